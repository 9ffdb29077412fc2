# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A height raster, an OBJ and a point cloud in one scene, at real-world coordinates."""

import numpy as np
import pytest
from osgeo import gdal, osr
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader

import vtkhelios

gdal.UseExceptions()

# Heidelberg, in UTM zone 32: latitude 49.4, longitude 8.7 (40 digits, rounded).
EAST, NORTH = 478233.5100801130, 5471966.6981215651
LATITUDE, LONGITUDE = 49.4, 8.7
GROUND = 110.0
CONE = 1.5 * 0.35e-3 / 2  # rad, half angle of the sampled cone of the scanner below

SURVEY = """\
<document><survey name="town" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls"
  scene="scene.xml#s" {survey}>
<leg><platformSettings {leg}/>
<scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100" headRotatePerSec_deg="180"
  verticalAngleMin_deg="-40" verticalAngleMax_deg="60" headRotateStart_deg="0" headRotateStop_deg="360"/></leg>
</survey></document>
"""
HERE = f'x="{EAST}" y="{NORTH}" onGround="true"'

TERRAIN = """<part id="terrain"><filter type="geotiffloader">
<param type="string" key="filepath" value="terrain.tif"/>
<param type="string" key="matfile" value="ground.mtl"/><param type="string" key="matname" value="grass"/>
</filter>{filters}</part>"""
HOUSE = f"""<part id="house"><filter type="objloader">
<param type="string" key="filepath" value="house.obj"/></filter>
<filter type="translate"><param type="vec3" key="offset" value="{EAST + 10};{NORTH};0"/>
<param type="integer" key="onGround" value="1"/></filter></part>"""
WALL = """<part id="wall"><filter type="xyzloader">
<param type="string" key="filepath" value="wall.xyz"/><param type="string" key="separator" value=";"/>
<param type="double" key="voxelSize" value="0.25"/></filter></part>"""
MATERIALS = "newmtl grass\nhelios_reflectance 0.4\nhelios_classification 2\nhelios_isGround true\n"


def write_terrain(path, epsg, x, y, pixel, side=80):
    """Level ground around (x, y), as a raster of north-up pixels."""
    driver = gdal.GetDriverByName("GTiff")
    raster = driver.Create(str(path), side, side, 1, gdal.GDT_Float32)
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(epsg)
    raster.SetProjection(reference.ExportToWkt())
    half = side / 2
    raster.SetGeoTransform([x - half * pixel[0], pixel[0], 0, y + half * pixel[1], 0, -pixel[1]])
    raster.GetRasterBand(1).WriteArray(np.full((side, side), GROUND, np.float32))
    raster.FlushCache()


def write_wall(path):
    """Points 0.1 m apart on a wall 8 m north of the centre, 4 m wide, 2 m high."""
    x, z = np.meshgrid(np.arange(-2, 2, 0.1), np.arange(0, 2, 0.1))
    points = np.stack([EAST + x.ravel(), np.full(x.size, NORTH + 8), GROUND + z.ravel()], axis=-1)
    np.savetxt(path, points, fmt="%.3f", delimiter=";")


@pytest.fixture
def run(tmp_path):
    """Runs a survey of a scene with these parts; returns the echoes, or the error texts."""
    write_terrain(tmp_path / "terrain.tif", 32632, EAST, NORTH, (1.0, 1.0))
    write_wall(tmp_path / "wall.xyz")
    (tmp_path / "ground.mtl").write_text("newmtl asphalt\n" + MATERIALS)
    (tmp_path / "house.obj").write_text(
        "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv -2 -2 3\nv 2 -2 3\nv 2 2 3\nv -2 2 3\n"
        "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 7 8\n"
    )

    def call(*parts, leg=HERE, survey="", scene=""):
        (tmp_path / "scene.xml").write_text(
            f'<document><scene id="s" {scene}>\n' + "\n".join(parts) + "</scene></document>"
        )
        (tmp_path / "survey.xml").write_text(SURVEY.format(leg=leg, survey=survey))
        errors = []
        reader = vtkhelios.vtkHeliosSurveyReader()
        player = vtkhelios.vtkHeliosSurveyPlayer()
        for algorithm in (reader, player):
            watch(algorithm, errors)
        reader.SetFileName(str(tmp_path / "survey.xml"))
        reader.AddAssetDirectory(str(vtkhelios.data_directory() / "Assets"))
        if not reader.Read():
            return "\n".join(errors)
        player.SetSurvey(reader.GetSurvey())
        player.SetOutputDirectory(str(tmp_path))
        player.SetOverwrite(True)
        player.SetFormat("vtp")
        player.GetOptions().NoiseOff()
        if not player.Run():
            return "\n".join(errors)
        assert not errors
        cloud = vtkXMLPPolyDataReader()
        cloud.SetFileName(str(tmp_path / "town" / "leg000_points.pvtp"))
        cloud.Update()
        return cloud.GetOutput()

    call.folder = tmp_path
    return call


