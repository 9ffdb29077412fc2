# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Areas of flight plans: the same polygon in every form, and errors that name place and value."""

import json

import numpy as np
import pytest
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from vtkhelios.plans.kinds import SettingError
from vtkhelios.flight._area import box_area, contains, measure, read_area, to_polydata

CORNERS = [(0.0, 0.0), (10.0, 0.0), (10.5, 5.25), (0.0, 6.0)]
WKT = "POLYGON ((0 0, 10 0, 10.5 5.25, 0 6, 0 0))"


def as_vtp(path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(to_polydata([[np.array(CORNERS)]]))
    assert writer.Write()


def as_geojson(path):
    ring = [list(corner) for corner in [*CORNERS, CORNERS[0]]]
    geometry = {"type": "Polygon", "coordinates": [ring]}
    feature = {"type": "Feature", "properties": {}, "geometry": geometry}
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))


WRITERS = {
    "area.wkt": lambda path: path.write_text(WKT),
    "area.geojson": as_geojson,
    "area.txt": lambda path: path.write_text("# x y\n0 0\n10 0  # east\n\n10.5\t5.25\n0 6\n"),
    "area.csv": lambda path: path.write_text("0,0\n10, 0\n10.5;5.25\n0,6,99\n"),
    "area.vtp": as_vtp,
}


@pytest.mark.parametrize("name", WRITERS)
def test_every_file(name, tmp_path):
    WRITERS[name](tmp_path / name)
    [[ring]] = read_area(tmp_path / name)
    assert ring == pytest.approx(np.array(CORNERS))


def test_text_arrays_and_polydata():
    for area in (WKT, f"SRID=25832;{WKT}", CORNERS, to_polydata([[np.array(CORNERS)]])):
        [[ring]] = read_area(area)
        assert ring == pytest.approx(np.array(CORNERS))


def test_holes_and_several_polygons():
    area = read_area(
        "MULTIPOLYGON (((0 0, 10 0, 10 10, 0 10), (2 2, 2 4, 4 4, 4 2)), ((20 0, 21 0, 21 1, 20 1)))"
    )
    assert [len(rings) for rings in area] == [2, 1]
    assert measure(area) == pytest.approx(100 - 4 + 1)
    inside = contains(area, np.array([(1, 1), (3, 3), (20.5, 0.5), (15, 5), (-1, 1), (9.99, 9.99)]))
    assert inside.tolist() == [True, False, True, False, False, True]


def test_contains_as_a_formula():
    places = np.random.default_rng(1).uniform(-1, 3, (2000, 2))
    triangle = [[np.array([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)])]]
    x, y = places.T
    assert (contains(triangle, places) == ((x > 0) & (y > 0) & (x + y < 2))).all()
    assert measure(box_area((1, 2, 0), (4, 7, 9))) == 15


@pytest.mark.parametrize(
    ("area", "message"),
    [
        ("POLYGON ((0 0, 1 x, 1 1))", "vertex 1 is '1 x': expected x y"),
        ("POLYGON ((0 0, 1 1, 2 2))", "polygon 0 has no surface; give three or more corners"),
        ("POLYGON EMPTY", "is not a valid polygon in WKT: expected POLYGON"),
        ([(0, 0), (1, float("nan")), (1, 1)], "polygon 0 has a coordinate that is not finite"),
        ([(0, 0), (1, 1e300), (1, 1)], "or beyond 1e+09 m; correct it"),
        (
            "nowhere.txt",
            "nowhere.txt: cannot be read: No such file or directory; give a polygon in",
        ),
        ("rows.txt", "rows.txt:2: '3;x' is not a corner: expected x y"),
        ("broken.geojson", "broken.geojson: is not valid JSON"),
        ("empty.geojson", "empty.geojson: has no polygon"),
        ("words.geojson", "words.geojson: has coordinates that are not numbers"),
        ("deep.geojson", "deep.geojson: is nested too deeply; give a GeoJSON polygon"),
        ("collections.geojson", "collections.geojson: has no polygon"),
        ("large.geojson", "large.geojson: has coordinates that are not numbers"),
        ("number.geojson", "number.geojson: has coordinates that are not numbers"),
        ("without.geojson", "polygon 0 has no surface"),
    ],
)
def test_errors(area, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "rows.txt").write_text("0 0\n3;x\n")
    (tmp_path / "broken.geojson").write_text("{")
    (tmp_path / "deep.geojson").write_text("[" * 100_000)
    nested = '{"type": "GeometryCollection", "geometries": [' * 200 + "]}" * 200
    (tmp_path / "collections.geojson").write_text(nested)
    (tmp_path / "large.geojson").write_text(
        f'{{"type": "Polygon", "coordinates": [[[1{"0" * 400}, 1], [1, 1]]]}}'
    )
    (tmp_path / "number.geojson").write_text('{"type": "MultiPolygon", "coordinates": 5}')
    (tmp_path / "without.geojson").write_text('{"type": "Polygon", "coordinates": []}')
    (tmp_path / "empty.geojson").write_text('{"type": "FeatureCollection", "features": []}')
    (tmp_path / "words.geojson").write_text(
        '{"type": "Polygon", "coordinates": [[["a", 1], [1, 1]]]}'
    )
    with pytest.raises(SettingError) as error:
        read_area(area)
    assert message in str(error.value)


@pytest.mark.parametrize(
    "text", ["1" * 300_000 + "x 1", " " * 300_000 + "x", "POLYGON ((1 " + "1" * 300_000]
)
def test_long_texts_take_linear_time(text, tmp_path):
    """Quadratic time would be a quarter of an hour."""
    path = tmp_path / "area.txt"
    path.write_text(text)
    with pytest.raises(SettingError, match="is not a"):
        read_area(path)


@pytest.mark.parametrize("area", [7, [1, 2, 3], [["a", "b"]]])
def test_types(area):
    with pytest.raises(TypeError, match="area"):
        read_area(area)
