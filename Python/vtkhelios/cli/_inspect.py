# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contents of a file of points, and whether it agrees with itself."""

import pathlib

import numpy as np

from .. import formats

from ..array_names import (
    CLASSIFICATION_IDS, GPS_TIME, LEG_IDS, NUMBER_OF_RETURNS, RETURN_NUMBER,
    UNITS,
)  # fmt: skip
from ..catalogue._files import CatalogueError, read_root
from ..core.paths import text_from_vtk
from ..core.reading import make_reader
from ..core.systems import Metres
from ..core.words import counted
from ..formats._base import rows_of
from ..formats._names import NAME_KEYS, NAMES
from ..formats._records import EXTENDED_HEAD, RecordReader
from ..formats._run import is_run
from ..reports.raster import FARTHEST, Raster, is_near, tally

RECORDS = (".las", ".laz", ".copc.laz")
POINTS_A_CELL = 8  # for the point spacing


class Inspection:
    """Reads all points once; ``facts`` is the --json output, ``warnings`` the problems."""

    def __init__(self, path, height_unit=None):
        self.path = path
        self._height_unit = height_unit
        self._metres = None  # unit of the file's system
        self.facts = {}
        self.warnings = []
        self._low = np.full(3, np.inf)
        self._high = np.full(3, -np.inf)
        self._returns = np.zeros(256, np.int64)
        self._classes = np.zeros(256, np.int64)
        self._legs = {}
        self._named = {ids: {} for ids in NAMES}  # points by number
        self._times = [np.inf, -np.inf]
        self._last_time = -np.inf
        self._backward = self._invalid = self._impossible = self._count = self._far = 0
        self._raster = Raster(limit=1024)

    def run(self, task):
        with formats.open_reader(self.path) as reader:
            task.total = reader.count
            reader.keeps_invalid = True  # they are counted
            self._metres = Metres(reader.header.crs, self._height_unit)
            arrays = None
            for chunk in reader.chunks():
                arrays = arrays or {name: values[:0] for name, values in chunk.items()}
                self._add(chunk, reader.scan)
                task.advance(rows_of(chunk))
            self._add_facts(reader, arrays)
        if not is_run(self.path) and formats.ending(self.path) in RECORDS:
            self._add_head_facts()
        self._check(reader)
        if self._metres.guess:
            self.warnings.append(self._metres.guess)
        if self._count and (problem := self._metres.refuse_degrees(self._low)):
            self.warnings.append(f"spacing and density are not measured: {problem}")

    def _add(self, chunk, scan):
        points = chunk["points"]
        finite = np.isfinite(points).all(axis=1)
        self._invalid += int(np.count_nonzero(~finite))
        points = points[finite]
        self._count += rows_of(chunk)
        if len(points):
            self._low = np.minimum(self._low, points.min(axis=0))
            self._high = np.maximum(self._high, points.max(axis=0))
            if not self._metres.is_geographic:
                self._add_cells(self._metres.convert(points), scan)
        if RETURN_NUMBER in chunk:
            self._returns += tally(chunk[RETURN_NUMBER])
            if NUMBER_OF_RETURNS in chunk:
                odd = chunk[RETURN_NUMBER] > chunk[NUMBER_OF_RETURNS]
                self._impossible += int(np.count_nonzero(odd))
        if CLASSIFICATION_IDS in chunk:
            self._classes += tally(np.clip(chunk[CLASSIFICATION_IDS], 0, 255))
        if LEG_IDS in chunk and chunk[LEG_IDS].dtype.kind in "iu":
            _count(chunk[LEG_IDS], self._legs)
        for ids in NAMES:
            if ids in chunk and chunk[ids].dtype.kind in "iu":
                _count(chunk[ids], self._named[ids])
        if GPS_TIME in chunk and rows_of(chunk):
            with np.errstate(all="ignore"):  # some times are not finite
                self._add_times(chunk[GPS_TIME].reshape(rows_of(chunk), -1)[:, 0])

    def _add_cells(self, points, scan):
        near = is_near(points)
        self._far += int(np.count_nonzero(~near))
        self._raster.add(points[near, :2], scan)

    def _add_times(self, times):
        self._times = [min(self._times[0], times.min()), max(self._times[1], times.max())]
        self._backward += int(np.count_nonzero(np.diff(times) < 0) + (times[0] < self._last_time))
        self._last_time = times[-1]

    def _add_facts(self, reader, arrays):
        facts = self.facts
        facts["file"] = str(self.path)
        facts["format"] = reader.kind
        facts["points"] = self._count
        if self._count > self._invalid:
            facts["bounds"] = {"minimum": self._low.tolist(), "maximum": self._high.tolist()}
            facts["spacing_m"] = self._spacing() if self._raster.counts.size else None
            facts["density_m2"] = facts["spacing_m"] and facts["spacing_m"] ** -2
        facts["crs"] = reader.header.crs or None
        facts["unit_m"], _, facts["heightUnit_m"] = self._metres.factors.tolist()
        if reader.header.epoch:
            facts["gpsEpoch_s"] = reader.header.epoch
        if np.isfinite(self._times).all():
            facts["gpsTime_s"] = {"first": self._times[0], "last": self._times[1]}
        facts["returns"] = {str(i): int(n) for i, n in enumerate(self._returns) if n}
        facts["classes"] = {str(i): int(n) for i, n in enumerate(self._classes) if n}
        facts["legs"] = {str(leg): count for leg, count in sorted(self._legs.items())}
        for key, ids in zip(NAME_KEYS, NAMES):
            if names := reader.header.texts(NAMES[ids]):
                facts[key] = _name_counts(names, self._named[ids])
        facts["arrays"] = [
            {"name": name, "type": values.dtype.name, "unit": UNITS.get(name),
             "components": int(np.prod(values.shape[1:], dtype=int))}
            for name, values in (arrays or {}).items() if name != "points"
        ]  # fmt: skip

    def _spacing(self):
        """Approximate, in xy: of the median non-empty cell, with some points per cell."""
        raster = self._raster
        while raster.counts.sum() < POINTS_A_CELL * np.count_nonzero(raster.counts):
            if min(raster.counts.shape) <= 2:
                break
            raster.coarsen()
        counts = raster.counts[raster.counts > 0]
        return float(raster.cell / np.sqrt(np.median(counts)))

    # Facts of LAS and LAZ.

    def _add_head_facts(self):
        try:
            reader = RecordReader(self.path)
        except formats.FormatError as error:
            if "pip install" not in str(error):
                raise
            self.warnings.append(f"the header is not checked: {error}")
            return
        header, facts = reader.header, self.facts
        facts["software"] = _text(header.generating_software)
        facts["system"] = _text(header.system_identifier)
        facts["scale"] = [float(x) for x in header.scales]
        facts["offset"] = [float(x) for x in header.offsets]
        facts["globalEncoding"] = reader.encoding
        facts["gpsTimeKind"] = "adjusted standard" if reader.encoding & 1 else "not adjusted"
        facts["headerRecords"] = [
            {"user": _text(each.user_id), "id": int(each.record_id),
             "description": _text(each.description)}
            for each in header.vlrs if not 100 <= each.record_id < 355
        ]  # fmt: skip
        facts["extendedRecords"] = [
            {"user": _text(each.user), "id": each.number, "bytes": each.size - EXTENDED_HEAD,
             "description": _text(each.description)}
            for each in reader.extended_heads
        ]  # fmt: skip
        facts["extraBytes"] = [
            {
                "name": _text(each.name),
                "type": str(each.dtype),
                "description": _text(each.description),
            }
            for each in header.point_format.extra_dimensions
        ]
        self._add_waveform_facts(reader)
        self._check_head(header)
        self.warnings += reader.notes

    def _add_waveform_facts(self, reader):
        if not reader.header.point_format.has_waveform_packet:
            return
        try:
            path, place, size = reader.packets()
        except formats.FormatError as error:
            self.warnings.append(str(error))
            return
        where = "internal" if path == reader.path else path
        self.facts["waveforms"] = {"packets": where, "bytes": size - 60}

    def _check_head(self, header):
        steps = np.abs(np.asarray(header.scales))
        if self._count:
            for name, told, found in (
                ("minimum", header.mins, self._low), ("maximum", header.maxs, self._high),
            ):  # fmt: skip
                if (np.abs(np.asarray(told) - found) > 0.75 * steps).any():
                    self.warnings.append(
                        f"the {name} in the header is {_triple(told)}, but that of the points "
                        f"{_triple(found)}; vtkhelios convert corrects it"
                    )
        told = np.asarray(header.number_of_points_by_return)
        found = self._returns[1 : len(told) + 1]
        if not np.array_equal(told, found) and self._returns.sum():
            self.warnings.append(
                f"the header counts {told.tolist()} points by return, but there are "
                f"{found.tolist()}; vtkhelios convert corrects it"
            )

    def _check(self, reader):
        if reader.count is not None and reader.count != self._count and "E57" not in reader.kind:
            self.warnings.append(
                f"the header counts {counted(reader.count, 'point')}, but there are {self._count:,}"
            )
        if self._invalid:
            self.warnings.append(
                f"{counted(self._invalid, 'point', 'are')} not finite; vtkhelios convert --skip-invalid drops "
                "them"
            )
        if self._far:
            self.warnings.append(
                f"{counted(self._far, 'point', 'are')} more than {FARTHEST:g} m from the origin; the spacing "
                "excludes them"
            )
        if self._impossible:
            self.warnings.append(
                f"{counted(self._impossible, 'point', 'have')} a return number above their number of returns"
            )
        if self._returns[0]:
            self.warnings.append(
                f"{counted(self._returns[0], 'point', 'have')} the return number 0"
            )
        if self._backward and "copc" not in reader.kind.lower():
            self.warnings.append(
                f"GPS times decrease {self._backward:,} times from point to point: points are not "
                "in order of measurement"
            )
        self.warnings += reader.notes


