# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many scans by one sensor: the echoes of single scans, and errors that name scan, scene and pose."""

import numpy as np
import pytest

import vtkhelios
from vtkhelios import PipelineError, Scene

SENSOR = "velodyne_vlp16"
SHORT = {
    "arrays": ["Range", "Amplitude", "PulseIds"],
    "scan_frequency": 20,
    "duration": 0.01,
    "noise": False,
    "sub_rays": 1,
}


def make_scene(height):
    """A square floor of 200 m at a height."""
    corners = [(-100, -100, height), (100, -100, height), (100, 100, height), (-100, 100, height)]
    return Scene(np.array(corners, float), np.array([[0, 1, 2], [0, 2, 3]]))


@pytest.fixture(scope="module")
def sensor():
    return vtkhelios.Sensor(SENSOR, **SHORT)


def test_scans_of_many_scenes_are_on_their_floors(sensor):
    heights = np.linspace(-3, -1, 40)
    scans = vtkhelios.scan_many([make_scene(h) for h in heights], np.zeros((40, 3)), sensor)
    assert len(scans) == 40 and scans.offsets[0] == 0 and scans.offsets[-1] == len(scans.points)
    for height, scan in zip(heights, scans):
        assert len(scan["points"]) > 500
        assert np.abs(scan["points"][:, 2] - height).max() < 1e-6
        assert np.linalg.norm(scan["points"], axis=1) == pytest.approx(scan["Range"], abs=0.05)
    assert not scans["Range"].flags.owndata  # no copy of the array of C++


def test_a_scan_of_a_batch_is_that_of_a_survey(sensor):
    """The same pulses from the same place."""
    scene = make_scene(0.0)
    survey = vtkhelios.make_survey(
        scene, [(3, 4, 2)], SENSOR, scan_frequency=20, duration=0.01, platform="tripod"
    )
    expected = survey.run(noise=False, sub_rays=1)  # the tripod is 1.5 m high
    scans = sensor.scan(scene, (3, 4, 3.5))
    assert scans.points == pytest.approx(expected.points, abs=1e-6)
    assert scans["Range"] == pytest.approx(expected["Range"], abs=1e-6)
    assert np.array_equal(scans["PulseIds"], expected["PulseIds"])
    assert scans.pulses == survey.number_of_pulses


def test_echoes_do_not_depend_on_the_division_among_threads():
    """Alone, in a batch of few, and of many; noise is that of the number of the scan."""
    scene = make_scene(-2.0)
    sensor = vtkhelios.Sensor(SENSOR, scan_frequency=20, duration=0.005)
    poses = np.column_stack([np.linspace(0, 5, 64), np.zeros(64), np.zeros(64)])
    many, few = sensor.scan(scene, poses), sensor.scan(scene, poses[:2])
    for number in (0, 1):
        for name, values in few[number].items():
            assert np.array_equal(values, many[number][name]), name
    assert many["PulseIds"].max() < 64 * many.pulses
    ranges = [scan["Range"][:100] for scan in sensor.scan(scene, np.zeros((2, 3)))]
    assert not np.array_equal(*ranges)  # other noise


