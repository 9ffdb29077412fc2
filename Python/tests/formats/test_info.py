# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios info: facts about files, runs and surveys, and their errors."""

import json
import shutil
import struct

import numpy as np
import pytest

from _point_files import write

from vtkhelios import cli, formats
from vtkhelios.cli._inspect import Inspection


@pytest.fixture
def info(capsys):
    """The facts of a path, and standard error."""

    def call(path, *options):
        capsys.readouterr()
        code = cli.main(["info", str(path), "--json", *map(str, options)])
        out, err = capsys.readouterr()
        return code, json.loads(out) if out else None, err

    return call


def read(path):
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks())
        return {name: np.concatenate([each[name] for each in chunks]) for name in chunks[0]}


def test_las(small_runs, info):
    pytest.importorskip("laspy")
    path = small_runs["las"] / "leg000_points.las"
    cloud = read(path)
    code, facts, _ = info(path)
    assert code == 0 and facts["warnings"] == []
    assert facts["format"] == "LAS 1.4, point format 9"
    assert facts["points"] == len(cloud["points"])
    assert facts["bounds"]["minimum"] == cloud["points"].min(axis=0).tolist()
    assert facts["bounds"]["maximum"] == cloud["points"].max(axis=0).tolist()
    times = facts["gpsTime_s"]
    assert [times["first"], times["last"]] == [cloud["GpsTime"].min(), cloud["GpsTime"].max()]
    counts = np.bincount(cloud["ReturnNumber"])
    assert facts["returns"] == {str(i): int(n) for i, n in enumerate(counts) if n}
    assert facts["legs"] == {"0": facts["points"]}
    assert "25832" in facts["crs"] and facts["gpsTimeKind"] == "not adjusted"
    amplitude = next(each for each in facts["arrays"] if each["name"] == "Amplitude")
    assert amplitude == {"name": "Amplitude", "type": "float64", "unit": "W", "components": 1}


def test_header_of_las(small_runs, info):
    pytest.importorskip("laspy")
    path = small_runs["las"] / "leg000_points.las"
    _, facts, _ = info(path)
    assert facts["scale"] == [1e-4] * 3 and facts["system"] == "SIMULATION"
    assert facts["waveforms"]["packets"].endswith("leg000_points.wdp")
    assert facts["waveforms"]["bytes"] == path.with_suffix(".wdp").stat().st_size - 60
    extra = {each["name"]: each["description"] for each in facts["extraBytes"]}
    assert extra["EchoWidth"] == "full width at half maximum [ns]"
    assert {"user": "LASF_Projection", "id": 2112}.items() <= facts["headerRecords"][0].items()


def test_extended_records(tmp_path, info, capsys):
    """The octree of COPC, and records of other programs in LAS, with their size and description."""
    laspy = pytest.importorskip("laspy")
    write(tmp_path / "a.copc.laz")
    _, facts, _ = info(tmp_path / "a.copc.laz")
    (record,) = facts["extendedRecords"]
    assert record == {"user": "copc", "id": 1000, "bytes": 32, "description": "EPT Hierarchy"}
    header = laspy.LasHeader(version="1.4", point_format=6)
    las = laspy.LasData(header)
    las.xyz = np.arange(30.0).reshape(10, 3)
    las.evlrs = laspy.vlrs.vlrlist.VLRList([laspy.VLR("theirs", 7, "a note", b"x" * 100)])
    las.write(tmp_path / "b.las")
    _, facts, _ = info(tmp_path / "b.las")
    (record,) = facts["extendedRecords"]
    assert record == {"user": "theirs", "id": 7, "bytes": 100, "description": "a note"}
    assert cli.main(["info", str(tmp_path / "b.las")]) == 0
    assert "extended   theirs 7, 100 bytes: a note\n" in capsys.readouterr().out


@pytest.mark.parametrize("spacing", [0.1, 0.5, 2.0])
def test_spacing(tmp_path, info, spacing):
    grid = np.indices((200, 200, 1)).reshape(3, -1).T * spacing
    with formats.open_writer(tmp_path / "a.ply") as writer:
        writer.write({"points": grid})
    _, facts, _ = info(tmp_path / "a.ply")
    assert facts["spacing_m"] == pytest.approx(spacing, rel=0.35)


@pytest.mark.parametrize("kind", ["las", "xyz", "vtp"])
def test_runs(small_runs, info, kind):
    summary = json.loads((small_runs[kind] / "run_summary.json").read_text())
    code, facts, _ = info(small_runs[kind])
    assert code == 0 and facts["warnings"] == []
    assert facts["points"] == summary["totals"]["points"]
    assert facts["legs"] == {str(leg["leg"]): leg["points"] for leg in summary["legs"]}
    assert facts["format"].startswith("run of 2 files of points")


