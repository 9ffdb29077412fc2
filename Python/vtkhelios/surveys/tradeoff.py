# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cost of accuracy on a survey, and the parts of the model that it requires.

>>> result = vtkhelios.read_survey("survey.xml").tradeoff()
>>> print(result)
>>> result.cheapest(range_error=0.005, missed=0.01).name
"""

import csv
import dataclasses
import html
import io
import json

__all__ = ["Row", "Tradeoff"]

# Values of Row.kind.
SURVEY, SUB_RAYS, PATTERN, TOLERANCE = "survey", "sub-rays", "pattern", "tolerance"
BINS, DETECTOR, RAY_CASTER, MESH = "bins", "detector", "ray caster", "mesh"
PART, SCENE_PART = "part", "scene part"
# Ways that a survey file can name, with the same echo detector and bins.
SETTINGS = (SURVEY, SUB_RAYS, TOLERANCE, RAY_CASTER)
TOLD = 0.1  # smaller differences of times are chance
CHANGES = (  # rows of a verdict: measure, factor to mm or %, text
    ("missedAndInvented", 100.0, "{} % of the echoes missed or invented"),
    ("positionP95_m", 1e3, "positions by {} mm"),
    ("amplitudeRms", 100.0, "amplitudes by {} %"),
)


@dataclasses.dataclass
class Row:
    """A way to compute the survey, or the survey without a part of the model or scene."""

    name: str
    kind: str  #: survey, sub-rays, pattern, tolerance, bins, detector, ray caster, mesh; or part,
    #: scene part
    options: dict  #: of Survey.run(); without the mesh of the kinds mesh and scene part
    errors: dict  #: measures (Estimates) against the reference, or against the survey as it is
    seconds: float  #: processor time per pulse
    echoes: int
    memory: float = 0.0  #: of the scene and the trees of its ray caster [bytes]
    unclear: tuple = ()  #: measures below three times the error of the reference
    detail: str = ""  #: of a mesh: its triangles and its distance from the scene
    verdict: str = ""  #: of a part of the model: what it changes, and its share of the time

    @property
    def range_error(self):
        """The upper end of the 95th percentile [m]."""
        return self.errors["rangeP95_m"].upper

    @property
    def lost(self):
        """The upper end of the missed and invented echoes."""
        return self.errors["missedAndInvented"].upper

    @property
    def score(self):
        """The narrowest tolerance that it keeps: the largest of the 95th percentile of the range
        error [mm], missed and invented echoes [%] and the RMS of the amplitude error [%]."""
        errors = self.errors
        shares = errors["missedAndInvented"].value, errors["amplitudeRms"].value
        return max(1e3 * errors["rangeP95_m"].value, *(100 * share for share in shares))

    def as_dict(self):
        """Plain values: each measure, and its ends with _lower and _upper."""
        row = {"way": self.name, "kind": self.kind, "us_per_pulse": 1e6 * self.seconds}
        row |= {"memory_bytes": self.memory, "echoes": self.echoes, "score": self.score}
        for name, estimate in self.errors.items():
            ends = {f"{name}_lower": estimate.lower, f"{name}_upper": estimate.upper}
            row |= {name: estimate.value, **ends}
        return row | {
            "unclear": " ".join(self.unclear),
            "detail": self.detail,
            "verdict": self.verdict,
        }


def find_verdict(row, whole):
    """Returns what leaving out (or adding) a part of the model changes and costs, in words.

    Changes of less than 1 mm and 1 % are small; those below three times the error of the reference, and
    times below TOLD, cannot be told.
    """
    clear = {name: each.value for name, each in row.errors.items() if name not in row.unclear}
    changes = [
        text.format(_short(factor * clear[name]))
        for name, factor, text in CHANGES
        if factor * clear.get(name, 0.0) >= 1.0
    ]
    if changes:
        text = f"matters: {', '.join(changes)}"
    else:
        text = "small: below 1 mm and 1 %" if any(clear.values()) else "no difference"
    return f"{text}; {_describe_time(row.seconds / max(1e-12, whole.seconds))}"


def _describe_time(ratio):
    """Returns the cost of a part of the model, from the time without it over the time with it."""
    if abs(ratio - 1.0) < TOLD:
        return "no time"
    if ratio < 1.0:
        return f"{_short(100.0 * (1.0 - ratio))} % of the time"
    return f"{_short(ratio)} times the time"


def _short(value):
    """Returns a number with two digits."""
    return f"{float(f'{value:.2g}'):,g}"


class Table:
    """Rows of equal columns: ``table["way"]``, ``len(table)``, ``pandas.DataFrame(table.rows)``."""

    def __init__(self, rows):
        self.rows = rows
        self.columns = list(rows[0]) if rows else []

    def __len__(self):
        return len(self.rows)

    def __iter__(self):
        return iter(self.rows)

    def __getitem__(self, key):
        return [row[key] for row in self.rows] if isinstance(key, str) else self.rows[key]

    def to_csv(self):
        """Comma-separated text, with a line of names."""
        text = io.StringIO()
        writer = csv.DictWriter(text, self.columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(self.rows)
        return text.getvalue()

    def _repr_html_(self):
        def line(cells, tag):
            texts = (f"{cell:.4g}" if isinstance(cell, float) else str(cell) for cell in cells)
            return "<tr>" + "".join(f"<{tag}>{html.escape(t)}</{tag}>" for t in texts) + "</tr>"

        rows = "".join(line(row.values(), "td") for row in self.rows)
        return f"<table>{line(self.columns, 'th')}{rows}</table>"


@dataclasses.dataclass
class Tradeoff:
    """The result of Survey.tradeoff()."""

    survey: str
    pulses: int  #: of the sample, fired
    pulses_fired: float  #: of the whole survey, estimated
    reference: dict  #: the measures of its own error, at most; its tolerance [m]
    ways: list
    parts: list  #: the survey without a part of the model or scene, against the survey as it is
    noise: float  #: standard deviation of a range [m]; 0: none
    other_memory: float = 0.0  #: of a run besides scene and ray caster, estimated [bytes]
    absent: tuple = ()  #: what was not measured, and why

    @property
    def table(self):
        """The ways as a Table."""
        return Table([row.as_dict() for row in self.ways])

    @property
    def parts_table(self):
        """The parts of the model as a Table."""
        return Table([row.as_dict() for row in self.parts])

    @property
    def frontier(self):
        """The settings that none beats in both time and score, from the fastest."""
        rows = []
        for row in sorted(self._settings(), key=lambda row: (row.seconds, row.score)):
            if not rows or row.score < rows[-1].score:
                rows.append(row)
        return rows

    @property
    def fastest(self):
        """The fastest setting."""
        return min(self._settings(), key=lambda row: row.seconds)

    @property
    def smallest(self):
        """The setting that needs the least memory."""
        return min(self._settings(), key=lambda row: row.memory)

    @property
    def limits(self):
        """The least 95th percentile of the range error [m], and the least fraction of missed and
        invented echoes, that the reference can tell: its own."""
        own = self.reference
        return max(own["rangeP95_m"].value, own["tolerance"]), own["missedAndInvented"].value

    def has_setting(self, memory):
        """Returns whether a setting needs no more memory [bytes]."""
        return self.run_memory(self.smallest) <= memory

    def cheapest(self, range_error=None, missed=None, memory=None):
        """Returns the fastest setting with this 95th percentile of the range error [m] and this
        fraction of
        missed and invented echoes, by the upper ends of their intervals, in a memory [bytes]; None
        if there is no such setting, or if the reference cannot tell (see limits)."""
        asked = (range_error, missed)
        if any(ask is not None and ask < limit for ask, limit in zip(asked, self.limits)):
            return None
        fits = [
            row
            for row in self._settings(memory)
            if (range_error is None or row.range_error <= range_error)
            and (missed is None or row.lost <= missed)
        ]
        return min(fits, key=lambda row: row.seconds, default=None)

    def most_accurate(self, seconds=None, threads=1, memory=None):
        """Returns the setting with the least score of those that run the survey in a time [s] and a
        memory
        [bytes], the fastest of several; or None."""
        fits = [
            row
            for row in self._settings(memory)
            if seconds is None or self.run_time(row, threads) <= seconds
        ]
        return min(fits, key=lambda row: (row.score, row.seconds), default=None)

    def run_time(self, row, threads=1):
        """Returns the estimated time of the whole survey [s], without loading and writing."""
        return row.seconds * self.pulses_fired / threads

    def run_memory(self, row):
        """Returns the estimated memory of a run of the whole survey [bytes]."""
        return self.other_memory + row.memory

    def to_json(self):
        """Returns all results as JSON."""
        content = dataclasses.asdict(self)
        content["ways"] = [row.as_dict() | {"options": row.options} for row in self.ways]
        content["parts"] = [row.as_dict() | {"options": row.options} for row in self.parts]
        return json.dumps(content, indent=2)

    def _settings(self, memory=None):
        """The ways that a survey can name, in a memory [bytes]."""
        rows = [row for row in self.ways if row.kind in SETTINGS and self._gains(row)]
        return [row for row in rows if memory is None or self.run_memory(row) <= memory]

    def _gains(self, row):
        """Returns whether a ray caster, which changes no echo, is faster or smaller than the
        survey's."""
        if row.kind != RAY_CASTER:
            return True
        base = self.ways[0]
        same = [each for each in self.ways if each.kind in (SURVEY, RAY_CASTER)]
        own = min(each.seconds for each in same if each.memory == base.memory)
        is_faster = row.seconds < (1.0 - TOLD) * own
        return row.memory != base.memory and (is_faster or row.memory < 0.99 * base.memory)
