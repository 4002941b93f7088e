#include "framework/report/page/style.hpp"

namespace stope::report {

const char* page_style() {
  return R"(:root{color-scheme:light dark;
--paper:#faf9f6;--card:#fff;--ink:#1c2127;--soft:#69727e;--line:#dddfe2;--wire:#8d97a4;
--good:#2e7d4f;--bad:#b3261e;--road:#c4480e;--path:#1858c4;--casing:#fff;--track:#7a3fb0;
--run:#2f6db0;--io:#8a63b5;--wait-in:#dde3ea;--wait-out:#edd6b2;--shade:rgba(20,24,30,.07);
--sans:"Inter","Segoe UI","Helvetica Neue","Noto Sans","Liberation Sans",Arial,sans-serif;
--serif:"Iowan Old Style","Palatino Linotype",Palatino,"Charter","Georgia","Noto Serif","Liberation Serif",serif;
--mono:ui-monospace,"SF Mono",Menlo,"Cascadia Mono","DejaVu Sans Mono","Liberation Mono",monospace}
@media (prefers-color-scheme:dark){:root{
--paper:#131518;--card:#1a1d21;--ink:#e4e6e9;--soft:#949da9;--line:#2f343a;--wire:#69737f;
--good:#67c391;--bad:#ff8a80;--road:#ff9b57;--path:#71b2ff;--casing:#101214;--track:#c79bff;
--run:#5c9be0;--io:#ad8bdb;--wait-in:#333b45;--wait-out:#5f4b2c;--shade:rgba(0,0,0,.4)}
.neutral{filter:invert(.88)}.tinted{filter:brightness(.88)}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 var(--sans)}
main{max-width:1240px;margin:0 auto;padding:40px 28px 80px}
h1{font:400 44px/1.1 var(--serif);margin:2px 0 14px;letter-spacing:-.01em;overflow-wrap:anywhere}
h2{font:400 25px/1.2 var(--serif);margin:0 0 14px}
section{margin-top:56px}
a{color:inherit;text-decoration-color:var(--wire);text-underline-offset:3px}
code{font-family:var(--mono);font-size:.86em}
.over{font-size:12px;letter-spacing:.11em;text-transform:uppercase;color:var(--soft);margin:0}
.verdict{font-size:19px;margin:0 0 18px;overflow-wrap:anywhere}
.verdict b{font-weight:600}.done b{color:var(--good)}.failed b,.cancelled b{color:var(--bad)}
.facts{display:flex;flex-wrap:wrap;gap:6px 34px;margin:0 0 14px;padding:0}
.facts div{min-width:70px}.facts dt{font-size:12px;color:var(--soft);margin:0}
.facts dd{margin:0;font-size:17px;font-variant-numeric:tabular-nums}
.facts dd small{font-size:13px;color:var(--soft)}
.command{margin:0;padding:10px 14px;background:var(--card);border:1px solid var(--line);border-radius:6px;
font:12.5px/1.5 var(--mono);overflow-wrap:anywhere;white-space:pre-wrap}
.soft{color:var(--soft)}.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.scroll{overflow-x:auto;margin:0 -28px;padding:0 28px}
.scroll svg{display:block;max-width:max(100%,880px);height:auto}
.legend{display:inline-flex;flex-wrap:wrap;gap:2px 16px;color:var(--soft);font-size:12.5px;margin:0 0 6px}
.legend>span{display:inline-flex;align-items:center;gap:6px}
.legend i{width:11px;height:11px;border-radius:2px;display:inline-block}
i.run{background:var(--run)}i.io{background:var(--io)}i.wait-in{background:var(--wait-in)}i.wait-out{background:var(--wait-out)}
.key{width:22px;height:10px;overflow:visible}.key.dot{width:10px}
figure{margin:0}
.results{display:flex;flex-wrap:wrap;gap:40px 28px;margin-bottom:44px}
.map.wide{--tall:780px;flex:1 1 100%;min-width:0}.map.half{--tall:920px;flex-basis:min(100%,480px)}
.gallery{--tall:420px;display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,480px),1fr));gap:36px 28px;align-items:end}
.frame{position:relative;aspect-ratio:var(--ratio);width:min(100%,calc(var(--tall)*var(--ratio)));margin:0 auto;
background:var(--card);box-shadow:0 0 0 1px var(--line),0 6px 24px var(--shade);overflow:hidden}
.wide .frame{margin:0}
.frame.points{background:#15181c}
.frame svg{display:block;width:100%;height:100%}
.cells{image-rendering:pixelated}
.map path{fill:none;stroke-linecap:round;stroke-linejoin:round;vector-effect:non-scaling-stroke}
.map .road{stroke:var(--road);stroke-width:2.2}.map .closed{stroke-dasharray:3 5}
.map .path{stroke:var(--path);stroke-width:4}.map .casing{stroke:var(--casing);stroke-width:8;stroke-opacity:.85}
.map .track{stroke:var(--track);stroke-width:2.4}.map .line{stroke:var(--ink);stroke-width:1.4}
.map .link{stroke:var(--ink);stroke-width:1.2;stroke-opacity:.6}
.map .faint .road{stroke-width:1.6;stroke-opacity:.55}
.map circle{vector-effect:non-scaling-stroke;stroke:var(--casing);stroke-width:1.4;fill:var(--ink)}
.map .junction{fill:var(--road)}.map .dead-end{fill:var(--casing);stroke:var(--road);stroke-width:2}
.map .bend{fill:var(--road);stroke:none;r:2}
.many circle{stroke-width:.7}.many .dead-end{stroke-width:1.1}
.map .start{fill:var(--good);stroke-width:2.4}.map .goal{fill:var(--bad);stroke-width:2.4}
.map .region{fill:var(--ink)}
.scale{position:absolute;left:14px;bottom:12px;border:solid var(--ink);border-width:0 1.5px 1.5px;height:6px}
.scale span{position:absolute;left:0;bottom:8px;white-space:nowrap;font-size:12px;line-height:1;padding:3px 5px;
background:var(--card);border-radius:3px;opacity:.88}
.north{position:absolute;right:12px;top:10px;font-size:11px;line-height:1.1;text-align:center;padding:3px 6px;
background:var(--card);border-radius:3px;opacity:.88}
.north span{display:block;font-size:15px}
.points .scale{border-color:#dfe3e8}
figcaption{margin-top:10px;font-size:13.5px;color:var(--soft);overflow-wrap:anywhere}
figcaption b{color:var(--ink);font-weight:600}.kind{color:var(--ink)}.kind:after{content:":"}
figcaption .legend{margin:0 0 0 14px;vertical-align:bottom}.remark{font-style:italic}
table{border-collapse:collapse;width:100%;font-size:13.5px}
th{font-weight:500;text-align:left}thead th{font-size:12px;color:var(--soft);border-bottom:1px solid var(--wire);padding:0 10px 5px 0;vertical-align:bottom}
td,tbody th{padding:5px 10px 5px 0;border-bottom:1px solid var(--line);vertical-align:top;overflow-wrap:anywhere}
th.n,td.n{text-align:right;padding-left:10px}th.n+th:not(.n),td.n+td:not(.n){padding-left:22px}td:last-child,th:last-child{padding-right:0}
section>table+table{margin-top:26px}
.sum{font-size:11px;color:var(--soft);word-break:break-all}
td.timeline,th.timeline{width:38%;min-width:180px}th.timeline{color:var(--soft)}
th.timeline span:last-child{float:right}
.strip{display:block;width:100%;height:15px;margin-top:3px}
.times tbody th{overflow-wrap:normal}
details{margin-top:14px}summary{cursor:pointer;color:var(--soft);margin-bottom:8px}
dl{display:grid;grid-template-columns:max-content 1fr;gap:3px 20px;margin:0 0 26px;font-size:13.5px}
dl.facts{display:flex}dt{color:var(--soft)}dd{margin:0;overflow-wrap:anywhere}
.stages td:first-child,.stages code{white-space:nowrap}.chosen{font-weight:600}.default{color:var(--soft)}.stages td span{margin-right:10px;display:inline-block}
.log{list-style:none;margin:0;padding:0;font-size:13px}.log li{padding:2px 0}
.log .warning b,.log .warning:before{color:var(--road)}.log .warning:before{content:"▲ ";font-size:10px}
@media print{.scroll{overflow:visible}section{break-inside:avoid-page}}
)";
}

}  // namespace stope::report
