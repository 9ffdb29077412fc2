# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of a report: a single HTML file."""

import base64

from ..array_names import AMPLITUDE, RANGE
from ..core import packages
from ..core.classes import version
from ..core.words import counted, noun, time_span
from ..formats._classes import CLASSES
from . import charts
from .accuracy import accuracy_rows
from .moving import HEADS, moving_rows
from .options import describe_options
from .raster import Histogram, is_near
from .run import describe_paths, describe_time, readable
from .template import PAGE, STYLE

MAXIMUM_ECHOES = 6  # larger counts share one bar
OUTER = 0.003  # fraction of points at either end excluded from histograms
LEG_HEADS = (
    "leg", "start [s]", "duration [s]", "pulses", "with echo [%]", "points", "computing time [s]"
)  # fmt: skip
HISTOGRAM_TEXTS = {  # key: title, axis, unit of the median, note
    "range": (RANGE, "range [m]", "m", ""),
    "incidence": (
        "Angle of incidence", "angle from the surface normal [deg]", "deg",
        "0: normal incidence",
    ),
    "amplitude": (AMPLITUDE, "amplitude [dB above 1 nW]", "dB", "10 dB: ten times the power"),
    "width": ("Echo width", "full width at half maximum [ns]", "ns",
              "wider than the pulse: slopes, leaves within one beam; logarithmic frequency scale"),
}  # fmt: skip


def load_template(page=PAGE):
    """Returns the template of a page; ImportError without Jinja2."""
    jinja2 = packages.load("jinja2", "pages need")
    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined)
    return environment.from_string(page)


def write_page(summary, figures, reader, cloud=None):
    """Returns the text of the page; cloud is the link to the page of the cloud, None: there is
    none."""
    histograms, missing = _histograms(figures)
    return load_template().render(
        style=STYLE,
        summary=summary,
        legs_with_pulses=counted(len(summary["legs"]), "leg"),
        version=version(),
        tiles=_tiles(summary, figures),
        cloud=cloud,
        maps=_maps(figures, reader),
        histograms=histograms,
        missing=missing,
        outer=f"{100 * OUTER:g}",
        leg_heads=LEG_HEADS,
        legs=_legs(summary),
        files=_files(figures, reader),
        moving_heads=HEADS,
        moving=moving_rows(figures.moving_parts()),
        settings=_settings(summary),
        inputs=_inputs(summary),
    )


def _tiles(summary, figures):
    totals, timings = summary["totals"], summary["timings"]
    fired, hit = totals["pulsesFired"], totals["pulsesHit"]
    seconds = timings.get("parts_s", timings["run_s"])
    tiles = [
        (f"{figures.count:,}", noun(figures.count, "point")),
        (f"{fired:,}", f"{noun(fired, 'pulse')} emitted"),
        (f"{100 * hit / max(1, fired):.1f} %", "of the pulses with an echo"),
        (f"{figures.count / max(1, hit):.3f}", "echoes per pulse with an echo"),
        (f"{figures.mean_density():.4g} /m²", "point density of non-empty cells"),
        (f"{100 * figures.raster.coverage():.1f} %", f"coverage of {_cell(figures)} cells"),
    ]
    if figures.overlap() is not None:
        tiles.append((f"{100 * figures.overlap():.1f} %", "overlap: covered by two legs or more"))
    moving = [part["points"] for part in figures.moving_parts() if "points" in part]
    if moving:
        share = 100 * sum(moving) / max(1, figures.count)
        tiles.append((f"{share:.2g} %", "of the points on parts that moved"))
    is_joined = "parts_s" in timings
    rate = f"{fired / max(seconds, 1e-9) / 1e6:.2f} M pulses/s"
    tiles.append((time_span(seconds),
                  "run time of the parts" if is_joined else f"run time, {rate}"))  # fmt: skip
    return tiles


def _cell(figures):
    cell = figures.raster.cell
    return f"{cell:g} m" if cell >= 0.1 else f"{1000 * cell:.3g} mm"


def make_figure(title, note, png, alt):
    """Returns a picture of a page."""
    return {"title": title, "note": note, "png": base64.b64encode(png).decode(), "alt": alt}


