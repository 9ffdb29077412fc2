# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys over height rasters: traced as they are, with the files of a mesh."""

import hashlib
import json

import numpy as np
import pytest
from osgeo import gdal, osr

import vtkhelios
from vtkhelios.cli import main

gdal.UseExceptions()

EAST, NORTH = 478233.5, 5471966.6

SURVEY = """\
<document><survey name="s" platform="platforms.xml#{platform}" scanner="scanners.xml#{scanner}"
  scene="scene.xml#s">{legs}</survey></document>
"""
TRIPOD = f"""<leg><platformSettings x="{EAST}" y="{NORTH}" onGround="true"/>
<scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100" headRotatePerSec_deg="60"
  verticalAngleMin_deg="-40" verticalAngleMax_deg="60" headRotateStart_deg="0" headRotateStop_deg="90"/></leg>"""
AIRCRAFT = "".join(
    f"""<leg><platformSettings x="{EAST + x}" y="{NORTH}" z="300" movePerSec_m="60"/>
<scannerSettings active="{active}" pulseFreq_hz="150000" scanFreq_hz="100" scanAngle_deg="15"/></leg>"""
    for x, active in ((-20, "true"), (20, "false"))
)
PLANS = {
    "tls": ("tripod", "vz400_class_tls", TRIPOD),
    "als": ("airplane_linearpath", "rotating_als", AIRCRAFT),
}

OBJ = '<filter type="objloader"><param type="string" key="filepath" value="{}"/></filter>'
TIF = """<filter type="geotiffloader"><param type="string" key="filepath" value="terrain.tif"/>
<param type="string" key="matfile" value="ground.mtl"/></filter>"""


def part(name, loader=TIF, filters=""):
    return f'<part id="{name}">{loader}{filters}</part>\n'


def move(x, y, z=0, on_ground=False):
    flag = '<param type="integer" key="onGround" value="1"/>' if on_ground else ""
    return f'<filter type="translate"><param type="vec3" key="offset" value="{x};{y};{z}"/>{flag}</filter>'


def turn(angle, axis="z"):
    return f"""<filter type="rotate"><param key="rotation" type="rotation">
<rot axis="{axis}" angle_deg="{angle}"/></param></filter>"""


TREES = "".join(
    part(
        f"tree {i}",
        OBJ.format("tree.obj"),
        turn(40 * i) + move(EAST + 3 + 4 * i, NORTH + 5 - i, 0, True),
    )
    for i in range(4)
)


