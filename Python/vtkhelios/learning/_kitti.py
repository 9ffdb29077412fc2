# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The layouts of the KITTI odometry benchmark and of SemanticKITTI.

sequences/00/velodyne/000000.bin   float32: x forward, y left, z up [m], intensity [0, 1]
sequences/00/labels/000000.label   uint32 (SemanticKITTI): label, and instance in the high 16 bits
sequences/00/times.txt             start of each scan [s], from the first
sequences/00/calib.txt             P0 to P3, and Tr from the scanner to the camera
poses/00.txt                       (SemanticKITTI: sequences/00/poses.txt) 3 x 4 of each scan, of the
                                   camera, relative to the first
sequences/00/origin.txt            the pose of the first scan in the run, 4 x 4
"""

import numpy as np

from ..core.files import write_whole
from ._tables import write_table

# From the scanner (x forward, y left, z up) to the camera (x right, y down, z forward).
TO_CAMERA = np.array([[0, -1, 0, 0], [0, 0, -1, 0], [1, 0, 0, 0], [0, 0, 0, 1]], float)


def make_rows(scan, content):
    """Returns x, y, z [m] and intensity of the points of a scan, float32."""
    rows = np.empty((len(scan.arrays["points"]), 4), "<f4")
    rows[:, :3], rows[:, 3] = scan.points, content.find_intensities(scan.arrays)
    return rows


def write_calibration(path, transforms):
    """Writes P0 to P3, which are identities, and transforms, by name."""
    lines = {**{f"P{index}": np.eye(4)[:3] for index in range(4)}, **transforms}
    rows = (
        f"{name}: {' '.join(f'{value:.12e}' for value in matrix.ravel())}\n"
        for name, matrix in lines.items()
    )
    write_whole(path, "".join(rows))


class KittiWriter:
    """Writes scans, poses and times; folder is a Path."""

    poses_file = "poses/00.txt"

    def __init__(self, folder, content):
        self.folder, self.content = folder, content
        self.sequence = folder / "sequences/00"

    def write(self, scans):
        """Writes all scans; returns the number of scans and of points."""
        for folder in (self.sequence / "velodyne", (self.folder / self.poses_file).parent):
            folder.mkdir(parents=True, exist_ok=True)
        starts, poses, count = [], [], 0
        for number, scan in enumerate(scans):
            rows = make_rows(scan, self.content)
            write_whole(self.sequence / f"velodyne/{number:06}.bin", rows.tobytes())
            self.write_labels(number, scan)
            starts.append(scan.start)
            poses.append(scan.pose)
            count += len(rows)
        self._write_poses(np.array(starts), poses)
        return len(starts), count

    def write_labels(self, number, scan):
        """Writes the labels, for SemanticKITTI only."""

    def _write_poses(self, starts, poses):
        first = np.linalg.inv(poses[0])
        rows = [(TO_CAMERA @ first @ pose @ TO_CAMERA.T)[:3].ravel() for pose in poses]
        write_table(self.folder / self.poses_file, rows, "%.9e")
        write_table(self.sequence / "times.txt", starts - starts[0], "%.6e")
        write_table(self.sequence / "origin.txt", poses[0], "%.17g")
        write_calibration(self.sequence / "calib.txt", {"Tr": TO_CAMERA[:3]})


class SemanticKittiWriter(KittiWriter):
    """Writes labels and instances, too."""

    poses_file = "sequences/00/poses.txt"

    def write_labels(self, number, scan):
        (self.sequence / "labels").mkdir(exist_ok=True)
        words = self.content.find_instances(scan.arrays) << np.uint32(16)
        words |= self.content.find_labels(scan.arrays)
        write_whole(self.sequence / f"labels/{number:06}.label", words.astype("<u4").tobytes())
