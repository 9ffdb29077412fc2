# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A run, or its estimate, as text: from the report of the player."""

import itertools

from ..core.run_files import SUMMARY_NAME
from ..core.words import counted, time_span
from .accuracy import MILLIMETRES, PERCENT, accuracy_line, accuracy_lines, number, short

MAXIMUM_LEGS = 20
MAXIMUM_FILES = 12

FORECAST_SHARES = ("missed", "invented", "amplitudeRms")
FORECAST_COLUMNS = (  # head, width
    ("us/pulse", 10),
    ("run", 14),
    ("p95 mm", 32),
    ("missed %", 10),
    ("invented %", 12),
    ("amplitude %", 13),
)
COLUMNS = (  # columns of a table of legs: title, width, text
    ("leg", 5, lambda leg: str(leg["leg"])),
    ("start [s]", 12, lambda leg: f"{leg['start_s']:.3f}"),
    ("lasts [s]", 12, lambda leg: f"{leg['duration_s']:.3f}"),
    ("pulses", 15, lambda leg: f"{leg['pulses']:,}"),
    ("emitted", 15, lambda leg: f"{leg['pulsesFired']:,}"),
    ("points", 15, lambda leg: f"{leg['points']:,}"),
)


def summary_lines(report, folder, is_verbose=False):
    """Yields a finished run; in detail also versions, how pulses were sampled, and all of the accuracy."""
    totals, timings = report["totals"], report["timings"]
    versions = report["versions"]
    if is_verbose:
        yield (
            f"with     vtkHelios {versions['vtkHelios']}, VTK {versions['VTK']}, "
            f"ray caster {report['rayCaster']}"
        )
    yield f"sampling {describe_sampling(report, is_verbose)}"
    if len(report["legs"]) > 1:
        is_joined = "parts_s" in timings  # its legs were computed in the parts
        times = [] if is_joined else [("time [s]", 10, timings["legs_s"])]
        yield from table_lines(report["legs"], times)
    echoes = totals["firstReturns"]
    share = 100 * echoes / max(1, totals["pulsesFired"])
    yield f"pulses   {totals['pulsesFired']:,} emitted, {echoes:,} with an echo ({share:.1f} %)"
    if is_verbose:
        yield f"         {describe_paths(totals)}"
    yield from unresolved_lines(totals)
    yield f"points   {totals['points']:,} ({totals['firstReturns']:,} first returns)"
    yield f"time     {describe_time(totals, timings)}; {timings['load_s']:.2f} s to load the scene"
    yield from file_lines(report["legs"], folder)
    if "accuracy" in report and is_verbose:
        yield from accuracy_lines(report["accuracy"])
    elif "accuracy" in report:
        yield accuracy_line(report["accuracy"])


def describe_sampling(report, is_verbose):
    """Returns how beams are sampled: the method alone, or with its limits."""
    return report["sampling"] if is_verbose else report["sampling"].partition(";")[0]


def describe_time(totals, timings):
    """How long a run took, and its rates; one of parts was computed when they ran."""
    seconds = max(timings["run_s"], 1e-9)
    if "parts_s" in timings:
        return f"{timings['parts_s']:.2f} s in the parts, {seconds:.2f} s to join them"
    return (
        f"{seconds:.2f} s with {counted(timings['threads'], 'thread')}: "
        f"{totals['pulsesFired'] / seconds / 1e6:.2f} M pulses/s, "
        f"{totals['points'] / seconds / 1e6:.2f} M points/s"
    )


def file_lines(legs, folder):
    """Yields the files of a run, including the summary."""
    files = [(file["name"], file["bytes"]) for leg in legs for file in leg["files"]]
    lines = [f"{folder / name} ({readable(size)})" for name, size in files[:MAXIMUM_FILES]]
    if len(files) > MAXIMUM_FILES:
        lines.append(f"and {len(files) - MAXIMUM_FILES} more in {folder}")
    lines.append(f"{folder / SUMMARY_NAME}")
    for index, line in enumerate(lines):
        yield f"{'' if index else 'files':8} {line}"


def estimate_lines(report, is_verbose=False):
    """Yields an estimated run."""
    totals = report["totals"]
    yield f"sampling {describe_sampling(report, is_verbose)}"
    sizes = [readable(leg["bytes"]) for leg in report["legs"]]
    yield from table_lines(report["legs"], [("bytes", 12, sizes)])
    share = totals["pulsesSampled"] / max(1, totals["pulses"])
    yield f"legs     {len(report['legs'])}, {totals['duration_s']:.3f} s"
    yield f"pulses   {totals['pulses']:,}, {totals['pulsesFired']:,} of them emitted"
    yield f"points   {totals['points']:,}"
    yield f"files    {readable(totals['bytes'])}"
    yield f"memory   {readable(report['memory_bytes'])}"
    yield (
        f"time     {time_span(report['load_s'] + report['run_s'])} "
        f"with {counted(report['threads'], 'thread')}"
    )
    yield f"         estimated from {100 * share:.0f} % of the pulses; nothing was written"
    yield from forecast_table(report["forecast"])


def forecast_line(forecast):
    """Returns the price of tolerances, and what fixed sub-rays miss, as one line; None if it is not known."""
    if "reason" in forecast:
        return None
    adaptive = [way for way in forecast["ways"] if "subRays" not in way]
    fixed = next(way for way in forecast["ways"] if "subRays" in way)
    prices = []
    for time, equal in itertools.groupby(adaptive, lambda way: time_span(way["run_s"])):
        names = [_tolerance(way) for way in equal]
        prices.append(f"{' to '.join(dict.fromkeys((names[0], names[-1])))} {time}")
    return (
        f"price    about {', '.join(prices)}; {fixed['subRays']} fixed sub-rays {time_span(fixed['run_s'])}, with "
        f"{short(fixed['missedAndInvented'][0], PERCENT)} of the echoes missed or invented and 95 % of the ranges "
        f"within {short(fixed['rangeP95_m'][0], MILLIMETRES)}; from {counted(forecast['pulses'], 'pulse')}, without "
        "writing; --range-tolerance and --sub-rays choose"
    )


