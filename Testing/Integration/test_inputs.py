# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every file that a run opens is one of its inputs: one that changes is named wherever runs meet."""

import hashlib
import importlib.util
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import zipfile

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.cluster import _tasks

gdal = pytest.importorskip("osgeo.gdal")
gdal.UseExceptions()

SURVEY = """\
<document><!-- byte: 0 -->
<survey name="all" scene="scene.xml#all" platform="interpolated" basePlatform="platform.xml#own"
  scanner="scanner.xml#own"><leg><platformSettings trajectory="flight.txt"/>
<scannerSettings scanFreq_hz="10"/></leg></survey></document>
"""
PLATFORM = """\
<document><!-- byte: 0 --><platform id="own" type="linearpath"><scannerMount/></platform></document>
"""
SCANNER = """\
<document><!-- byte: 0 --><scanner id="own" optics="spinning" pulseFreqs_Hz="20000" rangeMin_m="0.1"
  wavelength_nm="905"><FWFSettings pulseShape="pulse.csv"/><beams file="beams.csv"/></scanner></document>
"""
SCENE = """\
<document><!-- byte: 0 --><scene id="all">
{}
<partTable file="stand.csv"><model id="pole">
<filter type="objloader"><param key="filepath" value="pole.obj"/></filter></model></partTable>
</scene></document>
"""
LOADERS = [
    ("objloader", dict(filepath="ground.obj")),
    ("objloader", dict(filepath="wall.obj")),
    ("plyloader", dict(filepath="mesh.ply")),
    ("stlloader", dict(filepath="mesh.stl")),
    ("cityjsonloader", dict(filepath="town.city.json")),
    ("gltfloader", dict(filepath="mesh.gltf")),
    ("geotiffloader", dict(filepath="all.vrt")),
    ("xyzloader", dict(filepath="points.xyz", separator=" ", voxelSize="1", matfile="wall.mtl")),
    ("lasloader", dict(filepath="points.las", voxelSize="1")),
    ("lasloader", dict(filepath="points.laz", voxelSize="1")),
    ("detailedvoxels", dict(filepath="tree.vox", ladlut="leaves.txt", matfile="leaf.mtl")),
    ("detailedvoxels", dict(filepath="hedge.vox", intersectionMode="fixed")),
]
TRIANGLE = "v 0 0 {0}\nv 1 0 {0}\nv 0 1 {0}\n"
VOXELS = (
    "VOXEL SPACE\n#min_corner: 2 2 0\n#max_corner: 3 3 1\n#split: 1 1 1\n#res: 1 #max_pad: 1.6\n"
    "i j k PadBVTotal transmittance\n0 0 0 0.4 0.5\n"
)
VRT = """\
<VRTDataset rasterXSize="4" rasterYSize="4"><!-- byte: 0 -->
<GeoTransform>{x}, 1, 0, -20, 0, -1</GeoTransform>
<VRTRasterBand dataType="Float32" band="1"><SimpleSource>
<SourceFilename relativeToVRT="1">{name}</SourceFilename><SourceBand>1</SourceBand>
<SrcRect xOff="0" yOff="0" xSize="4" ySize="4"/><DstRect xOff="0" yOff="0" xSize="4" ySize="4"/>
</SimpleSource></VRTRasterBand></VRTDataset>
"""
SPECTRUM = "byte: 0\n0.4 {0}\n2.0 {0}\n"

# Every kind of input, and two texts of the same length: what is in the file, and what takes its place.
BYTE = (b"byte: 0", b"byte: 1")
KINDS = {
    "survey.xml": BYTE,
    "scene.xml": BYTE,
    "platform.xml": BYTE,
    "scanner.xml": BYTE,
    "beams.csv": (b"# 0", b"# 1"),
    "pulse.csv": (b"1,1.0", b"1,1.1"),
    "flight.txt": (b"0,0,20", b"0,0,21"),
    "stand.csv": (b"5,5", b"5,6"),
    "pole.obj": BYTE,
    "ground.obj": BYTE,
    "ground.mtl": BYTE,  # by mtllib
    "grass.ppm": (b"\x07\x07", b"\x07\x08"),  # by map_Kd of ground.mtl: a texel
    "spectra/clay.txt": (b"0.4 30", b"0.4 31"),  # by its name in ground.mtl
    "wall.obj": BYTE,
    "wall.mtl": BYTE,
    "mesh.ply": BYTE,
    "mesh.stl": BYTE,
    "town.city.json": BYTE,
    "mesh.gltf": BYTE,
    "mesh.bin": (struct.pack("<f", 7.5), struct.pack("<f", 7.625)),
    "all.vrt": BYTE,
    "inner.vrt": BYTE,  # a tile of all.vrt
    "tile.tif": (struct.pack("<f", 2.25), struct.pack("<f", 2.5)),  # input of inner.vrt
    "tile.tif.aux.xml": BYTE,  # beside it
    "points.xyz": (b"0.5", b"0.6"),
    "points.las": (b"byte: 0", b"byte: 1"),
    "points.laz": (b"byte: 0", b"byte: 1"),
    "tree.vox": (b"0.4 0.5", b"0.3 0.5"),
    "leaves.txt": (b"0,0,1,0.5", b"0,0,1,0.6"),
    "leaf.mtl": BYTE,
    "hedge.vox": (b"0.4 0.5", b"0.3 0.5"),
}

