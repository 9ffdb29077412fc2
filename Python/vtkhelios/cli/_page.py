# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of a report: one HTML file that needs no other."""

import base64
import html

import vtkhelios

from . import _charts
from ._figures import CLASSES
from ._progress import duration
from ._report import describe_paths, readable

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

MOST_ECHOES = 6  # from which on pulses are one bar
OUTER = 0.003  # share of points at either end that histograms leave out
HISTOGRAM_TEXTS = {  # key: title, axis, unit of the median, note
    "range": ("Range", "range [m]", "m", ""),
    "incidence": (
        "Angle of incidence", "angle from the normal of the surface [deg]", "deg",
        "0: straight onto the surface",
    ),
    "amplitude": ("Amplitude", "amplitude [dB above 1 nW]", "dB", "10 dB are ten times the power"),
    "width": ("Echo width", "full width at half maximum [ns]", "ns",
              "wider than the pulse: slopes, and leaves in one beam; shares on a logarithmic scale"),
}  # fmt: skip


def write_page(summary, figures, reader):
    """The text of the page."""
    title = html.escape(f"{summary['survey']}: report of a run")
    parts = [
        "<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{title}</title><style>{STYLE}</style></head><body>",
        f"<h1>{html.escape(summary['survey'])}</h1>", f'<p class="lead">{_lead(summary)}</p>',
        _tiles(summary, figures),
        "<h2>From above</h2>", _maps(figures, reader), "<h2>Points</h2>", _histograms(figures),
        "<h2>Legs</h2>", _legs(summary), _strips(figures, reader),
        "<h2>How it was run</h2>", _settings(summary),
        "<h2>Inputs</h2>", _inputs(summary), "</body></html>",
    ]  # fmt: skip
    return "\n".join(part for part in parts if part)


def _lead(summary):
    versions = summary["versions"]
    return html.escape(
        f"A simulated survey: {len(summary['legs'])} legs that fired pulses, by vtkHelios "
        f"{versions['vtkHelios']} (this page: {vtkhelios.__version__}), VTK {versions['VTK']}."
    )


def _tiles(summary, figures):
    totals, timings = summary["totals"], summary["timings"]
    fired, hit = totals["pulsesFired"], totals["pulsesHit"]
    seconds = timings["run_s"]
    tiles = [
        (f"{figures.count:,}", "points"),
        (f"{fired:,}", "pulses that left the scanner"),
        (f"{100 * hit / max(1, fired):.1f} %", "of the pulses have an echo"),
        (f"{figures.count / max(1, hit):.3f}", "echoes a pulse that has any"),
        (f"{figures.mean_density():.4g} /m²", "points, where there are any"),
        (f"{100 * figures.raster.coverage():.1f} %", f"coverage of {_cell(figures)} cells"),
    ]
    if figures.overlap() is not None:
        tiles.append((f"{100 * figures.overlap():.1f} %", "of it seen by two legs or more"))
    tiles.append((duration(seconds) if seconds >= 60 else f"{seconds:.2f} s",
                  f"to run, {fired / max(seconds, 1e-9) / 1e6:.2f} M pulses/s"))  # fmt: skip
    cells = (f'<div class="tile"><b>{value}</b><span>{name}</span></div>' for value, name in tiles)
    return f'<div class="tiles">{"".join(cells)}</div>'


def _cell(figures):
    cell = figures.raster.cell
    return f"{cell:g} m" if cell >= 0.1 else f"{1000 * cell:.3g} mm"


def _figure(title, note, png, alt):
    data = base64.b64encode(png).decode()
    small = f"<small>{note}</small>" if note else ""
    return (
        f"<figure><figcaption>{title}{small}</figcaption>"
        f'<img alt="{html.escape(alt)}" src="data:image/png;base64,{data}"></figure>'
    )


def _maps(figures, reader):
    raster = figures.raster
    trajectories = [reader.trajectory(name) for name in reader.files]
    paths = [trajectory[1] for trajectory in trajectories if trajectory]
    figures_of = [
        _figure(
            "Density", f"cells of {_cell(figures)}; white: no point; orange: the platform",
            _charts.density_map(raster, paths),
            f"map of the density, on average {figures.mean_density():.3g} points a square metre",
        )
    ]  # fmt: skip
    if figures.overlap() is not None:
        share = 100 * figures.overlap()
        figures_of.append(
            _figure("Overlap", f"{share:.1f} % of the cells with a point were seen twice or more",
                    _charts.strips_map(raster), f"map of the overlap, {share:.1f} %")
        )  # fmt: skip
    note = (
        '<p class="note">Coverage is the share of cells with a point, of all cells that lie between '
        "the first and the last such cell of their row and of their column.</p>"
    )
    return f'<div class="charts">{"".join(figures_of)}</div>{note}'


