# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios fit: table, JSON, files that are flown, errors, interrupts."""

import json
import re
import signal

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.cli import fit
from vtkhelios.reports.fit import shown
from vtkhelios.fitting import Value

LINES, PULSES, HEIGHT, SPEED = 50.0, 50_000.0, 300.0, 50.0


def write(path, seconds=1.0, times=True, pulses=None):
    """A polygon mirror over level ground with steps of 4 m, by formulas: angles of +-20 degrees,
    flown northward. At a step a pulse has a second return on the lower level."""
    number = np.arange(int(seconds * PULSES) if pulses is None else pulses)
    time = number / PULSES
    beta = 40 * ((time * LINES) % 1.0) - 20
    tangent = np.tan(np.radians(beta))
    origin = np.column_stack([0 * time, SPEED * time, np.full_like(time, HEIGHT)])
    beam = np.column_stack([tangent, 0 * time, -np.ones_like(time)])
    upper = np.floor(HEIGHT * tangent / 10) % 2 == 0
    level = np.where(upper, 4.0, 0.0)
    first = origin + beam * (HEIGHT - level)[:, None]
    second = np.flatnonzero(upper & (number % 7 == 0))
    last = origin[second] + beam[second] * HEIGHT
    order = np.argsort(np.concatenate([number, second]), kind="stable")

    def both(values, more):
        return np.concatenate([values, more])[order]

    several = np.ones(len(number), np.uint8)
    several[second] = 2
    chunk = {
        "points": np.concatenate([first, last])[order],
        "ReturnNumber": both(np.ones(len(number), np.uint8), np.full(len(second), 2, np.uint8)),
        "NumberOfReturns": both(several, several[second]),
        "ScanAngle": both(beta, beta[second]),
        "GpsTime": both(time, time[second]) + 1000.0 if times else np.zeros(len(order)),
        "LegIds": np.full(len(order), 5, np.int32),
    }
    with formats.open_writer(path, formats.Header()) as writer:
        writer.write(chunk)
    return path


@pytest.fixture(scope="module")
def cloud(tmp_path_factory):
    return write(tmp_path_factory.mktemp("clouds") / "a.las")


def call(capsys, *arguments):
    capsys.readouterr()
    code = cli.main(["fit", *map(str, arguments)])
    return code, *capsys.readouterr()


def test_table(cloud, capsys):
    code, out, _ = call(capsys, cloud)
    assert code == 0
    assert re.search(r"^strip 1, source 5: 5\d,\d{3} points of 50,000 pulses in 1.00 s", out, re.M)
    assert re.search(r"^  mirror +rotating +lines in one direction", out, re.M)
    assert re.search(r"^  pulse frequency +50000\.0+ Hz +\+- 0\.0", out, re.M)
    assert re.search(r"^  line frequency +50\.00\d* Hz +\+- ", out, re.M)
    assert re.search(r"^  speed +50\.0000\d* m/s +\+- ", out, re.M)
    assert re.search(r"^  threshold +not known +the cloud has no Intensity or Amplitude", out, re.M)


def test_json_is_that_of_the_package(cloud, capsys):
    code, out, err = call(capsys, cloud, "--json")
    assert code == 0
    assert json.loads(out) == json.loads(vtkhelios.fit(cloud).to_json())


def test_survey_is_flown(cloud, tmp_path, capsys):
    folder = tmp_path / "new" / "fitted"
    code, out, _ = call(capsys, cloud, "--output", folder)
    assert code == 0 and f"written  {folder}; fly it: vtkhelios run {folder / 'survey.xml'}" in out
    assert json.loads((folder / "fit.json").read_text())["strips"][0]["source"] == 5
    assert cli.main(["validate", str(folder / "survey.xml")]) == 0
    arguments = ["run", str(folder / "survey.xml"), "--format", "las", "--output", str(tmp_path)]
    assert cli.main([*arguments, "--quiet"]) == 0
    again = vtkhelios.fit(tmp_path / "fitted")
    assert again["mirror"].text == "rotating"
    assert again["line frequency"].value == pytest.approx(LINES, abs=0.02)
    assert again.of_strip("speed", 1).value == pytest.approx(SPEED, abs=0.01)
    assert abs(again.strips[0].times[0] - 1000.0) < 0.01  # the times of the cloud
    code, _, err = call(capsys, cloud, "--output", folder)
    assert code == 1 and "survey.xml: already exists; give --overwrite to replace it" in err
    code, out, err = call(
        capsys, cloud, "--output", folder, "--overwrite", "--quiet", "--scene", "city.xml#city"
    )
    assert (code, out, err) == (0, "", "")
    assert 'scene="city.xml#city"' in (folder / "survey.xml").read_text()


