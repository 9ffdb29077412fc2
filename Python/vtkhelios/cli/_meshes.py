# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as input of vtkhelios info and vtkhelios convert."""

import pathlib

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios

from ..array_names import (
    CRS, MATERIAL_CLASSIFICATION, MATERIAL_IDS, MATERIAL_IS_GROUND, MATERIAL_NAME,
    MATERIAL_REFLECTANCE, MATERIAL_TEXTURE, NOTES, PART_IDS, PART_NAME,
)  # fmt: skip
from ..core.paths import text_from_vtk, to_vtk
from ..core.pipeline import MessageLog
from ..core.run_files import PART
from ..core.systems import HEIGHT_UNITS, find_system
from ..core.unfinished import set_unfinished
from ..core.words import counted
from ..formats import FormatError
from ..reports.raster import FARTHEST
from ..scenes.scene import make_reader
from ._stopping import run_native, set_outcome

SHOWN_PARTS = 10
KINDS = {
    "objloader": "OBJ", "geotiffloader": "GeoTIFF", "plyloader": "PLY", "stlloader": "STL",
    "cityjsonloader": "CityJSON", "gltfloader": "glTF",
}  # fmt: skip


def is_mesh(path):
    """Returns whether a file is a mesh: PLY files without faces are clouds."""
    return vtkhelios.vtkHeliosDialect.IsMesh(to_vtk(path))


def read(path, messages):
    """Returns the triangles of a file, or None after an error."""
    reader = make_reader(path)
    messages.watch(reader)
    run_native(reader)
    mesh = reader.GetOutput()
    if mesh.GetPoints() is not None:
        return mesh
    messages.error_unless_told(f"{path}: cannot be read")
    return None


def read_colored(path, messages):
    """Returns the triangles of a file with its colours, or without if only these have an error: a
    warning."""
    reader = make_reader(path)
    if not hasattr(reader, "SetReadColors"):
        return read(path, messages)
    reader.SetReadColors(True)
    with MessageLog() as log:
        log.watch(reader)
        reader.Update()
    if not log.errors:
        for warning in log.warnings:
            messages.warning(warning)
        return reader.GetOutput()
    mesh = read(path, messages)
    for error in log.root_errors() if mesh else ():
        messages.warning(f"{error}; only a run with --colors reads it")
    return mesh


def describe_textures(mesh, messages):
    """File and size of each texture of a mesh; a warning of those that cannot be read."""
    column = mesh.GetFieldData().GetAbstractArray(MATERIAL_TEXTURE)
    rows = range(column.GetNumberOfValues()) if column else ()
    for path in dict.fromkeys(column.GetValue(row) for row in rows):
        if not path:
            continue
        reader = vtkhelios.vtkHeliosImageReader()
        reader.SetFileName(path)
        with MessageLog() as log:
            log.watch(reader)
            reader.Update()
        for message in log.root_errors() + log.warnings:
            messages.warning(f"texture {message}")
        if not log.errors:
            width, height, _ = reader.GetOutput().GetDimensions()
            yield {"file": text_from_vtk(path), "width": width, "height": height}


def inspect(path, messages):
    """Facts about a mesh, or None after an error."""
    mesh = read_colored(path, messages)
    if mesh is None:
        return None
    kind = KINDS[vtkhelios.vtkHeliosDialect.FindLoader(to_vtk(path))]
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    areas = compute_areas(mesh, points)
    facts = {
        "file": str(path),
        "format": f"mesh ({kind})",
        "triangles": len(areas),
        "vertices": len(points),
    }
    if len(points):
        low, high = points.min(axis=0), points.max(axis=0)
        facts["bounds"] = {"minimum": low.tolist(), "maximum": high.tolist()}
    facts["crs"] = find_crs(mesh)
    facts["area_m2"] = float(areas.sum())
    facts["materials"] = list(describe_materials(mesh, areas))
    facts["parts"] = list(describe_parts(mesh, areas))
    facts["textures"] = list(describe_textures(mesh, messages))
    facts["cutouts"] = list_notes(mesh)
    return facts


