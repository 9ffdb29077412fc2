# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The result of a tradeoff as text."""


from ..core.words import duration
from ..surveys.accuracy import POSITION
from ..surveys.tradeoff import SCENE_PART, TOLD

COLUMNS = (  # title, measure, factor
    ("p50", "rangeP50_m", 1e3),
    ("p95", "rangeP95_m", 1e3),
    ("RMS mm", "rangeRms_m", 1e3),
    ("missed %", "missed", 1e2),
    ("invented", "invented", 1e2),
    ("amplitude", "amplitudeRms", 1e2),
    ("width ns", "widthRms_ns", 1.0),
)
PART_COLUMNS = (
    ("position", POSITION, 1e3),
    ("range mm", "rangeP95_m", 1e3),
    *COLUMNS[3:],
)
NAME, WIDTH = 28, 10
MARK = "~"
MEGABYTE = 1e6


def result_lines(result, threads):
    """Everything as text."""
    own = result.reference
    yield (
        f"from     {result.pulses:,} of about {result.pulses_fired:,.0f} pulses; reference: "
        f"adaptive within {_figure(own['tolerance'], 1e3)} mm, itself within "
        f"{_figure(own['rangeP95_m'].value, 1e3)} mm (p95), "
        f"{_figure(own['missedAndInvented'].value, 1e2)} % of the echoes"
    )
    yield ""
    yield from _way_table(result.ways)
    if result.parts:
        yield ""
        yield from _part_table(result.parts)
    for text in result.absent:
        yield f"not measured: {text}"
    yield ""
    yield f"{MARK} less than three times the error of the reference, or a tenth of the time;"
    yield "us: processor time per pulse; MB: scene and ray caster; p95 with its 95 % confidence"
    yield "interval; amplitude: RMS, of a full footprint [%]; position, range: 95th percentiles"
    yield ""
    names = ", ".join(row.name for row in result.frontier)
    yield f"none is both faster and more accurate than: {names}"
    base = result.ways[0]
    yield (
        f"the whole survey as it is takes about {duration(result.run_time(base, threads))} with "
        f"{threads} thread{'s'[: threads != 1]}, without loading and writing, and "
        f"{megabytes(result.run_memory(base))} MB"
    )


def megabytes(size):
    """Returns a size in MB, with three digits."""
    return f"{float(f'{size / MEGABYTE:.3g}'):,g}"


def _way_table(rows):
    yield "ways to compute this survey: errors against the reference"
    heads = "".join(f"{head:>{WIDTH}}" for head, _, _ in COLUMNS)
    yield f"{'':{NAME}}{heads}{'us':>9}{'MB':>8}{'p95 from, to mm':>19}"
    for row in rows:
        p95 = row.errors["rangeP95_m"]
        ends = f"{_figure(p95.lower, 1e3)}, {_figure(p95.upper, 1e3)}"
        yield (
            f"{row.name:{NAME}}{_cells(row, COLUMNS)}{1e6 * row.seconds:>9.3g}"
            f"{megabytes(row.memory):>8}{ends:>19}{_note(row)}"
        )


def _part_table(rows):
    """Tabulates the changes by each part of the model and of the scene, and their cost."""
    whole, *others = rows
    yield "what this scene requires: changes of the cloud, of us and of MB without each part"
    heads = "".join(f"{head:>{WIDTH}}" for head, _, _ in PART_COLUMNS)
    yield f"{'':{NAME}}{heads}{'echoes %':>{WIDTH}}{'us':>10}{'MB':>10}"
    yield (
        f"{whole.name:{NAME}}{'':{WIDTH * (len(PART_COLUMNS) + 1)}}{1e6 * whole.seconds:>9.3g} "
        f"{megabytes(whole.memory):>9}"
    )
    for row in others:
        time = row.seconds - whole.seconds
        mark = MARK if abs(time) < TOLD * whole.seconds else " "
        memory = (row.memory - whole.memory) / MEGABYTE
        echoes = "" if row.kind == SCENE_PART else f"{_change(row, whole):+.2g}"
        yield (
            f"{row.name[: NAME - 1]:{NAME}}{_cells(row, PART_COLUMNS)}{echoes:>{WIDTH - 1}} "
            f"{1e6 * time:>+9.2g}{mark}{f'{memory:+.3g}' if abs(memory) > 0.005 else '0':>9}"
            f"{_note(row)}"
        )


def _change(row, whole):
    """Returns the change of the number of echoes [%]."""
    return 100 * (row.echoes / max(1, whole.echoes) - 1)


def _cells(row, columns):
    return "".join(_cell(row, name, factor) for _, name, factor in columns)


def _note(row):
    notes = [note for note in (row.detail, row.verdict) if note]
    return f"  {'; '.join(notes)}" if notes else ""


def _cell(row, name, factor):
    value = row.errors[name].value
    mark = MARK if name in row.unclear and value > 0 else " "
    return f"{_figure(value, factor):>{WIDTH - 1}}{mark}"


def _figure(value, factor):
    return f"{factor * value:.3g}" if value > 1e-9 else "0"
