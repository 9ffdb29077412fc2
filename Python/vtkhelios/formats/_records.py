# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS and LAZ as records: bytes are copied verbatim, so that nothing is lost."""

import logging
import os
import pathlib
import struct
import typing

import numpy as np

from ..core.run_files import PART
from ._base import ROWS, FormatError, check_file, need
from ._las_check import HEADER_BYTES, Damage, check_header
from ._laz import make_backend, read_records

WAVES = (b"LASF_Spec", 65535)  # the extended record of waveform packets
NOT_KEPT = (b"laszip encoded", b"copc")  # users of the point compression records
HEAD, EXTENDED_HEAD = 54, 60  # bytes before the data of a record
INTERNAL, EXTERNAL = 2, 4  # bits of the global encoding: location of packets
STANDARD_TIME, OFFSET_TIME = 1, 64  # its bits of times
WRITTEN = {0: 2, 5: 4}  # versions 1.x whose records are copied to another one
LEAST = {0: 0, 1: 0, 2: 2, 3: 2, 4: 3, 5: 3}  # versions 1.x of the first formats; of others 4
DESCRIPTORS = range(100, 355)  # numbers of the waveform packet descriptor records
TO_SCANNER = b"waveform [W], to the scanner"  # descriptor text in heliosLasWaves.h, and
FROM_SCANNER = b"waveform [W]"  # text of earlier versions, whose vectors had the opposite sign


class ExtendedRecord(typing.NamedTuple):
    """The head of a record after the points."""

    user: bytes
    number: int
    place: int  # first byte in the file
    size: int  # [bytes], with the head
    description: bytes