def watch(source, errors):
    def note(caller, event, text):
        errors.append(text)

    note.CallDataType = "string0"
    source.AddObserver("ErrorEvent", note)


def test_three_kinds_in_one_scene(run):
    cloud = run(TERRAIN.format(filters=""), HOUSE, WALL)
    assert not isinstance(cloud, str), cloud
    echoes = vtkhelios.arrays(cloud)
    points, single = echoes["points"], echoes["NumberOfReturns"] == 1
    part = echoes["PartIds"]
    assert set(part) == {0, 1, 2}
    ground = single & (part == 0)
    away = np.abs(points[ground, 2] - GROUND)
    assert np.quantile(away, 0.99) < 2e-3
    # If a part cuts the footprint the echo belongs to the rest: at most the footprint away.
    cosine = np.cos(np.radians(echoes["IncidenceAngle"][ground]))
    assert np.all(away < CONE * echoes["Range"][ground] / cosine + 1e-5)
    assert np.all(echoes["ClassificationIds"][part == 0] == 2)
    # The house is on the ground, its west side 8 m away.
    assert points[part == 1, 0].min() == pytest.approx(EAST + 8, abs=CONE * 12)
    assert points[part == 1, 2].min() > GROUND - 0.05
    # The wall is one layer of 0.25 m voxels from the minimum of its points on.
    wall = points[single & (part == 2)]
    assert wall[:, 1].min() == pytest.approx(NORTH + 8, abs=1e-2)
    assert wall[:, 1].max() <= NORTH + 8.25 + 1e-2
    crs = cloud.GetFieldData().GetAbstractArray("CRS").GetValue(0)
    assert "32632" in crs


@pytest.mark.parametrize("kind", ["csv", "pts", "ptx", "asc"])
def test_text_of_other_programs_is_the_same_wall(run, kind):
    """Separators, columns and poses are found without attributes of the filter."""
    ground = TERRAIN.format(filters="")
    echoes = vtkhelios.arrays(run(ground, WALL))
    x, y, z = np.loadtxt(run.folder / "wall.xyz", delimiter=";").T
    names = "id,z,y,x\n" + "".join(f"7,{c},{b},{a}\n" for a, b, c in zip(x, y, z))
    counted = f"{len(x)}\n" + "".join(f"{a} {b} {c} 120\n" for a, b, c in zip(x, y, z))
    commented = "//X Y Z R\n" + "".join(f"{a} {b} {c} 9\n" for a, b, c in zip(x, y, z))
    pose = (
        f"{len(x)}\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n{EAST} {NORTH} 0 1\n"
    )
    local = "".join(f"{a - EAST:.9f} {b - NORTH:.9f} {c} 0.5\n" for a, b, c in zip(x, y, z))
    texts = {"csv": names, "pts": counted, "asc": commented, "ptx": pose + local}
    (run.folder / f"wall.{kind}").write_text(texts[kind])
    wall = WALL.replace("wall.xyz", f"wall.{kind}").replace(
        '<param type="string" key="separator" value=";"/>', ""
    )
    found = vtkhelios.arrays(run(ground, wall))
    assert len(found["points"]) == len(echoes["points"]) and (found["PartIds"] == 1).any()
    assert np.abs(found["points"] - echoes["points"]).max() < 1e-6


def test_a_raster_in_degrees_is_refused_with_the_remedy(run):
    write_terrain(run.folder / "terrain.tif", 4326, LONGITUDE, LATITUDE, (1.4e-5, 9e-6))
    errors = run(TERRAIN.format(filters=""))
    assert isinstance(errors, str)
    assert "scene.xml:1" in errors and "degrees" in errors and "EPSG:32632" in errors


