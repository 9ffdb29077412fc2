# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The folder of a run: its summary, and the points of its legs as one cloud."""

import itertools
import os
import pathlib

import numpy as np

from ..array_names import CHANNEL_IDS, DIRECTION, GPS_TIME, LEG_IDS, ORIENTATION, PULSE_IDS
from ..core.classes import vtk_class

from ..core.run_files import (
    JOURNAL_NAME, POINTS, PULSES, SUMMARY_NAME, TRAJECTORY, WAVEFORMS, beside, is_epoch, kind_of,
    number_of, stem_of,
)  # fmt: skip
from ..core.words import counted
from ._base import ROWS, Reader, Scan, call, from_cloud, rows_of
from ._open import ending, open_file
from ._summary import read_summary
from ._text import TextReader
from ._vtp import PiecesReader


def is_run(path):
    """Returns whether a path is a folder, i.e. a run."""
    return pathlib.Path(path).is_dir()


class RunReader(Reader):
    """All points of a run, leg by leg, or of one of its files; all have LegIds."""

    kind = "run"

    def __init__(self, path, only=None):
        super().__init__(path)
        self.folder = pathlib.Path(path)
        self.summary = self._read_summary()
        self.files = [name for name in self._names(POINTS) if only in (None, name)]
        if not self.files:
            self.fail(f"its {SUMMARY_NAME} lists no point files; run the survey again")
        self.scans = [self._make_scan(name) for name in self.files]
        self._text = vtk_class("vtkHeliosPointTextReader")()  # one, for the names of parts
        self.notes = [] if only else self._find_unnamed()
        self._readers = [self._open(name) for name in self.files]
        self.header = self._readers[0].header
        self.has_waveforms = any(reader.has_waveforms for reader in self._readers) or any(
            kind_of(path) == WAVEFORMS for path in self.folder.iterdir()
        )
        self.count = self._count()
        self.kind = f"run of {counted(len(self.files), 'file')} of points ({ending(self.files[0])})"

    def _names(self, kind):
        """Returns the files of a kind that the summary lists."""
        names = [file["name"] for leg in self.summary["legs"] for file in leg["files"]]
        return [name for name in dict.fromkeys(names) if kind_of(name) == kind]

    def waveform_files(self):
        """The LAS files that have the same points with their waveforms; empty if there are none."""
        files = dict(zip(self._names(POINTS), self._names(WAVEFORMS)))
        found = [
            files[name] for name in self.files if files.get(name, "").endswith((".las", ".laz"))
        ]
        return found if len(found) == len(self.files) else []

    def _find_unnamed(self):
        """Notes on point files in the folder that the summary does not list."""
        present = {path.name for path in self.folder.iterdir() if kind_of(path) == POINTS}
        return [
            f"{self.folder / name}: is not read: {SUMMARY_NAME} does not list it; run the survey "
            "again, or remove the file"
            for name in sorted(present - set(self.files))
        ]

    def _count(self):
        """Returns the points of the files; legs of a strip that share a file add up."""
        records = {file["name"]: file["records"] for leg in self.summary["legs"]
                   for file in leg["files"]}  # fmt: skip
        return sum(records[name] for name in self.files)

    def _read_summary(self):
        path = self.folder / SUMMARY_NAME
        if os.path.lexists(path):
            return read_summary(path)
        if (self.folder / JOURNAL_NAME).is_file():
            self.fail("the run is not finished; vtkhelios run --resume continues it")
        if any(is_epoch(path) and (path / SUMMARY_NAME).exists() for path in self.folder.iterdir()):
            self.fail("holds several epochs; give the folder of one: epoch000, epoch001 ...")
        self.fail(f"is a folder without {SUMMARY_NAME}; give the folder of a run, or files")

    def _open(self, name):
        path = self.folder / name
        if path.suffix == ".xyz":
            return TextReader(path, self._text)
        return open_file(path)

    def read_chunks(self, rows):
        for self.scan, (name, reader) in enumerate(zip(self.files, self._readers)):
            reader.keeps_invalid = self.keeps_invalid
            for chunk in reader.chunks(rows):
                if LEG_IDS not in chunk:
                    chunk[LEG_IDS] = np.full(rows_of(chunk), number_of(name), np.int32)
                if reader.header.part_names:
                    self.header.part_names = reader.header.part_names
                yield chunk
            self.notes += [note for note in reader.notes if note not in self.notes]

    def trajectory(self, name):
        """Times [s], points [m] and quaternions of the leg of a point file; None: no file."""
        path = self._find(name, TRAJECTORY)
        return path and self._read_trajectory(path)

    def _find(self, name, kind):
        """Returns the file of a kind that belongs to a point file; None: no file."""
        paths = beside(self.folder / name, kind)
        return next((path for path in paths if path.is_file()), None)

    def _read_trajectory(self, path):
        if path.suffix == ".txt":
            return _text_trajectory(self, path)
        pieces = list(PiecesReader(path).chunks())
        names = (GPS_TIME, "points", ORIENTATION)
        return tuple(np.concatenate([piece[name] for piece in pieces]) for name in names)

    def _make_scan(self, name):
        stem = stem_of(name)
        trajectory = self.trajectory(name)
        pulses = self._pulses(name)
        if trajectory is None:
            return Scan(stem)
        _, places, turns = trajectory
        stands = np.ptp(places, axis=0).max() == 0.0
        if not stands:  # a local frame near the points
            return Scan(stem, tuple(np.rint(places.mean(axis=0))), has_pose=True)
        origin = next(pulses())["points"][0] if pulses else places[0]
        return Scan(stem, tuple(origin), tuple(turns[0]), True, pulses)

    def _pulses(self, name):
        """Returns a function that reads the pulses of a leg in chunks; None: there are none."""
        path = self._find(name, PULSES)
        if path is None:
            return None
        return lambda: _text_pulses(path) if path.suffix == ".txt" else PiecesReader(path).chunks()

    def close(self):
        for reader in self._readers:
            reader.close()


def _text_pulses(path, rows=ROWS):
    """Origin x y z, direction x y z, time [ns], pulse, channel."""
    with open(path) as file:
        while lines := list(itertools.islice(file, rows)):
            table = np.loadtxt(lines, ndmin=2)
            yield {
                "points": table[:, :3],
                DIRECTION: table[:, 3:6],
                GPS_TIME: 1e-9 * table[:, 6],
                PULSE_IDS: table[:, 7].astype(np.int64),
                CHANNEL_IDS: table[:, 8].astype(np.int32),
            }


def _text_trajectory(owner, path):
    """x y z, GPS time, roll pitch yaw, as written by vtkHeliosTrajectoryTextWriter."""
    reader = vtk_class("vtkHeliosTrajectoryReader")()
    reader.SetFileName(str(path))
    reader.UseWriterFormat()
    call(owner, reader, reader.Update)
    chunk = from_cloud(reader.GetOutput())
    return chunk[GPS_TIME], chunk["points"], chunk[ORIENTATION]
