# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A fit as a scanner, a survey and trajectories that ``vtkhelios run`` flies."""

import pathlib
import xml.sax.saxutils

import numpy as np

from ..core.files import write_files
from ._mirror import OSCILLATING, ROTATING

MARGIN = 0.5  # margin of the ground over its half width
HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n<!-- Written by vtkhelios fit. -->\n'
PLATFORM = "Assets/platforms.xml#airplane_linearpath"


#: Patterns of the names of all files that may be written.
FILES = ("survey.xml", "scanner.xml", "scene.xml", "ground.obj", "strip[0-9][0-9][0-9]*.csv")


def write_fit(fit, folder, scene, **more):
    """Writes all files, and more texts by name, into a folder, which is created; returns their paths."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    texts = {"scanner.xml": scanner_text(fit), "survey.xml": survey_text(fit, scene)}
    for strip in fit.strips:
        texts[trajectory_name(strip)] = trajectory_text(strip)
    if scene is None:
        texts["scene.xml"], texts["ground.obj"] = SCENE, ground_text(fit)
    return write_files(folder, texts | {name: text + "\n" for name, text in more.items()})


def _known(fit, name):
    """Returns the number of a value, or None."""
    return next(
        (each.value for each in fit.values if each.name == name and each.strip is None), None
    )


def _escape(text):
    return xml.sax.saxutils.quoteattr(text)


def kind_of(fit):
    return fit["mirror"].text


def scanner_attributes(fit):
    """Returns the attributes of the scanner, as far as they are known."""
    kind = kind_of(fit)
    attributes = {"optics": kind, "pulseFreqs_Hz": f"{_known(fit, 'pulse frequency'):.10g}"}
    rate = f"{_known(fit, 'line frequency'):.10g}"
    attributes |= {"scanFreqMin_Hz": rate, "scanFreqMax_Hz": rate}
    if kind == ROTATING:
        low, high = _known(fit, "smallest angle"), _known(fit, "largest angle")
        half = max(0.5 * _known(fit, "sweep of a facet"), abs(low), abs(high))
        attributes["scanAngleMax_deg"] = f"{half:.6g}"
        attributes["scanAngleEffectiveMax_deg"] = f"{min(half, max(abs(low), abs(high))):.6g}"
    else:
        attributes["scanAngleMax_deg"] = f"{_known(fit, 'scan angle'):.6g}"
    if kind == OSCILLATING:
        if "sinusoidal" in fit["law of motion"].text:
            attributes["scanPattern"] = "sinusoidal"
        else:
            pulses = _known(fit, "pulse frequency") / _known(fit, "line frequency") / 2
            attributes["turningPulses"] = str(round(pulses * (_known(fit, "turn") or 0.0)))
    for name, value, form in (
        ("accuracy_m", _known(fit, "range noise"), ".3g"),
        ("beamDivergence_rad", _known(fit, "beam divergence"), ".3g"),
        ("pulseLength_ns", _known(fit, "pulse length"), ".3g"),
        ("maxNOR", _known(fit, "returns per pulse, maximum"), ".0f"),
    ):
        if value:
            attributes[name] = format(value, form)
    return attributes


def scanner_text(fit):
    lines = "".join(
        f"\n    {name}={_escape(value)}" for name, value in scanner_attributes(fit).items()
    )
    sources = "".join(
        f'      <source kind="derived" note={_escape(f"{each.name}: {each.how}")}/>\n'
        for each in fit.values if each.strip is None
    )  # fmt: skip
    return (
        f'{HEAD}<document>\n  <scanner id="fitted" name={_escape(f"Fitted to {fit.name}")} '
        f'use="airborne"{lines}>\n    <sources>\n{sources}    </sources>\n  </scanner>\n</document>\n'
    )


def leg_text(fit, strip):
    """Returns a leg that flies the trajectory of a strip."""
    settings = (
        f'pulseFreq_hz="{_known(fit, "pulse frequency"):.10g}" '
        f'scanFreq_hz="{_known(fit, "line frequency"):.10g}"'
    )
    if kind_of(fit) == ROTATING:
        settings += (
            f' verticalAngleMin_deg="{_known(fit, "smallest angle"):.6g}"'
            f' verticalAngleMax_deg="{_known(fit, "largest angle"):.6g}"'
        )
    else:
        settings += f' scanAngle_deg="{_known(fit, "scan angle"):.6g}"'
    name = trajectory_name(strip)
    return (
        f"    <!-- strip {strip.number}: {strip.points} points, {strip.pulses} pulses -->\n"
        f'    <leg>\n      <platformSettings trajectory="{name}" syncGPSTime="true" '
        f'teleportToStart="true"\n          tStart="{strip.times[0]:.9f}" tEnd="{strip.times[-1]:.9f}"/>\n      <scannerSettings {settings}/>\n    </leg>\n'
    )


def survey_text(fit, scene):
    legs = "".join(leg_text(fit, strip) for strip in fit.strips)
    scene = _escape(str(scene or "scene.xml#ground"))
    return (
        f'{HEAD}<document>\n  <survey name="fitted" scene={scene} scanner="scanner.xml#fitted"\n'
        f'      platform="interpolated" basePlatform="{PLATFORM}">\n{legs}  </survey>\n</document>\n'
    )


def trajectory_name(strip):
    return f"strip{strip.number:03d}.csv"


def trajectory_text(strip):
    """Returns the rows t, roll, pitch, yaw [deg], x, y, z."""
    rows = np.column_stack([strip.times, strip.angles, strip.positions])
    lines = "\n".join(
        f"{row[0]:.9f},{row[1]:.6f},{row[2]:.6f},{row[3]:.6f},{row[4]:.4f},{row[5]:.4f},{row[6]:.4f}"
        for row in rows
    )
    return f'#HEADER: "t", "roll", "pitch", "yaw", "x", "y", "z"\n{lines}\n'


SCENE = (
    f'{HEAD}<document>\n  <scene id="ground" name="A level plane">\n    <part id="1">\n'
    '      <filter type="objloader"><param type="string" key="filepath" value="ground.obj"/></filter>\n'
    "    </part>\n  </scene>\n</document>\n"
)


def ground_text(fit):
    """Returns a level plane around the points at the height of the ground."""
    low, high = fit.box[0, :2], fit.box[1, :2]
    reach = MARGIN * np.max(high - low) + 10.0
    (x0, y0), (x1, y1) = low - reach, high + reach
    corners = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    return "".join(f"v {x:.3f} {y:.3f} {fit.ground:.3f}\n" for x, y in corners) + "f 1 2 3 4\n"
