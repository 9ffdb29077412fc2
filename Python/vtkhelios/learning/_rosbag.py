# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bag of ROS 2 (rosbag2): the messages of --mcap in scans_0.mcap, and metadata.yaml."""

from ..core.files import write_whole
from ._mcap import McapWriter

TOPIC = """\
    - message_count: {count}
      topic_metadata:
        name: {name}
        type: {kind}
        serialization_format: cdr
        offered_qos_profiles: ""
"""
METADATA = """\
rosbag2_bagfile_information:
  version: 5
  storage_identifier: mcap
  relative_file_paths:
    - {file}
  duration:
    nanoseconds: {duration}
  starting_time:
    nanoseconds_since_epoch: {start}
  message_count: {count}
  topics_with_message_count:
{topics}  compression_format: ""
  compression_mode: ""
  files:
    - path: {file}
      starting_time:
        nanoseconds_since_epoch: {start}
      duration:
        nanoseconds: {duration}
      message_count: {count}
"""


class RosbagWriter(McapWriter):
    """Writes a folder that ros2 bag reads; needs mcap and rosbags."""

    name = "scans_0.mcap"

    def write(self, scans):
        written = super().write(scans)
        topics = "".join(
            TOPIC.format(count=self.counts[name], name=name, kind=self.kinds[name])
            for name in sorted(self.counts)
        )
        start, end = self.span or (0, 0)
        text = METADATA.format(
            file=self.name, topics=topics, start=start, duration=end - start,
            count=sum(self.counts.values()),
        )  # fmt: skip
        write_whole(self.path.parent / "metadata.yaml", text)
        return written
