# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""E57 by pye57: the points of its scans, in world coordinates."""

import dataclasses

import numpy as np

from ..array_names import (
    AMPLITUDE, GPS_TIME, INTENSITY, NUMBER_OF_RETURNS, RETURN_NUMBER, RGB,
)  # fmt: skip
from ..core.systems import Metres
from ..core.words import counted
from ._base import ROWS, Reader, Scan, guarded, need

from ._e57_fields import (
    COLOURS, DIRECTION_ONLY, FULL, KNOWN, NAME_NODES, OURS, POLAR, STATES, TREES, TREE_TYPES, XYZ, Range,
    check_flags, find_range, full_colour, number_of, rotation_matrix,
)  # fmt: skip
from ._e57_writer import E57Writer
from ._union import explain_missing, fill, join_layouts, layout_of

__all__ = ["E57Reader", "E57Writer"]

UNIT_ERROR = 1e-6  # error of the length of a quaternion that is 1


def _first_line(error):
    """Returns the message of libE57Format, without source locations."""
    return (str(error).strip().splitlines() or [type(error).__name__])[0]


class E57Reader(Reader):
    def __init__(self, path):
        super().__init__(path)
        self.fills_missing = True  # whether chunks of all scans have the same arrays
        self._pye57 = need("pye57", "E57 files")
        try:
            self._file = self._pye57.E57(self.path)
            headers = [self._file.get_header(i) for i in range(self._file.scan_count)]
            self.header.crs = self._text(self._file.root, "coordinateMetadata")
        except Exception as error:  # libE57Format raises types that vary between releases
            self.fail(f"is not an E57 file, or is damaged: {_first_line(error)}; copy it again")
        self.count = sum(header.point_count for header in headers)
        self.kind = f"E57, {len(headers)} scan{'s'[: len(headers) != 1]}"
        if self.count == 0:
            self.fail("has no points; give a file with points")
        with guarded(self.path):
            self._read_heads(headers)
            for name, node in NAME_NODES.items():
                self.header.set_texts(name, self._read_texts(node))

    def _read_heads(self, headers):
        self.scans = [self._make_scan(header, i) for i, header in enumerate(headers)]
        starts = [self._find_start(header) for header in headers]
        self.header.epoch = next((start for start in starts if start), 0.0)
        self._points = [
            ScanPoints(self, header, scan, start - self.header.epoch if start else 0.0)
            for header, scan, start in zip(headers, self.scans, starts)
        ]
        for scan, points in zip(self.scans, self._points):
            scan.misses = points.misses if points.may_have_misses() else None
        self._note_rest(starts, headers)
        self._set_unit()

    def _set_unit(self):
        """E57 stores metres: coordinates are converted to the unit of their system."""
        metres = Metres(self.header.crs)
        self._factors = None if metres.is_identity or metres.is_geographic else metres.factors
        if metres.is_geographic:
            self.notes.append(
                f"{self.path}: its coordinate system is in degrees, but E57 stores metres: "
                "coordinates are read as they are"
            )
        if self._factors is not None:
            self.notes.append(
                f"{self.path}: its metres are converted to the units of its coordinate system: "
                f"{metres.factors[0]:.9g} m, heights {metres.factors[2]:.9g} m"
            )
            self.scans = [
                dataclasses.replace(scan, translation=tuple(scan.translation / self._factors))
                for scan in self.scans
            ]

    def _note_rest(self, starts, headers):
        """Notes on what is not read, and on scans without a start."""
        if any(starts) and not all(starts):
            self.notes.append(
                f"{self.path}: {starts.count(0.0)} of {counted(len(starts), 'scan')} have no acquisitionStart: "
                f"their times count from {self.header.epoch:.17g} s, as those of the first that has one"
            )
        unread = set().union(*(header.point_fields for header in headers)) - KNOWN
        if unread:
            self.notes.append(f"{self.path}: these fields are dropped: {', '.join(sorted(unread))}")
        root = self._file.root
        images = root["images2D"].childCount() if root.isDefined("images2D") else 0
        if images:
            self.notes.append(f"{self.path}: its images are dropped ({images})")

    def _text(self, node, name):
        return node[name].value() if node.isDefined(name) else ""

    def _read_texts(self, name):
        """Returns the texts in a vector of the root."""
        root = self._file.root
        nodes = (root[i] for i in range(root.childCount()))  # isDefined() needs known extensions
        node = next((each for each in nodes if each.elementName() == name), None)
        return [node[i].value() for i in range(node.childCount())] if node is not None else []

    def _find_start(self, header):
        """GPS time of the zero of the time stamps of a scan; 0: unknown."""
        path = "acquisitionStart/dateTimeValue"
        return number_of(header.node[path]) if header.node.isDefined(path) else 0.0

    def _make_scan(self, header, index):
        name = self._text(header.node, "name") or f"scan{index:03}"
        if not header.has_pose():
            return Scan(name)
        pose = header.node["pose"]
        turn = self._read_numbers(pose, "rotation", "wxyz", (1.0, 0.0, 0.0, 0.0))
        move = self._read_numbers(pose, "translation", "xyz", (0.0, 0.0, 0.0))
        return Scan(name, move, self._normalise(turn, name), True)

    def _read_numbers(self, pose, name, parts, otherwise):
        if not pose.isDefined(name):
            return otherwise
        return tuple(number_of(pose[name][part]) for part in parts)

    def _normalise(self, turn, name):
        length = float(np.linalg.norm(turn))
        if not (0.0 < length < np.inf):
            self.fail(
                f'the rotation of scan "{name}" is the quaternion {turn}, which has no direction; '
                "write the pose again"
            )
        if abs(length - 1.0) > UNIT_ERROR:
            self.notes.append(
                f'{self.path}: the rotation of scan "{name}" is a quaternion of length {length:.9g}; '
                "it is normalised"
            )
        return tuple(float(part) / length for part in turn)

    def read_chunks(self, rows):
        union = join_layouts((self._name(i), each.layout) for i, each in enumerate(self._points))
        self._note_missing(union)
        counts = {}
        for self.scan, points in enumerate(self._points):
            for chunk in points.chunks(rows, counts):
                if self._factors is not None:
                    chunk["points"] = chunk["points"] / self._factors
                yield fill(chunk, union) if self.fills_missing else chunk
        self._note_counts(counts)

    def _name(self, index):
        return f'{self.path}: scan "{self.scans[index].name}"'

    def _note_missing(self, union):
        for index, points in enumerate(self._points if self.fills_missing else ()):
            note = explain_missing(self._name(index), points.layout, union)
            if note and note not in self.notes:
                self.notes.append(note)

    def _note_counts(self, counts):
        directions, invalid = counts.pop("directions", 0), counts.pop("invalid", 0)
        if directions or invalid:
            self.notes.append(
                f"{self.path}: {counted(directions + invalid, 'point', 'are')} marked as invalid "
                f"({counted(directions, 'pulse')} without an echo, {invalid:,} without coordinates); they are dropped"
            )
        clipped = counts.pop("clipped", 0)
        if clipped:
            self.notes.append(
                f"{self.path}: {clipped:,} intensities are outside the limits of their scan: clipped"
            )
        bad = counts.pop("not finite", 0)
        if bad:
            self.notes.append(f"{self.path}: {bad:,} intensities are not finite: read as 0")
        for words, count in counts.items():
            self.notes.append(f"{self.path}: {count:,} {words} are marked as invalid: read as 0")

    def types_of(self, header):
        """Returns the types of the fields of a scan, by name."""
        return self._pye57.libe57.StructureNode(header.points.prototype())

    def read_fields(self, header, names, rows):
        """Yields some fields of the points of a scan, as numbers with their scale."""
        libe57 = self._pye57.libe57
        data = {name: np.empty(rows) for name in names}
        buffers = libe57.VectorSourceDestBuffer()
        for name, values in data.items():
            buffers.append(libe57.SourceDestBuffer(
                self._file.image_file, name, values, rows, True, True))  # fmt: skip
        try:
            reader = header.points.reader(buffers)
            while count := reader.read():
                yield {name: v[:count].copy() for name, v in data.items()}
            reader.close()
        except self._pye57.libe57.E57Exception as error:
            self.fail(
                f"its points cannot be read: {_first_line(error)}; it is damaged, copy it again"
            )

    def close(self):
        self._file.close()


