# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scene, trajectory and waveform files: the C++ readers alone, and detect."""

import re
import struct

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios

from . import small_files
from .outcomes import check, check_count, check_fields, check_finite, check_polydata, plain_lines
from .target import Seed, Target, collect_warnings, command_line, pick, update


class Obj(Target):
    """OBJ: every triangle of its faces; fewer only if no area is lost."""

    name = "obj"

    def make_seeds(self, folder):
        beside = {"a.mtl": small_files.MATERIALS.encode()}
        many = "".join(f"v {i % 7} {i // 7} {0.1 * i:.2f}\n" for i in range(49))
        many += "".join(f"f {i + 1} {i + 2} {i + 9} {i + 8}\n" for i in range(41) if i % 7 != 6)
        return [
            Seed("plane.obj", small_files.PLANE.encode(), beside),
            Seed("grid.obj", many.encode(), beside),
        ]

    def run(self, path, data):
        reader = vtkhelios.vtkHeliosObjSceneReader()
        reader.SetFileName(str(path))
        scene, warned = update(reader)
        cells = check_polydata(scene)
        lines = plain_lines(data, (b"#",))
        if warned or lines is None or b"\\" in data:
            return
        rows = [line.split() for line in lines]
        expected = sum(len(words) - 3 for words in rows if words[0] == b"f")
        if cells < expected and get_area(scene) >= find_area(rows) * (1 - 1e-9):
            return  # corners at one place, or a spike
        check_count(cells, expected, warned, "triangles")


