# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""All metrics of two clouds, row by row; what cannot be measured, with the reason."""

import numpy as np

from ..array_names import (
    AMPLITUDE, CLASSIFICATION_IDS, ECHO_WIDTH, INTENSITY, NUMBER_OF_RETURNS,
)  # fmt: skip
from ..core.words import counted
from ._blocks import Blocks, kolmogorov_smirnov, total_variation
from ._distances import MeshDistance, Nearest
from ._ground import box_of, cells_of
from ._planes import find_planes, find_shift

from ._pulses import (
    Lines, Missing, density, first_returns, is_empty, mean, multi_return_share, need,
    returns_per_pulse,
)  # fmt: skip
from .result import Histogram, Row, contains_zero

BINS = 60  # bins of histograms
OUTER = 0.3  # [%] of the points at either end share the outermost bins
EXPECTED = 5.0  # points in a cell, for it to count as occluded: by chance 0.7 % have none
POINTS_OF_CLASS = 100  # in both clouds; smaller classes are left out
NO_GROUND = "the clouds share no ground"
STAGES = ("pulses", "spacing", "heights", "echoes", "planes", "distances", "mesh", "classes")


class Measurement:
    """Measures two Sides on their Ground."""

    def __init__(self, sides, ground, seed, sample, on_step):
        self.sides, self.ground, self.sample, self._on_step = sides, ground, sample, on_step
        self.blocks = Blocks(ground.tiles, seed)
        self.rows, self.absent, self.histograms = [], [], []
        self.shift, self.registration = [None] * 3, f"not known: {NO_GROUND}"
        self._stage = 0

    def run(self, mesh):
        for self._stage, name in enumerate(STAGES):
            self.on_step(name, 0.0)
            getattr(self, f"measure_{name}")(*[mesh][: name == "mesh"])

    def on_step(self, name, share):
        self._on_step(name, (self._stage + share) / len(STAGES))

    # Rows.

    def add(self, name, unit, function, by_density=False, of_class=None, note=""):
        """A row of function(side) -> Sampled; or its reason in absent."""
        whole = name if of_class is None else f"{name} of class {of_class}"
        try:
            a, b = (function(side) for side in self.sides)
        except Missing as missing:
            self.absent.append(f"{whole}: {missing}")
            return
        empty = [side.name for side, each in zip(self.sides, (a, b)) if is_empty(each)]
        if empty:
            self.absent.append(f"{whole}: {empty[0]} has too few points")
            return
        self.rows.append(
            Row(name, unit, a.estimate(), b.estimate(), b.minus(a).estimate(),
                by_density=by_density, of_class=of_class, note=note)
        )  # fmt: skip

    def add_single(self, name, unit, sampled, note=""):
        self.rows.append(Row(name, unit, None, None, sampled.estimate(), note=note))

    def add_histograms(self, name, unit, values, edges):
        """The distances of two histograms, and these for pictures. values: by side."""
        counts = [self._counts(side.tiles, each, edges) for side, each in zip(self.sides, values)]
        for kind, measure in (
            ("total variation", total_variation),
            ("Kolmogorov-Smirnov", kolmogorov_smirnov),
        ):
            sampled, chance = self.blocks.difference(*counts, measure)
            self.rows.append(
                Row(f"{name}, {kind}", "", None, None, sampled.estimate(), chance=chance)
            )
        a, b = (count.sum(axis=0) / count.sum() for count in counts)
        self.histograms.append(Histogram(name, unit, edges, a, b))

    def _counts(self, tiles, values, edges):
        known = np.isfinite(values)
        width = edges[1] - edges[0]
        bins = np.clip((values[known] - edges[0]) / width, 0, BINS - 1).astype(np.int64)
        flat = np.bincount(tiles[known] * BINS + bins, minlength=self.blocks.count * BINS)
        return flat.reshape(-1, BINS).astype(np.float64)

    def _draw(self, side):
        """Returns the rows of a random sample of the points."""
        if len(side) <= self.sample:
            return np.arange(len(side))
        return np.sort(self.blocks.random.choice(len(side), self.sample, replace=False))

    # Metrics.

    def measure_pulses(self):
        self.add("returns per pulse", "", lambda side: returns_per_pulse(side, self.blocks))
        self.add("multi-return share", "", lambda side: multi_return_share(side, self.blocks))
        shared = self.ground.is_shared
        areas = [self.ground.areas(self.sides if shared else [side]) for side in self.sides]
        area_of = dict(zip(map(id, self.sides), areas))
        self.add("density", "points/m²",
                 lambda side: density(side, self.blocks, area_of[id(side)]), True)  # fmt: skip
        self.add(
            "pulse density", "pulses/m²",
            lambda side: density(side, self.blocks, area_of[id(side)], first_returns(side)), True,
            note="pulses with a return",
        )  # fmt: skip

    def measure_spacing(self):
        lines = {}

        def lines_of(side):
            if id(side) not in lines:
                lines[id(side)] = Lines(side, self.ground.tile)
            return lines[id(side)]

        self.add("spacing along lines", "m", lambda side: lines_of(side).along(self.blocks),
                 note="of successive pulses, in plan view")  # fmt: skip
        self.add("spacing across lines", "m", lambda side: lines_of(side).across(self.blocks),
                 note="of successive lines, in plan view")  # fmt: skip
        self.add("nearest-neighbour spacing", "m", self._spacing, True)

    def _spacing(self, side):
        if len(side) < 2:
            raise Missing(f"{side.name} has one point")
        rows = self._draw(side)
        found = Nearest(side.points).spacing(rows, self.on_step)
        return self.blocks.quantile(found, side.tiles[rows])

    def measure_heights(self):
        """Above the lowest point of the column: of both clouds, where they share the ground."""
        shared = self.ground.is_shared
        heights = []
        for side in self.sides:
            low = self.ground.lowest(self.sides if shared else [side])
            heights.append(side.points[:, 2] - low[side.columns_of])
            side.columns["Height"] = heights[-1]
        self.add("mean height", "m",
                 lambda side: mean(self.blocks, side["Height"], side.tiles),
                 note=f"above the lowest point within {self.ground.column:g} m")  # fmt: skip
        top = max(np.percentile(each, 100 - OUTER) for each in heights)
        edges = np.linspace(0.0, top if top > 0 else 1.0, BINS + 1)
        self.add_histograms("height profile", "m", heights, edges)

    def measure_echoes(self):
        if all(AMPLITUDE in side for side in self.sides):
            self._measure_values(AMPLITUDE, "amplitude", "dB", decibels)
        elif all(INTENSITY in side for side in self.sides):
            self._measure_values(INTENSITY, "intensity", "", _plain)
        else:
            names = [side.name for side in self.sides if AMPLITUDE not in side]
            self.absent.append(
                f"amplitude: {names[0]} has no {AMPLITUDE}, and not both {INTENSITY}"
            )
        self._measure_values(ECHO_WIDTH, "echo width", "ns", _plain)

    def _measure_values(self, array, name, unit, convert):
        try:
            for side in self.sides:
                need(side, array)
            values = [convert(side[array]) for side in self.sides]
            known = [each[np.isfinite(each)] for each in values]
            for side, each in zip(self.sides, known):
                if not len(each):
                    raise Missing(f"{side.name} has no finite {array}")
        except Missing as missing:
            self.absent.append(f"{name}: {missing}")
            return
        by_side = dict(zip(map(id, self.sides), values))

        def median(side):
            each = by_side[id(side)]
            return self.blocks.quantile(each[np.isfinite(each)], side.tiles[np.isfinite(each)])

        self.add(f"median {name}", unit, median)
        ends = [np.percentile(each, [OUTER, 100 - OUTER]) for each in known]
        low, high = min(end[0] for end in ends), max(end[1] for end in ends)
        edges = np.linspace(low, high if high > low else low + 1.0, BINS + 1)
        self.add_histograms(f"{name} histogram", unit, values, edges)

    def measure_planes(self):
        if not self.ground.is_shared:
            self.absent.append(f"planes: {NO_GROUND}")
            return
        planes = find_planes(self.sides, self.ground.cell, self.blocks.random, self.on_step)
        if len(planes.offset) == 0:
            reason = f"no cell of {self.ground.cell:g} m is planar in both clouds"
            self.absent.append(f"planes: {reason}")
            self.registration = f"not known: {reason}"
            return
        order = {id(side): index for index, side in enumerate(self.sides)}
        blocks, tiles = self.blocks, planes.tiles
        self.add("planar share of cells", "", lambda side: blocks.ratio(
            blocks.sums(planes.cells, planes.planar[order[id(side)]]), blocks.sums(planes.cells)))  # fmt: skip
        count = f"{counted(len(planes.offset), 'cell')} planar in both clouds"
        self.add("noise of planes, RMS", "m", lambda side: blocks.ratio(
            blocks.sums(tiles, planes.squares[order[id(side)]]),
            blocks.sums(tiles, planes.freedom[order[id(side)]]), np.sqrt), note=count)  # fmt: skip
        rms = planes.rms
        self.add("noise of planes, median", "m",
                 lambda side: blocks.quantile(rms[order[id(side)]], tiles), note=count)  # fmt: skip
        self.add_single("offset of planes, median", "m", blocks.quantile(planes.offset, tiles),
                        "from A to B along upward normals")  # fmt: skip
        self._measure_shift(planes)

    def _measure_shift(self, planes):
        found, rest = find_shift(planes, self.blocks)
        self.shift = [each and each.estimate() for each in found]
        for axis, each in zip("xyz", found):
            if each is None:
                self.absent.append(f"shift {axis}: too few of the planes face {axis}")
            else:
                self.add_single(f"shift {axis}", "m", each, "of B against A, from planes")
        self.registration = describe_shift(self.shift, rest)

    def measure_distances(self):
        if not self.ground.is_shared:
            self.absent.append(f"distances, occluded cells: {NO_GROUND}")
            return
        found = {}
        for side, other in zip(self.sides, self.sides[::-1]):
            rows = self._draw(side)
            away = Nearest(other.points).distances(side.points[rows], self.on_step)
            found[id(side)] = away, side.tiles[rows]
        for name, share in (("median", 0.5), ("95th percentile", 0.95)):
            self.add(f"distance to the other cloud, {name}", "m",
                     lambda side, share=share: self.blocks.quantile(*found[id(side)], share), True,
                     note="of a point to the nearest one")  # fmt: skip
        self._measure_occlusion()

    def _measure_occlusion(self):
        """Cells that only one cloud has, of those in which the other would have EXPECTED points."""
        box = box_of([side.points for side in self.sides], self.ground.cell)
        numbers = [cells_of(side.points, self.ground.cell, *box) for side in self.sides]
        known, first, index = np.unique(np.concatenate(numbers), True, True)
        tiles = np.concatenate([side.tiles for side in self.sides])[first]
        parts = np.split(index, [len(numbers[0])])
        counts = [np.bincount(part, minlength=len(known)) for part in parts]
        per_tile = [self.blocks.sums(side.tiles) for side in self.sides]
        both = (per_tile[0] > 0) & (per_tile[1] > 0)
        ratio = np.median(per_tile[1][both] / per_tile[0][both])
        expected = {id(self.sides[0]): (0, ratio), id(self.sides[1]): (1, 1.0 / ratio)}

        def only(side):
            which, factor = expected[id(side)]
            full = counts[which] * factor >= EXPECTED
            if not full.any():
                raise Missing(f"no cell in which {EXPECTED:g} points of the other are expected")
            alone = full & (counts[1 - which] == 0)
            return self.blocks.ratio(self.blocks.sums(tiles[alone]), self.blocks.sums(tiles[full]))

        self.add("occluded in the other cloud", "", only,
                 note=f"cells of {self.ground.cell:g} m that only this cloud has")  # fmt: skip

    def measure_mesh(self, mesh):
        if mesh is None:
            return
        distance, reach, share, near = MeshDistance(mesh), self.ground.cell, {}, {}
        for side in self.sides:
            rows = self._draw(side)
            away, tiles = distance.distances(side.points[rows], self.on_step), side.tiles[rows]
            within = np.abs(away) <= reach
            share[id(side)] = within, tiles
            near[id(side)] = away[within], tiles[within]

        def near_of(side):
            if not len(near[id(side)][0]):
                raise Missing(f"no sampled point of {side.name} is within {reach:g} m of the mesh")
            return near[id(side)]

        def spread(side):
            values, tiles = near_of(side)
            return self.blocks.quantile(np.abs(values - np.median(values)), tiles)

        where = f"of points within {reach:g} m"
        self.add(f"share within {reach:g} m of the mesh", "",
                 lambda side: mean(self.blocks, *share[id(side)]))  # fmt: skip
        self.add("distance to the mesh, median", "m",
                 lambda side: self.blocks.quantile(*near_of(side)),
                 note=f"{where}, positive on the side of the normals")  # fmt: skip
        self.add("distance to the mesh, spread", "m", spread,
                 note=f"{where}: median absolute deviation; 0.674 times that of Gaussian noise")  # fmt: skip

    def measure_classes(self):
        missing = [side.name for side in self.sides if CLASSIFICATION_IDS not in side]
        if missing:
            self.absent.append(f"classes: {missing[0]} has no {CLASSIFICATION_IDS}")
            return
        counts = [np.unique(side[CLASSIFICATION_IDS], return_counts=True) for side in self.sides]
        sizes = [dict(zip(ids.tolist(), number.tolist())) for ids, number in counts]
        known = sorted(set(sizes[0]) | set(sizes[1]))
        if len(known) < 2:
            self.absent.append(f"classes: all points have class {known[0]}")
            return
        for number in known:
            few = [f"{side.name} has {size.get(number, 0):,}" for side, size in
                   zip(self.sides, sizes) if size.get(number, 0) < POINTS_OF_CLASS]  # fmt: skip
            if few:
                self.absent.append(
                    f"class {number}: {few[0]} points of it, fewer than {POINTS_OF_CLASS}"
                )
                continue
            self._measure_class(number)

    def _measure_class(self, number):
        blocks = self.blocks

        def mask(side):
            return side[CLASSIFICATION_IDS] == number

        self.add("share of points", "", lambda side: blocks.ratio(
            blocks.sums(side.tiles, mask(side)), blocks.sums(side.tiles)), of_class=number)  # fmt: skip
        if all(NUMBER_OF_RETURNS in side for side in self.sides):
            self.add("returns per pulse", "",
                     lambda side: returns_per_pulse(side, blocks, mask(side)), of_class=number,
                     note="of pulses whose first return is of the class")  # fmt: skip
        self.add("mean height", "m", lambda side: mean(
            blocks, side["Height"][mask(side)], side.tiles[mask(side)]), of_class=number)  # fmt: skip


def decibels(amplitude):
    """Above 1 nW; NaN for 0 and less."""
    amplitude = amplitude.astype(np.float64)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(amplitude > 0, 10.0 * np.log10(1e9 * amplitude), np.nan)


def _plain(values):
    """Converts to numbers of 64 bits; numpy's own float64() makes a scalar of one value."""
    return values.astype(np.float64)


def describe_shift(shift, rest):
    """Describes the registration in words."""
    known = [(axis, each) for axis, each in zip("xyz", shift) if each]
    texts = ", ".join(
        f"{axis} {each.value:+.4f} m"
        + ("" if np.isnan(each.lower) else f" [{each.lower:+.4f}, {each.upper:+.4f}]")
        for axis, each in known
    )
    open_axes = "".join(axis for axis, each in zip("xyz", shift) if not each)
    left = f"; {' and '.join(open_axes)} not determined by the planes" if open_axes else ""
    tail = f"{texts}; RMS of the rest {rest:.4f} m{left}"
    if any(np.isnan(each.lower) for _, each in known):
        return f"a shift without interval, of too few tiles: {tail}"
    if all(contains_zero(each) for _, each in known):
        return f"no shift found: {tail}"
    return f"B is shifted against A; nothing was moved: {tail}"
