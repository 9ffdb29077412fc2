# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""PulseWaves: files made here by the specification, damaged ones, and files of an instrument."""

import os
import pathlib
import struct

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli, formats

DEFAULT = pathlib.Path(__file__).resolve().parents[4] / "shared" / "data"
REAL = pathlib.Path(os.environ.get("HELIOS_DATA", DEFAULT)) / "real" / "waveform"
RIEGL = REAL / "100429_152240_2535pt_UTM.pls"
HALF_LIGHT = 0.149896229  # [m/ns]


def record(number, data):
    head = struct.pack("<16sIIq64s", b"PulseWaves_Spec", number, 0, len(data), b"")
    return head + data


def sampling(kind, channel, bits, segments, samples, sample_bits):
    """bits: of duration, number of segments, number of samples; durations in half units plus 10."""
    duration, some, many = bits
    return struct.pack(
        "<IIBBBBffBBHIHHfI", 40, 0, kind, channel, 0, duration, 0.5, 10.0, some, many, segments,
        samples, sample_bits, 0, 2.0, 0,
    )  # fmt: skip


def descriptor(centre, extra, *samplings):
    return struct.pack("<IIiHHfII", 28, 0, centre, extra, len(samplings), 2.0, 0, 0) + b"".join(
        samplings
    )


FIXED = descriptor(4, 3, sampling(1, 7, (16, 0, 0), 1, 3, 8), sampling(2, 0, (16, 0, 0), 1, 4, 16))
VARIABLE = descriptor(0, 0, sampling(2, 1, (32, 8, 16), 0, 0, 32))


def write(folder, appended=False):
    """Three pulses: of fixed samples, of two segments, and without a waveform."""
    waves = bytearray(b"PulseWavesWaves\0".ljust(60, b"\0"))
    places = [len(waves)]
    waves += b"xyz" + struct.pack("<h3B", -6, 1, 2, 3) + struct.pack("<h4H", 100, 5, 6, 700, 8)
    places.append(len(waves))
    waves += struct.pack("<BiHII", 2, 2000, 2, 70000, 9) + struct.pack(
        "<iH30I", 3000, 30, *range(1, 31)
    )
    pulses = b""
    for index, place, flags in ((1, places[0], 32), (2, places[1], 16), (0, places[1], 48)):
        anchor, target = (1000 * index, 0, 0), (1000 * index, 0, -149_000)
        pulses += struct.pack(
            "<qq3i3ihhBBBB", 5000 + index, place, *anchor, *target, 0, 0, index, flags, 0, 0
        )
    before = record(200001, FIXED) + (b"" if appended else record(200002, VARIABLE))
    after = record(0xFFFFFFFF, b"")
    if appended:  # the data first, then the head
        whole = record(200002, VARIABLE)
        after += whole[96:] + whole[:96]
    head = struct.pack(
        "<16s16x8x128xHHBBHqqIIIIqIi", b"PulseWavesPulse", 1, 2026, 0, 3, 352, 352 + len(before), 3,
        0, 0, 48, 0, 0, 1 if appended else 2, -1,
    )  # fmt: skip
    head += struct.pack("<2d2q", 1e-3, 100.0, 0, 0) + struct.pack(
        "<6d", *(3 * (1e-3,)), 10.0, 20.0, 30.0
    )
    (folder / "a.pls").write_bytes(head.ljust(352, b"\0") + before + pulses + after)
    (folder / "a.wvs").write_bytes(waves)
    return folder / "a.pls"


def samples_of(table):
    return [
        table["Samples"][first : first + count].tolist()
        for first, count in zip(table["Offset"], table["Count"])
    ]


