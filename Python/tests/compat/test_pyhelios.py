# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts for pyhelios run: as its documented examples use it, in the names of versions 1 and 2."""

import math
import pathlib
import re
import threading

import numpy as np
import pytest

import vtkhelios
from vtkhelios.compat import pyhelios
from vtkhelios.compat.pyhelios import _logging, _simulation
from vtkhelios.compat.pyhelios._coordinates import find_angles, find_rotations

ROOT = pathlib.Path(__file__).resolve().parents[3]
HELIOS = ROOT.parent / "shared/data/helios"  # other people's examples, where they are
SCANNER = 3.7  # its height: 2 m, the tripod 1.5 m, the beam 0.2 m


@pytest.fixture(autouse=True)
def fresh(monkeypatch):
    """Seed and logging of each test."""
    monkeypatch.setattr(_simulation, "_seed", "")
    monkeypatch.setattr(_logging, "_level", _logging.WARNINGS)
    monkeypatch.setattr(_simulation, "BLOCK", 5000)


@pytest.fixture
def builder(make_survey, tmp_path):
    """A builder of a small survey that writes no files."""
    made = pyhelios.SimulationBuilder(str(make_survey()), "assets/", str(tmp_path / "output"))
    made.setExportToFile(False)
    return made


def run(builder):
    simulation = builder.build()
    simulation.start()
    return simulation.join()


# Scripts as in the examples.


def test_script_with_a_callback_as_in_version_1(make_survey, tmp_path, capsys):
    counted, first = [], []

    def callback(output=None):
        with pyhelios.PYHELIOS_SIMULATION_BUILD_CONDITION_VARIABLE:
            measurements = output.measurements
            counted.append(len(measurements))
            if not first and measurements.length() > 0:
                first.append(measurements[0].getPosition())
            assert not output.finished
            pyhelios.PYHELIOS_SIMULATION_BUILD_CONDITION_VARIABLE.notify()

    pyhelios.loggingVerbose()
    pyhelios.setDefaultRandomnessGeneratorSeed("123")
    builder = pyhelios.SimulationBuilder(str(make_survey()), ["assets/"], str(tmp_path / "output"))
    builder.setNumThreads(0)
    builder.setLasOutput(False)
    builder.setZipOutput(False)
    builder.setCallbackFrequency(10)
    builder.setFinalOutput(True)
    builder.setLegNoiseDisabled(True)
    builder.setRebuildScene(True)
    builder.setWriteWaveform(True)
    builder.setCalcEchowidth(True)
    builder.setFullwaveNoise(False)
    builder.setPlatformNoiseDisabled(True)
    builder.setKDTFactory(4)
    builder.setKDTJobs(1)
    builder.setCallback(callback)
    simulation = builder.build()
    simulation.start()
    simulation.pause()
    assert simulation.isPaused() and not simulation.isRunning()
    simulation.resume()
    output = simulation.join()
    assert simulation.isStarted() and simulation.isFinished()

    measurements, trajectories = pyhelios.outputToNumpy(output)
    assert sum(counted) == len(output.measurements) == len(measurements)
    pulses = vtkhelios.read_survey(builder.surveyPath).number_of_pulses
    assert len(counted) == math.ceil(pulses / 5000)
    assert measurements.shape[1:] == (17,) and trajectories.shape[1:] == (7,)
    assert tuple(first[0]) == pytest.approx(tuple(measurements[0, :3]))
    spherical = pyhelios.cartesianToSpherical(measurements[:, 0:3])
    assert pyhelios.sphericalToCartesian(spherical) == pytest.approx(measurements[:, :3], abs=1e-9)

    folder = pathlib.Path(output.filepath).parent
    assert folder.parent == tmp_path / "output/plane"
    assert re.fullmatch(r"\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d", folder.name)
    assert [path.name for path in sorted(folder.glob("leg*"))] == [
        "leg000_fullwave.txt",
        "leg000_points.xyz",
        "leg000_trajectory.txt",
    ]
    assert [path.name for path in folder.parent.iterdir()] == [folder.name]
    written = np.loadtxt(output.outpaths[0])
    columns = (0, 1, 2, 9, 10, 11, 12, 13, 14, 15, 16)
    assert measurements[:, columns] == pytest.approx(written, abs=6e-5)
    assert "files: " in capsys.readouterr().out


