# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Georeferencing of recorded pulses: with vtkHelios, and in numpy without it.

Pulses come from a CSD file of Optech, as documented by PDAL's readers.optech: a header with
misalignment and IMU offset angles, then a record per pulse with time, ranges, scan angle, attitude
and position. The angles turn right, forward, up axes by R3(heading) R1(-pitch) R2(-roll).
"""

import pathlib
import struct
import tempfile

import numpy as np

import _study
import vtkhelios

DATA = _study.real_data()
SEMI_MAJOR = 6378137.0  # m, WGS 84
FLATTENING = 1 / 298.257223563
ECCENTRICITY = FLATTENING * (2 - FLATTENING)  # squared

CSD_HEADER = 4 + 64 + 32  # bytes before the format version
CSD_PULSE = np.dtype(
    [
        ("time", "<f8"),
        ("returns", "u1"),
        ("range", "<f4", 4),
        ("intensity", "<u2", 4),
        ("angle", "<f4"),
        ("roll", "<f4"),
        ("pitch", "<f4"),
        ("heading", "<f4"),
        ("latitude", "<f8"),
        ("longitude", "<f8"),
        ("height", "<f4"),
    ]
)


def read_csd(path):
    """The pulses (m, rad, s) and the sums of the misalignment and IMU angles [rad]."""
    data = pathlib.Path(path).read_bytes()
    if data[:4] != b"CSD\0":
        raise ValueError(f"{path} is not a CSD file")
    size = struct.unpack_from("<H", data, CSD_HEADER + 4)[0]
    count = struct.unpack_from("<I", data, CSD_HEADER + 24)[0]
    angles = struct.unpack_from("<6d", data, CSD_HEADER + 30 + 4 * 256)
    raw = np.frombuffer(data, CSD_PULSE, count=count, offset=size)
    pulses = {name: raw[name].astype(float) for name in CSD_PULSE.names}
    pulses["longitude"] = (pulses["longitude"] + np.pi) % (2 * np.pi) - np.pi
    return pulses, np.add(angles[:3], angles[3:])


def turn(roll, pitch, heading):
    """R3(heading) R1(-pitch) R2(-roll), passive rotations of geodesy [rad]: (n, 3, 3)."""
    roll, pitch, heading = np.broadcast_arrays(*map(np.atleast_1d, (roll, pitch, heading)))
    zero, one = np.zeros_like(roll), np.ones_like(roll)

    def stack(*rows):
        return np.stack([np.stack(row, -1) for row in rows], -2)

    c, s = np.cos(heading), np.sin(heading)
    r3 = stack((c, s, zero), (-s, c, zero), (zero, zero, one))
    c, s = np.cos(-pitch), np.sin(-pitch)
    r1 = stack((one, zero, zero), (zero, c, s), (zero, -s, c))
    c, s = np.cos(-roll), np.sin(-roll)
    r2 = stack((c, zero, -s), (zero, one, zero), (s, zero, c))
    return r3 @ r1 @ r2


def to_ecef(latitude, longitude, height):
    """Geocentric coordinates [m] of a position [rad, m] on WGS 84: (n, 3)."""
    normal = SEMI_MAJOR / np.sqrt(1 - ECCENTRICITY * np.sin(latitude) ** 2)
    across = (normal + height) * np.cos(latitude)
    return np.stack(
        [
            across * np.cos(longitude),
            across * np.sin(longitude),
            (normal * (1 - ECCENTRICITY) + height) * np.sin(latitude),
        ],
        -1,
    )


def enu_axes(latitude, longitude):
    """Columns east, north, up in geocentric axes: (n, 3, 3)."""
    latitude, longitude = np.atleast_1d(latitude), np.atleast_1d(longitude)
    sb, cb, sl, cl = np.sin(latitude), np.cos(latitude), np.sin(longitude), np.cos(longitude)
    zero = np.zeros_like(sb)
    east = np.stack([-sl, cl, zero], -1)
    north = np.stack([-sb * cl, -sb * sl, cb], -1)
    up = np.stack([cb * cl, cb * sl, sb], -1)
    return np.stack([east, north, up], -1)


def georeference_in_ecef(pulses, boresight):
    """The first returns in geocentric coordinates [m], by matrices: (n, 3)."""
    angle, distance = pulses["angle"], pulses["range"][:, 0]
    beam = np.stack([np.sin(angle), 0 * angle, -np.cos(angle)], -1) * distance[:, None]
    position = pulses["latitude"], pulses["longitude"]
    attitude = turn(pulses["roll"], pulses["pitch"], pulses["heading"])
    chain = enu_axes(*position) @ attitude @ turn(*boresight)
    return to_ecef(*position, pulses["height"]) + np.einsum("nij,nj->ni", chain, beam)


def to_local(points, origin):
    """East, north, up [m] at an origin (latitude, longitude, height) of geocentric points."""
    return (points - to_ecef(*origin)) @ enu_axes(*origin[:2])[0]


def write_sbet(path, pulses):
    """Writes the poses of pulses as an SBET file; a second before and after they equal the poses at
    the ends."""
    names = "latitude", "longitude", "height"
    records = np.zeros((len(pulses["time"]) + 2, 17))
    records[1:-1, 0] = pulses["time"]
    for column, name in zip((1, 2, 3, 7, 8, 9), (*names, "roll", "pitch", "heading")):
        records[1:-1, column] = pulses[name]
    records[0], records[-1] = records[1], records[-2]
    records[0, 0] -= 1
    records[-1, 0] += 1
    pathlib.Path(path).write_bytes(records.astype("<f8").tobytes())


def _product(a, b):
    """The product of quaternions w, x, y, z."""
    return np.concatenate(
        [[a[0] * b[0] - a[1:] @ b[1:]], a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])]
    )


def _about(axis, angle):
    """The right-handed rotation about an axis (0: x ...) by an angle [rad]."""
    q = np.zeros(4)
    q[0], q[1 + axis] = np.cos(angle / 2), np.sin(angle / 2)
    return q


def mount_of(boresight):
    """The orientation of the scanner on the body: w, x, y, z.

    The mirror deflects from y towards z; that is from -z of the body towards x, for a scan angle to
    the right. Then the boresight turns it, in the order heading, pitch, roll.
    """
    roll, pitch, heading = boresight
    down = _product(_about(2, -np.pi / 2), _about(0, -np.pi / 2))
    turned = _product(_product(_about(2, -heading), _about(0, pitch)), _about(1, roll))
    return _product(turned, down)


def platform_of(pulses, crs):
    """The vtkHeliosInterpolatedPlatform that flies the poses of pulses, and their SBET file's CRS."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "poses.sbet"
        write_sbet(path, pulses)
        reader = vtkhelios.vtkHeliosTrajectoryReader()
        reader.SetFileName(str(path))
        reader.SetTargetCRS(crs)
        flight = vtkhelios.update(reader)
    platform = vtkhelios.vtkHeliosInterpolatedPlatform()
    platform.AddInputData(flight)
    platform.KeepFileTimesOn()
    return platform


