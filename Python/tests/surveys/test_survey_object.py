# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys read, run in memory, in blocks and to files; of scenes in memory."""

import tempfile
import tracemalloc

import numpy as np
import pytest
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource

import vtkhelios
from vtkhelios.core.watching import ProgressLine

FLAT = ([[-60, -60, 0], [60, -60, 0], [60, 60, 0], [-60, 60, 0]], [[0, 1, 2], [0, 2, 3]])
TRIPOD = dict(scan_frequency=100, vertical=(-40, 60), head=(0, 30), head_speed=60)


@pytest.fixture
def survey(make_survey):
    return vtkhelios.read_survey(make_survey())


@pytest.fixture
def three():
    """Three scan positions on a plane; the second is skipped."""
    legs = [(0, 0), dict(position=(10, 0), active=False), (0, 20, 1), (5, 5)]
    return vtkhelios.make_survey(vtkhelios.Scene(*FLAT), legs, **TRIPOD)


def test_read(survey):
    assert repr(survey) == (
        "Survey('plane': Terrestrial polygon mirror (RIEGL VZ-400 class) on Tripod, "
        "1 leg, 1 active, scene 'plane')"
    )
    assert survey.legs[0].position == (0, 0, 2) and survey.legs[0].pulse_frequency == 100_000
    assert survey.number_of_pulses == 50_000 and survey.leg_pulses(0) == (0, 50_000)
    assert survey.scene.GetNumberOfCells() == 2
    assert "<td>0, 0, 2</td><td>100,000</td><td>100</td>" in survey._repr_html_()


def test_read_errors(tmp_path, make_survey):
    with pytest.raises(vtkhelios.PipelineError, match="none.xml"):
        vtkhelios.read_survey(tmp_path / "none.xml")
    with pytest.raises(FileNotFoundError, match="nowhere: no such folder"):
        vtkhelios.read_survey(make_survey(), assets=[tmp_path / "nowhere"])
    path = make_survey(speed="fast")
    with pytest.raises(vtkhelios.PipelineError, match='survey.xml:6: headRotatePerSec_deg="fast"'):
        vtkhelios.read_survey(path)


def test_same_echoes_as_files(survey, tmp_path):
    cloud = survey.run(seed=5)
    report = survey.run_to(tmp_path / "out", seed=5)
    rows = np.loadtxt(report["folder"] / "leg000_points.xyz", usecols=(0, 1, 2))
    assert report["totals"]["points"] == len(rows) == len(cloud)
    assert np.abs(rows - cloud.points).max() < 1e-4
    assert not np.array_equal(survey.run(seed=6).points, cloud.points)
    assert np.array_equal(survey.run(seed=5).points, cloud.points)


def test_result_is_independent_of_later_runs(survey):
    first = survey.run(noise=False)
    before = first.points.copy()
    second = survey.run()
    assert np.array_equal(first.points, before) and not np.array_equal(second.points, before)


def test_options(survey):
    exact = survey.run(noise=False, truth=True)
    steep = exact["IncidenceAngle"] < 80  # at grazing incidence the footprint is long and skewed
    assert np.abs(exact.points[steep, 2]).max() < 1e-3
    assert np.abs(exact["TruePoint"] - exact.points)[steep].max() < 1e-2
    plain = survey.run()
    assert "TruePoint" not in plain and plain.waveforms is plain.pulses is plain.sub_rays is None
    flagged = survey.run(scan_flags=True)  # a polygon
    assert "EdgeOfFlightLine" not in plain and flagged["ScanDirectionFlag"].all()
    assert set(flagged["EdgeOfFlightLine"]) <= {0, 1}
    relative = survey.run(decibels=True)
    assert "Reflectance" not in plain and np.array_equal(relative["Amplitude"], plain["Amplitude"])
    strength = relative["RelativeAmplitude"] - 10 * np.log10(relative["Amplitude"])
    assert np.ptp(strength) < 1e-9 and relative["Reflectance"].max() < 0
    full = survey.run(waveforms=True, pulses=True, hits=True, sub_rays=7)
    assert full.waveforms.GetNumberOfRows() == len(np.unique(full["PulseIds"]))
    # the scanner emits over 100 of the 240 degrees of a facet
    assert len(full.pulses) == pytest.approx(50_000 * 100 / 240, rel=0.01)
    assert len(full.sub_rays) > 5 * len(full)