def _count(numbers, counts):
    """Adds the points of each number to a table."""
    for number, count in zip(*np.unique(numbers, return_counts=True)):
        counts[int(number)] = counts.get(int(number), 0) + int(count)


def _name_counts(names, counts):
    """Returns the points of each part or material: the number, its name if it has one, and the
    count."""
    return [
        {"id": number, "name": names[number] if 0 <= number < len(names) else None, "points": count}
        for number, count in sorted(counts.items())
    ]


def _text(value):
    """Returns a header string; laspy returns bytes if it is not UTF-8."""
    return value.decode(errors="replace") if isinstance(value, bytes) else value


def _triple(values):
    return "(" + ", ".join(f"{value:.12g}" for value in values) + ")"


def inspect_xml(path, assets, messages):
    """Facts about a document: its survey, else what it holds; None after an error."""
    try:
        root = read_root(path)
    except CatalogueError:
        root = None  # the reader tells why
    if root is None or root.find("survey") is not None:
        return inspect_survey(path, assets, messages)
    return inspect_document(path, root, assets, messages)


def inspect_document(path, root, assets, messages):
    """Facts about a document without a survey, or None after an error."""
    reader = make_reader(str(path), assets)
    messages.watch(reader)
    if not reader.Check():
        messages.error_unless_told(f"{path}: cannot be read")
        return None
    return {
        "file": str(path),
        "format": f"document ({_name_form(path)})",
        "scenes": [
            {
                "id": scene.get("id", ""),
                "name": scene.get("name", ""),
                "parts": [_inspect_part(part) for part in scene.findall("part")],
                "tables": [table.get("file", "") for table in scene.findall("partTable")],
            }
            for scene in root.findall("scene")
        ],
        "platforms": [each.get("id", "") for each in root.findall("platform")],
        "scanners": [each.get("id", "") for each in root.findall("scanner")],
        "plans": [each.get("name", "") for each in root.findall("surveyPlanner")],
    }


