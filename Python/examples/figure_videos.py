# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Films and stills of four surveys, one of each kind of platform, as the paper's figure 3 has them.

    build/venv/bin/python Python/examples/figure_videos.py OUT [SECONDS]

A multicopter, an aeroplane, a tripod and a car scan the village; the viewer films each for SECONDS (default: 8) with
the camera that suits it, and takes a still of it half way. OUT gets village_*.ogv and village_*.png.
Without a display it draws on one of its own (xvfb-run).
"""

import os
import pathlib
import subprocess
import sys

import vtkhelios
from vtkhelios.cli import view

# Survey, when its still is taken [share of its time is half], camera, colours.
FILMS = [
    ("village_uls", "follow", "height"),
    ("village_als", "free", "height"),
    ("village_tls", "orbit", "amplitude"),
    ("village_mls", "follow", "incidence"),
]
SIZE = "960x600"


def make_scene(folder):
    """The village, unless it is there."""
    if not (folder / "village_scene.xml").exists():
        maker = vtkhelios.data_directory() / "Scenes" / "make_village.py"
        subprocess.run([sys.executable, maker, folder], check=True)


def show(survey, scene, *arguments):
    """Runs the viewer on a survey."""
    path = vtkhelios.data_directory() / "Surveys" / f"{survey}.xml"
    words = [str(path), "--assets", str(scene), "--offscreen", "--size", SIZE, *arguments]
    subprocess.run(view.command(view.find_viewer(), words, os.environ), check=True)


def film(survey, camera, colors, scene, out, seconds):
    look = ["--camera", camera, "--color-by", colors]
    video = out / f"{survey}.ogv"
    show(survey, scene, *look, "--record", str(video), "--seconds", f"{seconds:g}")
    show(survey, scene, *look, "--still", str(out / f"{survey}.png"))
    return video


def main(arguments):
    if not 1 <= len(arguments) <= 2:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    out = pathlib.Path(arguments[0])
    seconds = float(arguments[1]) if len(arguments) == 2 else 8.0
    scene = out / "scene"
    scene.mkdir(parents=True, exist_ok=True)
    make_scene(scene)
    for survey, camera, colors in FILMS:
        print(film(survey, camera, colors, scene, out, seconds))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