def _maps(figures, reader):
    raster = figures.raster
    trajectories = [reader.trajectory(name) for name in reader.files]
    paths = [places[is_near(places)] for _, places, *_ in filter(None, trajectories)]
    figures_of = [
        make_figure(
            "Density", f"cells of {_cell(figures)}; white: no point; orange: the platform",
            charts.density_map(raster, paths),
            f"map of the density, {figures.mean_density():.3g} points/m² on average",
        )
    ]  # fmt: skip
    if figures.overlap() is not None:
        share = 100 * figures.overlap()
        figures_of.append(
            make_figure("Overlap", f"{share:.1f} % of the non-empty cells are covered twice or more",
                    charts.strips_map(raster), f"map of the overlap, {share:.1f} %")
        )  # fmt: skip
    return figures_of


def _histograms(figures):
    shown, missing = [], []
    for key, (title, axis, unit, note) in HISTOGRAM_TEXTS.items():
        histogram = figures.histograms[key]
        if not len(histogram.counts):
            missing.append(title.lower())
            continue
        if key == "range" and figures.range_is_computed:
            note = "distance to the platform: text files have no ranges"
        median = histogram.quantile(0.5)
        png = charts.histogram(*_focus(histogram), axis, median, unit, log=key == "width")
        shown.append(
            make_figure(title, note, png, f"{title}: histogram, median {median:.4g} {unit}")
        )
    return shown + _bars(figures), missing


def _focus(histogram):
    """Edges and counts without the outermost points, which would compress the rest."""
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
        names = [str(i) for i in range(1, MAXIMUM_ECHOES)]
        counts = [int(count) for count in figures.echoes[1:MAXIMUM_ECHOES]]
        rest = int(figures.echoes[MAXIMUM_ECHOES:].sum())
        png = charts.bars([*names, f"{MAXIMUM_ECHOES} or more"], [*counts, rest], "echoes",
                           "fraction of the pulses with an echo [%]")  # fmt: skip
        found.append(make_figure("Echoes per pulse", "", png, "pulses by their number of echoes"))
    if figures.classes.any():
        numbers = sorted(range(256), key=lambda i: -figures.classes[i])[:12]
        numbers = [i for i in numbers if figures.classes[i]]
        names = [f"{i} {CLASSES.get(i, '')}".strip() for i in numbers]
        png = charts.bars(names, [int(figures.classes[i]) for i in numbers], "class",
                           "fraction of the points [%]")  # fmt: skip
        found.append(make_figure("Classes", "", png, "points by their class"))
    return found


def _legs(summary):
    timings = summary["timings"]
    spent = ["in parts" if "parts_s" in timings else f"{each:.2f}" for each in timings["legs_s"]]
    return [
        (
            leg["leg"], f"{leg['start_s']:.3f}", f"{leg['duration_s']:.3f}",
            f"{leg['pulsesFired']:,}", f"{100 * leg['pulsesHit'] / max(1, leg['pulsesFired']):.1f}",
            f"{leg['points']:,}", seconds,
        )
        for leg, seconds in zip(summary["legs"], spent)
    ]  # fmt: skip


def _files(figures, reader):
    """Returns the files and their points, unless every leg has its own."""
    if len(reader.files) == len(reader.summary["legs"]):
        return []
    return [(name, f"{count:,}") for name, count in zip(reader.files, figures.legs)]


def _settings(summary):
    timings, options = summary["timings"], summary["options"]
    return [
        ("beam sampling", summary["sampling"]),
        ("pulses", describe_paths(summary["totals"])),
        ("ray caster", summary["rayCaster"]),
        ("time", f"{timings['load_s']:.2f} s to load; {describe_time(summary['totals'], timings)}"),
        *accuracy_rows(summary.get("accuracy")),
        *describe_options(options),
        ("scene (SHA-256 of its triangles)", {"code": summary["scene"]}),
    ]  # fmt: skip


def _inputs(summary):
    return [
        (each["file"], readable(each["bytes"]), {"code": each["sha256"]})
        for each in summary["inputs"]
    ]
