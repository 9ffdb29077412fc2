# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scanners from the calibration of a manufacturer.

>>> from vtkhelios import instruments
>>> text = instruments.read_ouster("os1.json")  # of a file with one <scanner>
"""

import math
import re

from ..core.classes import vtk_class
from ..core.json_files import JsonError, parse_json
from ..core.paths import text_from_vtk
from ..core.pipeline import PipelineError
from .items import change, paths_of, text_of

__all__ = ["InstrumentError", "read_ouster"]

_NONE = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]  # transformation


class InstrumentError(ValueError):
    """A calibration that cannot be used; the message names file, value and remedy."""


def read_ouster(path, id=None):
    """The metadata of an Ouster sensor (JSON) as the text of an XML file with one <scanner>.

    path
        metadata as its software saves them, of any firmware: beam_altitude_angles,
        beam_azimuth_angles, lidar_origin_to_beam_origin_mm or beam_to_lidar_transform,
        lidar_to_sensor_transform and lidar_mode are used.
    id
        of the scanner. Default: from the product and the mode, such as os1_128_1024x10.

    The scanner frame is the sensor frame of Ouster, with y = x and x = -y of the sensor. All beams of
    a column fire at once, at the angle of the encoder. Pulse k of column m has the number m n + k for
    n beams, in the order of the file, which is ChannelIds; ColumnIds is the measurement id. A range
    of the sensor is the distance from the origin of the beam plus the origin's distance from the axis.
    What is not in the file (wavelength, divergence, power, ranges) is left at the defaults.

    Raises InstrumentError if the file is not such a file, or a value in it is not valid, and OSError.
    """
    facts = _Metadata(path)
    columns, turns = facts.mode()
    altitudes = facts.angles("beam_altitude_angles", 90)
    azimuths = facts.angles("beam_azimuth_angles", 360)
    if len(altitudes) != len(azimuths):
        facts.fail(
            f"beam_altitude_angles has {len(altitudes)} values, but beam_azimuth_angles has "
            f"{len(azimuths)}; give one of each per beam"
        )
    offset, height = facts.beam_origin()
    start, place = facts.mount()
    product = str(facts.find("prod_line", "Ouster"))
    default = re.sub(r"\W+", "_", product.lower()).replace("os_", "os") + f"_{columns}x{turns}"
    beam = {"originOffset_m": offset, "originHeight_m": height, "firingTime_s": 0}
    values = {
        "name": f"Ouster {product} {facts.find('prod_sn', '')}".strip(),
        "optics": "spinning",
        "spin": "clockwise",
        "spinStart_deg": start,
        "pulseFreqs_Hz": columns * turns * len(altitudes),
        "scanFreqMin_Hz": turns,
        "scanFreqMax_Hz": turns,
        "beamOrigin": dict(zip("xyz", place)),
        "beams": {
            "beam": [
                {"elevation_deg": altitude, "azimuth_deg": -azimuth, **beam}
                for altitude, azimuth in zip(altitudes, azimuths)
            ]
        },
    }
    try:
        return scanner_text(id or default, values, _COMMENT.format(mode=f"{columns}x{turns}"))
    except PipelineError as error:
        facts.fail(error)


def scanner_text(id, values, comment):
    """Returns the text of a file with one scanner; values are those of Docs/dialect.md, see
    Parts.append()."""
    survey = vtk_class("vtkHeliosSurvey")()
    scanner = change(survey, "AddScanner", id)
    for path, value in paths_of(values):
        change(survey, "SetScannerAttribute", scanner, path, text_of(value))
    return text_from_vtk(survey.MakeFileText("scanner", scanner, comment, ""))


_COMMENT = """
  From the metadata of the sensor: beams, their origins, rates. Not in the metadata, and to be added
  from the data sheet: wavelength_nm, beamDivergence_rad, pulseLength_ns, accuracy_m, rangeMin_m,
  rangeMax_m, maxNOR. Mode {mode}.
"""


class _Metadata:
    """The values of a file, whatever section a firmware puts them into."""

    def __init__(self, path):
        self._path = path
        with open(path, "rb") as file:
            text = file.read()
        try:
            self._all = parse_json(text)
        except JsonError as error:
            self.fail(f"{error}; give the metadata of the sensor")
        if not isinstance(self._all, dict):
            self.fail("is not a JSON object; give the metadata of the sensor")

    def fail(self, message):
        raise InstrumentError(f"{self._path}: {message}")

    def find(self, name, default=None):
        """Returns the value with a name: at the top level, or in a section."""
        sections = [self._all, *(one for one in self._all.values() if isinstance(one, dict))]
        return next((one[name] for one in sections if one.get(name) is not None), default)

    def numbers(self, name, values, count=None):
        """Finite numbers; of the requested count."""
        if isinstance(values, list) and values and isinstance(values[0], list):
            values = [one for row in values for one in (row if isinstance(row, list) else [row])]
        if not isinstance(values, list) or not values or (count and len(values) != count):
            self.fail(f"{name} is not a list of {count or 'one or more'} numbers; correct it")
        for index, value in enumerate(values):
            if isinstance(value, bool) or not isinstance(value, (int, float)):
                self.fail(f"{name}[{index}] is {value!r}, not a number; correct it")
            if not math.isfinite(value):
                self.fail(f"{name}[{index}] is {value!r}; give a finite number")
        return [float(value) for value in values]

    def angles(self, name, most):
        values = self.find(name)
        if values is None:
            self.fail(f"has no {name}; give the metadata of an Ouster sensor")
        values = self.numbers(name, values)
        for index, value in enumerate(values):
            if abs(value) > most:
                self.fail(
                    f"{name}[{index}] is {value:g}; give an angle from {-most} to {most} [deg]"
                )
        return values

    def mode(self):
        """Returns the columns per revolution, and revolutions per second."""
        mode = self.find("lidar_mode")
        found = re.fullmatch(r"(\d{1,5})x(\d{1,3})", str(mode))
        if not found or not int(found[1]) * int(found[2]):
            self.fail(f"lidar_mode is {mode!r}; expected columns x revolutions/s, such as 1024x10")
        return int(found[1]), int(found[2])

    def beam_origin(self):
        """Distance from the axis and height of the origins [m]."""
        transform = self.find("beam_to_lidar_transform")
        if transform is not None:
            matrix = self.numbers("beam_to_lidar_transform", transform, 16)
            origin = [matrix[3], matrix[11]]
        else:
            offset = [self.find("lidar_origin_to_beam_origin_mm", 0.0)]
            origin = [*self.numbers("lidar_origin_to_beam_origin_mm", offset), 0.0]
        self._check_lengths("the beams start", origin)
        return origin[0] / 1000, origin[1] / 1000

    def _check_lengths(self, what, values):
        for value in values:
            if abs(value) > 1e4:
                self.fail(f"{what} {value:g} mm from the origin; give at most 10000 mm")

    def mount(self):
        """Returns the azimuth of the head at column 0 [deg], and where the lidar is [m], in our
        frame."""
        name = "lidar_to_sensor_transform"
        matrix = self.numbers(name, self.find(name, _NONE), 16)
        if max(abs(matrix[k] - (k == 10)) for k in (2, 6, 8, 9, 10)) > 1e-6:
            self.fail(f"{name} does not rotate about z; only such sensors are supported")
        turn = math.degrees(math.atan2(matrix[4], matrix[0]))
        lengths = [matrix[k] for k in (3, 7, 11)]
        self._check_lengths("the lidar is", lengths)
        x, y, z = (value / 1000 for value in lengths)
        return turn, (-y + 0.0, x, z)
