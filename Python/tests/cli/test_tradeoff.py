# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Accuracy against time on surveys whose errors are known, and what it recommends."""

import argparse
import csv
import dataclasses
import io
import json
import os
import pathlib
import runpy
import signal
import subprocess
import sys
import time
from xml.etree import ElementTree

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkStringArray

import vtkhelios
from vtkhelios.scenes import meshes as meshes
from vtkhelios.surveys.accuracy import MEASURES, Estimate, Sampler
from vtkhelios.core.pipeline import PipelineError
from vtkhelios.surveys.tradeoff_run import confirm
from vtkhelios.reports.tradeoff_pictures import make_picture
from vtkhelios.cli.tradeoff import explain_none, fraction, length, minutes, set_options

SETTINGS = ("survey", "sub-rays", "tolerance")  # names that a survey can use; some ray casters, too
ROOM = "".join(
    f"v {x} {y} {z}\n" for z in (0, 9) for x, y in ((-20, -20), (20, -20), (20, 20), (-20, 20))
)
ROOM += "f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
WALL = "v -100 10 -100\nv 100 10 -100\nv 100 10 100\nv -100 10 100\nf 1 2 3\nf 1 3 4\n"


@pytest.fixture(scope="module")
def fence(tmp_path_factory):
    """Two scan positions before slats of 3 mm, thinner than the beam, and a wall."""
    small_run = runpy.run_path(pathlib.Path(__file__).parents[1] / "_small_run.py")
    return small_run["write_survey"](tmp_path_factory.mktemp("fence"))


@pytest.fixture(scope="module")
def result(fence):
    return vtkhelios.read_survey(fence).tradeoff(pulses=400, seconds=1e6)


def row_of(rows, name):
    return next(row for row in rows if row.name == name)


def test_on_a_plane_no_way_has_an_error(make_survey, tmp_path):
    survey = make_survey(stop=5)
    (tmp_path / "plane.obj").write_text(WALL)
    text = survey.read_text()
    for old, new in (('_deg="-40"', '_deg="-2"'), ('_deg="60"', '_deg="2"')):
        text = text.replace(f"verticalAngle{'Min' if '-' in old else 'Max'}{old}",
                            f"verticalAngle{'Min' if '-' in old else 'Max'}{new}")  # fmt: skip
    survey.write_text(text)
    result = vtkhelios.read_survey(survey).tradeoff(pulses=50, parts=False, seconds=1e6)
    assert result.parts == []
    for row in result.ways:
        if row.kind in ("survey", "sub-rays", "pattern", "tolerance", "bins"):
            assert row.errors["rangeP95_m"].upper < 1e-4, row.name
            assert row.errors["missedAndInvented"].value == 0, row.name
            assert row.errors["amplitudeRms"].value < 2e-3, row.name


def test_few_sub_rays_miss_slats_that_tolerances_see(result):
    rows = {row.name: row for row in result.ways}
    few, many = rows["7 sub-rays"], rows["953 sub-rays"]
    assert few.errors["rangeP95_m"].lower > many.errors["rangeP95_m"].upper
    assert few.errors["amplitudeRms"].value > 3 * many.errors["amplitudeRms"].upper
    assert rows["1 sub-ray"].errors["missed"].lower > 2e-3
    for tolerance in (0.01, 0.003, 0.001):
        row = rows[f"tolerance {1e3 * tolerance:g} mm"]
        assert row.errors["rangeP95_m"].lower <= tolerance
        assert row.errors["missedAndInvented"].lower <= 10 * tolerance
    assert few.seconds < many.seconds


def test_values_below_the_error_of_the_reference_are_unclear(result):
    for row in result.ways:
        for name, estimate in row.errors.items():
            own = result.reference[name].value
            assert (name in row.unclear) == (estimate.value <= 3 * own), (row.name, name)


def test_ray_casters_give_the_same_echoes(result):
    rows = [row for row in result.ways if row.kind == "ray caster" and "obbtree" not in row.name]
    assert len(rows) > 1
    assert all(row.errors == rows[0].errors for row in rows)


def test_no_setting_beats_the_frontier(result):
    frontier = result.frontier
    assert frontier == sorted(frontier, key=lambda row: row.seconds)
    for row in result.ways:
        if row.kind in SETTINGS:
            assert any(best.seconds <= row.seconds and best.score <= row.score for best in frontier)


def test_the_cheapest_setting_is_as_accurate_as_asked(result):
    row = result.cheapest(range_error=0.003, missed=0.02)
    assert row.range_error <= 0.003 and row.lost <= 0.02
    for other in result.ways:
        if other.kind in SETTINGS and other.seconds < row.seconds:
            assert other.range_error > 0.003 or other.lost > 0.02
    assert result.cheapest(range_error=1e-9) is None


