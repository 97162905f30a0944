"""How the page with the annotated source looks: light and dark, for screens of any width."""

STYLE = """
:root {
  color-scheme: light dark;
  --back: #ffffff; --panel: #f5f7f9; --text: #1c2329; --soft: #5b6770; --rule: #dde3e8;
  --yes: #1a7f37; --no: #c62828; --part: #9a6700; --link: #0b5cad;
  --no-back: #fdecea; --part-back: #fff6db; --mark: #e8f0fa;
}
@media (prefers-color-scheme: dark) { :root:not([data-theme="light"]) {
  --back: #14181c; --panel: #1c2228; --text: #e3e8ec; --soft: #98a4ae; --rule: #303942;
  --yes: #57c274; --no: #ff7b72; --part: #e3b341; --link: #79b8ff;
  --no-back: #3a1c1c; --part-back: #342b12; --mark: #1f3247;
} }
:root[data-theme="dark"] {
  color-scheme: dark;
  --back: #14181c; --panel: #1c2228; --text: #e3e8ec; --soft: #98a4ae; --rule: #303942;
  --yes: #57c274; --no: #ff7b72; --part: #e3b341; --link: #79b8ff;
  --no-back: #3a1c1c; --part-back: #342b12; --mark: #1f3247;
}
:root[data-theme="light"] { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--back); color: var(--text);
  font: 15px/1.45 system-ui, "Segoe UI", Roboto, sans-serif; }
header { display: flex; align-items: center; gap: 1rem; padding: .8rem 1.2rem;
  border-bottom: 1px solid var(--rule); }
header h1 { font-size: 1.15rem; margin: 0; flex: 1; }
button, input, select { font: inherit; color: inherit; background: var(--panel);
  border: 1px solid var(--rule); border-radius: 6px; padding: .25rem .6rem; }
button { cursor: pointer; }
:focus-visible { outline: 2px solid var(--link); outline-offset: 1px; }
main { padding: 1rem 1.2rem 3rem; max-width: 1500px; margin: 0 auto; }
.cards { display: grid; grid-template-columns: repeat(auto-fit, minmax(190px, 1fr)); gap: .8rem; }
.card { background: var(--panel); border: 1px solid var(--rule); border-radius: 8px;
  padding: .7rem .9rem; }
.card b { display: block; font-size: 1.7rem; font-weight: 600; }
.card span { color: var(--soft); }
.bar { height: 6px; border-radius: 3px; background: var(--rule); overflow: hidden;
  margin-top: .3rem; }
.bar i { display: block; height: 100%; background: var(--yes); }
.bar i.middle { background: var(--part); } .bar i.low { background: var(--no); }
.tools { display: flex; flex-wrap: wrap; gap: .6rem; align-items: center; margin: 1.2rem 0 .5rem; }
.tools label { color: var(--soft); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: .3rem .6rem; border-bottom: 1px solid var(--rule);
  vertical-align: top; }
th { color: var(--soft); font-weight: 500; white-space: nowrap; }
th button { border: 0; background: none; padding: 0; color: inherit; }
td.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap;
  min-width: 7rem; }
tbody tr:hover { background: var(--mark); }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
.soft { color: var(--soft); }
.source { font: 13px/1.5 ui-monospace, "Cascadia Mono", Consolas, monospace; border: 1px solid
  var(--rule); border-radius: 8px; overflow-x: auto; background: var(--back); }
.source .line { display: grid; grid-template-columns: 4.2rem 5.2rem minmax(max-content, 1fr); }
.source .line > * { padding: 0 .6rem; white-space: pre; }
.source .number, .source .hits { color: var(--soft); text-align: right; background: var(--panel);
  user-select: none; }
.source .hits { border-right: 3px solid transparent; }
.yes > .hits { border-right-color: var(--yes); }
.no > .hits { border-right-color: var(--no); color: var(--no); }
.other > .hits { border-right: 3px dotted var(--yes); }
.texts a, .texts b { margin-right: .5rem; white-space: nowrap; }
.no > .code { background: var(--no-back); }
.part > .hits { border-right-color: var(--part); color: var(--part); }
.part > .code { background: var(--part-back); }
.line.here > .number { background: var(--mark); color: var(--text); }
.note { padding: .15rem .6rem .3rem 10.2rem; color: var(--part); font: 13px/1.45 system-ui,
  sans-serif; }
.note.no { color: var(--no); }
.note button { padding: 0 .4rem; font-size: 12px; }
.decision { margin: .3rem .6rem .6rem 10.2rem; font: 13px/1.45 system-ui, sans-serif;
  background: var(--panel); border: 1px solid var(--rule); border-radius: 8px; padding: .5rem; }
.decision table { width: auto; } .decision td, .decision th { padding: .1rem .6rem; }
.decision code { font: 12px/1.4 ui-monospace, Consolas, monospace; }
.ok { color: var(--yes); } .bad { color: var(--no); }
kbd { border: 1px solid var(--rule); border-radius: 4px; padding: 0 .3rem; font: 12px monospace; }
ul.missing li { break-inside: avoid; }
ul.missing { columns: 20rem; column-gap: 1.5rem; padding-left: 1.1rem; margin: .3rem 0 1rem; }
h2 { font-size: 1.05rem; margin: 1.6rem 0 .4rem; }
@media print { .tools, header button { display: none; } }
"""
