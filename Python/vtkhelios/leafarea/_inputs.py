# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scans of runs and files, read one after the other."""

import pathlib

import numpy as np

from .. import formats

from ..array_names import (
    AMPLITUDE, CLASSIFICATION_IDS, DIRECTION, ECHO_WIDTH, GPS_TIME, INCIDENCE_ANGLE, INTENSITY,
    MATERIAL_IDS, NUMBER_OF_RETURNS, ORIGIN, PULSE_IDS, REFLECTANCE, RETURN_NUMBER, WEIGHT,
)  # fmt: skip
from ..core.arrays import arrays
from ..core.classes import vtk_class
from ..core.paths import to_vtk
from ..core.systems import Metres
from ..core.run_files import HITS, SUMMARY_NAME
from ..core.words import counted
from ..formats import FormatError
from ..formats._base import Header, call, select, to_cloud
from ..formats._run import RunReader
from ..formats._vtp import PiecesReader
from ._scans import Scan, add_pulses, find_misses

KEPT = {
    "points", AMPLITUDE, CLASSIFICATION_IDS, DIRECTION, ECHO_WIDTH, GPS_TIME, INCIDENCE_ANGLE,
    INTENSITY, MATERIAL_IDS, NUMBER_OF_RETURNS, ORIGIN, PULSE_IDS, REFLECTANCE,
    RETURN_NUMBER, WEIGHT,
}  # fmt: skip


class Inputs:
    """Scans that can be read repeatedly, one in memory at a time."""

    def __init__(self, name, make_scans, notes):
        self.name, self._make_scans, self.notes = name, make_scans, notes

    def __iter__(self):
        return self._make_scans()


def read_inputs(clouds, trajectory, origin, spacing, on_step):
    """Returns the Inputs of files and runs."""
    if not clouds:
        raise ValueError("no clouds; give a run or files of points")
    paths = [cloud if hasattr(cloud, "data") else pathlib.Path(cloud) for cloud in clouds]
    for path in paths:
        if isinstance(path, pathlib.Path) and not path.exists():
            raise FormatError(f"{path}: no such file or folder; check its name")
    notes = []
    given = [trajectory] if isinstance(trajectory, (str, pathlib.Path)) else trajectory or ()
    paths_of_flight = [_read_trajectory(each) for each in given]

    def make_scans():
        for path in paths:
            if not isinstance(path, pathlib.Path):
                yield scan_of_cloud(path)
                continue
            on_step(f"reading {path}", 0.0)
            if path.is_dir():
                yield from _scans_of_run(path, notes)
            else:
                yield from _scans_of_file(path, paths_of_flight, origin, spacing, notes)

    names = [str(path) if isinstance(path, pathlib.Path) else "cloud" for path in paths]
    name = names[0] if len(paths) == 1 else f"{names[0]} and {len(paths) - 1} more"
    return Inputs(name, make_scans, notes)


def scan_of_cloud(cloud):
    """Returns the Scan of a Cloud, with its pulses and sub-rays if it has them."""
    pulses, hits = (None if each is None else each.data for each in (cloud.pulses, cloud.sub_rays))
    return Scan("cloud", cloud.data, pulses, hits, knows_misses=pulses is not None)


def _read_trajectory(path):
    if not pathlib.Path(path).is_file():
        raise FormatError(f"{path}: no such file; give the trajectory of the points")
    reader = vtk_class("vtkHeliosTrajectoryReader")()
    reader.SetFileName(to_vtk(path))
    call(_Named(path), reader, reader.Update)
    return reader.GetOutput()


class _Named:
    """A file whose errors are a FormatError."""

    def __init__(self, path):
        self.path, self.notes = str(path), []

    def fail(self, problem):
        raise FormatError(f"{self.path}: {problem}")


def _scans_of_run(folder, notes):
    run = RunReader(folder)
    run.close()
    for name in run.files:
        with RunReader(folder, only=name) as reader:
            chunks = _kept(reader.chunks())
            _add_notes(notes, reader.notes)
            if not chunks:
                continue
            _check_unit(folder / name, reader.header.crs, chunks[0]["points"])
            scan = Scan(str(folder / name), to_cloud(_join(chunks), reader.header))
            pulses = reader.scans[0].pulses
            if pulses is None:
                _add_notes(notes, [
                    f"{folder / name}: the pulses that hit nothing are not known: densities are too "
                    "high wherever beams leave the plants for the sky; run with --pulses"
                ])  # fmt: skip
                _add_places(scan, reader, name)
            else:
                scan.pulses = to_cloud(_join(_kept(pulses())))
                scan.knows_misses = True
                hits = reader._find(name, HITS)
                scan.hits = hits and to_cloud(_join(_kept(PiecesReader(hits).chunks())))
            yield scan


def _add_places(scan, reader, name):
    """Adds where the beams of a leg without pulses begin."""
    found = reader.trajectory(name)
    if found is None:
        raise FormatError(
            f"{scan.name}: has no pulses and no trajectory beside it in {SUMMARY_NAME}'s folder, so "
            "that its beams are not known; run with --pulses"
        )
    times, places, _ = found
    if np.ptp(places, axis=0).max() == 0.0:
        scan.origin = tuple(places[0])
    else:
        scan.trajectory = to_cloud({"points": places, GPS_TIME: times}, reader.header)


