# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The folder of a run: its summary, and the points of its legs as one cloud."""

import itertools
import os
import pathlib
import re

import numpy as np

import vtkhelios

from ._base import ROWS, Reader, Scan, call, check_file, from_cloud, rows_of
from ._summary import read_summary
from ._text import TextReader
from ._vtp import PiecesReader

POINTS = re.compile(r"((leg|strip)([^/\\]+?))_points(_dev\d+)?\.(xyz|las|laz|pvtp)")
NUMBER = re.compile(r"-?\d{1,9}")


def is_run(path):
    """Whether a path is a folder, i.e. a run."""
    return pathlib.Path(path).is_dir()


class RunReader(Reader):
    """All points of a run, leg by leg, or of one of its files; all have LegIds."""

    kind = "run"

    def __init__(self, path, only=None):
        super().__init__(path)
        self.folder = pathlib.Path(path)
        self.summary = self._read_summary()
        names = [file["name"] for leg in self.summary["legs"] for file in leg["files"]]
        self.files = [
            name for name in dict.fromkeys(names) if POINTS.fullmatch(name) and only in (None, name)
        ]
        if not self.files:
            self.fail("its run_summary.json lists no point files; run the survey again")
        self.scans = [self._make_scan(name) for name in self.files]
        self._names = {}  # of objects in text
        self.notes = [] if only else self._find_unnamed()
        self._readers = [self._open(name) for name in self.files]
        self.header = self._readers[0].header
        self.has_waveforms = any(reader.has_waveforms for reader in self._readers) or any(
            self.folder.glob("*_fullwave*")
        )
        self.count = self._count()
        self.kind = (
            f"run of {len(self.files)} files of points ({pathlib.Path(self.files[0]).suffix})"
        )

    def _find_unnamed(self):
        """Notes on point files in the folder that the summary does not list."""
        beside = {path.name for path in self.folder.iterdir() if POINTS.fullmatch(path.name)}
        return [
            f"{self.folder / name}: is not read: run_summary.json does not list it; run the survey "
            "again, or remove the file"
            for name in sorted(beside - set(self.files))
        ]

    def _count(self):
        """The points of the files; legs of a strip that share a file add up."""
        records = {file["name"]: file["records"] for leg in self.summary["legs"]
                   for file in leg["files"]}  # fmt: skip
        return sum(records[name] for name in self.files)

    def _read_summary(self):
        path = self.folder / "run_summary.json"
        if os.path.lexists(path):
            return read_summary(path)
        if (self.folder / "run.journal").is_file():
            self.fail("the run is not finished; vtkhelios run --resume continues it")
        if any(self.folder.glob("play[0-9]*/run_summary.json")):
            self.fail("holds several epochs; give the folder of one: play000, play001 ...")
        self.fail("is a folder without run_summary.json; give the folder of a run, or files")

    def _open(self, name):
        from . import open_reader

        path = self.folder / name
        if path.suffix == ".xyz":
            check_file(path)
            return TextReader(path, self._names)
        return open_reader(path)

    def leg_of(self, name):
        """The number of the leg or strip in a file name; -1: its strip has a name."""
        number = POINTS.fullmatch(name)[3]
        return int(number) if NUMBER.fullmatch(number) else -1

    def read_chunks(self, rows):
        for self.scan, (name, reader) in enumerate(zip(self.files, self._readers)):
            reader.keeps_invalid = self.keeps_invalid
            for chunk in reader.chunks(rows):
                if "LegIds" not in chunk:
                    chunk["LegIds"] = np.full(rows_of(chunk), self.leg_of(name), np.int32)
                if reader.header.part_names:
                    self.header.part_names = reader.header.part_names
                yield chunk
            self.notes += [note for note in reader.notes if note not in self.notes]

    def trajectory(self, name):
        """Times [s], points [m] and quaternions of the leg of a point file; None: no file."""
        stem = POINTS.fullmatch(name)[1]
        for ending in (".txt", ".pvtp"):
            path = self.folder / f"{stem}_trajectory{ending}"
            if path.is_file():
                return self._read_trajectory(path)
        return None

    def _read_trajectory(self, path):
        if path.suffix == ".txt":
            return _text_trajectory(self, path)
        pieces = list(PiecesReader(path).chunks())
        names = ("GpsTime", "points", "Orientation")
        return tuple(np.concatenate([piece[name] for piece in pieces]) for name in names)

    def _make_scan(self, name):
        stem = pathlib.Path(name).name.split("_points")[0]
        trajectory = self.trajectory(name)
        pulses = self._pulses(POINTS.fullmatch(name)[1])
        if trajectory is None:
            return Scan(stem)
        _, places, turns = trajectory
        stands = np.ptp(places, axis=0).max() == 0.0
        if not stands:  # a local frame near the points
            return Scan(stem, tuple(np.rint(places.mean(axis=0))), has_pose=True)
        origin = next(pulses())["points"][0] if pulses else places[0]
        return Scan(stem, tuple(origin), tuple(turns[0]), True, pulses)

    def _pulses(self, stem):
        """A function that reads the pulses of a leg in chunks; None: there are none."""
        path = self.folder / f"{stem}_pulse.pvtp"
        if path.is_file():
            return lambda: PiecesReader(path).chunks()
        path = self.folder / f"{stem}_pulse.txt"
        return (lambda: _text_pulses(path)) if path.is_file() else None

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
                "Direction": table[:, 3:6],
                "GpsTime": 1e-9 * table[:, 6],
                "PulseIds": table[:, 7].astype(np.int64),
                "ChannelIds": table[:, 8].astype(np.int32),
            }


def _text_trajectory(owner, path):
    """x y z, GPS time, roll pitch yaw, as written by vtkHeliosTrajectoryTextWriter."""
    reader = vtkhelios.vtkHeliosTrajectoryReader()
    reader.SetFileName(str(path))
    for name, column in zip(("X", "Y", "Z", "Time", "Roll", "Pitch", "Yaw"), range(7)):
        getattr(reader, f"Set{name}Column")(column)
    reader.SetAngleConvention(reader.CANONICAL)
    reader.SetAngleUnit(reader.DEGREES)
    reader.SetSeparators(" ")
    call(owner, reader, reader.Update)
    chunk = from_cloud(reader.GetOutput())
    return chunk["GpsTime"], chunk["points"], chunk["Orientation"]