class ScanPoints:
    """The points of a scan as arrays."""

    def __init__(self, owner, header, scan, shift):
        self._owner, self._header, self._scan = owner, header, scan
        self._shift = shift  # shift of its time stamps [s]
        self._fields = KNOWN & set(header.point_fields)
        self._types = owner.types_of(header)
        if not (self._fields.issuperset(XYZ) or self._fields.issuperset(POLAR)):
            owner.fail("has a scan without coordinates; leave that scan out")
        node = header.node
        description = node["description"].value() if node.isDefined("description") else ""
        self._intensity = self._colours = None
        self._is_amplitude = description.startswith(OURS)
        if "intensity" in self._fields and not self._is_amplitude:
            self._intensity = self._find_intensity(node)
        if self._fields.issuperset(COLOURS):
            self._colours = self._find_colours(node)
        empty = {name: np.empty(0) for name in self._fields}
        self.layout = layout_of(self._to_chunk(empty, {}))

    def _find_intensity(self, node):
        """Its range; without one, whole numbers of 16 bits are as they are, others too, as float."""
        found = find_range(node, self._types, "intensityLimits", "intensity", "intensity")
        is_16 = found.is_known or self._header.point_count == 0
        if not is_16 and self._are_whole("intensity"):
            return Range(0.0, FULL)
        return found

    def _are_whole(self, name):
        return all(
            np.all((values[name] == np.rint(values[name])) & (values[name] >= 0))
            and np.all(values[name] <= FULL)
            for values in self._owner.read_fields(self._header, [name], ROWS)
        )

    def _find_colours(self, node):
        ranges = [find_range(node, self._types, "colorLimits", name, name) for name in COLOURS]
        if all(found.is_known for found in ranges):
            return ranges
        parts = self._owner.read_fields(self._header, COLOURS, ROWS)
        largest = max((np.nanmax(values) for each in parts for values in each.values()), default=0)
        return [Range(0.0, full_colour(largest))] * 3

    def chunks(self, rows, counts):
        """Yields the valid points; adds to the counts of what is not valid."""
        for data in self._owner.read_fields(self._header, self._fields, rows):
            yield self._to_chunk(data, counts)

    def may_have_misses(self):
        """Returns whether points may be marked as directions without an echo."""
        return self._state_name() in self._fields

    def misses(self):
        """Yields the directions of pulses without an echo, in the world."""
        turn = rotation_matrix(self._scan.rotation) if self._scan.has_pose else np.eye(3)
        for data in self._owner.read_fields(self._header, self._fields, ROWS):
            mark = data[self._state_name()] == DIRECTION_ONLY
            xyz = self._find_local({name: values[mark] for name, values in data.items()})
            lengths = np.linalg.norm(xyz, axis=1)
            yield (xyz[lengths > 0] / lengths[lengths > 0, None]) @ turn.T

    def _state_name(self):
        return STATES[0] if self._fields.issuperset(XYZ) else STATES[1]

    def _to_chunk(self, data, counts):
        data = self._drop_invalid(data, counts)
        check_flags(data, counts)
        chunk = {"points": self._place(data)}
        if "timeStamp" in data:
            chunk[GPS_TIME] = data["timeStamp"] + self._shift
        if "returnIndex" in data:
            chunk[RETURN_NUMBER] = (data["returnIndex"] + 1).astype(np.uint8)
        if "returnCount" in data:
            chunk[NUMBER_OF_RETURNS] = data["returnCount"].astype(np.uint8)
        for name, field in TREES.items():
            if field in data:
                chunk[name] = data[field].astype(TREE_TYPES[name])
        if "intensity" in data:
            self._add_intensity(chunk, data["intensity"], counts)
        if self._colours:
            parts = [found.to_unit(data[name]) for found, name in zip(self._colours, COLOURS)]
            chunk[RGB] = np.clip(np.column_stack(parts), 0.0, 1.0).astype(np.float32)
        return chunk

    def _drop_invalid(self, data, counts):
        state = data.get(self._state_name())
        if state is None:
            return data
        valid = state == 0
        for words, found in (("directions", state == DIRECTION_ONLY), ("invalid", ~valid)):
            counts[words] = counts.get(words, 0) + int(np.count_nonzero(found))
        counts["invalid"] -= int(np.count_nonzero(state == DIRECTION_ONLY))
        return {name: values[valid] for name, values in data.items()}

    def _place(self, data):
        """World coordinates; values that are not finite stay so."""
        with np.errstate(invalid="ignore", over="ignore"):
            return self._move_to_world(data)

    def _find_local(self, data):
        """Returns coordinates in the frame of the scanner."""
        if all(name in data for name in XYZ):
            return np.column_stack([data[name] for name in XYZ])
        r, azimuth, elevation = (data[name] for name in POLAR)
        flat = r * np.cos(elevation)
        return np.column_stack(
            [flat * np.cos(azimuth), flat * np.sin(azimuth), r * np.sin(elevation)]
        )

    def _move_to_world(self, data):
        xyz = self._find_local(data)
        scan = self._scan
        if scan.has_pose:
            xyz = xyz @ rotation_matrix(scan.rotation).T + np.asarray(scan.translation)
        return xyz

    def _add_intensity(self, chunk, values, counts):
        if self._is_amplitude:
            chunk[AMPLITUDE] = values
            return
        if not self._intensity.is_known:
            chunk[INTENSITY] = values
            return
        scaled = np.rint(self._intensity.to_unit(values) * FULL)
        finite = np.isfinite(scaled)
        outside = np.count_nonzero(finite & ((scaled < 0) | (scaled > FULL)))
        for words, count in (("not finite", np.count_nonzero(~finite)), ("clipped", outside)):
            if count:
                counts[words] = counts.get(words, 0) + int(count)
        chunk[INTENSITY] = np.clip(np.where(finite, scaled, 0.0), 0, FULL).astype(np.uint16)
