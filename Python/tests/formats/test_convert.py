# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios convert: points of a run in all formats."""

import gc
import json
import os
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.points.selection import Selection


@pytest.fixture
def convert(capsys):
    """Converts and returns (exit code, standard output, standard error)."""

    def call(*arguments):
        capsys.readouterr()
        try:
            code = cli.main(["convert", *map(str, arguments)])
        except SystemExit as wrong:
            code = wrong.code
        return code, *capsys.readouterr()

    return call


@pytest.fixture
def las(small_runs, tmp_path):
    """A copy of the LAS file of the first leg, with its packets."""
    pytest.importorskip("laspy")
    pytest.importorskip("lazrs")
    for ending in ("las", "wdp"):
        shutil.copy(small_runs["las"] / f"leg000_points.{ending}", tmp_path / f"a.{ending}")
    return tmp_path / "a.las"


def read(path):
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks())
        return {name: np.concatenate([each[name] for each in chunks]) for name in chunks[0]}


def read_waveforms(path):
    reader = vtkhelios.vtkHeliosLASReader()
    reader.SetFileName(str(path))
    reader.ReadWaveformsOn()
    vtkhelios.update(reader)
    return vtkhelios.arrays(reader.GetOutputDataObject(1)), reader


# Records


def test_las_to_laz_and_back_is_the_same_file(las, convert, tmp_path):
    code, out, err = convert(las, tmp_path / "b.laz")
    assert code == 0 and err == "" and "lost" not in out
    assert (tmp_path / "b.laz").stat().st_size < 0.5 * las.stat().st_size
    assert convert(tmp_path / "b.laz", tmp_path / "c.las")[0] == 0
    assert (tmp_path / "c.las").read_bytes() == las.read_bytes()
    assert (tmp_path / "c.wdp").read_bytes() == las.with_suffix(".wdp").read_bytes()


def test_laspy_reads_the_laz(las, convert, tmp_path):
    laspy = pytest.importorskip("laspy")
    convert(las, tmp_path / "b.laz")
    ours, theirs = laspy.read(tmp_path / "b.laz"), laspy.read(las)
    assert ours.points.array.tobytes() == theirs.points.array.tobytes()
    assert ours.header.point_format.id == 9 and ours.header.global_encoding.wkt
    assert any("25832" in v.string for v in ours.header.vlrs.get("WktCoordinateSystemVlr"))


@pytest.mark.parametrize(
    "version, form",
    [("1.2", f) for f in range(4)] + [("1.3", f) for f in (4, 5)] + [("1.4", f) for f in range(11)],
)
def test_every_field_of_every_format(convert, tmp_path, version, form):
    """Random bits in all fields, unknown records, Extra Bytes with a scale."""
    laspy = pytest.importorskip("laspy")
    header = laspy.LasHeader(version=version, point_format=form)
    header.scales, header.offsets = [0.001, 0.002, 0.01], [4e5, 5e6, -10.0]
    header.system_identifier, header.generating_software = "OTHER", "somebody's"
    header.vlrs.append(laspy.VLR("somebody", 77, "theirs", b"x" * 100))
    header.add_extra_dim(laspy.ExtraBytesParams("Height", "i2", "scaled", [0.5], [0.01]))
    points = laspy.ScaleAwarePointRecord.zeros(2000, header=header)
    raw = points.array.view(np.uint8).reshape(2000, -1)
    raw[:] = np.random.default_rng(form).integers(0, 256, raw.shape)
    if header.point_format.has_waveform_packet:
        points.array["wavepacket_index"] = 0
        (tmp_path / "a.wdp").write_bytes(bytes(2) + b"LASF_Spec" + bytes(49))
    with laspy.open(tmp_path / "a.las", "w", header=header) as writer:
        writer.write_points(points)
    for source, target in (("a.las", "b.laz"), ("b.laz", "c.las")):
        code, _, err = convert(tmp_path / source, tmp_path / target)
        assert code == 0, err
    assert (tmp_path / "c.las").read_bytes()[375:] == (tmp_path / "a.las").read_bytes()[375:]
    one, two = (laspy.read(tmp_path / name) for name in ("a.las", "b.laz"))
    assert two.points.array.tobytes() == points.array.tobytes()
    assert two.header.generating_software == "somebody's" and two.header.version == version
    assert np.array_equal(one["Height"], two["Height"])
    assert [v.record_data_bytes() for v in one.vlrs] == [v.record_data_bytes() for v in two.vlrs]


