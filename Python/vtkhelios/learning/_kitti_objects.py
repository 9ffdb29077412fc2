# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The layout of the KITTI benchmark of 3D objects.

training/velodyne/000000.bin   float32: x forward, y left, z up [m], intensity [0, 1]
training/label_2/000000.txt    an object a line: type, truncated -1, occluded 3 (unknown), alpha, no box
                               in an image, height width length [m], x y z of the middle of its floor in
                               the camera [m], rotation_y
training/calib/000000.txt      P0 to P3 and R0_rect, identities, Tr_velo_to_cam and Tr_imu_to_velo
ImageSets/train.txt            the numbers of the scans

All objects with an echo are there, also beside and behind the camera, which is at the sensor.
"""

import numpy as np

from ..core.files import write_whole
from ._content import yaw_of
from ._kitti import TO_CAMERA, make_rows, write_calibration

TYPES = {
    10: "Car", 11: "Cyclist", 13: "Misc", 15: "Cyclist", 16: "Tram", 18: "Truck", 20: "Van",
    30: "Pedestrian", 31: "Cyclist", 32: "Cyclist",
}  # fmt: skip
NO_IMAGE = "-1.00 -1.00 -1.00 -1.00"  # left, top, right, bottom


class KittiObjectsWriter:
    """Writes points and boxes of objects; folder is a Path."""

    def __init__(self, folder, content):
        self.folder, self.content = folder, content

    def write(self, scans):
        """Writes all scans; returns the number of scans and of points."""
        training, count, number = self.folder / "training", 0, -1
        for name in ("velodyne", "label_2", "calib"):
            (training / name).mkdir(parents=True)
        for number, scan in enumerate(scans):
            boxes = self.content.find_boxes(scan.arrays, "--kitti-objects")
            rows = make_rows(scan, self.content)
            write_whole(training / f"velodyne/{number:06}.bin", rows.tobytes())
            lines = (_describe(box, scan.pose) for box in boxes)
            write_whole(training / f"label_2/{number:06}.txt", "".join(lines))
            _write_calibration(training / f"calib/{number:06}.txt", scan)
            count += len(rows)
        (self.folder / "ImageSets").mkdir()
        numbers = "".join(f"{index:06}\n" for index in range(number + 1))
        write_whole(self.folder / "ImageSets/train.txt", numbers)
        return number + 1, count


def _describe(box, pose):
    """Returns the line of an object."""
    center, axes = box.within(pose)
    length, width, height = box.size
    x, y, z = TO_CAMERA[:3, :3] @ (center - axes[:, 2] * height / 2)
    turn = _wrap(-yaw_of(axes) - np.pi / 2)  # about the y axis of the camera, 0 along its x axis
    alpha = _wrap(turn - np.arctan2(x, z))
    numbers = (height, width, length, x, y, z, turn)
    values = " ".join(f"{value:.4f}" for value in numbers)
    return f"{TYPES[box.label]} -1 3 {alpha:.4f} {NO_IMAGE} {values}\n"


def _write_calibration(path, scan):
    mount = np.linalg.inv(scan.platform) @ scan.pose
    transforms = {
        "R0_rect": np.eye(3),
        "Tr_velo_to_cam": TO_CAMERA[:3],
        "Tr_imu_to_velo": np.linalg.inv(mount)[:3],
    }
    write_calibration(path, transforms)


def _wrap(angle):
    """Returns an angle in [-pi, pi)."""
    return (angle + np.pi) % (2 * np.pi) - np.pi
