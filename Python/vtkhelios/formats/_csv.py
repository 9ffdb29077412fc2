# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""CSV with a line of names, as PDAL writes it: every array is a column, numbers have all digits."""

import numpy as np

from ..array_names import NORMAL, NORMALS, RGB
from ..core.classes import vtk_class
from ._base import FileWriter, rows_of
from ._text import TextReader

__all__ = ["CsvWriter", "TextReader"]

NAMES = {RGB: ("Red", "Green", "Blue"), NORMALS: tuple(f"{NORMAL}{axis}" for axis in "XYZ")}
FULL = 65535


class CsvWriter(FileWriter):
    def __init__(self, path, header):
        super().__init__(path, header)
        self._names = None

    def store(self, chunk):
        columns = dict(self._columns(chunk))
        if self._names is None:
            self._names = list(columns)
            self.open_part()
            self.file.write((",".join(map(_quote, self._names)) + "\n").encode())
        elif list(columns) != self._names:
            self.fail(
                f"points have the columns {', '.join(columns)}, but those before "
                f"{', '.join(self._names)}; convert the files one by one"
            )
        words = [map(repr, values.tolist()) for values in columns.values()]
        self.file.write(("\n".join(map(",".join, zip(*words))) + "\n").encode())
        self.count += rows_of(chunk)

    def _columns(self, chunk):
        """Yields the columns of a chunk: name, values."""
        yield from zip("XYZ", chunk["points"].T)
        for name, values in chunk.items():
            if name == "points":
                continue
            if name == RGB:
                values = np.rint(np.nan_to_num(values) * FULL).clip(0, FULL).astype(np.int64)
            if values.ndim == 1:
                yield vtk_class("vtkHeliosPointTextReader").GetCommonName(name) or name, values
                continue
            parts = NAMES.get(name) or [f"{name}{k}" for k in range(values.shape[1])]
            yield from zip(parts, values.T)

    def close(self):
        if not self.count:
            self.abandon()
            self.fail("would have no points; change the selection")
        self.file.close()
        self.keep_part()


def _quote(name):
    """Returns a name in one column and one line."""
    return "".join("_" if each in ',"\r\n' else each for each in name)