def test_waveforms_internal_and_external(las, convert, tmp_path):
    inside = tmp_path / "b.las"
    assert convert(las, inside, "--waveforms", "internal")[0] == 0
    assert not inside.with_suffix(".wdp").exists()
    data = inside.read_bytes()
    encoding, begin = struct.unpack_from("<H", data, 6)[0], struct.unpack_from("<Q", data, 227)[0]
    assert encoding & 2 and not encoding & 4  # internal, and not external
    assert data[begin + 2 : begin + 11] == b"LASF_Spec"
    assert struct.unpack_from("<H", data, begin + 18)[0] == 65535
    outside, one = read_waveforms(las)
    found, two = read_waveforms(inside)
    assert set(found) == set(outside)
    for name, values in outside.items():
        assert np.array_equal(found[name], values), name
    assert convert(inside, tmp_path / "c.laz")[0] == 0  # kept internal
    assert convert(tmp_path / "c.laz", tmp_path / "d.las", "--waveforms", "external")[0] == 0
    assert (tmp_path / "d.las").read_bytes() == las.read_bytes()
    assert (tmp_path / "d.wdp").read_bytes() == las.with_suffix(".wdp").read_bytes()
    del one, two


def turn_vectors(path):
    """Rewrites a LAS file as an earlier version: vectors point away from the scanner."""
    data = bytearray(path.read_bytes())
    begin, length = struct.unpack_from("<I", data, 96)[0], struct.unpack_from("<H", data, 105)[0]
    said = b"waveform [W], to the scanner"
    assert data[:begin].count(said) == 252
    data[:begin] = data[:begin].replace(said, b"waveform [W]".ljust(len(said), b"\0"))
    records = np.frombuffer(data, np.uint8, offset=begin).reshape(-1, length)
    records[:, [50, 54, 58]] ^= 0x80  # the signs of three floats from byte 47 on
    path.write_bytes(data)


@pytest.mark.parametrize("ending", ["las", "laz"])
def test_waveform_vectors_of_earlier_versions_are_reversed(las, convert, tmp_path, ending):
    expected, right = las.read_bytes(), read_waveforms(las)[0]
    turn_vectors(las)
    assert las.read_bytes() != expected
    code, _, err = convert(las, tmp_path / f"b.{ending}")
    assert code == 0 and err.count("an earlier version of vtkHelios wrote its waveforms") == 1
    code, _, err = convert(tmp_path / f"b.{ending}", tmp_path / "c.las")  # once, not twice
    assert code == 0 and "earlier" not in err
    assert (tmp_path / "c.las").read_bytes() == expected
    found, reader = read_waveforms(tmp_path / "c.las")
    assert all(np.array_equal(found[name], values) for name, values in right.items())
    del reader


def test_waveform_vectors_of_earlier_versions_in_laz(las, convert, tmp_path):
    """LAZ made by another program from a file of an earlier version keeps its records."""
    laspy = pytest.importorskip("laspy")
    expected = las.read_bytes()
    turn_vectors(las)
    laspy.read(las).write(tmp_path / "b.laz")
    shutil.copy(las.with_suffix(".wdp"), tmp_path / "b.wdp")
    code, _, err = convert(tmp_path / "b.laz", tmp_path / "c.las")
    assert code == 0 and "vtkhelios convert inverts them" in err
    begin = struct.unpack_from("<I", expected, 96)[0]
    assert (tmp_path / "c.las").read_bytes()[begin:] == expected[begin:]