class RecordReader:
    """The header of a file in laspy, its head as bytes, and its points as records."""

    def __init__(self, path):
        self.path = str(path)
        self.notes = []  # reinterpreted data
        laspy = need("laspy", "LAS and LAZ files")
        logging.getLogger("laspy").setLevel(logging.CRITICAL)  # it is also an exception
        if os.path.exists(self.path):
            check_file(self.path)
        self._size = os.path.getsize(self.path)
        try:
            self._take_head()
            with open(self.path, "rb") as file:
                self.header = laspy.LasHeader.read_from(file)
            self._make_plain(self.header)
            self.header.version = laspy.header.Version(1, self.minor)
            self.header.global_encoding.value = self.encoding
            self.header.vlrs = [
                each for each in self.header.vlrs if each.user_id.encode() not in NOT_KEPT
            ]
            self._turn_descriptors()
        except FormatError:
            raise
        except Exception as error:  # any exception of laspy for invalid bytes
            self.fail(
                f"is not a LAS or LAZ file, or its header is damaged: {error}; write it again"
            )
        self._read(0, 0)  # finds errors in the points

    def find_new_version(self):
        """A note if the records are written to another version of LAS, or None."""
        written = f"1.{self.minor}"
        if written == self.version:
            return None
        return f"{self.path}: is LAS {self.version}; its records are copied to LAS {written}"

    def fail(self, problem):
        raise FormatError(f"{self.path}: {problem}")

    def _make_plain(self, header):
        """laspy writes only ASCII texts; RecordWriter restores their bytes."""
        for name in ("generating_software", "system_identifier"):
            setattr(header, name, _as_ascii(getattr(header, name)))
        from laspy import VLR

        for place, record in enumerate(header.vlrs):
            texts = [_as_ascii(text) for text in (record.user_id, record.description)]
            if texts != [record.user_id, record.description]:
                user, words = texts
                data = record.record_data_bytes()
                header.vlrs[place] = VLR(user, record.record_id, words, data)

    def _take_head(self):
        with open(self.path, "rb") as file:
            start = file.read(HEADER_BYTES)
            if problem := check_header(start, self._size):
                raise Damage(problem)
            minor = start[25]
            self._set_start(bytearray(start))
            header_size, self._points_begin, count = struct.unpack_from("<HII", start, 94)
            file.seek(header_size)
            data = file.read(self._points_begin - header_size)
            self.records = [each for each in _split(data, count) if each[0] not in NOT_KEPT]
            self._waves_begin = struct.unpack_from("<Q", start, 227)[0] if minor >= 3 else 0
            self.extended_heads = self._find_extended(file, start) if minor >= 4 else []
            self.extended = [
                (each.user, each.number, each.place, each.size)
                for each in self.extended_heads if each.user not in NOT_KEPT
            ]  # fmt: skip

    def _set_start(self, start):
        """The head as it is written: of LAS 1.0 as 1.2, of LAS 1.5 as 1.4, of formats that the
        version does not have as the first one that has them.
        """
        minor, form = start[25], start[104] & 63
        if minor < 2:
            start[6:8] = bytes(2)  # reserved there
        if minor < 1:
            start[4:6] = bytes(2)
        self.minor = start[25] = max(WRITTEN.get(minor, minor), LEAST.get(form, 4))
        self.encoding = struct.unpack_from("<H", start, 6)[0]
        self._time_shift = 0.0
        if minor == 5 and self.encoding & OFFSET_TIME:
            if self.encoding & STANDARD_TIME:
                self._time_shift = 1e6 * struct.unpack_from("<H", start, 391)[0] - 1e9
            self.encoding &= ~OFFSET_TIME
            struct.pack_into("<H", start, 6, self.encoding)
        self.start = bytes(start)
        self.version = f"1.{minor}"

    def _turn_descriptors(self):
        """Waveform vectors of earlier versions point away from the scanner: chunks() inverts them
        and updates the records.
        """
        from laspy import VLR

        turned = [(user, _turn_descriptor(data)) for user, data in self.records]
        self._is_turned = turned != self.records and self.header.point_format.has_waveform_packet
        if not self._is_turned:
            return
        self.records = turned
        self.header.vlrs = [
            VLR(each.user_id, each.record_id, TO_SCANNER.decode(), each.record_data_bytes())
            if each.record_id in DESCRIPTORS and each.description == FROM_SCANNER.decode()
            else each
            for each in self.header.vlrs
        ]
        self.notes.append(
            f"{self.path}: an earlier version of vtkHelios wrote its waveforms, with vectors that "
            "point away from the scanner; vtkhelios convert inverts them"
        )

    def _find_extended(self, file, start):
        """Returns the extended records."""
        place, count = struct.unpack_from("<QI", start, 235)
        found = []
        for _ in range(count):
            file.seek(place)
            head = file.read(EXTENDED_HEAD)
            if len(head) < EXTENDED_HEAD:
                self.fail(
                    f"is cut off: an extended record at byte {place} is missing; copy it again"
                )
            size = EXTENDED_HEAD + struct.unpack_from("<Q", head, 20)[0]
            if place + size > self._size:
                self.fail(
                    f"is cut off: it has {self._size} bytes, and an extended record ends after "
                    f"{place + size}; copy it again"
                )
            user, words = (text.split(b"\0")[0] for text in (head[2:18], head[28:]))
            number = struct.unpack_from("<H", head, 18)[0]
            found.append(ExtendedRecord(user, number, place, size, words))
            place += size
        return found

    def _read(self, first, count):
        """Reads points as a structured array."""
        records = np.empty(count, self.header.point_format.dtype())
        try:
            read_records(self.path, first, records)
        except ValueError as error:
            raise FormatError(str(error)) from error
        return records

    def packets(self):
        """Location of the waveform packets: file, offset, size with a head of 60 bytes; or None."""
        if not self.header.point_format.has_waveform_packet:
            return None
        for user, number, place, size in self.extended:
            if (user, number) == WAVES:
                return self.path, place, size
        if self.encoding & INTERNAL and self._waves_begin:
            return self.path, self._waves_begin, self._size - self._waves_begin
        beside = pathlib.Path(self.path).with_suffix(".wdp")
        if not beside.is_file() and beside.with_suffix(".wdz").is_file():
            self.fail(
                f"its waveforms are compressed ({beside.stem}.wdz), which cannot be read; decompress "
                f"them to {beside.name} with the program that wrote them"
            )
        if not beside.is_file():
            self.fail(
                f"its waveforms should be in {beside}, which is missing; keep the two files "
                "together"
            )
        return str(beside), 0, beside.stat().st_size

    def chunks(self, rows=ROWS):
        """Yields the points as structured arrays."""
        total, done = self.header.point_count, 0
        while done < total:
            count = min(rows, total - done)
            records = self._read(done, count)
            done += count
            if self._time_shift:
                records["gps_time"] += self._time_shift
            if self._is_turned:
                for name in ("x_t", "y_t", "z_t"):
                    records[name] = -records[name]
            yield records

    def read_points(self, first, count):
        """Returns points of laspy, scaled."""
        from laspy import ScaleAwarePointRecord

        header, records = self.header, self._read(first, count)
        return ScaleAwarePointRecord(
            records, header.point_format, scales=header.scales, offsets=header.offsets
        )


def _as_ascii(text):
    """Returns a header text, as laspy returns it, with ? for what is not ASCII."""
    data = text if isinstance(text, bytes) else str(text).encode("latin-1", "replace")
    return data.decode("ascii", "replace").replace("\ufffd", "?")


def _split(data, count):
    """Yields the variable length records of a head: user, bytes."""
    at = 0
    for _ in range(count):
        size = HEAD + struct.unpack_from("<H", data, at + 20)[0]
        user = data[at + 2 : at + 18].split(b"\0")[0]
        yield user, data[at : at + size]
        at += size


def _turn_descriptor(data):
    """Returns a descriptor record of an earlier version in current form; others unchanged."""
    is_ours = (
        data[2:18].split(b"\0")[0] == b"LASF_Spec"
        and struct.unpack_from("<H", data, 18)[0] in DESCRIPTORS
        and data[22:HEAD].split(b"\0")[0] == FROM_SCANNER
    )
    return data[:22] + TO_SCANNER.ljust(HEAD - 22, b"\0") + data[HEAD:] if is_ours else data


