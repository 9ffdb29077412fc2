# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The spectra of Data/Assets/spectra: complete, plausible, and as made by their program."""

import pathlib
import subprocess
import sys

import numpy as np
import pytest

ASSETS = pathlib.Path(__file__).absolute().parents[2] / "Data" / "Assets"
LINES_NM = (532, 905, 1064, 1550)

# Published values of such surfaces, percent at LINES_NM: lowest and highest.
RANGES = {
    "aluminum": ((88, 94), (84, 92), (92, 97), (95, 99)),
    "asphalt": ((4, 18), (8, 25), (8, 28), (10, 32)),
    "bark": ((6, 25), (20, 50), (25, 60), (25, 55)),
    "brick": ((6, 20), (18, 45), (20, 50), (25, 60)),
    "concrete": ((15, 40), (20, 50), (20, 50), (22, 55)),
    "conifer": ((4, 14), (30, 60), (30, 60), (8, 30)),
    "copper": ((55, 75), (95, 99), (96, 99), (96, 99)),
    "deciduous": ((6, 18), (40, 58), (40, 58), (20, 38)),
    "grass": ((4, 15), (35, 65), (35, 65), (12, 32)),
    "grass_dry": ((7, 25), (25, 50), (30, 60), (25, 50)),
    "sand": ((12, 40), (25, 60), (28, 60), (30, 65)),
    "shingle_gray": ((6, 20), (8, 28), (8, 28), (8, 28)),
    "shingle_red": ((5, 18), (20, 45), (25, 50), (30, 60)),
    "snow": ((90, 100), (70, 92), (55, 82), (1, 12)),
    "soil": ((6, 20), (15, 40), (18, 45), (20, 50)),
    "water": ((1.9, 3.5), (1.8, 2.5), (1.8, 2.5), (1.8, 2.2)),
    "wood": ((25, 60), (55, 85), (60, 92), (40, 65)),
}


def parse(path):
    """The rows of a file, as read by vtkHelios: two numbers; all else is header."""
    rows = []
    for line in path.read_text(encoding="ascii").splitlines():
        try:
            x, y = (float(word) for word in line.replace(",", " ").split())
        except ValueError:
            assert not rows, f"a line among the rows: {line}"
            continue
        rows.append((x, y))
    return np.array(rows)


def read(name):
    return parse(ASSETS / "spectra" / f"{name}.txt")


def at(name, micrometres):
    wavelengths, values = read(name).T
    return np.interp(micrometres, wavelengths, values)


def test_every_spectrum_is_known():
    assert {path.stem for path in (ASSETS / "spectra").glob("*.txt")} == set(RANGES)


@pytest.mark.parametrize("name", RANGES)
def test_file(name):
    wavelengths, values = read(name).T
    assert wavelengths[0] == 0.35 and wavelengths[-1] == 2.5
    assert np.all(np.diff(wavelengths) > 0.0)
    assert np.all((values > 0.0) & (values < 100.0))
    header = (ASSETS / "spectra" / f"{name}.txt").read_text().splitlines()[:3]
    assert (
        "percent" in header[0] and header[1].startswith("Made by") and header[2].startswith("Trust")
    )


@pytest.mark.parametrize("name", RANGES)
def test_levels_equal_published_values(name):
    for line, (low, high) in zip(LINES_NM, RANGES[name]):
        assert low <= at(name, line / 1000.0) <= high, line


def test_metals_reflect():
    for name in ("aluminum", "copper"):
        wavelengths, values = read(name).T
        assert values[wavelengths > 0.9].min() > 85.0
    assert at("copper", 0.65) - at("copper", 0.5) > 20.0  # red
    wavelengths, values = read("aluminum").T
    near = (wavelengths > 0.7) & (wavelengths < 1.0)
    assert wavelengths[near][values[near].argmin()] == pytest.approx(
        0.825, abs=0.03
    )  # the interband dip


@pytest.mark.parametrize("name", ["grass", "deciduous", "conifer"])
def test_leaves_have_a_red_edge_a_green_peak_and_water(name):
    assert at(name, 0.80) > 6.0 * at(name, 0.67)
    assert at(name, 0.55) > 1.5 * max(at(name, 0.45), at(name, 0.67))
    edge = [x for x in np.arange(0.66, 0.80, 0.001) if at(name, x) > 0.5 * at(name, 0.80)][0]
    assert 0.69 <= edge <= 0.73
    assert at(name, 1.45) < 0.6 * at(name, 1.65)
    assert at(name, 1.94) < 0.4 * at(name, 1.65)


def test_dry_grass_has_no_red_edge():
    assert at("grass_dry", 0.80) < 2.5 * at("grass_dry", 0.67)
    assert at("grass_dry", 1.45) > 0.85 * at("grass_dry", 1.65)
    assert at("grass_dry", 2.10) < at("grass_dry", 2.20) + 1.0  # cellulose


def test_snow_is_bright_in_visible_light_and_dark_at_1500_nm():
    assert at("snow", 0.5) > 90.0
    assert at("snow", 1.03) < at("snow", 1.09)
    assert at("snow", 1.5) < 10.0


def test_water_is_dark():
    assert read("water")[:, 1].max() < 4.0
    assert at("water", 0.589) == pytest.approx(
        100.0 * ((1.333 - 1.0) / (1.333 + 1.0)) ** 2, rel=0.02
    )


def test_program_reproduces_the_files(tmp_path):
    subprocess.run([sys.executable, ASSETS / "make_spectra.py", tmp_path], check=True)
    for name in RANGES:
        assert np.allclose(parse(tmp_path / f"{name}.txt"), read(name), atol=0.002), name
    assert (tmp_path / "README.md").read_text() == (ASSETS / "spectra" / "README.md").read_text()