def list_notes(mesh):
    """Returns what readers cut out of the triangles of a mesh, or of a scene's parts, in words."""
    column = mesh.GetFieldData().GetAbstractArray(NOTES)
    rows = range(column.GetNumberOfValues()) if column else ()
    return list(dict.fromkeys(column.GetValue(row) for row in rows))


def find_crs(mesh):
    array = mesh.GetFieldData().GetAbstractArray(CRS)
    return text_from_vtk(array.GetValue(0)) if array and array.GetNumberOfValues() else None


def bounds_lines(facts):
    """Bounds to the millimetre, of longitude and latitude to 1e-8 degrees."""
    system = find_system(facts["crs"] or "")
    units = (system.unit, system.unit, facts.get("heightUnit_m", system.height_unit))
    for axis, unit, low, high in zip("xyz", units, *facts["bounds"].values()):
        digits = 3 if unit else 8
        yield f"{axis:10} {_fixed(low, digits)} to {_fixed(high, digits)} {name_unit(unit)}"


def name_unit(metres):
    """Returns the name of a unit in metres; degrees are 0."""
    for name, size in {"deg": 0.0, **HEIGHT_UNITS}.items():
        if abs(metres - size) <= 1e-9 * size:
            return name
    return f"x {metres:g} m"


def _fixed(value, digits):
    return f"{value:.{digits}f}" if abs(value) <= FARTHEST else f"{value:g}"


def describe_crs(crs):
    """Code and name of a coordinate system; of one that PROJ does not know, the begin of its text."""
    if not crs:
        return "not known"
    return find_system(crs).name or " ".join(crs.split())[:100]


def compute_areas(mesh, points):
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[corners[:, i]] for i in range(3))
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)


def describe_materials(mesh, areas):
    """Describes each material that a triangle has."""
    columns = mesh.GetFieldData()
    names = columns.GetAbstractArray(MATERIAL_NAME)
    values = {
        key: vtk_to_numpy(columns.GetArray(name))
        for key, name in (
            ("reflectance", MATERIAL_REFLECTANCE),
            ("class", MATERIAL_CLASSIFICATION),
            ("ground", MATERIAL_IS_GROUND),
        )
    }
    ids = vtk_to_numpy(mesh.GetCellData().GetArray(MATERIAL_IDS))
    counts = np.bincount(ids, minlength=names.GetNumberOfValues())
    sums = np.bincount(ids, areas, minlength=names.GetNumberOfValues())
    for row in np.flatnonzero(counts):
        yield {
            "name": text_from_vtk(names.GetValue(int(row))),
            "triangles": int(counts[row]),
            "area_m2": float(sums[row]),
            "reflectance": _none_if_nan(values["reflectance"][row]),
            "class": int(values["class"][row]),
            "ground": bool(values["ground"][row]),
        }


def describe_parts(mesh, areas):
    """Describes each object of a file that has objects."""
    names = mesh.GetFieldData().GetAbstractArray(PART_NAME)
    ids = mesh.GetCellData().GetArray(PART_IDS)
    if names is None or ids is None:
        return
    ids = vtk_to_numpy(ids)
    counts = np.bincount(ids, minlength=names.GetNumberOfValues())
    sums = np.bincount(ids, areas, minlength=names.GetNumberOfValues())
    for row in np.flatnonzero(counts):
        yield {
            "id": int(row),
            "name": text_from_vtk(names.GetValue(int(row))),
            "triangles": int(counts[row]),
            "area_m2": float(sums[row]),
        }


