# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Coordinate systems, units and epochs of point files, in every format and command."""

import json
import re

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.core.systems import Metres, find_difference, find_system

ENDINGS = ["las", "laz", "copc.laz", "xyz", "ply", "pcd", "vtp", "e57"]
SURVEY_FOOT = 1200 / 3937
UTM = "EPSG:25832"


@pytest.fixture
def run(capsys):
    """Runs a command and returns (exit code, standard output, standard error)."""

    def call(*arguments):
        capsys.readouterr()
        try:
            code = cli.main([*map(str, arguments)])
        except SystemExit as wrong:
            code = wrong.code
        return code, *capsys.readouterr()

    return call


def write(path, points, crs="", steps=None, **arrays):
    header = formats.Header()
    header.crs = crs
    with formats.open_writer(path, header) as writer:
        writer.write({"points": np.asarray(points, float), **arrays})
    return path


def read(path):
    with formats.open_reader(path) as reader:
        points = np.concatenate([chunk["points"] for chunk in reader.chunks()])
    return points, reader


def make_points(count=2000, seed=3, size=50.0):
    """Points of 50 x 50 m in UTM, to 0.1 mm."""
    random = np.random.default_rng(seed)
    points = random.uniform(0, 1, (count, 3)) * [size, size, 10] + [478000, 5473000, 100]
    return np.round(points, 4)


def make_plane(unit, height_unit, seed=0):
    """A plane with 20 mm of noise and 7.4 points/m2 on Long Island, in a unit [m]."""
    random = np.random.default_rng(seed)
    x, y = random.uniform(0, 80, (2, int(7.4 * 80 * 80)))
    z = 30 + 0.1 * x + random.normal(0, 0.02, len(x))
    points = np.column_stack([300000 + x, 60000 + y, z]) / [unit, unit, height_unit]
    arrays = {
        "GpsTime": np.arange(len(x)) * 1e-4,
        "ReturnNumber": np.ones(len(x), np.uint8),
        "NumberOfReturns": np.ones(len(x), np.uint8),
    }
    return points, arrays


def sort(points):
    return points[np.lexsort(points.T)]


# Identity


def test_what_a_system_is():
    utm = find_system(UTM)
    assert (utm.code, utm.unit, utm.height_unit, utm.has_height_unit) == (UTM, 1.0, 1.0, False)
    assert utm.name == "EPSG:25832 (ETRS89 / UTM zone 32N)" and utm.label == UTM
    feet = find_system("EPSG:2263+6360")
    assert feet.code == "EPSG:2263+6360" and feet.has_height_unit
    assert np.allclose([feet.unit, feet.height_unit], SURVEY_FOOT, rtol=1e-12)
    degrees = find_system("EPSG:4326")
    assert degrees.is_geographic and degrees.resolution == (1e-9, 1e-9, 1e-4)
    assert degrees.find_metric((8.7, 49.4, 0)) == "EPSG:32632"
    none, unknown = find_system(""), find_system("no system")
    assert not none.is_known and not none.problem and none.label == "none"
    assert "is not a coordinate system known to PROJ" in unknown.problem
    assert unknown.label == "no system" and len(find_system("x" * 500).label) < 70


def test_systems_are_compared_by_what_they_define():
    wkt = wkt_of(UTM)
    assert find_system(UTM).is_same(wkt) and find_system(wkt).is_same(UTM)
    assert find_difference(wkt, UTM) is None
    assert find_difference(UTM, "") is None
    both = wkt_of("EPSG:25832+7837")
    assert find_system(both).code == "EPSG:25832+7837"
    assert find_difference(both, "EPSG:25832+7837") is None
    assert find_difference(both, UTM) == (
        "EPSG:25832+7837 and EPSG:25832; convert one of them with vtkhelios convert "
        "--crs EPSG:25832+7837"
    )
    assert find_system("").is_same("") and not find_system("").is_same(UTM)


def wkt_of(text):
    system = vtkhelios.vtkHeliosCoordinateSystem()
    assert system.SetText(text)
    return system.GetWkt()


def test_heights_in_a_stated_unit():
    text = find_system("EPSG:2263").with_height_unit(1.0)
    assert find_system(text).height_unit == 1.0 and find_system(text).has_height_unit
    assert find_system(text).label == "EPSG:2263, heights in metre"
    with pytest.raises(ValueError, match="heights of ENU 49 8 0 have a fixed unit"):
        find_system("ENU 49 8 0").with_height_unit(1.0)