def _histograms(figures):
    shown, missing = [], []
    for key, (title, axis, unit, note) in HISTOGRAM_TEXTS.items():
        histogram = figures.histograms[key]
        if not len(histogram.counts):
            missing.append(title.lower())
            continue
        if key == "range" and figures.range_is_reckoned:
            note = "from the platform: text has no ranges"
        median = histogram.quantile(0.5)
        png = _charts.histogram(*_focus(histogram), axis, median, unit, log=key == "width")
        shown.append(_figure(title, note, png, f"{title}: histogram, median {median:.4g} {unit}"))
    shown += _bars(figures)
    note = (
        f'<p class="note">Not in this run\'s files: {", ".join(missing)}. With '
        "<code>--format las</code> or <code>vtp</code> it is.</p>"
        if missing
        else ""
    )
    outer = f'<p class="note">Histograms leave out the outer {100 * OUTER:g} % at either end.</p>'
    return f'<div class="charts">{"".join(shown)}</div>{outer}{note}'


def _focus(histogram):
    """Edges and counts without the outermost points, which would squeeze the rest."""
    from ._raster import Histogram

    low, high = histogram.quantile(OUTER), histogram.quantile(1 - OUTER)
    first = max(0, int(low / histogram.width) - histogram.first - 1)
    last = int(high / histogram.width) - histogram.first + 2
    part = Histogram(histogram.width)
    part.first = histogram.first + first
    part.counts = histogram.counts[first:last]
    return part.merged()


def _bars(figures):
    found = []
    if figures.echoes.any():
        names = [str(i) for i in range(1, MOST_ECHOES)]
        counts = [int(count) for count in figures.echoes[1:MOST_ECHOES]]
        rest = int(figures.echoes[MOST_ECHOES:].sum())
        png = _charts.bars([*names, f"{MOST_ECHOES} or more"], [*counts, rest], "echoes",
                           "share of the pulses with an echo [%]")  # fmt: skip
        found.append(_figure("Echoes a pulse", "", png, "pulses by their number of echoes"))
    if figures.classes.any():
        numbers = sorted(range(256), key=lambda i: -figures.classes[i])[:12]
        numbers = [i for i in numbers if figures.classes[i]]
        names = [f"{i} {CLASSES.get(i, '')}".strip() for i in numbers]
        png = _charts.bars(names, [int(figures.classes[i]) for i in numbers], "class",
                           "share of the points [%]")  # fmt: skip
        found.append(_figure("Classes", "", png, "points by their class"))
    return found


def _table(heads, rows, text=(0,)):
    def cells(row, tag):
        kinds = [' class="text"' if i in text else "" for i in range(len(row))]
        return "".join(f"<{tag}{kind}>{cell}</{tag}>" for kind, cell in zip(kinds, row))

    body = "".join(f"<tr>{cells(row, 'td')}</tr>" for row in rows)
    return (
        f'<div class="wide"><table><thead><tr>{cells(heads, "th")}</tr></thead>'
        f"<tbody>{body}</tbody></table></div>"
    )


def _legs(summary):
    seconds = summary["timings"]["legs_s"]
    rows = [
        (
            leg["leg"], f"{leg['start_s']:.3f}", f"{leg['duration_s']:.3f}",
            f"{leg['pulsesFired']:,}", f"{100 * leg['pulsesHit'] / max(1, leg['pulsesFired']):.1f}",
            f"{leg['points']:,}", f"{spent:.2f}",
        )
        for leg, spent in zip(summary["legs"], seconds)
    ]  # fmt: skip
    heads = (
        "leg",
        "start [s]",
        "lasts [s]",
        "pulses",
        "with echo [%]",
        "points",
        "computed in [s]",
    )
    return _table(heads, rows)


def _strips(figures, reader):
    if len(reader.files) == len(reader.summary["legs"]):
        return ""
    rows = [(html.escape(name), f"{count:,}") for name, count in zip(reader.files, figures.legs)]
    return _table(("file", "points"), rows)


def _settings(summary):
    totals, timings, options = summary["totals"], summary["timings"], summary["options"]
    rows = [
        ("sampling of the beam", html.escape(summary["sampling"])),
        ("pulses", describe_paths(totals)),
        ("ray caster", html.escape(summary["rayCaster"])),
        ("time", f"{timings['load_s']:.2f} s to load, {timings['run_s']:.2f} s to run, "
                 f"{timings['threads']} threads"),
        ("options", html.escape(", ".join(f"{k}: {v}" for k, v in options.items()))),
        ("scene (SHA-256 of its triangles)", f"<code>{html.escape(str(summary['scene']))}</code>"),
    ]  # fmt: skip
    return _table(("", ""), rows, text=(0, 1)).replace("<thead><tr><th", "<thead hidden><tr><th")


def _inputs(summary):
    rows = [
        (html.escape(each["file"]), readable(each["bytes"]), f"<code>{each['sha256']}</code>")
        for each in summary["inputs"]
    ]
    return _table(("file", "size", "SHA-256"), rows, text=(0, 2))
