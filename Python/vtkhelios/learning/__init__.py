# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in the public layouts of data sets for machine learning and SLAM.

A run is split into scans, of a time window or of a leg each, in the frame of the platform:

>>> from vtkhelios import formats, learning
>>> with formats.open_reader("output/street") as reader:
...     for scan in learning.read_scans(reader, window=0.1):
...         scan.points, scan.pose, scan.arrays["PartIds"]

To add a layout: a class with write(scans), which returns the numbers of scans and points, and its
line in WRITERS.
"""

from ._kitti import KittiWriter, SemanticKittiWriter
from ._labels import Labels
from ._mcap import McapWriter
from ._s3dis import S3disWriter
from ._scans import Frame, read_scans

__all__ = ["WRITERS", "Frame", "Labels", "read_scans"]

WRITERS = {
    "kitti": KittiWriter,
    "semantickitti": SemanticKittiWriter,
    "s3dis": S3disWriter,
    "mcap": McapWriter,
}
