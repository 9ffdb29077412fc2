# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios plan: files for maps and receivers, as GDAL reads them; candidates from files; the page."""

import base64
import csv
import json
import re
from xml.etree import ElementTree

import numpy as np
import pytest

import vtkhelios
from vtkhelios.cli import main
from vtkhelios.reports.flight import describe_step
from vtkhelios.reports.map_marks import describe_length, round_length

EAST, NORTH, SIZE = 500100.0, 5480000.0, 40.0
TRIPODS = ["--grid", "10", "--order", "walk", "--no-picture"]
FLIGHT = [
    "--als",
    "--scanner",
    "copter_uls",
    "--flying-height",
    "50",
    "--density",
    "6",
    "--no-picture",
]
ALL = ["csv", "dxf", "geojson", "gpx", "kml"]
SCENE = """\
<document><scene id="field" {crs}><part><filter type="objloader">
  <param type="string" key="filepath" value="field.obj"/></filter></part></scene></document>
"""


def write_wall(path, east=EAST, north=NORTH):
    """Ground with a wall, so that two scans are needed."""
    lines = [
        f"v {east + x} {north + y} 100" for x, y in ((0, 0), (SIZE, 0), (SIZE, SIZE), (0, SIZE))
    ]
    middle = east + SIZE / 2 + 1
    lines += [
        f"v {middle} {north + y} {z}" for y, z in ((0, 100), (SIZE, 100), (SIZE, 104), (0, 104))
    ]
    path.write_text("\n".join([*lines, "f 1 2 3 4", "f 5 6 7 8"]) + "\n")


@pytest.fixture
def plan(tmp_path, capsys, monkeypatch):
    """Plans in a folder with field.obj and field.xml; returns exit code, report and standard error."""
    monkeypatch.chdir(tmp_path)
    write_wall(tmp_path / "field.obj")
    (tmp_path / "field.xml").write_text(SCENE.format(crs='crs="EPSG:25832"'))

    def call(*arguments):
        code = main(["plan", *map(str, arguments), "--json"])
        said = capsys.readouterr()
        return code, json.loads(said.out) if said.out else None, said.err

    return call


def to_degrees(places):
    """Longitudes and latitudes by PROJ."""
    osr = pytest.importorskip("osgeo.osr")
    systems = []
    for code in (25832, 4326):
        system = osr.SpatialReference()
        system.ImportFromEPSG(code)
        system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        systems.append(system)
    move = osr.CoordinateTransformation(*systems)
    return np.array(
        [move.TransformPoint(float(x), float(y))[:2] for x, y in np.asarray(places)[:, :2]]
    )


def read_layer(path, layer=0):
    """The geometries of a layer as GDAL reads them: their type, points, and fields."""
    gdal = pytest.importorskip("osgeo.gdal")
    file = gdal.OpenEx(str(path), gdal.OF_VECTOR)
    assert file, path
    found = []
    for feature in file.GetLayer(layer):
        shape = feature.GetGeometryRef()
        inner = shape.GetGeometryRef(0) if shape.GetGeometryName() == "POLYGON" else shape
        points = [inner.GetPoint(i) for i in range(inner.GetPointCount())]
        found.append((shape.GetGeometryName(), np.array(points), feature.items()))
    return found