OPTIONS = [
    "--format",
    "las",
    "--colors",
    "--pulses-per-block",
    "1000",
    "--seed",
    "1",
    "--no-accuracy-report",
]


def write_scene(folder):
    names = [
        f'<part><filter type="{kind}">'
        + "".join(f'<param key="{key}" value="{value}"/>' for key, value in parameters.items())
        + "</filter></part>"
        for kind, parameters in LOADERS
    ]
    (folder / "scene.xml").write_text(SCENE.format("\n".join(names)))
    (folder / "stand.csv").write_text("model,x,y,z\npole,5,5,0\n")
    (folder / "pole.obj").write_text("# byte: 0\n" + TRIANGLE.format(3) + "f 1 2 3\n")
    (folder / "ground.obj").write_text(
        "# byte: 0\nmtllib ground.mtl\nusemtl clay\nv -90 -90 0\nv 90 -90 0\nv 90 90 0\nv -90 90 0\n"
        "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/2\n"
    )
    (folder / "ground.mtl").write_text(
        "# byte: 0\nnewmtl clay\nKd 1 1 1\nmap_Kd grass.ppm\nhelios_spectra clay\n"
    )
    (folder / "grass.ppm").write_bytes(b"P6\n2 2\n255\n" + b"\x07" * 12)
    (folder / "spectra").mkdir()
    (folder / "spectra/clay.txt").write_text(SPECTRUM.format(30))
    (folder / "wall.obj").write_text("# byte: 0\n" + TRIANGLE.format(4) + "f 1 2 3\n")
    (folder / "wall.mtl").write_text("# byte: 0\nnewmtl wall\nhelios_reflectance 0.3\n")