@pytest.mark.parametrize(
    "name", ["scanner.xml", "survey.xml", "ground.obj", "strip002.csv", "fit.json"]
)
def test_no_file_is_replaced_unasked(cloud, tmp_path, capsys, name):
    (tmp_path / name).write_text("of the user")
    code, _, err = call(capsys, cloud, "--output", tmp_path)
    assert code == 1 and f"{name}: already exists; give --overwrite to replace it" in err
    assert [path.name for path in tmp_path.iterdir()] == [name]
    assert (tmp_path / name).read_text() == "of the user"


def test_a_short_strip_is_an_error(tmp_path, capsys):
    code, _, err = call(capsys, write(tmp_path / "a.las", seconds=0.5))
    assert code == 1 and err.count("\n") == 1
    assert "nothing can be fitted: strip 1 is left out: fewer than 10 of its scan lines" in err


def test_errors(cloud, tmp_path, capsys):
    (tmp_path / "empty").mkdir()
    untimed = write(tmp_path / "untimed.las", times=False)
    few = write(tmp_path / "few.las", pulses=300)
    for arguments, message in (
        ((tmp_path / "gone.las",), "gone.las: no such file or folder; check its name"),
        ((tmp_path / "empty",), "empty: is a folder without run_summary.json"),
        ((untimed,), "GpsTime is 0 at all points, so that no pulses are known"),
        ((few,), "has 300 pulses in its longest strip, too few for a fit; give a cloud"),
        ((cloud, "--scene", "a.xml#b"), "--scene is of the survey that --output writes; give it"),
        (
            (cloud, "--scene", "a.xml", "--output", "b"),
            "a.xml: has no id; give the file and the id",
        ),
        (
            (cloud, "--output", cloud / "b"),
            "cannot be written: Not a directory; give another --outp",
        ),
        ((cloud, "--points", 1000), "the clouds have more than 1,000 points; give fewer strips"),
    ):
        code, out, err = call(capsys, *arguments, "--quiet")
        assert code == 1 and message in err and out == "" and "Traceback" not in err, err
    for arguments in ((), (cloud, "--unit", 0), (cloud, "--points", 10)):
        with pytest.raises(SystemExit) as end:
            call(capsys, *arguments)
        assert end.value.code == 2


def test_no_memory(cloud, monkeypatch, capsys):
    def fail(*_):
        raise MemoryError

    monkeypatch.setattr(fit, "fit_watched", fail)
    code, _, err = call(capsys, cloud)
    assert code == 1 and "not enough memory; give fewer strips" in err


def test_interrupt_writes_nothing(cloud, tmp_path, monkeypatch, capsys):
    def stop(_clouds, on_step, *_):
        signal.raise_signal(signal.SIGINT)
        on_step("strip 1", 0.5)
        on_step("strip 1", 0.6)

    monkeypatch.setattr(fit, "fit_watched", stop)
    code, _, err = call(capsys, cloud, "--output", tmp_path / "fitted")
    assert code == 130 and "interrupted; nothing was written" in err
    assert not (tmp_path / "fitted").exists()


@pytest.mark.parametrize(
    "value, uncertainty, unit, expected",
    [
        (386735.751, 0.31, "Hz", ("386735.75 Hz", "+- 0.31")),
        (0.0135, 0.0008, "m", ("13.50 mm", "+- 0.80")),
        (0.00028, 0.00014, "rad", ("0.28 mrad", "+- 0.14")),
        (3.0, None, "", ("3", "")),
        (50.0, 1e-9, "Hz", ("50.000000 Hz", "+- 1e-09")),
    ],
)
def test_numbers_are_rounded_as_their_uncertainty(value, uncertainty, unit, expected):
    assert shown(Value("a", unit, value, uncertainty, "")) == expected
