# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waveforms of an airborne RIEGL scanner, LAS 1.4 point format 9, against PulseWaves of the same pulses.

The files come from github.com/PulseWaves/PulseWaves, data/RIEGL. HELIOS_DATA names the folder that
has them as real/waveform/; without it: data of a folder "shared" beside the repository."""

import os
import pathlib
import struct

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios

DEFAULT = pathlib.Path(__file__).resolve().parents[5] / "shared" / "data"
FOLDER = pathlib.Path(os.environ.get("HELIOS_DATA", DEFAULT)) / "real" / "waveform"
LAS = FOLDER / "100429_152240_2535pt_UTM.las"
LIGHT = 0.299792458  # [m/ns]

pytestmark = pytest.mark.skipif(not LAS.is_file(), reason="without the data of the vendor")


@pytest.fixture(scope="module")
def riegl():
    """The cloud and its waveforms as arrays, and the messages."""
    reader = vtkhelios.vtkHeliosLASReader()
    messages = []
    reader.AddObserver("WarningEvent", lambda *_: messages.append(1))
    reader.SetFileName(str(LAS))
    reader.ReadWaveformsOn()
    vtkhelios.update(reader)
    assert not messages
    table = reader.GetOutputDataObject(1)
    waves = {
        table.GetColumnName(i): vtk_to_numpy(table.GetColumn(i)).copy()
        for i in range(table.GetNumberOfColumns())
    }
    return vtkhelios.arrays(reader.GetOutput()), waves


@pytest.fixture(scope="module")
def points():
    """Raw fields of each point: packet, location [ps], return number."""
    data = LAS.read_bytes()
    begin, length = struct.unpack_from("<I", data, 96)[0], struct.unpack_from("<H", data, 105)[0]
    form = np.dtype({
        "names": ["return", "packet", "location", "vector"],
        "formats": ["u1", "<u8", "<f4", ("<f4", 3)],
        "offsets": [14, 31, 43, 47],
        "itemsize": length,
    })  # fmt: skip
    return np.frombuffer(data, form, offset=begin)


def get_pulses():
    """GPS time, anchor [m], direction per nanosecond [m/ns], first and last sample of PulseWaves 0.3."""
    data = LAS.with_suffix(".pls").read_bytes()
    begin, count = struct.unpack_from("<qq", data, 176)
    scale, offset = struct.unpack_from("<3d", data, 256), struct.unpack_from("<3d", data, 280)
    form = np.dtype([
        ("time", "<i8"), ("waves", "<i8"), ("anchor", "<i4", 3), ("target", "<i4", 3),
        ("first", "<i2"), ("last", "<i2"), ("rest", "<u4"),
    ])  # fmt: skip
    pulses = np.sort(np.frombuffer(data, form, count, begin), order="time")
    anchor, target = pulses["anchor"] * scale + offset, pulses["target"] * scale + offset
    time = pulses["time"] * struct.unpack_from("<d", data, 224)[0]
    return time, anchor, (target - anchor) / 1000.0, pulses["first"], pulses["last"]


def test_all_packets_are_read(riegl, points):
    cloud, waves = riegl
    assert len(cloud["points"]) == 2535
    assert len(waves["PulseIds"]) == len(np.unique(points["packet"])) == 2375
    assert set(waves["Count"]) <= set(range(1, 121)) and waves["Count"].max() == 120
    assert np.all(waves["BinSize"] == 1.0)


def test_beams_point_downwards(riegl, points):
    cloud, waves = riegl
    assert np.all(points["vector"][:, 2] > 1.4e-4)  # [m/ps], to the scanner
    assert np.all(waves["Direction"][:, 2] < -0.9)
    first = waves["PulseIds"]  # no ids: the rows of the first points
    assert np.all(waves["Origin"][:, 2] > cloud["points"][first, 2])
    # on its waveform the point has the file position, although light is slower in air
    time = waves["StartTime"] + 1e-3 * points["location"][first]
    found = waves["Origin"] + (0.5 * LIGHT * time)[:, None] * waves["Direction"]
    assert np.abs(found - cloud["points"][first]).max() < 1e-6
    assert np.abs(waves["StartTime"]).max() < 0.03  # [ns]


def test_the_later_of_two_echoes_is_farther(riegl, points):
    cloud, waves = riegl
    pairs = 0
    for row, origin, direction in zip(waves["PulseIds"], waves["Origin"], waves["Direction"]):
        echoes = np.flatnonzero(points["packet"] == points["packet"][row])
        echoes = echoes[np.argsort(points["return"][echoes] & 15)]
        distance = (cloud["points"][echoes] - origin) @ direction
        assert np.all(np.diff(distance) > 0.0)
        pairs += len(echoes) > 1
    assert pairs == 144 + 8


def test_origins_equal_those_of_pulsewaves(riegl):
    _, waves = riegl
    time, anchor, step, first, last = get_pulses()
    after = np.clip(np.searchsorted(time, waves["GpsTime"]), 1, len(time) - 1)
    pulse = np.where(
        waves["GpsTime"] - time[after - 1] < time[after] - waves["GpsTime"], after - 1, after
    )
    assert np.abs(waves["GpsTime"] - time[pulse]).max() < 1e-6
    speed = np.linalg.norm(step[pulse], axis=1)
    beam = step[pulse] / speed[:, None]
    assert np.abs(waves["Direction"] - beam).max() < 1e-5  # targets are rounded to 1 mm in 149 m
    way = waves["Origin"] - anchor[pulse]
    along = (way * beam).sum(axis=1)
    assert np.linalg.norm(way - along[:, None] * beam, axis=1).max() < 0.006
    sample = along / speed  # [ns] after the anchor: within the digitized part of the pulse
    assert np.all(sample > first[pulse] - 0.2)
    assert np.all(sample < last[pulse])
    assert np.median(np.abs(sample - first[pulse])) < 0.1  # except for later segments


def test_fields_of_riegl_have_the_names_of_ours(riegl):
    """Decibels are no watts: the file's Amplitude is 0.01 dB, its Pulse width 0.1 ns per unit."""
    cloud, _ = riegl
    assert "Amplitude" not in cloud and "Pulse width" not in cloud
    raw = np.frombuffer(LAS.read_bytes(), np.uint8)
    begin = struct.unpack_from("<I", raw, 96)[0]
    length = struct.unpack_from("<H", raw, 105)[0]
    rows = raw[begin : begin + length * len(cloud["Intensity"])].reshape(-1, length)
    fields = np.ascontiguousarray(rows[:, 59:63]).view("<u2")  # format 9 has 59 bytes
    assert np.allclose(cloud["RelativeAmplitude"], 0.01 * fields[:, 0], rtol=1e-12)
    assert np.allclose(cloud["EchoWidth"], 0.1 * fields[:, 1], rtol=1e-12)
    # a few below 0 dB have wrapped round in the file: 65469 for -0.67 dB
    assert np.quantile(cloud["RelativeAmplitude"], 0.99) < 50.0
