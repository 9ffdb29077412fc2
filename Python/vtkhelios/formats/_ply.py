# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""PLY: binary, little endian, every array a property of the vertices.

VTK's writer uses floats for coordinates and drops arrays; a vertex of fixed size is a numpy record,
so reading and writing are a header and copies.
"""

import numpy as np

from ..array_names import INTENSITY, NORMALS, RGB
from ._base import ROWS, FileWriter, Reader, rows_of
from ._ply_names import PlyNames, from_ascii, to_ascii

TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2",
    "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8",
}  # fmt: skip
WORDS = {"i1": "char", "u1": "uchar", "i2": "short", "u2": "ushort", "i4": "int", "u4": "uint"}
WORDS |= {"f4": "float", "f8": "double"}
MARK = "vtkhelios"  # of comments with data that PLY cannot store

# Names that other programs read.
NORMAL_FIELDS, COLOURS = ("nx", "ny", "nz"), ("red", "green", "blue")
INTENSITY_FIELD = "intensity"
# Integers that are stored as floats, by type: the largest that are exact.
LARGEST = {"int64": 2**53, "uint64": 2**53, "uint16": 65535}
COUNT_WIDTH = 20  # width of the vertex count, filled with a comment


class PlyReader(Reader):
    def __init__(self, path):
        super().__init__(path)
        self._properties = []  # name, type
        self._marks = {}  # data of our comments
        with open(self.path, "rb") as file:
            self._read_head(file)
            self._begin = file.tell()
            file.seek(0, 2)
            size = file.tell() - self._begin
        marked = {name for name, _ in self._properties if f"type:{to_ascii(name)}" in self._marks}
        self._names = PlyNames(dict(self._properties), marked)
        if self.count is None or None in self._names.axes:
            self.fail("has no vertices with x, y and z; give a file with points")
        if self.count == 0:
            self.fail("has no points; give a file with points")
        order = ">" if self._form == "binary_big_endian" else "<"
        self._type = np.dtype([(name, order + kind) for name, kind in self._properties])
        if self._form != "ascii" and size < self.count * self._type.itemsize:
            self.fail(
                f"is cut off: it has {size // self._type.itemsize} whole points of the "
                f"{self.count} that its header counts; copy it again"
            )
        too_few = size + 1 < 2 * len(self._properties) * self.count
        if self._form == "ascii" and self.count > ROWS and too_few:
            self.fail(
                f"has {self.count} points, but only {size} bytes after the header; " "copy it again"
            )
        self.kind = f"PLY {self._form}"
        self.header.crs = from_ascii(self._marks.get("crs", ""))
        self.header.epoch = self._read_epoch()

    def _read_head(self, file):
        if file.readline().split() != [b"ply"]:
            self.fail("is not a PLY file: it does not start with ply; check its name")
        self._form, element = None, None
        for _ in range(10_000):
            line = file.readline(100_000)
            words = line.decode("latin-1").split()
            if words == ["end_header"]:
                break
            if not line:
                self.fail("ends within its header; copy it again")
            if words[:1] == ["format"] and len(words) == 3:
                self._form = words[1]
            elif words[:2] == ["comment", MARK] and len(words) > 2:
                self._marks[words[2]] = " ".join(words[3:])
            elif words[:1] == ["element"] and len(words) == 3:
                element = words[1]
                if element == "vertex" and self.count is not None:
                    self.fail("has vertices twice; write them as one element")
                if element == "vertex":
                    self.count = self._whole(words[2])
                elif self.count is None and self._whole(words[2]):
                    self.fail(f'has "{element}" before its vertices; write the vertices first')
            elif words[:1] == ["property"] and element == "vertex":
                self._take_property(words)
        else:
            self.fail("has more than 10000 lines of header; is it a PLY file?")
        if self._form not in ("ascii", "binary_little_endian", "binary_big_endian"):
            self.fail(f'has the format "{self._form}"; give ascii or binary')

    def _whole(self, word):
        if not (word.isascii() and word.isdigit() and len(word) < 19):
            self.fail(f'counts "{word}" elements, which is not a number; write it again')
        return int(word)

    def _take_property(self, words):
        if len(words) != 3 or words[1] not in TYPES:
            self.fail(f'has a vertex with "{" ".join(words)}"; only plain numbers can be read')
        if words[2] == "points" or words[2] in dict(self._properties):
            why = "that is reserved for coordinates" if words[2] == "points" else "twice"
            self.fail(f'has a property "{words[2]}" {why}; give each property a unique name')
        self._properties.append((from_ascii(words[2]), TYPES[words[1]]))

    def _read_epoch(self):
        """The time origin in our comment, 0: none."""
        word = self._marks.get("epoch", "0")
        try:
            epoch = float(word)
        except ValueError:
            epoch = np.nan
        if not np.isfinite(epoch):
            self.fail(
                f'gives "{word}" as the origin of its times, which is not a number; correct it'
            )
        return epoch

    def read_chunks(self, rows):
        wanted = self._names.wanted()
        for vertices in self._read_vertices(rows) if wanted else ():
            for name in wanted:
                self._names.add_range(name, vertices[name])
        for vertices in self._read_vertices(rows):
            yield self._to_chunk(vertices)

    def _read_vertices(self, rows):
        done = 0
        with open(self.path, "rb") as file:
            file.seek(self._begin)
            while done < self.count:
                number = min(rows, self.count - done)
                yield self._take(file, number, done)
                done += number

    def _take(self, file, number, done):
        if self._form != "ascii":
            return np.fromfile(file, self._type, number)
        lines = [file.readline() for _ in range(number)]
        if not any(line.strip() for line in lines):
            self.fail(f"has {done} whole points of {self.count}; copy it again")
        try:
            table = np.loadtxt(lines, ndmin=2, comments=None)
        except ValueError as error:
            self.fail(f"vertices {done} to {done + number} cannot be read: {error}; correct them")
        if table.shape != (number, len(self._properties)):
            self.fail(f"has {done + len(table)} whole points of {self.count}; copy it again")
        vertices = np.empty(number, self._type)
        for column, (name, _) in enumerate(self._properties):
            self._fill(vertices, name, table[:, column], done)
        return vertices

    def _fill(self, vertices, name, values, done):
        """Numbers of text as the type in the header."""
        with np.errstate(invalid="ignore", over="ignore"):
            vertices[name] = values
        wrong = vertices[name] != values
        if vertices.dtype[name].kind != "f" and wrong.any():
            row = int(np.flatnonzero(wrong)[0])
            self.fail(
                f"{name} of vertex {done + row} is {values[row]:g}, not of type "
                f"{vertices.dtype[name].name}; correct it"
            )

    def _to_chunk(self, vertices):
        fields = {name: vertices[name].astype(vertices[name].dtype.newbyteorder("="))
                  for name, _ in self._properties}  # fmt: skip
        names = self._names
        chunk = {"points": _stack(fields, names.axes).astype(np.float64)}
        if names.normals:
            chunk[NORMALS] = _stack(fields, names.normals)
        if names.colours:
            chunk[RGB] = (_stack(fields, names.colours) / names.full_colour()).astype(np.float32)
        for name in list(fields):
            if name in fields:
                self._add(chunk, fields, name)
        return chunk

    def _add(self, chunk, fields, name):
        """A property, or three of them, as an array."""
        three = [name[:-1] + axis for axis in "XYZ"]
        if name == three[0] and name[:-1] and all(each in fields for each in three):
            if name[:-1] in {"points", *chunk}:
                self.fail(f'has a property "{name}" beside {name[:-1]}; leave one out')
            chunk[name[:-1]] = _stack(fields, three)
            return
        source = name
        name, values = self._names.convert(name, fields.pop(name))
        if name in chunk:
            self.fail(f'has a property "{name}" in addition to {name}; leave one out')
        kind = self._marks.get(f"type:{to_ascii(source)}")
        chunk[name] = self._to_whole(name, values, kind) if kind in LARGEST else values
        if name == INTENSITY and self._names.wants_scale(source):
            self._scale(chunk, source)

    def _scale(self, chunk, source):
        """Intensities of other types as 16 bits."""
        scale = self._names.scale(source)
        scale.apply(chunk)
        note = f"{self.path}: {scale.note}"
        if scale.note and note not in self.notes:
            self.notes.append(note)

    def _to_whole(self, name, values, kind):
        """Integers stored as floats by the writer."""
        exact = np.rint(values) == values
        low = 0 if kind == "uint16" else -LARGEST[kind]
        if not (exact & (values >= low) & (values <= LARGEST[kind])).all():
            limit = "65535" if kind == "uint16" else "2^53"
            self.fail(f"has values of {name} that are not whole numbers to {limit}; correct them")
        return values.astype(kind)


def _stack(fields, names):
    return np.column_stack([fields.pop(name) for name in names])


def _word(name):
    """A name as one word of ASCII."""
    return to_ascii("_".join(name.split()) or "_")


class PlyWriter(FileWriter):
    def __init__(self, path, header):
        super().__init__(path, header)
        self._type = None
        self._wide = {}  # arrays that are stored as floats: type

    def put(self, chunk):
        fields = dict(self._fields(chunk))
        kinds = [(name, "<" + values.dtype.str[1:]) for name, values in fields.items()]
        if self._type is None:
            self._type = np.dtype(kinds)
            self.open_part()
            self.file.write(self._head(0))
        elif np.dtype(kinds) != self._type:
            self.fail(
                f"points have the properties {', '.join(fields)}, but those before "
                f"{', '.join(self._type.names)}; convert the files one by one"
            )
        vertices = np.empty(rows_of(chunk), self._type)
        for name, values in fields.items():
            vertices[name] = values
        self.file.write(np.ascontiguousarray(vertices))
        self.count += len(vertices)

    def _fields(self, chunk):
        """The properties of a chunk: name, values."""
        yield from zip("xyz", np.asarray(chunk["points"], np.float64).T)
        for name, values in chunk.items():
            if name == "points":
                continue
            if name == NORMALS:
                yield from zip(NORMAL_FIELDS, values.T)
            elif name == RGB:
                yield from zip(COLOURS, self._colours(values).T)
            elif name == INTENSITY and values.dtype == np.uint16 and INTENSITY_FIELD not in chunk:
                self._wide[INTENSITY_FIELD] = values.dtype.name
                yield INTENSITY_FIELD, values.astype(np.float32)  # Open3D reads no ushort
            elif values.ndim == 2 and values.shape[1] == 3:
                yield from zip([name + axis for axis in "XYZ"], self._fit(name, values).T)
            elif values.ndim == 2:
                yield from zip([f"{name}{i}" for i in range(values.shape[1])],
                               self._fit(name, values).T)  # fmt: skip
            else:
                yield name, self._fit(name, values)

    def _colours(self, values):
        bytes_of = np.rint(np.clip(values, 0, 1) * 255).astype(np.uint8)
        if np.abs(bytes_of / 255.0 - values).max(initial=0) > 1e-6:
            self.lost[RGB] = "only 8 bits per colour are stored"
        return bytes_of

    def _fit(self, name, values):
        """64-bit integers as doubles, exact up to 2^53."""
        if values.dtype.itemsize < 8 or values.dtype.kind == "f":
            return values
        if len(values) and max(abs(int(values.min())), abs(int(values.max()))) > LARGEST["int64"]:
            self.fail(f"PLY stores whole numbers to 2^53, but {name} has larger ones; leave it out")
        if values.ndim == 1:
            self._wide[name] = values.dtype.name
        return values.astype(np.float64)

    def _head(self, count):
        """The header, of the same size for any count."""
        text = str(count)
        lines = ["ply", "format binary_little_endian 1.0"]
        lines.append("comment " + "." * (COUNT_WIDTH - len(text)))
        if self.header.crs:
            lines.append(f"comment {MARK} crs {to_ascii(' '.join(self.header.crs.split()))}")
        if self.header.epoch:
            lines.append(f"comment {MARK} epoch {self.header.epoch!r}")
        lines += [f"comment {MARK} type:{_word(name)} {kind}" for name, kind in self._wide.items()]
        lines.append(f"element vertex {text}")
        lines += [f"property {WORDS[kind.str[1:]]} {_word(name)}" for name, (kind, _) in
                  self._type.fields.items()]  # fmt: skip
        return ("\n".join([*lines, "end_header"]) + "\n").encode("ascii")

    def close(self):
        if not self.count:
            self.abandon()
            self.fail("would have no points; change the selection")
        self.file.seek(0)
        self.file.write(self._head(self.count))
        self.file.close()
        self.keep_part()
