# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes from arrays.

>>> scene = vtkhelios.Scene(points, triangles, reflectance=0.4)
"""

import csv
import html
import io
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkIdTypeArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ..array_names import (
    MATERIAL_ATTENUATION, MATERIAL_BACKSCATTER, MATERIAL_CLASSIFICATION, MATERIAL_DISPERSION,
    MATERIAL_IDS, MATERIAL_IS_GROUND, MATERIAL_MEAN_SQUARE_SLOPE, MATERIAL_MIRROR_REFLECTANCE,
    MATERIAL_NAME, MATERIAL_OPTICS, MATERIAL_REFLECTANCE, MATERIAL_REFRACTIVE_INDEX,
    MATERIAL_RETROREFLECTION, MATERIAL_SPECTRUM, MATERIAL_SPECULAR_EXPONENT, MATERIAL_SPECULARITY,
    MATERIAL_THICKNESS, MATERIAL_TRANSMITTANCE,
)  # fmt: skip
from ..core.arrays import numpy_to_vtk
from ..core.classes import vtk_class
from ..core.paths import to_vtk
from ..core.pipeline import MessageLog, conclude, update
from ..core.views import data_of
from ..core.words import counted
from ..exchange._clouds import scene_to_pyvista
from ..exchange._polydata import read_polydata, triangulate

__all__ = ["Scene", "add_parts", "count_triangles", "flatten", "has_instances"]

_READERS = {
    "objloader": "vtkHeliosObjSceneReader",
    "geotiffloader": "vtkHeliosGeoTiffSceneReader",
    "plyloader": "vtkHeliosPLYSceneReader",
    "stlloader": "vtkHeliosSTLSceneReader",
    "cityjsonloader": "vtkHeliosCityJSONReader",
    "gltfloader": "vtkHeliosGLTFSceneReader",
}

_OPTICS = {"mirror": 1, "pane": 2, "volume": 3, "water": 4, "leaf": 5, "retroreflector": 6}
_OPTICS_NUMBERS = {  # column, lowest and highest value
    "mirror_reflectance": (MATERIAL_MIRROR_REFLECTANCE, 0, 1),
    "refractive_index": (MATERIAL_REFRACTIVE_INDEX, 1, 4),
    "thickness": (MATERIAL_THICKNESS, 0, 10),
    "attenuation": (MATERIAL_ATTENUATION, 0, 1e6),
    "backscatter": (MATERIAL_BACKSCATTER, 0, 1e6),
    "transmittance": (MATERIAL_TRANSMITTANCE, 0, 1),
    "retroreflection": (MATERIAL_RETROREFLECTION, 0, 1e9),
    "mean_square_slope": (MATERIAL_MEAN_SQUARE_SLOPE, 0, 1),
}

DISPERSIONS = {"water": 1, "sodaLime": 2, "bk7": 3, "silica": 4}


class Scene:
    """Triangles to scan: ``scene.polydata`` is a vtkPolyData with materials, ready for a pipeline.

    points
        the vertices [m], n x 3; or the name of a file, see read(); or a vtkPolyData of triangles, used
        unchanged, or an algorithm that makes one. A vtkHeliosScene keeps its instances: they have no points and triangles of their
        own, but count and have a box.
        Or a mesh of another library: pyvista.PolyData or MultiBlock, trimesh.Trimesh or Scene,
        a TriangleMesh of Open3D, meshio.Mesh, a vtkPolyData of another VTK, or any object with
        points (or vertices) and faces (or triangles). Polygons are triangulated; arrays,
        colours (RGB), MaterialIds with their names, and PartIds of several meshes are kept; double
        points are shared.
    triangles
        three vertex indices each, m x 3; the scanner ignores their order.
    reflectance
        [0, 1], one value, or one per triangle (of a mesh of polygons: per polygon). Default: 0.5.
    ground
        whether tripods may be placed on the triangles: a boolean, or one
        per triangle (polygon). Without any ground everything is ground.
    optics
        what the triangles do with the light that they do not scatter: "mirror", "pane", "volume",
        "water", "leaf" or "retroreflector" (Docs/materials.md), or a dictionary with that as kind and its numbers, {"kind":
        "pane", "refractive_index": 1.52, "thickness": 0.006}; also mirror_reflectance, attenuation
        [1/m], backscatter [1/(m sr)], transmittance, retroreflection [1/sr] and mean_square_slope.
        Default: None, nothing; the default reflectance of others is 0.
    """

    def __init__(self, points, triangles=None, reflectance=None, ground=False, optics=None):
        faces = None
        if triangles is None:
            self.polydata, faces = _read_mesh(points)
            if reflectance is None and ground is False and optics is None:
                return
            _check_no_instances(self.polydata, "reflectance, ground and optics")
            count = self.polydata.GetNumberOfCells()
        else:
            self.polydata = _make_mesh(points, triangles)
            count = len(triangles)
        if reflectance is None:
            reflectance = 0.5 if optics is None else 0.0
        _add_materials(self.polydata, count, reflectance, ground, faces)
        if optics is not None:
            _add_optics(self.polydata, optics)

    @property
    def points(self) -> np.ndarray:
        """The vertices [m], n x 3, without a copy; call modified() after changes in place."""
        _check_no_instances(self.polydata, "points")
        return vtk_to_numpy(self.polydata.GetPoints().GetData())

    @property
    def triangles(self) -> np.ndarray:
        """The indices of vertices, m x 3, without a copy."""
        _check_no_instances(self.polydata, "triangles")
        return vtk_to_numpy(self.polydata.GetPolys().GetConnectivityArray()).reshape(-1, 3)

    @property
    def bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """The box: (lowest x, y, z), (highest x, y, z) [m]."""
        if not has_instances(self.polydata):
            return self.points.min(axis=0), self.points.max(axis=0)
        box, flattener = [0.0] * 6, vtk_class("vtkHeliosSceneFlatten")()
        with MessageLog() as log:
            log.watch(flattener)
            flattener.ComputeBounds(self.polydata, box)
        conclude(log)
        return np.array(box[::2]), np.array(box[1::2])

    def __len__(self) -> int:
        return count_triangles(self.polydata)

    def __add__(self, other) -> "Scene":
        """Merges both scenes."""
        composer = vtk_class("vtkHeliosSceneComposer")()
        composer.AddInputDataObject(0, self.polydata)
        composer.AddInputDataObject(0, Scene(other).polydata)
        joined = vtkPolyData()
        joined.ShallowCopy(update(composer))
        return Scene(joined)

    def write(self, path) -> None:
        """Writes an OBJ file and its materials, which read back as the same scene.

        Instances are written as copies.
        """
        writer = vtk_class("vtkHeliosObjSceneWriter")()
        writer.SetFileName(to_vtk(path))
        writer.SetInputDataObject(flatten(self.polydata))
        with MessageLog() as log:
            log.watch(writer)
            succeeded = writer.Write()
        conclude(log)
        if not succeeded:
            raise OSError(f"{path} cannot be written; is its folder there?")

    def to_pyvista(self):
        """Returns the triangles as a pyvista.PolyData with their cell and field arrays; instances
        are copies.

        It shares vertices and arrays where PyVista can, also if PyVista has another VTK.
        """
        return scene_to_pyvista(flatten(self.polydata))

    @classmethod
    def read(cls, path, **properties) -> "Scene":
        """Reads a mesh: .obj, .tif, .ply, .stl, .gltf, .glb, .json or .jsonl (CityJSON).

        Properties belong to the reader of the file, such as vtkHeliosCityJSONReader:

        >>> city = vtkhelios.Scene.read("delft.city.json", level_of_detail="2.2")
        """
        mesh = vtkPolyData()
        mesh.ShallowCopy(update(make_reader(path, **properties)))
        return cls(mesh)

    def modified(self) -> None:
        """Tells pipelines that vertices were changed in place."""
        self.polydata.GetPoints().Modified()

    def __repr__(self):
        if not len(self):
            return "Scene(no triangles)"
        low, high = self.bounds
        box = ", ".join(f"{a:.6g} to {b:.6g}" for a, b in zip(low, high))
        return f"Scene({counted(len(self), 'triangle')}, {box} m)"

    def _repr_html_(self):
        fields = self.polydata.GetFieldData()
        names, values = map(
            fields.GetAbstractArray, (MATERIAL_NAME, MATERIAL_REFLECTANCE)
        )  # None: no materials
        count = names.GetNumberOfValues() if names else 0
        rows = [
            f"<tr><td>{html.escape(names.GetValue(i))}</td>"
            f"<td>{'' if values is None else _fraction(values.GetValue(i))}</td></tr>"
            for i in range(min(count, SHOWN))
        ]
        more = f"<tr><td>and {counted(count - SHOWN, 'more')}</td></tr>" if count > SHOWN else ""
        table = (
            f"<table><tr><th>material</th><th>reflectance</th></tr>{''.join(rows)}{more}</table>"
        )
        return html.escape(repr(self)) + (table if count else "")


SHOWN = 20  # materials in a notebook


def _fraction(value):
    return "of its spectrum" if value != value else f"{value:g}"


def has_instances(polydata):
    """Returns whether a vtkPolyData is a vtkHeliosScene with instances."""
    return bool(vtk_class("vtkHeliosScene").HasInstances(polydata))


def count_triangles(polydata):
    """Returns the triangles of a scene; an instance's count as often as it stands."""
    is_scene = has_instances(polydata)
    return polydata.GetNumberOfTriangles() if is_scene else polydata.GetNumberOfCells()