def forecast_table(forecast):
    """Yields time and errors of a run at several tolerances and numbers of sub-rays."""
    if "reason" in forecast:
        yield f"price    not known: {forecast['reason']}"
        return
    yield (
        f"price    of other settings, without writing, from {counted(forecast['pulses'], 'pulse')}; p95 of the range "
        "error with its 95 % confidence interval"
    )
    heads = "".join(f"{head:>{width}}" for head, width in FORECAST_COLUMNS)
    yield f"         {'':20}{heads}"
    for way in forecast["ways"]:
        is_fixed = "subRays" in way
        name = counted(way["subRays"], "sub-ray") if is_fixed else f"within {_tolerance(way)}"
        errors = [_ends(way["rangeP95_m"]), *(_percent(way, key) for key in FORECAST_SHARES)]
        cells = [f"{way['us_per_pulse']:.3g}", time_span(way["run_s"]), *errors]
        widths = (width for _, width in FORECAST_COLUMNS)
        yield f"         {name:20}" + "".join(f"{cell:>{w}}" for cell, w in zip(cells, widths))


def _tolerance(way):
    return short(way["rangeTolerance_m"], MILLIMETRES)


def _ends(estimate):
    value, lower, upper = (number(each, MILLIMETRES, "") for each in estimate)
    return f"{value} ({lower}, {upper})"


def _percent(way, key):
    return number(way[key][0], PERCENT, "")


def join_reports(epochs, reports):
    """Merges the reports of several epochs, with their sums."""
    joined = {"epochs": [{"epoch": epoch, **report} for epoch, report in zip(epochs, reports)]}
    names = reports[0]["totals"]
    joined["totals"] = {name: sum(each["totals"][name] for each in reports) for name in names}
    times = [each.get("timings", each) for each in reports]
    names = [name for name in ("load_s", "run_s", "parts_s") if name in times[0]]
    joined["timings"] = {name: sum(each[name] for each in times) for name in names}
    if "memory_bytes" in reports[0]:  # estimates: epochs run one at a time
        joined["memory_bytes"] = max(each["memory_bytes"] for each in reports)
    return joined


def epochs_lines(joined):
    """Yields all epochs of a survey together."""
    totals, timings = joined["totals"], joined["timings"]
    seconds = timings["load_s"] + timings["run_s"]
    yield f"epochs   {len(joined['epochs'])}, of the same legs"
    yield f"pulses   {totals['pulsesFired']:,}"
    yield f"points   {totals['points']:,}"
    if "memory_bytes" in joined:
        yield f"files    {readable(totals['bytes'])}"
        yield f"memory   {readable(joined['memory_bytes'])}"
    if "parts_s" in timings:
        yield f"time     {timings['parts_s']:.2f} s in the parts, {seconds:.2f} s to join them"
    else:
        yield f"time     {time_span(seconds)}"


def table_lines(legs, more):
    """Yields the legs, one per line; more columns are (title, width, one value per leg)."""
    shown = legs[:MAXIMUM_LEGS]
    columns = [(title, width, [text(leg) for leg in shown]) for title, width, text in COLUMNS]
    for title, width, values in more:
        texts = [value if isinstance(value, str) else f"{value:.2f}" for value in values]
        columns.append((title, width, texts[:MAXIMUM_LEGS]))
    padded = [_padded([title, *texts], width) for title, width, texts in columns]
    for index, cells in enumerate(zip(*padded)):
        yield f"{'' if index else 'legs':8}" + "".join(cells).removeprefix("  ")
    if len(legs) > MAXIMUM_LEGS:
        yield f"         and {len(legs) - MAXIMUM_LEGS} more"


def _padded(texts, width):
    """Returns the texts of one column, at its width or the longest plus two blanks."""
    width = max(width, 2 + max(map(len, texts)))
    return [f"{text:>{width}}" for text in texts]


def describe_paths(totals):
    """How pulses were sampled, and their cost."""
    pulses = totals["pulsesFired"]
    ways = {
        "with a planar footprint": totals["pulsesOnPlane"],
        "in closed form": totals["pulsesWithoutBins"],
        "with a binned waveform": totals["pulsesBinned"],
    }
    ways["without a hit"] = pulses - sum(ways.values())
    counts = ", ".join(f"{count:,} {way}" for way, count in ways.items() if count > 0)
    return f"{counts or 'none'}; {totals['subRays'] / max(1, pulses):.1f} sub-rays per pulse"


def unresolved_lines(totals):
    """For how many pulses the tolerances may not be kept."""
    count = totals.get("pulsesUnresolved", 0)
    if count > 0:
        share = 100 * count / max(1, totals["pulsesFired"])
        yield (
            f"         {count:,} of them ({share:.2g} %) need more sub-rays for the tolerances: "
            "give --max-sub-rays"
        )


def readable(size):
    """Returns a human-readable number of bytes: 1.2 MB."""
    for unit in ("B", "kB", "MB", "GB"):
        if size < 1000:
            return f"{size:.0f} {unit}" if unit == "B" else f"{size:.1f} {unit}"
        size /= 1000
    return f"{size:.1f} TB"