def test_metres():
    metres = Metres("EPSG:2263")
    assert np.allclose(metres.factors, SURVEY_FOOT) and "--height-unit" in metres.guess
    assert not Metres("EPSG:2263+5703").guess and not Metres("EPSG:2263", 1.0).guess
    assert Metres("EPSG:2263", 1.0).factors[2] == 1.0
    points = make_points(3)
    assert Metres(UTM).convert(points) is points and Metres("").is_identity
    assert "longitudes and latitudes (EPSG:4326)" in Metres("EPSG:4326").refuse_degrees((8, 49, 0))


# Every format


@pytest.mark.parametrize("ending", ENDINGS)
def test_degrees_keep_a_tenth_of_a_millimetre(run, tmp_path, ending):
    points = make_points()
    source, made, back = (tmp_path / name for name in ("a.las", f"b.{ending}", "c.las"))
    write(source, points, UTM)
    code, _, err = run("convert", source, made, "--crs", "EPSG:4326")
    if ending == "e57":  # which stores metres
        assert code == 1 and not made.exists()
        assert "E57 stores metres: its coordinates are longitudes and latitudes (EPSG:4326)" in err
        assert "vtkhelios convert --crs EPSG:32632" in err
        return
    assert code == 0, err
    degrees, reader = read(made)
    assert len(np.unique(degrees, axis=0)) == len(points)
    assert np.abs(degrees[:, :2] - [8.697, 49.4095]).max() < 0.001
    if ending == "xyz":  # has no coordinate system
        write(made.with_suffix(".vtp"), degrees, "EPSG:4326")
        made = made.with_suffix(".vtp")
    else:
        assert find_system(reader.header.crs).code == "EPSG:4326"
    assert run("convert", made, back, "--crs", UTM)[0] == 0
    assert np.abs(sort(read(back)[0]) - sort(points)).max() < 2e-4


def test_degrees_of_a_las_file_stay_where_they_are(run, tmp_path):
    laspy = pytest.importorskip("laspy")
    head = laspy.LasHeader(point_format=6, version="1.4")
    head.scales, head.offsets = [1e-7, 2e-8, 0.01], [8.5123, 49.25, 0.125]
    las = laspy.LasData(head)
    points = make_points()
    las.x, las.y, las.z = 8.7 + points[:, 0] % 1 / 1e3, 49.4 + points[:, 1] % 1 / 1e3, points[:, 2]
    las.write(tmp_path / "a.las")
    for ending in ("copc.laz", "vtp"):
        assert run("convert", tmp_path / "a.las", tmp_path / f"b.{ending}")[0] == 0
        assert np.array_equal(
            sort(read(tmp_path / f"b.{ending}")[0]), sort(read(tmp_path / "a.las")[0])
        )
    copc = laspy.open(tmp_path / "b.copc.laz").header  # value that laspy reads
    assert copc.scales.tolist() == [1e-7, 2e-8, 0.01] and copc.offsets[0] == 8.5123
    code, _, _ = run("convert", tmp_path / "b.vtp", tmp_path / "c.xyz")
    text = (tmp_path / "c.xyz").read_text().split()
    assert (
        code == 0 and re.fullmatch(r"8\.7\d{8}", text[0]) and re.fullmatch(r"49\.4\d{8}", text[1])
    )


@pytest.mark.parametrize("ending", ENDINGS)
def test_feet_stay_feet_in_files(run, tmp_path, ending):
    """E57 stores metres, and gives the units of the system back."""
    points = np.round(make_plane(SURVEY_FOOT, SURVEY_FOOT)[0], 4)
    write(tmp_path / f"a.{ending}", points, "EPSG:2263")
    back, reader = read(tmp_path / f"a.{ending}")
    tolerance = 2e-3 if ending == "pcd" else 1e-4
    assert np.abs(sort(back) - sort(points)).max() < tolerance
    if ending == "xyz":
        return
    assert find_system(reader.header.crs).code == "EPSG:2263"
    assert (
        run("convert", tmp_path / f"a.{ending}", tmp_path / "b.vtp", "--crs", "EPSG:32618")[0] == 0
    )
    heights = sort(read(tmp_path / "b.vtp")[0])[:, 2]
    assert np.allclose(heights.mean(), points[:, 2].mean() * SURVEY_FOOT, atol=1e-3)


