# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios leafarea: runs, PTX, E57, LAS with trajectories; files; errors."""

import csv
import json

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli

DENSITY = 1.2
SURVEY = """\
<document>
  <survey name="s" scene="#s" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls">
    <leg><platformSettings x="0" y="0" z="-1.7" onGround="false"/>
      <scannerSettings pulseFreq_hz="100000" verticalAngleMin_deg="-20" verticalAngleMax_deg="20"
        verticalResolution_deg="0.5" horizontalResolution_deg="0.5" headRotateStart_deg="-20"
        headRotateStop_deg="20"/></leg>
  </survey>
  <scene id="s"><part><filter type="detailedvoxels"><param key="filepath" value="a.vox"/></filter></part></scene>
</document>
"""
BOX = ["--bounds", "-2", "2", "8", "12", "-2", "2"]
AREA = DENSITY * 64


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    rows = "".join(f"{i} {j} {k} {DENSITY}\n" for i, j, k in np.ndindex(4, 4, 4))
    (tmp_path / "a.vox").write_text(
        "VOXEL SPACE\n#min_corner: -2 8 -2\n#max_corner: 2 12 2\n#split: 4 4 4\n#res: 1\n"
        f"i j k PadBVTotal\n{rows}"
    )
    (tmp_path / "s.xml").write_text(SURVEY)
    return tmp_path


def run_survey(*options):
    command = ["run", "s.xml", "--quiet", "--no-accuracy-report", "--sub-rays", "1", *options]
    assert cli.main(command) == 0


def leafarea(capsys, *words):
    """Returns the JSON, the error text."""
    capsys.readouterr()
    code = cli.main(["leafarea", *words, "--json"])
    text = capsys.readouterr()
    return (json.loads(text.out) if code == 0 else None), text.err


@pytest.mark.parametrize("format", ["xyz", "las", "vtp"])
def test_a_run_with_its_pulses(folder, capsys, format):
    run_survey("--pulses", "--format", format)
    found, errors = leafarea(capsys, "output/s", "--voxel", "1", *BOX)
    assert found["scans"] == 1 and found["knowsMisses"] and "warning" not in errors
    assert abs(found["plantArea_m2"] - AREA) < 3.5 * found["plantAreaError_m2"]
    assert found["voxels"]["seen"] + found["voxels"]["shadowed"] == 64
    assert len(found["profile"]) == 4 and found["heights"] == "z"


def test_hits_of_a_run(folder, capsys):
    run_survey("--pulses", "--hits", "--sub-rays", "19")
    found, _ = leafarea(capsys, "output/s", "--voxel", "2", *BOX)
    assert abs(found["plantArea_m2"] - AREA) < 3.5 * found["plantAreaError_m2"]


def test_a_run_without_pulses_warns_and_has_too_much(folder, capsys):
    run_survey()
    found, errors = leafarea(capsys, "output/s", "--voxel", "1", *BOX)
    assert "the pulses that hit nothing are not known" in errors and "--pulses" in errors
    assert not found["knowsMisses"] and found["plantArea_m2"] > 1.1 * AREA


