# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel of build.sh, in an environment without Debian's packages and beside PyPI's vtk.

Not part of the default tests: build/venv/bin/python -m pytest Python/wheel/test_wheel.py
HELIOS_PYTHON names the Python of the wheel (/usr/bin/python3). It needs PyPI, installs 400 MB into
build/wheel/test, and compares with the program of this build, build/bin/vtkhelios.
"""

import filecmp
import os
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PYTHON = os.environ.get("HELIOS_PYTHON", "/usr/bin/python3")  # Python of the wheel that is tested
REFERENCE = ROOT / "build/bin/vtkhelios"
LARGEST = 60_000_000  # bytes


def run(*command, check=True, **options):
    kept = ("PATH", "HOME", "PIP_INDEX_URL", "PIP_CERT")
    environment = {key: os.environ[key] for key in kept if key in os.environ}
    environment |= options.pop("environment", {})
    done = subprocess.run(
        [*map(str, command)], capture_output=True, text=True, env=environment, **options
    )
    assert not check or done.returncode == 0, done.stdout + done.stderr
    return done


@pytest.fixture(scope="session")
def wheel():
    code = "import sys; print('cp{}{}'.format(*sys.version_info), end='')"
    tag = run(PYTHON, "-c", code).stdout
    wheels = sorted((ROOT / "dist").glob(f"vtkhelios-*-{tag}-{tag}-manylinux_*.whl"))
    assert wheels, "dist has no wheel: make it with Python/wheel/build.sh"
    return wheels[-1]


def make_environment(name, *packages):
    folder = ROOT / "build/wheel/test" / name
    shutil.rmtree(folder, ignore_errors=True)
    run(PYTHON, "-m", "venv", folder)
    pip = (folder / "bin/python", "-m", "pip", "--disable-pip-version-check")
    run(*pip, "install", "-q", *packages)
    run(*pip, "check")
    return folder / "bin"


@pytest.fixture(scope="session")
def alone(wheel):
    """The folder of programs of an environment with the wheel and numpy."""
    return make_environment("alone", wheel)


@pytest.fixture(scope="session")
def beside(wheel):
    """The same with PyVista, its VTK, and rasterio."""
    return make_environment("beside", wheel, "vtk==9.7.*", "pyvista==0.49.*", "rasterio==1.4.*")


@pytest.fixture(scope="session")
def village(tmp_path_factory, alone):
    folder = tmp_path_factory.mktemp("village")
    run(alone / "python", ROOT / "Data/Scenes/make_village.py", folder)
    return folder


def scan(program, survey, output, *more, **options):
    return run(
        program, "run", survey, "--assets", ROOT / "Data", "--output", output, *more, **options
    )


def expect_equal_files(left, right):
    """The points, trajectories and waveforms of two runs are the same bytes."""
    names = sorted(path.name for path in left.rglob("leg*"))
    assert names and names == sorted(path.name for path in right.rglob("leg*"))
    for path in left.rglob("leg*"):
        other = next(right.rglob(path.name))
        assert filecmp.cmp(path, other, shallow=False), path.name
        assert path.stat().st_size > 0


def test_size(wheel):
    assert wheel.stat().st_size < LARGEST


def test_every_library_has_a_license(wheel):
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        libraries = {name.split("/")[-1] for name in names if name.startswith("vtkhelios/lib/")}
        bundled = next(name for name in names if name.endswith(".dist-info/licenses/bundled.txt"))
        text = archive.read(bundled).decode()
        rows = {row.split()[0]: row.split() for row in text.split("\n\n")[1].splitlines()}
        assert libraries and libraries <= set(rows)
        for library in libraries:
            source = rows[library][1]
            notice = archive.read(bundled.replace("bundled.txt", f"{source}.txt")).decode()
            assert "opyright" in notice, source


def test_auditwheel_accepts_the_tag(wheel):
    """It links to nothing outside of the wheel but the libraries that every Linux has."""
    tool = next(ROOT.glob("build/wheel/venv-*/bin/auditwheel"))
    shown = " ".join(run(tool, "show", wheel).stdout.split())
    assert 'is consistent with the following platform tag: "manylinux_2_35_x86_64"' in shown


def test_no_symbol_is_shared_with_another_vtk(wheel, tmp_path):
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path)
    libraries = [path for path in tmp_path.rglob("*.so*") if path.is_file()]
    assert len(libraries) > 60
    for library in libraries:
        assert "UNIQUE" not in run("readelf", "--dyn-syms", "-W", library).stdout, library
        names = re.findall(r"\(NEEDED\).*\[(libvtk.*)\]", run("readelf", "-d", library).stdout)
        assert [name for name in names if name.endswith("-9.1.so.1")] == [], library


def test_commands_without_numpy_of_the_system(alone):
    assert re.fullmatch(r"vtkhelios \S+\n", run(alone / "vtkhelios", "--version").stdout)
    code = "import numpy, sys, vtkhelios; assert numpy.__file__.startswith(sys.prefix)"
    run(alone / "python", "-c", f"{code}; assert vtkhelios.__file__.startswith(sys.prefix)")


@pytest.mark.parametrize("survey", ["village_tls", "village_als"])
def test_echoes_are_those_of_the_debian_build(alone, village, tmp_path, survey):
    assert REFERENCE.is_file(), "build the release preset for the comparison"
    for name, program in (("wheel", alone / "vtkhelios"), ("build", REFERENCE)):
        scan(program, ROOT / f"Data/Surveys/{survey}.xml", tmp_path / name, "--assets", village)
    expect_equal_files(tmp_path / "wheel", tmp_path / "build")


def write_fence(folder):
    sys.path.insert(0, str(ROOT / "Python/tests"))
    from _small_run import write_survey

    return write_survey(folder)


def test_coordinate_systems_come_with_the_wheel(alone, tmp_path):
    """LAS files have the text of EPSG:25832, also where PROJ_DATA names a folder of another PROJ."""
    survey = write_fence(tmp_path)
    elsewhere = {"PROJ_DATA": str(tmp_path)}
    scan(alone / "vtkhelios", survey, tmp_path / "wheel", "--format", "las", environment=elsewhere)
    scan(REFERENCE, survey, tmp_path / "build", "--format", "las")
    expect_equal_files(tmp_path / "wheel", tmp_path / "build")


TERRAIN = """
import sys
import numpy
import rasterio
x, y = numpy.meshgrid(numpy.arange(120), numpy.arange(120))
heights = (3 * numpy.sin(x / 9) * numpy.cos(y / 11)).astype("float32")
heights[40:44, 50:53] = -9999
corner = rasterio.transform.from_origin(-60, 60, 1, 1)
with rasterio.open(sys.argv[1], "w", driver="GTiff", width=120, height=120, count=1, dtype="float32",
                   crs="EPSG:25832", transform=corner, nodata=-9999, compress="deflate") as file:
    file.write(heights, 1)