def flatten(polydata):
    """Returns a scene as one mesh, with copies of its instances; PipelineError if there are too
    many."""
    if not has_instances(polydata):
        return polydata
    algorithm = vtk_class("vtkHeliosSceneFlatten")()
    algorithm.SetInputDataObject(polydata)
    mesh = vtkPolyData()
    mesh.ShallowCopy(update(algorithm))
    return mesh


def _check_no_instances(polydata, what):
    if has_instances(polydata):
        raise ValueError(
            f"the scene has {polydata.GetNumberOfInstances():,} instances, and {what} are of one mesh; "
            "make it of vtkHeliosSceneFlatten, or use its prototypes and instances"
        )


def make_reader(path, **properties):
    """Returns the reader of a mesh, by the ending of its name; ValueError if it is none."""
    dialect = vtk_class("vtkHeliosDialect")
    reader = _READERS.get(dialect.FindLoader(to_vtk(path)))
    if reader is None:
        raise ValueError(
            f"{path}: is not a mesh of a known format; known: {dialect.GetMeshEndings()}"
        )
    return vtk_class(reader)(file_name=to_vtk(path), **properties)


def _read_mesh(source):
    """Returns a source as (vtkPolyData of triangles, polygon of each triangle or None: they are the
    same)."""
    data = make_reader(source) if isinstance(source, (str, os.PathLike)) else data_of(source)
    if hasattr(data, "GetOutputPort"):
        data = update(data)
    if isinstance(data, vtkPolyData):
        return (
            (data, None)
            if has_instances(data) or not data.GetNumberOfPolys() + data.GetNumberOfStrips()
            else triangulate(data)
        )
    made = read_polydata(data)
    if made is None:
        kind = type(source).__name__
        raise TypeError(
            "a Scene is made of points and triangles, of a vtkPolyData, or of a mesh with points and "
            f"faces, not of {kind}"
        )
    return made


