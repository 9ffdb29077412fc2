# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""PulseWaves 0.3: pulses of an instrument (.pls) and their samples (.wvs beside it).

Source: PulseWaves, Full Waveform LiDAR Specification, version 0.3 revision 6.
"""

import dataclasses
import math
import os
import pathlib
import struct

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable

from ..core.arrays import numpy_to_vtk

from ..array_names import (
    BIN_SIZE, CHANNEL_IDS, COUNT, DIRECTION, EDGE_OF_FLIGHT_LINE, GPS_TIME, OFFSET, ORIGIN,
    PULSE_IDS, SAMPLES, SCAN_DIRECTION_FLAG, START_TIME,
)  # fmt: skip
from ._base import FormatError, check_file, to_cloud

HALF_LIGHT = 0.5 * 0.299792458  # [m/ns]

HEADER_SIZE = 352
RECORD_HEAD = 96
DESCRIPTORS = range(200001, 200256)
OUTGOING, RETURNING = 1, 2
WAVES_HEADER = 60
EXTENSION = 1000.0  # sampling units from the anchor to the target
NO_CENTRE = -0x70000001  # 0x8FFFFFFF: anchors are at no constant distance from the optical centre

PULSE = np.dtype([
    ("time", "<i8"), ("waves", "<i8"), ("anchor", "<i4", 3), ("target", "<i4", 3),
    ("first", "<i2"), ("last", "<i2"), ("descriptor", "u1"), ("flags", "u1"),
    ("intensity", "u1"), ("class", "u1"),
])  # fmt: skip
EDGE_BIT, DIRECTION_BIT = 16, 32  # bits of the flags


@dataclasses.dataclass
class PulseWaves:
    """``pulses``: vtkPolyData, the anchors [m] with Direction, GpsTime [s], PulseIds,
    ScanDirectionFlag and EdgeOfFlightLine. ``returning`` and ``outgoing``: vtkTable in the layout of
    vtkHeliosScanner's waveforms, one row per segment, with ChannelIds; samples as digitized."""

    pulses: vtkPolyData
    returning: vtkTable
    outgoing: vtkTable


@dataclasses.dataclass
class _Sampling:
    """A sampling record: bits of the integers before its samples, and what they are without bits."""

    kind: int
    channel: int
    duration_bits: int
    scale: float
    offset: float
    segment_bits: int
    count_bits: int
    segments: int
    count: int
    sample_bits: int
    unit: float  # [ns]


@dataclasses.dataclass
class _Descriptor:
    centre: int  # from the optical centre to the anchor [sampling units]
    extra: int  # bytes before the samples
    unit: float  # [ns]
    samplings: list


def read_pulsewaves(path):
    """The pulses and waveforms of a .pls file and the .wvs beside it, as PulseWaves.

    PulseIds are the places in the file, from 0. The origin of a waveform is the anchor, from which
    segments are counted; for outgoing pulses it is the optical centre. StartTime [ns, two-way] is such
    that c / 2 StartTime from the origin is the place of the first sample by the file's own vectors,
    which use the speed of light in air; BinSize [ns] is the file's.
    Raises FormatError for files that are missing, damaged, compressed or of another version.
    """
    return _File(path).read()


