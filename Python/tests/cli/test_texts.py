# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texts and names that are not UTF-8: errors keep their text, names work or are clearly rejected."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys

import pytest
from vtkmodules.vtkCommonCore import vtkObject, vtkOutputWindow

import vtkhelios
from vtkhelios import _native, cli
from vtkhelios.core.paths import from_vtk, to_vtk
from vtkhelios.core.pipeline import MessageLog, report_error
from vtkhelios.cli._messages import Messages
from vtkhelios.core.streams import visible
from vtkhelios.formats import _waveforms

ODD = os.fsdecode(b"odd\xff\xfe")  # a file name that is not UTF-8
BAD = b"\xff\xfe"


@pytest.fixture
def odd_survey(make_survey, tmp_path):
    """A survey whose folder and name are not UTF-8."""
    make_survey()
    folder = tmp_path / ODD
    folder.mkdir()
    for name in ("survey.xml", "scene.xml", "plane.obj"):
        shutil.copy(tmp_path / name, folder / name)
    return (folder / "survey.xml").rename(folder / f"{ODD}.xml")


def expect_clear(done):
    """One clear error that shows the name."""
    assert done.returncode == 1, done
    assert done.stderr.startswith("error: ") and done.stderr.count("error") == 1
    assert r"odd\xff\xfe" in done.stderr and "Traceback" not in done.stderr


# Messages of an object.


@pytest.mark.parametrize(
    "text, expected",
    [
        (b"bad \xff\xfe bytes", r"bad \xff\xfe bytes"),
        ("größer", "größer"),
        (b"", "vtkObject: a message without text"),
        (None, "vtkObject: a message without text"),
    ],
)
def test_error_events_with_any_text_raise(text, expected):
    source = vtkObject()
    with MessageLog() as log:
        log.watch(source)
        for event in ("ErrorEvent", "WarningEvent"):
            source.InvokeEvent(event, *[text][: text is not None])
    assert log.errors == log.warnings == [expected]
    assert not source.HasObserver("ErrorEvent")


def test_messages_count_them(capsys):
    source = vtkObject()
    with Messages() as messages:
        messages.watch(source)
        source.InvokeEvent("WarningEvent", b"x\xff")
        source.InvokeEvent("ErrorEvent", b"x\xff")  # the same text, as bytes
        vtkOutputWindow.GetInstance().DisplayErrorText(b"y\xff")
    assert messages.errors == 2
    assert capsys.readouterr().err == "warning: x\\xff\nerror: x\\xff\nerror: y\\xff\n"


def test_failure_reported_only_by_the_executive_raises(capsys):
    source = vtkObject()
    told = "Algorithm vtkFoo returned failure for request: vtkInformation"
    with Messages() as messages:
        messages.watch(source)
        source.InvokeEvent("ErrorEvent", told)
        assert messages.errors == 1
        source.InvokeEvent("ErrorEvent", told)
    assert messages.errors == 1
    assert capsys.readouterr().err == f"error: {told}\n"


@pytest.mark.parametrize(
    "arguments, error, message",
    [
        ((None, "ErrorEvent", print), TypeError, "None cannot be watched"),
        ((vtkObject(), "FooEvent", print), ValueError, "FooEvent is not a VTK event"),
        ((vtkObject(), "ErrorEvent", 3), TypeError, "the callback is not callable"),
    ],
)
def test_invalid_observers(arguments, error, message):
    with pytest.raises(error, match=message):
        _native.observe(*arguments)


def test_exception_in_an_observer_is_contained(monkeypatch):
    unraisable = []
    monkeypatch.setattr(sys, "unraisablehook", unraisable.append)
    source = vtkObject()
    _native.observe(source, "ErrorEvent", lambda text: 1 / 0)
    source.InvokeEvent("ErrorEvent", "x")
    assert unraisable[0].exc_type is ZeroDivisionError