def _make_mesh(points, triangles):
    points = np.ascontiguousarray(points, dtype=np.float64)
    triangles = np.asarray(triangles)
    for name, array in (("points", points), ("triangles", triangles)):
        if array.ndim != 2 or array.shape[1] != 3:
            raise ValueError(f"{name} has the shape {array.shape}; give an array of (n, 3)")
    if triangles.dtype.kind not in "iu":
        raise TypeError(f"triangles is of {triangles.dtype}; give whole numbers, indices of points")
    if not np.isfinite(points).all():
        raise ValueError("points has NaN or infinity; give finite coordinates")
    if triangles.size and not 0 <= triangles.min() <= triangles.max() < len(points):
        raise ValueError(
            f"triangles has indices from {triangles.min()} to {triangles.max()}; "
            f"the points are 0 to {len(points) - 1}"
        )
    mesh, holder, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    holder.SetDataType(VTK_DOUBLE)
    holder.SetData(numpy_to_vtk(points))
    mesh.SetPoints(holder)
    corners = np.ascontiguousarray(triangles, dtype=np.int64).reshape(-1)
    offsets = np.arange(0, len(corners) + 1, 3, dtype=np.int64)
    id_type = vtkIdTypeArray().GetDataType()
    # Copies: the cells use the memory of these arrays, without a reference.
    cells.SetData(numpy_to_vtk(offsets, 1, id_type), numpy_to_vtk(corners, 1, id_type))
    mesh.SetPolys(cells)
    return mesh


def _add_materials(mesh, count, reflectance, ground, faces=None):
    """Adds a material for every distinct pair of reflectance and ground; faces: see _for_each()."""
    reflectance = _for_each("reflectance", reflectance, count, faces)
    if reflectance.size and not (reflectance.min() >= 0 and reflectance.max() <= 1):
        worst = reflectance[~((reflectance >= 0) & (reflectance <= 1))][0]
        raise ValueError(f"reflectance is {worst:g}; its valid range is [0, 1]")
    ground = _for_each("ground", ground, count, faces)
    pairs, ids = np.unique(np.stack([reflectance, ground]), axis=1, return_inverse=True)
    names, spectra = vtkStringArray(), vtkStringArray()
    for index in range(pairs.shape[1]):
        names.InsertNextValue(f"material{index}")
        spectra.InsertNextValue("")
    is_ground = pairs[1].astype(np.int32)
    columns = {
        MATERIAL_NAME: names,
        MATERIAL_REFLECTANCE: numpy_to_vtk(pairs[0], deep=1),
        MATERIAL_SPECULARITY: numpy_to_vtk(0.0 * pairs[0], deep=1),
        MATERIAL_SPECULAR_EXPONENT: numpy_to_vtk(0.0 * pairs[0] + 10, deep=1),
        MATERIAL_CLASSIFICATION: numpy_to_vtk(2 * is_ground, deep=1),
        MATERIAL_IS_GROUND: numpy_to_vtk(is_ground, deep=1),
        MATERIAL_SPECTRUM: spectra,
    }
    for name, column in columns.items():
        column.SetName(name)
        mesh.GetFieldData().AddArray(column)
    material_ids = numpy_to_vtk(ids.reshape(-1).astype(np.int32), deep=1)
    material_ids.SetName(MATERIAL_IDS)
    mesh.GetCellData().AddArray(material_ids)