def test_legs(three):
    whole = three.run(waveforms=True)
    assert set(np.unique(whole["LegIds"])) == {0, 2, 3}
    ends = three.run(legs=[3, 0], waveforms=True)
    keep = whole["LegIds"] != 2
    assert np.array_equal(ends.points, whole.points[keep])
    assert np.array_equal(ends["PulseIds"], whole["PulseIds"][keep])
    one = three.run(legs=2)
    assert np.array_equal(one.points, whole.points[~keep])
    # The samples of a pulse's row are its own.
    last = ends.waveforms.GetNumberOfRows() - 1
    same = whole.waveforms.GetNumberOfRows() - 1
    assert np.array_equal(_samples(ends.waveforms, last), _samples(whole.waveforms, same))


def _samples(table, row):
    columns = vtkhelios.arrays(table)
    begin = columns["Offset"][row]
    return columns["Samples"][begin : begin + columns["Count"][row]]


@pytest.mark.parametrize(
    "legs, message",
    [
        (7, "there is no leg 7; legs are 0 to 3"),
        ([1], "leg 1 fires no pulses; leave it out of legs"),
        ([], "legs is empty; give the index of a leg, or None for all"),
    ],
)
def test_wrong_legs(three, legs, message):
    with pytest.raises(ValueError, match=message):
        three.run(legs=legs)


def test_blocks_are_computed_on_demand(survey, monkeypatch):
    """With 5e12 pulses the first block is immediate."""

    class Long:
        def GetNumberOfPulses(self):
            return 5 * 10**12

    monkeypatch.setattr(survey, "_load", lambda *_: Long())
    monkeypatch.setattr(survey, "_run_window", lambda _options, window, _watched: window)
    tracemalloc.start()
    blocks = survey.blocks(10**6)
    first = next(blocks), next(blocks)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert first == ((0, 10**6), (10**6, 2 * 10**6))
    assert peak < 10**6


def test_blocks_equal_the_run(three):
    whole = three.run(pulses=True)
    shares = []
    blocks = list(three.blocks(30_000))
    assert len(blocks) == 5
    assert np.array_equal(np.concatenate([block.points for block in blocks]), whole.points)
    some = list(three.blocks(20_000, legs=[2], progress=shares.append))
    assert np.array_equal(
        np.concatenate([block.points for block in some]), whole.points[whole["LegIds"] == 2]
    )
    assert shares == sorted(shares) and 1 / 3 <= shares[0] <= shares[-1] <= 2 / 3
    with pytest.raises(ValueError, match="pulses is 0; give a whole number of 1 or more"):
        next(three.blocks(0))


def test_progress_is_reported(three):
    shares = []
    three.run(progress=shares.append)
    assert shares and shares[0] >= 0 and shares[-1] <= 1
    with pytest.raises(TypeError, match="progress is 7; give True, False or a function"):
        three.run(progress=7)


def test_progress_line(three, capsys):
    three.run(progress=True)
    said = capsys.readouterr().err
    assert said.startswith("\r[") and " %" in said and said.endswith("\r")

    class File(list):
        write = list.append

        def flush(self):
            pass

    file = File()
    line = ProgressLine(file)
    line(0.5)
    assert f"[{'#' * 12}{' ' * 12}]  50 %, 0 s left" in file[0]
    line.close()
    assert file[-1].strip() == ""


def test_run_continues_without_a_place_for_progress(survey, monkeypatch):
    with open("/dev/full", "w") as full:
        monkeypatch.setattr("sys.stderr", full)
        assert len(survey.run(progress=True)) > 0
        full.buffer.raw.close()  # else Python's final flush also fails
        assert len(survey.run(progress=True)) > 0
    monkeypatch.setattr("sys.stderr", None)
    assert len(survey.run(progress=True)) > 0


def test_exception_of_a_callback_ends_the_run(three, tmp_path):
    def stop(share):
        raise RuntimeError(f"enough at {share:.0f}")

    with pytest.raises(RuntimeError, match="enough at 0"):
        three.run(progress=stop)
    with pytest.raises(RuntimeError, match="enough"):
        three.run_to(tmp_path, progress=stop)
    assert len(three.run()) > 0