def test_poses_turn_the_scanner(sensor):
    """A quarter turn about z, as a quaternion and as a matrix; the scene is asymmetric."""
    scene = make_scene(-2.0)
    half = np.sqrt(0.5)
    turned = sensor.scan(scene, [0, 0, 0, half, 0, 0, half])
    matrix = np.array([[0.0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    straight = sensor.scan(scene, (0, 0, 0))
    assert turned.points == pytest.approx(straight.points @ matrix[:3, :3].T, abs=1e-9)
    assert sensor.scan(scene, matrix).points == pytest.approx(turned.points, abs=1e-9)


def test_scenes_of_poses(sensor):
    scenes = [make_scene(-1.0), make_scene(-2.0)]
    scans = sensor.scan(scenes, np.zeros((3, 3)), scene_ids=[1, 0, 1])
    assert [round(scan["points"][0, 2]) for scan in scans] == [-2, -1, -2]


def test_steps_in_a_scene_that_changes(sensor):
    """Its tree is kept until the scene is another, or modified."""
    scene = make_scene(-1.0)
    assert sensor.scan(scene, (0, 0, 0)).points[0, 2] == pytest.approx(-1)
    assert sensor.scan(scene, (0, 0, 1)).points[0, 2] == pytest.approx(-1)
    points = scene.polydata.GetPoints()
    for index in range(points.GetNumberOfPoints()):
        x, y, _ = points.GetPoint(index)
        points.SetPoint(index, x, y, -3.0)
    points.Modified()
    scene.polydata.Modified()
    assert sensor.scan(scene, (0, 0, 0)).points[0, 2] == pytest.approx(-3)


def test_arrays_that_are_wanted():
    scene = make_scene(-1.0)
    few = vtkhelios.Sensor(SENSOR, **{**SHORT, "arrays": ["Range"]}).scan(scene, (0, 0, 0))
    assert set(few.arrays) == {"points", "Range"}
    every = vtkhelios.Sensor(SENSOR, **{**SHORT, "arrays": None}).scan(scene, (0, 0, 0))
    assert {"Range", "GpsTime", "ChannelIds", "ScanAngle"} <= set(every.arrays)
    with pytest.raises(PipelineError, match=r"scan 0 \(scene 0, pose .*no array Colour"):
        vtkhelios.Sensor(SENSOR, **{**SHORT, "arrays": ["Colour"]}).scan(scene, (0, 0, 0))


def test_scans_without_echoes(sensor):
    scans = sensor.scan(make_scene(500.0), np.zeros((3, 3)))
    assert scans.offsets.tolist() == [0, 0, 0, 0] and len(scans) == 3
    assert scans[2]["points"].shape == (0, 3)


def test_errors_name_scan_scene_and_pose(sensor):
    scenes = [make_scene(-1.0), make_scene(-2.0)]
    poses = np.zeros((2, 3))
    poses[1] = (4, np.nan, 0)
    with pytest.raises(
        PipelineError,
        match=r"scan 1 \(scene 1, pose 4 nan 0, 1 0 0 0\): its position is not finite",
    ):
        sensor.scan(scenes, poses)
    with pytest.raises(
        PipelineError, match="scan 0 .*2 0 0 0.*is not a unit quaternion w, x, y, z"
    ):
        sensor.scan(scenes[0], [0, 0, 0, 2, 0, 0, 0])
    with pytest.raises(PipelineError, match=r"scan 1 \(scene 2, .*there are only 2 scenes"):
        sensor.scan(scenes, np.zeros((2, 3)), scene_ids=[0, 2])
    with pytest.raises(PipelineError, match="there are 3 poses for 2 scenes; give one each"):
        sensor.scan(scenes, np.zeros((3, 3)))


def test_errors_of_arguments(sensor):
    scene = make_scene(-1.0)
    with pytest.raises(ValueError, match=r"poses has the shape \(2, 5\); give n x 3"):
        sensor.scan(scene, np.zeros((2, 5)))
    with pytest.raises(ValueError, match="pose 0: its matrix .* is no rotation"):
        sensor.scan(scene, np.diag([1.0, 1, -1, 1]))
    with pytest.raises(ValueError, match=r"scene_ids has the shape \(3,\); give one for each of 2"):
        sensor.scan(scene, np.zeros((2, 3)), scene_ids=[0, 0, 0])
    with pytest.raises(ValueError, match="scenes is empty"):
        sensor.scan([], np.zeros((2, 3)))
    with pytest.raises(TypeError, match="scene 1: scene is of int"):
        sensor.scan([scene, 5], np.zeros((2, 3)))
    with pytest.raises(TypeError, match="sensor is of str; give a vtkhelios.Sensor"):
        vtkhelios.scan_many(scene, np.zeros((2, 3)), SENSOR)
    with pytest.raises(TypeError, match="colour is neither a setting of a leg"):
        vtkhelios.Sensor(SENSOR, colour=1)
    with pytest.raises(PipelineError, match="its scanner has several channels"):
        vtkhelios.Sensor("livox_avia", duration=0.01).scan(scene, (0, 0, 0))