def test_what_the_reference_cannot_tell_is_said(result):
    arguments = argparse.Namespace(memory=None, minutes=None, range=None, missed=0.01)
    own = {**result.reference, "missedAndInvented": Estimate(0.02, 0.01, 0.03)}
    vague = dataclasses.replace(result, reference=own)
    assert vague.cheapest(missed=0.01) is None and vague.cheapest(missed=0.5) is not None
    text = explain_none(vague, arguments, 2)
    assert text.startswith(
        "--missed 1 %: missed and invented echoes cannot be told to better than 2 %"
    )


def test_a_check_replaces_the_error_of_a_reference_that_it_contradicts():
    own = dict.fromkeys(MEASURES, Estimate(1e-5, 1e-5, 2e-5))
    of_check = dict.fromkeys(MEASURES, Estimate(1e-3, 5e-4, 2e-3))
    found = {**of_check, "rangeP95_m": Estimate(6e-3, 5e-3, 9e-3)}
    assert confirm(own, found, of_check) == {**own, "rangeP95_m": found["rangeP95_m"]}


def test_patterns_of_one_number_differ(result):
    rows = [row for row in result.ways if row.kind == "pattern"]
    names = [row.name for row in rows]
    assert "64 sub-rays, Vogel" in names and "64 sub-rays, GaussLegendre" in names
    pair = [row_of(rows, f"256 sub-rays, {name}").errors for name in ("Vogel", "GaussLegendre")]
    assert pair[0]["amplitudeRms"].value != pair[1]["amplitudeRms"].value
    assert max(errors["amplitudeRms"].value for errors in pair) < 0.02


def test_ray_casters_differ_in_memory(result):
    rows = {row.options["ray_caster"]: row for row in result.ways if row.kind == "ray caster"}
    assert rows["bvh"].memory > rows["beam"].memory > 1e4
    assert result.run_memory(rows["bvh"]) == result.other_memory + rows["bvh"].memory
    assert 1e7 < result.other_memory < 4e9
    least = result.run_memory(result.smallest)
    assert result.cheapest(memory=least).memory == result.smallest.memory
    assert result.most_accurate(memory=least).memory == result.smallest.memory
    assert result.has_setting(least) and not result.has_setting(0.99 * least)
    assert result.cheapest(memory=0.99 * least) is None
    assert result.most_accurate(memory=1e12).score == result.frontier[-1].score


def test_memory_of_a_way_does_not_depend_on_the_run_before(fence):
    sampler = Sampler(vtkhelios.read_survey(fence), 40, lambda *_: None, {})
    way = {"ray_caster": "bvh"}
    sampler.run(**way)
    memory = sampler.memory(**way)
    sampler.run(ray_caster="beam", sub_rays=1)
    assert memory == sampler.memory(**way) > 6e4


def test_a_ray_caster_is_a_setting_if_it_gains(result):
    base = result.ways[0]

    def add(seconds, memory):
        caster = dataclasses.replace(
            base, name="other", kind="ray caster", seconds=seconds, memory=memory
        )
        return dataclasses.replace(result, ways=[*result.ways, caster])

    def is_setting(made):
        return made.has_setting(made.run_memory(made.ways[-1])) and any(
            row.name == "other" for row in (made.fastest, made.smallest)
        )

    assert is_setting(add(1e-9, 2 * base.memory))  # faster
    assert is_setting(add(2 * base.seconds, 1.0))  # smaller
    assert not is_setting(add(1e-9, base.memory))  # the survey's own, timed by chance
    assert not is_setting(add(0.99 * base.seconds, 2 * base.memory))


def test_the_most_accurate_setting_is_within_the_time(result):
    row = result.most_accurate(1e9)
    assert row.score == min(row.score for row in result.frontier)
    fastest = min(result.frontier, key=lambda row: row.seconds)
    assert result.most_accurate(result.run_time(fastest) * 1.0001) is fastest
    assert result.run_time(fastest, threads=2) == result.run_time(fastest) / 2
    assert result.most_accurate(0.0) is None