def test_internal_waveforms_by_laspy(las, convert, tmp_path):
    """A packet found and decoded by laspy alone."""
    laspy = pytest.importorskip("laspy")
    convert(las, tmp_path / "b.laz", "--waveforms", "internal")
    file = laspy.read(tmp_path / "b.laz")
    packets = next(v for v in file.evlrs if v.record_id == 65535)
    data = packets.record_data_bytes()
    table, _ = read_waveforms(las)
    rows = {int(pulse): row for row, pulse in enumerate(table["PulseIds"])}
    descriptors = {
        v.record_id - 99: v.record_data_bytes()
        for v in file.header.vlrs
        if 100 <= v.record_id < 355
    }
    for i in range(0, len(file.points), 997):
        form = descriptors[int(file["wavepacket_index"][i])]
        bits, _, count, spacing, gain, offset = struct.unpack("<BBIIdd", form)
        place = int(file["wavepacket_offset"][i]) - 60
        assert bits == 32 and spacing > 0
        numbers = np.frombuffer(data, "<u4", count, place)
        row = rows[int(file["WaveformIds"][i])]
        begin, size = int(table["Offset"][row]), int(table["Count"][row])
        expected = table["Samples"][begin : begin + size]
        assert np.abs(offset + gain * numbers[:size] - expected).max() <= gain


def test_echo_detection_on_converted_waveforms(las, convert, tmp_path):
    echoes = []
    for path in (las, tmp_path / "b.las"):
        if path != las:
            convert(las, path, "--waveforms", "internal")
        _, reader = read_waveforms(path)
        detection = vtkhelios.vtkHeliosEchoDetection()
        detection.SetInputData(reader.GetOutputDataObject(1))
        detector = vtkhelios.vtkHeliosPeakDetector()
        detector.SetDetectionThreshold(1e-13)
        detection.SetEchoDetector(detector)
        detection.SetPulseLength(4.0)
        echoes.append(vtkhelios.arrays(vtkhelios.update(detection)))
    assert len(echoes[0]["points"]) > 1000
    for name, values in echoes[0].items():
        assert np.array_equal(values, echoes[1][name]), name


def test_merged_files_keep_their_waveforms(small_runs, convert, tmp_path):
    pytest.importorskip("lazrs")
    code, out, _ = convert(small_runs["las"], tmp_path / "all.las")
    assert code == 0 and "lost" not in out
    parts = [small_runs["las"] / f"leg00{k}_points.las" for k in range(2)]
    whole, pieces = read(tmp_path / "all.las"), [read(path) for path in parts]
    for name, values in whole.items():
        expected = np.concatenate([piece[name] for piece in pieces])
        assert np.allclose(values, expected, rtol=0, atol=1e-9), name
    assert set(whole["LegIds"]) == {0, 1}
    waves, _ = read_waveforms(tmp_path / "all.las")
    each = [read_waveforms(path)[0] for path in parts]
    assert np.array_equal(waves["Samples"], np.concatenate([one["Samples"] for one in each]))


def test_a_run_with_separate_waveforms(small_runs, convert, tmp_path):
    """Points of format 6, and with --waveforms of format 9 with their packets."""
    pytest.importorskip("lazrs")
    survey = small_runs["las"].parents[1] / "survey.xml"
    words = ["run", survey, "--format", "las", "--output", tmp_path, "--waveforms", "--quiet"]
    assert cli.main([*map(str, words)]) == 0
    run = tmp_path / "fence"
    assert convert(run, tmp_path / "points.las")[0] == 0
    assert not (tmp_path / "points.wdp").exists()
    assert convert(run, tmp_path / "waves.las", "--waveforms", "external")[0] == 0
    assert [(tmp_path / f"{name}.las").read_bytes()[104] for name in ("points", "waves")] == [6, 9]
    points, waves = read(tmp_path / "points.las"), read(tmp_path / "waves.las")
    for name, values in points.items():
        assert np.array_equal(values, waves[name]), name
    assert convert(small_runs["las"], tmp_path / "inside.las")[0] == 0
    expected, _ = read_waveforms(tmp_path / "inside.las")
    assert np.array_equal(read_waveforms(tmp_path / "waves.las")[0]["Samples"], expected["Samples"])
    assert (points["ScanDirectionFlag"] == 1).all()  # a polygon