@pytest.mark.parametrize("appended", [False, True])
def test_pulses_and_samples_by_the_specification(tmp_path, appended):
    found = formats.read_pulsewaves(write(tmp_path, appended))
    pulses = vtkhelios.arrays(found.pulses)
    assert pulses["points"].tolist() == [[11, 20, 30], [12, 20, 30], [10, 20, 30]]
    assert np.allclose(pulses["GpsTime"], [105.001, 105.002, 105.0])
    assert np.allclose(pulses["Direction"], [0, 0, -1])
    assert pulses["ScanDirectionFlag"].tolist() == [1, 0, 1]
    assert pulses["EdgeOfFlightLine"].tolist() == [0, 1, 1]
    back = vtkhelios.arrays(found.returning)
    assert back["PulseIds"].tolist() == [0, 1, 1] and back["ChannelIds"].tolist() == [0, 1, 1]
    assert samples_of(back) == [[5, 6, 700, 8], [70000, 9], list(range(1, 31))]
    assert back["BinSize"].tolist() == [2, 2, 2]
    # 0.149 m a unit: 100, 2000 and 3000 halves and ten units after the anchor
    depth = HALF_LIGHT * back["StartTime"]
    assert np.allclose(depth, 0.149 * np.array([60, 1010, 1510]), rtol=1e-12)
    assert np.allclose(back["Origin"][:, 2], 30.0)
    out = vtkhelios.arrays(found.outgoing)
    assert out["PulseIds"].tolist() == [0] and samples_of(out) == [[1, 2, 3]]
    # Place of the optical centre, four units before the anchor.
    assert np.allclose(out["Origin"][0], [11, 20, 30 + 4 * 0.149])
    assert np.isclose(HALF_LIGHT * out["StartTime"][0], 0.149 * (10 - 3))


def change(path, place, form, *values):
    data = bytearray(path.read_bytes())
    struct.pack_into(form, data, place, *values)
    path.write_bytes(data)


@pytest.mark.parametrize(
    "file, place, form, value, message",
    [
        ("pls", 0, "<s", b"p", "a.pls: is not a PulseWaves file: it does not start with"),
        ("pls", 173, "<B", 4, "a.pls: is PulseWaves 0.4 with pulses of format 0; version 0.3"),
        ("pls", 192, "<I", 1, "a.pls: is PulseWaves 0.3 with pulses of format 1; version 0.3"),
        ("pls", 204, "<I", 1, "a.pls: has compressed pulses, which cannot be read; write them"),
        ("pls", 200, "<I", 47, "a.pls: has a header of 352 bytes, pulses of 47 bytes"),
        ("pls", 184, "<q", 9, "a.pls: is cut off: it has 5 whole pulses of the 9 that its header"),
        ("pls", 224, "<d", float("nan"), "a.pls: has a scale or offset that is not a number"),
        ("pls", 256, "<d", 0.0, None),
        ("pls", 256, "<d", 1e308, "a.pls: has coordinates or times that are not finite"),
        ("pls", 476 + 12, "<f", float("inf"), "a.pls: pulse 0 has samples every 2.0 ns at times"),
        ("pls", 476 + 32, "<f", 0.0, "a.pls: pulse 0 has samples every 0.0 ns at times"),
        ("pls", 272, "<d", 0.0, "a.pls: pulse 0 has no direction: anchor and target are the same"),
        (
            "pls",
            352 + 24,
            "<q",
            10**9,
            "a.pls: is cut off within its record 200001; copy it again",
        ),
        ("pls", 352 + 16, "<I", 200009, "a.pls: pulse 0 refers to pulse descriptor 1, which the"),
        ("pls", 352 + 96 + 14, "<H", 90, "a.pls: has a pulse descriptor 200001 that is cut off"),
        ("pls", 352 + 96 + 28 + 28, "<H", 12, "a.pls: pulse 0 has samples of 12 bits after"),
        ("pls", 352 + 96 + 28 + 20, "<B", 32, "bits after integers of (32, 16, 0) bits; 8, 16 and"),
        ("pls", 720 + 96 + 44, "<B", 2, "a.pls: its pulses refer to 267 bytes of samples, but"),
        ("wvs", 0, "<s", b"p", "a.wvs: is not the samples of a PulseWaves file; copy it again"),
        ("wvs", 16, "<I", 1, "a.wvs: has compressed samples, which cannot be read; write them"),
        ("wvs", 60 + 18 + 5, "<H", 60000, "a.wvs: is cut off: the samples of pulse 1 end at byte"),
    ],
)
def test_damaged_files_are_errors(tmp_path, file, place, form, value, message):
    path = write(tmp_path)
    change(tmp_path / f"a.{file}", place, form, value)
    if message is None:
        assert formats.read_pulsewaves(path).pulses.GetNumberOfPoints() == 3
        return
    with pytest.raises(formats.FormatError) as error:
        formats.read_pulsewaves(path)
    assert message in str(error.value)