def test_parts_of_the_model_change_what_they_model(result):
    names = [row.name for row in result.parts]
    assert names[0] == "the whole model" and "without voxels" not in names
    for reason in (
        "without specular: no material is specular",
        "without spectra: no material has a spectrum",
        "without voxels: the scene has no turbid voxels",
        "without motion: the platform does not move while it scans",
        "without attitude: the platform does not move while it scans",
        "parts of the scene: there is one, or one kind",
    ):
        assert reason in result.absent
    whole = result.parts[0].errors
    assert whole["rangeP95_m"].value == whole["missedAndInvented"].value == 0
    bare = row_of(result.parts, "without divergence")
    assert bare.errors["missed"].lower > 2e-3  # slats beside the axis
    clear = row_of(result.parts, "without atmosphere")
    assert clear.errors["missedAndInvented"].value == 0
    assert 0 < clear.errors["amplitudeRms"].value < 0.02
    merged = row_of(result.parts, "without waveform")
    assert merged.errors["missed"].lower > 0 and merged.echoes < result.parts[0].echoes
    noise = row_of(result.parts, "with noise")
    assert 1e-3 < noise.errors["rangeRms_m"].value < 0.02
    assert noise.errors["rangeRms_m"].value == pytest.approx(result.noise, rel=0.25)
    position = noise.errors["positionP95_m"]  # along the beam, normally distributed
    assert position.lower < position.value < position.upper
    assert position.value == pytest.approx(1.96 * result.noise, rel=0.25)


def test_a_specular_lobe_counts_where_there_is_one(make_survey, tmp_path):
    survey = make_survey(stop=5)
    (tmp_path / "plane.obj").write_text("mtllib a.mtl\nusemtl shiny\n" + WALL)
    (tmp_path / "a.mtl").write_text("newmtl shiny\nKd 0.2 0.2 0.2\nKs 0.8 0.8 0.8\nNs 20\n")
    survey = vtkhelios.read_survey(survey)
    shiny = survey.run(noise=False)["Amplitude"].max()
    assert survey.run(noise=False, without="specular")["Amplitude"].max() < 0.5 * shiny


def test_tables_have_columns(result):
    table = result.table
    assert len(table) == len(result.ways) and table["way"][0] == "the survey as it is"
    assert table[0]["rangeP95_m_lower"] <= table[0]["rangeP95_m"] <= table[0]["rangeP95_m_upper"]
    assert set(table.columns) == set(table[3])
    read = list(csv.DictReader(io.StringIO(table.to_csv())))
    assert float(read[2]["us_per_pulse"]) == table["us_per_pulse"][2]
    assert table._repr_html_().count("<tr>") == len(table) + 1
    assert [row["way"] for row in result.parts_table] == [row.name for row in result.parts]
    assert json.loads(result.to_json())["reference"]["tolerance"] == pytest.approx(3e-5)


def test_samples_are_the_same_pulses(fence):
    survey = vtkhelios.read_survey(fence)
    whole = survey.run(noise=False)
    some = survey.run(noise=False, pulse_step=50)
    assert 0 < len(some) < len(whole) / 20
    ranges = dict(zip(zip(whole["PulseIds"], whole["ReturnNumber"]), whole["Range"]))
    for pulse, number, value in zip(some["PulseIds"], some["ReturnNumber"], some["Range"]):
        assert ranges[pulse, number] == value
    both = np.concatenate([survey.run(noise=False, pulse_step=50, legs=i)["Range"] for i in (0, 1)])
    assert (both == some["Range"]).all()


@pytest.mark.parametrize(
    "options, message",
    [
        (
            {"without": "colour"},
            'Without is "colour"; give divergence, waveform, specular, spectra,',
        ),
        ({"sub_rays": 18, "sub_ray_pattern": "Circles"}, "does not have; give 7 or 19, or the"),
    ],
)
def test_wrong_options_name_value_and_cure(fence, options, message):
    with pytest.raises(PipelineError) as caught:
        vtkhelios.read_survey(fence).run(**options)
    assert message in str(caught.value)


def test_bins_have_a_valid_range(fence):
    with pytest.raises(ValueError, match="bin_size is -1.0; its valid range is"):
        vtkhelios.read_survey(fence).run(bin_size=-1.0)


def test_too_few_pulses_are_refused(fence):
    with pytest.raises(ValueError, match="pulses is 3; give a whole number of 10 or more"):
        vtkhelios.read_survey(fence).tradeoff(pulses=3)


def test_times_too_short_to_measure(make_survey, monkeypatch):
    """Surveys of few pulses have results and a picture, whose axes are logarithmic."""
    monkeypatch.setattr(Sampler, "_time_window", lambda *_: 0.0)
    result = vtkhelios.read_survey(make_survey(stop=1)).tradeoff(pulses=10, parts=False)
    assert all(row.seconds > 0 for row in result.ways)
    assert make_picture(result).startswith(b"\x89PNG")


def test_what_does_not_fit_into_the_time_is_named(fence):
    """The settings are measured in any case, on fewer pulses."""
    result = vtkhelios.read_survey(fence).tradeoff(pulses=400, seconds=1e-6)
    assert {row.kind for row in result.ways} == {"survey", "sub-rays", "tolerance"}
    assert [row.name for row in result.parts] == ["the whole model"]
    assert 50 < result.pulses < 400
    named = next(text for text in result.absent if "give more seconds (--seconds)" in text)
    for name in ("20 sub-rays, Vogel", "detector gaussian", "ray caster bvh", "with noise"):
        assert name in named