def _scans_of_file(path, trajectories, origin, spacing, notes):
    with formats.open_reader(path) as reader:
        groups = {}
        for chunk in reader.chunks():
            groups.setdefault(reader.scan, []).extend(_kept([chunk]))
        _add_notes(notes, reader.notes)
        if not any(groups.values()):
            raise FormatError(f"{path}: has no points; give a cloud with points")
        for index, chunks in groups.items():
            found = reader.scans[index]
            header = Header(reader.header.fields)
            scan = Scan(f"{path}, {found.name}" if len(groups) > 1 else str(path), None)
            chunk = _join(chunks)
            _check_unit(path, header.crs, chunk["points"])
            if trajectories:
                yield from _divide(scan, chunk, header, trajectories, notes)
                continue
            if origin is not None or found.has_pose:
                scan.origin = tuple(origin if origin is not None else found.translation)
                _add_pulses(scan, chunk, header, found, spacing, notes)
            elif ORIGIN in chunk:
                scan.echoes = to_cloud(chunk, header)
                _add_notes(notes, [_explain_misses(scan)])
            else:
                raise FormatError(
                    f"{scan.name}: does not tell where its beams begin, without which no path "
                    "through a voxel is known; give --origin X Y Z of a tripod, --trajectory of a "
                    "flight (vtkhelios fit finds one), or a PTX or E57 file with poses"
                )
            yield scan


def _check_unit(path, crs, points):
    """Refuses coordinates that are not metres, which positions and trajectories share."""
    metres = Metres(crs)
    if problem := metres.refuse_degrees(points[0]):
        raise FormatError(f"{path}: {problem}")
    if not metres.is_identity:
        raise FormatError(
            f"{path}: its coordinates have units of {metres.factors[0]:.9g} m, and heights of "
            f"{metres.factors[2]:.9g} m; convert it to a system in metres first: vtkhelios convert "
            "--crs"
        )


TIME_MARGIN = 1.0  # beyond the ends of a trajectory [s]


def _divide(scan, chunk, header, trajectories, notes):
    """Yields the points of each trajectory; others are left out, with a note."""
    _check_times(scan, chunk)
    times = chunk[GPS_TIME]
    rest = np.ones(len(times), bool)
    _add_notes(notes, [_explain_misses(scan)])
    for index, trajectory in enumerate(trajectories):
        on_path = arrays(trajectory)[GPS_TIME]
        low, high = on_path.min() - TIME_MARGIN, on_path.max() + TIME_MARGIN
        mask = rest & (times >= low) & (times <= high)
        rest &= ~mask
        if mask.any():
            echoes = to_cloud(select(chunk, mask), header)
            yield Scan(f"{scan.name}, trajectory {index + 1}", echoes, trajectory=trajectory)
    if rest.all():
        raise FormatError(
            f"{scan.name}: its times, {times.min():.3f} to {times.max():.3f} s, are not on any "
            "trajectory; give those of these points"
        )
    if rest.any():
        _add_notes(notes, [
            f"{scan.name}: {counted(int(rest.sum()), 'point')} of {len(rest):,} are left out: their "
            "times are not on any trajectory"
        ])  # fmt: skip


def _check_times(scan, chunk):
    if GPS_TIME not in chunk or np.ptp(chunk[GPS_TIME]) == 0:
        raise FormatError(
            f"{scan.name}: has no {GPS_TIME}, which places its beams on the trajectory; give points "
            "with times, as LAS of point format 1, 3 or 6 to 10"
        )


def _add_pulses(scan, chunk, header, found, spacing, notes):
    if spacing is not None:
        ways = chunk["points"] - np.asarray(scan.origin)
        lengths = np.linalg.norm(ways, axis=1)
        misses = find_misses(ways[lengths > 0] / lengths[lengths > 0, None], spacing)
    elif found.misses is not None:
        misses = np.concatenate([np.empty((0, 3)), *found.misses()])
    else:
        misses = np.empty((0, 3))
    add_pulses(scan, chunk, header, misses)
    # A grid of PTX has all pulses; a file with flags of directions may have none.
    scan.knows_misses = spacing is not None or found.has_all or len(misses) > 0
    if not scan.knows_misses:
        _add_notes(notes, [_explain_misses(scan)])


def _explain_misses(scan):
    return (
        f"{scan.name}: the pulses that hit nothing are not known: densities are too high wherever "
        "beams leave the plants for the sky (not over ground that returns all; --spacing of a "
        "tripod's pattern tells them)"
    )


def _add_notes(notes, more):
    notes += [note for note in more if note and note not in notes]


def _kept(chunks):
    return [
        {name: values for name, values in chunk.items() if name in KEPT}
        for chunk in chunks
        if len(chunk["points"])
    ]


def _join(chunks):
    """Returns the chunks as one, with the arrays common to all."""
    names = [name for name in chunks[0] if all(name in chunk for chunk in chunks)]
    return {name: np.concatenate([chunk[name] for chunk in chunks]) for name in names}
