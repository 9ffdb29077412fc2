# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A fit as a scanner, a survey and trajectories that ``vtkhelios run`` flies."""

import pathlib

import numpy as np

from ..core.files import write_files
from ..core.paths import to_vtk
from ..surveys.instruments import scanner_text
from ..surveys.scanning import make_survey
from ._mirror import OSCILLATING, ROTATING

MARGIN = 0.5  # margin of the ground over its half width
PLATFORM = "platforms.xml#airplane_linearpath"


#: Patterns of the names of all files that may be written.
FILES = ("survey.xml", "scanner.xml", "ground.obj", "strip[0-9][0-9][0-9]*.csv")


def write_fit(fit, folder, scene, **more):
    """Writes all files, and more texts by name, into a folder, which is created; returns their paths."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    texts = {
        "scanner.xml": scanner_text("fitted", scanner_values(fit), " Written by vtkhelios fit. ")
    }
    for strip in fit.strips:
        texts[trajectory_name(strip)] = trajectory_text(strip)
    if scene is None:
        texts["ground.obj"] = ground_text(fit)
    paths = write_files(folder, texts | {name: text + "\n" for name, text in more.items()})
    return [write_survey(fit, folder, scene or folder / "ground.obj"), *paths]


def write_survey(fit, folder, scene):
    """Writes the survey that flies the trajectories in a folder; returns its path."""
    first = folder / trajectory_name(fit.strips[0])
    legs = [leg_values(fit, strip, folder) for strip in fit.strips]
    survey = make_survey(
        None, legs, "scanner.xml#fitted", PLATFORM, "fitted", [folder], trajectory=first
    )
    survey.vtk.SetSources(to_vtk(scene), "", "")
    survey.write(folder / "survey.xml")
    return folder / "survey.xml"


def _known(fit, name):
    """Returns the number of a value, or None."""
    return next(
        (each.value for each in fit.values if each.name == name and each.strip is None), None
    )


def kind_of(fit):
    return fit["mirror"].text


def scanner_values(fit):
    """Returns the attributes of the scanner, as far as they are known, and their sources."""
    kind = kind_of(fit)
    attributes = {"name": f"Fitted to {fit.name}", "use": "airborne", "optics": kind}
    attributes["pulseFreqs_Hz"] = f"{_known(fit, 'pulse frequency'):.10g}"
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
    sources = [
        {"kind": "derived", "note": f"{each.name}: {each.how}"}
        for each in fit.values
        if each.strip is None
    ]
    return {**attributes, "sources": {"source": sources}}


def leg_values(fit, strip, folder):
    """Returns the settings of a leg that flies the trajectory of a strip."""
    values = {
        "trajectory": folder / trajectory_name(strip),
        "syncGPSTime": True,
        "teleportToStart": True,
        "tStart": f"{strip.times[0]:.9f}",
        "tEnd": f"{strip.times[-1]:.9f}",
        "pulse_frequency": f"{_known(fit, 'pulse frequency'):.10g}",
        "scan_frequency": f"{_known(fit, 'line frequency'):.10g}",
    }
    if kind_of(fit) == ROTATING:
        ends = ("smallest angle", "largest angle")
        return {**values, "vertical": [f"{_known(fit, name):.6g}" for name in ends]}
    return {**values, "scan_angle": f"{_known(fit, 'scan angle'):.6g}"}


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


def ground_text(fit):
    """Returns a level plane around the points at the height of the ground."""
    low, high = fit.box[0, :2], fit.box[1, :2]
    reach = MARGIN * np.max(high - low) + 10.0
    (x0, y0), (x1, y1) = low - reach, high + reach
    corners = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    return "".join(f"v {x:.3f} {y:.3f} {fit.ground:.3f}\n" for x, y in corners) + "f 1 2 3 4\n"
