# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""What accuracy costs on a survey, and which parts of the model it requires.

>>> result = vtkhelios.read_survey("survey.xml").tradeoff()
>>> print(result)
>>> result.cheapest(range_error=0.005, missed=0.01).name
"""

import dataclasses
import importlib
import json

from ._accuracy import MEASURES, Estimate, Sampler

__all__ = ["Row", "Tradeoff", "make_tradeoff"]

SUB_RAYS_OF_REFERENCE, BINS_PER_PULSE = 4096, 50
CIRCLES = (1, 2, 3, 5, 9, 18)
TOLERANCES = (0.03, 0.01, 0.003, 0.001, 0.0003)  # [m]; ten times as many of the energy
BINS = (0.02, 0.0625, 0.125, 0.25)  # of the pulse
BIN_CIRCLES = 5
CLEAR = 3.0  # times the error of the reference


@dataclasses.dataclass
class Row:
    """A way to compute the survey, or the survey without a part of the model."""

    name: str
    kind: str  #: survey, sub-rays, tolerance, bins, detector, ray caster; or part
    options: dict  #: of Survey.run()
    errors: dict  #: measures (Estimates) against the reference, or against the survey as it is
    seconds: float  #: processor time per pulse
    echoes: int
    unclear: tuple = ()  #: measures below three times the error of the reference

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
        row |= {"echoes": self.echoes, "score": self.score}
        for name, estimate in self.errors.items():
            ends = {f"{name}_lower": estimate.lower, f"{name}_upper": estimate.upper}
            row |= {name: estimate.value, **ends}
        row["unclear"] = " ".join(self.unclear)
        return row


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
        import csv
        import io

        text = io.StringIO()
        writer = csv.DictWriter(text, self.columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(self.rows)
        return text.getvalue()

    def _repr_html_(self):
        import html

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
    reference: dict  #: the measures of its own error, at most
    ways: list
    parts: list  #: the survey without a part of the model, against the survey as it is
    noise: float  #: standard deviation of a range [m]; 0: none

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

    def cheapest(self, range_error=None, missed=None):
        """The fastest setting with this 95th percentile of the range error [m] and this fraction of
        missed and invented echoes, by the upper ends of their intervals; None: there is none."""
        fits = [
            row
            for row in self._settings()
            if (range_error is None or row.range_error <= range_error)
            and (missed is None or row.lost <= missed)
        ]
        return min(fits, key=lambda row: row.seconds, default=None)

    def most_accurate(self, seconds, threads=1):
        """The setting with the least score of those that run the survey in a time; or None."""
        fits = [row for row in self._settings() if self.run_time(row, threads) <= seconds]
        return min(fits, key=lambda row: row.score, default=None)

    def run_time(self, row, threads=1):
        """The estimated time of the whole survey [s], without loading and writing."""
        return row.seconds * self.pulses_fired / threads

    def to_json(self):
        """All results as JSON."""
        content = dataclasses.asdict(self)
        content["ways"] = [row.as_dict() | {"options": row.options} for row in self.ways]
        content["parts"] = [row.as_dict() | {"options": row.options} for row in self.parts]
        return json.dumps(content, indent=2)

    def _settings(self):
        """The ways that a survey can name: same echo detector, bins and ray caster."""
        return [row for row in self.ways if row.kind in ("survey", "sub-rays", "tolerance")]


def make_tradeoff(survey, pulses=2000, parts=True, on_step=None, **options):
    """See Survey.tradeoff(); on_step is called with a name and the fraction done."""
    ways = list(_ways())
    names = _class("vtkHeliosRunOptions").GetModelPartNames().split() if parts else []
    step = _Steps(on_step, len(ways) + len(names) + (4 if parts else 2))
    step.begin("drawing pulses")
    sampler = Sampler(survey, pulses, step.tell, options)
    bins = sampler.pulse_length()
    fine = {"bin_size": bins / BINS_PER_PULSE, "without": "voxels"}
    step.begin("reference")
    reference, _ = sampler.run(sub_rays=SUB_RAYS_OF_REFERENCE, **fine)
    half, _ = sampler.run(sub_rays=SUB_RAYS_OF_REFERENCE // 2, **fine)
    own = sampler.compare(half, reference)
    rows = []
    for name, kind, choice in ways:
        step.begin(name)
        truth = reference
        if kind == "bins":
            choice = {**choice, "bin_size": round(choice["bin_size"] * bins, 6)}
            name = f"{choice['sub_rays']} sub-rays, bins {choice['bin_size']:.3g} ns"
        elif kind == "detector":  # each measures the range in its own way
            truth, _ = sampler.run(sub_rays=SUB_RAYS_OF_REFERENCE, **choice, **fine)
        rows.append(_measure(sampler, name, kind, choice, truth, own))
    return Tradeoff(
        survey=survey.name,
        pulses=sampler.fired,
        pulses_fired=sampler.share_fired * sampler.total,
        reference=_plain(own) | {"subRays": SUB_RAYS_OF_REFERENCE},
        ways=rows,
        parts=_leave_out(sampler, survey, names, own, step) if parts else [],
        noise=_noise(survey),
    )


def _ways():
    """Name, kind and options of each way."""
    yield "the survey as it is", "survey", {}
    sampler = _class("vtkHeliosBeamSampler")()
    sampler.SetPatternToCircles()

    def count(circles):
        sampler.SetNumberOfCircles(circles)
        return sampler.GetNumberOfSubRays()

    for circles in CIRCLES:
        number = count(circles)
        yield f"{number} sub-ray{'s' if number > 1 else ''}", "sub-rays", {"sub_rays": number}
    for tolerance in TOLERANCES:
        choice = {"tolerance": tolerance, "energy_tolerance": min(1.0, 10 * tolerance)}
        yield f"tolerance {1e3 * tolerance:g} mm", "tolerance", choice
    for bins in BINS:
        choice = {"sub_rays": count(BIN_CIRCLES), "bin_size": bins}
        yield f"bins of {bins:g} pulses", "bins", choice
    for name in _class("vtkHeliosRunOptions").GetEchoDetectorNames().split():
        yield f"detector {name}", "detector", {"detector": name}
    factory = _class("vtkHeliosRayCasterFactory")
    for index in range(factory.GetNumberOfBackends()):
        name = factory.GetBackendName(index)
        yield f"ray caster {name}", "ray caster", {"ray_caster": name}


def _measure(sampler, name, kind, options, reference, own):
    """A way against the reference."""
    cloud, _ = sampler.run(**options, without="voxels")
    errors = sampler.compare(cloud, reference)
    unclear = [each for each in MEASURES if errors[each].value <= CLEAR * own[each].value]
    seconds = _seconds(sampler, options)
    return Row(name, kind, options, _only(errors), seconds, len(cloud), tuple(unclear))


def _leave_out(sampler, survey, names, own, step):
    """The survey without each part of the model, against the survey as it is; first itself."""
    step.begin("the whole model")
    whole, _ = sampler.run()
    rows = [
        Row("the whole model", "part", {}, _only(sampler.compare(whole, whole)),
            _seconds(sampler, {}), len(whole))
    ]  # fmt: skip
    source = survey.source_of({})
    for part in names:
        step.begin(f"without {part}")
        if part == "voxels" and source.GetGrid(0) is None:
            continue
        rows.append(_part(sampler, f"without {part}", {"without": part}, whole, own))
    step.begin("with noise")
    rows.append(_part(sampler, "with noise", {"noise": True}, whole, own))
    return rows


def _part(sampler, name, options, whole, own):
    cloud, _ = sampler.run(**options)
    errors = sampler.compare(cloud, whole)
    unclear = [each for each in MEASURES if errors[each].value <= CLEAR * own[each].value]
    seconds = _seconds(sampler, options)
    return Row(name, "part", options, _only(errors), seconds, len(cloud), tuple(unclear))


def _seconds(sampler, options):
    """Processor time per pulse fired."""
    return sampler.time(**options) / max(1e-9, sampler.share_fired)


def _only(errors):
    return {name: errors[name] for name in MEASURES}


def _plain(errors):
    return {name: Estimate(*errors[name]) for name in MEASURES}


def _noise(survey):
    """The standard deviation of a range of the first scanner [m]."""
    text = survey.vtk.GetScannerAttribute(0, "accuracy_m")
    try:
        return float(text)
    except ValueError:
        return 0.0


class _Steps:
    """Tells the name of the current step, and the fraction of all that is done."""

    def __init__(self, on_step, count):
        self._on_step, self._count = on_step, count
        self._done, self._name = -1, ""

    def begin(self, name):
        self._done, self._name = self._done + 1, name
        self.tell(0.0)

    def tell(self, _share):
        if self._on_step:
            self._on_step(self._name, min(1.0, max(0, self._done) / self._count))


def _class(name):
    return getattr(importlib.import_module(__package__), name)
