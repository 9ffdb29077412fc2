# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files of a simulation: in a folder with the date, as HELIOS++ has it."""

import datetime
import importlib.util
import os
import pathlib
import tempfile

import numpy as np

from ...core.packages import advise
from ...core.run_files import POINTS, kind_of
from ...formats._laz import make_backend
from ...formats._records import RecordReader
from ._errors import PyHeliosToolsException

FORMAT = "%Y-%m-%d_%H-%M-%S"


def write_files(survey, output, kind, version, **options):
    """Runs a Survey, writes <output>/<name>/<date>/legNNN..., returns the files of points, as texts.

    kind is xyz, las or laz; version that of LAS, 1.4 or 1.0. The folder appears when it is complete.
    """
    is_old = version == "1.0" and kind != "xyz"
    if is_old and not importlib.util.find_spec("laspy"):
        raise PyHeliosToolsException(f"setLas10(True): LAS 1.0 files need laspy: {advise('laspy')}")
    parent = pathlib.Path(output, survey.name)
    parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".unfinished", dir=parent) as scratch:
        report = survey.run_to(scratch, format=kind, **options)
        for path in _find_points(report["folder"]) if is_old else ():
            _write_old(path)
        folder = _find_free(parent)
        os.rename(report["folder"], folder)
    return [str(path) for path in _find_points(folder)]


def _find_points(folder):
    """Returns the files of points that a run wrote."""
    return sorted(path for path in folder.iterdir() if kind_of(path) == POINTS)


def _find_free(parent):
    """Returns a new folder with the date and time, with a number if it exists."""
    now = datetime.datetime.now().strftime(FORMAT)
    folder, number = parent / now, 2
    while folder.exists():
        folder, number = parent / f"{now}_{number}", number + 1
    return folder


def _write_old(path):
    """Makes LAS 1.0 of a LAS or LAZ file: 1.1, which has the same records, under that number."""
    import laspy

    reader = RecordReader(path)
    las = reader.read_points(0, reader.header.point_count)
    old = laspy.LasData(laspy.LasHeader(point_format=1, version="1.1"))
    old.header.scales, old.header.offsets = reader.header.scales, reader.header.offsets
    old.points = laspy.ScaleAwarePointRecord.zeros(len(las), header=old.header)
    for name in ("X", "Y", "Z", "intensity", "user_data", "point_source_id", "gps_time"):
        old[name] = las[name]
    for name, most in (("return_number", 7), ("number_of_returns", 7), ("classification", 31)):
        old[name] = np.minimum(las[name], most)
    compress = path.suffix == ".laz"
    old.write(path, do_compress=compress, laz_backend=make_backend(laspy) if compress else None)
    with open(path, "r+b") as file:
        file.seek(VERSION)
        file.write(bytes((1, 0)))


VERSION = 24  # where a LAS file has its version
