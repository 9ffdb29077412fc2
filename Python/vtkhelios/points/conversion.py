# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of some files into another one: as LAS records where both ends are LAS, else as arrays."""

import contextlib
import dataclasses
import pathlib

import numpy as np

from .. import formats

from ..array_names import (
    COORDINATE_SCALE, CRS, GPS_EPOCH, GPS_TIME, ORIENTATION, PART_NAME,
)  # fmt: skip
from ..core.classes import vtk_class
from ..core.files import drop_part, keep_part, open_part
from ..core.systems import find_system
from ..core.words import counted
from ..formats._base import call, from_cloud, rows_of, select, to_cloud

from ..formats._names import (
    NAMES, TREE_NAMES, NameUnion, add_names, check_names, names_file, renumber, tables_of,
    write_names,
)  # fmt: skip
from ..formats._records import RecordReader, RecordWriter, same_form
from ..formats._run import RunReader
from ..formats._union import explain_missing, fill, join_layouts, layout_of

RECORDS = (".las", ".laz", ".copc.laz")
NAMED = (".vtp", ".pvtp", *RECORDS)  # formats that store names of parts and materials


class Conversion:
    """One output and its inputs."""

    def __init__(
        self, inputs, output, selection, crs=None, waveforms=None, height_unit=None, epoch=None
    ):
        self.inputs = inputs
        self.output = str(output)
        self.selection = selection
        self.crs = crs
        self.height_unit = height_unit
        self.epoch = epoch
        self.waveforms = waveforms
        self.kinds = []  # inputs: path, kind, count
        self.notes = []
        self.lost = {}
        self.count = 0

    def files(self):
        """Returns all files of the output."""
        path = pathlib.Path(self.output)
        kind = formats.ending(path)
        beside = [path.with_suffix(".wdp")] if kind in (".las", ".laz") else []
        return [path, *beside, *([names_file(path)] if kind in RECORDS else [])]

    def run(self, task):
        """Converts; if it raises anything, it writes no output."""
        paths = self._record_files()
        if paths and self._copy_records(paths, task):
            return
        if self.waveforms:
            raise formats.FormatError(
                f"{self.output}: waveforms are copied only from LAS or LAZ to LAS or LAZ, of one "
                "form if "
                "there are several inputs; leave --waveforms out"
            )
        self._convert(task)

    # Records.

    def _record_files(self):
        """The files whose records can be copied; empty if arrays are needed."""
        is_changed = self.crs or self.height_unit
        if formats.ending(self.output) not in (".las", ".laz") or is_changed:
            return []
        paths = []
        for each in self.inputs:
            paths += self._files_of_run(each) if isinstance(each, RunReader) else [each]
        return paths if all(formats.ending(path) in RECORDS for path in paths) else []

    def _files_of_run(self, run):
        """Its point files, or with --waveforms those that have the same points with waveforms."""
        waveform_files = run.waveform_files() if self.waveforms else []
        return [str(run.folder / name) for name in waveform_files or run.files]

    def _copy_records(self, paths, task):
        readers = [RecordReader(path) for path in paths]
        self.notes += [note for reader in readers for note in reader.notes]
        for reader in readers[1:]:
            if why := same_form(readers[0], reader):
                self.notes.append(
                    f"{reader.path}: has {why} than {paths[0]}: points are converted as arrays; "
                    "header records of other programs are not kept"
                )
                return False
        names = self._find_names(readers)
        if names is None:
            return False
        packets = [reader.packets() for reader in readers]
        if self.waveforms and not all(packets):
            raise formats.FormatError(f"{paths[0]}: has no waveforms; leave --waveforms out")
        self.notes += filter(None, (reader.find_new_version() for reader in readers))
        task.total = sum(reader.header.point_count for reader in readers)
        self.kinds = [(r.path, _words(r), r.header.point_count) for r in readers]
        with Output(self.output, self._is_internal(packets)) as output:
            writer = RecordWriter(
                output.file, readers[0], compress=self.output.lower().endswith(".laz")
            )
            for reader, packet in zip(readers, packets):
                grown = writer.add_packets(packet) if packet else 0
                if not self._copy_file(reader, writer, grown, task):
                    output.abandon()
                    self.kinds.clear()
                    return False
            self._check_count()
            task.show_step("finishing")
            writer.close(output.internal, output.beside)
        write_names(self.output, self.count, names)
        return True

    def _find_names(self, readers):
        """Returns a header with the names of the points of all files; None: they have unlike
        ones."""
        headers = [formats.Header() for _ in readers]
        for reader, header in zip(readers, headers):
            if note := add_names(reader.path, reader.header.point_count, header):
                self.notes.append(note)
        for reader, header in zip(readers, headers):
            if tables_of(header) != tables_of(headers[0]):
                self.notes.append(
                    f"{reader.path}: has other names of parts or materials than {readers[0].path}: "
                    "points are converted as arrays; header records of other programs are not kept"
                )
                return None
        check_names(self.output, headers[0])
        return headers[0]

    def _is_internal(self, packets):
        """Returns whether packets are stored in the file; None: there are none."""
        found = [packet for packet in packets if packet]
        if not found:
            return None
        return self.waveforms == "internal" or (
            self.waveforms is None and not found[0][0].lower().endswith(".wdp")
        )

    def _copy_file(self, reader, writer, grown, task):
        is_long = reader.header.point_format.id >= 6
        for records in reader.chunks():
            total = len(records)
            mask = self.selection.of_records(records, is_long)
            records = records if mask is None else records[mask]
            if grown:
                named = records["wavepacket_index"] > 0
                records["wavepacket_offset"][named] += grown
            if not writer.shift(records, reader):
                self.notes.append(
                    f"{reader.path}: its coordinates do not fit the scale and offset of the first "
                    "file: points are converted as arrays"
                )
                self.count = self.selection.seen = 0
                task.done = 0
                return False
            writer.write(records)
            self.count += len(records)
            task.advance(total)
        return True

    # Arrays.

    def _convert(self, task):
        readers = [
            each if isinstance(each, RunReader) else formats.open_reader(each)
            for each in self.inputs
        ]
        for reader in readers:
            reader.keeps_invalid = True  # the selection handles them
            reader.fills_missing = not self._keeps_scans
        layouts = self._find_layouts()
        self._check_headers(readers, layouts)
        counts = [reader.count for reader in readers]
        task.total = None if None in counts else sum(counts)
        target = self._find_target(readers)
        moves = [self._make_move(reader, target) for reader in readers]
        header = formats.Header(readers[0].header.fields)
        self._set_header(header, target, moves, readers)
        union = self._join_layouts(layouts)
        names = NameUnion()
        moved = [names.add(reader.header) for reader in readers]
        names.set_names(header)
        try:
            with formats.open_writer(self.output, header) as writer:
                for reader, move, numbers in zip(readers, moves, moved):
                    steps = (self._find_shift(reader, header), numbers, move, union)
                    self._convert_file(reader, writer, steps, task)
                self._check_count()
                task.show_step("finishing")
            self.lost |= writer.lost
            self.notes += writer.notes
        finally:
            for reader in readers:
                self.notes += reader.notes
                reader.close()
        self._note_lost(readers)

    @property
    def _keeps_scans(self):
        """Whether the output holds scans with unlike arrays."""
        return formats.ending(self.output) == ".e57"

    @property
    def _missing(self):
        """The value of floats that points of other inputs have; text has no points with NaN."""
        return 0.0 if formats.ending(self.output) == ".xyz" else float("nan")

    def _find_layouts(self):
        """Returns the arrays of every input, by the path; empty for one input."""
        layouts = {}
        for each in self.inputs if len(self.inputs) > 1 else ():
            path = each.path if isinstance(each, RunReader) else str(each)
            with formats.open_reader(path) as reader:
                reader.keeps_invalid = True
                layouts[path] = layout_of(next(reader.chunks(1)))
        return layouts

    def _join_layouts(self, layouts):
        """Returns the arrays of the output, with notes on inputs without some of them; None: as
        they are."""
        if self._keeps_scans or not layouts:
            return None
        union = join_layouts(layouts.items())
        for path, layout in layouts.items():
            if note := explain_missing(path, layout, union, self._missing):
                self.notes.append(note)
        return union

    def _find_shift(self, reader, header):
        """Returns the shift of the times of a reader to the epoch of the output [s]."""
        epoch = reader.header.epoch
        return epoch - header.epoch if epoch and header.epoch else 0.0

    def _convert_file(self, reader, writer, steps, task):
        shift, numbers, move, union = steps
        scan, count = None, 0
        for chunk in reader.chunks():
            if scan != reader.scan:
                scan = reader.scan
                found = reader.scans[scan]
                writer.begin(move.move_scan(found) if move else found)
            total = rows_of(chunk)
            mask = self.selection.of_chunk(chunk, reader.path)
            chunk = chunk if mask is None else select(chunk, mask)
            if shift and GPS_TIME in chunk:
                chunk = {**chunk, GPS_TIME: chunk[GPS_TIME] + shift}
            if rows_of(chunk):
                chunk = renumber(chunk, numbers) if numbers else chunk
                chunk = move(chunk) if move else chunk
                writer.write(chunk if union is None else fill(chunk, union, self._missing))
            self.count += rows_of(chunk)
            count += total
            task.advance(total)
        self.kinds.append((reader.path, reader.kind, count))

    def _check_headers(self, readers, layouts):
        first = readers[0]
        timed = [reader for reader in readers if GPS_TIME in layouts.get(reader.path, (GPS_TIME,))]
        if timed:
            first.header.epoch = timed[0].header.epoch
        for other in readers[1:]:
            one, another = find_system(first.header.crs), find_system(other.header.crs)
            if not self.crs and not one.is_same(another.text):
                raise formats.FormatError(
                    f"{other.path}: has the coordinate system {another.label}, "
                    f"and {first.path} {one.label}; convert one of them first, with --crs"
                )
            unknown = 0.0 in (other.header.epoch, first.header.epoch)
            if other in timed and unknown and other.header.epoch != first.header.epoch:
                raise formats.FormatError(
                    f"{other.path}: its times count from {other.header.epoch:.17g} s of GPS time, "
                    f"and those of {first.path} from {first.header.epoch:.17g} s; convert each to a "
                    "file of its own"
                )

    def _find_target(self, readers):
        """Returns the coordinate system of the output: of --crs, else of the inputs."""
        known = next((reader.header.crs for reader in readers if reader.header.crs), "")
        if not self.height_unit or (self.crs and known):
            return self.crs or known
        target = known or self.crs
        return target and self._state_height_unit(target)

    def _state_height_unit(self, crs):
        try:
            return find_system(crs).with_height_unit(self.height_unit)
        except ValueError as error:
            raise formats.FormatError(f"{self.output}: {error}; leave --height-unit out") from error

    def _make_move(self, reader, target):
        """Returns a Move of the points of a reader to a system; None if they stay."""
        source = formats.Header(reader.header.fields)
        if self.height_unit and source.crs:
            source.crs = self._state_height_unit(source.crs)
        if not source.crs or find_system(source.crs).is_same(target):
            return None  # assigned, not converted
        return Move(source, target, self.epoch, self)

    def _set_header(self, header, target, moves, readers):
        """The system of the output, and the steps of its coordinates."""
        header.crs = target or ""
        steps = [reader.header.fields.GetArray(COORDINATE_SCALE) for reader in readers]
        header.fields.RemoveArray(COORDINATE_SCALE)
        if any(moves):
            if len(moves) == 1:
                moves[0].header = header
        elif len(steps) == 1 and steps[0]:
            header.fields.AddArray(steps[0])
        elif known := [each for each in steps if each]:
            header.set_steps([min(each.GetValue(axis) for each in known) for axis in range(3)])

    def _check_count(self):
        if self.count == 0:
            raise formats.FormatError(
                f"{self.output}: none of the {counted(self.selection.seen, 'point')} is selected; choose "
                "other --returns, --class or --every"
            )

    def _note_lost(self, readers):
        if any(reader.has_waveforms for reader in readers):
            self.lost["waveforms"] = "only copied from LAS or LAZ to LAS or LAZ, as records"
        kind = formats.ending(self.output)
        fields = {reader.header.fields.GetArrayName(i) for reader in readers
                  for i in range(reader.header.fields.GetNumberOfArrays())}  # fmt: skip
        if kind not in NAMED:
            kept = set(TREE_NAMES) if kind in (".ply", ".e57") else set()
            kept |= {PART_NAME} if kind == ".xyz" else set()
            for name in sorted((set(NAMES.values()) & fields) - kept):
                self.lost[name] = "points keep the numbers; LAS, LAZ, COPC and VTK store the names"
        if kind in (".xyz", ".csv") and fields & {CRS, GPS_EPOCH}:
            self.lost |= {name: "text has no header" for name in (CRS, GPS_EPOCH) if name in fields}