def get_area(scene):
    corners = vtk_to_numpy(scene.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = vtk_to_numpy(scene.GetPoints().GetData())[corners].swapaxes(0, 1)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def find_area(rows):
    """The sum of the faces' areas as Newell has them, at most the area of their triangles."""
    points = np.array([words[1:4] for words in rows if words[0] == b"v"], float)
    area = 0
    for words in rows:
        if words[0] == b"f":
            corners = [int(word.split(b"/")[0]) for word in words[1:]]
            places = points[[corner - (corner > 0) for corner in corners]]
            places = places - places[0]
            area += np.linalg.norm(np.cross(places, np.roll(places, -1, axis=0)).sum(axis=0)) / 2
    return area


class Mtl(Target):
    """MTL beside a good OBJ: reflectances between 0 and 1."""

    name = "mtl"

    def make_seeds(self, folder):
        return [
            Seed("a.mtl", small_files.MATERIALS.encode(), {"plane.obj": small_files.PLANE.encode()})
        ]

    def run(self, path, data):
        reader = vtkhelios.vtkHeliosObjSceneReader()
        reader.SetFileName(str(path.with_name("plane.obj")))
        scene, warned = update(reader)
        check_count(check_polydata(scene), 4, False, "triangles")
        check_materials(scene.GetFieldData())
        materials = vtkhelios.vtkHeliosMaterialReader()
        if hasattr(materials, "SetFileName"):
            materials.SetFileName(str(path))
            materials.SetInputData(scene)
            scene, warned = update(materials)
            check_materials(scene.GetFieldData())


def check_materials(fields):
    reflectance = fields.GetArray("Material.Reflectance")
    if reflectance is not None:
        values = vtk_to_numpy(reflectance)
        known = values[~np.isnan(values)]  # not set: by the spectrum, or the default
        check(((known >= 0) & (known <= 1)).all(), f"reflectances {values}")


class GeoTiff(Target):
    """GeoTIFF as a scene."""

    name = "geotiff"
    kind = "binary"

    def make_seeds(self, folder):
        heights = np.add.outer(np.arange(6.0), np.arange(5.0) * 0.5)
        return [
            Seed("float.tif", make_tiff(heights.astype("<f4"), 3)),
            Seed("short.tif", make_tiff(heights.astype("<i2"), 2)),
            Seed("tiled.tif", make_tiff(heights.astype("<f8"), 3)),
        ]

    def run(self, path, data):
        reader = vtkhelios.vtkHeliosGeoTiffSceneReader()
        reader.SetFileName(str(path))
        scene, warned = update(reader)
        check(check_polydata(scene) > 0 or warned, "no triangles, and no warning")


def make_tiff(rows, form):
    """A GeoTIFF of one strip, in EPSG:32632."""
    height, width = rows.shape
    pixels = rows.tobytes()
    doubles = struct.pack("<3d6d", 2.0, 2.0, 0.0, 0, 0, 0, 476000.0, 5473000.0, 0)
    keys = struct.pack("<16H", 1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 32632)
    count = 13
    more = 8 + 2 + 12 * count + 4
    at_doubles, at_keys = more, more + len(doubles)
    at_pixels = at_keys + len(keys)
    tags = [
        (256, 3, 1, width), (257, 3, 1, height), (258, 3, 1, 8 * rows.itemsize), (259, 3, 1, 1),
        (262, 3, 1, 1), (273, 4, 1, at_pixels), (277, 3, 1, 1), (278, 3, 1, height),
        (279, 4, 1, len(pixels)), (339, 3, 1, form), (33550, 12, 3, at_doubles),
        (33922, 12, 6, at_doubles + 24), (34735, 3, 16, at_keys),
    ]  # fmt: skip
    head = b"II" + struct.pack("<HIH", 42, 8, count)
    head += b"".join(struct.pack("<HHII", *tag) for tag in tags) + struct.pack("<I", 0)
    return head + doubles + keys + pixels


class Xyz(Target):
    """Points of scenes as text, plain and with normals and colours."""

    name = "xyz"

    def make_seeds(self, folder):
        return [
            Seed("plain.xyz", b"// a hedge\nx y z\n1 2 3\n4.5 -6e1 +7\n0.1\t0.2\t0.3 # lone\n\n9 8 7\n"),
            Seed("columns.xyz", b"1.5,2,3,0,0,1,255,128,0,leaf\n4, 5, 6, 0.6, 0.8, 0, 1, 2, 3,twig\n"
                 b'7,8,9,-1,0,0,0,0,0,\n1,1,1,0,0,1,9,9,9,"a, b" // end\n'),
        ]  # fmt: skip

    def run(self, path, data):
        reader = vtkhelios.vtkHeliosXyzReader()
        reader.SetFileName(str(path))
        columns = path.name == "columns.xyz"
        reader.SetSeparators("," if columns else " ")
        reader.SetReadNormals(columns)
        reader.SetReadColors(columns)
        cloud, warned = update(reader)
        check_polydata(cloud)
        lines = plain_lines(data)
        if lines is not None and not lines[0].strip()[:1].isalpha():
            check_count(cloud.GetNumberOfPoints(), len(lines), warned)


class Voxels(Target):
    """Voxel files."""

    name = "vox"

    def make_seeds(self, folder):
        return [Seed("crown.vox", small_files.CROWN.encode())]

    def run(self, path, data):
        reader = vtkhelios.vtkHeliosVoxelReader()
        reader.SetFileName(str(path))
        grid, _ = update(reader)
        check(grid.GetNumberOfCells() > 0, "no cells")
        check_finite("bounds", grid.GetBounds())
        check_finite("spacing", grid.GetSpacing())
        fields = grid.GetCellData()
        for index in range(fields.GetNumberOfArrays()):
            values = vtk_to_numpy(fields.GetArray(index))
            check(not np.isinf(values).any(), f"{fields.GetArrayName(index)} is infinite")


ROW = re.compile(rb"[-+.\d]\S*\s*[\s,]\s*[-+.\d]\S*")  # row of a spectrum, or meant to be one


class Spectrum(Target):
    """The spectrum of a material, and a survey run with it."""

    name = "spectrum"
    weight = 0.4

    def make_seeds(self, folder):
        return [Seed("wood.txt", small_files.SPECTRUM.encode(), survey_files(folder))]

    def run(self, path, data):
        (path.parent / "spectra").mkdir(exist_ok=True)
        (path.parent / "spectra/wood.txt").write_bytes(data)
        with collect_warnings() as warned:
            survey = vtkhelios.read_survey(path.with_name("survey.xml"), assets=path.parent)
            cloud = survey.run(noise=False)
        check_polydata(cloud.polydata)
        check_finite("amplitudes", cloud["Amplitude"])
        if not warned:
            lines = [line.strip(b" \t\r,") for line in data.split(b"\n")]
            rows = [ROW.fullmatch(line) is not None for line in filter(None, lines)]
            first = rows.index(True)
            check(all(rows[first:]), "a line among the rows is not used, and no warning")


def survey_files(folder):
    """A survey whose wall has the reflectance of its spectrum."""
    materials = small_files.MATERIALS.replace("helios_reflectance 0.3\n", "")
    small_files.write_survey(folder, small_files.STAND, small_files.SIMPLE_SCENE)
    (folder / "a.mtl").write_text(materials)
    files = small_files.files_below(folder)
    files.pop("wood.txt")
    files.pop("spectra/wood.txt")
    return files


class Trajectory(Target):
    """Trajectories: times in order, unit quaternions, every row."""

    name = "trajectory"

    def make_seeds(self, folder):
        return [
            Seed("path.csv", small_files.PATH.encode()),
            Seed("path.txt", b"0 0 0 90 1 2 3\n1 0.5 0 91 2 2 3 # a bend\n2 1 0 95 3 2.5 3\n"),
        ]

    def run(self, path, data):
        reader = vtkhelios.vtkHeliosTrajectoryReader()
        reader.SetFileName(str(path))
        reader.SetSeparators("," if path.suffix == ".csv" else " ")
        way, warned = update(reader)
        check_polydata(way)
        times = vtk_to_numpy(way.GetPointData().GetArray("GpsTime"))
        check((np.diff(times) >= 0).all(), "times decrease")
        turns = vtk_to_numpy(way.GetPointData().GetArray("Orientation"))
        check(
            np.allclose(np.linalg.norm(turns, axis=1), 1.0), "orientations are not unit quaternions"
        )
        lines = plain_lines(data)
        check_count(len(times), None if lines is None else len(lines), warned, "rows")


class Waveforms(Target):
    """Stored waveforms, by their reader and by detect."""

    def __init__(self, kind, by_detect):
        self.name = f"{'detect' if by_detect else 'waveforms'}-{kind}"
        self.form = kind
        self.by_detect = by_detect
        self.kind = {"txt": "text", "vtt": "mixed", "pvtt": "xml"}[kind]
        self.weight = 0.6 if by_detect else 1.0

    def make_seeds(self, folder):
        form = "xyz" if self.form == "txt" else "vtp"
        survey = small_files.STAND.replace('headRotateStop_deg="1"', 'headRotateStop_deg="-0.9"')
        run = small_files.run_survey(
            folder, survey, "--format", form, "--waveforms", "--pulses-per-block", "15",
            scene=small_files.SIMPLE_SCENE,
        )  # fmt: skip
        files = {path.name: path.read_bytes() for path in sorted(run.glob("leg000_fullwave*"))}
        name = sorted(name for name in files if name.endswith(f".{self.form}"))[0]
        data = files.pop(name)
        return [Seed(name, data, files if self.form == "pvtt" else {})]

    def run(self, path, data):
        if self.by_detect:
            output = path.with_name(pick(data, ["echoes.xyz", "echoes.pvtp"]))
            detector = pick(data, ["peak", "gaussian", "cfd", "leadingEdge", "photonCounting"])
            command_line("detect", path, "-o", output, "--detector", detector,
                         "--pulse-length", "5", "--threads", "1")  # fmt: skip
            from .targets_points import read_points

            check(read_points(output)[0] > 0, "no echoes")
            return
        if self.form == "txt":
            reader = vtkhelios.vtkHeliosWaveformTextReader()
        else:
            reader = vtkhelios.vtkHeliosWaveformXMLReader()
        reader.SetFileName(str(path))
        table, warned = update(reader)
        rows = check_waveforms(table)
        lines = plain_lines(data) if self.form == "txt" else None
        check_count(rows, None if lines is None else len(lines), warned, "waveforms")


def check_waveforms(table):
    """Columns finite and of equal length, samples of every row present. Returns the rows."""
    rows = table.GetNumberOfRows()
    check_fields(table.GetRowData(), rows)
    if rows:
        samples = table.GetFieldData().GetArray("Samples")
        check(samples is not None, "no samples")
        check_finite("Samples", vtk_to_numpy(samples))
        offsets, counts = (
            vtk_to_numpy(table.GetRowData().GetArray(name)) for name in ("Offset", "Count")
        )
        check((offsets >= 0).all() and (counts >= 0).all(), "offsets or counts below 0")
        last = (offsets + counts).max()
        check(last <= samples.GetNumberOfTuples(), "samples beyond the end")
        bins = vtk_to_numpy(table.GetRowData().GetArray("BinSize"))
        check((bins > 0).all(), "bins of width 0")
    return rows


def make_targets():
    return [
        Obj(), Mtl(), GeoTiff(), Xyz(), Voxels(), Spectrum(), Trajectory(),
        *[Waveforms(kind, by_detect) for kind in ("txt", "vtt", "pvtt") for by_detect in (False, True)],
    ]  # fmt: skip