def test_script_in_the_names_of_version_2(make_survey, tmp_path):
    pyhelios.logging_silent()
    pyhelios.default_rand_generator_seed("7")
    simulation = pyhelios.Simulation(str(make_survey()), ["assets/"], str(tmp_path), 1, True)
    simulation.final_output = False
    simulation.export_to_file = True
    simulation.callback_frequency = 0
    simulation.load_survey(False, False, False, True)
    leg = simulation.get_leg(0)
    leg.scanner_settings.rotation_stop_angle = math.radians(10.0)
    leg.platform_settings.set_position(1.0, 2.0, 3.0)
    assert leg.platform_settings.position == (1.0, 2.0, 3.0)
    assert simulation.num_legs == 1 and simulation.survey.name == "plane"
    simulation.start()
    measurements, trajectories, path, paths, finished = simulation.join()
    assert finished and len(measurements) == len(trajectories) == 0
    assert paths == [path] and path.endswith("leg000_points.las")
    x, y, z = vtkhelios.read_survey(simulation.survey_path).legs[0].position
    assert (x, y, z) == (0.0, 0.0, 2.0)  # the file is unchanged


def test_strips_are_built_leg_by_leg(make_survey, tmp_path):
    text = pathlib.Path(make_survey()).read_text()
    text = text.replace("platforms.xml#tripod", "platforms.xml#airplane_linearpath")
    text = text.replace("vz400_class_tls", "rotating_als")
    path = tmp_path / "strips.xml"
    path.write_text(re.sub(r"<leg>.*</leg>", "<leg/><leg/>", text, flags=re.S))
    builder = pyhelios.SimulationBuilder(path, [], tmp_path)
    builder.setExportToFile(False)
    build = builder.build()
    simulation, shift = build.sim, build.sim.getScene().getShift()
    waypoints = [(-50.0, 0.0), (50.0, 0.0), (50.0, 40.0), (-50.0, 40.0)]
    for number, (x, y) in enumerate(waypoints):
        leg = simulation.newLeg(number) if number > 1 else simulation.getLeg(number)
        leg.getPlatformSettings().x = x - shift.x
        leg.getPlatformSettings().y = y - shift.y
        leg.getPlatformSettings().z = 300.0 - shift.z
        leg.getPlatformSettings().movePerSec = 100.0
        leg.getScannerSettings().pulseFreq = 150_000
        leg.getScannerSettings().scanAngle = math.radians(20.0)
        leg.getScannerSettings().scanFreq = 50.0
        leg.getScannerSettings().trajectoryTimeInterval = 0.1
        leg.getScannerSettings().active = number % 2 == 0
    survey = simulation.getSurvey()
    assert survey.getLength() == 0.0
    survey.calculateLength()
    assert survey.getLength() == 240.0
    build.start()
    measurements, trajectories = pyhelios.outputToNumpy(build.join())
    # Strips at y = 0 and 40, 300 m up: the swath is 2 x 300 tan(20).
    reach = 300.0 * math.tan(math.radians(20.0))
    assert measurements[:, 1].min() == pytest.approx(-reach, abs=1.0)
    assert measurements[:, 1].max() == pytest.approx(40.0 + reach, abs=1.0)
    assert trajectories[:, 2] == pytest.approx(300.0)
    east = trajectories[:, 1] < 20.0
    assert trajectories[east, 6] == pytest.approx(math.pi / 2)
    assert trajectories[~east, 6] == pytest.approx(-math.pi / 2)
    with pytest.raises(IndexError, match=r"newLeg\(9\): legs are added at the end; give 4"):
        simulation.newLeg(9)
    simulation.removeLeg(3)
    with pytest.raises(IndexError, match="there is no leg 3; there are 3"):
        simulation.getLeg(3)


@pytest.mark.skipif(not HELIOS.is_dir(), reason="the examples of HELIOS++ are not here")
def test_settings_of_an_example_survey(monkeypatch, tmp_path):
    monkeypatch.chdir(HELIOS)
    path = "data/surveys/toyblocks/als_toyblocks.xml"
    build = pyhelios.SimulationBuilder(path, "assets/", tmp_path).build()
    settings = build.sim.getLeg(0).getScannerSettings()
    assert settings.active is True
    assert settings.pulseFreq == 200_000
    assert settings.scanFreq == 80
    assert math.degrees(settings.scanAngle) == pytest.approx(20.0)
    assert settings.trajectoryTimeInterval == 0.01
    assert build.sim.getLeg(0).getPlatformSettings().movePerSec == 30
    survey = build.sim.getSurvey()
    survey.calculateLength()
    assert (survey.name, survey.getLength()) == ("toyblocks_als", 400.0)


# The output.