def test_times_are_of_fired_pulses(make_survey, monkeypatch):
    """A window that is narrower than a line fires few of its pulses."""
    survey = vtkhelios.read_survey(make_survey())
    for leg in survey.legs:
        leg.vertical = (-5, -4)
    sampler = Sampler(survey, 50, lambda *_: None, {})
    assert sampler.share_fired < 0.1
    lengths = []

    def count(first, length, _options):
        """Every pulse that is fired takes a millisecond."""
        cloud = survey.run_window({"noise": False, "pulses": True}, (first, first + length))
        lengths.append(length)
        return 1e-3 * len(cloud.pulses)

    monkeypatch.setattr(sampler, "_time_window", count)
    assert sampler.time() == pytest.approx(1e-3)
    assert max(lengths) > 1


def test_a_tenth_of_the_noise_is_a_way(result, fence):
    survey = vtkhelios.read_survey(fence)
    noise = float(survey.vtk.GetScannerAttribute(0, "accuracy_m"))
    row = row_of(result.ways, f"tolerance {100 * noise:g} mm, 1 %")
    assert row.options == {"tolerance": pytest.approx(0.1 * noise), "energy_tolerance": 0.01}
    small = survey.tradeoff(pulses=50, parts=False, seconds=0.0, accuracy="instrument")
    assert row_of(small.ways, "7 sub-rays").errors["missed"].value >= 0


@pytest.mark.parametrize("duration", [1e-5, 1e-4, 0.033])
def test_few_pulses(make_survey, tmp_path, command_line, duration):
    """One, ten, and 3,300."""
    survey = make_survey()
    (tmp_path / "plane.obj").write_text(ROOM)
    text = survey.read_text().replace(
        "Stop_deg", f'Stop_deg="30" maxDuration_s="{duration}" unused'
    )
    survey.write_text(text.replace(' unused="30"', ""))
    command = ("tradeoff", survey, "--pulses", "10", "--no-parts", "--quiet", "--output", tmp_path)
    done = command_line(*command)
    assert done.returncode == 0, done.stderr
    names = {path.name for path in (tmp_path / "plane").iterdir()}
    assert names == {"tradeoff.json", "tradeoff.csv", "tradeoff.png"}


def test_a_survey_without_echoes_is_an_error(make_survey):
    survey = vtkhelios.read_survey(make_survey(z=10000.0))
    with pytest.raises(PipelineError, match="pulses of the survey has an echo"):
        survey.tradeoff(pulses=20)


@pytest.mark.parametrize("settings", ["", '<FWFSettings binSize_ns="1" beamSampleQuality="9"/>'])
def test_options_of_a_way_are_attributes_of_the_survey(make_survey, settings):
    path = make_survey()
    text = path.read_text().replace("<leg>", f"<!-- own -->{settings}<leg>", 1)
    path.write_text(text.replace("<survey ", '<survey rangeTolerance_m="0.5" ', 1))

    def apply(options):
        survey = vtkhelios.read_survey(path)
        set_options(survey, options)
        survey.write(path)
        root = ElementTree.parse(path).getroot().find("survey")
        assert "<!-- own -->" in path.read_text()
        found = root.find("FWFSettings")
        return dict(root.attrib), {} if found is None else dict(found.attrib)

    before, own = apply({})
    assert before["rangeTolerance_m"] == "0.5" and len(own) == (2 if settings else 0)
    fixed, own = apply({"sub_rays": 19})
    assert own["beamSampleQuality"] == "3" and "rangeTolerance_m" not in fixed
    again, own = apply({"tolerance": 0.003, "energy_tolerance": 0.03})
    assert "beamSampleQuality" not in own
    assert again == {**before, "rangeTolerance_m": "0.003", "energyTolerance": "0.03"}
    for caster in ("embree", "bvh"):
        assert apply({"ray_caster": caster})[0] == {**again, "rayCaster": caster}


@pytest.mark.parametrize(
    "parse, good, value, bad, message",
    [
        (length, "5mm", 0.005, "5", "'5' is not a length; give one such as 5mm or 2cm"),
        (length, "2 cm", 0.02, "-1m", "is not a length"),
        (fraction, "1%", 0.01, "2", "'2' is not a fraction; give one such as 1% or 0.01"),
        (fraction, "0.2", 0.2, "nan", "is not a fraction"),
        (minutes, "10", 10.0, "-3", "'-3' is not a time; give a number of minutes above 0"),
    ],
)
def test_wishes_are_read(parse, good, value, bad, message):
    assert parse(good) == pytest.approx(value)
    with pytest.raises(Exception, match=message):
        parse(bad)


