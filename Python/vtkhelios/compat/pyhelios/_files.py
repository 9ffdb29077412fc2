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
from ._errors import PyHeliosToolsException

FORMAT = "%Y-%m-%d_%H-%M-%S"
CHUNK = 1_000_000  # points


def write_files(survey, output, kind, version, **options):
    """Runs a Survey, writes <output>/<name>/<date>/legNNN..., returns the files of points, as texts.

    kind is xyz, las or laz: LAZ files beside LAS files; version that of LAS, 1.4 or 1.0. The folder
    appears when it is complete.
    """
    is_old = version == "1.0" and kind != "xyz"
    if (kind == "laz" or is_old) and not (
        importlib.util.find_spec("laspy") and importlib.util.find_spec("lazrs")
    ):
        setter = "setLas10(True): LAS 1.0 files" if is_old else "setZipOutput(True): LAZ files"
        raise PyHeliosToolsException(f"{setter} need laspy and lazrs: {advise('laspy')}")
    parent = pathlib.Path(output, survey.name)
    parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".unfinished", dir=parent) as scratch:
        report = survey.run_to(scratch, format="xyz" if kind == "xyz" else "las", **options)
        for path in _find_points(report["folder"]) if kind != "xyz" else ():
            if is_old:
                _write_old(path, path.with_suffix(f".{kind}"))
            elif kind == "laz":
                _compress(path)
        folder = _find_free(parent)
        os.rename(report["folder"], folder)
    paths = _find_points(folder)
    return [str(path.with_suffix(".laz") if kind == "laz" else path) for path in paths]


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


def _compress(path):
    """Writes the LAZ file of a LAS file."""
    import laspy

    with laspy.open(path) as reader:
        with laspy.open(path.with_suffix(".laz"), mode="w", header=reader.header) as writer:
            for points in reader.chunk_iterator(CHUNK):
                writer.write_points(points)


def _write_old(path, target):
    """Writes LAS or LAZ 1.0 of a LAS file: 1.1, which has the same records, under that number."""
    import laspy

    las = laspy.read(path)
    old = laspy.LasData(laspy.LasHeader(point_format=1, version="1.1"))
    old.header.scales, old.header.offsets = las.header.scales, las.header.offsets
    old.points = laspy.ScaleAwarePointRecord.zeros(len(las.points), header=old.header)
    for name in ("X", "Y", "Z", "intensity", "user_data", "point_source_id", "gps_time"):
        old[name] = las[name]
    for name, most in (("return_number", 7), ("number_of_returns", 7), ("classification", 31)):
        old[name] = np.minimum(las[name], most)
    old.write(target)
    with open(target, "r+b") as file:
        file.seek(VERSION)
        file.write(bytes((1, 0)))


VERSION = 24  # where a LAS file has its version