def make_heights(side=160):
    """Hills with noise and a hole."""
    y, x = np.mgrid[0:side, 0:side] * 0.5
    z = 110 + 3 * np.sin(x / 9) * np.cos(y / 7) + np.random.default_rng(1).normal(0, 0.05, x.shape)
    z[side // 4 : side // 4 + 6, side // 2 : side // 2 + 9] = -9999
    return z.astype(np.float32)


def write_raster(path, heights, east=EAST, north=NORTH, no_data=-9999):
    side = heights.shape[0]
    raster = gdal.GetDriverByName("GTiff").Create(str(path), side, side, 1, gdal.GDT_Float32)
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(32632)
    raster.SetProjection(reference.ExportToWkt())
    raster.SetGeoTransform([east - side / 4, 0.5, 0, north + side / 4, 0, -0.5])
    if no_data is not None:
        raster.GetRasterBand(1).SetNoDataValue(no_data)
    raster.GetRasterBand(1).WriteArray(heights)
    raster.FlushCache()


@pytest.fixture
def folder(tmp_path):
    write_raster(tmp_path / "terrain.tif", make_heights())
    (tmp_path / "ground.mtl").write_text(
        "newmtl grass\nhelios_reflectance 0.4\nhelios_classification 2\nhelios_isGround true\n"
    )
    (tmp_path / "tree.obj").write_text(
        "v -1 0 2\nv 1 0 2\nv 0 0.5 6\nv 0 -1 1\nv 0.2 1 2\nv 0.1 0 5\nv 0 0 0\n"
        "f 1 2 3\nf 4 5 6\nf 1 5 3\nf 7 1 2\n"
    )
    return tmp_path


def write_survey(folder, parts, plan="tls", scene=""):
    (folder / "scene.xml").write_text(
        f'<document><scene id="s" {scene}>\n{parts}</scene></document>'
    )
    platform, scanner, legs = PLANS[plan]
    survey = folder / f"{plan}.xml"
    survey.write_text(SURVEY.format(platform=platform, scanner=scanner, legs=legs))
    return survey


def run(survey, *options):
    """The digests of the files of a run."""
    output = survey.parent / "out"
    assert (
        main(["run", str(survey), "--output", str(output), "--overwrite", "--quiet", *options]) == 0
    )
    files = sorted(p for p in output.rglob("*") if p.is_file() and p.suffix != ".json")
    assert sum(p.stat().st_size for p in files) > 100000
    return {str(p.relative_to(output)): hashlib.sha256(p.read_bytes()).hexdigest() for p in files}


def load(survey, instances=True, **options):
    source = vtkhelios.read_survey(survey).source(instances=instances, **options)
    assert source.Load()
    return source.GetScene()


def find_prototypes(scene):
    if not isinstance(scene, vtkhelios.vtkHeliosScene):
        return []
    return [scene.GetPrototype(i).GetClassName() for i in range(scene.GetNumberOfPrototypes())]


@pytest.mark.parametrize("plan", PLANS)
@pytest.mark.parametrize(
    "options", [["--sub-rays", "1"], ["--sub-rays", "19"], ["--format", "las"]]
)
def test_files_are_those_of_a_mesh(folder, plan, options):
    survey = write_survey(folder, part("terrain") + TREES, plan)
    assert find_prototypes(load(survey)) == ["vtkImageData", "vtkPolyData"]
    assert run(survey, *options) == run(survey, *options, "--no-instances")


SCALE = '<filter type="scale"><param type="double" key="scale" value="1.5"/></filter>'
PLACES = {
    "moved": move(EAST + 3.25, NORTH - 7.5, 12.125),
    "turned": turn(33) + move(EAST, NORTH),
    "scaled": SCALE + move(EAST, NORTH),
    "tilted": turn(5, "x") + move(EAST, NORTH),
}


@pytest.mark.parametrize("place", PLACES)
def test_a_raster_may_be_placed(folder, place):
    write_raster(folder / "terrain.tif", make_heights(), 0, 0)
    survey = write_survey(folder, part("terrain", filters=PLACES[place]) + TREES)
    assert find_prototypes(load(survey)) == ["vtkImageData", "vtkPolyData"]
    assert run(survey, "--sub-rays", "19") == run(survey, "--sub-rays", "19", "--no-instances")


def test_a_raster_is_the_scene(folder):
    survey = write_survey(folder, part("terrain"), "als")
    scene = load(survey)
    assert scene.GetNumberOfPolys() == 0
    assert scene.GetNumberOfTriangles() == load(survey, False).GetNumberOfPolys()
    assert scene.GetFieldData().GetAbstractArray("Material.Name").GetValue(0) == "grass"
    assert "32632" in scene.GetFieldData().GetAbstractArray("CRS").GetValue(0)
    assert run(survey) == run(survey, "--no-instances")


def test_two_parts_of_one_raster(folder):
    survey = write_survey(folder, part("near") + part("high", filters=move(0, 0, 30)), "als")
    assert find_prototypes(load(survey)) == ["vtkImageData"]
    assert run(survey) == run(survey, "--no-instances")


@pytest.mark.parametrize(
    "filters",
    [
        '<filter type="repair"/>',
        '<filter type="crs"><param key="target" value="EPSG:25832"/></filter>',
        move(0, 0, 0, True),
    ],
)
def test_filters_of_meshes_make_one(folder, filters):
    under = part("base", OBJ.format("base.obj"))
    (folder / "base.obj").write_text(
        f"v {EAST - 90} {NORTH - 90} 90\nv {EAST + 90} {NORTH - 90} 90\nv {EAST} {NORTH + 90} 90\nf 1 2 3\n"
    )
    scene = load(write_survey(folder, part("terrain", filters=filters) + under))
    assert find_prototypes(scene) == []
    assert scene.GetNumberOfPolys() > 40000


def test_extreme_heights_make_a_mesh(folder, capsys):
    """Boxes of rasters are floats, relative to the width: heights far beyond are for meshes."""
    heights = make_heights()
    heights[3, 5] = 1e9
    write_raster(folder / "terrain.tif", heights)
    survey = write_survey(folder, part("terrain") + TREES)
    assert find_prototypes(load(survey)) == ["vtkPolyData"]
    assert run(survey) == run(survey, "--no-instances")


def test_a_raster_without_triangles_is_left_out(folder, capsys):
    write_raster(folder / "terrain.tif", np.full((10, 10), -9999, np.float32))
    (folder / "base.obj").write_text(
        f"v {EAST - 90} {NORTH - 90} 90\nv {EAST + 90} {NORTH - 90} 90\nv {EAST} {NORTH + 90} 90\nf 1 2 3\n"
    )
    survey = write_survey(folder, part("terrain") + part("base", OBJ.format("base.obj")))
    assert find_prototypes(load(survey)) == []
    assert main(["run", str(survey), "--output", str(folder / "out")]) == 0
    error = capsys.readouterr().err
    assert (
        "terrain.tif: no triangles" in error
        and "(terrain) has no triangles; it is left out" in error
    )


def test_tiles_of_a_vrt_are_the_whole(folder):
    survey = write_survey(folder, part("terrain") + TREES)
    whole = run(survey, "--sub-rays", "19")
    heights = make_heights()
    for i in range(4):
        column, row = 80 * (i % 2), 80 * (i // 2)
        write_raster(
            folder / f"tile{i}.tif",
            heights[row : row + 80, column : column + 80],
            EAST - 20 + column / 2,
            NORTH + 20 - row / 2,
        )
    gdal.BuildVRT(
        str(folder / "all.vrt"), [str(folder / f"tile{i}.tif") for i in range(4)]
    ).FlushCache()
    write_survey(folder, part("terrain", TIF.replace("terrain.tif", "all.vrt")) + TREES)
    assert find_prototypes(load(survey)) == ["vtkImageData", "vtkPolyData"]
    assert run(survey, "--sub-rays", "19") == whole


def test_a_missing_tile_of_a_vrt_has_a_message(folder, capsys):
    gdal.BuildVRT(str(folder / "all.vrt"), [str(folder / "terrain.tif")]).FlushCache()
    survey = write_survey(folder, part("terrain", TIF.replace("terrain.tif", "all.vrt")))
    (folder / "terrain.tif").unlink()
    assert main(["run", str(survey), "--output", str(folder / "out"), "--quiet"]) == 1
    error = capsys.readouterr().err
    assert "all.vrt" in error and "terrain.tif" in error


def test_heights_beyond_the_memory_are_in_a_file(folder, monkeypatch):
    """The files are the same; the temporary one has no name."""
    side = 3000
    y, x = np.mgrid[0:side, 0:side] * 0.5
    write_raster(
        folder / "terrain.tif", (110 + 3 * np.sin(x / 9) * np.cos(y / 7)).astype(np.float32)
    )
    survey = write_survey(folder, part("terrain"))
    whole = run(survey, "--sub-rays", "1")
    scratch = folder / "scratch"
    scratch.mkdir()
    monkeypatch.setenv("TMPDIR", str(scratch))
    used = vtkhelios.vtkHeliosMemoryLimit.GetUsed()
    limit = f"{int(used + 70)}MiB"
    assert run(survey, "--sub-rays", "1", "--memory", limit) == whole
    assert not list(scratch.iterdir())


def test_a_missing_raster_has_a_message(folder, capsys):
    survey = write_survey(folder, part("terrain") + TREES)
    (folder / "terrain.tif").write_bytes(b"II*\0 not a raster")
    assert main(["run", str(survey), "--output", str(folder / "out"), "--quiet"]) == 1
    error = capsys.readouterr().err
    assert "scene.xml:2" in error and "terrain.tif" in error


def test_epochs_with_and_without_moving_parts(folder):
    """Where another part moves, the raster is one, too."""
    motion = '<dmotion id="all" loop="0"><motion type="translation" vec="0.1;0;0"/></dmotion>'
    car = OBJ.format("tree.obj") + move(EAST + 6, NORTH, 111) + motion
    moving = part("car", car, '<swap force_null="true"/>')
    survey = write_survey(folder, part("terrain") + moving, scene='dynTimeStep="0.1"')
    for epoch in range(2):
        assert find_prototypes(load(survey, epoch=epoch)) == ["vtkImageData"]
    files = run(survey)
    assert files == run(survey, "--no-instances")
    assert len(files) > 3


def test_a_changed_raster_is_another_scene(folder):
    survey = write_survey(folder, part("terrain"))
    digests = set()
    for change in (0, 0, 1):
        heights = make_heights()
        heights[-1, -1] += change
        write_raster(folder / "terrain.tif", heights)
        run(survey)
        summary = json.loads((folder / "out" / "s" / "run_summary.json").read_text())
        digests.add(json.dumps(summary["scene"]))
    assert len(digests) == 2
