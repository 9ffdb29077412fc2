# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cards that images cut return the light of what is left, near and far, once and as instances."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

import vtkhelios
from vtkhelios import cli
from vtkhelios.array_names import AMPLITUDE

SIZE = 128  # pixels of the mask
CARD = """mtllib {name}.mtl
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl leaf
f 1/1 2/2 3/3 4/4
"""
SURVEY = """<document>
<platform id="p" type="static"><scannerMount><rot axis="x" angle_deg="-90"/></scannerMount></platform>
<scanner id="s" optics="rotating" pulseFreqs_Hz="100000" beamDivergence_rad="{divergence}"
 rangeMin_m="1" scanAngleMax_deg="45" scanAngleEffectiveMax_deg="45" scanFreqMin_Hz="1"
 scanFreqMax_Hz="1000" headRotatePerSecMax_deg="360"><headRotateAxis z="1"/></scanner>
<scene id="w">{parts}</scene>
<survey name="leaf" scene="#w" platform="#p" scanner="#s"><leg>
 <platformSettings x="0" y="0" z="{height}"/>
 <scannerSettings pulseFreq_hz="100000" scanFreq_hz="20" verticalAngleMin_deg="-{half}"
  verticalAngleMax_deg="{half}" headRotatePerSec_deg="{speed}" headRotateStart_deg="-{half}"
  headRotateStop_deg="{half}"/></leg></survey></document>"""
PART = """<part id="{name}{i}"><filter type="objloader"><param key="filepath" value="{name}.obj"/></filter>
<filter type="translate"><param type="vec3" key="offset" value="{x};{y};{z}"/></filter></part>"""


def make_mask():
    """A leaf with a hole: 30.0 % of the image, smoothed over a pixel."""
    y, x = (np.mgrid[:SIZE, :SIZE] + 0.5) / SIZE - 0.5
    leaf = 0.3353 - np.hypot(x, 1.12 * y)
    hole = np.hypot(x - 0.1, y) - 0.07
    return np.clip(SIZE * np.minimum(leaf, hole) + 0.5, 0, 1)


def write_png(path, mask):
    image = vtkImageData()
    image.SetDimensions(SIZE, SIZE, 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(np.round(255 * mask).astype(np.uint8).ravel(), deep=True)
    )
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()


@pytest.fixture
def folder(tmp_path):
    write_png(tmp_path / "mask.png", make_mask())
    for name, image in (("cut", "map_d mask.png\n"), ("full", "")):
        (tmp_path / f"{name}.obj").write_text(CARD.format(name=name))
        (tmp_path / f"{name}.mtl").write_text(f"newmtl leaf\nKd 1 1 1\n{image}")
    return tmp_path


def scan(folder, name, places, height, half, divergence):
    """Returns the echoes of cards at places, seen from above."""
    parts = "".join(
        PART.format(name=name, i=i, x=x, y=y, z=z) for i, (x, y, z) in enumerate(places)
    )
    path = folder / "survey.xml"
    path.write_text(
        SURVEY.format(parts=parts, height=height, half=half, divergence=divergence, speed=half / 16)
    )
    return vtkhelios.read_survey(path).run(noise=False, pulses=True)


def energy(*arguments):
    """The echoes of flat cards have one shape: their amplitudes add up to the light returned."""
    return scan(*arguments)[AMPLITUDE].sum()


@pytest.mark.parametrize("places", [[(0, 0, 0)], [(-2, 0, 0), (2, 0, 0), (0, 2.5, 0)]])
@pytest.mark.parametrize("height, divergence", [(40, 3e-4), (400, 3e-4)])
def test_a_card_returns_its_share(folder, places, height, divergence):
    half = np.degrees(np.arctan2(4.5, height))
    cut, full = (energy(folder, name, places, height, half, divergence) for name in ("cut", "full"))
    assert cut / full == pytest.approx((make_mask() > 0.5).mean(), rel=5e-3)


def test_a_card_within_a_beam_returns_its_share(folder):
    """The footprint is 16 m wide: the beam's profile is nearly constant over the card."""
    cut, full = (
        scan(folder, name, [(0, 0, 0)], 10000, 0.01, 1.6e-3)[AMPLITUDE].max()
        for name in ("cut", "full")
    )
    y, x = 2 * ((np.mgrid[:SIZE, :SIZE] + 0.5) / SIZE - 0.5)
    profile = np.exp(-2 * (x**2 + y**2) / 8.0**2)
    share = (profile * (make_mask() > 0.5)).sum() / profile.sum()
    assert cut / full == pytest.approx(share, rel=5e-3)


def test_info_and_validate_name_what_is_cut(folder, capsys):
    scan(
        folder, "cut", [(0, 0, 0), (3, 0, 0)], 40, 1, 3e-4
    )  # the notes of one part are its scene's
    assert cli.main(["info", str(folder / "cut.obj")]) == 0
    share = (make_mask() > 0.5).mean()
    text = f'map_d mask.png of material "leaf" leaves {100 * share:.3g} % of 4 m2: 2 -> '
    assert f"cut out    {text}" in capsys.readouterr().out
    assert cli.main(["validate", "--deep", str(folder / "survey.xml")]) == 0
    assert f"note: {text}" in capsys.readouterr().out