def test_points_are_read_by_pdal(small_runs, tmp_path):
    """PDAL refuses format 9, so points with waveforms have a file of their own."""
    program = shutil.which("pdal")
    if not program:
        pytest.skip("pdal is not here")
    survey = small_runs["las"].parents[1] / "survey.xml"
    words = ["run", survey, "--format", "las", "--output", tmp_path, "--waveforms", "--quiet"]
    assert cli.main([*map(str, words)]) == 0
    for name, is_read in (("leg000_points.las", True), ("leg000_fullwave.las", False)):
        done = subprocess.run(
            [program, "info", tmp_path / "fence" / name], capture_output=True, text=True
        )
        assert (done.returncode == 0) == is_read, done.stderr


def test_merged_files_of_different_forms(las, convert, tmp_path):
    """Data that cannot be copied go through arrays, with a message."""
    cloud = read(las)
    with formats.open_reader(las) as reader:
        with formats.open_writer(tmp_path / "b.las", reader.header) as writer:
            writer.write(cloud)
    code, out, err = convert(las, tmp_path / "b.las", tmp_path / "c.laz", "--merge")
    assert code == 0 and "b.las: has another point format or other Extra Bytes than" in err
    assert "dropped  waveforms: only copied from LAS or LAZ to LAS or LAZ" in out
    both = read(tmp_path / "c.laz")
    for name, values in cloud.items():
        assert np.allclose(both[name], np.concatenate([values, values]), rtol=0, atol=1e-9), name
    assert out.count("input ") == 2


# Choices


def test_returns_classes_and_every_nth(las, convert, tmp_path):
    whole = read(las)
    number, count = whole["ReturnNumber"], whole["NumberOfReturns"]
    assert (count > 1).any()
    masks = {
        "first": number == 1,
        "last": number == count,
        "single": count == 1,
    }
    for returns, mask in masks.items():
        for ending in ("laz", "ply"):  # once as records and once as arrays
            path = tmp_path / f"{returns}.{ending}"
            assert convert(las, path, "--returns", returns)[0] == 0
            assert np.array_equal(read(path)["GpsTime"], whole["GpsTime"][mask])
    assert convert(las, tmp_path / "n.las", "--every", 7, "--class", "0,2")[0] == 0
    found = read(tmp_path / "n.las")
    assert np.array_equal(found["GpsTime"], whole["GpsTime"][::7])
    with formats.open_reader(tmp_path / "n.las") as reader:
        assert reader.count == len(found["GpsTime"])  # count in the header
    code, _, err = convert(las, tmp_path / "x.las", "--class", "9")
    assert code == 1 and "none of the" in err and not list(tmp_path.glob("x.*"))


def test_every_nth_across_chunks():
    """Points are counted across chunks, regardless of other options."""
    for every in (1, 3, 7):
        selection = Selection(every=every, classes=[1])
        kept = []
        for begin in range(0, 100, 11):
            numbers = np.arange(begin, min(begin + 11, 100))
            chunk = {
                "points": np.column_stack([numbers] * 3).astype(float),
                "ClassificationIds": numbers % 2,
            }
            kept += numbers[selection.of_chunk(chunk, "a")].tolist()
        assert kept == [i for i in range(100) if i % every == 0 and i % 2 == 1]


