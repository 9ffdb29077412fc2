# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scanners from the calibration of their manufacturers."""

import json
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import vtkhelios
from vtkhelios.surveys import instruments

LEGACY = {
    "prod_line": "OS-1-3",
    "prod_sn": "12",
    "lidar_mode": "512x20",
    "beam_altitude_angles": [10.5, 0, -20.25],
    "beam_azimuth_angles": [4.21, 0, -1.4],
    "lidar_origin_to_beam_origin_mm": 15.806,
    "lidar_to_sensor_transform": [-1, 0, 0, 1, 0, -1, 0, 2, 0, 0, 1, 36.18, 0, 0, 0, 1],
}
NEWER = {
    "sensor_info": {"prod_line": "OS-1-3", "prod_sn": "12"},
    "config_params": {"lidar_mode": "512x20"},
    "beam_intrinsics": {
        "beam_altitude_angles": [10.5, 0, -20.25],
        "beam_azimuth_angles": [4.21, 0, -1.4],
        "beam_to_lidar_transform": [1, 0, 0, 15.806, 0, 1, 0, 0, 0, 0, 1, 2.5, 0, 0, 0, 1],
    },
    "lidar_intrinsics": {"lidar_to_sensor_transform": LEGACY["lidar_to_sensor_transform"]},
}


@pytest.fixture
def metadata(tmp_path):
    """Writes metadata with changes; returns the path."""

    def write(changes=(), base=LEGACY):
        path = tmp_path / "os1.json"
        facts = {**base, **dict(changes)}
        path.write_text(json.dumps({k: v for k, v in facts.items() if v is not None}))
        return path

    return write


def scanner_of(text):
    return ET.fromstring(text).find("scanner")


def test_values(metadata):
    scanner = scanner_of(instruments.read_ouster(metadata()))
    assert scanner.get("id") == "os1_3_512x20" and scanner.get("name") == "Ouster OS-1-3 12"
    assert float(scanner.get("pulseFreqs_Hz")) == 512 * 20 * 3
    assert scanner.get("spin") == "clockwise" and abs(float(scanner.get("spinStart_deg"))) == 180
    assert [float(scanner.find("beamOrigin").get(k)) for k in "xyz"] == [-0.002, 0.001, 0.03618]
    beams = scanner.findall("beams/beam")
    assert [float(beam.get("elevation_deg")) for beam in beams] == [10.5, 0, -20.25]
    assert [float(beam.get("azimuth_deg")) for beam in beams] == [-4.21, 0, 1.4]
    assert {float(beam.get("originOffset_m")) for beam in beams} == {0.015806}
    assert {float(beam.get("originHeight_m")) for beam in beams} == {0}
    assert {float(beam.get("firingTime_s")) for beam in beams} == {0}


def test_sections_of_newer_firmware(metadata):
    old = scanner_of(instruments.read_ouster(metadata(), 'a"b<'))
    new = scanner_of(instruments.read_ouster(metadata(base=NEWER), 'a"b<'))
    assert old.get("id") == 'a"b<' and old.attrib == new.attrib
    assert {float(beam.get("originHeight_m")) for beam in new.iter("beam")} == {0.0025}
    for one, other in zip(old.iter("beam"), new.iter("beam")):
        names = ("elevation_deg", "azimuth_deg", "originOffset_m")
        assert [one.get(name) for name in names] == [other.get(name) for name in names]


