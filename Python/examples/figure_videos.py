# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Videos and stills of four surveys, one per kind of platform, as in the paper's figure 3.

    build/venv/bin/python Python/examples/figure_videos.py OUT [SECONDS]

A multicopter, an aeroplane, a tripod and a car scan the village; the viewer records each for
SECONDS (default: 8) with a suitable camera, and a still of the end. Output: OUT/village_*.ogv and
village_*.png. Without a display it uses its own (Xvfb).
"""

import pathlib
import subprocess
import sys

import vtkhelios

# Survey, camera, colours.
FILMS = [
    ("village_uls", "follow", "height"),
    ("village_als", "free", "height"),
    ("village_tls", "orbit", "amplitude"),
    ("village_mls", "follow", "incidence"),
]


def make_scene(folder):
    """Creates the village if it is missing."""
    if not (folder / "village_scene.xml").exists():
        folder.mkdir(parents=True, exist_ok=True)
        maker = vtkhelios.data_directory() / "Scenes" / "make_village.py"
        subprocess.run([sys.executable, maker, folder], check=True)
    return folder


def show(survey, *arguments):
    """Runs the viewer on a survey, without a window."""
    words = ["view", survey, "--offscreen", *map(str, arguments)]
    subprocess.run([sys.executable, "-P", "-m", "vtkhelios", *words], check=True)


def film(survey, out, seconds, *look):
    """A video of a survey from start to end, and a still of the full view; their paths."""
    video, still = (out / f"{survey.stem}{ending}" for ending in (".ogv", ".png"))
    show(survey, *look, "--record", video, "--seconds", seconds, "--still", still)
    return video, still


def main(arguments):
    if not 1 <= len(arguments) <= 2:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    out = pathlib.Path(arguments[0])
    seconds = float(arguments[1]) if len(arguments) == 2 else 8.0
    scene = make_scene(out / "scene")
    for name, camera, colors in FILMS:
        survey = vtkhelios.data_directory() / "Surveys" / f"{name}.xml"
        look = ["--assets", scene, "--size", "960x600", "--camera", camera, "--color-by", colors]
        print(*film(survey, out, seconds, *look), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