def test_surveys(small_runs, info):
    survey = small_runs["las"].parents[1] / "survey.xml"
    code, facts, _ = info(survey)
    assert code == 0
    assert (facts["name"], facts["moving"], facts["epochs"]) == ("fence", False, 1)
    assert facts["scene"] == "fence" and "VZ-400" in facts["scanner"]
    assert [leg["position_m"] for leg in facts["legs"]] == [[0, 0, 2], [-8, 3, 2]]
    assert facts["legs"][0]["pulseFrequency_Hz"] == 100_000
    code, facts, _ = info(small_runs["las"].parents[1] / "scene.xml")
    assert code == 0 and "scene.xml" in facts["file"]


def test_as_text(small_runs, capsys):
    for path in (small_runs["xyz"], small_runs["las"].parents[1] / "survey.xml"):
        assert cli.main(["info", str(path)]) == 0
    out = capsys.readouterr().out
    assert "spacing    about" in out and "EchoWidth [ns] (float64)" in out
    assert "returns    1: " in out and "legs       0: " in out
    assert "leg 1      (-8.000, 3.000, 2.000) m, 100000 pulses/s, 100 lines/s" in out


def test_coordinates_and_their_system(small_runs, tmp_path, capsys):
    """To the millimetre, also of coordinates with seven digits, and of degrees."""
    assert cli.main(["info", str(small_runs["las"])]) == 0
    assert "crs        EPSG:25832 (ETRS89 / UTM zone 32N)" in capsys.readouterr().out
    for crs, points, expected in (
        ("EPSG:32632", [[478123.4567, 5471966.7891, 110.2344]],
         ["x          478123.457 to 478123.457 m", "y          5471966.789 to 5471966.789 m",
          "z          110.234 to 110.234 m", "crs        EPSG:32632 (WGS 84 / UTM zone 32N)"]),
        ("EPSG:4326", [[8.123456789, 49.5, 110.2344]],
         ["x          8.12345679 to 8.12345679 deg", "y          49.50000000 to 49.50000000 deg",
          "z          110.234 to 110.234 m", "crs        EPSG:4326 (WGS 84)"]),
        ("a local   grid", [[1, 2, 3]], ["x          1.000 to 1.000 m", "crs        not known"]),
    ):  # fmt: skip
        header = formats.Header()
        header.crs = crs
        with formats.open_writer(tmp_path / "a.vtp", header) as writer:
            writer.write({"points": np.array(points, float)})
        assert cli.main(["info", str(tmp_path / "a.vtp")]) == 0
        lines = capsys.readouterr().out.splitlines()
        assert [line for line in expected if line not in lines] == []


# Errors


@pytest.fixture
def broken(small_runs, tmp_path):
    """A LAS file with bytes of its header replaced: offset, format, value."""
    pytest.importorskip("laspy")

    def make(place, form, value):
        for ending in ("las", "wdp"):
            shutil.copy(small_runs["las"] / f"leg000_points.{ending}", tmp_path / f"a.{ending}")
        with open(tmp_path / "a.las", "r+b") as file:
            file.seek(place)
            file.write(struct.pack(form, value))
        return tmp_path / "a.las"

    return make


def test_wrong_boxes_and_counts(broken, info):
    _, facts, _ = info(broken(104, "<B", 9))  # unchanged
    highest, lowest = facts["bounds"]["maximum"][1], facts["bounds"]["minimum"][1]
    _, facts, _ = info(broken(195, "<d", highest + 2e-4))
    assert len(facts["warnings"]) == 1
    assert facts["warnings"][0].startswith("the maximum in the header is (")
    _, facts, _ = info(broken(203, "<d", lowest - 2e-4))
    assert facts["warnings"][0].startswith("the minimum in the header is (")
    _, facts, _ = info(broken(255, "<Q", 5))
    assert facts["warnings"][0].startswith("the header counts [5, ")


def test_waveforms_of_an_earlier_version(small_runs, tmp_path, info):
    path = tmp_path / "a.las"
    for ending in (".las", ".wdp"):
        shutil.copy(small_runs["las"] / f"leg000_points{ending}", path.with_suffix(ending))
    assert info(path)[1]["warnings"] == []
    said, before = b"waveform [W], to the scanner", b"waveform [W]"
    path.write_bytes(path.read_bytes().replace(said, before.ljust(len(said), b"\0")))
    (warning,) = info(path)[1]["warnings"]
    assert warning.startswith(f"{path}: an earlier version of vtkHelios wrote its waveforms")
    assert warning.endswith("vtkhelios convert inverts them")


def test_wrong_sizes(broken, info):
    code, _, err = info(broken(247, "<Q", 10**9))
    assert code == 1 and "that its header counts: it is cut off" in err
    code, _, err = info(broken(105, "<H", 20))
    assert code == 1 and "has points of 20 bytes; format 9 needs 59" in err


def test_unusual_points(tmp_path, info):
    with formats.open_writer(tmp_path / "a.ply") as writer:
        writer.write(
            {
                "points": np.array([[0, 0, 0], [1, 1, 1], [np.inf, 0, 0]]),
                "GpsTime": np.array([1.0, 3.0, 2.0]),
                "ReturnNumber": np.array([1, 3, 0], np.uint8),
                "NumberOfReturns": np.array([1, 2, 1], np.uint8),
            }
        )
    _, facts, _ = info(tmp_path / "a.ply")
    assert facts["warnings"] == [
        "1 point is not finite; vtkhelios convert --skip-invalid drops them",
        "1 point has a return number above their number of returns",
        "1 point has the return number 0",
        "GPS times decrease 1 times from point to point: points are not in order of measurement",
    ]


