# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Input clouds: numpy arrays, and LAS or LAZ files piece by piece.

Both are input for vtkHeliosPointVoxelizer, as any VTK data set with points is:

>>> from vtkhelios import points
>>> voxelizer = vtkhelios.vtkHeliosPointVoxelizer()
>>> voxelizer.SetInputData(points.points_from_arrays(xyz))
>>> voxelizer.SetInputConnection(points.las_source("trees.laz").GetOutputPort())
"""

import os

import numpy as np
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline

from ..array_names import CRS, NORMALS, RGB
from ..core.arrays import numpy_to_vtk
from ..core import packages
from ..core.pipeline import report_error
from ..formats import open_reader
from ..formats._records import FormatError, RecordReader

__all__ = ["las_source", "points_from_arrays"]

_COLOUR_TYPES = (np.uint8, np.uint16, np.float32, np.float64)


def points_from_arrays(xyz, normals=None, rgb=None, crs=None):
    """Returns a cloud of points (vtkPolyData without cells) from arrays of n rows and three
    columns.

    xyz
        coordinates [m]. float64 and float32 are not copied if contiguous, and the
        cloud keeps them alive; other types become float64.
    normals
        vectors of any length, 0 0 0 if not set.
    rgb
        uint8, uint16, or floats in [0, 1].
    crs
        the coordinate system, WKT or "EPSG:n".
    """
    coordinates = _triples("xyz", xyz, (np.float64, np.float32))
    cloud = vtkPolyData()
    holder = vtkPoints()
    holder.SetData(numpy_to_vtk(coordinates))  # in the array's own precision
    cloud.SetPoints(holder)
    if normals is not None:
        array = numpy_to_vtk(_triples("normals", normals, (np.float64,), len(coordinates)))
        array.SetName(NORMALS)
        cloud.GetPointData().SetNormals(array)
    if rgb is not None:
        array = numpy_to_vtk(_triples("rgb", rgb, _COLOUR_TYPES, len(coordinates)))
        array.SetName(RGB)
        cloud.GetPointData().AddArray(array)
    if crs:
        text = vtkStringArray()
        text.SetName(CRS)
        text.InsertNextValue(crs)
        cloud.GetFieldData().AddArray(text)
    return cloud


def _triples(name, values, types, rows=None):
    """Returns the values as a contiguous array of three columns, of one of the types, else the
    first."""
    array = np.asarray(values)
    if array.ndim != 2 or array.shape[1] != 3 or rows not in (None, len(array)):
        wanted = "n" if rows is None else rows
        raise ValueError(f"{name} has the shape {array.shape}; give an array of ({wanted}, 3)")
    if not array.dtype.isnative or array.dtype.type not in types:
        if name == "rgb" and array.dtype.kind not in "f":
            raise ValueError(f"rgb is {array.dtype}; give uint8, uint16, or floats in [0, 1]")
        array = array.astype(types[0] if name != "rgb" else np.float64)
    return np.ascontiguousarray(array)


def las_source(path, colors=False):
    """Returns a source (vtkAlgorithm) of the points of a LAS or LAZ file; needs laspy.

    It supports piece requests, so that a filter that requests one after the other never holds the
    file: piece i of n is the i-th of n ranges of points. The coordinate system of the file, if any,
    is field data; with colors, red, green and blue are RGB.

    Raises ImportError without laspy, OSError and ValueError for a file that cannot be read; later
    failures are errors of the source.
    """
    return _LasSource(path, colors)


class _LasSource(VTKPythonAlgorithmBase):
    def __init__(self, path, colors):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self._path = os.fspath(path)
        self._colors = colors
        self._records = self._open()
        header = self._records.header
        self._count = header.point_count
        names = set(header.point_format.dimension_names)
        self._crs = self._find_crs()
        if self._count == 0:
            raise ValueError(f"{self._path} has no points; give a file with points")
        if colors and not {"red", "green", "blue"} <= names:
            raise ValueError(f"{self._path} has no colours; leave colors off")

    def _open(self):
        """The records of the file, whose header is checked."""
        packages.load("laspy", "LAS and LAZ files need")
        try:
            return RecordReader(self._path)
        except FormatError as error:
            words = str(error).removeprefix(f"{self._path}: ")
            raise ValueError(f"{self._path} cannot be read: {words}") from error

    def _find_crs(self):
        if self._count == 0:
            return None
        with open_reader(self._path) as reader:
            return reader.header.crs

    def RequestInformation(self, _request, _in_info, out_info):
        out_info.GetInformationObject(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
        return 1

    def RequestData(self, _request, _in_info, out_info):
        info = out_info.GetInformationObject(0)
        keys = vtkStreamingDemandDrivenPipeline
        pieces = max(1, info.Get(keys.UPDATE_NUMBER_OF_PIECES()) or 1)
        piece = info.Get(keys.UPDATE_PIECE_NUMBER()) or 0
        begin, end = (self._count * min(i, pieces) // pieces for i in (piece, piece + 1))
        try:
            cloud = self._read(begin, end - begin)
        except Exception as error:  # no exception may cross the pipeline, whatever laspy raises
            report_error(self, f"{self._path}: points {begin} to {end} cannot be read: {error}")
            return 0
        vtkPolyData.GetData(out_info).ShallowCopy(cloud)
        return 1

    def _read(self, begin, count):
        rows = self._records.read_points(begin, count)
        with np.errstate(over="ignore", invalid="ignore"):
            xyz = np.column_stack([rows.x, rows.y, rows.z])
        if not np.isfinite(xyz).all():
            raise ValueError("coordinates are not finite; correct scale and offset in the header")
        rgb = np.column_stack([rows.red, rows.green, rows.blue]) if self._colors else None
        return points_from_arrays(xyz, rgb=rgb, crs=self._crs)