def test_measurements_are_echoes(builder):
    cloud = vtkhelios.read_survey(builder.surveyPath).run()
    output = run(builder)
    rows, _ = pyhelios.outputToNumpy(output)
    assert (rows[:, :3] == cloud.points).all()
    origin, direction, distance = rows[:, 3:6], rows[:, 6:9], cloud["Range"][:, None]
    assert origin == pytest.approx(np.tile([0.0, 0.0, SCANNER], (len(rows), 1)), abs=1e-9)
    assert np.linalg.norm(direction, axis=1) == pytest.approx(1.0, abs=1e-12)
    assert origin + direction * distance == pytest.approx(cloud.points, abs=1e-9)
    assert (rows[:, 9] == cloud["Amplitude"] * 1e9).all()
    assert (rows[:, 16] == cloud["GpsTime"]).all()
    lists, _ = pyhelios.outputToList(output)
    assert lists[3] == rows[3].tolist()
    echo = output.measurements[3]
    assert echo.position == echo.getPosition() == tuple(rows[3, :3])
    assert echo.beam_origin[2] == echo.getBeamOrigin().z == pytest.approx(SCANNER)
    assert echo.getBeamDirection() == echo.beam_direction
    assert echo.echoWidth == echo.echo_width == rows[3, 10]
    assert echo.pulseReturnNumber == echo.pulse_return_number == 1
    assert echo.distance == pytest.approx(cloud["Range"][3])
    assert [each.gpsTime for each in output.measurements[2:4]] == rows[2:4, 16].tolist()
    assert output.measurements.get(-1).fullwaveIndex == cloud["PulseIds"][-1]


def test_hit_objects_have_the_ids_of_parts(builder, tmp_path):
    scene = (tmp_path / "scene.xml").read_text()
    for name, number in (("17", 17.0), ("ground", 0.0)):
        (tmp_path / "scene.xml").write_text(scene.replace("<part>", f'<part id="{name}">'))
        output = run(builder)
        assert output.measurements[0].hitObjectId == output.measurements[0].hit_object_id == name
        assert set(pyhelios.outputToNumpy(output)[0][:, 14]) == {number}


def test_angles_of_attitudes_are_those_of_files():
    # Rz(-yaw) Ry(roll) Rx(pitch), column by column.
    roll, pitch, yaw = 0.3, -0.2, 2.5
    half = np.array([pitch, roll, -yaw]) / 2
    (cx, cy, cz), (sx, sy, sz) = np.cos(half), np.sin(half)
    quaternion = [
        cx * cy * cz + sx * sy * sz,
        sx * cy * cz - cx * sy * sz,
        cx * sy * cz + sx * cy * sz,
        cx * cy * sz - sx * sy * cz,
    ]
    assert np.ravel(find_angles([quaternion])) == pytest.approx([roll, pitch, yaw])
    angles = find_rotations(*(7.0 * np.array(quaternion)))
    assert angles == pytest.approx([math.degrees(each) for each in (pitch, roll, -yaw)])


# Filters, noise, seed.


def test_filters_change_parts(builder, tmp_path):
    scene = (tmp_path / "scene.xml").read_text().replace("<part>", '<part id="plane">')
    (tmp_path / "scene.xml").write_text(scene)
    builder.addTranslateFilter(0.0, 0.0, -1.0, "plane")
    builder.addScaleFilter(0.5, "plane")
    turn = math.radians(5.0)  # about x: z rises with y
    builder.addRotateFilter(math.cos(turn / 2), math.sin(turn / 2), 0.0, 0.0, "plane")
    rows, _ = pyhelios.outputToNumpy(run(builder))
    assert rows[:, 2] == pytest.approx(-1.0 + math.tan(turn) * rows[:, 1], abs=0.05)
    assert 80.0 < np.abs(rows[:, 1]).max() < 100.0  # nearly half of 200 m
    builder.addScaleFilter(0.5, "roof")
    with pytest.raises(
        pyhelios.PyHeliosToolsException, match="no part with the id 'roof'.*: plane"
    ):
        builder.build()
    with pytest.raises(ValueError, match="no rotation; its norm is 0"):
        pyhelios.Simulation().addRotateFilter(0.0, 0.0, 0.0, 0.0, "plane")


def test_the_seed_is_that_of_the_scripts(builder):
    clouds = []
    for seed in ("5", "5", "6"):
        pyhelios.setDefaultRandomnessGeneratorSeed(seed)
        clouds.append(pyhelios.outputToNumpy(run(builder))[0])
    assert (clouds[0] == clouds[1]).all()
    assert (clouds[0][:, :3] != clouds[2][:, :3]).any()