@pytest.mark.parametrize(
    "call, error, message",
    [
        (lambda s: s.run(sede=1), TypeError, "sede is no option; options are: tolerance, en"),
        (lambda s: s.run(seed=-7), ValueError, r"seed is -7; its valid range is \[0, 2"),
        (
            lambda s: s.run(detector="best"),
            vtkhelios.PipelineError,
            'EchoDetector is "best"; give peak',
        ),
        (lambda s: s.run(tolerance=7), (ValueError, vtkhelios.PipelineError), "is 7"),
        (lambda s: s.run(tolerance=0.1, sub_rays=7), ValueError, "give one of them"),
        (lambda s: s.run_to("x", legs=0), TypeError, "legs is no option; options are: .*hits"),
        (
            lambda s: s.run_to("x", truth=True),
            vtkhelios.PipelineError,
            "cannot have points and normals without noise; give vtp",
        ),
        (lambda s: s.run_to("x", format="pdf"), vtkhelios.PipelineError, "pdf"),
    ],
)
def test_wrong_options(three, call, error, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(error, match=message):
        call(three)


def test_earlier_run_is_not_overwritten(survey, tmp_path):
    survey.run_to(tmp_path)
    with pytest.raises(vtkhelios.PipelineError, match="files of an earlier run"):
        survey.run_to(tmp_path)
    assert survey.run_to(tmp_path, overwrite=True, format="las")["folder"].is_dir()


def test_in_a_pipeline(survey):
    @vtkhelios.filter
    def far(cloud, distance=20.0):
        return cloud["Range"] > distance

    cloud = vtkhelios.Cloud((survey >> far)())
    assert len(cloud) and cloud["Range"].min() > 20
    source = survey.source(waveforms=True)
    again = vtkhelios.Cloud(
        (vtkhelios.select_ports(source, 1) >> vtkhelios.vtkHeliosEchoDetection())()
    )
    assert len(again) == len(survey.run())


# By hand.


def test_scan_a_plane():
    scene = vtkhelios.Scene(*FLAT, reflectance=0.4)
    cloud = vtkhelios.scan(scene, position=(3, 4), noise=False, truth=True, **TRIPOD)
    centre = np.array([3, 4, 1.7])  # mount and beam are 1.5 and 0.2 m up
    assert np.abs(cloud.points[cloud["IncidenceAngle"] < 80, 2]).max() < 2e-3
    assert np.allclose(np.linalg.norm(cloud.points - centre, axis=1), cloud["Range"], atol=1e-6)


def test_reflectance_scales_amplitude():
    dark = vtkhelios.scan(vtkhelios.Scene(*FLAT, reflectance=0.2), (0, 0), noise=False, **TRIPOD)
    light = vtkhelios.scan(vtkhelios.Scene(*FLAT, reflectance=0.4), (0, 0), noise=False, **TRIPOD)
    common = np.intersect1d(dark["PulseIds"], light["PulseIds"])
    ratio = (
        light["Amplitude"][np.isin(light["PulseIds"], common)]
        / dark["Amplitude"][np.isin(dark["PulseIds"], common)]
    )
    assert np.allclose(ratio, 2, rtol=1e-6)


def test_scan_along_a_path():
    cloud = vtkhelios.scan(
        vtkhelios.Scene(*FLAT),
        path=[(-20, 0, 40), (20, 0, 40)],
        scanner="copter_uls",
        speed=20,
        scan_frequency=50,
        pulse_frequency=100_000,
        scan_angle=30,
    )
    assert np.ptp(cloud["GpsTime"]) == pytest.approx(2, abs=0.1)
    assert cloud.points[:, 0].min() == pytest.approx(-20, abs=1)


def test_trajectory(three):
    way = [(-20, 0, 40), (20, 0, 40), (20, 30, 40)]
    flight = vtkhelios.make_survey(
        vtkhelios.Scene(*FLAT), way, "copter_uls", "copter_linearpath", speed=20, scan_frequency=50
    )
    leg = flight.trajectory(0, interval=0.5)
    assert np.allclose(leg.points, [(x, 0, 40) for x in (-20, -10, 0, 10, 20)])
    assert np.allclose(leg["GpsTime"], [0, 0.5, 1, 1.5, 2]) and leg["Orientation"].shape == (5, 4)
    assert flight.trajectory(1, interval=0)["GpsTime"].tolist() == pytest.approx([2, 3.5])
    assert len(three.trajectory(0)) == 1
    with pytest.raises(ValueError, match="leg 1 fires no pulses and has no trajectory"):
        three.trajectory(1)
    with pytest.raises(ValueError, match="interval is -1; give seconds"):
        three.trajectory(0, interval=-1)


def test_scene_keeps_memory_and_bits():
    points = np.random.default_rng(3).random((30, 3))
    triangles = np.arange(30).reshape(10, 3)
    scene = vtkhelios.Scene(points, triangles, reflectance=np.linspace(0.1, 0.9, 10))
    assert scene.points.ctypes.data == points.ctypes.data
    assert np.array_equal(scene.triangles, triangles)
    survey = vtkhelios.make_survey(scene, [(0, 0, 5)], **TRIPOD)
    assert np.array_equal(vtkhelios.Scene(survey.scene).points, points)
    assert len(scene + vtkhelios.Scene(*FLAT)) == 12
    low, high = scene.bounds
    assert np.array_equal(low, points.min(axis=0)) and np.array_equal(high, points.max(axis=0))
    assert repr(scene).startswith("Scene(10 triangles, ")


def test_scene_of_an_algorithm_and_of_data():
    blocks = vtkhelios.vtkHeliosSyntheticScene(kind="blocks")
    assert len(vtkhelios.Scene(blocks)) == len(vtkhelios.Scene(blocks.output)) > 100
    ground = vtkhelios.Scene(blocks.output, reflectance=0.1).polydata.GetFieldData()
    assert ground.GetArray("Material.Reflectance").GetTuple1(0) == 0.1


def test_a_changed_scene_is_scanned_as_it_is_now():
    scene = vtkhelios.Scene(*FLAT)
    survey = vtkhelios.make_survey(scene, [(0, 0, 0)], **TRIPOD)
    first = survey.run(noise=False)
    scene.points[:, 2] -= 1
    scene.modified()
    second = survey.run(noise=False)
    assert second["Range"].min() == pytest.approx(first["Range"].min() * 2.7 / 1.7, rel=1e-2)
    scene.points[:, 2] += 4
    scene.modified()
    assert vtkhelios.Scene(survey.scene).points[0, 2] == 3


def test_a_scene_in_memory_writes_no_file(tmp_path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    before = tmp_path.stat().st_mtime_ns  # changes with every file made in it
    assert len(vtkhelios.scan(vtkhelios.Scene(*FLAT), (0, 0), **TRIPOD)) > 1000
    assert tmp_path.stat().st_mtime_ns == before and list(tmp_path.iterdir()) == []


def test_a_scene_of_vtk_filters_is_scanned_as_it_is():
    plane = vtkPlaneSource()  # one polygon of four corners, on the xy plane
    plane.SetOrigin(-60, -60, 0)
    plane.SetPoint1(60, -60, 0)
    plane.SetPoint2(-60, 60, 0)
    survey = vtkhelios.make_survey(plane, [(0, 0, 0)], **TRIPOD)
    assert abs(survey.run(noise=False).points[:, 2]).max() < 0.02
    plane.SetCenter(0, 0, -2)  # the survey follows the pipeline
    assert survey.run(noise=False).points[:, 2].max() == pytest.approx(-2, abs=0.02)
    blocks = vtkAppendFilter()  # an unstructured grid
    blocks.AddInputConnection(plane.GetOutputPort())
    cloud = vtkhelios.scan(blocks, (0, 0, 0), noise=False, **TRIPOD)
    assert cloud.points[:, 2].max() == pytest.approx(-2, abs=0.02)


def test_another_scene_for_a_survey_from_a_file(make_survey):
    path = make_survey()
    own = vtkhelios.read_survey(path).run(noise=False)
    scene = vtkhelios.Scene(*FLAT)
    scene.points[:, 2] += 0.5
    other = vtkhelios.read_survey(path, scene=scene).run(noise=False)
    assert other.points[:, 2].mean() == pytest.approx(own.points[:, 2].mean() + 0.5, abs=1e-3)


def test_files_of_a_scene_in_memory(tmp_path):
    survey = vtkhelios.make_survey(vtkhelios.Scene(*FLAT), [(0, 0)], name="flat", **TRIPOD)
    report = survey.run_to(tmp_path, noise=False, seed=3)
    assert report["folder"] == tmp_path / "flat" and report["options"]["seed"] == 3
    assert report["totals"]["points"] == len(survey.run(noise=False, seed=3))
    with pytest.raises(TypeError, match="colour is no option; options are: tolerance, "):
        survey.run_to(tmp_path, colour=1)


def test_settings_of_a_leg_by_their_names_in_surveys():
    cloud = _scan(scanFreq_hz=50, trajectoryTimeInterval_s=0.1)
    assert len(cloud) > 1000
    with pytest.raises(vtkhelios.PipelineError, match='leg 0: scanFreq_hz="fast" is not'):
        _scan(scanFreq_hz="fast")


def test_scene_of_another_type_is_an_error(make_survey):
    for call in (
        lambda: vtkhelios.scan(42, (0, 0), **TRIPOD),
        lambda: vtkhelios.read_survey(make_survey(), scene=4.2),
    ):
        with pytest.raises(
            TypeError, match="scene is of (int|float); give a Scene, a VTK data set"
        ):
            call()
    points = vtkhelios.Cloud.from_arrays(vtkhelios.Scene(*FLAT).points).polydata
    with pytest.raises(vtkhelios.PipelineError, match="the input scene, a vtkPolyData, has no pol"):
        vtkhelios.scan(points, (0, 0, 5), **TRIPOD)


def test_limits_of_the_scanner_clip_with_a_warning():
    with pytest.warns(RuntimeWarning, match='^leg 0: scanFreq_hz="1" is clipped to 3, '):
        _scan(scan_frequency=1)


@pytest.mark.parametrize(
    "make, error, message",
    [
        (
            lambda: vtkhelios.Scene([[0, 0]], [[0, 0, 0]]),
            ValueError,
            r"points has the shape \(1, 2\)",
        ),
        (
            lambda: vtkhelios.Scene([[0, 0, 0]], [[0, 0, 1]]),
            ValueError,
            "indices from 0 to 1; the po",
        ),
        (
            lambda: vtkhelios.Scene([[0, 0, 0]], [[0, 0, 0.5]]),
            TypeError,
            "float64; give whole numb",
        ),
        (lambda: vtkhelios.Scene([[0, 0, np.nan]], [[0, 0, 0]]), ValueError, "has NaN or infinity"),
        (
            lambda: vtkhelios.Scene(*FLAT, reflectance=2),
            ValueError,
            r"is 2; its valid range is \[0, 1\]",
        ),
        (
            lambda: vtkhelios.Scene(*FLAT, reflectance=[1]),
            ValueError,
            "give one number, or 2 of them",
        ),
        (lambda: vtkhelios.Scene(1), TypeError, "made of points and triangles, .* not of int"),
        (
            lambda: vtkhelios.Scene("x"),
            ValueError,
            "x: is not a mesh of a known format; known: .obj",
        ),
        (lambda: _scan(scan_freq=9), TypeError, "scan_freq is neither a setting of a leg"),
        (
            lambda: _scan(scan_frequency=-1),
            vtkhelios.PipelineError,
            '^leg 0: scanFreq_hz="-1" is out of range',
        ),
        (lambda: _scan(position=(1,)), ValueError, "give x, y, or x, y, z"),
        (lambda: _scan(scanner="laser"), vtkhelios.PipelineError, "laser"),
        (lambda: _scan(position=None), TypeError, "needs a position .on a tripod., or a path"),
        (lambda: _make([{}]), TypeError, "a leg has no position"),
        (
            lambda: _make([dict(position=(0, 0), colour=1)]),
            TypeError,
            "colour is not a setting of a leg",
        ),
    ],
)
def test_errors(make, error, message):
    with pytest.raises(error, match=message):
        make()


def _scan(**more):
    return vtkhelios.scan(vtkhelios.Scene(*FLAT), **{"position": (0, 0), **TRIPOD, **more})


def _make(legs):
    return vtkhelios.make_survey(vtkhelios.Scene(*FLAT), legs, **TRIPOD)


def test_what_is_replaced_need_not_exist(make_survey, tmp_path):
    path = make_survey(stop=6)
    expected = vtkhelios.read_survey(path).run()
    (tmp_path / "plane.obj").unlink()
    (tmp_path / "scene.xml").unlink()
    with pytest.raises(vtkhelios.PipelineError, match="scene.xml: no such file|no such file"):
        vtkhelios.read_survey(path)
    plane = vtkhelios.Scene(
        [[-200, -200, 0], [200, -200, 0], [200, 200, 0], [-200, 200, 0]], [[0, 1, 2], [0, 2, 3]]
    )
    cloud = vtkhelios.read_survey(path, scene=plane).run()
    assert (cloud.points == expected.points).all()


def test_a_replaced_trajectory_need_not_exist(make_survey, tmp_path):
    path = make_survey(stop=6)
    text = path.read_text().replace('platform="platforms.xml#tripod"', 'platform="interpolated"')
    path.write_text(text.replace("<platformSettings ", '<platformSettings trajectory="gone.trj" '))
    with pytest.raises(vtkhelios.PipelineError, match='trajectory="gone.trj": no such file'):
        vtkhelios.read_survey(path)
    times = [0.0, 1.0, 2.0]
    flight = vtkhelios.Cloud.from_arrays(
        [[t, 0, 20] for t in times], GpsTime=times, Orientation=[[1.0, 0, 0, 0]] * 3
    )
    assert len(vtkhelios.read_survey(path, trajectory=flight).run()) > 0


@pytest.mark.parametrize(
    "bad", [dict(scattering_orders=-1), dict(max_sub_rays=-5), dict(detector="nope")]
)
def test_a_refused_option_holds_for_its_call_only(survey, bad):
    for legs in (None, [0]):
        with pytest.raises(vtkhelios.PipelineError):
            survey.run(legs=legs, pulse_step=2000, **bad)
        assert len(survey.run(legs=[0], pulse_step=2000).points) > 0