def _name_form(path):
    return "HELIOS XML" if pathlib.Path(path).suffix.lower() == ".xml" else "YAML"


def _inspect_part(part):
    parameters = [each for filter in part.findall("filter") for each in filter.findall("param")]
    files = [each.get("value", "") for each in parameters if "filepath" in each.get("key", "")]
    return {
        "id": part.get("id", ""),
        "filters": [filter.get("type", "") for filter in part.findall("filter")],
        "files": files,
    }


def list_moving(survey):
    """The parts that move, and how, of a vtkHeliosSurvey."""
    motions = (
        (survey.GetPartName(i), survey.GetPartMotion(i)) for i in range(survey.GetNumberOfParts())
    )
    return [
        {"part": text_from_vtk(name), "motion": text_from_vtk(motion)}
        for name, motion in motions
        if motion
    ]


def inspect_survey(path, assets, messages):
    """Facts about a survey, or None after an error."""
    reader = make_reader(str(path), assets)
    messages.watch(reader)
    if not reader.Read():
        messages.error_unless_told(f"{path}: cannot be read")
        return None
    survey = reader.GetSurvey()
    legs = []
    for leg in range(survey.GetNumberOfLegs()):
        position = [0.0, 0.0, 0.0]
        survey.GetLegPosition(leg, position)
        legs.append({
            "leg": leg, "active": survey.IsLegActive(leg), "position_m": position,
            "onGround": survey.IsLegOnGround(leg),
            "pulseFrequency_Hz": survey.GetLegPulseFrequency(leg),
            "scanFrequency_Hz": survey.GetLegScanFrequency(leg),
        })  # fmt: skip
    return {
        "file": str(path),
        "format": f"survey ({_name_form(path)})",
        "name": text_from_vtk(survey.GetName()),
        "scanner": text_from_vtk(survey.GetScannerName()),
        "platform": text_from_vtk(survey.GetPlatformName()),
        "moving": survey.IsMoving(),
        "scene": text_from_vtk(survey.GetSceneName()),
        "movingParts": list_moving(survey),
        "epochs": survey.GetNumberOfEpochs(),
        "seed": survey.GetSeed(),
        "legs": legs,
    }
