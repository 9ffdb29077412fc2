# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages that differ only by a channel or part are one line with their count."""

import warnings

import pytest
from vtkmodules.vtkCommonCore import vtkOutputWindow

from vtkhelios import cli
from vtkhelios.core.pipeline import MessageLog, PipelineError, SimilarMessages, conclude
from vtkhelios.cli._messages import Messages
from vtkhelios.reports.options import describe_options

CHANNELS = "".join(f'<channel id="{i}"/>' for i in range(4))
SCANNERS = f"""\
<document>
  <scanner id="many" pulseLength_ns="5" beamDivergence_rad="0.0005" optics="rotating">
    <channels>{CHANNELS}</channels>
  </scanner>
</document>
"""
SURVEY = """\
<document>
  <survey name="s" scene="scene.xml#s" platform="platforms.xml#tripod" scanner="many.xml#many">
    <leg>
      <platformSettings z="2"/>
      <scannerSettings pulseFreq_hz="100000" scanFreq_hz="100" verticalAngleMin_deg="-40"
        verticalAngleMax_deg="60" headRotatePerSec_deg="10" headRotateStop_deg="1"/>
    </leg>
  </survey>
</document>
"""
SCENE = """\
<document>
  <scene id="s">
    <part><filter type="objloader"><param key="filepath" value="ground.obj"/></filter></part>
  </scene>
</document>
"""


@pytest.fixture
def survey(tmp_path):
    """A survey by a scanner of four channels whose mirror does not sweep."""
    (tmp_path / "many.xml").write_text(SCANNERS)
    (tmp_path / "scene.xml").write_text(SCENE)
    (tmp_path / "ground.obj").write_text("v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\n")
    (tmp_path / "survey.xml").write_text(SURVEY)
    return tmp_path / "survey.xml"


def test_similar_messages():
    merge = SimilarMessages.merge
    texts = [f"a.xml:7: scanner vlp, channel {i}: no pulse frequency" for i in range(3)]
    assert merge(texts) == [f"{texts[0]} (and 2 more channels)"]
    assert merge(texts[:2]) == [f"{texts[0]} (and 1 more channel)"]
    assert merge([texts[0]] * 3) == [texts[0]]
    parts = [f'b.xml:{i}: part "oak {i}" is not above ground' for i in (4, 9)]
    assert merge([*texts, "other", *parts]) == [
        f"{texts[0]} (and 2 more channels)", "other", f"{parts[0]} (and 1 more part)",
    ]  # fmt: skip
    assert merge([texts[0], texts[1] + "!"]) == [texts[0], texts[1] + "!"]
    assert merge(["a.xml:1: wrong", "a.xml:2: wrong"]) == ["a.xml:1: wrong", "a.xml:2: wrong"]
    assert merge(["a.xml:1: part a", "c.xml:1: part a"]) == ["a.xml:1: part a", "c.xml:1: part a"]


def test_errors_of_a_pipeline():
    log = MessageLog()
    log.warnings += [f"part {i} is flat" for i in range(3)]
    log.errors += [f"channel {i} is blind" for i in range(3)]
    with warnings.catch_warnings(record=True) as caught, pytest.raises(PipelineError) as error:
        warnings.simplefilter("always")
        conclude(log)
    assert [str(each.message) for each in caught] == ["part 0 is flat (and 2 more parts)"]
    assert error.value.messages == ["channel 0 is blind (and 2 more channels)"]


@pytest.mark.parametrize("command", ["run", "validate", "info"])
def test_channels(survey, capsys, command):
    assert cli.main([command, str(survey)]) == 1
    out, err = capsys.readouterr()
    lines = [line for line in (out + err).splitlines() if "scanAngleMax_deg is missing" in line]
    assert len(lines) == 1 and lines[0].endswith("(and 3 more channels)")


def test_messages_are_held_until_the_next_output(capsys):
    with Messages() as messages:
        window = vtkOutputWindow.GetInstance()
        for part in ("a", "b", "b"):
            window.DisplayWarningText(f"part {part} is flat")
        assert capsys.readouterr().err == ""
        window.DisplayErrorText("channel 0 is blind")
        assert capsys.readouterr().err == "warning: part a is flat (and 1 more part)\n"
        window.DisplayErrorText("channel 1 is blind")
        assert messages.errors == 1
        messages.info("result")
        window.DisplayErrorText("at once")
        window.DisplayErrorText("at once")
        window.DisplayErrorText("part c is empty")
    printed = capsys.readouterr()
    assert printed.out == "result\n"
    assert printed.err.splitlines() == [
        "error: channel 0 is blind (and 1 more channel)", "error: at once", "error: part c is empty",
    ]  # fmt: skip


def test_options_in_words():
    options = {
        "seed": 7, "noise": False, "rangeTolerance_m": 0.0025, "energyTolerance": 0.02, "subRays": 0,
        "binSize_ns": 0.25, "format": "las", "pulseStep": 10, "pulsesPerBlock": 262144,
        "waveforms": True, "pulses": False, "detector": "", "new": 1,
    }  # fmt: skip
    assert describe_options(options) == [
        ("format", "LAS 1.4 (.las)"), ("range tolerance", "2.5 mm"), ("energy tolerance", "2 %"),
        ("waveform bins", "0.25 ns"), ("seed of random numbers", "7"), ("noise", "off"),
        ("pulses computed", "one of 10"), ("waveforms", "written"), ("pulses per block", "262,144"),
        ("new", "1"),
    ]  # fmt: skip