def test_the_command_writes_files_and_applies_its_recommendation(command_line, fence, tmp_path):
    pytest.importorskip("matplotlib")
    out = fence.parent / "applied.xml"
    done = command_line(
        *("tradeoff", fence, "--pulses", 100, "--no-parts", "--output", tmp_path),
        *("--range", "200mm", "--missed", "60%", "--apply", out),
    )
    assert done.returncode == 0, done.stderr
    assert "ways to compute this survey" in done.stdout and "tolerance 0.3 mm" in done.stdout
    assert "recommended: " in done.stdout and f"written  {out}" in done.stdout
    for name in ("tradeoff.json", "tradeoff.csv", "tradeoff.png"):
        assert (tmp_path / "fence" / name).stat().st_size > 1000
    source = vtkhelios.read_survey(out).source()
    assert source.Load()
    recommended = done.stdout.split("recommended: ")[1].split(",")[0]
    number = recommended.split()[0]
    expected = f"fixed, {number} sub-ray" if "sub-ray" in recommended else "adaptive"
    assert source.DescribeSampling().startswith(expected)


def test_what_no_setting_reaches_is_an_error_with_the_best_one(command_line, fence, tmp_path):
    arguments = ("tradeoff", fence, "--pulses", 50, "--no-parts", "--output", tmp_path, "--quiet")
    done = command_line(*arguments, "--missed", "0.001%")
    assert done.returncode == 1
    assert "no setting is as accurate as asked" in done.stderr and "more --pulses" in done.stderr
    done = command_line(*arguments, "--range", "0.001um")
    assert done.returncode == 1
    assert "cannot be told to better than 0.03 mm here, the error of the reference" in done.stderr
    done = command_line(*arguments, "--minutes", "1e-9")
    assert done.returncode == 1 and "no setting is that fast" in done.stderr
    done = command_line(*arguments, "--memory", "25M")  # less than the process has
    assert done.returncode == 1 and "available of the 25 MB" in done.stderr


def test_too_little_memory_is_explained(result):
    arguments = argparse.Namespace(memory=1e6, minutes=None)
    text = explain_none(result, arguments, 2)
    assert text.startswith("--memory 1 MB: no setting needs so little; ")
    assert " needs about " in text and text.endswith(" MB: give more, or simplify the scene")
    arguments = argparse.Namespace(memory=1e12, minutes=1e-9)
    assert "no setting is that fast in this memory" in explain_none(result, arguments, 2)


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["--range", "5mm", "--minutes", "3"], "--minutes asks for the most accurate setting"),
        (["--apply", "a.xml"], "--apply needs a recommendation: give --range, --missed, --minutes"),
        (["--range", "five"], "'five' is not a length; give one such as 5mm"),
    ],
)
def test_wrong_usage_is_explained(command_line, fence, arguments, message):
    done = command_line("tradeoff", fence, *arguments)
    assert done.returncode == 2 and message in done.stderr


