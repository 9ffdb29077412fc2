# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS and LAZ of other programs: versions, colours of 8 bits, Extra Bytes, merged files."""

import struct

import numpy as np
import pytest
from _point_files import make_chunk, read, write

from vtkhelios import cli, formats

laspy = pytest.importorskip("laspy")
pytest.importorskip("lazrs")
COLOURS = ("red", "green", "blue")


def write_las(path, version="1.4", form=6, count=10, extras=(), change=None, **values):
    """A file of laspy; LAS 1.0 by its version alone, with numbers in its reserved bytes."""
    is_first = version == "1.0"
    header = laspy.LasHeader(version="1.1" if is_first else version, point_format=form)
    header.scales = [0.001] * 3
    for each in extras:
        header.add_extra_dim(each)
    if change:
        change(header)
    points = laspy.ScaleAwarePointRecord.zeros(count, header=header)
    points["X"] = np.arange(count) * 1000
    points["return_number"][:] = points["number_of_returns"][:] = 1
    for name, numbers in values.items():
        points[name] = np.broadcast_to(numbers, count)
    laspy.LasData(header, points).write(path, do_compress=path.suffix == ".laz")
    if is_first:
        data = bytearray(path.read_bytes())
        data[4:8], data[25] = b"\x01\x02\x01\x03", 0
        path.write_bytes(data)


@pytest.fixture
def convert(capsys):
    def call(*arguments):
        code = cli.main(["convert", *map(str, arguments)])
        return code, capsys.readouterr()

    return call


VERSIONS = [("1.0", 1), ("1.1", 1), ("1.2", 3), ("1.3", 1), ("1.4", 3), ("1.4", 7), ("1.5", 6)]


@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize(("version", "form"), VERSIONS)
def test_every_version_is_read_and_copied(tmp_path, convert, version, form, ending):
    path = tmp_path / f"a.{ending}"
    write_las(path, version, form, gps_time=np.arange(10) * 0.5, intensity=np.arange(10))
    reader, back = read(path)
    assert back["points"][:, 0].tolist() == list(range(10)) and version in reader.kind
    assert back["GpsTime"].tolist() == (np.arange(10) * 0.5).tolist() and reader.header.epoch == 0
    for output in ("b.las", "b.laz"):
        code, said = convert(path, tmp_path / output, "--overwrite")
        copy = laspy.read(tmp_path / output)
        written = {"1.0": "1.2", "1.5": "1.4"}.get(version, version)
        assert code == 0 and str(copy.header.version) == written
        note = f"is LAS {version}; its records are copied to LAS {written}"
        assert (note in said.err + said.out) == (written != version)
        assert copy.header.global_encoding.gps_time_type == 0
        assert np.array_equal(copy.gps_time, back["GpsTime"])
        assert np.array_equal(copy.intensity, np.arange(10)) and copy.x[-1] == 9


@pytest.mark.parametrize("ending", ["las", "laz"])
def test_times_of_las_1_5_have_an_offset_of_their_own(tmp_path, convert, ending):
    def change(header):
        header.global_encoding.gps_time_offset = True
        header.gps_time_offset = 1400

    path = tmp_path / f"a.{ending}"
    write_las(path, "1.5", change=change, gps_time=np.arange(10) * 0.5)
    reader, back = read(path)
    assert reader.header.epoch + back["GpsTime"][3] == 1.4e9 + 1.5
    assert convert(path, tmp_path / "b.las")[0] == 0
    copy = laspy.read(tmp_path / "b.las")
    assert copy.gps_time[3] == 0.4e9 + 1.5 and copy.header.global_encoding.value == 1
    assert path.read_bytes()[25] == 5


@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize("late", [0, 256])
def test_colours_of_8_bits_are_found_in_the_whole_file(tmp_path, ending, late):
    red = np.array([255, 51, *[0] * 7, late])
    path = tmp_path / f"a.{ending}"
    write_las(path, form=8, red=red, nir=np.full(10, 255))
    reader, back = read(path, rows=3)
    full = 65535 if late else 255
    assert np.allclose(back["RGB"][:, 0], red / full, rtol=0, atol=1e-7)
    assert set(back["NearInfrared"]) == {255 if late else 65535}
    note = f"{path}: its colours have 8 bits: they are scaled by 257 to the 16 bits of LAS"
    assert reader.notes.count(note) == (not late)


@pytest.mark.parametrize("ending", ["las", "laz", "copc.laz"])
def test_dark_colours_of_our_files_are_as_they_are(tmp_path, ending):
    chunk = make_chunk(50)
    chunk["RGB"] = np.full((50, 3), 200 / 65535, np.float32)
    write(tmp_path / f"a.{ending}", chunk)
    reader, back = read(tmp_path / f"a.{ending}")
    assert np.allclose(back["RGB"], chunk["RGB"], rtol=0, atol=1e-7) and not reader.notes