def test_an_observer_keeps_ctrl_c():
    def interrupt(_text):
        signal.raise_signal(signal.SIGINT)

    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # jobs of a shell ignore it
    source = vtkObject()
    _native.observe(source, "ErrorEvent", interrupt)
    try:
        with pytest.raises(KeyboardInterrupt):
            source.InvokeEvent("ErrorEvent", "x")
            for _ in range(1000):
                pass
    finally:
        signal.signal(signal.SIGINT, before)


def test_python_errors_with_such_names(window, capfd):
    source = vtkObject()
    with MessageLog() as log:
        log.watch(source)
        report_error(source, f"{ODD}: broken")
    assert log.errors == [r"odd\xff\xfe: broken"]
    report_error(source, f"{ODD}: broken")  # not observed
    assert capfd.readouterr().err.startswith("odd")


def test_messages_have_one_source():
    """VTK's own observers drop texts that are not UTF-8."""
    package = pathlib.Path(vtkhelios.__file__).parent
    assert not [path for path in package.rglob("*.py") if "CallDataType" in path.read_text()]


def test_names_to_vtk_and_back():
    assert to_vtk("größe") == "größe"
    assert to_vtk(ODD) == to_vtk(os.fsencode(ODD)) == b"odd\xff\xfe"
    assert from_vtk(b"odd\xff\xfe") == from_vtk(ODD) == ODD and from_vtk(None) == ""


# Messages of readers.


