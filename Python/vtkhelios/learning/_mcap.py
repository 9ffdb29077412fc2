# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""MCAP with messages of ROS 2, for SLAM: scans.mcap.

/points   sensor_msgs/PointCloud2 in the frame lidar: x y z [m], intensity [0, 1], t [s] after the
          stamp, ring (channel), range [m], return_number
/misses   the same message of pulses without an echo, of runs with pulses: dx dy dz (unit vector),
          t, ring
/tf       tf2_msgs/TFMessage: base_link in map, and lidar in base_link, at each scan; map begins at
          the first scan's position in whole metres

A stamp is GpsTime, or, if the points have a GpsEpoch, the Unix time that ROS uses.
"""

import numpy as np

from ..array_names import CHANNEL_IDS, GPS_TIME, RANGE, RETURN_NUMBER
from ..core.files import naming
from ..exchange import load
from ..vtkHeliosFiltersCore import vtkHeliosGpsTime
from ..core.rotation import quaternion_of

POINTS = np.dtype([
    ("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("intensity", "<f4"), ("t", "<f4"), ("range", "<f4"),
    ("ring", "<u2"), ("return_number", "u1"), ("unused", "u1"),
])  # fmt: skip
MISSES = np.dtype([
    ("dx", "<f4"), ("dy", "<f4"), ("dz", "<f4"), ("t", "<f4"), ("ring", "<u2"), ("unused", "<u2"),
])  # fmt: skip
_KINDS = {"f4": 7, "u2": 4, "u1": 2}  # types of PointField
CLOUD, TRANSFORM = "sensor_msgs/msg/PointCloud2", "tf2_msgs/msg/TFMessage"


class McapWriter:
    """Writes scans.mcap to a folder (a Path); needs mcap and rosbags."""

    name = "scans.mcap"

    def __init__(self, folder, content):
        self._mcap = load("mcap.writer", "MCAP files need")
        typesys = load("rosbags.typesys", "MCAP files need")
        self.store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
        self.path, self.content = folder / self.name, content
        self.channels, self.origin = {}, None
        self.counts, self.kinds = {}, {}  # numbers and kinds of messages by topic
        self.span = None  # their first and last time [ns]
        epoch = content.header.epoch
        self.begin = round(1e9 * vtkHeliosGpsTime.ToUnixTime(epoch)) if epoch else 0  # [ns]

    def write(self, scans):
        """Writes all scans; returns their number and the number of points."""
        number, count = -1, 0
        with naming(self.path), open(self.path, "wb") as file:
            self.writer = self._mcap.Writer(file, compression=self._mcap.CompressionType.NONE)
            self.writer.start(profile="ros2", library="vtkhelios")
            for number, scan in enumerate(scans):
                self._write_transform(scan, number)
                self._write_cloud("/points", scan.start, make_points(scan, self.content), number)
                if scan.misses is not None:
                    self._write_cloud("/misses", scan.start, make_misses(scan), number)
                count += len(scan.arrays["points"])
            self.writer.finish()
        return number + 1, count

    def _send(self, topic, kind, message, start, number):
        if topic not in self.channels:
            text, _ = self.store.generate_msgdef(kind, ros_version=2)
            schema = self.writer.register_schema(kind, "ros2msg", text.encode())
            self.channels[topic] = self.writer.register_channel(topic, "cdr", schema)
        data = bytes(self.store.serialize_cdr(message, kind))
        time = self._stamp(start)
        self.counts[topic], self.kinds[topic] = self.counts.get(topic, 0) + 1, kind
        self.span = (
            (min(time, self.span[0]), max(time, self.span[1])) if self.span else (time, time)
        )
        self.writer.add_message(self.channels[topic], time, data, time, number)

    def _stamp(self, start):
        """Converts a time of the points to the time of a message [ns]."""
        return self.begin + round(1e9 * start)

    def _header(self, frame, start):
        kinds = self.store.types
        stamp = kinds["builtin_interfaces/msg/Time"](*divmod(self._stamp(start), 10**9))
        return kinds["std_msgs/msg/Header"](stamp, frame)

    def _write_cloud(self, topic, start, rows, number):
        field = self.store.types["sensor_msgs/msg/PointField"]
        fields = [
            field(name, offset, _KINDS[kind.str[1:]], 1)
            for name, (kind, offset, *_) in rows.dtype.fields.items()
            if name != "unused"
        ]
        size = rows.dtype.itemsize
        message = self.store.types[CLOUD](
            self._header("lidar", start), 1, len(rows), fields, False, size, size * len(rows),
            rows.view(np.uint8).reshape(-1), True,
        )  # fmt: skip
        self._send(topic, CLOUD, message, start, number)

    def _write_transform(self, scan, number):
        """Writes the platform in the map, and the frame of points on the platform."""
        if self.origin is None:
            self.origin = np.floor(scan.platform[:3, 3])
        platform = scan.platform.copy()
        platform[:3, 3] -= self.origin
        mount = np.linalg.inv(scan.platform) @ scan.pose
        message = self.store.types[TRANSFORM]([
            self._make_transform(scan, "map", "base_link", platform),
            self._make_transform(scan, "base_link", "lidar", mount),
        ])  # fmt: skip
        self._send("/tf", TRANSFORM, message, scan.start, number)

    def _make_transform(self, scan, parent, child, pose):
        kinds = self.store.types
        w, x, y, z = quaternion_of(pose[:3, :3])
        transform = kinds["geometry_msgs/msg/Transform"](
            kinds["geometry_msgs/msg/Vector3"](*(float(value) for value in pose[:3, 3])),
            kinds["geometry_msgs/msg/Quaternion"](x, y, z, w),
        )
        return kinds["geometry_msgs/msg/TransformStamped"](
            self._header(parent, scan.start), child, transform
        )


def make_points(scan, content):
    """Returns the rows of a PointCloud2."""
    arrays = scan.arrays
    rows = np.zeros(len(arrays["points"]), POINTS)
    rows["x"], rows["y"], rows["z"] = scan.points.T
    rows["intensity"] = content.find_intensities(arrays)
    rows["t"] = arrays[GPS_TIME] - scan.start
    rows["range"] = arrays.get(RANGE, np.linalg.norm(scan.points, axis=1))
    rows["ring"] = arrays.get(CHANNEL_IDS, 0)
    rows["return_number"] = arrays.get(RETURN_NUMBER, 1)
    return rows


def make_misses(scan):
    """Returns the rows of pulses without an echo."""
    rows = np.zeros(len(scan.misses[GPS_TIME]), MISSES)
    rows["dx"], rows["dy"], rows["dz"] = scan.directions.T
    rows["t"] = scan.misses[GPS_TIME] - scan.start
    rows["ring"] = scan.misses.get(CHANNEL_IDS, 0)
    return rows