def test_platform_noise_is_switched_off(builder, tmp_path):
    path = pathlib.Path(builder.surveyPath)
    noise = '<positionZNoise type="UNIFORM" min="5" max="6"/>'
    path.write_text(path.read_text().replace("</survey>", f"{noise}</survey>"))
    without, _ = pyhelios.outputToNumpy(run(builder))
    builder.setPlatformNoiseDisabled(False)
    noisy, _ = pyhelios.outputToNumpy(run(builder))
    assert without[:, 5] == pytest.approx(SCANNER)
    assert noisy[:, 5].min() >= SCANNER + 5.0


# Objects of the survey.


def test_scanner_and_scene_are_described(builder):
    simulation = builder.build().sim
    scanner = simulation.getScanner()
    assert (scanner.averagePower, scanner.beamDivergence) == (4.0, 0.00035)
    assert scanner.wavelength == pytest.approx(1550e-9)
    assert scanner.getSupportedPulseFrequencies() == [100_000, 300_000]
    assert scanner.getDetector().accuracy == 0.005
    assert (scanner.detector.rangeMin, scanner.detector.range_max) == (1.5, 600.0)
    assert "Beam Divergence: 0.35 mrad" in scanner.toString()
    scanner.fwfSettings.beamSampleQuality = 3
    scanner.beamDivergence = 0.001
    assert (scanner.fwfSettings.beamSampleQuality, scanner.beam_divergence) == (3, 0.001)
    assert simulation.getPlatform().getRelativePosition().z == 1.5
    scene = simulation.getScene()
    assert scene.getAABB().getMinVertex().getPosition() == (-200.0, -200.0, 0.0)
    assert scene.AABB.getMaxVertex().position == (200.0, 200.0, 0.0)
    assert scene.getNumSceneParts() == 1 and scene.getScenePart(0).id == "0"
    triangle = scene.getPrimitive(1)
    assert triangle.getVertex(2).getPosition() == (-200.0, 200.0, 0.0)
    assert triangle.getCentroid().x == pytest.approx(-200.0 / 3)
    assert triangle.getMaterial().reflectance == pytest.approx(50.0)
    assert triangle.getScenePart().getId() == "0"
    for get, wrong in ((scene.getPrimitive, 2), (scene.getScenePart, 1)):
        with pytest.raises(IndexError, match=f"there is no .* {wrong}; there are {wrong}"):
            get(wrong)


# Control.


def test_a_paused_simulation_waits_and_a_stopped_one_ends(builder):
    reached = threading.Event()
    builder.setCallbackFrequency(1)
    builder.setCallback(lambda output: reached.set())
    simulation = builder.build()
    simulation.start()
    assert reached.wait(60)
    simulation.pause()
    simulation.stop()
    output = simulation.join()
    assert simulation.isStopped() and not simulation.isRunning()
    assert output.outpaths == []
    with pytest.raises(pyhelios.PyHeliosToolsException, match="was started before"):
        simulation.start()


def test_errors_of_callbacks_are_those_of_join(builder):
    def fail(output):
        raise KeyError("mine")

    builder.setCallbackFrequency(100)
    builder.setCallback(fail)
    with pytest.raises(KeyError, match="mine"):
        run(builder)


def test_laz_files(builder):
    laspy, _ = pytest.importorskip("laspy"), pytest.importorskip("lazrs")
    builder.setExportToFile(True)
    builder.setLasOutput(True)
    builder.setZipOutput(True)
    output = run(builder)
    assert output.outpath.endswith("leg000_points.laz")
    read = laspy.read(output.outpath)
    rows, _ = pyhelios.outputToNumpy(output)
    assert len(read.points) == len(rows)
    assert read.xyz == pytest.approx(rows[:, :3], abs=1e-3)
    again = run(builder)  # within the same second, or not
    assert pathlib.Path(again.outpath).parent != pathlib.Path(output.outpath).parent


# Errors.


@pytest.mark.parametrize(
    "setter, value, message",
    [
        ("setNumThreads", -1, r"setNumThreads\(-1\): expected a whole number, 0 or more"),
        ("setNumThreads", float("nan"), "setNumThreads.nan.: expected a whole number"),
        ("setLasOutput", 1, r"setLasOutput\(1\): expected True or False"),
        ("setRebuildScene", "yes", "setRebuildScene.'yes'.: expected True or False"),
        ("setCallback", 3, r"setCallback\(3\): expected a function of the output, or None"),
        ("setFixedGpsTimeStart", "soon", "setFixedGpsTimeStart.'soon'.: expected a POSIX time"),
    ],
)
def test_values_that_are_not_valid(setter, value, message):
    with pytest.raises(pyhelios.PyHeliosToolsException, match=message):
        getattr(pyhelios.SimulationBuilder("survey.xml"), setter)(value)


