// How the pages look: light and dark by the reader's choice, colours that the colour-blind tell apart, never colour alone.
#pragma once

#include <string_view>

namespace graze::fuzz {

inline constexpr std::string_view page_style = R"css(
:root { color-scheme: light dark; --ink: #1b1f24; --soft: #57606a; --line: #d0d7de; --ground: #ffffff; --panel: #f6f8fa;
  --good: #0065a8; --bad: #b34700; --open: #6b4fa0; --bar: #0072b2; --heat: 213, 94, 0; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ed; --soft: #a0a9b4; --line: #3a424c; --ground: #14181d; --panel: #1d232a;
  --good: #67bdf0; --bad: #ffa54f; --open: #c3b1ef; --bar: #56b4e9; --heat: 255, 150, 60; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 72rem; padding: 1rem; background: var(--ground); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
body.broad { max-width: 90rem; }
pre, dd, p, figcaption { overflow-wrap: anywhere; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0 0 .25rem; }
h2 { font-size: 1.15rem; margin: 2rem 0 .5rem; }
h3 { font-size: 1rem; margin: 0; }
p { margin: .4rem 0; max-width: 52rem; }
.soft, figcaption, caption, dt { color: var(--soft); }
.verdict { font-weight: 700; padding: .05em .5em; border: .14em solid; border-radius: .4em; white-space: nowrap; }
.pass { color: var(--good); } .fail { color: var(--bad); } .incomplete { color: var(--open); }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(8rem, 1fr)); gap: .5rem; margin: 1rem 0; }
.facts div { background: var(--panel); border-radius: .5rem; padding: .5rem .75rem; }
.facts b { display: block; font-size: 1.25rem; font-variant-numeric: tabular-nums; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .6rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
thead th { vertical-align: bottom; border-bottom: 2px solid var(--line); font-weight: 600; white-space: normal; }
tbody th { text-align: left; font-weight: 400; position: sticky; left: 0; background: var(--ground); }
th.name { text-align: left; }
.loose th { white-space: normal; }
td small { display: block; color: var(--soft); }
td.zero { color: var(--soft); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; margin: .5rem 0; }
dd { margin: 0; }
code, pre { font: .8125rem/1.45 ui-monospace, monospace; }
pre { background: var(--panel); border-radius: .4rem; padding: .5rem .75rem; margin: .4rem 0; white-space: pre-wrap; }
.offender { border: 1px solid var(--line); border-radius: .5rem; padding: .75rem; margin: .75rem 0; display: grid;
  grid-template-columns: 16rem 1fr; gap: 0 1rem; }
.offender > div { min-width: 0; }
@media (max-width: 44rem) { .offender { grid-template-columns: 1fr; } dl { grid-template-columns: 1fr; } dt { margin-top: .4rem; }
  th, td { padding: .25rem .35rem; } }
figure { margin: .25rem 0; } figcaption { font-size: .8125rem; }
svg { width: 100%; max-width: 16rem; height: auto; display: block; }
svg.chart { max-width: 46rem; min-width: 32rem; }
svg text { fill: var(--ink); font: 11px system-ui, sans-serif; }
.shape { fill: rgba(127, 140, 155, .22); stroke: var(--ink); stroke-width: 1.2; }
.ray { stroke: var(--bar); stroke-width: 2; fill: none; } .ring { stroke: var(--bar); stroke-width: 2; fill: none; }
.guide { stroke: var(--bar); stroke-width: 1; stroke-dasharray: 3 4; } .dot { fill: var(--bar); stroke: none; }
.center { fill: var(--ink); } .bar { fill: var(--bar); } .axis { stroke: var(--line); stroke-width: 1; }
details { margin: .5rem 0; } summary { cursor: pointer; }
)css";

}  // namespace graze::fuzz