def test_pulses_of_the_scanner(metadata, tmp_path):
    (tmp_path / "os1.xml").write_text(instruments.read_ouster(metadata(), "own"))
    plane = vtkhelios.Scene(
        [[-50, -50, 0], [50, -50, 0], [50, 50, 0], [-50, 50, 0]], [[0, 1, 2], [0, 2, 3]]
    )
    settings = dict(assets=tmp_path, scan_frequency=20, duration=0.05, noise=False, pulses=True)
    cloud = vtkhelios.scan(plane, (0, 0, 0), scanner="os1.xml#own", columns=True, **settings)
    pulses = cloud.pulses
    assert len(pulses) == 512 * 3
    ids = pulses["PulseIds"]
    assert np.array_equal(pulses["ChannelIds"], ids % 3)
    assert np.array_equal(pulses["ColumnIds"], ids // 3)
    assert np.abs(pulses["GpsTime"] - ids // 3 / 10240).max() < 1e-15
    # Ouster's formulas; the sensor's frame is turned by 180 degrees, its x is our y.
    encoder = np.pi + 2 * np.pi * (1 - (ids // 3) / 512)
    azimuth = encoder - np.radians(np.take([4.21, 0, -1.4], ids % 3))
    altitude = np.radians(np.take([10.5, 0, -20.25], ids % 3))
    expected = np.stack([-np.sin(azimuth), np.cos(azimuth), np.tan(altitude)], axis=1)
    assert np.abs(pulses["Direction"] - expected * np.cos(altitude)[:, None]).max() < 1e-12
    circle = 0.015806 * np.stack([-np.sin(encoder), np.cos(encoder), 0 * encoder], axis=1)
    assert np.abs(pulses.points - circle - [-0.002, 0.001, 1.53618]).max() < 1e-12
    hit = cloud["PulseIds"]
    assert set(cloud["ChannelIds"]) == {2} and np.array_equal(cloud["ColumnIds"], hit // 3)
    assert "ColumnIds" not in vtkhelios.scan(plane, (0, 0, 0), scanner="os1.xml#own", **settings)


@pytest.mark.parametrize(
    "changes, message",
    [
        ({"beam_azimuth_angles": [1, 2]}, "beam_altitude_angles has 3 values, but beam_azimuth_a"),
        ({"beam_altitude_angles": None}, "has no beam_altitude_angles; give the metadata of an Ou"),
        ({"beam_altitude_angles": [1, "2", 3]}, "beam_altitude_angles[1] is '2', not a number"),
        ({"beam_altitude_angles": [1, 2, 95]}, "beam_altitude_angles[2] is 95; give an angle from"),
        ({"beam_altitude_angles": []}, "beam_altitude_angles is not a list of one or more numbers"),
        (
            {"beam_azimuth_angles": [float("nan"), 1, 2]},
            "is not valid JSON: NaN is not a valid JSON number; give the metadata",
        ),
        ({"lidar_mode": "fast"}, "lidar_mode is 'fast'; expected columns x revolutions/s"),
        ({"lidar_mode": "0x10"}, "lidar_mode is '0x10'; expected"),
        ({"lidar_mode": None}, "lidar_mode is None; expected"),
        ({"lidar_origin_to_beam_origin_mm": True}, "beam_origin_mm[0] is True, not a number"),
        ({"lidar_origin_to_beam_origin_mm": 1e5}, "the beams start 100000 mm from the origin"),
        (
            {"beam_to_lidar_transform": [1, 2]},
            "beam_to_lidar_transform is not a list of 16 numbers",
        ),
        (
            {"lidar_to_sensor_transform": [1, 0, 0, 2e4, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
            "the lidar is 20000 mm from the origin; give at most 10000 mm",
        ),
        (
            {"lidar_to_sensor_transform": [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1]},
            "lidar_to_sensor_transform does not rotate about z",
        ),
    ],
)
def test_values_that_are_not_valid(metadata, changes, message):
    path = metadata(changes)
    with pytest.raises(instruments.InstrumentError) as error:
        instruments.read_ouster(path)
    assert str(error.value).startswith(f"{path}: ") and message in str(error.value)


@pytest.mark.parametrize(
    "content, message",
    [
        (b"{", "is not valid JSON: Expecting property name"),
        (b"\xff\xfe{}", "byte 0 is not UTF-8; give the metadata of the sensor"),
        (b"[1]", "is not a JSON object"),
        (
            b'{"lidar_mode": "512x20", "beam_altitude_angles": [1e999]}',
            r"beam_altitude_angles\[0\] is inf; give a finite",
        ),
        (b"[" * 100000, "is nested too deeply; give the metadata"),
    ],
)
def test_files_that_are_not_metadata(tmp_path, content, message):
    path = tmp_path / "os1.json"
    path.write_bytes(content)
    with pytest.raises(instruments.InstrumentError, match=message):
        instruments.read_ouster(path)


def test_command(metadata, tmp_path, command_line):
    path = metadata()
    printed = command_line("instrument", path, "--id", "roof")
    assert printed.returncode == 0 and scanner_of(printed.stdout).get("id") == "roof"
    out = tmp_path / "os1.xml"
    written = command_line("instrument", path, "--id", "roof", "--output", out)
    assert (written.returncode, written.stdout) == (0, f"{out}\n")
    assert out.read_text() == printed.stdout
    assert command_line("validate", out).returncode == 0


def test_command_errors(metadata, tmp_path, command_line):
    path = metadata({"lidar_mode": "fast"})
    done = command_line("instrument", path)
    assert done.returncode == 1 and done.stderr.startswith(f"error: {path}: lidar_mode is 'fast'")
    done = command_line("instrument", tmp_path / "none.json")
    assert done.returncode == 1 and "No such file or directory; check the name" in done.stderr
    nowhere = tmp_path / "none" / "os1.xml"
    done = command_line("instrument", metadata(), "--output", nowhere)
    assert done.returncode == 1 and f"{nowhere}: cannot be written" in done.stderr
    assert "give another --output" in done.stderr
