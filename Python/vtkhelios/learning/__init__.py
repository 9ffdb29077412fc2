# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in the public layouts of data sets for machine learning, robots and SLAM.

A run is split into scans, of a time window or of a leg each, in the frame of the sensor:

>>> from vtkhelios import formats, learning
>>> with formats.open_reader("output/street") as reader:
...     content = learning.Content.of(reader)
...     for scan in learning.read_scans(reader, window=0.1):
...         scan.points, scan.pose, content.find_labels(scan.arrays)

``vtkhelios.learning.torch_data`` has exported scans as a data set of PyTorch. To add a layout: a class
with write(scans), which returns the numbers of scans and points, and its line in WRITERS.
"""

from ._boxes import Box, check_inputs
from ._content import Content
from ._kitti import KittiWriter, SemanticKittiWriter
from ._kitti_objects import KittiObjectsWriter
from ._labels import Labels
from ._mcap import McapWriter
from ._nuscenes import NuscenesWriter
from ._rosbag import RosbagWriter
from ._s3dis import S3disWriter
from ._scans import Frame, read_scans

__all__ = ["WRITERS", "Box", "Content", "Frame", "Labels", "check_inputs", "read_scans"]

WRITERS = {
    "kitti": KittiWriter,
    "semantickitti": SemanticKittiWriter,
    "kitti-objects": KittiObjectsWriter,
    "nuscenes": NuscenesWriter,
    "s3dis": S3disWriter,
    "mcap": McapWriter,
    "rosbag": RosbagWriter,
}