class _File:
    def __init__(self, path):
        self.path = os.fspath(path)

    def fail(self, problem, path=None):
        raise FormatError(f"{path or self.path}: {problem}")

    def read(self):
        check_file(self.path)
        self.data = pathlib.Path(self.path).read_bytes()
        self._read_header()
        self._read_waves()
        self.descriptors = dict(self._read_descriptors())
        return self._make_result()

    def _read_header(self):
        data = self.data
        if data[:15] != b"PulseWavesPulse":
            self.fail("is not a PulseWaves file: it does not start with PulseWavesPulse")
        if len(data) < HEADER_SIZE:
            self.fail(f"is cut off within its header, after {len(data)} bytes; copy it again")
        major, minor, size = struct.unpack_from("<BBH", data, 172)
        begin, self.count, form, _, length, compression = struct.unpack_from("<qqIIII", data, 176)
        if (major, minor) != (0, 3) or form != 0:
            self.fail(
                f"is PulseWaves {major}.{minor} with pulses of format {form}; version 0.3 with "
                "format 0 can be read"
            )
        if compression:
            self.fail("has compressed pulses, which cannot be read; write them uncompressed (.pls)")
        if size < HEADER_SIZE or begin < size or length < PULSE.itemsize or self.count < 0:
            self.fail(
                f"has a header of {size} bytes, pulses of {length} bytes from byte {begin} on, and "
                f"{self.count} of them, which is not possible: it is damaged, copy it again"
            )
        if begin + self.count * length > len(data):
            self.fail(
                f"is cut off: it has {max(0, len(data) - begin) // length} whole pulses of the "
                f"{self.count} that its header counts; copy it again"
            )
        self.head_size = size
        form = np.dtype({
            "names": PULSE.names, "formats": [PULSE[name] for name in PULSE.names],
            "offsets": [PULSE.fields[name][1] for name in PULSE.names], "itemsize": length,
        })  # fmt: skip
        self.pulses = np.frombuffer(data, form, self.count, begin)
        numbers = struct.unpack_from("<2d", data, 224) + struct.unpack_from("<6d", data, 256)
        if not all(map(math.isfinite, numbers)):
            self.fail("has a scale or offset that is not a number: it is damaged, copy it again")
        self.time, self.scale, self.offset = numbers[:2], numbers[2:5], numbers[5:]

    def _read_waves(self):
        self.waves_path = str(pathlib.Path(self.path).with_suffix(".wvs"))
        if not os.path.isfile(self.waves_path):
            self.fail(
                f"its samples should be in {self.waves_path}, which is missing; keep the two together"
            )
        self.waves = np.fromfile(self.waves_path, np.uint8)
        head = self.waves[:WAVES_HEADER].tobytes()
        if len(head) < WAVES_HEADER or head[:15] != b"PulseWavesWaves":
            self.fail("is not the samples of a PulseWaves file; copy it again", self.waves_path)
        if struct.unpack_from("<I", head, 16)[0]:
            self.fail(
                "has compressed samples, which cannot be read; write them uncompressed",
                self.waves_path,
            )

    def _read_descriptors(self):
        """Yields the pulse descriptors by index, of the records before and after the pulses."""
        for number, record in self._records():
            if number in DESCRIPTORS:
                try:
                    yield number - DESCRIPTORS[0] + 1, _parse_descriptor(record)
                except struct.error:
                    self.fail(f"has a pulse descriptor {number} that is cut off: copy it again")

    def _records(self):
        at = self.head_size
        before, after = struct.unpack_from("<Ii", self.data, 216)
        for _ in range(before):
            if at + RECORD_HEAD > len(self.data):
                self.fail("is cut off within its records; copy it again")
            user, number, size = struct.unpack_from("<16sI4xq", self.data, at)
            at += RECORD_HEAD + size
            if size < 0 or at > len(self.data):
                self.fail(f"is cut off within its record {number}; copy it again")
            if user.rstrip(b"\0") == b"PulseWaves_Spec":
                yield number, self.data[at - size : at]
        end = len(self.data)
        while (
            after != 0 and end >= RECORD_HEAD
        ):  # appended records, from the end; their head is last
            user, number, size = struct.unpack_from("<16sI4xq", self.data, end - RECORD_HEAD)
            if (
                user.rstrip(b"\0") != b"PulseWaves_Spec"
                or number == 0xFFFFFFFF
                or not 0 <= size <= end - RECORD_HEAD
            ):
                break
            yield number, self.data[end - RECORD_HEAD - size : end - RECORD_HEAD]
            end, after = end - RECORD_HEAD - size, after - 1

    @np.errstate(over="ignore", invalid="ignore")  # checked
    def _make_result(self):
        pulses = self.pulses
        anchor = pulses["anchor"] * self.scale + self.offset
        target = pulses["target"] * self.scale + self.offset
        step = (target - anchor) / EXTENSION  # a sampling unit
        speed = np.linalg.norm(step, axis=1)
        time = pulses["time"] * self.time[0] + self.time[1]
        if not all(np.isfinite(each).all() for each in (anchor, speed, time)):
            self.fail("has coordinates or times that are not finite: it is damaged, copy it again")
        if not np.all(speed > 0.0):
            self.fail(
                f"pulse {np.argmin(speed > 0.0)} has no direction: anchor and target are the same"
            )
        flags = pulses["flags"]
        cloud = to_cloud({
            "points": anchor,
            DIRECTION: step / speed[:, None],
            GPS_TIME: time,
            PULSE_IDS: np.arange(len(pulses)),
            SCAN_DIRECTION_FLAG: (flags & DIRECTION_BIT > 0).astype(np.uint8),
            EDGE_OF_FLIGHT_LINE: (flags & EDGE_BIT > 0).astype(np.uint8),
        })  # fmt: skip
        segments = self._find_segments()
        geometry = (anchor, step, speed, time)
        return PulseWaves(
            cloud,
            self._make_table(segments, RETURNING, geometry),
            self._make_table(segments, OUTGOING, geometry),
        )

    def _find_segments(self):
        """Returns all segments: arrays of pulses, durations, counts and places, with their
        sampling."""
        found = []
        for index in np.unique(self.pulses["descriptor"]):
            rows = np.flatnonzero(self.pulses["descriptor"] == index)
            if index == 0:
                continue  # no waveform
            if index not in self.descriptors:
                self.fail(
                    f"pulse {rows[0]} refers to pulse descriptor {index}, which the file does not have"
                )
            descriptor = self.descriptors[index]
            place = self.pulses["waves"][rows] + descriptor.extra
            for sampling in descriptor.samplings:
                place = self._walk(rows, place, descriptor, sampling, found)
        total = sum(int(count.sum()) * (each.sample_bits // 8) for _, each, _, _, count, _ in found)
        if total > len(self.waves):
            self.fail(
                f"its pulses refer to {total} bytes of samples, but {self.waves_path} has "
                f"{len(self.waves)}: they overlap; write the files again"
            )
        return found

    def _walk(self, rows, place, descriptor, sampling, found):
        """Adds the segments of a sampling of pulses from places on; returns their ends."""
        self._check_sampling(rows[0], sampling)
        number, place = self._read(rows, place, sampling.segment_bits, sampling.segments)
        segments = int(number.max(initial=0))
        if segments > 1 and sampling.duration_bits == 0:
            self.fail(
                f"pulse {rows[np.argmax(number)]} has {segments} segments without a duration from the "
                "anchor, which only one can have: it is damaged, copy it again"
            )
        for segment in range(segments):
            has = number > segment
            some, at = rows[has], place[has]
            duration, at = self._read(some, at, sampling.duration_bits, 0, signed=True)
            count, at = self._read(some, at, sampling.count_bits, sampling.count)
            end = at + count * (sampling.sample_bits // 8)
            self._check_ends(some, end)
            duration = sampling.scale * duration + sampling.offset
            if not np.isfinite(duration).all() or not 0.0 < sampling.unit < np.inf:
                self.fail(
                    f"pulse {some[0]} has samples every {sampling.unit} ns at times that are not "
                    "finite: it is damaged, copy it again"
                )
            found.append((descriptor, sampling, some, duration, count, at))
            place = place.copy()
            place[has] = end
        return place

    def _check_sampling(self, row, sampling):
        bits = (sampling.segment_bits, sampling.duration_bits, sampling.count_bits)
        known = sampling.segment_bits < 32 and all(each in (0, 8, 16, 32) for each in bits)
        if not known or sampling.sample_bits not in (8, 16, 32):
            self.fail(
                f"pulse {row} has samples of {sampling.sample_bits} bits after integers of {bits} "
                "bits; 8, 16 and 32 can be read"
            )

    def _check_ends(self, rows, ends):
        bad = (ends > len(self.waves)) | (ends < 0)
        if bad.any():
            self.fail(
                f"is cut off: the samples of pulse {rows[np.argmax(bad)]} end at byte "
                f"{ends[np.argmax(bad)]} of {len(self.waves)}; copy it again",
                self.waves_path,
            )

    def _read(self, rows, place, bits, otherwise, signed=False):
        """Returns an integer per pulse, and the place after it."""
        if bits == 0:
            return np.full(len(place), otherwise, np.int64), place
        size = bits // 8
        self._check_ends(rows, np.where(place < WAVES_HEADER, -1, place + size))
        values = _combine(self.waves[place[:, None] + np.arange(size)])
        if signed:
            values = np.where(values >= 1 << (bits - 1), values - (1 << bits), values)
        return values, place + size

    def _make_table(self, segments, kind, geometry):
        anchor, step, speed, time = geometry
        columns = {
            name: [] for name in (PULSE_IDS, CHANNEL_IDS, ORIGIN, START_TIME, BIN_SIZE, COUNT)
        }
        samples = []
        for descriptor, sampling, rows, duration, count, place in segments:
            if sampling.kind != kind:
                continue
            from_centre = kind == OUTGOING and descriptor.centre != NO_CENTRE
            shift = descriptor.centre if from_centre else 0
            columns[PULSE_IDS].append(rows)
            columns[CHANNEL_IDS].append(np.full(len(rows), sampling.channel))
            columns[ORIGIN].append(anchor[rows] - shift * step[rows])
            columns[START_TIME].append(duration * speed[rows] / HALF_LIGHT)
            columns[BIN_SIZE].append(np.full(len(rows), sampling.unit))
            columns[COUNT].append(count)
            samples += self._read_samples(place, count, sampling.sample_bits // 8)
        return _fill_table(columns, samples, geometry)

    def _read_samples(self, place, count, size):
        return [
            _combine(self.waves[at : at + n * size].reshape(n, size))
            for at, n in zip(place.tolist(), count.tolist())
        ]


def _combine(data):
    """Little-endian bytes (the last axis) as integers."""
    return (data.astype(np.int64) << (8 * np.arange(data.shape[-1]))).sum(axis=-1)


def _parse_descriptor(record):
    size, centre, extra, samplings, unit = struct.unpack_from("<I4xiHHf", record)
    found = []
    for _ in range(samplings):
        values = struct.unpack_from("<I4xBBxBffBBHIH2xf", record, size)
        found.append(_Sampling(*values[1:]))
        size += values[0]
    return _Descriptor(centre, extra, unit, found)


def _fill_table(columns, samples, geometry):
    """Returns the rows in the order of pulses and start times."""
    _, step, speed, time = geometry
    arrays = {
        name: np.concatenate(values) if values else np.zeros(0) for name, values in columns.items()
    }
    order = np.lexsort((arrays[START_TIME], arrays[CHANNEL_IDS], arrays[PULSE_IDS]))
    arrays = {name: values[order] for name, values in arrays.items()}
    rows = arrays[PULSE_IDS].astype(np.int64)
    counts = arrays[COUNT].astype(np.int64)
    chosen = [samples[i] for i in order.tolist()]
    arrays |= {
        PULSE_IDS: rows,
        CHANNEL_IDS: arrays[CHANNEL_IDS].astype(np.int32),
        ORIGIN: arrays[ORIGIN].reshape(-1, 3),
        DIRECTION: (step[rows] / speed[rows][:, None]).reshape(-1, 3),
        GPS_TIME: time[rows],
        COUNT: counts,
        OFFSET: np.cumsum(counts) - counts,
    }
    table = vtkTable()
    for name, values in arrays.items():
        table.GetRowData().AddArray(_named(values, name))
    flat = np.concatenate(chosen) if chosen else np.zeros(0)
    table.GetFieldData().AddArray(_named(flat.astype(np.float32), SAMPLES))
    return table


def _named(values, name):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    return array