def write_meshes(folder):
    (folder / "mesh.ply").write_text(
        "ply\nformat ascii 1.0\ncomment byte: 0\nelement vertex 3\nproperty double x\n"
        "property double y\nproperty double z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 5\n1 0 5\n0 1 5\n3 0 1 2\n"
    )
    corners = "".join(f"vertex {x} {y} 6\n" for x, y in ((0, 0), (1, 0), (0, 1)))
    (folder / "mesh.stl").write_text(
        f"solid byte: 0\nfacet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\nendsolid\n"
    )
    town = {
        "type": "CityJSON",
        "version": "1.1",
        "transform": {"scale": [1, 1, 1], "translate": [0, 0, 0]},
        "metadata": {"title": "byte: 0"},
        "CityObjects": {
            "a": {
                "type": "Building",
                "geometry": [{"type": "MultiSurface", "lod": "1", "boundaries": [[[0, 1, 2]]]}],
            }
        },
        "vertices": [[8, 0, 8], [9, 0, 8], [8, 1, 8]],
    }
    (folder / "town.city.json").write_text(json.dumps(town))
    points = np.array([[0, 7.5, 0], [1, 7.5, 0], [0, 7.5, 1]], np.float32)
    (folder / "mesh.bin").write_bytes(points.tobytes())
    accessor = {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
    accessor.update(min=[0, 7.5, 0], max=[1, 7.625, 1])
    mesh = {
        "asset": {"version": "2.0", "generator": "byte: 0"},
        "buffers": [{"byteLength": 36, "uri": "mesh.bin"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [accessor],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "scene": 0,
    }
    (folder / "mesh.gltf").write_text(json.dumps(mesh))


def write_rasters(folder):
    (folder / "all.vrt").write_text(VRT.format(x=-20, name="inner.vrt"))
    (folder / "inner.vrt").write_text(VRT.format(x=-20, name="tile.tif"))
    tile = gdal.GetDriverByName("GTiff").Create(str(folder / "tile.tif"), 4, 4, 1, gdal.GDT_Float32)
    tile.SetGeoTransform([-20, 1, 0, -20, 0, -1])
    tile.GetRasterBand(1).WriteArray(np.full((4, 4), 2.25, np.float32))
    del tile
    (folder / "tile.tif.aux.xml").write_text("<PAMDataset><!-- byte: 0 --></PAMDataset>\n")


def write_clouds(folder):
    points = np.array([[-5, -5, 0.5], [-5, -4, 1.5], [-4, -5, 2.5]])
    np.savetxt(folder / "points.xyz", points, fmt="%.1f")
    for name in ("points.las", "points.laz"):
        with formats.open_writer(folder / name) as writer:
            writer.write({"points": points - [10, 0, 0]})
        data = bytearray((folder / name).read_bytes())
        data[58:90] = b"byte: 0".ljust(32, b"\0")  # the generating software
        (folder / name).write_bytes(data)
    (folder / "tree.vox").write_text(VOXELS)
    (folder / "hedge.vox").write_text(VOXELS.replace("2 2 0", "6 6 0").replace("3 3 1", "7 7 1"))
    (folder / "leaves.txt").write_text("0,0,1,0.5\n1,0,0,0.5\n")
    (folder / "leaf.mtl").write_text("# byte: 0\nnewmtl leaf\nhelios_reflectance 0.3\n")


def write_survey(folder):
    """A survey that reads a file of each kind; returns its path."""
    (folder / "survey.xml").write_text(SURVEY)
    (folder / "platform.xml").write_text(PLATFORM)
    (folder / "scanner.xml").write_text(SCANNER)
    (folder / "beams.csv").write_text("# 0\nelevation_deg\n-30\n-45\n-60\n")
    (folder / "pulse.csv").write_text("0,0\n1,1.0\n2,0.5\n3,0\n")
    (folder / "flight.txt").write_text("0,0,0,90,0,0,20\n1,0,0,90,5,0,20\n")
    write_scene(folder)
    write_meshes(folder)
    write_rasters(folder)
    write_clouds(folder)
    return folder / "survey.xml"


def vtkhelios_run(*arguments):
    """Runs the command in this process; returns its exit code."""
    return cli.main([*map(str, arguments), "--quiet"])


class Folder:
    """A survey with runs of it: one that was broken off, one that is finished, and two parts."""

    def __init__(self, path):
        self.path, self.survey = path, write_survey(path)
        self.options = ["--assets", path, *OPTIONS]
        run = ["run", self.survey, *self.options, "--output"]
        assert vtkhelios_run(*run, path / "whole") == 0
        for part in ("1/2", "2/2"):
            assert vtkhelios_run(*run, path / "parts", "--part", part) == 0
        self.break_off(path / "broken")

    def break_off(self, output):
        """Leaves a run after some blocks."""
        survey = vtkhelios.read_survey(self.survey, assets=[self.path])
        player = vtkhelios.vtkHeliosSurveyPlayer(survey=survey.vtk, output_directory=str(output))
        player.format = "las"
        player.pulses_per_block, player.options.seed, player.write_colors = 1000, 1, True
        player.options.accuracy_report = False
        player.AddObserver(
            "ProgressEvent", lambda *_: player.GetCount("pulses") > 3000 and player.Abort()
        )
        assert not player.Run() and (output / "all/run.journal").exists()

    def inputs(self, output="whole"):
        summary = json.loads((self.path / output / "all/run_summary.json").read_text())
        return {
            os.path.relpath(each["file"], self.path): (each["bytes"], each["sha256"])
            for each in summary["inputs"]
        }


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return Folder(tmp_path_factory.mktemp("inputs"))


class Change:
    """Changes bytes of a file for a while, neither its size nor, on request, its time."""

    def __init__(self, path, keeps_time=False):
        self.path, self.keeps_time = path, keeps_time

    def __enter__(self):
        self.bytes, self.state = self.path.read_bytes(), self.path.stat()
        old, new = KINDS[os.path.relpath(self.path, self.root())]
        assert len(old) == len(new) and old in self.bytes
        self.path.write_bytes(self.bytes.replace(old, new))
        assert self.path.stat().st_size == self.state.st_size
        self.restore_time()

    def root(self):
        return self.path.parent.parent if self.path.parent.name == "spectra" else self.path.parent

    def restore_time(self):
        if self.keeps_time:
            os.utime(self.path, ns=(self.state.st_atime_ns, self.state.st_mtime_ns))

    def __exit__(self, *_):
        self.path.write_bytes(self.bytes)
        self.restore_time()


def test_the_table_has_every_input(folder):
    """Each with its size and its digest; the run opens no other file of this folder."""
    files = {str(path.relative_to(folder.path)): path for path in map(folder.path.joinpath, KINDS)}
    assert folder.inputs() == {
        name: (path.stat().st_size, hashlib.sha256(path.read_bytes()).hexdigest())
        for name, path in files.items()
    }


def test_the_run_opens_no_other_file(folder, tmp_path):
    """The kernel's record is compared."""
    if not shutil.which("strace"):
        pytest.skip("no strace")
    trace = tmp_path / "trace"
    command = [sys.executable, "-P", "-m", "vtkhelios", "run", folder.survey, *folder.options]
    package = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
    subprocess.run(
        ["strace", "-f", "-e", "trace=openat,open", "-o", trace, *map(str, command), "--quiet"]
        + ["--output", str(tmp_path / "out")],
        env={**os.environ, "PYTHONPATH": str(package)},
        check=True,
    )
    opened = set()
    for line in trace.read_text(errors="replace").splitlines():
        name = line.split('"')[1] if line.count('"') > 1 else ""
        if name.startswith(f"{folder.path}/") and os.path.isfile(name) and "= -1" not in line:
            opened.add(os.path.relpath(name, folder.path))
    assert opened == set(KINDS)


@pytest.mark.parametrize("keeps_time", [False, True])
@pytest.mark.parametrize("name", KINDS)
def test_resumed_runs_name_the_file(name, keeps_time, folder, capsys):
    for output in ("broken", "whole"):
        with Change(folder.path / name, keeps_time):
            run = ["run", folder.survey, *folder.options, "--output", folder.path / output]
            assert vtkhelios_run(*run, "--resume", "--check-all") == 1
        said = capsys.readouterr().err
        assert f"{folder.path / name} has changed; use the same inputs and options" in said
        assert "set Overwrite (--overwrite) to start again" in said
    assert (folder.path / "broken/all/run.journal").exists()


@pytest.mark.parametrize("name", KINDS)
def test_joined_parts_name_the_file(name, folder, tmp_path, capsys):
    with Change(folder.path / name):
        join = ["join", folder.path / "parts/all", "--output", tmp_path / "joined"]
        assert vtkhelios_run(*join) == 1
    said = capsys.readouterr().err
    assert "part001of002: part 1/2 cannot be joined, since" in said
    assert f"{folder.path / name} has changed; join and run all parts with the same inputs" in said


def test_unchanged_inputs_are_accepted(folder, tmp_path):
    """After all changes were taken back, also with other times."""
    for name in KINDS:
        os.utime(folder.path / name)
    shutil.copytree(folder.path / "broken", tmp_path / "broken")
    run = ["run", folder.survey, *folder.options, "--resume", "--output"]
    assert vtkhelios_run(*run, tmp_path / "broken") == 0
    assert vtkhelios_run("join", folder.path / "parts/all", "--output", tmp_path / "joined") == 0
    whole = folder.path / "whole/all/leg000_points.las"
    for output in ("broken", "joined"):
        assert (tmp_path / output / "all/leg000_points.las").read_bytes() == whole.read_bytes()


def test_a_moved_survey_is_resumed(folder, tmp_path, capsys):
    """Files in another folder are the same inputs, and what changes there is named."""
    moved = tmp_path / "moved"
    shutil.copytree(folder.path, moved)
    run = ["run", moved / "survey.xml", "--assets", moved, *OPTIONS, "--resume", "--output"]
    assert vtkhelios_run(*run, moved / "whole") == 0
    for name in ("ground.mtl", "spectra/clay.txt", "grass.ppm", "tile.tif"):
        for output in ("broken", "whole"):
            with Change(moved / name):
                assert vtkhelios_run(*run, moved / output) == 1
            assert f"{moved / name} has changed" in capsys.readouterr().err
    assert vtkhelios_run(*run, moved / "broken") == 0


def test_a_file_that_takes_precedence_is_new(folder, tmp_path, capsys):
    """A spectrum that is found in a folder before the others."""
    shutil.copytree(folder.path, tmp_path / "copy")
    copy = tmp_path / "copy"
    first = tmp_path / "first"
    (first / "spectra").mkdir(parents=True)
    run = ["run", copy / "survey.xml", "--assets", first, "--assets", copy, *OPTIONS, "--resume"]
    (first / "spectra/clay.txt").write_text(SPECTRUM.format(50))
    assert vtkhelios_run(*run, "--output", copy / "broken") == 1
    assert f"{first / 'spectra/clay.txt'} has changed" in capsys.readouterr().err


def test_an_archive_is_an_input(folder, tmp_path, capsys):
    """A tile in a ZIP file."""
    copy = tmp_path / "copy"
    shutil.copytree(folder.path, copy, ignore=shutil.ignore_patterns("all"))
    with zipfile.ZipFile(copy / "tiles.zip", "w") as archive:
        archive.write(copy / "tile.tif", "tile.tif")
    text = (
        (copy / "inner.vrt").read_text().replace('"1">tile.tif', '"0">/vsizip/tiles.zip/tile.tif')
    )
    (copy / "inner.vrt").write_text(text.replace("tiles.zip", f"{copy}/tiles.zip"))
    run = ["run", copy / "survey.xml", "--assets", copy, *OPTIONS, "--output", copy / "out"]
    assert vtkhelios_run(*run) == 0
    with open(copy / "out/all/run_summary.json") as file:
        names = {os.path.relpath(each["file"], copy) for each in json.load(file)["inputs"]}
    assert names == set(KINDS) - {"tile.tif", "tile.tif.aux.xml"} | {"tiles.zip"}
    with open(copy / "tiles.zip", "ab") as archive:
        archive.write(b"more")
    assert vtkhelios_run(*run, "--resume") == 1
    assert f"{copy / 'tiles.zip'} has changed" in capsys.readouterr().err


def test_epochs_have_the_files_that_they_read(folder, tmp_path):
    """The files do not depend on whether the same process loaded the epoch before."""
    copy = tmp_path / "copy"
    shutil.copytree(folder.path, copy, ignore=shutil.ignore_patterns("all"))
    for name in ("old", "new"):
        mesh = f"mtllib {name}.mtl\nusemtl m\n{TRIANGLE.format(9)}f 1 2 3\n"
        (copy / f"{name}.obj").write_text(mesh)
        (copy / f"{name}.mtl").write_text("newmtl m\nhelios_reflectance 0.3\n")
    load = '<filter type="objloader"><param key="filepath" value="{}.obj"/></filter>'
    part = f'<part>{load.format("old")}<swap>{load.format("new")}</swap></part>'
    scene = (copy / "scene.xml").read_text()
    (copy / "scene.xml").write_text(scene.replace("<partTable", f"{part}<partTable"))
    run = ["run", copy / "survey.xml", "--assets", copy, *OPTIONS, "--output"]
    assert vtkhelios_run(*run, copy / "both") == 0
    assert vtkhelios_run(*run, copy / "alone", "--epoch", "1") == 0

    def inputs(output, epoch):
        path = copy / output / "all" / epoch / "run_summary.json"
        return json.loads(path.read_text())["inputs"]

    def names(output, epoch):
        return {os.path.relpath(each["file"], copy) for each in inputs(output, epoch)}

    assert names("both", "epoch000") == set(KINDS) | {"old.obj", "old.mtl"}
    assert names("both", "epoch001") == set(KINDS) | {"new.obj", "new.mtl"}
    assert inputs("both", "epoch001") == inputs("alone", "epoch001")


# Ranks and workers: each reads its own files.

OTHER = ["ground.mtl", "grass.ppm", "spectra/clay.txt", "mesh.bin", "tile.tif", "pulse.csv"]


@pytest.mark.parametrize("name", OTHER)
def test_workers_name_the_file(name, folder):
    """The files that one worker has loaded are compared with another worker's."""
    survey = vtkhelios.read_survey(folder.survey, assets=[folder.path])
    options = dict(colors=True)
    task = _tasks.make_task(survey, options)
    _tasks._here.clear()  # like in another process
    windows, total, loaded = _tasks.find_windows(vtkhelios.read_survey, task, None)
    assert {
        os.path.relpath(each["file"], folder.path) for each in json.loads(loaded)["inputs"]
    } == (set(KINDS))
    assert len(_tasks.compute_block(vtkhelios.read_survey, task, 0, 1000, loaded))
    _tasks._loaded.clear()
    task = json.loads(task)
    task["fingerprint"] = json.dumps({**json.loads(task["fingerprint"]), "inputs": []})
    survey = vtkhelios.read_survey(folder.survey, assets=[folder.path])
    with Change(folder.path / name, keeps_time=True):
        _tasks._loaded[task["key"]] = survey  # survey of a worker that has read it after the change
        with pytest.raises(vtkhelios.PipelineError) as caught:
            _tasks.compute_block(vtkhelios.read_survey, json.dumps(task), 0, 1000, loaded)
    _tasks._loaded.clear()
    message = f"not the survey of another worker, since {folder.path / name} has changed"
    assert message in str(caught.value) and "give all workers the same files" in str(caught.value)


@pytest.mark.skipif(
    not shutil.which("mpiexec") or not importlib.util.find_spec("vtkhelios.vtkHeliosScannerMpi"),
    reason="no MPI",
)
@pytest.mark.parametrize("name", OTHER)
def test_ranks_name_the_file(name, folder, tmp_path):
    """Rank 1 works in another folder, of whose files one differs."""
    for rank in ("0", "1"):
        shutil.copytree(folder.path, tmp_path / rank, ignore=shutil.ignore_patterns("all"))
    path = tmp_path / "1" / name
    old, new = KINDS[name]
    path.write_bytes(path.read_bytes().replace(old, new))
    program = (
        "import os, sys; os.chdir(os.environ.get('OMPI_COMM_WORLD_RANK', os.environ.get('PMI_RANK')));"
        "from vtkhelios.cli import main; sys.exit(main(sys.argv[1:]))"
    )
    run = ["run", "survey.xml", "--assets", ".", *OPTIONS, "--output", str(tmp_path / "out")]
    done = subprocess.run(
        ["mpiexec", "--oversubscribe", "--bind-to", "none", "-n", "2", sys.executable, "-P", "-c"]
        + [program, *run],
        env={
            **os.environ,
            "PYTHONPATH": str(pathlib.Path(vtkhelios.__file__).absolute().parents[1]),
            "OMPI_ALLOW_RUN_AS_ROOT": "1",  # in containers
            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "PMIX_MCA_gds": "hash",  # needs no shared memory
        },
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode != 0
    assert "rank 1: cannot share the run of rank 0, since" in done.stderr
    assert f"{path.name} has changed; give all ranks the same files" in done.stderr


# While it is read.


def test_a_file_that_changes_while_the_scene_is_loaded(folder, tmp_path):
    shutil.copytree(folder.path, tmp_path / "copy", ignore=shutil.ignore_patterns("all"))
    survey = vtkhelios.read_survey(tmp_path / "copy/survey.xml", assets=[tmp_path / "copy"])
    player = vtkhelios.vtkHeliosSurveyPlayer(
        survey=survey.vtk, output_directory=str(tmp_path / "out")
    )

    def change(*_):
        if player.GetMessage() == "assembling the scene":
            with open(tmp_path / "copy/ground.mtl", "a") as file:
                file.write("# more\n")

    player.AddObserver("ProgressEvent", change)
    assert not player.Run()
    expected = "ground.mtl was changed while the survey was loaded; run the survey again when"
    assert expected in player.GetMessage()
    assert not (tmp_path / "out/all/run.journal").exists()


def test_an_image_that_changes_during_a_run_was_read_before(folder, tmp_path):
    shutil.copytree(folder.path, tmp_path / "copy", ignore=shutil.ignore_patterns("all"))
    image, runs = tmp_path / "copy/grass.ppm", []
    for name, texel in (("whole", None), ("changed", b"\x09")):
        survey = vtkhelios.read_survey(tmp_path / "copy/survey.xml", assets=[tmp_path / "copy"])
        player = vtkhelios.vtkHeliosSurveyPlayer(
            survey=survey.vtk,
            output_directory=str(tmp_path / name),
            format="las",
            write_colors=True,
        )

        def change(*_, player=player, texel=texel):
            if texel and player.GetMessage() == "running leg 0":
                image.write_bytes(b"P6\n2 2\n255\n" + texel * 12)

        player.AddObserver("ProgressEvent", change)
        assert player.Run(), player.GetMessage()
        runs.append([path.read_bytes() for path in sorted((tmp_path / name).rglob("*.las"))])
    assert b"\x09" in image.read_bytes()
    assert runs[0] and runs[0] == runs[1]