def test_several_segments_need_durations(tmp_path):
    path = write(tmp_path)
    change(path, 352 + 96 + 28 + 11, "<B", 0)  # bits of the outgoing sampling
    change(path, 352 + 96 + 28 + 22, "<H", 60000)  # its segments
    with pytest.raises(formats.FormatError, match="pulse 0 has 60000 segments without a duration"):
        formats.read_pulsewaves(path)


def test_short_and_missing_files_are_errors(tmp_path, capsys):
    path = write(tmp_path)
    whole = path.read_bytes(), path.with_suffix(".wvs").read_bytes()
    for size in range(0, len(whole[0]) - 96, 7):  # up to the mark of the end
        path.write_bytes(whole[0][:size])
        with pytest.raises(formats.FormatError, match="a.pls: "):
            formats.read_pulsewaves(path)
    path.write_bytes(whole[0])
    for size in range(len(whole[1])):
        path.with_suffix(".wvs").write_bytes(whole[1][:size])
        with pytest.raises(formats.FormatError, match="a.wvs: "):
            formats.read_pulsewaves(path)
    path.with_suffix(".wvs").unlink()
    assert (
        cli.main(["detect", str(path), "--pulse-length", "4", "-o", str(tmp_path / "a.xyz")]) == 1
    )
    assert "a.wvs, which is missing; keep the two together" in capsys.readouterr().err
    with pytest.raises(formats.FormatError, match="none.pls: no such file"):
        formats.read_pulsewaves(tmp_path / "none.pls")


@pytest.mark.skipif(not RIEGL.is_file(), reason="without the data of the vendor")
def test_samples_and_places_equal_those_of_las():
    """Every packet of the .las is a segment of the .pls; positions are rounded to 1 mm in 149 m."""
    reader = vtkhelios.vtkHeliosLASReader()
    reader.SetFileName(str(RIEGL.with_suffix(".las")))
    reader.ReadWaveformsOn()
    vtkhelios.update(reader)
    las = vtkhelios.arrays(reader.GetOutputDataObject(1))
    found = formats.read_pulsewaves(RIEGL)
    pls = vtkhelios.arrays(found.returning)
    starts = [
        one["Origin"] + HALF_LIGHT * one["StartTime"][:, None] * one["Direction"]
        for one in (las, pls)
    ]
    segments, used, away = samples_of(pls), set(), []
    for row, samples in enumerate(samples_of(las)):
        near = np.flatnonzero(np.abs(pls["GpsTime"] - las["GpsTime"][row]) < 1e-6)
        distance = np.linalg.norm(starts[1][near] - starts[0][row], axis=1)
        best = near[np.argmin(distance)]
        padded = segments[best]
        assert padded[: len(samples)] == samples and not any(
            padded[len(samples) :]
        )  # zeros dropped
        used.add(best)
        away.append(distance.min())
    assert len(used) == len(away) == 2375
    assert max(away) < 0.006 and np.median(away) < 0.003
    assert len(segments) == 2392  # also of the second detector
    out = vtkhelios.arrays(found.outgoing)
    assert len(out["PulseIds"]) == 2368 and (out["Count"] == 24).all()