def test_e57_stores_metres(tmp_path):
    pye57 = pytest.importorskip("pye57")
    points, _ = make_plane(SURVEY_FOOT, 1.0)
    write(tmp_path / "a.e57", points, "EPSG:2263+5703")
    scan = pye57.E57(str(tmp_path / "a.e57")).read_scan(0, ignore_missing_fields=True)
    stored = np.column_stack([scan[f"cartesian{axis}"] for axis in "XYZ"])
    assert np.allclose(sort(stored), sort(points * [SURVEY_FOOT, SURVEY_FOOT, 1.0]), atol=1e-6)


JUNK = "a page of no WKT"


@pytest.mark.parametrize("ending", [end for end in ENDINGS if end != "xyz"])
def test_a_record_that_is_no_system_is_ignored(run, tmp_path, ending):
    path = write(tmp_path / f"a.{ending}", make_points(50), UTM)
    if ending in ("las", "laz", "copc.laz"):
        data = path.read_bytes()
        at = data.index(b"PROJCS[")
        path.write_bytes(data[:at] + JUNK.encode() + b"\0" + data[at + len(JUNK) + 1 :])
    else:
        make_junk(path, ending)
    points, reader = read(path)
    assert reader.header.crs == "" and len(points) == 50
    notes = [note for note in reader.notes if "coordinate system is not known" in note]
    assert len(notes) == 1 and "known to PROJ" in notes[0] and str(path) in notes[0]
    code, _, err = run("convert", path, tmp_path / "b.copc.laz")
    assert code == 0 and "not known and is ignored" in err
    assert run("convert", path, tmp_path / "c.las", "--crs", "EPSG:2180")[0] == 0
    assert find_system(read(tmp_path / "c.las")[1].header.crs).code == "EPSG:2180"


def make_junk(path, ending):
    """Writes a file whose coordinate system is no WKT."""
    if ending == "e57":
        libe57 = pytest.importorskip("pye57").libe57
        write(path, make_points(50))
        image = libe57.ImageFile(str(path.with_suffix(".new")), "w")
        image.close()
        header = formats.Header()
        header.crs = JUNK
        with formats.open_writer(path, header) as writer:
            writer.write({"points": make_points(50)})
        return
    header = formats.Header()
    header.crs = JUNK
    with formats.open_writer(path, header) as writer:
        writer.write({"points": make_points(50)})


# Commands


def test_merge_compares_systems(run, tmp_path):
    wkt2 = wkt2_of_utm()
    write(tmp_path / "a.vtp", make_points(10), UTM)
    write(tmp_path / "b.vtp", make_points(10), wkt2)
    write(tmp_path / "c.vtp", make_points(10), "EPSG:25833")
    code, _, err = run(
        "convert", "--merge", tmp_path / "a.vtp", tmp_path / "b.vtp", tmp_path / "m.las"
    )
    assert code == 0 and len(read(tmp_path / "m.las")[0]) == 20, err
    code, _, err = run(
        "convert", "--merge", tmp_path / "b.vtp", tmp_path / "c.vtp", tmp_path / "n.las"
    )
    assert code == 1 and "has the coordinate system EPSG:25833, and" in err and "EPSG:25832;" in err


def wkt2_of_utm():
    """WKT 2 of EPSG:25832, as a text of this test."""
    return (
        'PROJCRS["ETRS89 / UTM zone 32N",BASEGEOGCRS["ETRS89",DATUM["European Terrestrial '
        'Reference System 1989",ELLIPSOID["GRS 1980",6378137,298.257222101]],ID["EPSG",4258]],'
        'CONVERSION["UTM zone 32N",METHOD["Transverse Mercator",ID["EPSG",9807]],'
        'PARAMETER["Latitude of natural origin",0,ANGLEUNIT["degree",0.0174532925199433]],'
        'PARAMETER["Longitude of natural origin",9,ANGLEUNIT["degree",0.0174532925199433]],'
        'PARAMETER["Scale factor at natural origin",0.9996,SCALEUNIT["unity",1]],'
        'PARAMETER["False easting",500000,LENGTHUNIT["metre",1]],'
        'PARAMETER["False northing",0,LENGTHUNIT["metre",1]]],CS[Cartesian,2],'
        'AXIS["easting (E)",east,LENGTHUNIT["metre",1]],'
        'AXIS["northing (N)",north,LENGTHUNIT["metre",1]],ID["EPSG",25832]]'
    )


