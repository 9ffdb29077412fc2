# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys made by hand: a scanner of the catalogue, placed in a scene.

>>> cloud = vtkhelios.scan(scene, position=(0, 0), head=(0, 360), head_speed=60,
                        scan_frequency=100)
"""

import pathlib
import re
import warnings

from ._pipeline import PipelineError
from .scene import Scene
from .survey import check_options, read_survey

__all__ = ["make_survey", "scan"]

# Leg settings, their XML attributes, and how they are written.
_PLATFORM = {
    "speed": "movePerSec_m",
    "stop_and_turn": "stopAndTurn",
    "smooth_turn": "smoothTurn",
    "yaw_at_departure": "yawAtDeparture_deg",
}
_SCANNER = {
    "active": "active",
    "pulse_frequency": "pulseFreq_hz",
    "scan_frequency": "scanFreq_hz",
    "scan_angle": "scanAngle_deg",
    "vertical": ("verticalAngleMin_deg", "verticalAngleMax_deg"),
    "head": ("headRotateStart_deg", "headRotateStop_deg"),
    "head_speed": "headRotatePerSec_deg",
    "beam_divergence": "beamDivergence_rad",
    "duration": "maxDuration_s",
    "vertical_resolution": "verticalResolution_deg",
    "horizontal_resolution": "horizontalResolution_deg",
}
_SURVEY = """\
<document>
  <scene id="scene">
    <part><filter type="objloader"><param type="string" key="filepath" value={obj}/></filter></part>
  </scene>
  <survey name={name} scene="#scene" platform={platform} scanner={scanner}>
{legs}
  </survey>
</document>
"""
_LINES_BEFORE_LEGS = 1 + _SURVEY[: _SURVEY.index("{legs}")].count("\n")
_LEG = "    <leg><platformSettings{}/><scannerSettings{}/></leg>"


def make_survey(
    scene,
    legs,
    scanner="vz400_class_tls",
    platform="tripod",
    name="survey",
    assets=(),
    **settings,
):
    """A survey (a Survey) of a scene, without user files.

    scene
        a Scene, a vtkPolyData of triangles, or an algorithm that makes one.
    legs
        a dictionary each, or only a position. ``position``: x, y on the ground below, or
        x, y, z [m]. On a moving platform a leg extends to the position of the next,
        and the last one is the end point. Its settings:
        speed [m/s], stop_and_turn, smooth_turn, yaw_at_departure [deg]; active,
        pulse_frequency [Hz], scan_frequency [lines/s], scan_angle [deg, half],
        vertical=(lowest, highest) [deg], head=(start, stop) [deg], head_speed [deg/s],
        vertical_resolution, horizontal_resolution [deg], beam_divergence [rad],
        duration [s].
    settings
        defaults for all legs.
    scanner, platform
        ids in the catalogue, or "file.xml#id" to be found in the folders of assets.

    Internally scene and survey are stored in a temporary folder, deleted with them. Raises
    PipelineError with the errors.
    """
    scene = scene if isinstance(scene, Scene) else Scene(scene)
    text = _SURVEY.format(
        obj=_quoted(str(scene.save_for_surveys())),
        name=_quoted(name),
        platform=_quoted(_reference("platforms.xml", platform)),
        scanner=_quoted(_reference("scanners.xml", scanner)),
        legs="\n".join(_leg(leg, settings) for leg in legs),
    )
    import tempfile

    folder = tempfile.TemporaryDirectory(prefix="vtkhelios-")
    path = pathlib.Path(folder.name) / "survey.xml"
    path.write_text(text, encoding="utf-8")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            survey = read_survey(path, assets)
        except PipelineError as error:
            raise PipelineError([_by_hand(message, path) for message in error.messages]) from None
    for warning in caught:
        warnings.warn(_by_hand(str(warning.message), path), warning.category, stacklevel=2)
    survey.path = None
    survey.keeps = (scene, scene.save_for_surveys(), folder)  # as long as it may be run
    return survey


def scan(
    scene, position=None, path=None, scanner="vz400_class_tls", platform=None, assets=(), **more
):
    """Places a scanner in a scene and returns its echoes as a Cloud.

    It is at a position (on a tripod), or moves along a path of positions (on "copter_linearpath").
    ``more`` are the settings of a leg, see make_survey(), and the options of Survey.run():
    progress, waveforms, noise, seed ...
    """
    if (position is None) == (path is None):
        raise TypeError("scan() needs a position (on a tripod), or a path to move along")
    known = {"position", *_PLATFORM, *_SCANNER}
    settings = {name: more.pop(name) for name in list(more) if name in known}
    check_options(more, f"neither a setting of a leg ({', '.join(sorted(known))}) nor of a run")
    platform = platform or ("tripod" if path is None else "copter_linearpath")
    legs = [position] if path is None else path
    survey = make_survey(scene, legs, scanner, platform, "scan", assets, **settings)
    return survey.run(**more)


def _reference(file, name):
    return name if "#" in name else f"{file}#{name}"


def _leg(leg, settings):
    leg = dict(settings, **(leg if isinstance(leg, dict) else {"position": leg}))
    if "position" not in leg:
        raise TypeError("a leg has no position; give x, y, or x, y, z")
    position = tuple(leg.pop("position"))
    if len(position) not in (2, 3):
        raise ValueError(f"position is {position!r}; give x, y, or x, y, z")
    place = dict(zip("xyz", position), onGround=len(position) == 2)
    return _LEG.format(
        _attributes({**place, **_pick(leg, _PLATFORM)}), _attributes(_pick(leg, _SCANNER, leg))
    )


def _pick(leg, known, rest=None):
    """The XML attributes of known settings; with rest, any others there are an error."""
    found = {}
    for name in [name for name in leg if name in known]:
        value, target = leg.pop(name), known[name]
        if isinstance(target, str):
            found[target] = value
        else:
            low, high = value
            found.update(zip(target, (low, high)))
    if rest:
        names = ", ".join(["position", *_PLATFORM, *_SCANNER])
        raise TypeError(f"{next(iter(rest))} is not a setting of a leg; known: {names}")
    return found


def _by_hand(message, path):
    """A message of the reader, with legs and settings instead of lines and attributes."""
    place = re.match(re.escape(str(path)) + r":(\d+): ", message)
    if not place:
        return message
    leg = int(place.group(1)) - _LINES_BEFORE_LEGS
    names = {}
    for name, target in {**_PLATFORM, **_SCANNER}.items():
        targets = (target,) if isinstance(target, str) else target
        names |= {
            key: f"{name}[{i}]" if len(targets) > 1 else name for i, key in enumerate(targets)
        }
    pattern = "|".join(sorted(names, key=len, reverse=True))
    text = re.sub(rf"\b({pattern})\b", lambda found: names[found.group()], message[place.end() :])
    return f"leg {leg}: {text}" if leg >= 0 else text


def _attributes(values):
    return "".join(f" {name}={_quoted(_text(value))}" for name, value in values.items())


def _quoted(text):
    import html

    return f'"{html.escape(text)}"'


def _text(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(float(value))
