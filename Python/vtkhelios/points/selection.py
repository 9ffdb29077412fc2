# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which points of a cloud are wanted."""

import numpy as np

from ..array_names import CLASSIFICATION_IDS, NUMBER_OF_RETURNS, RETURN_NUMBER
from ..formats import FormatError

RETURNS = ("all", "first", "last", "single")


class Selection:
    """Points by their return, class and number; counts them."""

    def __init__(self, returns="all", classes=None, every=1, skip_invalid=False):
        self.returns = returns
        self.classes = classes
        self.every = every
        self.skip_invalid = skip_invalid
        self.seen = 0
        self.invalid = 0

    def of_chunk(self, chunk, path):
        """Returns the mask of a chunk of arrays, or None: all."""
        keep = self._finite(chunk["points"], path)
        masks = [keep] if keep is not None else []
        if self.returns != "all":
            number, count = (self._array(chunk, name, path, "--returns")
                             for name in (RETURN_NUMBER, NUMBER_OF_RETURNS))  # fmt: skip
            masks.append(self._by_return(number, count))
        if self.classes is not None:
            masks.append(np.isin(self._array(chunk, CLASSIFICATION_IDS, path, "--class"),
                                 self.classes))  # fmt: skip
        return self._join(masks, len(chunk["points"]))

    def of_records(self, records, is_long):
        """Returns the mask of LAS records, or None: all."""
        masks = []
        if self.returns != "all":
            bits, width = records["bit_fields"], 4 if is_long else 3
            low = (1 << width) - 1
            masks.append(self._by_return(bits & low, bits >> width & low))
        if self.classes is not None:
            field = records["classification"] if is_long else records["raw_classification"] & 31
            masks.append(np.isin(field, self.classes))
        return self._join(masks, len(records))

    def _array(self, chunk, name, path, option):
        if name not in chunk:
            raise FormatError(f"{path}: has no {name}; leave {option} out")
        return chunk[name]

    def _by_return(self, number, count):
        if self.returns == "first":
            return number <= 1
        return number >= count if self.returns == "last" else count <= 1

    def _finite(self, points, path):
        """None if all coordinates are finite."""
        if np.isfinite(points).all():
            return None
        finite = np.isfinite(points).all(axis=1)
        if not self.skip_invalid:
            row = int(np.flatnonzero(~finite)[0])
            place = ", ".join(f"{value:g}" for value in points[row])
            raise FormatError(
                f"{path}: point {self.seen + row} is ({place}), not finite; correct it, or drop "
                "such points with --skip-invalid"
            )
        self.invalid += int(np.count_nonzero(~finite))
        return finite

    def _join(self, masks, count):
        first, self.seen = self.seen, self.seen + count
        mask = np.logical_and.reduce(masks) if masks else None
        if self.every == 1:
            return mask
        kept = (np.arange(first, first + count) % self.every) == 0
        return kept if mask is None else kept & mask
