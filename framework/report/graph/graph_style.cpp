#include "framework/report/graph/graph_picture.hpp"

namespace stope::report {

const char* graph_style() {
  return R"(.pipeline{font-family:var(--sans,system-ui,"Segoe UI","Helvetica Neue",Arial,sans-serif)}
.pipeline text{fill:var(--ink,#1d2126)}
.pipeline .box{fill:var(--card,#fff);stroke:var(--line,#c9ced6)}
.pipeline .output .box{fill:var(--paper,#f7f6f3);stroke-dasharray:none}
.pipeline .failed .box{stroke:var(--bad,#b3261e);stroke-width:2}
.pipeline .name{font-size:13px;font-weight:600}
.pipeline .use,.pipeline .port{font-size:10.5px;fill:var(--soft,#667080)}
.pipeline .use{font-family:var(--mono,ui-monospace,"SF Mono",Menlo,Consolas,monospace);font-size:10px}
.pipeline .time{font-size:10.5px;fill:var(--soft,#667080);font-variant-numeric:tabular-nums}
.pipeline .pin{fill:var(--card,#fff);stroke:var(--wire,#8b95a3);stroke-width:1.2}
.pipeline .wire{fill:none;stroke:var(--wire,#8b95a3);stroke-width:1.2}
.pipeline .wire.stream{stroke-width:2.6}
.pipeline .wire:hover{stroke:var(--run,#2f6db0)}
.run{fill:var(--run,#2f6db0)}.io{fill:var(--io,#8a63b5)}
.wait-in{fill:var(--wait-in,#dbe1e8)}.wait-out{fill:var(--wait-out,#ecd3ad)}
)";
}

}  // namespace stope::report