def test_tripods_in_every_format(plan, tmp_path):
    code, report, said = plan("field.xml", *TRIPODS)
    assert code == 0 and "geojson, kml" not in said, said
    folder = tmp_path / "output/field"
    assert sorted(path.suffix[1:] for path in folder.glob("positions.*")) == sorted([*ALL, "vtp"])
    ground = np.array([[row["x"], row["y"], row["z"] - 1.7] for row in report["positions"]])
    assert len(ground) >= 2 and report["crs"] == "EPSG:25832"
    assert ground[:, 2] == pytest.approx(100)
    with open(folder / "positions.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["crs"] for row in rows} == {"EPSG:25832"}
    names = ("x [m]", "y [m]", "ground z [m]")
    assert np.array([[float(row[name]) for name in names] for row in rows]) == pytest.approx(
        ground, abs=6e-4
    )
    wanted = to_degrees(ground)
    for kind in ("geojson", "kml", "gpx"):
        points = [each for each in read_layer(folder / f"positions.{kind}") if each[0] == "POINT"]
        assert np.abs(np.array([at[0, :2] for _, at, _ in points]) - wanted).max() < 1e-9, kind
        labels = [fields.get("name") or fields["Name"] for *_, fields in points]
        assert labels == [f"scan {i}" for i in range(len(ground))]
    drawn = read_layer(folder / "positions.dxf")
    points = [at[0] for name, at, fields in drawn if name == "POINT" and not fields["Text"]]
    assert np.array(points) == pytest.approx(ground, abs=1e-4)
    texts = [fields["Text"] for *_, fields in drawn if fields["Text"]]
    assert texts == [f"scan {i}" for i in range(len(ground))]
    route = read_layer(folder / "positions.gpx", "routes")
    assert np.abs(route[0][1][:, :2] - wanted).max() < 1e-9
    assert [
        fields["name"] for *_, fields in read_layer(folder / "positions.gpx", "route_points")
    ] == texts


def test_lines_in_every_format(plan, tmp_path):
    code, report, said = plan("field.xml", *FLIGHT, "--terrain-following")
    assert code == 0, said
    folder = tmp_path / "output/field_als"
    text = json.loads((folder / "lines.geojson").read_text())
    assert "crs" not in text
    *lines, (kind, ring, _) = read_layer(folder / "lines.geojson")
    assert len(lines) == len(report["lines"]) and kind == "POLYGON"
    x, y = (ring[:-1, :2] - ring[0, :2]).T
    assert np.dot(x, np.roll(y, -1)) > np.dot(np.roll(x, -1), y)  # counterclockwise
    corners = [
        (EAST, NORTH),
        (EAST + SIZE, NORTH),
        (EAST + SIZE, NORTH + SIZE),
        (EAST, NORTH + SIZE),
    ]
    assert np.abs(ring[:-1, :2] - to_degrees(corners)).max() < 1e-9
    ends = np.array([[row["begin"], row["end"]] for row in report["lines"]])
    wanted = to_degrees(ends.reshape(-1, 3)).reshape(-1, 2, 2)
    for name in ("geojson", "kml"):
        for (kind, places, _), end in zip(read_layer(folder / f"lines.{name}")[:-1], wanted):
            assert kind == "LINESTRING" and np.abs(places[[0, -1], :2] - end).max() < 1e-9
    heights = [places[:, 2] for _, places, _ in read_layer(folder / "lines.kml")[:-1]]
    assert [z[0] for z in heights] == pytest.approx(ends[:, 0, 2], abs=6e-4)
    (_, route, _), *_ = read_layer(folder / "lines.gpx", "routes")
    assert np.abs(route[[0, -1], :2] - wanted[[0, -1], [0, 1]]).max() < 1e-9
    drawn = [each for each in read_layer(folder / "lines.dxf") if each[0] == "LINESTRING"]
    assert np.array([at[[0, -1]] for _, at, _ in drawn[:-1]]) == pytest.approx(ends, abs=1e-4)
    assert drawn[-1][1][0] == pytest.approx(drawn[-1][1][-1])  # the area is closed
    for path in (folder / "lines.kml", folder / "lines.gpx"):
        ElementTree.parse(path)


def test_a_scene_without_a_system(plan, tmp_path, capsys):
    assert main(["plan", "field.obj", *TRIPODS]) == 0
    said = " ".join(capsys.readouterr().out.split())
    folder = tmp_path / "output/field"
    assert not list(folder.glob("positions.[gk]*")) and (folder / "positions.dxf").exists()
    assert (
        "no geojson, kml, gpx: these need degrees, and the coordinate system of the scene is not stated; "
        "give --crs, such as --crs EPSG:25832" in said
    )
    code, report, said = plan("field.obj", *TRIPODS, "--overwrite")
    assert code == 0 and report["crs"] is None and not said
    said = plan("field.obj", *TRIPODS, "--geo", "kml", "--overwrite")[2]
    assert said.count("warning: no kml: these need degrees") == 1
    code, report, said = plan(
        "field.obj", *TRIPODS, "--crs", "EPSG:25832", "--geo", "GPX,csv", "--overwrite"
    )
    assert code == 0 and report["crs"] == "EPSG:25832" and "these need" not in said
    assert sorted(path.name for path in folder.glob("positions.*")) == [
        "positions.csv", "positions.gpx", "positions.vtp"
    ]  # fmt: skip
    assert plan("field.obj", *TRIPODS, "--geo", "none", "--overwrite")[0] == 0
    assert [path.name for path in folder.glob("positions.*")] == ["positions.vtp"]
    for more in (TRIPODS, FLIGHT):
        code, _, said = plan("field.xml", *more, "--geo", "shp")
        assert (
            code == 1 and "--geo has 'shp'; known: csv, geojson, kml, dxf, gpx, all, none" in said
        )


def test_in_python(tmp_path):
    write_wall(tmp_path / "field.obj")
    made = vtkhelios.plan(tmp_path / "field.obj", grid=10, crs="EPSG:25832", name="a")
    assert {path.name for path in made.write(tmp_path, geo=["gpx"])} & {
        "positions.gpx",
        "positions.csv",
    } == {"positions.gpx"}
    without = vtkhelios.plan(tmp_path / "field.obj", grid=10, name="b")
    with pytest.warns(RuntimeWarning, match="no gpx: these need degrees"):
        without.write(tmp_path, geo="gpx")
    flight = vtkhelios.plan_flight(
        tmp_path / "field.obj", scanner="copter_uls", flying_height=50, density=4, name="c"
    )
    with pytest.warns(RuntimeWarning, match="no kml: these need degrees"):
        flight.write(tmp_path, geo="kml")


@pytest.mark.parametrize("kind", [TRIPODS, FLIGHT])
@pytest.mark.parametrize(
    ("crs", "message"),
    [
        ("EPSG:32633", "--crs is EPSG:32633, and the scene is in EPSG:25832; leave it out"),
        (
            "EPSG:4326",
            "--crs EPSG:4326: has units of degrees; a scene has metres: give a system in",
        ),
        ("EPSG:99999999", "--crs "),
    ],
)
def test_systems_that_are_refused(plan, tmp_path, kind, crs, message):
    code, _, said = plan("field.xml", *kind, "--crs", crs)
    assert code == 1 and message in said, said
    assert not (tmp_path / "output").exists() or not list((tmp_path / "output").rglob("*.xml"))


# Candidates and areas.


def test_candidates_of_a_file(plan, tmp_path, capsys):
    (tmp_path / "spots.csv").write_text(
        "name;Easting [m];Northing [m];z\n"
        f"a;{EAST + 5};{NORTH + 7};\nb;{EAST + 35};{NORTH + 9};100\n\nfar;{EAST + 99};{NORTH};\n"
    )
    assert main(["plan", "field.xml", *TRIPODS, "--candidates", "spots.csv"]) == 0
    assert "without 1 place of --candidates" in capsys.readouterr().out
    report = plan("field.xml", *TRIPODS, "--candidates", "spots.csv", "--overwrite")[1]
    assert report["places"] == 3 and report["candidates"] == 2
    found = sorted((row["x"] - EAST, row["y"] - NORTH, row["z"]) for row in report["positions"])
    assert np.array(found) == pytest.approx(np.array([(5, 7, 101.7), (35, 9, 101.7)]))
    # The files of a plan are candidates of the next one.
    for kind in ("csv", "geojson"):
        again = plan(
            "field.xml",
            *TRIPODS,
            "--candidates",
            f"output/field/positions.{kind}",
            "--output",
            kind,
        )
        assert again[0] == 0, again[2]
        rows = sorted(
            (row["x"] - EAST, row["y"] - NORTH, row["z"]) for row in again[1]["positions"]
        )
        assert np.array(rows) == pytest.approx(np.array(found), abs=2e-5)


def test_candidates_in_a_region(plan, tmp_path):
    (tmp_path / "spots.csv").write_text(f"x,y\n{EAST + 5},{NORTH + 7}\n{EAST + 35},{NORTH + 9}\n")
    region = ["--region", EAST, EAST + 20, NORTH, NORTH + 20]
    report = plan("field.xml", *TRIPODS, "--candidates", "spots.csv", *region)[1]
    assert report["candidates"] == 1 and report["testPoints"] == 20
    limited = plan("field.xml", *TRIPODS, *region, "--region-of", "all", "--overwrite")[1]
    assert limited["testPoints"] == 4 and limited["settings"]["regionOf"] == "all"


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.csv", "", "a.csv:1: has no column x (x, e, east, "),
        ("a.csv", "x,z\n1,2\n", "a.csv:1: has no column y (y, n, north, "),
        ("a.csv", "x,y\n", "a.csv: has no place; give one or more"),
        ("a.csv", "x,y\n1,2\n3,left\n", "a.csv:3: y is 'left'; give a number"),
        ("a.csv", "x,y\n1\n", "a.csv:2: y is ''; give a number"),
        ("a.csv", "x,y\n1,inf\n", "a.csv:2: y is 'inf'; give a number"),
        ("a.geojson", "{", "a.geojson: is not valid JSON"),
        (
            "a.geojson",
            '{"type": "Point", "coordinates": ["1", true]}',
            "coordinates that are not numbers",
        ),
        ("a.geojson", '{"type": "Point", "coordinates": [1]}', "coordinates that are not numbers"),
        ("a.geojson", '{"type": "Point", "coordinates": null}', "coordinates that are not numbers"),
        ("a.geojson", '{"type": "FeatureCollection", "features": []}', "a.geojson: has no place"),
        ("a.csv", b"x,y\n\xff\xfe\n", "a.csv: cannot be read: is not a text in UTF-8"),
        (
            "a.dxf",
            "",
            "a.dxf: is not CSV or GeoJSON; give a .csv with names of columns, or a .geojson",
        ),
        ("a.csv", "x,y\n1,2\n", "move the places onto the scene, or give other places"),
    ],
)
def test_wrong_candidates(plan, tmp_path, name, text, message):
    (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    code, _, said = plan("field.xml", *TRIPODS, "--candidates", name)
    assert code == 1 and message in said and said.count("error:") == 1, said


def test_an_area_in_degrees(plan, tmp_path):
    area = f"POLYGON (({EAST + 5} {NORTH + 5}, {EAST + 35} {NORTH + 5}, {EAST + 35} {NORTH + 30}))"
    code, first, said = plan("field.xml", *FLIGHT, "--area", area)
    assert code == 0, said
    code, second, said = plan(
        "field.xml", *FLIGHT, "--area", "output/field_als/lines.geojson", "--output", "again"
    )
    assert code == 0, said
    assert second["predicted"]["area_m2"] == pytest.approx(first["predicted"]["area_m2"], abs=1e-3)
    for mine, other in zip(first["lines"], second["lines"], strict=True):
        assert mine["begin"] == pytest.approx(other["begin"], abs=1e-3)


# The page.


def test_the_page_of_tripods(plan, tmp_path, read_pixels):
    pytest.importorskip("jinja2")
    pytest.importorskip("matplotlib")
    code, report, said = plan(
        "field.xml", *TRIPODS[:-1], "--setup-time", 240, "--walking-speed", 0.5
    )
    assert code == 0, said
    page = (tmp_path / "output/field/plan.html").read_text()
    maps = re.findall(r'data:image/png;base64,([^"]+)', page)
    assert len(maps) == 2
    for number, coded in enumerate(maps):
        (tmp_path / f"{number}.png").write_bytes(base64.b64decode(coded))
        pixels = read_pixels(tmp_path / f"{number}.png")
        assert (pixels[:, [0, 1, -2, -1]] == 255).all()  # labels and legend are whole
    text = re.sub("<[^>]*>", " ", page.partition("</style>")[2].replace('src="data:[^"]*"', ""))
    for words in ("EPSG:25832 (ETRS89 / UTM zone 32N)", "ground z [m]", "4 min 00 s for each of", "0.5 m/s",
                  "N is grid north", "Steepest ground for a tripod"):  # fmt: skip
        assert words in text, words
    assert not re.search(r"\d\.\d{5}|_(deg|m|Hz)\b|1,000,000,000", text)
    times = report["times"]
    count = len(report["positions"])
    assert times["setup_s"] == 240 * count
    places = np.array([(row["x"], row["y"], row["z"]) for row in report["positions"]])
    way = np.linalg.norm(np.diff(places, axis=0), axis=1).sum()
    assert times["travel_s"] == pytest.approx(2 * way)
    assert times["total_s"] == pytest.approx(times["setup_s"] + times["scan_s"] + times["travel_s"])
    run = vtkhelios.read_survey(tmp_path / "output/field/survey.xml")
    settings = report["scan"]
    assert times["scan_s"] == pytest.approx(count * 360 / settings["headRotatePerSec_deg"]), len(
        run.legs
    )


@pytest.mark.parametrize(
    ("most", "length", "text"),
    [(30, 20, "20 m"), (99.9, 50, "50 m"), (1200, 1000, "1 km"), (0.3, 0.2, "0.2 m")],
)
def test_scale_bars_have_round_lengths(most, length, text):
    assert round_length(most) == pytest.approx(length) and describe_length(length) == text


def test_steps_are_described():
    step = dict(pulseFrequency_Hz=2e5, flyingHeight_m=80.04, speed_m_s=10.63, strip_1_m2=8.0, time_s=153.2,
                timeFactor=1.36, pulsesFactor=0.711)  # fmt: skip
    assert describe_step(step) == (
        "200 kHz: 2 min 33 s (36 % more time), 10.6 m/s, 80 m above ground, a strip of at least 8 pulses/m² "
        "(29 % fewer pulses)"
    )
    assert "(the same time)" in describe_step({**step, "timeFactor": 1.001})
    assert describe_step({"reason": "no lower"}) == "no lower"
