# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of the files of a run, from vtkHeliosRunFiles; names need not be UTF-8."""

from ..vtkHeliosFiltersIO import vtkHeliosStreamWriter
from ..vtkHeliosScannerRun import vtkHeliosRunFiles as Files
from .paths import from_vtk, to_vtk

SUMMARY_NAME = Files.GetSummaryName()
JOURNAL_NAME = Files.GetJournalName()
PART = vtkHeliosStreamWriter.GetPartEnding()  # ending of names of unfinished files
FORMATS = tuple(map(Files.GetFormat, range(Files.GetNumberOfFormats())))
POINTS, WAVEFORMS, PULSES, HITS, TRAJECTORY = (
    Files.POINTS,
    Files.WAVEFORMS,
    Files.PULSES,
    Files.HITS,
    Files.TRAJECTORY,
)


def kind_of(path):
    """POINTS, WAVEFORMS, PULSES, HITS or TRAJECTORY; -1: no file of a run."""
    return Files.GetKind(to_vtk(_name(path)))


def stem_of(path):
    """Returns the leg or strip of a file, as legNNN or stripNNN."""
    return from_vtk(Files.GetStem(to_vtk(_name(path))))


def number_of(path):
    """Returns the number of the leg or strip of a file; -1: the strip has a name."""
    return Files.GetNumber(to_vtk(_name(path)))


def file_of_leg(leg, kind, format):
    """Returns the name of a file of a leg."""
    return Files.GetFileName(Files.GetLegStem(leg), kind, format)


def beside(path, kind):
    """The paths that the file of a kind beside a file may have, by format."""
    names = (Files.GetBeside(to_vtk(_name(path)), kind, format) for format in FORMATS)
    return [path.with_name(from_vtk(name)) for name in dict.fromkeys(names) if name]


def is_epoch(path):
    """Returns whether a folder belongs to an epoch."""
    return find_epoch(path) >= 0


def find_epoch(path):
    """Returns the epoch of a folder, by its name; -1: none."""
    return Files.GetEpoch(to_vtk(_name(path)))


def _name(path):
    return getattr(path, "name", path)