def test_merge_moves_every_input_from_its_own_system(run, tmp_path):
    points = make_points(50)
    write(tmp_path / "a.vtp", points, UTM)
    write(tmp_path / "b.vtp", points, "EPSG:25833")
    write(tmp_path / "c.vtp", points)  # in the system of --crs
    inputs = [tmp_path / f"{name}.vtp" for name in "abc"]
    code, _, err = run("convert", "--merge", *inputs, tmp_path / "m.vtp", "--crs", "EPSG:25833")
    assert code == 0, err
    made = read(tmp_path / "m.vtp")[0]
    assert np.array_equal(made[50:100], points) and np.array_equal(made[100:], points)
    assert np.abs(made[:50, 0] - 45000).max() < 5000  # 6 degrees to the west
    assert run("convert", tmp_path / "a.vtp", tmp_path / "d.vtp", "--crs", "EPSG:25833")[0] == 0
    assert np.array_equal(read(tmp_path / "d.vtp")[0], made[:50])


def test_merged_points_keep_the_finest_steps(run, tmp_path):
    laspy = pytest.importorskip("laspy")
    for name, scale in (("a", 0.01), ("b", 0.001)):
        head = laspy.LasHeader(point_format=6, version="1.4")
        head.scales, head.offsets = [scale] * 3, [478000.005, 5473000, 0]
        las = laspy.LasData(head)
        las.x, las.y, las.z = make_points(40).T
        las.write(tmp_path / f"{name}.las")
    code, _, err = run(
        "convert", "--merge", tmp_path / "a.las", tmp_path / "b.las", tmp_path / "m.las"
    )
    assert code == 0, err
    both = np.concatenate([read(tmp_path / f"{name}.las")[0] for name in "ab"])
    assert np.abs(read(tmp_path / "m.las")[0] - both).max() < 0.6e-4


def test_the_pose_of_a_scan_moves_with_its_points(run, tmp_path):
    pytest.importorskip("pye57")
    header = formats.Header()
    header.crs = UTM
    scan = formats.Scan("s", (478000.0, 5473000.0, 102.0), (1.0, 0.0, 0.0, 0.0), True)
    with formats.open_writer(tmp_path / "a.e57", header) as writer:
        writer.begin(scan)
        writer.write({"points": make_points(40)})
    assert run("convert", tmp_path / "a.e57", tmp_path / "b.e57", "--crs", "EPSG:25833")[0] == 0
    write(tmp_path / "p.vtp", [scan.translation], UTM)
    run("convert", tmp_path / "p.vtp", tmp_path / "q.vtp", "--crs", "EPSG:25833")
    moved = read(tmp_path / "b.e57")[1].scans[0]
    assert np.abs(np.array(moved.translation) - read(tmp_path / "q.vtp")[0][0]).max() < 1e-6
    angle = 2 * np.degrees(np.arctan2(moved.rotation[3], moved.rotation[0]))
    convergence = 6 * np.sin(np.radians(49.4))  # convergence of two meridians 6 degrees apart
    assert abs(abs(angle) - convergence) < 0.02


@pytest.mark.parametrize(
    ("crs", "height_unit", "guess"),
    [("EPSG:6539", SURVEY_FOOT, True), ("EPSG:6539+6360", SURVEY_FOOT, False),
     ("EPSG:6539+5703", 1.0, False), ("EPSG:32118", 1.0, False)],
)  # fmt: skip
def test_measures_are_in_metres(run, tmp_path, crs, height_unit, guess):
    points, arrays = make_plane(find_system(crs).unit, height_unit)
    path = write(tmp_path / "a.las", points, crs, **arrays)
    code, out, err = run("compare", path, path, "--json")
    assert code == 0 and ("--height-unit" in err) == guess
    rows = {row["metric"]: row["a"] for row in json.loads(out)["metrics"]}
    assert rows["noise of planes, RMS"] == pytest.approx(0.020, abs=0.0005)
    assert rows["density"] == pytest.approx(7.4, abs=0.8)  # cells at the border are not full
    code, out, err = run("info", path, "--json")
    facts = json.loads(out)
    assert facts["density_m2"] == pytest.approx(7.4, abs=0.4)
    assert facts["unit_m"] == find_system(crs).unit
    assert facts["heightUnit_m"] == pytest.approx(height_unit, rel=1e-12)
    assert any("--height-unit" in warning for warning in facts["warnings"]) == guess
    code, out, _ = run("info", path)
    assert re.search(r"\nspacing    about 0\.3[67]\d? m, in plan view: 7\.\d+ points/m²", out)
    assert f" {'m' if height_unit == 1 else 'us-ft'}\n" in re.search(r"\nz  .*\n", out)[0]


