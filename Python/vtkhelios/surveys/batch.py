# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many scans of small scenes by one sensor, for learning and for robots that step.

>>> sensor = vtkhelios.Sensor("velodyne_vlp16", scan_frequency=10, duration=0.1)
>>> scans = vtkhelios.scan_many(scenes, poses, sensor)
>>> scans["Range"], scans.offsets
"""

import functools
import typing

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .. import _native
from ..array_names import AMPLITUDE, OFFSETS, ORIENTATION, PART_IDS, PULSE_IDS, RANGE, SCENE_IDS
from ..core.arrays import numpy_to_vtk
from ..core.classes import vtk_class

from ..core.pipeline import (
    SECONDS_BETWEEN_SIGNS, MessageLog, PipelineError, conclude, update,
)  # fmt: skip
from ..core.rotation import quaternions_of
from ..core.watching import Progress
from ..core.words import counted
from .inputs import scene_data
from .items import SETTINGS, attributes
from .scanning import make_survey
from .survey import check_options

if typing.TYPE_CHECKING:  # dictionaries of keywords, made by Python/make_stubs.py
    from .keywords import ScanOptions

__all__ = ["Scans", "Sensor", "scan_many"]

ARRAYS = (RANGE, AMPLITUDE, PULSE_IDS, PART_IDS)


class Scans:
    """The echoes of many scans, one array a quantity: ``scans["Range"]``, ``scans.points``.

    Echoes ``offsets[i]`` to ``offsets[i + 1]`` are of scan i; ``scans[i]`` is a dictionary of views of
    its arrays, "points" among them. Arrays are not copied from C++.
    """

    def __init__(self, data, pulses):
        self.data, self.pulses = data, pulses  #: the vtkPolyData; the pulses of a scan

    @functools.cached_property
    def offsets(self):
        """Where the echoes of each scan begin, and the end."""
        return vtk_to_numpy(self.data.GetFieldData().GetArray(OFFSETS))

    @functools.cached_property
    def points(self):
        """The coordinates of all echoes [m], n x 3."""
        points = self.data.GetPoints()
        return vtk_to_numpy(points.GetData()) if points else np.zeros((0, 3))

    @functools.cached_property
    def arrays(self):
        """All arrays by name, "points" among them."""
        data = self.data.GetPointData()
        names = map(data.GetArrayName, range(data.GetNumberOfArrays()))
        return {
            "points": self.points,
            **{name: vtk_to_numpy(data.GetArray(name)) for name in names},
        }

    def __len__(self):
        return len(self.offsets) - 1

    def __getitem__(self, key):
        if isinstance(key, str):
            return self.arrays[key]
        number = range(len(self))[key]
        begin, end = self.offsets[number], self.offsets[number + 1]
        return {name: values[begin:end] for name, values in self.arrays.items()}

    def __repr__(self):
        return f"Scans({len(self):,} of {counted(self.pulses, 'pulse')}, {counted(len(self.points), 'echo')})"


class Sensor:
    """A scanner of the catalogue, set up once for many scans.

    scanner, assets
        see make_survey(); a scanner with one channel, of whose beams there may be many.
    arrays
        of the echoes, besides their points; None: all. Default: Range, Amplitude, PulseIds, PartIds.
    more
        the settings of a leg, see make_survey(), such as scan_frequency and duration, and the options of
        Survey.run(), such as sub_rays, noise, seed.

    A sensor keeps the tree of its last scene: a scan of the same scene from another pose costs its
    pulses. Do not use it in two threads.
    """

    def __init__(
        self, scanner, assets=(), arrays=ARRAYS, **more: "typing.Unpack[ScanOptions]"
    ):  # fmt: skip
        known = {*SETTINGS, *attributes("leg")}
        settings = {name: more.pop(name) for name in list(more) if name in known}
        check_options(more, "neither a setting of a leg nor an option of a run")
        survey = make_survey(
            _make_triangle(), [(0, 0, 0)], scanner, "tripod", "sensor", assets, **settings
        )
        self._survey, self._source = survey, survey.source(**more)
        self._batch = vtk_class("vtkHeliosScanBatch")()
        self._batch.SetSource(self._source)
        self._batch.SetArrays("" if arrays is None else " ".join(arrays))
        self._batch.SetInputDataObject(1, vtkPolyData())
        self._scenes = self._given = None
        self._pose = _make_poses((0, 0, 0), None)  # pose of a single scan

    def scan(self, scenes, poses, scene_ids=None, progress=None) -> Scans:
        """Scans scenes from poses; returns the echoes of all scans (Scans).

        scenes
            what vtkhelios.scan() takes, or a list of them.
        poses
            of the scanner in the world (x right, y forward, z up), one or an array of them: positions x,
            y, z [m]; or positions and unit quaternions w, x, y, z (7 numbers); or 4 x 4 matrices.
        scene_ids
            the number of the scene of each pose. Default: the only scene, or that of the same number.
        progress
            see Survey.run().

        Scan i has the pulse ids and random numbers from i times the pulses of a scan. Raises
        PipelineError with the number of the scan, its scene and pose, and the reason.
        """
        self._set_scenes(scenes)
        self._set_poses(poses, scene_ids)
        with MessageLog() as log, Progress(progress) as watched:
            log.watch(self._batch)
            log.watch(self._source)
            log.watch(self._batch.GetExecutive())
            _native.run(self._batch, 0, [self._batch], watched.callback, SECONDS_BETWEEN_SIGNS)
        conclude(log)
        output, taken = self._batch.GetOutputDataObject(0), vtkPolyData()
        taken.ShallowCopy(output)
        output.ReleaseData()
        if not taken.GetFieldData().HasArray(OFFSETS):
            raise PipelineError(["the scans cannot be made, for a reason that was not reported"])
        return Scans(taken, self._batch.GetPulsesPerScan())

    def _set_scenes(self, scenes):
        """Connects scenes, unless they are those of the last scans."""
        given = list(scenes) if isinstance(scenes, (list, tuple)) else [scenes]
        if not given:
            raise ValueError("scenes is empty; give a scene, or several")
        if self._given is not None and [*map(id, given)] == [*map(id, self._given)]:
            return
        self._batch.RemoveAllInputConnections(0)
        self._scenes = [_polydata(scene, number) for number, scene in enumerate(given)]
        for scene in self._scenes:
            self._batch.AddInputDataObject(0, scene)
        self._given = given

    def _set_poses(self, poses, scene_ids):
        """Sets the poses; of one scan, as of a robot that steps, in place."""
        values = np.asarray(poses, float)
        if scene_ids is not None or values.shape not in ((3,), (7,)):
            self._batch.SetInputDataObject(1, _make_poses(values, scene_ids))
            return
        x, y, z, *turn = values.tolist()
        self._pose.GetPoints().SetPoint(0, x, y, z)
        self._pose.GetPointData().GetArray(ORIENTATION).SetTuple4(
            0, *(turn or (1.0, 0.0, 0.0, 0.0))
        )
        self._pose.Modified()
        self._batch.SetInputDataObject(1, self._pose)


def scan_many(scenes, poses, sensor, scene_ids=None, progress=None) -> Scans:
    """Scans many scenes, or one from many poses, by one sensor (a Sensor), on all threads: see
    Sensor.scan()."""
    if not isinstance(sensor, Sensor):
        raise TypeError(
            f"sensor is of {type(sensor).__name__}; give a vtkhelios.Sensor, which is set up once"
        )
    return sensor.scan(scenes, poses, scene_ids, progress)


def _polydata(scene, number):
    """Returns a scene as a vtkPolyData."""
    try:
        data = scene_data(scene)
    except TypeError as error:
        raise TypeError(f"scene {number}: {error}") from None
    data = update(data) if isinstance(data, vtkAlgorithm) else data
    if not isinstance(data, vtkPolyData):
        raise TypeError(
            f"scene {number} is of {type(scene).__name__}; give a Scene, a vtkPolyData or a mesh"
        )
    return data


def _make_poses(poses, scene_ids):
    """Returns poses as a vtkPolyData."""
    values = np.asarray(poses, float)
    if values.shape[-2:] == (4, 4):
        matrices = values.reshape(-1, 4, 4)
        places, turns = matrices[:, :3, 3], quaternions_of(_check_rotations(matrices[:, :3, :3]))
    elif values.ndim in (1, 2) and values.shape[-1] in (3, 7):
        rows = values.reshape(-1, values.shape[-1])
        places, turns = rows[:, :3], rows[:, 3:]
        if rows.shape[1] == 3:
            turns = np.tile([1.0, 0.0, 0.0, 0.0], (len(rows), 1))
    else:
        raise ValueError(
            f"poses has the shape {values.shape}; give n x 3, n x 7 (x, y, z, w, x, y, z) or n x 4 x 4"
        )
    data, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=True))
    data.SetPoints(points)
    _add(data, ORIENTATION, np.ascontiguousarray(turns))
    if scene_ids is not None:
        ids = np.atleast_1d(np.asarray(scene_ids, np.int64))
        if ids.shape != (len(places),):
            raise ValueError(
                f"scene_ids has the shape {ids.shape}; give one for each of {len(places)} poses"
            )
        _add(data, SCENE_IDS, ids)
    return data


def _check_rotations(matrices):
    """Returns rotation matrices; ValueError names the first that is none."""
    errors = np.abs(matrices @ np.swapaxes(matrices, 1, 2) - np.eye(3)).max(axis=(1, 2))
    wrong = np.flatnonzero(~(errors < 1e-6) | ~(np.linalg.det(matrices) > 0))
    if len(wrong):
        number = int(wrong[0])
        raise ValueError(
            f"pose {number}: its matrix {matrices[number].tolist()} is no rotation; give one of unit "
            "length and right-handed"
        )
    return matrices


def _add(data, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)


def _make_triangle():
    """Returns a scene in place of those that are scanned."""
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetDataTypeToDouble()
    for x, y in ((0, 0), (1, 0), (0, 1)):
        points.InsertNextPoint(x, y, 0)
    cells.InsertNextCell(3, [0, 1, 2])
    data.SetPoints(points)
    data.SetPolys(cells)
    return data
