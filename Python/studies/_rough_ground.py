# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rough ground of known statistics: a Gaussian random surface."""

import numpy as np

import vtkhelios


class RoughGround:
    """A Gaussian random surface: heights of variance 1, correlation exp(-(d / length)^2), periodic."""

    def __init__(self, count, cell=0.1, length=1.0, seed=1):
        self.cell, self.length, self.count = cell, length, count
        k = 2 * np.pi * np.fft.fftfreq(count, cell)
        self.k2 = k[:, None] ** 2 + k**2
        noise = np.random.default_rng(seed).standard_normal((count, count))
        self.heights = self._filter(noise, np.exp(-self.k2 * length**2 / 8))
        self.heights -= self.heights.mean()
        self.heights /= self.heights.std()

    def _filter(self, field, response):
        return np.fft.ifft2(np.fft.fft2(field) * response).real

    def make_scene(self, deviation):
        """The surface as triangles, heights times the deviation [m]."""
        n = self.count
        x = (np.arange(n) - n // 2) * self.cell
        points = np.stack([*np.meshgrid(x, x, indexing="ij"), deviation * self.heights], -1)
        i = np.arange(n * n).reshape(n, n)
        a, b, c, d = (v.ravel() for v in (i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]))
        triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
        return vtkhelios.Scene(points.reshape(-1, 3), triangles)

    def variance_within(self, places, radius, cut, deviation):
        """The variance of the heights under vertical beams of radius w, truncated at `cut` w, at x,
        y [m].

        Tilted surfaces return less, so heights are weighted by the cosine of the tilt.
        """
        steps = np.linspace(-cut, cut, 25)
        x, y = (v.ravel() for v in np.meshgrid(steps, steps))
        inside = x**2 + y**2 <= cut**2
        offsets, weights = np.stack([x, y], 1)[inside], np.exp(-2 * (x**2 + y**2)[inside])
        cells = (places[:, None] + radius * offsets) / self.cell + self.count // 2
        heights = _interpolate(self.heights, cells)
        weights = weights * _interpolate(self.cosines(deviation), cells)
        weights /= weights.sum(axis=1, keepdims=True)
        mean = (heights * weights).sum(axis=1)
        return (heights**2 * weights).sum(axis=1) - mean**2

    def expected_within(self, radius, share):
        """Its mean over all positions: x / (1 + x), x = 4 a^2 / length^2.

        a is the standard deviation of the footprint along an axis: a^2 = share radius^2 / 4.
        """
        x = share * radius**2 / self.length**2
        return x / (1 + x)

    def cosines(self, deviation):
        """The cosine of the incidence of vertical beams, of heights times the deviation."""
        slopes = np.gradient(deviation * self.heights, self.cell)
        return 1 / np.sqrt(1 + slopes[0] ** 2 + slopes[1] ** 2)


def _interpolate(grid, places):
    """Bilinear values of a grid at positions in cells (any shape, the last axis is x, y)."""
    low = np.floor(places).astype(int)
    x, y = low[..., 0], low[..., 1]
    fx, fy = (places - low)[..., 0], (places - low)[..., 1]
    return (
        grid[x, y] * (1 - fx) * (1 - fy)
        + grid[x + 1, y] * fx * (1 - fy)
        + grid[x, y + 1] * (1 - fx) * fy
        + grid[x + 1, y + 1] * fx * fy
    )