def test_heights_of_an_option(run, tmp_path):
    points, arrays = make_plane(SURVEY_FOOT, 1.0)
    path = write(tmp_path / "a.las", points, "EPSG:6539", **arrays)
    code, out, err = run("compare", path, path, "--json", "--height-unit", "m")
    rows = {row["metric"]: row["a"] for row in json.loads(out)["metrics"]}
    assert code == 0 and rows["noise of planes, RMS"] == pytest.approx(0.020, abs=0.0005)
    assert run("convert", path, tmp_path / "b.las", "--height-unit", "m")[0] == 0
    assert find_system(read(tmp_path / "b.las")[1].header.crs).height_unit == 1.0
    run("convert", path, tmp_path / "c.las", "--crs", "EPSG:32618", "--height-unit", "m")
    assert np.allclose(read(tmp_path / "c.las")[0][:, 2].mean(), points[:, 2].mean(), atol=1e-3)
    code, _, err = run("convert", path, tmp_path / "d.las", "--height-unit", "mile")
    assert code == 2 and "'mile' is no unit of heights: m, ft, us-ft, or its metres" in err
    local = write(tmp_path / "e.vtp", make_points(10), "ENU 49 8 0")
    code, _, err = run("convert", local, tmp_path / "f.las", "--height-unit", "ft")
    assert code == 1 and "heights of ENU 49 8 0 have a fixed unit; leave --height-unit out" in err


def test_degrees_are_not_measured(run, tmp_path):
    path = write(tmp_path / "a.las", [[8.7, 49.4, 100], [8.70001, 49.40001, 101]], "EPSG:4326")
    for command in (["compare", path, path], ["view", path, "--html", tmp_path / "x.html"]):
        code, _, err = run(*command)
        assert code == 1 and "its coordinates are longitudes and latitudes (EPSG:4326)" in err
        assert "vtkhelios convert --crs EPSG:32632" in err
    code, out, err = run("info", path)
    assert code == 0 and "spacing" not in out and "8.70000000 to 8.70001000 deg" in out
    assert "spacing and density are not measured: its coordinates are longitudes" in err


def test_epochs(run, tmp_path):
    """ITRF2014 moves against ETRS89 by the motion of Eurasia: 2.5 cm a year."""
    place = np.array([[8.44, 49.32, 150.0]] * 20)
    path = write(tmp_path / "a.vtp", place, "EPSG:7912")
    places = {}
    for name, more in {
        "none": [], "2010": ["--epoch", "2010"], "2026": ["--epoch", "2026"]
    }.items():  # fmt: skip
        code, _, err = run("convert", path, tmp_path / f"{name}.vtp", "--crs", UTM, *more)
        assert code == 0 and ("move by 2.5 cm a year" in err) == (name == "none"), err
        places[name] = read(tmp_path / f"{name}.vtp")[0][0]
    assert np.hypot(*(places["2026"] - places["2010"])[:2]) == pytest.approx(0.40, abs=0.02)
    assert np.abs(places["none"] - places["2010"]).max() < 0.3
    header = formats.Header()
    header.crs, header.epoch = "EPSG:7912", 1e9  # adjusted standard time
    with formats.open_writer(tmp_path / "b.las", header) as writer:
        writer.write({"points": place, "GpsTime": np.full(20, 4.5199e8)})  # beginning of 2026
    code, _, err = run("convert", tmp_path / "b.las", tmp_path / "c.vtp", "--crs", UTM)
    assert code == 0 and "epoch" not in err
    assert np.abs(read(tmp_path / "c.vtp")[0][0] - places["2026"]).max() < 2e-3