@pytest.mark.parametrize("ending", ["las", "laz"])
def test_extra_bytes_without_value_or_description(tmp_path, ending):
    extras = [
        laspy.ExtraBytesParams("height", "f4", no_data=[-9999.0]),
        laspy.ExtraBytesParams("scaled", "i4", scales=[0.01], offsets=[1.0], no_data=[-1]),
        laspy.ExtraBytesParams("rest", "3u1"),
    ]
    path = tmp_path / f"a.{ending}"
    write_las(path, extras=extras, height=np.r_[-9999.0, np.arange(9)])
    data = laspy.read(path)
    data.points.array["scaled"] = np.r_[-1, np.arange(9)]
    data.write(path)
    raw = bytearray(path.read_bytes())
    at = raw.index(b"rest\0") - 4
    raw[at + 2 : at + 4] = bytes([0, 3])  # bytes that are not described
    path.write_bytes(raw)
    reader, back = read(path)
    assert np.isnan(back["height"][0]) and back["height"][1:].tolist() == list(range(9))
    assert np.isnan(back["scaled"][0]) and np.allclose(back["scaled"][1:], 1 + np.arange(9) / 100)
    text = "\n".join(reader.notes)
    assert f"{path}: height is not finite at 1 of 10 points" in text
    note = f"{path}: its points have 3 bytes that no Extra Bytes record describes by type and name"
    assert text.count(note) == 1 and "rest" not in back


@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize("form", [8, 7])
def test_near_infrared_is_kept_through_arrays(tmp_path, convert, form, ending):
    write_las(tmp_path / "a.las", form=form, red=np.arange(10) * 7000)
    write_las(tmp_path / "b.las", form=8, red=65535, nir=np.arange(10) * 7)
    code, _ = convert(tmp_path / "a.las", tmp_path / "b.las", tmp_path / f"c.{ending}", "--merge")
    merged = laspy.read(tmp_path / f"c.{ending}")
    assert code == 0 and merged.point_format.id == 8
    assert merged.nir.tolist() == [0] * 10 + (np.arange(10) * 7).tolist()
    assert merged.red.tolist() == (np.arange(10) * 7000).tolist() + [65535] * 10


FORMS = [(1, 6, 6), (6, 7, 7), (1, 3, 7), (0, 6, 6), (3, 8, 8), (2, 0, 7)]


@pytest.mark.parametrize(("one", "other", "written"), FORMS)
def test_unlike_point_formats_are_merged(tmp_path, convert, one, other, written):
    for name, form in (("a.las", one), ("b.las", other)):
        version = "1.2" if form < 6 else "1.4"
        write_las(tmp_path / name, version, form, intensity=np.arange(10) * 9)
    code, said = convert(tmp_path / "a.las", tmp_path / "b.las", tmp_path / "c.las", "--merge")
    merged = laspy.read(tmp_path / "c.las")
    assert code == 0 and merged.point_format.id == written
    assert merged.intensity.tolist() == (np.arange(10) * 9).tolist() * 2
    assert list(merged.x) == list(range(10)) * 2
    assert "has not all arrays of the others; its points get 0 for" in said.err + said.out


def test_unlike_extra_bytes_are_merged(tmp_path, convert):
    one = [laspy.ExtraBytesParams("Same", "f4"), laspy.ExtraBytesParams("Count", "u2")]
    other = [laspy.ExtraBytesParams("Same", "f8"), laspy.ExtraBytesParams("Height", "f8")]
    write_las(tmp_path / "a.laz", extras=one, Same=0.5, Count=7)
    write_las(tmp_path / "b.las", extras=other, Same=0.1, Height=3.0)
    code, said = convert(tmp_path / "a.laz", tmp_path / "b.las", tmp_path / "c.las", "--merge")
    merged = laspy.read(tmp_path / "c.las")
    assert code == 0 and merged["Same"].dtype == np.float64
    assert merged["Same"].tolist() == [0.5] * 10 + [0.1] * 10
    assert merged["Count"].tolist() == [7] * 10 + [0] * 10
    assert np.isnan(merged["Height"][:10]).all() and merged["Height"][10:].tolist() == [3] * 10
    text = said.err + said.out
    assert "a.laz: has not all arrays of the others; its points get NaN for Height" in text
    assert "b.las: has not all arrays of the others; its points get 0 for Count" in text