def test_coordinate_systems(small_runs, convert, tmp_path):
    source = small_runs["vtp"] / "leg000_points.pvtp"
    assert convert(source, tmp_path / "a.ply", "--crs", "EPSG:25833")[0] == 0
    assert convert(tmp_path / "a.ply", tmp_path / "b.ply", "--crs", "EPSG:25832")[0] == 0
    assert np.allclose(read(tmp_path / "b.ply")["points"], read(source)["points"], atol=1e-3)
    assert np.abs(read(tmp_path / "a.ply")["points"] - read(source)["points"]).max() > 1e4
    code, _, err = convert(source, tmp_path / "c.ply", "--crs", "EPSG:nonsense")
    assert code == 1 and "EPSG:nonsense" in err and not (tmp_path / "c.ply").exists()
    assert convert(small_runs["xyz"], tmp_path / "d.ply", "--crs", "EPSG:4978")[0] == 0
    with formats.open_reader(tmp_path / "d.ply") as reader:  # text has no epoch: values are kept
        assert reader.header.crs == "EPSG:4978"
    code, _, err = convert(tmp_path / "a.ply", tmp_path / "b.ply", tmp_path / "e.ply", "--merge")
    assert code == 1 and "give" not in err.split(";")[0] and "with --crs" in err


# Runs


def test_runs_of_every_format_are_the_same_cloud(small_runs, convert, tmp_path):
    clouds = []
    for kind, folder in small_runs.items():
        assert convert(folder, tmp_path / f"{kind}.ply")[0] == 0
        clouds.append(read(tmp_path / f"{kind}.ply"))
    for cloud in clouds[1:]:
        assert np.allclose(cloud["points"], clouds[0]["points"], rtol=0, atol=1.1e-4)
        for name in ("PulseIds", "ReturnNumber", "LegIds", "PartIds"):
            assert np.array_equal(cloud[name], clouds[0][name]), name


def test_objects_of_text_by_name(tmp_path):
    """A name is the same object in all legs, in any order."""
    row = "{} 0 0 1 4 1 1 0 {} 0 0\n"
    (tmp_path / "leg000_points.xyz").write_text(row.format(1, "wall") + row.format(2, "tree"))
    (tmp_path / "leg001_points.xyz").write_text(row.format(3, "roof") + row.format(4, "wall"))
    files = [{"name": f"leg00{k}_points.xyz", "records": 2} for k in range(2)]
    summary = {"legs": [{"leg": k, "files": [files[k]]} for k in range(2)]}
    (tmp_path / "run_summary.json").write_text(json.dumps(summary))
    with formats.open_reader(tmp_path) as reader:
        ids = np.concatenate([chunk["PartIds"] for chunk in reader.chunks()])
        names = reader.header.part_names
    assert [names[i] for i in ids] == ["wall", "tree", "roof", "wall"]


@pytest.mark.parametrize("kind", ["vtp", "xyz"])
def test_strips(small_runs, convert, tmp_path, kind):
    """Legs that share files: one cloud, and one trajectory through both positions."""
    folder = small_runs[kind].parents[1]
    for name in ("scene.xml", "fence.obj"):
        shutil.copy(folder / name, tmp_path)
    survey = (folder / "survey.xml").read_text().replace("<leg>", '<leg stripId="4">')
    (tmp_path / "survey.xml").write_text(survey)
    arguments = ["run", tmp_path / "survey.xml", "--format", kind, "--output", tmp_path, "--quiet"]
    assert cli.main([*map(str, arguments)]) == 0
    with formats.open_reader(tmp_path / "fence") as reader:
        _, places, _ = reader.trajectory(reader.files[0])
        assert np.allclose(places[:, :2], [[0, 0], [-8, 3]])
        assert len(reader.scans) == 1 and reader.scans[0].name == "strip004"
    assert convert(tmp_path / "fence", tmp_path / "a.ply")[0] == 0
    expected = read(small_runs[kind] / f"leg000_points.{'p' if kind == 'vtp' else ''}{kind}")
    assert np.allclose(read(tmp_path / "a.ply")["points"][:100], expected["points"][:100])


def test_one_file_per_leg(small_runs, convert, tmp_path):
    assert convert(small_runs["xyz"], tmp_path / "legs", "--format", "las")[0] == 0
    names = sorted(path.name for path in (tmp_path / "legs").iterdir())
    assert names == ["leg000_points.las", "leg001_points.las"]
    assert set(read(tmp_path / "legs" / names[1])["LegIds"]) == {1}


