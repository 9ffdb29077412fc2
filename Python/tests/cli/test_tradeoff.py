# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Accuracy against time on surveys whose errors are known, and what it recommends."""

import csv
import io
import json
import os
import pathlib
import runpy
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import vtkhelios
from vtkhelios._survey_text import with_sampling
from vtkhelios.cli.tradeoff import fraction, length, minutes
from vtkhelios._pipeline import PipelineError

WALL = "v -100 10 -100\nv 100 10 -100\nv 100 10 100\nv -100 10 100\nf 1 2 3\nf 1 3 4\n"


@pytest.fixture(scope="module")
def fence(tmp_path_factory):
    """Two scan positions before slats of 3 mm, thinner than the beam, and a wall."""
    small_run = runpy.run_path(pathlib.Path(__file__).parents[1] / "_small_run.py")
    return small_run["write_survey"](tmp_path_factory.mktemp("fence"))


@pytest.fixture(scope="module")
def result(fence):
    return vtkhelios.read_survey(fence).tradeoff(pulses=400)


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
    result = vtkhelios.read_survey(survey).tradeoff(pulses=50, parts=False)
    assert result.parts == []
    for row in result.ways:
        if row.kind in ("survey", "sub-rays", "tolerance", "bins"):
            assert row.errors["rangeP95_m"].upper < 1e-4, row.name
            assert row.errors["missedAndInvented"].value == 0, row.name
            assert row.errors["amplitudeRms"].value < 2e-3, row.name


def test_few_sub_rays_miss_slats_that_tolerances_see(result):
    rows = {row.name: row for row in result.ways}
    few, many = rows["7 sub-rays"], rows["953 sub-rays"]
    for measure in ("amplitudeRms", "rangeP95_m"):
        assert few.errors[measure].lower > many.errors[measure].upper, measure
    assert rows["1 sub-ray"].errors["missed"].lower > 0.01
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
        if row.kind in ("survey", "sub-rays", "tolerance"):
            assert any(best.seconds <= row.seconds and best.score <= row.score for best in frontier)


def test_the_cheapest_setting_is_as_accurate_as_asked(result):
    row = result.cheapest(range_error=0.003, missed=0.02)
    assert row.range_error <= 0.003 and row.lost <= 0.02
    for other in result.ways:
        if other.kind in ("survey", "sub-rays", "tolerance") and other.seconds < row.seconds:
            assert other.range_error > 0.003 or other.lost > 0.02
    assert result.cheapest(range_error=1e-9) is None


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
    whole = result.parts[0].errors
    assert whole["rangeP95_m"].value == whole["missedAndInvented"].value == 0
    bare = row_of(result.parts, "without divergence")
    assert bare.errors["missed"].lower > 0.01  # slats beside the axis
    clear = row_of(result.parts, "without atmosphere")
    assert clear.errors["missedAndInvented"].value == 0
    assert 0 < clear.errors["amplitudeRms"].value < 0.02
    dull = row_of(result.parts, "without specular")
    assert dull.errors["amplitudeRms"].value == 0  # no material has a lobe
    noise = row_of(result.parts, "with noise")
    assert 1e-3 < noise.errors["rangeRms_m"].value < 0.02
    assert noise.errors["rangeRms_m"].value == pytest.approx(result.noise, rel=0.25)


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
    assert json.loads(result.to_json())["reference"]["subRays"] == 4096


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
        ({"without": "colour"}, 'Without is "colour"; give divergence, atmosphere, specular and'),
        ({"bin_size": -1.0}, "BinSize is -1 ns; give 0 to 1000000 ns, 0 for the survey's value"),
    ],
)
def test_wrong_options_name_value_and_cure(fence, options, message):
    with pytest.raises(PipelineError) as caught:
        vtkhelios.read_survey(fence).run(**options)
    assert message in str(caught.value)


def test_too_few_pulses_are_refused(fence):
    with pytest.raises(ValueError, match="pulses is 3; give a whole number of 10 or more"):
        vtkhelios.read_survey(fence).tradeoff(pulses=3)


def test_a_survey_without_echoes_is_an_error(make_survey):
    survey = vtkhelios.read_survey(make_survey(z=100.0))
    with pytest.raises(PipelineError, match="pulses of the survey has an echo"):
        survey.tradeoff(pulses=20)


SURVEYS = [
    b"<document><survey name=\"a\" x='1 > 0'/></document>",
    b'<document><!-- <survey> --><survey name="a">\n<leg/></survey></document>',
    b'<survey rangeTolerance_m="0.5"><FWFSettings binSize_ns="1" beamSampleQuality = \'9\'/></survey>',
]


@pytest.mark.parametrize("data", SURVEYS)
def test_sampling_is_written_into_a_survey(data):
    import xml.etree.ElementTree as tree

    def read(data):
        root = tree.fromstring(data)
        survey = root if root.tag == "survey" else root.find("survey")
        settings = survey.find("FWFSettings")
        return dict(survey.attrib), dict(settings.attrib) if settings is not None else {}

    before, _ = read(data)
    fixed, settings = read(with_sampling(data, circles=3))
    assert settings["beamSampleQuality"] == "3" and "rangeTolerance_m" not in fixed
    again, settings = read(
        with_sampling(with_sampling(data, circles=3), tolerance=0.003, energy_tolerance=0.03)
    )
    assert "beamSampleQuality" not in settings
    assert again == {**before, "rangeTolerance_m": "0.003", "energyTolerance": "0.03"}


@pytest.mark.parametrize("data, message", [(b"<a>", "is not XML"), (b"<a/>", "has no <survey>")])
def test_other_files_are_refused(data, message):
    with pytest.raises(ValueError, match=message):
        with_sampling(data, circles=3)


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
    done = command_line(*arguments, "--range", "0.001um")
    assert done.returncode == 1
    assert "no setting is as accurate as asked" in done.stderr and "more --pulses" in done.stderr
    done = command_line(*arguments, "--minutes", "1e-9")
    assert done.returncode == 1 and "no setting is that fast" in done.stderr


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["--range", "5mm", "--minutes", "3"], "--minutes asks for the most accurate setting"),
        (["--apply", "a.xml"], "--apply needs a recommendation: give --range, --missed or"),
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
    time.sleep(3.0)
    child.send_signal(signal.SIGINT)
    started = time.monotonic()
    _, errors = child.communicate(timeout=60)
    assert child.returncode == 130, errors
    assert time.monotonic() - started < 5.0
    assert "interrupted before all ways were measured; nothing was written" in errors
    assert not (tmp_path / "out").exists()
