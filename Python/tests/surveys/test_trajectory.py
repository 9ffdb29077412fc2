# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scans along trajectories in memory, and surveys made with all elements of the dialect."""

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkStringArray

import vtkhelios
from vtkhelios import Cloud

FLAT = ([[-200, -200, 0], [200, -200, 0], [200, 200, 0], [-200, 200, 0]], [[0, 1, 2], [0, 2, 3]])
DOWN = dict(scanner="copter_uls", scan_frequency=50, pulse_frequency=100_000, scan_angle=30)


def _flight(height=40.0, speed=20.0, heading=0.0):
    """Two seconds along x, five rows; the body is level."""
    times = np.linspace(100, 102, 5)
    points = np.stack([speed * (times - 101), 0 * times, height + 0 * times], axis=1)
    half = np.radians(heading) / 2
    quaternions = np.tile([np.cos(half), 0, 0, np.sin(half)], (5, 1))
    return Cloud.from_arrays(points, GpsTime=times, Orientation=quaternions)


def _scan(trajectory, **more):
    return vtkhelios.scan(
        vtkhelios.Scene(*FLAT), trajectory=trajectory, noise=False, **{**DOWN, **more}
    )


def test_scan_along_a_trajectory():
    cloud = _scan(_flight())
    assert cloud["GpsTime"].min() >= 0 and np.ptp(cloud["GpsTime"]) == pytest.approx(2, abs=0.01)
    assert np.abs(cloud.points[cloud["IncidenceAngle"] < 60, 2]).max() < 2e-3
    # the nearest echoes are below: at the height of the flight less the height of the mount
    nearest = cloud["Range"].min()
    assert 39 < nearest < 41
    assert _scan(_flight(height=80))["Range"].min() == pytest.approx(nearest + 40, abs=0.01)


def test_the_attitude_turns_the_lines():
    """The swath is across the body: with the heading it turns from x to y."""
    north = np.ptp(_scan(_flight(speed=0.01)).points, axis=0)
    west = np.ptp(_scan(_flight(speed=0.01, heading=90)).points, axis=0)
    assert max(north[:2]) > 5 * min(north[:2])
    assert north[:2] == pytest.approx(west[1::-1], abs=0.1)


def test_times_of_a_leg():
    half = _scan(_flight(), tStart=100.5, tEnd=101.5, syncGPSTime=True)
    assert half["GpsTime"].min() == pytest.approx(100.5, abs=0.01)
    assert half["GpsTime"].max() == pytest.approx(101.5, abs=0.01)
    assert np.abs(half.points[:, 0]).max() < 10.1 + 40 * np.tan(np.radians(30)) + 1
    legs = [dict(tEnd=100.5), dict(tStart=101.5, teleportToStart=True)]
    survey = vtkhelios.make_survey(vtkhelios.Scene(*FLAT), legs, trajectory=_flight(), **DOWN)
    assert survey.number_of_pulses == 100_000
    assert np.allclose(survey.trajectory(1, 0).points[:, 0], [10, 20])


def test_a_file_gives_the_same_bits(tmp_path):
    rows = [(100, 1, 2, 80, -20, 0, 40), (101, 3, -2, 95, 0, 3, 41), (102, 0, 0, 90, 20, 0, 40)]
    path = tmp_path / "flight.txt"
    path.write_text("\n".join(",".join(map(str, row)) for row in rows))
    reader = vtkhelios.vtkHeliosTrajectoryReader(file_name=str(path))
    of_file, of_reader = _scan(path), _scan(reader)
    of_data = _scan(vtkhelios.update(reader))
    assert len(of_file) > 30_000
    for cloud in (of_reader, of_data):
        assert cloud.names == of_file.names
        assert all(np.array_equal(cloud[name], of_file[name]) for name in ["points", *cloud.names])


def test_a_flown_trajectory_is_flown_again():
    way = [(-20, 0, 40), (20, 0, 40)]
    scene = vtkhelios.Scene(*FLAT)
    first = vtkhelios.make_survey(scene, way, platform="copter_linearpath", speed=20, **DOWN)
    again = _scan(first.trajectory(0, interval=0.5))
    assert np.allclose(again.points, first.run(noise=False).points, atol=1e-6)


def test_changes_are_followed():
    flight = _flight()
    survey = vtkhelios.make_survey(vtkhelios.Scene(*FLAT), trajectory=flight, **DOWN)
    low = survey.run(noise=False)["Range"].min()
    flight.points[:, 2] += 25
    flight.data.Modified()
    assert survey.run(noise=False)["Range"].min() == pytest.approx(low + 25, abs=0.01)
    flight["GpsTime"][:] = 100 + 2 * (flight["GpsTime"] - 100)
    flight.data.Modified()
    assert survey.number_of_pulses == 400_000


SURVEY = """<document><survey name="flown" scene="scene.xml#plane" scanner="scanners.xml#copter_uls"
platform="interpolated" basePlatform="platforms.xml#copter_linearpath">
<leg><platformSettings trajectory="flight.txt"/>
<scannerSettings scanFreq_hz="50" scanAngle_deg="30" pulseFreq_hz="100000"/></leg></survey></document>
"""


def test_the_trajectory_of_a_survey_file_is_replaced(tmp_path, make_survey):
    with pytest.raises(vtkhelios.PipelineError, match="no platform of survey plane follows"):
        vtkhelios.read_survey(make_survey(), trajectory=_flight()).run()
    (tmp_path / "flight.txt").write_text("0,0,0,90,0,0,70\n1,0,0,90,20,0,70\n")
    path = tmp_path / "flown.xml"
    path.write_text(SURVEY)
    of_file = vtkhelios.read_survey(path).run(noise=False)
    assert of_file["Range"].min() == pytest.approx(70, abs=1)
    survey = vtkhelios.read_survey(path, scene=vtkhelios.Scene(*FLAT), trajectory=_flight())
    replaced = survey.run(noise=False)
    assert replaced["Range"].min() == pytest.approx(40, abs=1)
    assert np.array_equal(replaced.points, _scan(_flight()).points)
    report = survey.run_to(tmp_path / "out", noise=False)
    assert report["totals"]["points"] == len(replaced) and len(report["trajectory"]) == 64