def test_points_without_amplitudes_are_kept_in_text(tmp_path, convert):
    """Its writer drops points with numbers that are not finite."""
    write(tmp_path / "a.ply", make_chunk(5), formats.Header())
    write_las(tmp_path / "b.las")
    code, said = convert(tmp_path / "a.ply", tmp_path / "b.las", tmp_path / "c.xyz", "--merge")
    _, back = read(tmp_path / "c.xyz")
    assert code == 0 and len(back["points"]) == 15
    assert back["Amplitude"][5:].tolist() == [0.0] * 10
    assert "b.las: has not all arrays of the others; its points get 0 for Amplitude" in said.err


def test_arrays_of_unlike_components_are_an_error(tmp_path, convert):
    points = {"points": np.zeros((2, 3))}
    write(tmp_path / "a.ply", {**points, "Echo": np.zeros(2)}, formats.Header())
    write(tmp_path / "b.vtp", {**points, "Echo": np.zeros((2, 3))}, formats.Header())
    code, said = convert(tmp_path / "a.ply", tmp_path / "b.vtp", tmp_path / "c.las", "--merge")
    assert code == 1 and "b.vtp: Echo has 3 values per point, and 1 in " in said.err
    assert not (tmp_path / "c.las").exists()


@pytest.mark.parametrize("ending", ["ply", "e57", "vtp"])
def test_las_is_merged_with_other_formats(tmp_path, convert, ending):
    if ending == "e57":
        pytest.importorskip("pye57")
    write_las(tmp_path / "a.las", form=7, red=65535)
    chunk = {"points": np.ones((2, 3)), "Intensity": np.array([1, 2], np.uint16)}
    write(tmp_path / f"b.{ending}", chunk, formats.Header())
    code, said = convert(
        tmp_path / "a.las", tmp_path / f"b.{ending}", tmp_path / "c.las", "--merge"
    )
    merged = laspy.read(tmp_path / "c.las")
    assert code == 0 and merged.red.tolist() == [65535] * 10 + [0] * 2
    assert merged.intensity.tolist()[-2:] == [1, 2]
    assert list(merged.return_number) == [1] * 12
    assert "-1 for LegIds; 1 for NumberOfReturns, ReturnNumber" in said.err + said.out


def test_times_are_merged_at_one_epoch(tmp_path, convert):
    """A file without times does not matter; one without an epoch does."""
    times = {"points": np.ones((1, 3)), "GpsTime": np.array([5.0])}
    for name, epoch in (("a.vtp", 1e9), ("b.vtp", 1e9 + 3600), ("c.vtp", 0.0)):
        header = formats.Header()
        header.epoch = epoch
        write(tmp_path / name, times, header)
    write(tmp_path / "d.vtp", {"points": np.zeros((1, 3))}, formats.Header())
    files = [tmp_path / name for name in ("d.vtp", "a.vtp", "b.vtp")]
    assert convert(*files, tmp_path / "m.vtp", "--merge")[0] == 0
    reader, back = read(tmp_path / "m.vtp")
    assert reader.header.epoch == 1e9 and back["GpsTime"].tolist() == [0, 5, 3605]
    code, said = convert(*files, tmp_path / "c.vtp", tmp_path / "n.vtp", "--merge")
    assert code == 1 and "c.vtp: its times count from 0 s of GPS time" in said.err


def test_copc_has_the_range_of_its_times(tmp_path):
    chunk = make_chunk(1000)
    write(tmp_path / "a.copc.laz", chunk)
    data = (tmp_path / "a.copc.laz").read_bytes()
    times = laspy.read(tmp_path / "a.copc.laz").gps_time
    assert struct.unpack_from("<2d", data, 375 + 54 + 56) == (times.min(), times.max())
    assert times.max() > times.min() > 0


def test_waveforms_of_alternating_channels(tmp_path, convert):
    """lazrs mixes up the references of packets when it writes; LASzip does not."""
    pytest.importorskip("laszip")
    count = 1000
    offsets = 60 + 100 * np.arange(count, dtype=np.uint64)
    write_las(tmp_path / "a.las", form=9, count=count, scanner_channel=np.arange(count) % 4,
              wavepacket_index=1, wavepacket_offset=offsets, wavepacket_size=100)  # fmt: skip
    (tmp_path / "a.wdp").write_bytes(bytes(60 + 100 * count))
    assert convert(tmp_path / "a.las", tmp_path / "b.laz")[0] == 0
    copy = laspy.read(tmp_path / "b.laz", laz_backend=laspy.LazBackend.Laszip)
    assert np.array_equal(copy.wavepacket_offset, offsets)
    assert np.array_equal(copy.scanner_channel, np.arange(count) % 4)