def test_one_scan_per_setup(small_runs, convert, tmp_path):
    """E57: poses from the trajectories, a grid and invalid points from the pulses."""
    pye57 = pytest.importorskip("pye57")
    for kind in ("vtp", "xyz"):
        assert convert(small_runs[kind], tmp_path / f"{kind}.e57")[0] == 0
        summary = json.loads((small_runs[kind] / "run_summary.json").read_text())
        with pye57.E57(str(tmp_path / f"{kind}.e57")) as file:
            assert file.scan_count == 2
            for leg in range(2):
                check_scan(file, leg, summary["legs"][leg], small_runs[kind])


def check_scan(file, leg, told, folder):
    header = file.get_header(leg)
    raw = file.read_scan_raw(leg, ignore_unsupported_fields=True)
    world = file.read_scan(leg, row_column=True)
    state = raw["cartesianInvalidState"].astype(int)
    assert header["name"].value() == f"leg00{leg}"
    assert np.allclose(header.translation[:2], [(0, 0), (-8, 3)][leg])
    assert np.allclose(np.abs(header.rotation), [1, 0, 0, 0])  # a tripod
    assert np.count_nonzero(state == 0) == told["points"]
    assert np.count_nonzero(state == 1) == told["pulsesFired"] - told["pulsesHit"]
    local = np.column_stack([raw[f"cartesian{a}"] for a in "XYZ"])
    assert np.allclose(np.linalg.norm(local[state == 1], axis=1), 1.0, atol=1e-6)  # directions
    rows, columns = raw["rowIndex"].astype(int), raw["columnIndex"].astype(int)
    assert columns.max() + 1 == 101  # 100 lines/s for 1 s, starting within a line
    assert rows.max() + 1 == told["pulsesFired"] / 100 == 250
    first = state == 0
    cells = rows[state == 1] * 10_000 + columns[state == 1]
    assert len(np.unique(cells)) == len(cells)  # one pulse per cell
    up = np.degrees(np.arcsin(local[first, 2] / np.linalg.norm(local[first], axis=1)))
    step = 60.0 / 250
    assert np.abs(up - (rows[first] * step + up[rows[first] == rows[first].min()].mean()
                        - rows[first].min() * step)).max() < 3 * step  # fmt: skip
    xyz = np.column_stack([world[f"cartesian{a}"] for a in "XYZ"])
    name = f"leg00{leg}_points.{'pvtp' if (folder / 'leg000_points.pvtp').exists() else 'xyz'}"
    assert np.allclose(xyz, read(folder / name)["points"], rtol=0, atol=1e-6)


def test_lost_fields_are_reported(small_runs, convert, tmp_path):
    _, out, _ = convert(small_runs["vtp"], tmp_path / "a.xyz")
    lost = [line for line in out.splitlines() if line.startswith("dropped")]
    assert "Range, " in lost[0] and "text has no column for it" in lost[0]
    assert any("CRS" in line and "text has no header" in line for line in lost)
    _, out, _ = convert(small_runs["vtp"], tmp_path / "a.ply")
    assert "dropped  Material.Name, Part.Name: points keep the numbers" in out