@pytest.mark.parametrize(
    "change, message",
    [
        (lambda flight: flight["GpsTime"].__setitem__(3, 5), "row 3: GpsTime is 5, before that of"),
        (
            lambda flight: flight.points.__setitem__((2, 1), np.nan),
            r"row 2: Points is \(0, nan, 40\)",
        ),
        (
            lambda flight: flight["Orientation"].__setitem__((1, 0), 3),
            "row 1: Orientation is .3, 0, 0, 0., which is not a unit quaternion",
        ),
        (
            lambda flight: flight.data.GetPointData().RemoveArray("GpsTime"),
            "has no point array GpsTime; add one, the time .s.",
        ),
    ],
)
def test_wrong_trajectories(change, message):
    flight = _flight()
    change(flight)
    with pytest.raises(vtkhelios.PipelineError, match="input trajectory 0.*" + message):
        _scan(flight)


@pytest.mark.parametrize(
    "call, error, message",
    [
        (lambda: _scan(42), TypeError, "trajectory is of int; give a file name, a Cloud"),
        (lambda: _scan("none.txt"), vtkhelios.PipelineError, 'trajectory="none.txt": no such file'),
        (lambda: _scan(_flight(), position=(0, 0)), TypeError, "needs a position"),
        (lambda: vtkhelios.make_survey(vtkhelios.Scene(*FLAT)), TypeError, "needs legs, or a traj"),
        (
            lambda: vtkhelios.make_survey(vtkhelios.Scene(*FLAT), [(0, 0)], trajectory=_flight()),
            TypeError,
            "a leg has a position, but the trajectory gives it",
        ),
    ],
)
def test_wrong_arguments(call, error, message):
    with pytest.raises(error, match=message):
        call()


def test_elements_of_a_survey_without_files(tmp_path):
    """A part that moves and is swapped, put together by the paths of its attributes."""
    obj = tmp_path / "plane.obj"
    obj.write_text("v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nf 1 2 3 4\n")
    survey = vtkhelios.make_survey(
        None, [(0, 0, 10)], scan_frequency=100, vertical=(-40, 60), head=(0, 30), head_speed=60
    )
    assert survey.vtk.AddPart("objloader", str(obj)) == 0
    for name, value in {
        "dynTimeStep": "0.25",
        "dmotion/loop": "1",
        "dmotion/motion/type": "translation",
        "dmotion/motion/vec": "0;0;-5",
        "swap/translate/offset": "0;0;3",
    }.items():
        assert survey.vtk.SetPartAttribute(0, name, value)
        assert survey.vtk.GetPartAttribute(0, name) == value
    assert survey.vtk.SetPlatformAttribute(0, "scannerMount/rot/axis", "z")
    assert survey.vtk.SetPlatformAttribute(0, "scannerMount/rot/angle_deg", "180")
    cloud = survey.run(noise=False)
    steep, early = cloud["IncidenceAngle"] < 70, cloud["GpsTime"] < 0.25
    assert np.allclose(cloud.points[steep & early, 2], 0, atol=2e-3)
    assert np.allclose(cloud.points[steep & ~early, 2], -5, atol=2e-3)
    swapped = survey.run(noise=False, epoch=1)
    steep, early = swapped["IncidenceAngle"] < 70, swapped["GpsTime"] < 0.25
    assert np.allclose(swapped.points[steep & early, 2], 3, atol=2e-3)


def test_an_sbet_file_is_flown_in_the_system_of_the_scene(tmp_path):
    """A local system about a place: the same points as the trajectory in memory."""
    system = "ENU 49 9 250"
    scene = vtkhelios.Scene(*FLAT)
    label = vtkStringArray()
    label.SetName("CRS")
    label.InsertNextValue(system)
    scene.polydata.GetFieldData().AddArray(label)
    flight = _flight(heading=30)
    writer = vtkhelios.vtkHeliosSBETWriter()
    writer.SetFileName(str(tmp_path / "flight.sbet"))
    writer.SetCRS(system)
    assert writer.Open() and writer.Write(flight.polydata) and writer.Close()
    assert (tmp_path / "flight.sbet").stat().st_size == 5 * 136
    options = dict(noise=False, syncGPSTime=True, **DOWN)
    of_file = vtkhelios.scan(scene, trajectory=tmp_path / "flight.sbet", **options)
    of_memory = vtkhelios.scan(scene, trajectory=flight, **options)
    assert len(of_file) == len(of_memory) > 30_000
    assert np.allclose(of_file.points, of_memory.points, atol=1e-6)


def test_navigation_errors_keep_the_truth():
    """Points are reported below the ground by the error of the lever arm; TruePoint is on it."""
    survey = vtkhelios.make_survey(vtkhelios.Scene(*FLAT), [dict()], trajectory=_flight(), **DOWN)
    assert survey.vtk.SetPlatformAttribute(0, "navigationError/leverArmZ_m", "0.5")
    cloud = survey.run(truth=True)
    near = cloud["IncidenceAngle"] < 40
    assert np.abs(np.mean(cloud.points[near, 2]) + 0.5) < 0.01  # ranges have noise
    assert np.abs(cloud["TruePoint"][near, 2]).max() < 2e-3