def describe_lines(facts):
    """Yields the facts as text."""
    yield f"format     {facts['format']}"
    yield f"triangles  {facts['triangles']:,}, with {facts['vertices']:,} vertices"
    if "bounds" in facts:
        yield from bounds_lines(facts)
    yield f"crs        {describe_crs(facts['crs'])}"
    yield f"area       {facts['area_m2']:,.6g} m²"
    for each in facts["materials"]:
        reflectance = each["reflectance"]
        yield (
            f"material   {each['name']}: {counted(each['triangles'], 'triangle')}, {each['area_m2']:,.6g} m², "
            + ("" if reflectance is None else f"reflectance {reflectance:g}, ")
            + f"class {each['class']}"
            + (", ground" if each["ground"] else "")
        )
    if facts["parts"]:
        yield f"parts      {len(facts['parts']):,}"
    for each in facts["parts"][:SHOWN_PARTS]:
        yield f"part       {each['name']}: {counted(each['triangles'], 'triangle')}, {each['area_m2']:,.6g} m²"
    if len(facts["parts"]) > SHOWN_PARTS:
        yield f"           and {len(facts['parts']) - SHOWN_PARTS:,} more; --json lists all"
    for each in facts["textures"]:
        yield f"texture    {each['file']}: {each['width']} x {each['height']} pixels"
    for text in facts["cutouts"]:
        yield f"cut out    {text}"


def _none_if_nan(value):
    """Returns None for materials without a reflectance of their own."""
    return None if np.isnan(value) else float(value)


def convert(arguments, messages):
    """Writes a mesh as OBJ; 0, or 1 after an error."""
    path = check_arguments(arguments)
    set_outcome(f"{arguments.output} was not written")
    mesh = read(path, messages)
    if mesh is None:
        return 1
    if crs := find_crs(mesh):
        messages.warning(f"{path}: its coordinate system {crs} is dropped: OBJ has none")
    if names := mesh.GetFieldData().GetAbstractArray(PART_NAME):
        count = names.GetNumberOfValues()
        messages.warning(
            f"{path}: the names of its {counted(count, 'part')} are dropped: OBJ has none"
        )
    writer = vtkhelios.vtkHeliosObjSceneWriter(file_name=to_vtk(arguments.output))
    writer.SetInputDataObject(mesh)
    messages.watch(writer)
    parts = [f"{path}{PART}" for path in (arguments.output, material_file(arguments.output))]
    for part in parts:
        set_unfinished(part)
    if not writer.Write():
        messages.error_unless_told(f"{arguments.output}: cannot be written")
        return 1
    for part in parts:
        set_unfinished(part, False)
    set_outcome(f"{arguments.output} is written")
    messages.info(f"output   {arguments.output}: {counted(mesh.GetNumberOfPolys(), 'triangle')}")
    return 0


def material_file(output):
    """Returns the file of materials that belongs to an OBJ file."""
    return pathlib.Path(output).with_suffix(".mtl")


def check_arguments(arguments):
    """Returns the mesh to convert; FormatError without one, or with an option for points."""
    output = pathlib.Path(arguments.output)
    for path in arguments.inputs:
        if not pathlib.Path(path).exists():
            raise FormatError(f"{path}: no such file or folder; check its name")
    if len(arguments.inputs) != 1 or not is_mesh(arguments.inputs[0]):
        known = vtkhelios.vtkHeliosDialect.GetMeshEndings()
        raise FormatError(f"{output}: OBJ is written of one mesh ({known}); give one as input")
    path = arguments.inputs[0]
    for option, value, default in (
        ("--format", arguments.format, None), ("--merge", arguments.merge, False),
        ("--crs", arguments.crs, None), ("--returns", arguments.returns, "all"),
        ("--class", arguments.classes, None), ("--every", arguments.every, 1),
        ("--skip-invalid", arguments.skip_invalid, False),
        ("--waveforms", arguments.waveforms, None),
    ):  # fmt: skip
        if value != default:
            raise FormatError(f"{path}: {option} is for points, and this is a mesh; leave it out")
    for written in (output, material_file(output)):
        if written.exists() and written.resolve() == pathlib.Path(path).resolve():
            raise FormatError(f"{written}: is also an input; give another name")
        if written.exists() and not arguments.overwrite:
            raise FormatError(f"{written}: already exists; give --overwrite to replace it")
    return path
