# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The HTML of a report as a Jinja2 template: what is put into it is escaped unless marked safe."""

STYLE = """
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #1d2329; background: #fff;
  max-width: 75rem; margin: 2rem auto; padding: 0 1.25rem; }
h1 { font-size: 1.7rem; margin: 0 0 .2rem; } h2 { font-size: 1.15rem; margin: 2.2rem 0 .6rem; }
.lead { color: #4d5761; margin: 0 0 1.4rem; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(10.5rem, 1fr)); gap: .8rem; }
.tile { border: 1px solid #d5dade; border-radius: .4rem; padding: .6rem .8rem; }
.tile b { display: block; font-size: 1.3rem; font-variant-numeric: tabular-nums; }
.tile span { color: #4d5761; font-size: .85rem; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(22rem, 1fr)); gap: 1.6rem; }
figure { margin: 0; } figure img { width: 100%; height: auto; display: block; }
figcaption { font-weight: 600; margin-bottom: .2rem; }
figcaption small, p.note { font-weight: 400; color: #4d5761; font-size: .85rem; display: block; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
th, td { text-align: right; padding: .25rem .8rem .25rem 0; border-bottom: 1px solid #e3e6e9; }
th { color: #4d5761; font-weight: 600; } th:first-child, td:first-child { text-align: left; }
td.text, th.text { text-align: left; } code { font-size: .82rem; overflow-wrap: anywhere; }
@media print { body { margin: 0; } figure, .tile { break-inside: avoid; } }
"""

MACROS = """\
{% macro table(heads, rows, text=(0,), hidden=False) -%}
<div class="wide"><table><thead{{ " hidden" if hidden }}><tr>
{%- for head in heads -%}
<th{% if loop.index0 in text %} class="text"{% endif %}>{{ head }}</th>
{%- endfor -%}
</tr></thead><tbody>
{%- for row in rows -%}
<tr>
{%- for cell in row -%}
<td{% if loop.index0 in text %} class="text"{% endif %}>
{%- if cell is mapping %}<code>{{ cell.code }}</code>{% else %}{{ cell }}{% endif -%}
</td>
{%- endfor -%}
</tr>
{%- endfor -%}
</tbody></table></div>
{%- endmacro -%}
{% macro charts(figures) -%}
<div class="charts">
{%- for each in figures -%}
<figure><figcaption>{{ each.title }}{% if each.note %}<small>{{ each.note }}</small>{% endif -%}
</figcaption><img alt="{{ each.alt }}" src="data:image/png;base64,{{ each.png }}"></figure>
{%- endfor -%}
</div>
{%- endmacro -%}
"""

PAGE = (
    MACROS
    + """\
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{{ summary.survey }}: report of a run</title><style>{{ style | safe }}</style></head><body>
<h1>{{ summary.survey }}</h1>
<p class="lead">Simulated survey of {{ legs_with_pulses }} with pulses, by vtkHelios \
{{ summary.versions.vtkHelios }} (this page: {{ version }}), VTK {{ summary.versions.VTK }}.</p>
<div class="tiles">
{%- for value, name in tiles -%}
<div class="tile"><b>{{ value }}</b><span>{{ name }}</span></div>
{%- endfor -%}
</div>
{%- if cloud %}<p><a href="{{ cloud.href }}">The point cloud</a>: {{ cloud.points }} {{ "point" if cloud.points == "1" else "points" }}, {{ cloud.size }}, \
a file beside this one.</p>{% endif %}
<h2>Plan view</h2>
{{ charts(maps) }}<p class="note">Coverage is the fraction of non-empty cells among all cells \
between the first and the last non-empty cell of their row and of their column.</p>
<h2>Points</h2>
{{ charts(histograms) }}<p class="note">Histograms exclude the outermost {{ outer }} % at either end.</p>
{%- if missing %}<p class="note">Not in the files of this run: {{ missing | join(", ") }}. Use \
<code>--format las</code> or <code>vtp</code> to store it.</p>{% endif %}
<h2>Legs</h2>
{{ table(leg_heads, legs) }}
{{ table(("file", "points"), files) if files }}
{%- if moving %}<h2>Moving parts</h2>
{{ table(moving_heads, moving, text=(0, 1)) }}<p class="note">Speed: of the centroid, at moments of the legs. Radial velocity: of the echoes, positive if scanner and part move apart, of runs with <code>--velocities</code>.</p>{% endif %}
<h2>Run</h2>
{{ table(("", ""), settings, text=(0, 1), hidden=True) }}
<h2>Inputs</h2>
{{ table(("file", "size", "SHA-256"), inputs, text=(0, 2)) }}
</body></html>
"""
)
