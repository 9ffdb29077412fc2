# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exported scans as a data set of PyTorch."""

import importlib
import shutil

import numpy as np
import pytest

from vtkhelios import formats


def test_without_pytorch_the_error_says_what_to_install(monkeypatch):
    modules = __import__("sys").modules
    monkeypatch.delitem(modules, "vtkhelios.learning.torch_data", raising=False)
    monkeypatch.setitem(modules, "torch", None)
    with pytest.raises(
        ImportError, match="data sets of PyTorch need the package torch.*pip install"
    ):
        importlib.import_module("vtkhelios.learning.torch_data")


@pytest.fixture(scope="module")
def torch():
    return pytest.importorskip("torch")


@pytest.fixture
def make(torch):
    from vtkhelios.learning.torch_data import ScanDataset

    return ScanDataset


def test_elements_are_the_files(make, torch, exports):
    folder = exports("semantickitti")
    scans = make(folder)
    assert isinstance(scans, torch.utils.data.Dataset) and len(scans) == 10
    sequence, element = folder / "sequences/00", scans[4]
    rows = np.fromfile(sequence / "velodyne/000004.bin", np.float32).reshape(-1, 4)
    words = np.fromfile(sequence / "labels/000004.label", np.uint32)
    assert np.array_equal(element["points"].numpy(), rows[:, :3])
    assert np.array_equal(element["intensity"].numpy(), rows[:, 3])
    assert np.array_equal(element["labels"].numpy(), words & 0xFFFF)
    assert np.array_equal(element["instances"].numpy(), words >> 16)
    assert element["time"] == pytest.approx(0.4)
    # The middle of the scan, on the roof of the car.
    assert element["pose"][:3, 3].tolist() == pytest.approx([-30 + 7 * 0.45, -1.7, 1.8], abs=1e-6)
    assert "labels" not in make(exports("kitti"))[0]
    assert make(folder, transform=lambda each: each["labels"].max())[0] >= 252


def test_a_loader_joins_scans(make, torch, exports):
    from vtkhelios.learning.torch_data import collate

    scans = make(exports("semantickitti"))
    batches = list(torch.utils.data.DataLoader(scans, batch_size=4, collate_fn=collate))
    assert [len(batch["pose"]) for batch in batches] == [4, 4, 2]
    first = batches[0]
    begin, end = first["offsets"][2:4].tolist()
    assert torch.equal(first["points"][begin:end], scans[2]["points"])
    assert first["offsets"][-1] == len(first["points"]) == len(first["labels"])


def test_folders_that_are_not_whole(make, exports, tmp_path):
    with pytest.raises(formats.FormatError, match="has no sequences/00/velodyne/"):
        make(tmp_path)
    folder = tmp_path / "out"
    shutil.copytree(exports("semantickitti"), folder)
    scans, sequence = make(folder), folder / "sequences/00"
    label = sequence / "labels/000001.label"
    label.write_bytes(label.read_bytes()[:-4])
    with pytest.raises(formats.FormatError, match="000001.label: has .* labels for .* points"):
        scans[1]
    points = sequence / "velodyne/000002.bin"
    points.write_bytes(points.read_bytes()[:-4])
    with pytest.raises(formats.FormatError, match="000002.bin: its .* bytes are no whole points"):
        scans[2]
    (sequence / "velodyne/000009.bin").unlink()
    with pytest.raises(formats.FormatError, match="poses.txt: has 10 lines for 9 scans"):
        make(folder)
