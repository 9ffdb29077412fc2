# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""PLY, read by vtkHeliosPLYPointReader. Written is binary, little endian, every array a property of
the vertices: VTK's writer uses floats for coordinates and drops arrays; a vertex of fixed size is a
numpy record, so writing is a header and copies.
"""

import numpy as np

from ..array_names import INTENSITY, NORMALS, ORIENTATION, PART_ORIENTATION, RGB
from ..core.classes import vtk_class
from ..core.paths import to_vtk
from ._base import FileWriter, Header, Reader, call, from_cloud, rows_of
from ._names import TREE_NAMES
from ._ply_names import PlyNames, to_ascii

WORDS = {"i1": "char", "u1": "uchar", "i2": "short", "u2": "ushort", "i4": "int", "u4": "uint"}
WORDS |= {"f4": "float", "f8": "double"}
MARK = "vtkhelios"  # mark of comments with data that PLY cannot store, which the reader knows

# Names that other programs read.
NORMAL_FIELDS, COLOURS = ("nx", "ny", "nz"), ("red", "green", "blue")
INTENSITY_FIELD = "intensity"
QUATERNIONS = (ORIENTATION, PART_ORIENTATION)  # arrays of four components, which end in 0 to 3
LARGEST = 2**53  # limit of the integers that are stored as doubles: all are exact
COUNT_WIDTH = 20  # width of the vertex count, filled with a comment


class PlyReader(Reader):
    def __init__(self, path):
        super().__init__(path)
        self._reader = vtk_class("vtkHeliosPLYPointReader")()
        self._reader.SetFileName(to_vtk(self.path))
        fields = self._read(0, 2**31 - 1)  # few points, if any
        self.count = self._reader.GetNumberOfVertices()
        if self.count == 0:
            self.fail("has no points; give a file with points")
        del fields["points"]
        self._names = PlyNames({name: values.dtype.str[1:] for name, values in fields.items()})
        self.kind = f"PLY {self._reader.GetFormat()}"
        self.header = Header(self._reader.GetOutput().GetFieldData())

    def _read(self, piece, pieces):
        """Returns the properties of a piece of the points, but for x, y and z as points."""
        call(self, self._reader, lambda: self._reader.UpdatePiece(piece, pieces, 0))
        cloud = self._reader.GetOutput()
        if cloud.GetPointData().HasArray("points"):
            self.fail('has a property "points", which is reserved for coordinates; rename it')
        return from_cloud(cloud)

    def read_chunks(self, rows):
        pieces, wanted = -(-self.count // rows), self._names.wanted()
        for piece in range(pieces if wanted else 0):
            fields = self._read(piece, pieces)
            for name in wanted:
                self._names.add_range(name, fields[name])
        for piece in range(pieces):
            yield self._to_chunk(self._read(piece, pieces))

    def _to_chunk(self, fields):
        names = self._names
        chunk = {"points": fields.pop("points")}
        if names.normals:
            chunk[NORMALS] = _stack(fields, names.normals)
        if names.colours:
            chunk[RGB] = (_stack(fields, names.colours) / names.full_colour()).astype(np.float32)
        for name in list(fields):
            if name in fields:
                self._add(chunk, fields, name)
        return chunk

    def _add(self, chunk, fields, name):
        """A property, or three of them, as an array; of quaternions four."""
        three = [name[:-1] + axis for axis in "XYZ"]
        if name == three[0] and name[:-1] and all(each in fields for each in three):
            if name[:-1] in {"points", *chunk}:
                self.fail(f'has a property "{name}" beside {name[:-1]}; leave one out')
            chunk[name[:-1]] = _stack(fields, three)
            return
        four = [f"{name[:-1]}{k}" for k in range(4)]
        if name[:-1] in QUATERNIONS and all(each in fields for each in four):
            chunk[name[:-1]] = _stack(fields, four)
            return
        source = name
        name, values = self._names.convert(name, fields.pop(name))
        if name in chunk:
            self.fail(f'has a property "{name}" in addition to {name}; leave one out')
        chunk[name] = values
        if name == INTENSITY and self._names.wants_scale(source):
            self._scale(chunk, source)

    def _scale(self, chunk, source):
        """Intensities of other types as 16 bits."""
        scale = self._names.scale(source)
        scale.apply(chunk)
        note = f"{self.path}: {scale.note}"
        if scale.note and note not in self.notes:
            self.notes.append(note)


def _stack(fields, names):
    return np.column_stack([fields.pop(name) for name in names])


def _line(text):
    """Returns a text as a line of ASCII."""
    return to_ascii(" ".join(text.split()))


def _word(name):
    """Returns a name as one word of ASCII."""
    return to_ascii("_".join(name.split()) or "_")


class PlyWriter(FileWriter):
    def __init__(self, path, header):
        super().__init__(path, header)
        self._type = None
        self._wide = {}  # arrays that are stored as floats: type

    def store(self, chunk):
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
        """Yields the properties of a chunk: name, values."""
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
        if len(values) and max(abs(int(values.min())), abs(int(values.max()))) > LARGEST:
            self.fail(f"PLY stores whole numbers to 2^53, but {name} has larger ones; leave it out")
        if values.ndim == 1:
            self._wide[name] = values.dtype.name
        return values.astype(np.float64)

    def _head(self, count):
        """Returns the header, of the same size for any count."""
        text = str(count)
        lines = ["ply", "format binary_little_endian 1.0"]
        lines.append("comment " + "." * (COUNT_WIDTH - len(text)))
        if self.header.crs:
            lines.append(f"comment {MARK} crs {_line(self.header.crs)}")
        if self.header.epoch:
            lines.append(f"comment {MARK} epoch {self.header.epoch!r}")
        for name in TREE_NAMES:
            texts = enumerate(self.header.texts(name))
            lines += [f"comment {MARK} name:{name}:{i} {_line(text)}" for i, text in texts]
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
