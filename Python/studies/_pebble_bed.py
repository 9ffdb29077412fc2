# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bed of pebbles: ellipsoids half buried in a plane, as triangles and as exact surfaces."""

import numpy as np

import vtkhelios


def make_sphere(level):
    """The vertices and triangles of an icosahedron subdivided `level` times by 4."""
    g = (1 + 5**0.5) / 2
    corners = [(0, s, t * g) for s in (-1, 1) for t in (-1, 1)]
    points = np.array([np.roll(c, k) for k in range(3) for c in corners], float)
    points /= np.linalg.norm(points[0])
    near = np.linalg.norm(points[:, None] - points, axis=2)
    edge = np.unique(near.round(6))[1]
    linked = np.isclose(near, edge, atol=1e-5)
    triangles = [
        (a, b, c)
        for a, b, c in np.argwhere(linked[:, :, None] & linked[:, None] & linked[None])
        if a < b < c
    ]
    for _ in range(level):
        points, triangles = _split(points, np.array(triangles))
    return points, np.array(triangles)


def _split(points, triangles):
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    unique, index = np.unique(edges, axis=0, return_inverse=True)
    middles = points[unique].sum(axis=1)
    middles /= np.linalg.norm(middles, axis=1)[:, None]
    ab, bc, ca = (len(points) + index.reshape(-1, 3)).T
    a, b, c = triangles.T
    parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.concatenate([points, middles]), np.concatenate([np.stack(p, 1) for p in parts])


class PebbleBed:
    """Pebbles of 1 to 10 cm in a square of `size` [m], on the plane z = 0; the same for the same seed.

    Pebble k is the image of the unit sphere under x -> centres[k] + shapes[k] x. The plane is
    number `len(bed)`.
    """

    def __init__(self, size=0.8, seed=1, tries=12000):
        random = np.random.default_rng(seed)
        radii = np.sort(np.clip(0.017 * np.exp(0.35 * random.standard_normal(tries)), 0.01, 0.04))
        places, kept = np.empty((0, 2)), []
        for k, place in zip(range(tries)[::-1], random.uniform(-size / 2, size / 2, (tries, 2))):
            reach = 0.85 * (radii[k] + radii[kept])  # neighbours touch or overlap slightly
            if (np.linalg.norm(places - place, axis=1) > reach).all():
                places, kept = np.vstack([places, place]), [*kept, k]
        r = radii[kept]
        axes = r[:, None] * random.uniform((0.95, 0.75, 0.5), (1.2, 1.0, 0.75), (len(r), 3))
        self.centres = np.column_stack([places, 0.3 * axes[:, 2]])
        self.shapes = _turns(random, len(r)) * axes[:, None]
        self.inverses = np.linalg.inv(self.shapes)
        self.reach = axes.max(axis=1)  # bounding radius of a pebble
        self.size = size

    def __len__(self):
        return len(self.centres)

    def make_scene(self, level=3):
        """Triangles: 20 * 4^level per pebble, in pebble order, then two for the plane."""
        sphere, faces = make_sphere(level)
        points = self.centres[:, None] + sphere @ self.shapes.transpose(0, 2, 1)
        first = np.arange(len(self))[:, None, None] * len(sphere)
        s = 2 * self.size
        ground = len(self) * len(sphere) + np.array([(0, 1, 2), (0, 2, 3)])
        return vtkhelios.Scene(
            np.concatenate(
                [points.reshape(-1, 3), [(-s, -s, 0), (s, -s, 0), (s, s, 0), (-s, s, 0)]]
            ),
            np.concatenate([(first + faces).reshape(-1, 3), ground]),
        )

    def owners(self, cells, level=3):
        """The pebbles (or the plane) of triangles of make_scene()."""
        return np.minimum(cells // (20 * 4**level), len(self))

    def cast(self, origins, directions, block=512):
        """First hits of rays on the exact surface: range [m], pebble, cosine of the incidence.

        Consecutive rays should be close to each other: a block tests only the pebbles near its mean
        ray.
        """
        origins = np.broadcast_to(origins, directions.shape)
        with np.errstate(divide="ignore"):
            ranges = np.where(directions[:, 2] < 0, -origins[:, 2] / directions[:, 2], np.inf)
        owners, cosines = np.full(len(ranges), len(self)), -directions[:, 2]
        for begin in range(0, len(ranges), block):
            part = slice(begin, begin + block)
            for k in self._near(origins[part], directions[part]):
                self._cast_one(
                    k, *(v[part] for v in (origins, directions, ranges, owners, cosines))
                )
        return ranges, owners, cosines

    def _near(self, origins, directions):
        """The pebbles that any of these rays may hit."""
        origin, direction = origins.mean(axis=0), directions.mean(axis=0)
        towards = self.centres - origin
        along = towards @ direction / (direction @ direction)
        beside = np.linalg.norm(towards - along[:, None] * direction, axis=1)
        margin = np.linalg.norm(origins - origin, axis=1).max()
        margin = margin + np.abs(along) * np.linalg.norm(directions - direction, axis=1).max()
        return np.flatnonzero(beside < 1.1 * (self.reach + margin))

    def _cast_one(self, k, origins, directions, ranges, owners, cosines):
        """Shortens the ranges of rays that hit pebble k first."""
        towards, inverse = self.centres[k] - origins, self.inverses[k]
        along = np.einsum("ij,ij->i", towards, directions)
        near = np.einsum("ij,ij->i", towards, towards) - along**2 < self.reach[k] ** 2
        rays = np.flatnonzero(near)
        p, d = -towards[rays] @ inverse.T, directions[rays] @ inverse.T
        a, b = (d * d).sum(1), (p * d).sum(1)
        root = b * b - a * ((p * p).sum(1) - 1)
        rays, p, d, a, b, root = (v[root > 0] for v in (rays, p, d, a, b, root))
        hit = (-b - np.sqrt(root)) / a
        first = (hit > 0) & (hit < ranges[rays])
        rays, normals = rays[first], (p + hit[:, None] * d)[first] @ inverse
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        ranges[rays], owners[rays] = hit[first], k
        cosines[rays] = -np.einsum("ij,ij->i", normals, directions[rays])

    def heights(self, x, y):
        """The heights of the exact surface above positions [m]."""
        tops = np.column_stack([x, y, np.full(len(x), 1.0)])
        return 1.0 - self.cast(tops, np.tile([0.0, 0.0, -1.0], (len(x), 1)))[0]


def _turns(random, count):
    """Rotations: any azimuth, tilted by up to about 20 degrees."""
    azimuth = random.uniform(0, 2 * np.pi, count)
    tilt = np.radians(random.uniform(-20, 20, count))
    c, s, zero, one = np.cos(azimuth), np.sin(azimuth), np.zeros(count), np.ones(count)
    about_z = np.array([(c, -s, zero), (s, c, zero), (zero, zero, one)])
    c, s = np.cos(tilt), np.sin(tilt)
    about_x = np.array([(one, zero, zero), (zero, c, -s), (zero, s, c)])
    return np.einsum("ijn,jkn->nik", about_z, about_x)
