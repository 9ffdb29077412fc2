# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes and trajectories in memory, as the inputs of a vtkHeliosSurveySource."""

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from ..core.views import data_of
from ..scenes.scene import Scene


def scene_data(scene):
    """Returns the data of a Scene, or a data object or algorithm as it is; for other meshes their
    Scene; None: none."""
    data = getattr(scene, "polydata", scene)
    if data is None or isinstance(data, (vtkDataObject, vtkAlgorithm)):
        return data
    try:
        return Scene(data).polydata
    except TypeError:
        raise TypeError(
            f"scene is of {type(scene).__name__}; give a Scene, a VTK data set with a surface, an "
            "algorithm that makes one, or a mesh with points and faces"
        ) from None


def trajectory_data(trajectory):
    """Returns the vtkPolyData of a trajectory, or its algorithm as it is; None: none."""
    data = data_of(trajectory)
    if data is None or isinstance(data, (vtkPolyData, vtkAlgorithm)):
        return data
    raise TypeError(
        f"trajectory is of {type(trajectory).__name__}; give a file name, a Cloud or vtkPolyData "
        "with the arrays GpsTime and Orientation, or an algorithm that makes one"
    )
