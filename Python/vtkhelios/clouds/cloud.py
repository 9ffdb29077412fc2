# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds: a vtkPolyData of points, with its arrays as numpy arrays."""

import html
import itertools
import math
import numbers
import typing
import warnings

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vtkmodules.vtkCommonCore import (
    VTK_DOUBLE, vtkPoints, vtkTypeInt32Array, vtkTypeInt64Array,
)  # fmt: skip
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from .. import leafarea, webcloud
from ..array_names import UNITS
from ..core.arrays import arrays, numpy_to_vtk
from ..core.views import View
from ..core.words import counted, no_attribute
from ..exchange._clouds import to_open3d, to_pandas, to_pyvista
from .files import read_chunks, read_tables, write_cloud
from .join import add_clouds, join_tables
from .names import COORDINATES, explain_missing, find_array
from .transfer import pack, unpack

__all__ = ["Cloud", "Records", "read"]


class Cloud(View):
    """A thin view of a vtkPolyData: nothing is copied, and writing to an array writes to the data.

    polydata
        the vtkPolyData, for VTK, ParaView's writers, ``pyvista.wrap()``. Without cells, a
        vertex per point is added on first access, for rendering.
    data
        the same vtkPolyData unchanged: no vertices are added.
    waveforms, pulses, sub_rays
        additional output of a survey (a vtkTable and two Clouds), else None.

    >>> cloud.points[cloud["ReturnNumber"] == 1]
    """

    waveforms: typing.Any
    pulses: "Cloud | None"
    sub_rays: "Cloud | None"

    def __init__(self, polydata=None, waveforms=None, pulses=None, sub_rays=None):
        self.data = vtkPolyData() if polydata is None else polydata
        if not hasattr(self.data, "IsA") or not self.data.IsA("vtkPolyData"):
            kind = type(polydata).__name__
            raise TypeError(
                f"a Cloud is made of a vtkPolyData, not of {kind}; see Cloud.from_arrays()"
            )
        self.waveforms, self.pulses, self.sub_rays = waveforms, pulses, sub_rays

    @classmethod
    def from_arrays(cls, points, **columns) -> "Cloud":
        """Returns a cloud of points (n x 3) and arrays of n rows, shared if possible.

        float64 points and contiguous arrays of numbers are not copied. Boolean arrays become uint8.
        """
        cloud = cls()
        holder = vtkPoints()
        holder.SetDataType(VTK_DOUBLE)
        array = np.ascontiguousarray(points, dtype=np.float64)
        if array.ndim != 2 or array.shape[1] != 3:
            raise ValueError(f"points has the shape {array.shape}; give an array of (n, 3)")
        holder.SetData(numpy_to_vtk(array))
        cloud.data.SetPoints(holder)
        for name, values in columns.items():
            cloud[name] = values
        return cloud

    @property
    def polydata(self) -> typing.Any:
        """The vtkPolyData, with a vertex per point if it has no cells."""
        if self.data.GetNumberOfCells() == 0 and len(self):
            self.data.SetVerts(_make_vertices(len(self)))
        return self.data

    @property
    def points(self) -> np.ndarray:
        """The coordinates [m], n x 3."""
        holder = self.data.GetPoints()
        return vtk_to_numpy(holder.GetData()) if holder else np.empty((0, 3))

    @property
    def x(self) -> np.ndarray:
        """The first coordinate [m], a view of points; y and z are the others."""
        return self.points[:, 0]

    @property
    def y(self) -> np.ndarray:
        return self.points[:, 1]

    @property
    def z(self) -> np.ndarray:
        return self.points[:, 2]

    @property
    def names(self) -> list[str]:
        """The names of the point arrays, except string arrays."""
        return [name for name in arrays(self.data) if name != "points"]

    @property
    def bounds(self) -> tuple[float, float, float, float, float, float]:
        """The box in VTK's order: lowest x, highest x, lowest y, highest y, lowest z, highest z [m].

        NaN without points.
        """
        if not len(self):
            return (math.nan,) * 6
        ends = zip(self.points.min(axis=0).tolist(), self.points.max(axis=0).tolist())
        return tuple(itertools.chain.from_iterable(ends))

    @typing.overload
    def __getitem__(self, key: str) -> np.ndarray:
        ...

    @typing.overload
    def __getitem__(self, key: int) -> np.void:
        ...

    @typing.overload
    def __getitem__(self, key: "slice | list | np.ndarray") -> "Cloud":
        ...

    def __getitem__(self, key):
        """Returns an array by its name, without a copy; by an index, a record of the point; by a
        mask, a slice or indices, a Cloud of points.

        Names that laspy or PDAL have for the same values are known, too, with a warning.
        """
        if isinstance(key, numbers.Integral):
            return self.records[key]
        if not isinstance(key, str):
            return self.filter(key)
        if key == COORDINATES:
            return self.points
        array = self.data.GetPointData().GetArray(key)
        if array is not None:
            return vtk_to_numpy(array)
        name, component = self._find_alias(key)
        if name is None:
            raise KeyError(explain_missing(key, self.names))
        return self[name] if component is None else self[name][:, component]

    def _find_alias(self, name):
        """Returns the array, and its component, that another program's name stands for; warns."""
        found, component = find_array(name, self.names)
        if found not in (None, COORDINATES):
            hint = f"{name} is {found} here: cloud[{found!r}]"
            warnings.warn(hint, UserWarning, stacklevel=3)
        return found, component

    def __setitem__(self, name: str, values) -> None:
        """Adds or replaces an array; it has as many rows as there are points."""
        if name not in self and (found := find_array(name, self.names))[0]:
            name = self._find_alias(name)[0]
            if name == COORDINATES:
                self.points[:, slice(None) if found[1] is None else found[1]] = values
                self.data.GetPoints().Modified()
                return
        array = np.asarray(values)
        if len(array.shape) not in (1, 2) or len(array) != len(self):
            raise ValueError(f"{name} has the shape {array.shape}; give {len(self)} rows")
        if array.dtype.kind not in "iufb":
            raise TypeError(f"{name} is of {array.dtype}; give numbers")
        array = np.ascontiguousarray(array.view(np.uint8) if array.dtype.kind == "b" else array)
        column = numpy_to_vtk(array)
        column.SetName(name)
        self.data.GetPointData().AddArray(column)

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def __len__(self) -> int:
        return self.data.GetNumberOfPoints()

    def __bool__(self):
        return True

    @property
    def records(self) -> "Records":
        """All arrays as the fields of one table, without a copy: see Records."""
        columns = arrays(self.data)
        columns.setdefault("points", self.points)
        return Records(columns)

    def to_structured(self, names=None) -> np.ndarray:
        """Returns a structured array of all, or some, arrays; x, y and z are the first fields.

        This is a copy: its rows are contiguous in memory, while VTK's arrays are contiguous by
        column. ``records`` avoids the copy; so do ``points`` and ``[name]``.
        """
        return self.records.to_structured(names)

    def filter(self, keep) -> "Cloud":
        """Returns a new cloud of the points selected by a mask or by indices."""
        keep = keep if isinstance(keep, slice) else np.asarray(keep)
        if isinstance(keep, np.ndarray):
            if keep.dtype.kind not in "biu" or keep.ndim != 1:
                raise TypeError(
                    f"a cloud is indexed by a boolean mask or by indices, not by {keep.dtype}"
                )
            if keep.dtype.kind == "b" and len(keep) != len(self):
                raise ValueError(f"the mask has {len(keep)} rows; give one per point: {len(self)}")
        columns = arrays(self.data)
        kept = Cloud.from_arrays(self.points[keep])
        for name, values in columns.items():
            if name != "points":
                kept[name] = values[keep]
        kept.data.GetFieldData().ShallowCopy(self.data.GetFieldData())
        kept.waveforms, kept.pulses, kept.sub_rays = self.waveforms, self.pulses, self.sub_rays
        return kept

    def with_vertices(self) -> "Cloud":
        """Returns the same points and arrays with a vertex per point, and no other cells."""
        shown = vtkPolyData()
        shown.ShallowCopy(self.data)
        shown.SetVerts(_make_vertices(len(self)))
        return Cloud(shown, self.waveforms, self.pulses, self.sub_rays)

    def to_pandas(self):
        """Returns a pandas.DataFrame: x, y, z, and a column per array, which share the memory of
        the cloud.

        Arrays of three components are three columns: DirectionX, DirectionY, DirectionZ;
        Orientation has W, X, Y, Z. ``attrs`` has the units by column, and the field arrays, such as
        CRS. ImportError without pandas.
        """
        return to_pandas(self)

    def to_pyvista(self):
        """Returns a pyvista.PolyData with a vertex per point, all arrays and field arrays.

        Points and arrays of numbers share the memory of the cloud; field arrays of texts are copies.
        PyVista may have another VTK than vtkHelios. ImportError without PyVista.
        """
        return to_pyvista(self)

    def to_open3d(self):
        """Returns an open3d.t.geometry.PointCloud with positions (float64) and all arrays, n x
        components.

        Tensors share the memory of the cloud. Normals and RGB have Open3D's names, normals and
        colors; field arrays have no place. ``.to_legacy()`` makes an open3d.geometry.PointCloud.
        ImportError without Open3D.
        """
        return to_open3d(self)

    def write(self, path) -> None:
        """Writes a file; its ending selects the format: .las, .laz, .copc.laz, .xyz, .csv (text), .vtp,
        .pvtp (ParaView), .ply, .pcd or .e57, see Docs/files.md.

        What the format cannot hold is a warning. Raises FormatError (a ValueError), PipelineError
        and OSError.
        """
        write_cloud(self, path)

    def plant_area(self, **options):
        """Estimates the plant area density in the voxels of a grid, and returns a PlantArea.

        The cloud is best with its pulses, those that hit nothing too (``survey.run(pulses=True)``),
        and for partial hits with sub-rays (``hits=True``).

        voxel
            edge [m]. Default: 0.5.
        estimator
            contact-frequency, beer-lambert, beer-lambert-corrected, maximum-likelihood or
            maximum-likelihood-corrected, the default; formulas, sources and biases are in
            vtkHeliosPlantAreaDensity.
        leaf_angles
            spherical (default), uniform, planophile, erectophile, plagiophile, extremophile,
            ellipsoidal (of leaf_ratio, horizontal over vertical axis), horizontal, vertical; rows
            x y z G; or incidence: the angles of incidence of a simulation of triangles.
        leaf_size
            area of one side of a leaf [m2], for the standard error and the effective path.
        shares
            energy, equal or first: the shares of the echoes of a pulse, without sub-rays; or
            reflectance: by the array Reflectance [dB] over that of a leaf of leaf_reflectance (0.5).
        classes, materials
            what is counted, such as ``materials=["leaf"]``; all else ends beams. Default: all but
            ground, water and noise.
        bounds
            of the grid, six numbers [m]. Default: of the counted echoes.
        minimum_beams, maximum_range
            beams that a voxel needs to be seen (1), by their path, and where beams end [m].

        Raises ValueError for options outside their range, FormatError if nothing can be inverted.
        """
        return leafarea.estimate([leafarea.scan_of_cloud(self)], **options)

    def show(self, points=200_000, color_by=None, arrays=None, height=600, title="cloud"):
        """Returns the cloud as a page: in a notebook it is shown, ``.write("cloud.html")`` writes a
        file.

        points
            the most points of the page, a sample of all; the file of a notebook holds it.
        color_by
            the array of the first view: "Height", or a name. Default: the classes if there are
            several, else the colours, else the height.
        arrays
            the names of the arrays that the page has; None: all.
        height
            of the frame in the notebook [pixels].

        Raises FormatError (a ValueError) without points, and KeyError for an unknown array.
        """
        return webcloud.show(self, points, color_by, arrays, height, title)

    def __reduce__(self):
        """For pickle: the arrays, without a copy where the protocol has buffers."""
        packed = [pack(data) for data in (self.data, self.waveforms)]
        return _unpack, (*packed, self.pulses, self.sub_rays)

    def __sizeof__(self):
        """Returns the memory of all arrays [bytes]."""
        data = [item for item in (self.data, self.waveforms) if item is not None]
        clouds = [item for item in (self.pulses, self.sub_rays) if item is not None]
        return sum(1024 * item.GetActualMemorySize() for item in data) + sum(
            cloud.__sizeof__() for cloud in clouds
        )

    def __iter__(self) -> typing.Iterator[np.void]:
        """Yields the record of every point."""
        return iter(self.records)

    def __array__(self, dtype=None, copy=None) -> np.ndarray:
        """Returns the coordinates, n x 3: np.asarray(cloud) is cloud.points."""
        return self.points if dtype is None else self.points.astype(dtype, copy=False)

    def __add__(self, other: "Cloud") -> "Cloud":
        """Returns the points of both clouds, with all arrays of either: missing values are those of
        vtkhelios convert. A copy, without waveforms, pulses and sub-rays, whose ids may be the same.

        Raises ValueError for clouds with different coordinate systems.
        """
        if not isinstance(other, Cloud):
            return NotImplemented
        chunk, header = add_clouds([self, other])
        joined = Cloud.from_arrays(chunk.pop(COORDINATES), **chunk)
        joined.data.GetFieldData().ShallowCopy(header.fields)
        return joined

    def __radd__(self, other: int) -> "Cloud":
        """Returns the cloud itself, for sum()."""
        return self if isinstance(other, int) and other == 0 else NotImplemented

    if not typing.TYPE_CHECKING:  # else a type checker accepts any attribute

        def __getattr__(self, name):
            """Returns arrays by the names that laspy has for them."""
            if name.startswith("_") or "data" not in vars(self):
                raise no_attribute(self, name)
            found, component = self._find_alias(name)
            if found is None:
                raise no_attribute(self, name, explain_missing(name, self.names, dir(self)))
            return self[found] if component is None else self[found][:, component]

    def __setattr__(self, name, value):
        is_own = name in _ATTRIBUTES or hasattr(type(self), name)
        if name in ("x", "y", "z") or (not is_own and find_array(name, self.names)[0]):
            self[name] = value
        else:
            object.__setattr__(self, name, value)

    def __repr__(self):
        if not len(self):
            return "Cloud(no points)"
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        box = ", ".join(f"{a:.6g} to {b:.6g}" for a, b in zip(low, high))
        more = ", waveforms" if self.waveforms is not None else ""
        return f"Cloud({counted(len(self), 'point')}, {box} m; {', '.join(self.names) or 'no arrays'}{more})"

    def _repr_html_(self):
        rows = [
            f"<tr><td>{html.escape(name)}</td><td>{values.dtype}{_width(values)}</td>"
            f"<td>{_extent(values)}</td><td>{UNITS.get(name, 'm' if name == 'points' else '')}</td></tr>"
            for name, values in {"points": self.points, **arrays(self.data)}.items()
        ]
        head = "<tr><th>array</th><th>type</th><th>values</th><th>unit</th></tr>"
        return f"<b>Cloud</b>, {counted(len(self), 'point')}<table>{head}{''.join(rows)}</table>"