def test_files_and_the_table(folder, capsys):
    run_survey("--pulses")
    names = ["a.vti", "new/found.vox", "a.csv", "a.json"]
    words = [word for name in names for word in ("-o", name)]
    command = ["leafarea", "output/s", "--voxel", "1", *BOX, *words]
    assert cli.main(command) == 0
    text = capsys.readouterr()
    assert "LAI" in text.out and "PAD m²/m³" in text.out and "written  a.csv" in text.out
    grid = vtkhelios.update(vtkhelios.vtkHeliosVoxelReader(file_name="new/found.vox"))
    assert grid.GetNumberOfCells() == 64
    with open("a.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    facts = json.loads((folder / "a.json").read_text())
    assert [float(row["pad"]) for row in rows] == [row["pad"] for row in facts["profile"]]
    assert cli.main(command) == 1
    assert "a.vti: already exists; give --overwrite" in capsys.readouterr().err
    assert cli.main([*command, "--overwrite", "--quiet"]) == 0
    assert cli.main(["leafarea", "output/s", "-o", "a.obj"]) == 1
    assert "give --output one of: .vox, .vti, .csv, .json, .png" in capsys.readouterr().err
    (folder / "file").write_text("")
    assert cli.main(["leafarea", "output/s", "--voxel", "1", "-o", "file/a.json"]) == 1
    assert "cannot be written" in capsys.readouterr().err


def test_a_picture(folder, capsys):
    pytest.importorskip("matplotlib")
    run_survey("--pulses")
    command = ["leafarea", "output/s", "--voxel", "1", *BOX, "-o", "p.png", "--quiet"]
    assert cli.main(command) == 0
    assert (folder / "p.png").read_bytes()[1:4] == b"PNG"


def make_scan():
    """Directions of 60 columns of 50 rows that turn about z, and the ranges of a medium; inf: none."""
    random = np.random.default_rng(1)
    azimuth, elevation = np.meshgrid(
        np.radians(70 + np.arange(60) * 2 / 3),
        np.radians(-16 + np.arange(50) * 2 / 3),
        indexing="ij",
    )
    ways = np.stack(
        [
            np.cos(elevation) * np.cos(azimuth),
            np.cos(elevation) * np.sin(azimuth),
            np.sin(elevation),
        ],
        axis=-1,
    ).reshape(-1, 3)
    low, high = np.array([-2, 8, -2]), np.array([2, 12, 2])
    a, b = low / (ways + 1e-15), high / (ways + 1e-15)
    enter, leave = np.minimum(a, b).max(axis=1), np.maximum(a, b).min(axis=1)
    ranges = enter + random.exponential(2 / DENSITY, len(ways))
    return ways, np.where((ranges < leave) & (enter < leave), ranges, np.inf)


def write_ptx(path, ways, ranges, shift=(100.0, 200.0, 10.0)):
    """A scanner that is turned by 90 degrees and moved."""
    x, y, z = ways.T
    local = np.column_stack([y, -x, z])  # world = turn local
    points = local * np.where(np.isfinite(ranges), ranges, 0.0)[:, None]
    head = "60\n50\n{0} {1} {2}\n0 1 0\n-1 0 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n{0} {1} {2} 1\n"
    body = "".join(f"{x:.6f} {y:.6f} {z:.6f} 0.5\n" for x, y, z in points)
    path.write_text(head.format(*shift) + body)


MOVED = ["--bounds", "98", "102", "208", "212", "8", "12"]


def test_ptx_with_its_misses(tmp_path, capsys):
    ways, ranges = make_scan()
    write_ptx(tmp_path / "a.ptx", ways, ranges)
    found, errors = leafarea(capsys, str(tmp_path / "a.ptx"), "--voxel", "4", *MOVED)
    assert found["pulses"] == 3000 and found["knowsMisses"]
    assert abs(found["plantArea_m2"] - AREA) < 3.5 * found["plantAreaError_m2"]
    # The same as from memory, with the exact directions.
    hit = np.isfinite(ranges)
    cloud = vtkhelios.Cloud.from_arrays(
        (ways[hit] * ranges[hit, None]), PulseIds=np.flatnonzero(hit)
    )
    cloud.pulses = vtkhelios.Cloud.from_arrays(
        np.zeros_like(ways), Direction=ways, PulseIds=np.arange(len(ways))
    )
    exact = cloud.plant_area(voxel=4.0, bounds=(-2, 2, 8, 12, -2, 2))
    assert found["plantArea_m2"] == pytest.approx(exact.area, rel=1e-4)


def test_a_cut_ptx_is_an_error(tmp_path, capsys):
    write_ptx(tmp_path / "a.ptx", *make_scan())
    text = (tmp_path / "a.ptx").read_text().splitlines(keepends=True)
    (tmp_path / "a.ptx").write_text("".join(text[:-5]))
    _, errors = leafarea(capsys, str(tmp_path / "a.ptx"))
    assert "scan 1 has 2995 of its 3000 points" in errors


def test_misses_of_a_pattern(tmp_path, capsys):
    """A file without misses, from a known place: the pattern tells them."""
    ways, ranges = make_scan()
    hit = np.isfinite(ranges)
    points = ways[hit] * ranges[hit, None]
    np.savetxt(tmp_path / "a.xyz", points, fmt="%.6f", header="x y z", comments="")
    words = [str(tmp_path / "a.xyz"), "--voxel", "4", *BOX, "--origin", "0", "0", "0"]
    blind, errors = leafarea(capsys, *words)
    assert "the pulses that hit nothing are not known" in errors
    found, errors = leafarea(capsys, *words, "--spacing", "0.66667", "0.66667")
    assert "not known" not in errors
    assert abs(found["plantArea_m2"] - AREA) < 3.5 * found["plantAreaError_m2"]
    assert blind["plantArea_m2"] > 1.3 * AREA


def test_e57_with_its_misses(folder, capsys):
    pytest.importorskip("pye57")
    run_survey("--pulses")
    assert cli.main(["convert", "output/s", "a.e57", "--quiet"]) == 0
    run, _ = leafarea(capsys, "output/s", "--voxel", "4", *BOX)
    found, _ = leafarea(capsys, "a.e57", "--voxel", "4", *BOX)
    assert found["knowsMisses"] and found["pulses"] == run["pulses"]
    assert found["plantArea_m2"] == pytest.approx(run["plantArea_m2"], rel=1e-3)


def test_points_on_trajectories(tmp_path, capsys):
    """Two strips of vertical beams above a medium over a floor that returns the rest."""
    random = np.random.default_rng(3)
    count = 20_000
    times = np.where(np.arange(count) < count / 2, 0.0, 100.0) + 20.0 * random.uniform(size=count)
    x = times % 100 / 5  # 0 to 4 m
    y = np.where(times < 50, 1.0, 3.0) + random.uniform(-1, 1, count)
    ranges = 8 + random.exponential(1 / (0.5 * DENSITY), count)
    z = np.where(ranges < 12, 12 - ranges, -1.0)
    classes = np.where(z < 0, 2, 5)
    rows = np.column_stack([x, y, z, times, classes])
    np.savetxt(
        tmp_path / "a.csv", rows, fmt="%.6f", delimiter=",", comments="",
        header="x,y,z,gpstime,classification",
    )  # fmt: skip
    for name, start, at in (("one", 0, 1), ("two", 100, 3)):
        path = [f"{start + t},0,0,0,{t / 5},{at},500" for t in range(21)]
        (tmp_path / f"{name}.csv").write_text(
            '#HEADER: "t","roll","pitch","yaw","x","y","z"\n' + "\n".join(path)
        )
    words = [str(tmp_path / "a.csv"), "--voxel", "2", "--bounds", "0", "4", "0", "4", "0", "4"]
    paths = ["--trajectory", str(tmp_path / "one.csv"), "--trajectory", str(tmp_path / "two.csv")]
    found, _ = leafarea(capsys, *words, *paths)
    assert found["scans"] == 2 and found["heights"] == "above ground"
    assert abs(found["plantArea_m2"] - AREA) < 3.5 * found["plantAreaError_m2"]
    found, errors = leafarea(capsys, *words, *paths[:2])
    assert "10,000 points of 20,000 are left out" in errors
    (tmp_path / "three.csv").write_text(
        '#HEADER: "t","roll","pitch","yaw","x","y","z"\n900,0,0,0,0,0,9\n901,0,0,0,1,0,9\n'
    )
    _, errors = leafarea(capsys, *words, "--trajectory", str(tmp_path / "three.csv"))
    assert "are not on any trajectory" in errors
    _, errors = leafarea(capsys, *words, "--trajectory", "none.csv")
    assert "none.csv: no such file" in errors


def test_what_cannot_be_inverted_says_why(tmp_path, capsys):
    np.savetxt(tmp_path / "a.xyz", np.eye(3), fmt="%.3f", header="x y z", comments="")
    path = str(tmp_path / "a.xyz")
    (tmp_path / "t.csv").write_text("0,0,0,0,0,0,9\n1,0,0,0,1,0,9\n")
    for words, message in (
        ([path], "does not tell where its beams begin"),
        ([path, "--trajectory", str(tmp_path / "t.csv")], "has no GpsTime"),
        ([path, "--origin", "1", "0", "0"], "has points at the origin of its beams"),
        ([str(tmp_path / "no")], "no such file or folder"),
        ([path, "--origin", "9", "9", "9", "--spacing", "1e-4", "1e-4"], "give a larger --spacing"),
    ):
        _, errors = leafarea(capsys, *words)
        assert message in errors, words
    with pytest.raises(ValueError, match="no clouds"):
        vtkhelios.plant_area()


def test_coordinates_in_feet_and_degrees_are_refused(tmp_path, capsys):
    cloud = vtkhelios.Cloud.from_arrays(np.array([[1.0, 2.0, 3.0], [2.0, 2.0, 3.0]]))
    for crs, message in (("EPSG:2994", "have units of 0.3048 m"), ("EPSG:4326", "longitudes")):
        path = tmp_path / "a.vtp"
        from vtkmodules.vtkCommonCore import vtkStringArray

        text = vtkStringArray()
        text.SetName("CRS")
        text.InsertNextValue(crs)
        cloud.data.GetFieldData().AddArray(text)
        cloud.write(str(path))
        _, errors = leafarea(capsys, str(path), "--origin", "0", "0", "0")
        assert message in errors and "vtkhelios convert" in errors
