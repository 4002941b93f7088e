#include "framework/compare/report/style.hpp"

namespace stope::report {

// Better and worse, left and right are told apart by blue and orange, which the colour-blind can
// tell too, and by shape or dashes.
const char* comparison_style() {
  return R"(:root{--better:#1858c4;--worse:#b8440c;--band:rgba(120,130,145,.17);--common:#9aa2ad}
@media (prefers-color-scheme:dark){:root{--better:#71b2ff;--worse:#ff9b57;--band:rgba(160,170,185,.16);--common:#6c7681}
.slider img{filter:brightness(.9)}}
h3{font:500 16px/1.3 var(--sans);margin:30px 0 10px}
small{font-size:12px;color:var(--soft);font-weight:400}
.finding{font:400 21px/1.42 var(--serif);margin:0 0 10px;max-width:60em;overflow-wrap:anywhere}
.finding.better,.finding.worse{border-left:3px solid var(--better);padding-left:14px}
.finding.worse{border-color:var(--worse)}p.finding{color:var(--ink)}.finding.same,.finding.unknown{border-left:3px solid var(--line);padding-left:14px}
header .facts{margin-top:22px}
.so-far{color:var(--worse);font-weight:600}
.better{color:var(--better)}.worse{color:var(--worse)}.same{color:var(--soft)}.unknown{color:var(--soft)}
.said{min-width:170px}td.said{white-space:normal}td.said b{display:inline-block;width:1.2em}
.slight{opacity:.75}
.scroll td,.scroll th{overflow-wrap:normal}.verdicts th:first-child{min-width:120px}
.verdicts thead th{padding-top:26px}.verdicts thead:first-child th{padding-top:0}
.verdicts .arm{font:600 15px/1.2 var(--sans);color:var(--ink)}
.verdicts small{display:block}.verdicts td.n small{display:inline}.said.n,td.said,th.said{padding-left:22px}
.keys{margin-bottom:16px}.band{background:var(--band)}.keys .band{width:16px}
.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,480px),1fr));gap:34px 40px}
.plot figcaption{margin:0 0 4px;color:var(--soft)}.ways{float:right;font-size:12px}.ways span+span{margin-left:12px}
.plot .row{display:grid;grid-template-columns:minmax(70px,22%) 1fr;gap:12px;align-items:center;border-top:1px solid var(--line)}
.plot .row:last-child{border-color:var(--wire)}
.plot .name{font-size:13px;overflow-wrap:anywhere;text-align:right}
.plot .strip{height:auto;margin:0;overflow:visible}
.plot rect.band{fill:var(--band)}.zero{stroke:var(--wire);stroke-width:1}
.pair{fill:var(--ink);fill-opacity:.38}
.interval{stroke:currentColor;stroke-width:2;fill:none}.mean{fill:currentColor;stroke:var(--paper);stroke-width:1.5}
.key .interval{stroke-width:1.5}.key .mean{stroke:none}
.axis line{stroke:var(--wire)}.axis text{fill:var(--soft);font-size:11.5px}
.choose{display:flex;flex-wrap:wrap;gap:10px 26px;margin:0 0 20px;align-items:baseline}
.choose label{color:var(--soft)}.left-name{color:var(--ink);font-weight:600}
select,.download{font:inherit;color:var(--ink);background:var(--card);border:1px solid var(--wire);border-radius:5px;padding:4px 8px}
.views{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,460px),1fr));gap:36px 28px;align-items:start}
.slider,.sheet{position:relative;background:var(--card);box-shadow:0 0 0 1px var(--line),0 6px 24px var(--shade);overflow:hidden}
.slider img{display:block;width:100%;height:auto;user-select:none}
.slider .over{position:absolute;inset:0;height:100%;clip-path:inset(0 0 0 var(--cut))}
.handle{position:absolute;top:0;bottom:0;left:var(--cut);width:2px;margin-left:-1px;background:var(--ink);pointer-events:none}
.handle:after{content:"⟷";position:absolute;top:50%;left:50%;transform:translate(-50%,-50%);background:var(--card);color:var(--ink);
border:2px solid var(--ink);border-radius:50%;width:34px;height:34px;text-align:center;font:16px/30px var(--sans)}
.slider input{position:absolute;top:0;left:-8px;width:calc(100% + 16px);height:100%;margin:0;opacity:0;cursor:ew-resize;touch-action:pan-y}
.slider input:focus-visible~.handle,.slider:focus-within .handle{background:var(--better)}
.tab{position:absolute;top:8px;font-size:12px;padding:2px 7px;border-radius:3px;background:var(--card);opacity:.9;pointer-events:none}
.tab.left{left:8px}.tab.right{right:8px}
.absent p{margin:0;padding:40px 20px;text-align:center;background:var(--card);box-shadow:0 0 0 1px var(--line)}
.sheet svg{display:block;width:100%;height:auto;max-height:720px}
.common{stroke:var(--common);stroke-width:2.4}.only-left{stroke:var(--worse);stroke-width:4;stroke-dasharray:9 7}
.only-right{stroke:var(--better);stroke-width:4}
.key path{fill:none;vector-effect:non-scaling-stroke}.key .only-left{stroke-dasharray:5 3}
td.time{min-width:140px;font-variant-numeric:tabular-nums;white-space:nowrap}td.time b{font-weight:500}
td.lent,td.lent b{color:var(--soft)}
.bar{display:block;height:4px;border-radius:2px;background:var(--run);margin:2px 0 3px;min-width:1px}.lent .bar{background:var(--wait-in)}
.tag{font-size:11px;border:1px solid var(--line);border-radius:3px;padding:0 5px;color:var(--soft)}
tfoot th,tfoot td{border-top:1px solid var(--wire);border-bottom:0;padding-top:7px}
.downloads{list-style:none;margin:0;padding:0;display:flex;flex-wrap:wrap;gap:12px}
.download{display:inline-block;text-decoration:none;padding:8px 14px}.download:hover{border-color:var(--ink)}
.download small{display:block}
.plan{list-style:none;margin:0;padding:0;font:12.5px/1.6 var(--mono);overflow-wrap:anywhere}
@media (max-width:600px){main{padding:24px 16px 60px}.scroll{margin:0 -16px;padding:0 16px}h1{font-size:32px}
.finding{font-size:18px}.plot .row{grid-template-columns:1fr;gap:0;padding-top:4px}.plot .name{text-align:left}}
)";
}

}  // namespace stope::report