class Move:
    """Moves points and scans to another coordinate system, by vtkHeliosReproject."""

    def __init__(self, source, target, epoch, owner):
        self._source = source
        self._owner = owner  # collects the notes
        self.path = owner.output  # named in errors
        self._filter = vtk_class("vtkHeliosReproject")()
        self._filter.SetTargetCRS(target)
        self._filter.SetEpoch(epoch or 0.0)
        self.header = None  # gets the steps of the moved coordinates

    @property
    def notes(self):
        return self._owner.notes

    @notes.setter
    def notes(self, notes):
        self._owner.notes = notes

    def __call__(self, chunk):
        self._filter.SetInputData(to_cloud(chunk, self._source))
        call(self, self._filter, self._filter.Update)
        steps = self._filter.GetOutput().GetFieldData().GetArray(COORDINATE_SCALE)
        if self.header is not None and steps:
            self.header.fields.AddArray(steps)
        return from_cloud(self._filter.GetOutput())

    def move_scan(self, scan):
        """Returns a scan with its pose and its pulses moved."""
        if not scan.has_pose:
            return scan
        pose = {
            "points": np.array([scan.translation], float),
            ORIENTATION: np.array([scan.rotation], float),
        }
        moved = self(pose)
        return dataclasses.replace(
            scan,
            translation=tuple(moved["points"][0]),
            rotation=tuple(moved[ORIENTATION][0]),
            pulses=scan.pulses and (lambda: (self(chunk) for chunk in scan.pulses())),
        )


class Output:
    """A LAS or LAZ file, optionally with packets beside it, under names ending in .part."""

    def __init__(self, path, internal):
        self.path = pathlib.Path(path)
        self.internal = bool(internal)
        self._paths = [self.path]
        if internal is False:
            self._paths.append(self.path.with_suffix(".wdp"))
        self._files = []

    def __enter__(self):
        self.path.parent.mkdir(parents=True, exist_ok=True)
        for path in self._paths:
            self._files.append(open_part(path))
        self.file = self._files[0]
        self.beside = self._files[-1]
        return self

    def __exit__(self, kind, *_):
        if kind is not None or self.file.closed:
            self.abandon()
            return
        for file in self._files:
            file.close()
        for path in reversed(self._paths):  # the points, which need the packets, last
            keep_part(path)

    def abandon(self):
        for path, file in zip(self._paths, self._files):
            with contextlib.suppress(OSError):  # error of a full disk, already reported
                file.close()
            drop_part(path)


def _words(reader):
    header = reader.header
    kind = "LAZ" if header.are_points_compressed else "LAS"
    return f"{kind} {reader.version}, point format {header.point_format.id}"
