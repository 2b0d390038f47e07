// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/page/page.hpp"

namespace leastcost::app {

std::string page_style() {
  return R"(:root{--ink:#222;--soft:#6b6b6b;--rule:#dcd9d2;--faint:#f5f3ee;--paper:#fff;--good:#00704f;--bad:#b04a00;
--mild:#6b6b6b;--other:#0a63a0;--asked:#a3307f;color-scheme:light dark}
@media (prefers-color-scheme:dark){:root{--ink:#e6e4df;--soft:#a19e97;--rule:#3a3936;--faint:#252523;--paper:#1c1c1b;
--good:#45c79c;--bad:#f0905a;--mild:#a19e97;--other:#6fb7ea;--asked:#e58fc4}}
*{box-sizing:border-box}
html{background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,-apple-system,"Segoe UI","Helvetica Neue",
Helvetica,Arial,sans-serif;-webkit-text-size-adjust:100%}
body{margin:0}
main{max-width:1060px;margin:0 auto;padding:2.4rem 1.4rem 4rem}
h1,h2,h3{font-family:"Iowan Old Style","Palatino Linotype",Palatino,"URW Palladio L",Georgia,"DejaVu Serif",serif;
font-weight:600;line-height:1.2;letter-spacing:-.005em}
h1{font-size:2.1rem;margin:.1rem 0 .2rem;overflow-wrap:anywhere}
h2{font-size:1.25rem;margin:0;display:inline}
h3{font-size:1.02rem;margin:1.4rem 0 .4rem}
p{margin:.5rem 0;max-width:46rem}
header{border-bottom:2px solid var(--ink);padding-bottom:1rem;margin-bottom:1.2rem}
.kind{text-transform:uppercase;letter-spacing:.12em;font-size:.72rem;color:var(--soft);margin:0}
.about,.soft,figcaption{color:var(--soft)}
.about{margin:0}
.verdict{margin:.7rem 0 0;font-weight:600;font-size:1.05rem}
.verdict::before{content:"";display:inline-block;width:.62em;height:.62em;border-radius:50%;background:currentColor;
margin-right:.5em}
.other{color:var(--other)}.good{color:var(--good)}.bad{color:var(--bad)}.mild{color:var(--mild)}
.why{border-left:3px solid var(--bad);padding:.1rem 0 .1rem 1rem;margin:1rem 0}
.warning{border-left:3px solid var(--bad);padding-left:1rem}
.why li{margin:.25rem 0}.why ul{margin:.3rem 0;padding-left:1.1rem}
.key{display:grid;grid-template-columns:repeat(auto-fit,minmax(9.5rem,auto));justify-content:space-between;
gap:1rem 1.4rem;margin:0 0 1.4rem}
.key dt{font-size:.72rem;text-transform:uppercase;letter-spacing:.08em;color:var(--soft)}
.key dd{margin:0;font-size:1.12rem;font-variant-numeric:tabular-nums;line-height:1.3}
.key small{display:block;font-size:.8rem;color:var(--soft);max-width:15rem}
details{border-top:1px solid var(--rule);padding:.9rem 0 .5rem}
details>summary{cursor:pointer;list-style:none;margin-bottom:.5rem}
details>summary::-webkit-details-marker{display:none}
details>summary::after{content:"+";float:right;color:var(--soft);font-size:1.1rem}
details[open]>summary::after{content:"–"}
summary:focus-visible,canvas:focus-visible{outline:2px solid #0072B2;outline-offset:3px}
figure{margin:.6rem 0 1rem}
figcaption{font-size:.88rem;margin-top:.35rem;max-width:46rem}
.row{display:flex;flex-wrap:wrap;gap:1rem 1.6rem;align-items:flex-start}
svg{max-width:100%;height:auto}
.stage{position:relative;width:100%;height:min(68vh,620px);background:var(--faint);border:1px solid var(--rule);
display:flex;align-items:center;justify-content:center;overflow:hidden}
.stage canvas{display:block;width:100%;height:100%;cursor:grab}.stage canvas:active{cursor:grabbing}
.stage svg{max-height:100%}
#pose-row label{display:flex;gap:.7em;align-items:center}#pose{flex:1}
.legend{display:flex;flex-wrap:wrap;gap:.3rem 1.4rem;font-size:.88rem;margin-top:.5rem;color:var(--soft);
align-items:center}
.legend label{display:inline-flex;align-items:center;gap:.4rem;cursor:pointer}.legend svg{flex:none}
.ask{margin:1.2rem 0}.ask form:not([hidden]){display:flex;flex-wrap:wrap;gap:.5rem .9rem;align-items:baseline}
.ask input,.ask button{font:inherit;font-size:.95rem;padding:.15rem .4rem;color:inherit;background:var(--paper);
border:1px solid var(--soft);border-radius:3px;max-width:100%}.ask button{cursor:pointer}
.ask button:focus-visible,.ask input:focus-visible{outline:2px solid #0072B2;outline-offset:2px}
#ask-answer{min-height:1.5em;font-variant-numeric:tabular-nums}
#ask-answer.afloat{position:fixed;left:0;right:0;bottom:0;z-index:2;margin:0;padding:.5rem 1rem;background:var(--paper);
border-top:1px solid var(--soft)}
.copied{position:relative}.copied button{position:absolute;top:.4rem;right:.4rem;font-size:.78rem}
@media (max-width:560px){#plane>svg text{font-size:16px}}
svg.clickable{cursor:crosshair}.asked{fill:none;stroke:var(--asked);stroke-width:3.5}
.asked-end{fill:var(--asked);stroke:var(--paper);stroke-width:1.5}
.scroll{overflow-x:auto;margin:.4rem 0 1rem}
table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums}
th,td{text-align:left;padding:.32rem .9rem .32rem 0;vertical-align:baseline;border-bottom:1px solid var(--rule)}
th{font-weight:600;border-bottom:1.5px solid var(--ink);white-space:nowrap;vertical-align:bottom}
td.n,th.n{text-align:right;white-space:nowrap;padding-right:1.3rem}
td:last-child,th:last-child{padding-right:0}
td[title],th[title]{text-decoration:underline dotted var(--soft);text-underline-offset:3px;cursor:help}
.tests td:nth-child(3){text-align:right;padding-right:1.3rem;white-space:nowrap}.tests td:last-child{min-width:17rem}
.counts th{white-space:normal}.counts th:first-child,.counts td:first-child{white-space:nowrap}.counts td.n,
.counts th.n{padding-right:.7rem}
.counts td.n:last-child,.counts th.n:last-child{padding-right:0}
@media (max-width:700px){.tests,.tests thead,.tests tbody{display:block}.tests tr{display:grid;
grid-template-columns:minmax(0,6.3rem) minmax(0,1fr) minmax(0,1fr) 3.8rem;border-bottom:1px solid var(--rule)}
.tests tr th,.tests tr td,.tests tr td:first-child,.tests tr td:nth-child(3){border-bottom:0;white-space:normal;
overflow-wrap:anywhere;padding-right:.5rem}.tests tr td:nth-child(4),.tests tr th:nth-child(4){white-space:nowrap;
padding-right:0}.tests tr td:last-child{grid-column:1/-1;min-width:0;padding-top:0;
color:var(--soft)}.tests th:last-child{display:none}}
td.w,.tests td:first-child{white-space:nowrap}
td.good,td.bad{font-weight:600}td.plain{font-weight:400}
.matrix{font-size:.74rem;line-height:1.25}.matrix td{white-space:pre;padding:.26rem .4rem;
border-left:1px solid var(--rule);text-decoration:none}
.matrix th{white-space:normal;padding:.26rem .4rem;font-size:.72rem;overflow-wrap:normal;min-width:3.4rem}
.matrix th:first-child,.matrix td:first-child{position:sticky;left:0;background:var(--paper);border-left:0;
padding-left:0;white-space:normal;min-width:8rem}
.matrix td.good{background:color-mix(in srgb,var(--good) 9%,transparent);font-weight:400}
.matrix td.bad{background:color-mix(in srgb,var(--bad) 14%,transparent);font-weight:400}
.matrix td.best{font-weight:700}
.matrix td.other{background:color-mix(in srgb,var(--other) 12%,transparent)}
.matrix td.mild{background:color-mix(in srgb,var(--mild) 12%,transparent)}
details.sub{padding:.3rem 0;border-top:0}details.sub>summary{font-size:.95rem;margin:0}
details.sub>summary::after{float:none;margin-left:.5rem}
pre{background:var(--faint);border:1px solid var(--rule);padding:.8rem 1rem;overflow-x:auto;
font:13px/1.45 ui-monospace,"SF Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace}
code,.hash{font-family:ui-monospace,"SF Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace;font-size:.86em;
overflow-wrap:anywhere}
@media print{main{max-width:none;padding:0}.legend input{display:none}.scroll{overflow:visible}table{font-size:8pt}
.matrix,.matrix th{font-size:5pt}.matrix th,.matrix td{padding:1pt 2pt;min-width:0}.matrix th:first-child,
.matrix td:first-child{position:static;min-width:0}
details::details-content{content-visibility:visible;display:block;height:auto}details>summary::after,
details[open]>summary::after{content:""}tr,figure svg{break-inside:avoid}}
)";
}

}  // namespace leastcost::app