"""


@pytest.fixture
def raster_survey(tmp_path, beside):
    """The survey of the fence, with terrain from a GeoTIFF file instead."""
    survey = write_fence(tmp_path)
    run(beside / "python", "-c", TERRAIN, tmp_path / "terrain.tif")
    scene = tmp_path / "scene.xml"
    text = scene.read_text().replace("objloader", "geotiffloader")
    scene.write_text(text.replace("fence.obj", "terrain.tif"))
    return survey


def test_rasters_are_read_by_the_gdal_of_rasterio(beside, raster_survey, tmp_path):
    scan(beside / "vtkhelios", raster_survey, tmp_path / "wheel")
    scan(REFERENCE, raster_survey, tmp_path / "build")
    expect_equal_files(tmp_path / "wheel", tmp_path / "build")


def test_rasters_without_gdal(alone, raster_survey, tmp_path):
    nowhere = {"VTKHELIOS_GDAL_LIBRARY": str(tmp_path / "libgdal.so")}
    done = scan(
        alone / "vtkhelios", raster_survey, tmp_path / "out", check=False, environment=nowhere
    )
    assert done.returncode == 1
    assert f"rasters cannot be read: {tmp_path}/libgdal.so: cannot open shared" in done.stderr
    assert "install GDAL (python -m pip install rasterio)" in done.stderr


def test_what_is_left_out_says_so(alone):
    done = run(alone / "vtkhelios", "view", check=False)
    assert done.returncode == 1
    assert "the wheel has no vtkhelios-viewer" in done.stderr and "to_pyvista" in done.stderr


OURS = """
import vtkhelios
from vtkhelios.vtkmodules.vtkCommonCore import vtkVersion
from vtkhelios.vtkmodules.vtkFiltersSources import vtkSphereSource
"""
THEIRS = """
import pyvista
import vtk
"""


@pytest.mark.parametrize("order", [(OURS, THEIRS), (THEIRS, OURS)], ids=["ours", "theirs"])
def test_two_vtks_work_in_one_process(beside, order):
    code = """
assert vtk.vtkVersion.GetVTKVersion().startswith("9.7.")
assert vtkVersion.GetVTKVersion() == "9.1.0"
ours = vtkSphereSource()
ours.Update()
theirs = vtk.vtkSphereSource()
theirs.Update()
assert ours.GetOutput().GetNumberOfPoints() == theirs.GetOutput().GetNumberOfPoints() == 50
try:
    ours.SetInputConnection(theirs.GetOutputPort())
except TypeError:
    pass
else:
    raise AssertionError("an object of one VTK was passed to the other")
print("done")
"""
    assert run(beside / "python", "-c", "".join(order) + code).stdout == "done\n"


PLOT = """
import sys
import numpy
import pyvista
import vtkhelios
terrain = pyvista.ParametricRandomHills(u_res=120, v_res=120, random_seed=3).triangulate()
terrain = terrain.translate([-x for x in terrain.center]).scale((3, 3, 0.3))
house = pyvista.Box((-3, 3, 3, 7, -1, 5)).triangulate()
scenes = [
    vtkhelios.Scene(numpy.array(mesh.points, float), mesh.faces.reshape(-1, 4)[:, 1:], ground=True)
    for mesh in (terrain, house)
]
cloud = vtkhelios.scan(
    scenes[0] + scenes[1], position=(9, -8, 6), head=(0, 360), head_speed=60, scan_frequency=100
)
points = cloud.to_pyvista() if hasattr(cloud, "to_pyvista") else pyvista.PolyData(cloud.points)
plotter = pyvista.Plotter(off_screen=True, window_size=(640, 480))
plotter.add_mesh(points, scalars=cloud["Range"], point_size=2, cmap="viridis")
plotter.show(screenshot=sys.argv[1])
print(len(cloud))
"""
LOOK = """
import sys
from matplotlib.image import imread
image = imread(sys.argv[1])[:, :, :3]
print(*image.shape, (abs(image - image[0, 0]).max(axis=2) > 0.05).mean())
"""


def test_a_cloud_is_plotted_by_pyvista(beside):
    """The picture, build/wheel/test/cloud.png, shows more than a background."""
    picture = ROOT / "build/wheel/test/cloud.png"
    done = run(beside / "python", "-c", PLOT, picture)  # VTK 9.7 needs no display
    assert int(done.stdout.split()[-1]) > 50_000
    height, width, _, share = run(beside / "python", "-c", LOOK, picture).stdout.split()
    assert (width, height) == ("640", "480") and 0.05 < float(share) < 0.95