def test_a_fixed_start_is_that_of_the_survey(builder):
    builder.setFixedGpsTimeStart("2017-01-01 00:00:00")
    survey = builder.build().sim
    assert survey.fixedGpsTimeStart == "2017-01-01 00:00:00"
    assert survey._state.vtk.GetSurveyAttribute("gpsStartTime") == "2017-01-01 00:00:00"


def test_a_fixed_start_is_told_to_be_relative(capsys):
    builder = pyhelios.SimulationBuilder("survey.xml")
    builder.setFixedGpsTimeStart("2022-01-01 00:00:00")
    builder.setFixedGpsTimeStart("1640995200")
    builder.setFixedGpsTimeStart("")
    assert capsys.readouterr().err.count("GPS times count from the start of the survey") == 2


@pytest.mark.parametrize("setter", ["setZipOutput", "setLegacyEnergyModel", "setFullwaveNoise"])
def test_options_that_are_not_covered(setter, builder):
    getattr(builder, setter)(True)
    with pytest.raises(
        pyhelios.NotCoveredError, match=f"SimulationBuilder.{setter} is not covered"
    ):
        builder.build()


def test_names_that_are_not_covered(builder):
    simulation = builder.build().sim
    leg, scene = simulation.getLeg(0), simulation.getScene()
    owners = [
        (pyhelios, "pyhelios"),
        (builder, "SimulationBuilder"),
        (builder.build(), "SimulationBuild"),
        (simulation, "Simulation"),
        (simulation.getSurvey(), "Survey"),
        (simulation.getScanner(), "Scanner"),
        (leg, "Leg"),
        (leg.getScannerSettings(), "ScannerSettings"),
        (leg.getPlatformSettings(), "PlatformSettings"),
        (scene, "Scene"),
        (scene.getScenePart(0), "ScenePart"),
        (scene.getPrimitive(0), "Primitive"),
    ]
    for owner, name in owners:
        with pytest.raises(pyhelios.NotCoveredError, match=f"{name}.frobnicate is not covered"):
            owner.frobnicate
    for owner in (simulation, simulation.getScanner(), leg.getScannerSettings(), leg, scene):
        with pytest.raises(pyhelios.NotCoveredError, match="frobnicate is not covered"):
            owner.frobnicate = 1
    leg.serialId = 0
    with pytest.raises(
        pyhelios.NotCoveredError, match="serialId cannot be set to 3: .* the leg, 0"
    ):
        leg.serialId = 3
    with pytest.raises(pyhelios.NotCoveredError, match="set dynStep of <scene>"):
        simulation.dynSceneStep
    output = run(builder)
    with pytest.raises(pyhelios.NotCoveredError, match="Measurement.colour is not covered"):
        output.measurements[0].colour
    with pytest.raises(pyhelios.NotCoveredError, match="change the array of outputToNumpy"):
        output.measurements[0].intensity = 0.0
    with pytest.raises(IndexError, match="there is no record"):
        output.measurements[10**9]


def test_changes_that_are_not_valid(builder):
    simulation = builder.build()
    with pytest.raises(vtkhelios.PipelineError, match="leg 0: pulseFreq_hz.*out of range"):
        simulation.sim.getLeg(0).getScannerSettings().pulseFreq = -5
    settings = simulation.sim.getLeg(0).getScannerSettings()
    settings.headRotateStart, settings.headRotateStop = 2.0, 1.0
    with pytest.raises(vtkhelios.PipelineError, match="headRotateSt"):
        simulation.start()


def test_errors_of_the_survey_have_their_place(tmp_path):
    (tmp_path / "bad.xml").write_text("<document>\n<survey scne='x'/>\n</document>")
    with pytest.raises(vtkhelios.PipelineError, match=r"bad.xml:2"):
        pyhelios.SimulationBuilder(tmp_path / "bad.xml").build()
    with pytest.raises(pyhelios.PyHeliosToolsException, match="call loadSurvey"):
        pyhelios.Simulation("bad.xml").getNumLegs()
    with pytest.raises(pyhelios.PyHeliosToolsException, match="call start"):
        pyhelios.Simulation("bad.xml").join()


def test_version():
    assert pyhelios.getVersion() == f"vtkHelios {vtkhelios.__version__}"