def test_ctrl_c_ends_it_and_nothing_is_written(fence, tmp_path):
    package = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
    child = subprocess.Popen(
        [sys.executable, "-P", "-m", "vtkhelios", "tradeoff", str(fence), "--pulses", "100000",
         "--output", str(tmp_path / "out")],
        env={**os.environ, "PYTHONPATH": str(package)}, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    assert child.stdout.readline().startswith("survey ")
    child.send_signal(signal.SIGINT)
    started = time.monotonic()
    _, errors = child.communicate(timeout=60)
    assert child.returncode == 130, errors
    assert time.monotonic() - started < 5.0
    assert "interrupted before all ways were measured; nothing was written" in errors
    assert not (tmp_path / "out").exists()


FLIGHT = """\
<document>
  <survey name="flight" scene="scene.xml#field" platform="platforms.xml#copter_linearpath"
    scanner="scanners.xml#copter_uls">
    <leg>
      <platformSettings x="-10" y="0" z="40" onGround="false" movePerSec_m="8"/>
      <scannerSettings active="true" pulseFreq_hz="50000" scanFreq_hz="20" scanAngle_deg="20"/>
    </leg>
    <leg>
      <platformSettings x="10" y="0" z="40" onGround="false"/>
      <scannerSettings active="false"/>
    </leg>
  </survey>
</document>
"""
PART = """\
    <part id="{name}"><filter type="objloader">
      <param type="string" key="filepath" value="{name}.obj"/></filter></part>
"""


@pytest.fixture(scope="module")
def flight(tmp_path_factory):
    """A flight over a meadow that has a spectrum, and a tarpaulin with ripples of 5 mm."""
    folder = tmp_path_factory.mktemp("flight")
    parts = "".join(PART.format(name=name) for name in ("meadow", "tarpaulin"))
    (folder / "scene.xml").write_text(f'<document><scene id="field">\n{parts}</scene></document>')
    (folder / "meadow.mtl").write_text("newmtl green\nhelios_spectra grass\n")
    (folder / "meadow.obj").write_text(
        "mtllib meadow.mtl\nusemtl green\nv -60 -60 0\nv 60 -60 0\nv 60 60 0\nv -60 60 0\n"
        "f 1 2 3\nf 1 3 4\n"
    )
    lines, faces = [], []
    for i, j in np.ndindex(61, 61):
        height = 0.5 + 0.005 * np.sin(i) * np.cos(j)
        lines.append(f"v {-3 + 0.1 * i:.3f} {-3 + 0.1 * j:.3f} {height:.6f}")
        if i < 60 and j < 60:
            k = 61 * i + j + 1
            faces += [f"f {k} {k + 61} {k + 62}", f"f {k} {k + 62} {k + 1}"]
    (folder / "tarpaulin.obj").write_text("\n".join(lines + faces) + "\n")
    (folder / "survey.xml").write_text(FLIGHT)
    return folder / "survey.xml"


def test_without_spectra_materials_have_the_default_reflectance(flight):
    survey = vtkhelios.read_survey(flight)
    options = {"noise": False, "pulse_step": 100}
    pair = [survey.run(**options), survey.run(**options, without="spectra")]
    on_meadow = [cloud[cloud["PartIds"] == 0] for cloud in pair]
    file = vtkhelios.data_directory() / "Assets/spectra/grass.txt"
    rows = [line.split() for line in file.read_text().splitlines()]
    rows = np.array([row for row in rows if len(row) == 2 and row[0][0].isdigit()], dtype=float)
    wavelength = float(survey.vtk.GetScannerAttribute(0, "wavelength_nm"))
    reflectance = np.interp(wavelength / 1000, *rows.T) / 100
    ratio = on_meadow[0]["Amplitude"] / on_meadow[1]["Amplitude"]
    assert ratio == pytest.approx(reflectance / 0.5, rel=1e-9)
    on_tarpaulin = [cloud[cloud["PartIds"] == 1]["Amplitude"] for cloud in pair]
    assert len(on_tarpaulin[0]) and (on_tarpaulin[0] == on_tarpaulin[1]).all()


def test_without_motion_the_platform_stands_still_during_a_line(flight):
    survey = vtkhelios.read_survey(flight)
    still = survey.run(noise=False, pulses=True, without="motion").pulses
    whole = survey.run(noise=False, pulses=True).pulses
    assert len(np.unique(whole.points[:, 0])) == len(whole)
    places, first = np.unique(still.points[:, 0], return_index=True)
    assert len(places) == 50  # 2.5 s of 20 lines/s
    assert places == pytest.approx(whole.points[first, 0], abs=1e-3)
    away = whole.points[:, 0] - still.points[:, 0]
    assert away.min() > -1e-9 and away.max() == pytest.approx(8 / 20, rel=1e-2)
    assert (whole["Direction"] == still["Direction"]).all()


def test_without_attitude_interpolation_that_of_the_last_sample_holds():
    angles = np.radians([0, 10, 30]) / 2
    zero = np.zeros(3)
    path = vtkhelios.Cloud.from_arrays(
        np.column_stack([[0, 1, 2], zero, zero + 20]),
        GpsTime=np.array([0.0, 1.0, 2.0]),
        Orientation=np.column_stack([np.cos(angles), zero, zero, np.sin(angles)]),
    )
    scene = vtkhelios.Scene([(-90, -90, 0), (90, -90, 0), (0, 120, 0)], [(0, 1, 2)])
    survey = vtkhelios.make_survey(
        scene, scanner="copter_uls", trajectory=path, pulse_frequency=50000, scan_frequency=20
    )
    options = {"noise": False, "pulses": True, "pulse_step": 100}
    whole = survey.run(**options).pulses
    held = survey.run(**options, without="attitude").pulses

    def find_heading(cloud):  # angle of the plane in which the beams lie, from the start's
        across = cloud["Direction"][:, :2]
        return np.degrees(np.arctan2(across[:, 1], across[:, 0])) % 180

    late = np.linalg.norm(whole["Direction"][:, :2], axis=1) > 0.1  # not straight down
    turned = (find_heading(whole) - find_heading(held) + 90) % 180 - 90
    time = whole["GpsTime"]
    expected = np.where(time < 1, 10 * time, 20 * (time - 1))
    assert turned[late] == pytest.approx(expected[late], abs=1e-6)
    assert (whole.points == held.points).all()


def test_beams_hit_a_mesh_in_place_of_the_scene(flight):
    survey = vtkhelios.read_survey(flight)
    before = survey.run(noise=False, pulse_step=200)
    scene = vtkhelios.Scene(survey.scene)
    lowered = vtkhelios.Scene(scene.points - (0, 0, 1), scene.triangles)
    after = survey.run(noise=False, pulse_step=200, mesh=lowered)
    assert after.points[:, 2].max() == pytest.approx(before.points[:, 2].max() - 1, abs=0.01)
    again = survey.run(noise=False, pulse_step=200)
    assert (again.points == before.points).all()


@pytest.fixture(scope="module")
def flown(flight):
    return vtkhelios.read_survey(flight).tradeoff(pulses=200, seconds=1e6)


def test_parts_of_the_model_of_a_flight(flown):
    rows = {row.name: row for row in flown.parts}
    still = rows["without motion"].errors
    assert still["positionP95_m"].value == pytest.approx(0.95 * 8 / 20, rel=0.1)
    plain = rows["without spectra"]
    assert plain.errors["amplitudeRms"].lower > 0.01 and plain.errors["rangeP95_m"].value < 1e-6
    straight = rows["without attitude"].errors  # constant
    assert straight["positionP95_m"].value == straight["missedAndInvented"].value == 0
    assert "without specular" not in rows and "without voxels" not in rows


def test_parts_of_the_scene_are_left_out_one_by_one(flown):
    rows = {row.name: row for row in flown.parts if row.kind == "scene part"}
    seen = rows["without tarpaulin"]  # it hides the meadow
    assert "7,200 triangles" in seen.detail and "% of the echoes" in seen.detail
    assert seen.errors["invented"].lower > 0 and seen.errors["missed"].value < 0.01
    assert seen.memory < 0.1 * flown.parts[0].memory
    assert rows["without meadow"].errors["missedAndInvented"].value == 0  # hides nothing


def test_simplified_meshes_are_as_near_as_stated(flown):
    import vtkhelios as package

    if not hasattr(package, "vtkHeliosMeshSimplify"):
        assert "simplified meshes: this build has no CGAL" in flown.absent
        return
    rows = [row for row in flown.ways if row.kind == "mesh"]
    assert [row.name for row in rows] == [f"mesh within {d} mm" for d in (10, 50)]
    base = flown.ways[0]
    for row, distance in zip(rows, (0.01, 0.05)):
        assert " of 7,202 triangles, verified " in row.detail
        assert float(row.detail.split()[-2]) <= 1e3 * distance
        assert row.memory < 0.8 * base.memory
        assert row.range_error <= 1.5 * distance  # beams are nearly vertical
        assert row.options == {} and row not in flown.frontier
    assert rows[0].errors["rangeRms_m"].value > 1e-4  # the ripples are gone
    part = row_of(flown.parts, "tarpaulin within 50 mm")
    assert " of 7,200 triangles" in part.detail
    assert part.errors["positionP95_m"].upper <= 0.05


def test_a_scene_and_a_mesh_are_scanned_as_planned(command_line, flight, tmp_path):
    pytest.importorskip("matplotlib")
    scene = flight.with_name("scene.xml")
    arguments = ("--pulses", 30, "--no-parts", "--grid", 30, "--resolution", 1)
    target = tmp_path / "tuned.xml"
    done = command_line(
        *("tradeoff", scene, *arguments, "--output", tmp_path, "--range", "1m"),
        *("--missed", "100%", "--apply", target),
    )
    assert done.returncode == 0, done.stderr
    assert "as planned by vtkhelios plan" in done.stdout and "scan position" in done.stdout
    assert len(list(tmp_path.glob("*/tradeoff.json"))) == 1
    assert [path.name for path in tmp_path.iterdir() if path.is_file()] == ["tuned.xml"]
    run = command_line("run", target, "--output", tmp_path / "run", "--no-accuracy-report")
    assert run.returncode == 0, run.stderr
    mesh = flight.with_name("meadow.obj")
    done = command_line("tradeoff", mesh, *arguments, "--output", tmp_path)
    assert done.returncode == 0, done.stderr
    assert "vz400_class_tls on tripod" in done.stdout
    assert (tmp_path / "meadow" / "tradeoff.csv").is_file()


@pytest.mark.parametrize(
    "file, options, message",
    [
        ("survey.xml", ["--grid", "3"], "--grid is for a scene or a mesh, and "),
        ("none.obj", [], "none.obj: "),
        ("scene.xml", ["--assets", "none"], "--assets none: no such folder"),
    ],
)
def test_wrong_inputs_are_explained(command_line, flight, file, options, message):
    done = command_line("tradeoff", flight.with_name(file), *options)
    assert done.returncode == 1 and message in done.stderr, done.stderr


def test_the_tables_of_the_manual(flown, tmp_path, capsys):
    study = pathlib.Path(__file__).parents[2] / "studies" / "tradeoff_table.py"
    path = tmp_path / "tradeoff.json"
    path.write_text(flown.to_json())
    runpy.run_path(str(study))["main"](path)
    printed = capsys.readouterr().out
    assert "| way | p50 [mm] |" in printed and "| without motion | " in printed
    assert "| 953 sub-rays | " in printed and "obbtree" not in printed


def make_grid(names, steps=90):
    """A mesh of ripples, cut into parts along x."""
    x, y = np.meshgrid(np.linspace(0, 9, steps + 1), np.linspace(0, 9, steps + 1), indexing="ij")
    points = np.stack([x, y, 0.005 * np.sin(11 * x) * np.cos(13 * y)], axis=-1).reshape(-1, 3)
    corner = np.add.outer((steps + 1) * np.arange(steps), np.arange(steps)).reshape(-1)
    first = np.stack([corner, corner + steps + 1, corner + steps + 2], axis=1)
    second = np.stack([corner, corner + steps + 2, corner + 1], axis=1)
    mesh = vtkhelios.Scene(points, np.concatenate([first, second])).polydata
    parts = (points[mesh_triangles(mesh)[:, 0], 0] * len(names) / 9.001).astype(np.int32)
    meshes._add(mesh, "PartIds", parts)
    texts = vtkStringArray()
    texts.SetName("Part.Name")
    for name in names:
        texts.InsertNextValue(name)
    mesh.GetFieldData().AddArray(texts)
    return mesh


def mesh_triangles(mesh):
    return vtkhelios.Scene(mesh).triangles


def test_parts_are_grouped_by_their_names():
    mesh = make_grid(["tree_001", "house", "tree_2", "7", "row-12"])
    groups = {group.name: group for group in meshes.find_groups(mesh)}
    assert set(groups) == {"tree (2 parts)", "house", "part 7", "row-12"}
    assert groups["tree (2 parts)"].ids == (0, 2)
    assert sum(group.triangles for group in groups.values()) == mesh.GetNumberOfPolys()
    rest = meshes.without_parts(mesh, (0, 2))
    trees = groups["tree (2 parts)"].triangles
    assert rest.GetNumberOfPolys() == mesh.GetNumberOfPolys() - trees
    assert {group.name for group in meshes.find_groups(rest)} == set(groups) - {"tree (2 parts)"}
    assert meshes.find_groups(vtkhelios.Scene(np.eye(3), [(0, 1, 2)]).polydata) == []


def test_trees_of_a_table_are_grouped_by_kind(tmp_path):
    """Parts without names that are instances of the same mesh."""
    for name in ("oak", "fir"):
        (tmp_path / f"{name}.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 0 9\nf 1 2 3\n")
    parts = [{"file": str(tmp_path / f"{name}.obj"), "translate": {"offset": (x, 0, 0)}}
             for x, name in enumerate(["oak", "fir", "oak", "oak", "fir"])]  # fmt: skip
    survey = vtkhelios.make_survey(
        parts, [(0, -20, 2)], head_speed=60, head=(0, 9), scan_frequency=9
    )
    groups = meshes.find_groups(survey.source_of({"instances": True}).GetScene())
    assert [(group.name, group.ids) for group in groups] == [
        ("part 0 (3 parts like it)", (0, 2, 3)), ("part 1 (2 parts like it)", (1, 4)),
    ]  # fmt: skip


def test_a_part_is_replaced_by_its_simplification():
    if not hasattr(vtkhelios, "vtkHeliosMeshSimplify"):
        pytest.skip("this build has no CGAL")
    mesh, shares = make_grid(["a", "b"]), []
    simplified, verified = meshes.simplify(mesh, 0.05, 60.0, shares.append)
    assert 0 < verified <= 0.05 and simplified.GetNumberOfPolys() < mesh.GetNumberOfPolys() / 4
    mixed = meshes.with_parts(mesh, simplified, (1,))
    counts = [{group.name: group.triangles for group in meshes.find_groups(each)}
              for each in (mesh, simplified, mixed)]  # fmt: skip
    assert counts[2] == {"a": counts[0]["a"], "b": counts[1]["b"]}
    assert mixed.GetBounds() == pytest.approx(mesh.GetBounds(), abs=0.05)
    assert meshes.simplify(mesh, 0.05, 0.0, shares.append) is None  # no time