def read(path, waveforms: bool = False) -> Cloud:
    """Reads points as a Cloud: .las, .laz, .copc.laz, .xyz, .csv, .txt, .asc, .pts, .ptx, .vtp, .pvtp,
    .ply, .pcd, .e57, or the folder of a run, whose points have LegIds.

    waveforms
        True: also those in the file or beside it, as ``cloud.waveforms``.

    Surveys are read by read_survey(), meshes by Scene.read(). Raises FormatError (a ValueError) with
    the reason and the remedy.

    >>> cloud = vtkhelios.read("village.laz")
    """
    chunk, header = read_chunks(path)
    cloud = Cloud.from_arrays(chunk.pop(COORDINATES), **chunk)
    cloud.data.GetFieldData().ShallowCopy(header.fields)
    if waveforms:
        tables = read_tables(path)
        cloud.waveforms = tables[0] if len(tables) == 1 else join_tables(tables)
    return cloud


_ATTRIBUTES = ("data", "waveforms", "pulses", "sub_rays")


def _unpack(data, waveforms, pulses, sub_rays):
    return Cloud(unpack(data), unpack(waveforms), pulses, sub_rays)


class Records:
    """The columns of a cloud as a table whose rows are records, without a copy.

    ``records["Range"]`` is the array of the cloud itself, and so is x (a strided view of the
    points); writing to it writes to the cloud. ``records[7]`` and ``records[mask]`` are structured
    numpy arrays: copies, as rows are not contiguous in memory. numpy functions that need a
    structured array get a copy.
    """

    def __init__(self, columns):
        points = columns["points"]
        axes = {name: points[:, axis] for axis, name in enumerate("xyz")}
        rest = {name: values for name, values in columns.items() if name != "points"}
        self._columns = {**axes, **rest}
        self.dtype = np.dtype(
            [(name, values.dtype, values.shape[1:]) for name, values in self._columns.items()]
        )

    def __len__(self):
        return len(self._columns["x"])

    def __getitem__(self, key):
        if isinstance(key, str):
            return self._columns[key]
        if isinstance(key, slice):
            view = object.__new__(Records)
            view._columns = {name: values[key] for name, values in self._columns.items()}
            view.dtype = self.dtype
            return view
        rows = self._fill(self._columns, np.asarray(key))
        return rows if rows.ndim else rows[()]

    def __iter__(self):
        return (self[index] for index in range(len(self)))

    def __array__(self, dtype=None, copy=None):
        return self.to_structured() if dtype is None else self.to_structured().astype(dtype)

    def to_structured(self, names=None):
        """One structured array of all, or some, columns; a copy."""
        for name in names or ():
            if name not in self._columns:
                raise KeyError(f"there is no field {name}; it has: {', '.join(self._columns)}")
        chosen = {name: self._columns[name] for name in names or self._columns}
        return self._fill(chosen, slice(None))

    @staticmethod
    def _fill(columns, rows):
        taken = {name: values[rows] for name, values in columns.items()}
        kinds = [(name, columns[name].dtype, columns[name].shape[1:]) for name in columns]
        count = (
            np.shape(next(iter(taken.values())))[:1]
            if np.ndim(rows) or isinstance(rows, slice)
            else ()
        )
        table = np.empty(count, dtype=kinds)
        for name, values in taken.items():
            table[name] = values
        return table

    def __repr__(self):
        return f"Records({len(self):,} rows: {', '.join(self._columns)})"


def _make_vertices(count):
    """Returns a vertex cell per point, 8 bytes each (16 from 2^31 points on); the memory is VTK's
    own."""
    ids = vtkTypeInt32Array() if count < 2**31 - 1 else vtkTypeInt64Array()
    ids.SetNumberOfValues(count)
    vtk_to_numpy(ids)[:] = np.arange(count)
    cells = vtkCellArray()
    cells.SetData(1, ids)
    return cells


def _width(values):
    return f" x {values.shape[1]}" if values.ndim == 2 else ""


def _extent(values):
    return f"{values.min():.6g} to {values.max():.6g}" if values.size else ""