def _add_optics(mesh, optics):
    """Gives all materials of a mesh the same optics."""
    given = {"kind": optics} if isinstance(optics, str) else dict(optics)
    kind = given.pop("kind", None)
    medium = given.pop("dispersion", None)
    if kind not in _OPTICS:
        raise ValueError(f"optics is {kind!r}; give one of: {', '.join(_OPTICS)}")
    if medium is not None and medium not in DISPERSIONS:
        raise ValueError(f"dispersion is {medium!r}; give one of: {', '.join(DISPERSIONS)}")
    if unknown := set(given) - set(_OPTICS_NUMBERS):
        known = ", ".join(_OPTICS_NUMBERS)
        raise ValueError(f"optics has {sorted(unknown)[0]!r}; known: kind, {known}")
    fields = mesh.GetFieldData()
    count = fields.GetAbstractArray(MATERIAL_NAME).GetNumberOfValues()
    columns = {MATERIAL_OPTICS: np.full(count, _OPTICS[kind], np.int32)}
    if medium is not None:
        columns[MATERIAL_DISPERSION] = np.full(count, DISPERSIONS[medium], np.int32)
    for name, number in given.items():
        column, low, high = _OPTICS_NUMBERS[name]
        if not low <= number <= high:
            raise ValueError(f"{name} is {number!r}; its valid range is [{low:g}, {high:g}]")
        columns[column] = np.full(count, float(number))
    for name, values in columns.items():
        column = numpy_to_vtk(values, deep=1)
        column.SetName(name)
        fields.AddArray(column)


def _for_each(name, values, count, faces=None):
    """Returns a value for each of count triangles; values are one, or one for each of the faces
    that they are of."""
    values = np.asarray(values, dtype=np.float64)
    if values.ndim == 0:
        return np.full(count, values)
    wanted = count if faces is None else int(faces.max(initial=-1)) + 1
    if values.shape != (wanted,):
        raise ValueError(
            f"{name} has the shape {values.shape}; give one number, or {wanted} of them"
        )
    return values if faces is None else values[faces]


def add_parts(survey, table, models, seed, yaw, scale):
    """Adds a table of parts to a vtkHeliosSurvey; returns whether that succeeded.

    table
        a row for each part: the name of a CSV file, or its columns, a dictionary, a structured
        array or a data frame. Columns are x and y [m], and optionally model, z [m] (NaN: on the
        ground), yaw_deg, scale, id, classification, species and tree; others of a file are not
        used.
    models
        a dictionary of what rows place: by the names in the column model, the OBJ file of each, or
        a dictionary of attributes of <model>, such as {"objloader/filepath": "oak.obj", "share":
        3}. Rows without a model have one of them at random.
    seed
        of all random values.
    yaw, scale
        the ranges of random rotations about the vertical [deg] and factors, of rows without.
    """
    is_file = isinstance(table, (str, os.PathLike))
    index = survey.AddPartTable(to_vtk(table) if is_file else "")
    if index < 0:
        return False
    values = {"seed": seed, "yawMin_deg": yaw[0], "yawMax_deg": yaw[1]}
    values.update({"scaleMin": scale[0], "scaleMax": scale[1]})
    for number, (name, model) in enumerate(models.items()):
        given = {"objloader/filepath": model} if not hasattr(model, "items") else model
        values[f"model[{number}]/id"] = name
        values.update({f"model[{number}]/{key}": value for key, value in given.items()})
    for name, value in values.items():
        if not survey.SetPartTableAttribute(index, name, to_vtk(str(value))):
            return False
    if not is_file:
        survey.SetPartTableRows(index, to_vtk(_table_text(table)))
    return survey.Check()


def _table_text(table):
    """Returns the columns as the text of a CSV file; None and NaN are empty."""
    names = getattr(getattr(table, "dtype", None), "names", None) or list(table)
    columns = {name: np.asarray(table[name]).reshape(-1).tolist() for name in names}
    lengths = {name: len(column) for name, column in columns.items()}
    if len(set(lengths.values())) > 1:
        raise ValueError(f"the columns have different lengths: {lengths}; give one value per row")
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    for row in zip(*columns.values()):
        writer.writerow("" if cell is None or cell != cell else cell for cell in row)
    return text.getvalue()
