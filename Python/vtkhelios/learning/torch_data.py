# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exported scans as a data set of PyTorch, which is needed: pip install torch.

>>> from vtkhelios.learning.torch_data import ScanDataset
>>> scans = ScanDataset("kitti")  # of vtkhelios export --semantickitti or --kitti
>>> scans[0]["points"], scans[0]["labels"]
"""

import pathlib

import numpy as np

from ..core.packages import load
from ..core.words import counted
from ..formats import FormatError

torch = load("torch", "data sets of PyTorch need")
_data = load("torch", "data sets of PyTorch need", "torch.utils.data")

__all__ = ["ScanDataset", "collate"]


class ScanDataset(_data.Dataset):
    """The scans of a folder of vtkhelios export --semantickitti or --kitti, in order.

    An element has the tensors ``points`` (n x 3, float32, in the frame of the sensor [m]),
    ``intensity`` (n, float32), ``pose`` (4 x 4, float64: from that frame to the coordinates of the
    run), ``time`` (float64, after the first scan [s]); of --semantickitti also ``labels`` and
    ``instances`` (n, int64). transform: called with the element; what it returns is the element.
    """

    def __init__(self, folder, transform=None):
        self.folder, self.transform = pathlib.Path(folder), transform
        sequence = self.folder / "sequences/00"
        self.files = sorted((sequence / "velodyne").glob("*.bin"))
        if not self.files:
            raise FormatError(
                f"{self.folder}: has no sequences/00/velodyne/*.bin; give the folder of vtkhelios "
                "export --semantickitti or --kitti"
            )
        self.has_labels = (sequence / "labels").is_dir()
        poses = sequence / "poses.txt" if self.has_labels else self.folder / "poses/00.txt"
        self.poses = _read_poses(sequence, poses)
        self.times = np.loadtxt(sequence / "times.txt", ndmin=1)
        for path, count in ((poses, len(self.poses)), (sequence / "times.txt", len(self.times))):
            if count != len(self.files):
                raise FormatError(
                    f"{path}: has {counted(int(count), 'line')} for {counted(len(self.files), 'scan')}; "
                    "export the run again"
                )

    def __len__(self):
        return len(self.files)

    def __getitem__(self, index):
        path = self.files[index]
        rows = _read_words(path, np.float32, 4).reshape(-1, 4)
        element = {
            "points": torch.from_numpy(rows[:, :3].copy()),
            "intensity": torch.from_numpy(rows[:, 3].copy()),
            "pose": torch.from_numpy(self.poses[index].copy()),
            "time": torch.tensor(self.times[index], dtype=torch.float64),
        }
        if self.has_labels:
            file = path.parents[1] / f"labels/{path.stem}.label"
            words = _read_words(file, np.uint32, 1).astype(np.int64)
            if len(words) != len(rows):
                raise FormatError(
                    f"{file}: has {counted(len(words), 'label')} for {counted(len(rows), 'point')}; "
                    "export the run again"
                )
            element["labels"] = torch.from_numpy(words & 0xFFFF)
            element["instances"] = torch.from_numpy(words >> 16)
        return self.transform(element) if self.transform else element


def collate(elements):
    """Joins elements for a DataLoader: points of all scans one after the other, and ``offsets``, where
    each begins and the last one ends."""
    counts = [len(element["points"]) for element in elements]
    joined = {"offsets": torch.tensor(np.cumsum([0, *counts]))}
    for key in elements[0]:
        values = [element[key] for element in elements]
        joined[key] = torch.stack(values) if key in ("pose", "time") else torch.cat(values)
    return joined


def _read_words(path, kind, columns):
    """Returns the numbers of a file; FormatError if it does not have whole rows."""
    if path.stat().st_size % (4 * columns):
        raise FormatError(
            f"{path}: its {path.stat().st_size} bytes are no whole points; export the run again"
        )
    return np.fromfile(path, kind)


def _read_poses(sequence, path):
    """Returns the poses of the frame of points in the coordinates of the run."""
    tr = np.eye(4)
    for line in (sequence / "calib.txt").read_text().splitlines():
        name, _, values = line.partition(":")
        if name == "Tr":
            tr[:3] = np.reshape(values.split(), (3, 4)).astype(float)
    first = np.loadtxt(sequence / "origin.txt")
    rows = np.loadtxt(path, ndmin=2).reshape(-1, 3, 4)
    poses = np.tile(np.eye(4), (len(rows), 1, 1))
    poses[:, :3] = rows
    return first @ np.linalg.inv(tr) @ poses @ tr
