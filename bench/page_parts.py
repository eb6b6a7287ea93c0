"""What pages are made of: their style, tables, pictures, parts that open."""
import base64
import os
from html import escape

STYLE = """
:root { color-scheme: light; --ink: #1b1f24; --soft: #57606a; --line: #d0d7de; --panel: #f6f8fa; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 84rem; padding: 1rem; background: #fff; color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.5rem; margin: 0 0 .25rem; } h2 { font-size: 1.2rem; margin: 2.2rem 0 .4rem; } h3 { font-size: 1rem; margin: 1.4rem 0 .3rem; }
p { max-width: 56rem; margin: .4rem 0; } .soft { color: var(--soft); }
img { max-width: 100%; height: auto; display: block; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .84rem; font-variant-numeric: tabular-nums; }
th, td { padding: .22rem .6rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; vertical-align: top; }
thead th { border-bottom: 2px solid var(--line); font-weight: 600; white-space: normal; vertical-align: bottom; } .name { text-align: left; } tr.ours td { font-weight: 600; }
td.case { white-space: normal; text-align: left; overflow-wrap: anywhere; font: .75rem/1.4 ui-monospace, monospace; min-width: 30rem; font-weight: 400; }
pre, code { font: .82rem/1.45 ui-monospace, monospace; } pre { background: var(--panel); padding: .5rem .75rem; border-radius: .4rem; white-space: pre-wrap; }
details { margin: .3rem 0; } summary { cursor: pointer; color: var(--soft); }
"""


def table(head, body, names=1):
    """body: (class, cells) rows; cells are text, or (text, class)."""

    def cell(content, column):
        text, kind = content if isinstance(content, tuple) else (content, "name" if column < names else "")
        return f'<td class="{kind}">{escape(text)}</td>' if kind else f"<td>{escape(text)}</td>"

    out = ['<div class="wide"><table><thead><tr>']
    out += [f'<th class="name">{escape(h)}</th>' if i < names else f"<th>{escape(h)}</th>" for i, h in enumerate(head)]
    out.append("</tr></thead><tbody>")
    for kind, cells in body:
        out.append(f'<tr class="{kind}">' + "".join(cell(c, i) for i, c in enumerate(cells)) + "</tr>")
    out.append("</tbody></table></div>")
    return "".join(out)


def picture(folder, name, text):
    with open(os.path.join(folder, name + ".svg"), "rb") as file:
        data = base64.b64encode(file.read()).decode()
    return f'<img alt="{escape(text)}" src="data:image/svg+xml;base64,{data}">'


def details(title, content):
    return f"<details><summary>{escape(title)}</summary>{content}</details>"