def test_detect_loses_no_waveforms(make_survey, tmp_path, monkeypatch, capsys):
    out = tmp_path / "out"
    assert (
        cli.main(["run", str(make_survey()), "--output", str(out), "--waveforms", "--quiet"]) == 0
    )
    path = out / "plane/leg000_fullwave.txt"
    good = path.read_bytes()
    lines = good.splitlines(keepends=True)
    at = sum(map(len, lines[: len(lines) * 3 // 4])) + 4  # in a number of the second half
    path.write_bytes(good[:at] + BAD + good[at + 2 :])
    monkeypatch.setattr(_waveforms, "PIECE_SIZE", len(good) // 2)
    arguments = ["detect", str(path), "-o", str(tmp_path / "e.xyz"), "--pulse-length", "4"]
    assert cli.main(arguments) == 1
    error = capsys.readouterr().err
    assert error.startswith("error: ") and r"\xff\xfe" in error and "leg000_fullwave.txt" in error
    assert not list(tmp_path.glob("e.xyz*"))
    path.write_bytes(good)
    assert cli.main(arguments) == 0


def test_read_survey_raises(make_survey):
    path = make_survey()
    text = path.read_bytes()
    path.write_bytes(text.replace(b'pulseFreq_hz="100000"', b'pulseFreq_hz="' + BAD + b'"'))
    with pytest.raises(vtkhelios.PipelineError, match=r'survey.xml:6: .*"\\xff\\xfe"'):
        vtkhelios.read_survey(path)


def test_reader_that_fails_without_a_message_raises(make_survey, monkeypatch):
    reader = vtkhelios.vtkHeliosSurveyReader

    class Silent(reader):
        def Read(self):
            return False

    monkeypatch.setattr("vtkhelios.core.reading.vtkHeliosSurveyReader", Silent)
    with pytest.raises(vtkhelios.PipelineError, match="survey.xml: cannot be read"):
        vtkhelios.read_survey(make_survey())


# Names on the command line.


def test_run_and_detect_accept_any_name(command_line, odd_survey):
    output = odd_survey.parent / "out"
    for kind, ending in (("xyz", ".xyz"), ("vtp", ".pvtp")):
        done = command_line(
            *("run", odd_survey, "--assets", odd_survey.parent, "--output", output, "--overwrite"),
            *("--waveforms", "--format", kind),
        )
        assert done.returncode == 0, done.stderr
        assert r"odd\xff\xfe" in done.stdout
        waves = output / f"plane/leg000_fullwave{'.txt' if kind == 'xyz' else '.pvtt'}"
        echoes = odd_survey.parent / f"echoes{ending}"
        done = command_line("detect", waves, "-o", echoes, "--pulse-length", "4")
        assert done.returncode == 0, done.stderr
        assert echoes.stat().st_size > 0
    done = command_line("run", odd_survey, "--output", output, "--json", "--overwrite")
    assert json.loads(done.stdout)["totals"]["points"] > 0
    expect_clear(command_line("run", odd_survey, "--output", output))
    expect_clear(command_line("run", odd_survey.parent / "none.xml"))
    expect_clear(command_line("run", odd_survey, "--assets", odd_survey.parent / "none"))


def test_validate_accepts_any_name(command_line, odd_survey):
    assert command_line("validate", odd_survey).returncode == 0
    odd_survey.write_text("<document><survey nme='x'/></document>")
    done = command_line("validate", odd_survey)
    assert done.returncode == 1 and "Traceback" not in done.stderr
    assert r"odd\xff\xfe/odd\xff\xfe.xml:1: error: " in done.stdout
    found = json.loads(command_line("validate", odd_survey, "--json").stdout)
    assert found[0]["file"].endswith(r"odd\xff\xfe.xml")


def test_info_accepts_any_name(command_line, odd_survey):
    done = command_line("info", odd_survey)
    assert done.returncode == 0 and r"odd\xff\xfe.xml" in done.stdout
    expect_clear(command_line("info", odd_survey.parent / "none.las"))


@pytest.fixture
def expect_done_or_clear(capsys):
    """Runs a command line; it works, or one clear error gives the reason."""

    def call(*arguments):
        capsys.readouterr()
        code = cli.main([*map(str, arguments)])
        error = capsys.readouterr().err
        if code and "pip install" not in error:
            assert code == 1 and error.startswith("error: ") and error.count("error") == 1, error
            assert r"odd\xff\xfe" in error and error.count("\n") == 1

    return call


@pytest.mark.parametrize("kind", ["xyz", "las", "vtp"])
def test_points_of_any_name(expect_done_or_clear, small_runs, tmp_path, kind):
    run = tmp_path / ODD
    shutil.copytree(small_runs[kind], run)
    expect_done_or_clear("info", run)
    expect_done_or_clear("report", run, "--quiet")
    expect_done_or_clear("convert", run, run / "a.xyz", "--quiet")


ENDINGS = ("xyz", "las", "laz", "copc.laz", "e57", "ply", "pcd", "vtp", "pvtp")


@pytest.mark.parametrize("ending", ENDINGS)
def test_formats_with_any_name(expect_done_or_clear, small_runs, tmp_path, ending):
    """Written and read; no pieces are left."""
    odd, plain = tmp_path / f"{ODD}.{ending}", tmp_path / f"plain.{ending}"
    cloud = small_runs["las"] / "leg000_points.las"
    expect_done_or_clear("convert", cloud, odd, "--every", "100", "--quiet")
    assert not list(tmp_path.glob("*.part"))
    if cli.main(["convert", str(cloud), str(plain), "--every", "100", "--quiet"]) == 0:
        shutil.copy(plain, odd)
        expect_done_or_clear("info", odd)


def test_plan_refuses_names_that_xml_cannot_store(command_line, odd_survey, tmp_path):
    expect_clear(command_line("plan", odd_survey.parent / "scene.xml", "--output", tmp_path / "p"))
    expect_clear(command_line("plan", tmp_path / "scene.xml", "--output", tmp_path / ODD / "p"))
    assert not (tmp_path / "p").exists() and not (tmp_path / ODD / "p").exists()


@pytest.mark.parametrize("old", [b'id="plane"', b'name="plane"'])
def test_plan_refuses_names_in_files(command_line, make_survey, tmp_path, old):
    path = make_survey()
    path = path if b"name" in old else tmp_path / "scene.xml"
    path.write_bytes(path.read_bytes().replace(old, old[:-1] + b"odd" + BAD + b'"'))
    expect_clear(command_line("plan", path, "--output", tmp_path / "p", "--quiet"))


def test_view_shows_any_name(command_line, tmp_path):
    from vtkhelios.cli import view

    if view.find_viewer() is None:
        pytest.skip("the viewer is not built")
    done = command_line("view", tmp_path / "odd\x1b[31m.las", "--offscreen", "--still", "x.png")
    assert done.returncode and r"odd\x1b[31m.las" in done.stderr and "\x1b" not in done.stderr


def test_names_in_files_are_texts(make_survey, capsys):
    """A survey name in bytes that are not UTF-8."""
    path = make_survey()
    path.write_bytes(path.read_bytes().replace(b'name="plane"', b'name="pl' + BAD + b'ne"'))
    assert vtkhelios.read_survey(path).name == r"pl\xff\xfene"
    assert repr(vtkhelios.read_survey(path)).startswith(r"Survey('pl\\xff\\xfene': ")
    assert cli.main(["info", str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["name"] == r"pl\xff\xfene"
    assert cli.main(["run", str(path), "--dry-run"]) == 0
    assert r"survey   pl\xff\xfene (" in capsys.readouterr().out


def test_python_accepts_any_name(odd_survey, tmp_path):
    survey = vtkhelios.read_survey(odd_survey, assets=odd_survey.parent)
    report = survey.run_to(tmp_path / ODD / "out")
    assert report["folder"] == tmp_path / ODD / "out/plane"
    assert (report["folder"] / "leg000_points.xyz").stat().st_size > 0
    cloud = survey.run()
    for ending in ("las", "vtp"):
        cloud.write(tmp_path / ODD / f"cloud.{ending}")
        assert (tmp_path / ODD / f"cloud.{ending}").stat().st_size > 0
    vtkhelios.Scene([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]).write(tmp_path / ODD / "s.obj")
    assert (tmp_path / ODD / "s.obj").stat().st_size > 0


# Terminal output.


@pytest.mark.parametrize(
    "text, encoding, shown",
    [
        ("a\x1b]0;title\x07\rb\tc\nd", "utf-8", "a\\x1b]0;title\\x07\\rb\tc\nd"),
        ("\x9b31m\u202etxt\x7f", "utf-8", "\\x9b31m\\u202etxt\\x7f"),
        (ODD, "utf-8", r"odd\xff\xfe"),
        ("µm\ud800", "utf-8", "µm\\ud800"),
        ("µm", "ascii", r"\xb5m"),
    ],
)
def test_visible(text, encoding, shown):
    assert visible(text, encoding) == shown
    assert visible(shown, encoding) == shown


def test_contents_of_files_are_escaped(command_line, make_survey):
    path = make_survey()
    text = path.read_text()
    path.write_text(text.replace('pulseFreq_hz="100000"', 'pulseFreq_hz="\x7f\u202e\u009b31m"'))
    for command in (["run"], ["validate"], ["info"]):
        done = command_line(*command, path)
        assert done.returncode == 1
        assert r"\x7f\u202e\x9b31m" in done.stdout + done.stderr
        assert not set("\x7f\u202e\x9b") & set(done.stdout + done.stderr)
    path.write_text(text.replace('name="plane"', 'name="plane\u009b31m"'))
    done = command_line("info", path)
    assert done.returncode == 0 and r"plane\x9b31m" in done.stdout


def test_characters_missing_in_the_terminal_encoding(make_survey):
    """A terminal with another encoding: text is escaped, nothing raises."""
    environment = {**os.environ, "PYTHONPATH": ":".join(sys.path), "PYTHONIOENCODING": "ascii"}
    done = subprocess.run(
        [
            sys.executable,
            "-P",
            "-m",
            "vtkhelios",
            "run",
            make_survey(),
            "--dry-run",
            "--assets",
            "µ",
        ],
        capture_output=True,
        env=environment,
    )
    assert done.returncode == 1 and rb"--assets \xb5: no such folder" in done.stderr
    assert done.stderr.isascii() and b"Traceback" not in done.stderr
