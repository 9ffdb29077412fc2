# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Misalignments of a panoramic scanner in a scan: true points less reported ones, in both faces."""

import numpy as np
import pytest

import vtkhelios

SIZE = 1e-5  # size of a misalignment, m or rad

# Property, whether it is an angle, and range, azimuth, zenith angle of the NIST model, true less
# reported, with k = 1 in the front face and -1 in the back face, and the zenith angle in 0 ... pi.
PARAMETERS = {
    "horizontal_beam_offset": (False, lambda k, r, v: (0 * v, 1 / r, k * np.cos(v) / r)),
    "vertical_beam_offset": (False, lambda k, r, v: (0 * v, k / (r * np.tan(v)), -np.sin(v) / r)),
    "transit_offset": (False, lambda k, r, v: (k * np.sin(v), 0 * v, k * np.cos(v) / r)),
    "mirror_offset": (False, lambda k, r, v: (0 * v, k / (r * np.sin(v)), 0 * v)),
    "vertical_index_offset": (True, lambda k, r, v: (0 * v, 0 * v, k + 0 * v)),
    "horizontal_beam_tilt": (True, lambda k, r, v: (0 * v, 1 + 0 * v, k * np.cos(v))),
    "vertical_beam_tilt": (True, lambda k, r, v: (0 * v, k / np.tan(v), -np.sin(v))),
    "mirror_tilt": (True, lambda k, r, v: (0 * v, 2 * k / np.sin(v), 0 * v)),
    "transit_tilt": (True, lambda k, r, v: (0 * v, -k / np.tan(v), 0 * v)),
    "range_offset": (False, lambda k, r, v: (1 + 0 * v, 0 * v, 0 * v)),
}
BOX = [[x, y, z] for z in (-8.0, 8.0) for y in (-8.0, 8.0) for x in (-8.0, 8.0)]
FACES = [[0, 1, 3], [0, 3, 2], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4]]
FACES += [[2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 3, 7], [1, 7, 5]]


def scan_a_room(head=20.0, **parameters):
    """A vertical circle of pulses, at a head angle [deg, anticlockwise]: echoes with their truth."""
    mirror = vtkhelios.vtkHeliosRotatingMirror()
    mirror.SetPulseFrequency(3600)
    mirror.SetScanFrequency(10)
    scanner = vtkhelios.vtkHeliosScanner()
    scanner.SetBeamDeflector(mirror)
    scanner.GetBeamSampler().SetBeamDivergence(0)
    scanner.SetErrorModel(vtkhelios.vtkHeliosPanoramicErrorModel(**parameters))
    scanner.SetHeadRotateStart(head)
    scanner.SetDuration(0.1)
    scanner.GenerateTruthOn()
    room = vtkhelios.Scene(BOX, FACES)
    scanner.SetInputDataObject(0, room.polydata)
    stand = vtkhelios.Cloud.from_arrays(
        np.zeros((1, 3)), GpsTime=np.zeros(1), Orientation=np.array([[1.0, 0, 0, 0]])
    )
    scanner.SetInputDataObject(1, stand.polydata)
    return vtkhelios.arrays(vtkhelios.update(scanner))


def to_polar(points):
    """Range, azimuth (clockwise from y), zenith angle."""
    across = np.hypot(points[:, 0], points[:, 1])
    return (
        np.linalg.norm(points, axis=1),
        np.arctan2(points[:, 0], points[:, 1]),
        np.arctan2(across, points[:, 2]),
    )


def errors_of(echoes):
    """True less reported, by row, and the reported range and zenith angle; away from the poles."""
    reported, true = to_polar(echoes["points"]), to_polar(echoes["TruePoint"])
    apart = np.abs(np.sin(reported[2])) > 0.2
    found = [a - b for a, b in zip(true, reported)]
    found[1] = np.remainder(found[1] + np.pi, 2 * np.pi) - np.pi
    return [each[apart] for each in found], [each[apart] for each in reported]


@pytest.mark.parametrize("name", PARAMETERS)
def test_each_parameter_in_both_faces(name):
    is_angle, model = PARAMETERS[name]
    echoes = scan_a_room(**{name: np.degrees(SIZE) if is_angle else SIZE})
    found, (distance, _, zenith) = errors_of(echoes)
    # a mirror beyond the zenith looks back
    apart = np.abs(np.cos(np.radians(echoes["ScanAngle"]))) > 0.2
    k = np.where(np.cos(np.radians(echoes["ScanAngle"][apart])) > 0, 1.0, -1.0)
    assert 100 < np.sum(k > 0) < len(k) - 100
    for ours, theirs in zip(found, model(k, distance, zenith)):
        assert np.abs(ours - SIZE * theirs).max() < 1e-8  # squares of the parameters


def test_two_faces_differ_by_terms_that_change_sign():
    """The same target in the back face, with the head turned round: mirror tilt, twice its term."""
    tilt = np.degrees(SIZE)
    front = scan_a_room(20.0, mirror_tilt=tilt)
    back = scan_a_room(200.0, mirror_tilt=tilt)
    found, (_, _, zenith) = errors_of(front)
    other, (_, _, other_zenith) = errors_of(back)
    order, other_order = np.argsort(zenith), np.argsort(other_zenith)
    assert np.allclose(zenith[order], other_zenith[other_order], atol=1e-9)
    in_front = np.flatnonzero(found[1] > 0)
    in_back = np.flatnonzero(other[1] < 0)
    assert len(in_front) == len(in_back) > 100
    differences = np.sort(found[1][in_front]) - np.sort(other[1][in_back])[::-1]
    assert differences == pytest.approx(np.sort(4 * SIZE / np.sin(zenith[in_front])), abs=1e-8)


def test_no_parameter_no_error():
    echoes = scan_a_room()
    assert np.allclose(echoes["points"], echoes["TruePoint"], atol=1e-12)


def test_in_a_survey(make_survey):
    """<panoramicError> of a scanner: a range offset moves points towards the scanner."""
    survey = vtkhelios.read_survey(make_survey(stop=2))
    clean = survey.run(noise=False)
    assert survey.vtk.SetScannerAttribute(0, "panoramicError/rangeOffset_m", "0.5")
    moved = survey.run(noise=False)
    assert clean["Range"] - moved["Range"] == pytest.approx(0.5, abs=1e-6)