def georeference_with_vtkhelios(pulses, boresight, crs):
    """The first returns in a system [m], by platform, mount and mirror: (n, 3).

    The mirror is at either end of its oscillation, pulse 0 at -angle and pulse 1 at +angle: a scan
    per pulse, which fires at the recorded time.
    """
    mirror = vtkhelios.vtkHeliosOscillatingMirror()
    scanner = vtkhelios.vtkHeliosScanner()
    frequency = 1e6
    mirror.SetPulseFrequency(frequency)
    mirror.SetScanFrequency(frequency / 2)
    scanner.SetBeamDeflector(mirror)
    scanner.SetMountOrientation(*mount_of(boresight))
    scanner.GeneratePulsesOn()
    scanner.SetPulseWindow(0, 2)
    far = vtkhelios.Scene([[0, 0, -9e6], [1, 0, -9e6], [0, 1, -9e6]], [[0, 1, 2]])  # not hit
    scanner.SetInputDataObject(0, far.polydata)
    platform = platform_of(pulses, crs)  # a connection alone does not keep it alive
    scanner.SetInputConnection(1, platform.GetOutputPort())
    points = np.empty((len(pulses["time"]), 3))
    for k, (time, angle) in enumerate(zip(pulses["time"], np.degrees(pulses["angle"]))):
        fired = int(angle > 0)
        mirror.SetScanAngle(abs(angle))
        scanner.SetStartTime(time - fired / frequency)
        scanner.Update()
        shots = vtkhelios.arrays(scanner.GetOutputDataObject(2))
        direction = shots["Direction"][fired]
        points[k] = shots["points"][fired] + pulses["range"][k, 0] * direction
    return points