class RecordWriter:
    """Points as records, with the head of their file."""

    def __init__(self, file, reader, compress):
        import laspy

        self.file = file
        self._model = reader
        self._ranges = []  # ranges of waveform packets
        backend = make_backend(laspy) if compress else None
        try:
            self._writer = laspy.LasWriter(
                file, reader.header, do_compress=compress, laz_backend=backend, closefd=False
            )
        except Exception as error:  # read but not written by laspy
            raise FormatError(
                f"{reader.path}: its records cannot be copied by laspy: {type(error).__name__} "
                f"{error}; convert it with another program first"
            ) from error
        self._laspy = laspy

    def write(self, records):
        form = self._writer.header.point_format
        self._try(lambda: self._writer.write_points(self._laspy.PackedPointRecord(records, form)))

    def _try(self, action):
        """Errors of laspy, including a full disk, name the file."""
        try:
            action()
        except (OSError, FormatError):
            raise
        except Exception as error:
            raise FormatError(
                f"{self.file.name.removesuffix(PART)}: cannot be written: {error}; free space "
                "on its disk"
            ) from error

    def shift(self, records, reader):
        """Converts coordinates to the offset of this file; False if that is not exact."""
        ours, theirs = self._model.header, reader.header
        steps = (theirs.offsets - ours.offsets) / ours.scales
        whole = np.rint(steps)
        if np.abs(steps - whole).max() > 1e-4:
            return False
        for name, step in zip("XYZ", whole.astype(np.int64)):
            moved = records[name].astype(np.int64) + step
            if len(moved) and max(abs(moved.min()), abs(moved.max())) >= 2**31:
                return False
            records[name] = moved
        return True

    def add_packets(self, packets):
        """Adds the packets of a file; returns the shift of their offsets in points."""
        before = sum(size - EXTENDED_HEAD for _, _, size in self._ranges)
        self._ranges.append(packets)
        return before

    def close(self, internal=True, beside=None):
        """Ends the file; packets are written to it, or to another open one."""
        self._try(self._writer.close)
        self._restore_head()
        others = [
            (self._model.path, place, size)
            for user, number, place, size in self._model.extended
            if (user, number) != WAVES
        ]
        if self._model.minor >= 4 or self._ranges:
            self._append(others, internal, beside)

    def _restore_head(self):
        """Restores creator, date and records, byte-identical; records only if the total size agrees."""
        for first, last in ((4, 6), (8, 24), (26, 94)):
            self.file.seek(first)
            self.file.write(self._model.start[first:last])
        size, begin, count = struct.unpack("<HII", self.file.read(10))
        self.file.seek(size)
        made = b"".join(
            data for user, data in _split(self.file.read(begin - size), count)
            if user not in NOT_KEPT
        )  # fmt: skip
        kept = b"".join(data for _, data in self._model.records)
        if len(made) == len(kept):
            self.file.seek(size)
            self.file.write(kept)

    def _append(self, others, internal, beside):
        self.file.seek(0, os.SEEK_END)
        first, count, waves = self.file.tell(), len(others), 0
        for path, place, size in others:
            _copy(path, place, size, self.file)
        if self._ranges and internal:
            waves, count = self.file.tell(), count + 1
            self._write_packets(self.file)
        elif self._ranges:
            self._write_packets(beside)
        self._patch("<Q", 227, waves)
        if self._model.minor >= 4:
            self._patch("<QI", 235, first if count else 0, count)
        bits = (INTERNAL if internal else EXTERNAL) if self._ranges else 0
        self._patch("<H", 6, self._model.encoding & ~(INTERNAL | EXTERNAL) | bits)

    def _write_packets(self, file):
        path, place, _ = self._ranges[0]
        start = file.tell()
        _copy(path, place, EXTENDED_HEAD, file)
        for path, place, size in self._ranges:
            _copy(path, place + EXTENDED_HEAD, size - EXTENDED_HEAD, file)
        end = file.tell()
        file.seek(start + 20)
        file.write(struct.pack("<Q", end - start - EXTENDED_HEAD))
        file.seek(end)

    def _patch(self, form, place, *values):
        self.file.seek(place)
        self.file.write(struct.pack(form, *values))


def _copy(path, place, size, file, block=1 << 24):
    """Copies bytes of a file to the end of another one."""
    with open(path, "rb") as source:
        source.seek(place)
        while size > 0:
            data = source.read(min(block, size))
            if not data:
                raise FormatError(f"{path}: is cut off; copy it again")
            file.write(data)
            size -= len(data)


def same_form(one, other):
    """Why the records of two files do not fit into one, or an empty string."""
    ours, theirs = one.header, other.header
    if ours.point_format != theirs.point_format or ours.version != theirs.version:
        return "another point format or other Extra Bytes"
    if not np.array_equal(ours.scales, theirs.scales):
        return "other scales"
    if (one.encoding ^ other.encoding) & ~(INTERNAL | EXTERNAL):
        return "another kind of GPS time"
    if one.records != other.records:
        return "other header records"
    return ""