def test_distant_points(tmp_path, info):
    points = np.array([[0, 0, 0], [1e300, 0, 0], [3, 4, 5], [0, -1.7e308, 0]], float)
    with formats.open_writer(tmp_path / "a.ply") as writer:
        writer.write({"points": points})
    code, facts, err = info(tmp_path / "a.ply")
    assert code == 0 and facts["bounds"]["maximum"] == [1e300, 4.0, 5.0]
    assert facts["warnings"] == [
        "2 points are more than 1e+12 m from the origin; the spacing excludes them"
    ]
    with formats.open_writer(tmp_path / "b.ply") as writer:
        writer.write({"points": points[1:2]})
    assert info(tmp_path / "b.ply")[1]["spacing_m"] is None
    assert cli.main(["info", str(tmp_path / "b.ply")]) == 0


def test_impossible_numbers_in_arrays(tmp_path, info):
    with formats.open_writer(tmp_path / "a.ply") as writer:
        writer.write({
            "points": np.zeros((4, 3)), "GpsTime": np.array([np.nan, np.inf, -np.inf, 1e308]),
            "ReturnNumber": np.array([-1, 2**31 - 1, 1, 300], np.int32),
            "NumberOfReturns": np.array([1, 1, 1, 1], np.int32),
            "ClassificationIds": np.array([np.nan, 1e300, -5, 2]),
            "LegIds": np.array([0.5, np.nan, 1, 2]),
        })  # fmt: skip
    code, facts, err = info(tmp_path / "a.ply")
    assert code == 0 and "Traceback" not in err and "RuntimeWarning" not in err
    assert facts["returns"] == {"1": 1} and facts["legs"] == {}


def test_times_decreasing_between_chunks():
    inspection = Inspection("a")
    for first in (5.0, 7.0, 6.0, 8.0):
        inspection._add_times(np.array([first, first + 0.1]))
    assert inspection._backward == 1


def test_header_texts_that_are_not_utf8(small_runs, tmp_path, info):
    pytest.importorskip("laspy")
    path = tmp_path / "a.las"
    data = bytearray((small_runs["las"] / "leg000_points.las").read_bytes())
    data[26:32] = b"\xff\xfeABC\0"
    data[58:62] = b"\xe9t\xe9\0"
    path.write_bytes(data)
    shutil.copy(small_runs["las"] / "leg000_points.wdp", tmp_path / "a.wdp")
    code, facts, _ = info(path)
    assert code == 0
    assert facts["system"] == "??ABC" and facts["software"] == "?t?"


def test_point_files_missing_in_the_summary(tmp_path, info):
    for name in ("leg000_points.xyz", "leg001_points.xyz"):
        (tmp_path / name).write_text("1 2 3 1 4 1 1 0 0 0 0\n" * 5)
    legs = [{"leg": 0, "files": [{"name": "leg000_points.xyz", "records": 5}]}]
    (tmp_path / "run_summary.json").write_text(json.dumps({"legs": legs}))
    _, facts, _ = info(tmp_path)
    assert facts["points"] == 5
    assert len(facts["warnings"]) == 1
    assert (
        "leg001_points.xyz: is not read: run_summary.json does not list it" in facts["warnings"][0]
    )


def test_strips_with_names(tmp_path, info):
    for name in ("strip00a", "strip9999999999", "leg000"):
        (tmp_path / f"{name}_points.xyz").write_text("1 2 3 1 4 1 1 0 0 0 0\n" * 5)
    names = ("strip00a", "strip9999999999", "leg000", "leg000")
    files = [{"name": f"{name}_points.xyz", "records": 5} for name in names]
    (tmp_path / "run_summary.json").write_text(json.dumps({"legs": [{"leg": 0, "files": files}]}))
    _, facts, _ = info(tmp_path)
    assert facts["points"] == 15
    assert facts["legs"] == {"-1": 10, "0": 5}


def test_strips(tmp_path, info):
    """Legs that share a file count their points together."""
    (tmp_path / "strip004_points.xyz").write_text("1 2 3 1 4 1 1 0 0 0 0\n" * 5)
    legs = [
        {"leg": k, "files": [{"name": "strip004_points.xyz", "records": 2 + 3 * k}]} for k in (0, 1)
    ]
    (tmp_path / "run_summary.json").write_text(json.dumps({"legs": legs}))
    _, facts, _ = info(tmp_path)
    assert facts["points"] == 5 and facts["legs"] == {"4": 5} and facts["warnings"] == []


def test_wrong_names(tmp_path, info):
    code, _, err = info(tmp_path / "none.las")
    assert code == 1 and "none.las: no such file or folder; check its name" in err
    (tmp_path / "a.dat").write_text("")
    code, _, err = info(tmp_path / "a.dat")
    assert code == 1 and "a.dat: its ending is not of a known format" in err