def test_cloudcompare_reads_ply_and_text(small_runs, convert, tmp_path):
    program = shutil.which("CloudCompare") or shutil.which("cloudcompare")
    if not program:
        pytest.skip("CloudCompare is not here")
    for ending in ("ply", "xyz"):
        path = tmp_path / f"a.{ending}"
        assert convert(small_runs["vtp"], path)[0] == 0
        done = subprocess.run(
            [program, "-SILENT", "-AUTO_SAVE", "OFF", "-C_EXPORT_FMT", "ASC", "-PREC", "6", "-O",
             path, "-SAVE_CLOUDS", "FILE", tmp_path / f"{ending}.asc"],
            env={"QT_QPA_PLATFORM": "offscreen", "HOME": str(tmp_path)}, capture_output=True,
            timeout=120,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        found = np.loadtxt(tmp_path / f"{ending}.asc")
        assert np.allclose(found[:, :3], read(path)["points"], rtol=0, atol=1e-5)


# Errors


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["none.las", "b.laz"], "none.las: no such file or folder; check its name"),
        (["a.las", "b.shp"], "b.shp: its ending is not of a known format"),
        (["notes.dat", "b.las"], "notes.dat: its ending is not of a known format"),
        (["a.las", "a.las"], "a.las: is also an input; give another name"),
        (["a.las", "there.laz"], "there.laz: already exists; give --overwrite to replace it"),
        (["a.las", "there.laz", "b.laz"], "b.laz: is one file for 2 inputs; give --merge"),
        (["a.las", "folder"], "folder: is a folder; give --format for files in it"),
        (["a.las", "there.laz", "--format", "ply"], "there.laz: is a file; with --format"),
        (["a.las", "out", "--format", "ply", "--merge"], "leave --merge or --format out"),
        (
            ["a.las", "folder/a.las", "out", "--format", "ply"],
            "would be the output of both .*a.las and",
        ),
        (["folder", "b.las"], "folder: is a folder without run_summary.json; give the folder of"),
        (["begun", "b.las"], "begun: the run is not finished; vtkhelios run --resume continues it"),
        (["epochs", "b.las"], "epochs: holds several epochs; give the folder of one: epoch000"),
        (
            ["other", "b.las"],
            "run_summary.json: the file is a list: expected an object; run the survey",
        ),
        (["bare", "b.las"], "bare: its run_summary.json lists no point files; run the"),
        (
            ["broken", "b.las"],
            "broken/run_summary.json: is not valid JSON: .*; run the survey again",
        ),
        (
            ["a.las", "b.ply", "--waveforms", "internal"],
            "waveforms are copied only from LAS or LAZ to LAS or",
        ),
        (["bare.las", "b.las", "--waveforms", "internal"], "bare.las: has no waveforms; leave"),
        (["three.xyz", "b.las", "--returns", "last"], "three.xyz: has no ReturnNumber; leave --r"),
        (["nan.ply", "b.las"], r"nan.ply: point 1 is \(nan, 0, 0\), not finite; correct it, or"),
    ],
)
def test_errors(las, convert, tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    for folder in ("folder", "begun", "epochs/epoch000", "broken", "other", "bare"):
        (tmp_path / folder).mkdir(parents=True)
    shutil.copy(las, "folder/a.las")
    for name in ("there.laz", "notes.dat", "begun/run.journal", "epochs/epoch000/run_summary.json"):
        (tmp_path / name).write_text("")
    (tmp_path / "broken/run_summary.json").write_text("{")
    (tmp_path / "other/run_summary.json").write_text("[1]")
    (tmp_path / "bare/run_summary.json").write_text('{"legs": []}')
    (tmp_path / "three.xyz").write_text("1 2 3\n")
    with formats.open_writer("bare.las") as writer:
        writer.write({"points": np.zeros((2, 3))})
    with formats.open_writer("nan.ply") as writer:
        writer.write({"points": np.array([[0, 0, 0], [np.nan, 0, 0]])})
    before = sorted(tmp_path.rglob("*"))
    code, _, err = convert(*arguments)
    assert code == 1
    assert re.search(message, err), err
    assert sorted(tmp_path.rglob("*")) == before  # no files are left


def test_missing_packets(las, convert, tmp_path):
    las.with_suffix(".wdp").unlink()
    code, _, err = convert(las, tmp_path / "b.laz")
    assert code == 1 and "a.wdp, which is missing; keep the two files together" in err


def test_truncated_laz(las, convert, tmp_path, monkeypatch):
    (tmp_path / "scratch").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "scratch"))
    convert(las, tmp_path / "b.laz")
    data = (tmp_path / "b.laz").read_bytes()
    (tmp_path / "b.laz").write_bytes(data[: len(data) // 2])
    code, _, err = convert(tmp_path / "b.laz", tmp_path / "c.las")
    assert (
        code == 1
        and "b.laz: has no table of its 21115 points" in err
        and "is cut off or damaged" in err
    )
    code, _, err = convert(tmp_path / "b.laz", tmp_path / "c.ply")
    assert code == 1 and "b.laz: has no table of its 21115 points" in err
    assert not list(tmp_path.glob("c.*"))
    gc.collect()
    assert not list((tmp_path / "scratch").iterdir())


def test_truncated_las(las, convert, tmp_path):
    data = las.read_bytes()
    las.write_bytes(data[: len(data) // 2])
    code, _, err = convert(las, tmp_path / "c.laz")
    assert (
        code == 1
        and "a.las: has 10466 whole points of the" in err
        and "that its header counts" in err
    )
    convert_from = tmp_path / "in.las"
    las.write_bytes(data)
    convert(las, convert_from, "--waveforms", "internal")
    whole = convert_from.read_bytes()
    convert_from.write_bytes(whole[:-1000])
    code, _, err = convert(convert_from, tmp_path / "c.laz")
    assert code == 1 and "in.las: is cut off: it has" in err and "an extended record ends" in err
    assert not list(tmp_path.glob("c.*"))


def test_points_that_are_not_finite_can_be_skipped(convert, tmp_path):
    with formats.open_writer(tmp_path / "a.ply") as writer:
        writer.write({"points": np.array([[0, 0, 0], [np.nan, 0, 0], [1, 1, 1.0]])})
    code, out, _ = convert(tmp_path / "a.ply", tmp_path / "b.las", "--skip-invalid")
    assert code == 0 and "skipped  1 point that are not finite" in out
    assert read(tmp_path / "b.las")["points"].tolist() == [[0, 0, 0], [1, 1, 1]]


@pytest.mark.parametrize("option", [["--class", "300"], ["--every", "0"], ["--returns", "second"]])
def test_wrong_options(convert, option):
    code, _, err = convert("a.las", "b.las", *option)
    assert code == 2 and option[1] in err


def test_replacing(las, convert, tmp_path):
    (tmp_path / "b.ply").write_text("old")
    assert convert(las, tmp_path / "b.ply", "--overwrite")[0] == 0
    assert len(read(tmp_path / "b.ply")["points"]) > 1000


@pytest.mark.parametrize("ending", [kind[1:] for kind in formats.WRITTEN])
def test_full_disks(small_runs, tmp_path, ending):
    """A file that cannot grow beyond 200 kB: an error that names it, and no files left."""
    for package in {
        "las": ["laspy"],
        "e57": ["pye57"],
    }.get(ending, []):
        pytest.importorskip(package)
    sources = [small_runs["vtp"] / "leg000_points.pvtp", small_runs["las"] / "leg000_points.las"]
    limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000))  # noqa: E731
    for source in sources:
        done = subprocess.run(
            [sys.executable, "-P", "-m", "vtkhelios", "convert", source, f"b.{ending}"],
            cwd=tmp_path, capture_output=True, text=True, preexec_fn=limit, timeout=120,
            env={**os.environ, "PYTHONPATH": PACKAGE, "TMPDIR": str(tmp_path)},
        )  # fmt: skip
        assert done.returncode == 1, done.stderr
        assert "Traceback" not in done.stderr and f"b.{ending}" in done.stderr, done.stderr
        assert list(tmp_path.iterdir()) == []


def test_interrupted(tmp_path):
    """Ctrl-C leaves no files."""
    count = 3_000_000
    with formats.open_writer(tmp_path / "a.ply") as writer:
        writer.write({"points": np.random.default_rng(1).uniform(0, 100, (count, 3))})
    process = subprocess.Popen(
        [sys.executable, "-P", "-m", "vtkhelios", "convert", tmp_path / "a.ply", tmp_path / "b.xyz"],
        stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": PACKAGE},
    )  # fmt: skip
    part = tmp_path / "b.xyz.part"
    for _ in range(2000):
        if part.exists() and part.stat().st_size > 0 or process.poll() is not None:
            break
        time.sleep(0.005)
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=120)
    assert process.returncode == 130 and "interrupted" in err and "was not written" in err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.ply"]


PACKAGE = str(__import__("pathlib").Path(vtkhelios.__file__).absolute().parents[1])
