# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A small PulseWaves file: three outgoing waveforms."""

import struct

SAMPLES = (0, 0, 1, 20, 60, 40, 8, 1)


def make_pulsewaves():
    """The bytes of the .pls and of its .wvs."""
    outgoing = struct.pack(
        "<IIBBBBffBBHIHHfI", 40, 0, 1, 7, 0, 0, 0.5, 10.0, 0, 0, 1, len(SAMPLES), 8, 0, 1.0, 0
    )
    descriptor = struct.pack("<IIiHHfII", 28, 0, 4, 0, 1, 1.0, 0, 0) + outgoing
    record = struct.pack("<16sIIq64s", b"PulseWaves_Spec", 200001, 0, len(descriptor), b"")
    record += descriptor
    waves = bytearray(b"PulseWavesWaves\0".ljust(60, b"\0"))
    pulses = b""
    for index in range(3):
        anchor, target = (1000 * index, 0, 0), (1000 * index, 0, -149_000)
        pulses += struct.pack(
            "<qq3i3ihhBBBB", 5000 + index, len(waves), *anchor, *target, 0, 0, 1, 32, 0, 0
        )
        waves += bytes(min(255, each + index) for each in SAMPLES)
    head = struct.pack(
        "<16s16x8x128xHHBBHqqIIIIqIi", b"PulseWavesPulse", 1, 2026, 0, 3, 352, 352 + len(record), 3,
        0, 0, 48, 0, 0, 1, -1,
    )  # fmt: skip
    head += struct.pack("<2d2q6d", 1e-3, 100.0, 0, 0, 1e-3, 1e-3, 1e-3, 10.0, 20.0, 30.0)
    return head.ljust(352, b"\0") + record + pulses, bytes(waves)
