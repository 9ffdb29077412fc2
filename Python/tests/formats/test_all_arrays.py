# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""All arrays that echoes, pulses and trajectories may have, by format: here and by other readers."""

import numpy as np
import pytest
from _point_files import make_header, read, write

COUNT = 200

# By the array: its type and components.
ARRAYS = {
    "GpsTime": ("f8", 1), "PulseIds": ("i8", 1), "ReturnNumber": ("u1", 1), "NumberOfReturns": ("u1", 1),
    "Range": ("f8", 1), "Amplitude": ("f8", 1), "EchoWidth": ("f8", 1), "ScanAngle": ("f8", 1),
    "ClassificationIds": ("i4", 1), "MaterialIds": ("i4", 1), "PartIds": ("i4", 1), "CellIds": ("i8", 1),
    "IncidenceAngle": ("f8", 1), "WaveformIds": ("i8", 1), "LegIds": ("i4", 1), "ChannelIds": ("i4", 1),
    "Deviation": ("f8", 1), "ColumnIds": ("i8", 1), "RelativeAmplitude": ("f8", 1), "Reflectance": ("f8", 1),
    "TruePoint": ("f8", 3), "Normal": ("f8", 3), "RadialVelocity": ("f8", 1), "PartPosition": ("f8", 3),
    "PartOrientation": ("f8", 4), "PartVelocity": ("f8", 3), "SpecularEvents": ("i4", 1),
    "ScatteredAmplitude": ("f8", 1), "ScatteredDeviation": ("f8", 1), "RGB": ("f4", 3),
    "ScanDirectionFlag": ("u1", 1), "EdgeOfFlightLine": ("u1", 1), "Direction": ("f8", 3), "Hit": ("u1", 1),
    "Weight": ("f8", 1), "Orientation": ("f8", 4), "Velocity": ("f8", 3), "TreeIds": ("i4", 1),
    "SpeciesIds": ("i4", 1), "OrganIds": ("u1", 1), "WaterDepth": ("f8", 1), "UserData": ("u1", 1),
    "ClassificationFlags": ("u1", 1), "NearInfrared": ("u2", 1), "Intensity": ("u2", 1),
}  # fmt: skip

# By the format: arrays that it does not have, or not exactly.
PACKED = {"PartOrientation", "Orientation"}  # four components do not fit into Extra Bytes
LOST = {"las": PACKED, "laz": PACKED, "copc.laz": PACKED, "csv": set(), "pvtp": set(), "vtp": set(), "ply": set(),
        "pcd": set()}  # fmt: skip
FLOATS = {"pcd": {"Amplitude", "EchoWidth", "Intensity"}}  # arrays of single precision there


def make_arrays():
    random = np.random.default_rng(5)
    chunk = {"points": np.round(random.uniform(0, 100, (COUNT, 3)), 4)}
    for name, (kind, components) in ARRAYS.items():
        shape = (COUNT, components) if components > 1 else COUNT
        if kind[0] == "f":
            chunk[name] = random.uniform(0.01, 1, shape).astype(kind)
        else:
            chunk[name] = random.integers(0, 2, shape).astype(kind)
    chunk["GpsTime"] = np.arange(COUNT) * 0.25  # exact in another epoch
    chunk["PulseIds"] = np.arange(COUNT, dtype=np.int64) + 2**40
    chunk["CellIds"] = chunk["PulseIds"] - 2**41
    chunk["WaveformIds"] = np.where(np.arange(COUNT) % 2, chunk["PulseIds"], -1)
    chunk["NumberOfReturns"] = chunk["ReturnNumber"] = np.ones(COUNT, np.uint8)
    chunk["ScanAngle"] = np.round(chunk["ScanAngle"] / 0.006) * 0.006
    chunk["RGB"] = np.round(chunk["RGB"] * 255).astype(np.float32) / np.float32(255)
    chunk["NearInfrared"] = (chunk["NearInfrared"] * 40000).astype(np.uint16)
    chunk["Intensity"] = np.arange(COUNT, dtype=np.uint16) + 300
    return chunk


@pytest.mark.parametrize("ending", LOST)
def test_every_array_comes_back(tmp_path, ending):
    chunk = make_arrays()
    lost = LOST[ending]
    write(tmp_path / f"a.{ending}", {name: v for name, v in chunk.items() if name not in lost})
    reader, back = read(tmp_path / f"a.{ending}")
    assert set(back) == set(chunk) - lost
    order = np.argsort(back["PulseIds"])
    shift = reader.header.epoch - make_header().epoch if reader.header.epoch else 0.0
    for name, values in chunk.items():
        if name in lost:
            continue
        found = back[name][order].astype(float) + (shift if name == "GpsTime" else 0.0)
        close = 1e-6 if name in FLOATS.get(ending, ()) else 1e-9 if name == "ScanAngle" else 0.0
        close = 1e-5 if name == "points" else 2e-7 if name == "RGB" else close
        assert np.abs(found - values).max() <= close, name


def test_pandas_reads_every_column(tmp_path):
    pandas = pytest.importorskip("pandas")
    chunk = make_arrays()
    write(tmp_path / "a.csv", chunk)
    table = pandas.read_csv(tmp_path / "a.csv", float_precision="round_trip")
    names = {
        "ClassificationIds": "Classification",
        "NearInfrared": "Infrared",
        "ChannelIds": "ScanChannel",
    }
    for name, values in chunk.items():
        if values.ndim == 1:
            assert np.array_equal(table[names.get(name, name)], values), name
    assert np.array_equal(table[["TruePoint0", "TruePoint1", "TruePoint2"]], chunk["TruePoint"])
    assert np.array_equal(table[["X", "Y", "Z"]], chunk["points"])


def test_laspy_reads_the_extra_bytes(tmp_path):
    laspy = pytest.importorskip("laspy")
    chunk = {name: v for name, v in make_arrays().items() if name not in PACKED}
    write(tmp_path / "a.las", chunk)
    las = laspy.read(tmp_path / "a.las")
    for name in (
        "CellIds",
        "WaveformIds",
        "ColumnIds",
        "Weight",
        "SpecularEvents",
        "TreeIds",
        "Hit",
    ):
        assert np.array_equal(las[name], chunk[name]), name
    assert np.array_equal(las["PartVelocityY"], chunk["PartVelocity"][:, 1])


def test_plyfile_reads_the_properties(tmp_path):
    plyfile = pytest.importorskip("plyfile")
    chunk = make_arrays()
    write(tmp_path / "a.ply", chunk)
    rows = plyfile.PlyData.read(str(tmp_path / "a.ply"))["vertex"]
    for name in (
        "CellIds",
        "WaveformIds",
        "ColumnIds",
        "Weight",
        "SpecularEvents",
        "TreeIds",
        "Hit",
    ):
        assert np.array_equal(rows[name], chunk[name]), name
