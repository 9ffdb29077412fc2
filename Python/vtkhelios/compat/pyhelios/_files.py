# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files of a simulation: in a folder with the date, as HELIOS++ has it."""

import datetime
import importlib.util
import os
import pathlib
import tempfile

from ...core.run_files import POINTS, kind_of
from ._errors import PyHeliosToolsException

FORMAT = "%Y-%m-%d_%H-%M-%S"
CHUNK = 1_000_000  # points


def write_files(survey, output, kind, **options):
    """Runs a Survey, writes <output>/<name>/<date>/legNNN..., returns the files of points, as texts.

    kind is xyz, las or laz: LAZ files beside LAS files. The folder appears when it is complete.
    """
    if kind == "laz" and not (
        importlib.util.find_spec("laspy") and importlib.util.find_spec("lazrs")
    ):
        raise PyHeliosToolsException(
            "setZipOutput(True): LAZ files need laspy and lazrs: pip install laspy lazrs"
        )
    parent = pathlib.Path(output, survey.name)
    parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".unfinished", dir=parent) as scratch:
        report = survey.run_to(scratch, format="xyz" if kind == "xyz" else "las", **options)
        if kind == "laz":
            for path in _find_points(report["folder"]):
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