def test_a_raster_in_degrees_is_reprojected_on_request(run):
    write_terrain(run.folder / "terrain.tif", 4326, LONGITUDE, LATITUDE, (1.4e-5, 9e-6))
    crs = '<filter type="crs"><param type="string" key="target" value="EPSG:32632"/></filter>'
    cloud = run(TERRAIN.format(filters=crs))
    assert not isinstance(cloud, str), cloud
    points = vtkhelios.arrays(cloud)["points"]
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    assert np.abs(points[:, 2] - GROUND).max() < 2e-2
    # 40 pixels each way: metres per degree there, by the radii of meridian and parallel
    assert np.abs(middle[:2] - (EAST, NORTH)).max() < 1.5
    assert np.ptp(points[:, 0]) < 82 and np.ptp(points[:, 1]) < 82


def test_parts_of_two_systems_are_refused(run):
    write_terrain(run.folder / "other.tif", 25833, EAST, NORTH, (1.0, 1.0))
    other = TERRAIN.format(filters="").replace("terrain", "other")
    errors = run(TERRAIN.format(filters=""), other)
    assert isinstance(errors, str)
    assert "UTM zone 32N" in errors and "UTM zone 33N" in errors


def test_a_leg_in_degrees_is_reprojected(run):
    leg = f'crs="EPSG:4326" x="{LONGITUDE}" y="{LATITUDE}" onGround="true"'
    here = vtkhelios.arrays(run(TERRAIN.format(filters=""), leg=HERE))
    there = vtkhelios.arrays(run(TERRAIN.format(filters=""), leg=leg))
    assert len(here["points"]) == len(there["points"])
    assert np.abs(here["points"] - there["points"]).max() < 1e-6


def test_the_scene_may_name_its_system(run):
    plane = (
        "<part><filter type='objloader'><param key='filepath' value='plane.obj'/></filter></part>"
    )
    corners = [(-50, -50), (50, -50), (50, 50), (-50, 50)]
    text = "".join(f"v {EAST + x!r} {NORTH + y!r} {GROUND}\n" for x, y in corners) + "f 1 2 3 4\n"
    (run.folder / "plane.obj").write_text(text)
    leg = f'crs="EPSG:4326" x="{LONGITUDE}" y="{LATITUDE}" onGround="true"'
    cloud = run(plane, leg=leg, scene='crs="EPSG:32632"')
    assert not isinstance(cloud, str), cloud
    assert cloud.GetFieldData().GetAbstractArray("CRS").GetValue(0) == "EPSG:32632"
    errors = run(plane, leg=leg)
    assert isinstance(errors, str)
    assert "survey.xml:4" in errors and "the scene has no coordinate system" in errors


def test_points_in_degrees_become_voxels_in_metres(run):
    degrees = np.array([[LONGITUDE, LATITUDE + 8 / 111_240, GROUND + z] for z in (0.1, 0.6, 1.1)])
    np.savetxt(run.folder / "wall.xyz", degrees, fmt="%.12f", delimiter=";")
    crs = """<filter type="crs"><param type="string" key="source" value="EPSG:4326"/>
<param type="string" key="target" value="EPSG:32632"/></filter>"""
    wall = WALL.replace("</part>", crs + "</part>")
    cloud = run(TERRAIN.format(filters=""), wall)
    assert not isinstance(cloud, str), cloud
    echoes = vtkhelios.arrays(cloud)
    wall = echoes["points"][echoes["PartIds"] == 1]
    assert len(wall) > 10
    assert np.abs(wall[:, :2] - (EAST, NORTH + 8)).max() < 1.0


REFUSED = {
    "no such system": ({"scene": 'crs="EPSG:99999"'}, ["scene.xml:1", "EPSG:99999"]),
    "another system": ({"scene": 'crs="EPSG:25833"'}, ["scene.xml:1", "zone 33N", "zone 32N"]),
    "a leg nowhere": ({"leg": 'crs="moon" x="1" y="2"'}, ["survey.xml:4", 'crs="moon"']),
    "no such caster": ({"survey": 'rayCaster="embre"'}, ["rayCaster", "embre", "bvh"]),
}


@pytest.mark.parametrize("name", REFUSED)
def test_impossible_systems_are_refused(run, name):
    change, messages = REFUSED[name]
    errors = run(TERRAIN.format(filters=""), **change)
    assert isinstance(errors, str)
    for message in messages:
        assert message in errors


@pytest.mark.parametrize("caster", ["bvh"])
def test_a_survey_may_choose_its_ray_caster(run, caster):
    default = vtkhelios.arrays(run(TERRAIN.format(filters=""), HOUSE))
    chosen = vtkhelios.arrays(
        run(TERRAIN.format(filters=""), HOUSE, survey=f'rayCaster="{caster}"')
    )
    for name in default:
        assert np.array_equal(default[name], chosen[name])
