#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the spectra of Data/Assets/spectra, and the table of their README: models and published levels, no
measured files.

    python3 make_spectra.py [FOLDER]      (default: the folder spectra beside this program)

Needs numpy. The same bytes on every run.

Sources:
  Curran 1989        Remote Sensing of Environment 30, 271: absorption features of foliar chemistry
  Elvidge 1990       International Journal of Remote Sensing 11, 1775: dry plant materials
  Fresnel            reflection at normal incidence, ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2)
  Hale, Querry 1973  Applied Optics 12, 555: n and k of water
  Herold et al. 2004 IEEE Transactions on Geoscience and Remote Sensing 42, 1907: urban materials
  Jacquemoud, Baret 1990  Remote Sensing of Environment 34, 75: PROSPECT, the model of a leaf as plates
  Kokhanovsky, Zege 2004  Applied Optics 43, 1589: reflection of snow, weakly absorbing
  Kou et al. 1993    Applied Optics 32, 3531: k of water and ice in the near infrared
  Rakic et al. 1998  Applied Optics 37, 5271, tables 1 and 2: Lorentz-Drude models of metals
  Stoner, Baumgardner 1981  Soil Science Society of America Journal 45, 1161: kinds of soil spectra
  Warren, Brandt 2008     Journal of Geophysical Research 113, D14220: k of ice
"""

import pathlib
import sys

import numpy as np

WAVELENGTHS = np.round(np.arange(0.35, 2.5001, 0.01), 2)  # [um]
LINES_NM = (532, 905, 1064, 1550)  # wavelengths of common scanners


def interpolate(table):
    """Linear between (wavelength [um], value) pairs."""
    x, y = np.array(table).T
    return np.interp(WAVELENGTHS, x, y)


def interpolate_log(table):
    """Interpolates like interpolate(), in the logarithm."""
    return np.exp(interpolate([(x, np.log(y)) for x, y in table]))


def gaussians(*features):
    """A sum of (centre [um], width [um], height)."""
    return sum(h * np.exp(-0.5 * ((WAVELENGTHS - c) / w) ** 2) for c, w, h in features)


# --- metals and water: Fresnel ---------------------------------------------------------------------------------------


def fresnel(index):
    return np.abs((index - 1.0) / (index + 1.0)) ** 2


def lorentz_drude(plasma, strengths, widths, positions):
    """The reflectance of a metal from the oscillators of Rakic et al. 1998 [eV]."""
    energy = 1.2398419843 / WAVELENGTHS
    epsilon = np.ones_like(energy, dtype=complex)
    for f, gamma, position in zip(strengths, widths, positions):
        epsilon += f * plasma**2 / (position**2 - energy**2 - 1j * energy * gamma)
    return fresnel(np.sqrt(epsilon))


def aluminum():
    return lorentz_drude(
        14.98,
        (0.523, 0.227, 0.050, 0.166, 0.030),
        (0.047, 0.333, 0.312, 1.351, 3.382),
        (0.0, 0.162, 1.544, 1.808, 3.473),
    )


def copper():
    return lorentz_drude(
        10.83,
        (0.575, 0.061, 0.104, 0.723, 0.638),
        (0.030, 0.378, 1.056, 3.213, 4.305),
        (0.0, 0.291, 2.957, 5.300, 11.18),
    )


def water():
    return fresnel(
        interpolate(
            [
                (0.35, 1.343),
                (0.5, 1.335),
                (0.7, 1.331),
                (1.0, 1.327),
                (1.2, 1.324),
                (1.4, 1.321),
                (1.6, 1.317),
                (1.8, 1.312),
                (2.0, 1.306),
                (2.2, 1.296),
                (2.4, 1.279),
                (2.6, 1.242),
            ]
        )
    )


# --- snow ------------------------------------------------------------------------------------------------------------

K_ICE = [
    (0.35, 2.0e-11),
    (0.40, 2.4e-11),
    (0.45, 9.2e-11),
    (0.50, 5.9e-10),
    (0.55, 2.3e-9),
    (0.60, 5.7e-9),
    (0.65, 1.4e-8),
    (0.70, 2.9e-8),
    (0.75, 5.9e-8),
    (0.80, 1.3e-7),
    (0.84, 1.5e-7),
    (0.90, 4.2e-7),
    (0.95, 6.0e-7),
    (1.00, 1.6e-6),
    (1.03, 2.3e-6),
    (1.06, 2.0e-6),
    (1.10, 1.7e-6),
    (1.15, 2.3e-6),
    (1.20, 6.7e-6),
    (1.25, 1.3e-5),
    (1.30, 1.3e-5),
    (1.35, 1.4e-5),
    (1.40, 2.0e-5),
    (1.43, 1.0e-4),
    (1.46, 2.9e-4),
    (1.49, 5.5e-4),
    (1.54, 4.6e-4),
    (1.59, 3.1e-4),
    (1.65, 2.4e-4),
    (1.70, 1.9e-4),
    (1.80, 1.4e-4),
    (1.85, 1.3e-4),
    (1.89, 2.6e-4),
    (1.94, 1.1e-3),
    (2.00, 1.6e-3),
    (2.04, 1.5e-3),
    (2.10, 7.6e-4),
    (2.15, 4.0e-4),
    (2.24, 2.0e-4),
    (2.30, 2.8e-4),
    (2.35, 4.6e-4),
    (2.40, 5.8e-4),
    (2.50, 7.5e-4),
]


def snow(grain=0.4e-3, soot=0.97):
    """exp(-sqrt(13 gamma d)) with gamma = 4 pi k / wavelength, and the grain's diameter d [m]; dust and soot take
    some of the visible. A surface term of Fresnel's keeps it from 0 where ice absorbs most."""
    gamma = 4.0 * np.pi * interpolate_log(K_ICE) / (WAVELENGTHS * 1e-6)
    volume = np.exp(-np.sqrt(13.0 * gamma * grain))
    return soot * volume + 0.018 * (1.0 - volume)


# --- leaves ----------------------------------------------------------------------------------------------------------

# The contents of a leaf absorb light: chlorophylls and carotenoids [cm^2/ug], water [1/cm], dry
# matter [cm^2/g]. Positions and widths are taken from the published features, heights are set so
# that leaves of usual content reflect what is published (Jacquemoud, Baret 1990).
K_PIGMENT = gaussians(
    (0.34, 0.045, 0.055),
    (0.43, 0.036, 0.058),
    (0.48, 0.026, 0.045),
    (0.58, 0.045, 0.011),
    (0.62, 0.022, 0.014),
    (0.65, 0.014, 0.018),
    (0.676, 0.018, 0.052),
)
K_BROWN = np.exp(-(WAVELENGTHS - 0.40) / 0.16)  # relative; of dead leaves
K_WATER = interpolate_log(
    [
        (0.35, 3e-4),
        (0.60, 2.3e-3),
        (0.70, 6e-3),
        (0.75, 0.026),
        (0.80, 0.020),
        (0.85, 0.043),
        (0.90, 0.068),
        (0.95, 0.39),
        (0.975, 0.45),
        (1.00, 0.36),
        (1.05, 0.15),
        (1.10, 0.18),
        (1.15, 1.0),
        (1.20, 1.25),
        (1.25, 0.95),
        (1.30, 1.1),
        (1.35, 3.0),
        (1.40, 12.4),
        (1.45, 30.0),
        (1.50, 20.0),
        (1.55, 11.0),
        (1.60, 6.7),
        (1.65, 5.7),
        (1.70, 5.7),
        (1.75, 6.6),
        (1.80, 8.0),
        (1.85, 10.5),
        (1.90, 78.0),
        (1.94, 122.0),
        (2.00, 69.0),
        (2.05, 43.0),
        (2.10, 27.0),
        (2.20, 16.5),
        (2.25, 18.0),
        (2.30, 24.0),
        (2.40, 50.0),
        (2.50, 92.0),
    ]
)
K_DRY = interpolate(
    [
        (0.35, 30.0),
        (0.45, 15.0),
        (0.55, 7.0),
        (0.70, 3.0),
        (0.90, 1.7),
        (1.10, 1.7),
        (1.30, 2.8),
        (1.45, 6.0),
        (1.60, 6.5),
        (1.90, 12.0),
        (2.00, 18.0),
        (2.20, 23.0),
        (2.40, 33.0),
        (2.50, 36.0),
    ]
)
K_DRY = K_DRY + gaussians(
    (1.50, 0.035, 2.0), (1.73, 0.025, 4.0), (2.10, 0.045, 6.0), (2.30, 0.035, 6.0)
)
LEAF_INDEX = interpolate(
    [(0.35, 1.51), (0.5, 1.48), (0.8, 1.44), (1.1, 1.42), (1.4, 1.38), (1.9, 1.35), (2.5, 1.30)]
)


def diffuse_transmission(index, widest_deg):
    """Returns the share of diffuse light that enters a surface from a cone, by Fresnel's
    formulas."""
    theta = np.radians((np.arange(200) + 0.5) / 200.0 * widest_deg)[:, None]
    cos_in = np.cos(theta)
    cos_out = np.sqrt(1.0 - (np.sin(theta) / index) ** 2)
    r_s = ((cos_in - index * cos_out) / (cos_in + index * cos_out)) ** 2
    r_p = ((cos_out - index * cos_in) / (cos_out + index * cos_in)) ** 2
    weight = np.sin(2.0 * theta)
    return np.sum((1.0 - 0.5 * (r_s + r_p)) * weight, axis=0) / np.sum(weight)


def plate_transmission(k):
    """Returns the diffuse light through a plate of optical depth k, without its surfaces: 2
    E3(k)."""
    mu = (np.arange(400) + 0.5)[:, None] / 400.0
    return np.mean(2.0 * mu * np.exp(-k / mu), axis=0)


def leaf(layers, pigment, water_cm, dry, brown=0.0, pile=False):
    """A leaf as plates (Jacquemoud, Baret 1990): pigment [ug/cm^2], water [cm], dry matter [g/cm^2]. A pile is so
    many leaves that nothing shines through."""
    depth = (pigment * K_PIGMENT + water_cm * K_WATER + dry * K_DRY + brown * K_BROWN) / layers
    tau = plate_transmission(depth)
    t_in, t_all = diffuse_transmission(LEAF_INDEX, 40.0), diffuse_transmission(LEAF_INDEX, 90.0)
    t_out = t_all / LEAF_INDEX**2
    r_inside = 1.0 - t_out
    echo = 1.0 - (r_inside * tau) ** 2
    top_t = t_in * t_out * tau / echo
    top_r = 1.0 - t_in + r_inside * tau * top_t
    t = t_all * t_out * tau / echo
    r = 1.0 - t_all + r_inside * tau * t
    # Stokes: the same plate over and over.
    root = np.sqrt((1 + r + t) * (1 + r - t) * (1 - r + t) * (1 - r - t))
    a = (1.0 + r**2 - t**2 + root) / (2.0 * r)
    b = ((1.0 - r**2 + t**2 + root) / (2.0 * t)) ** (layers - 1.0)
    below = 1.0 / a if pile else a * (b**2 - 1.0) / (a**2 * b**2 - 1.0)
    return top_r + top_t * below * t / (1.0 - below * r)


# --- levels ----------------------------------------------------------------------------------------------------------

SOIL = [
    (0.35, 0.05),
    (0.40, 0.06),
    (0.50, 0.10),
    (0.60, 0.16),
    (0.70, 0.20),
    (0.80, 0.23),
    (0.90, 0.25),
    (1.06, 0.29),
    (1.30, 0.33),
    (1.38, 0.335),
    (1.42, 0.315),
    (1.55, 0.35),
    (1.80, 0.37),
    (1.87, 0.36),
    (1.93, 0.30),
    (2.05, 0.34),
    (2.13, 0.36),
    (2.21, 0.325),
    (2.27, 0.34),
    (2.50, 0.29),
]
SAND = [
    (0.35, 0.09),
    (0.40, 0.13),
    (0.50, 0.21),
    (0.60, 0.30),
    (0.70, 0.35),
    (0.90, 0.40),
    (1.06, 0.43),
    (1.35, 0.47),
    (1.42, 0.455),
    (1.55, 0.49),
    (1.80, 0.50),
    (1.93, 0.44),
    (2.10, 0.49),
    (2.20, 0.47),
    (2.50, 0.42),
]
ASPHALT = [
    (0.35, 0.06),
    (0.50, 0.10),
    (0.70, 0.13),
    (0.90, 0.15),
    (1.06, 0.16),
    (1.55, 0.19),
    (1.70, 0.19),
    (1.75, 0.185),
    (2.00, 0.20),
    (2.20, 0.20),
    (2.31, 0.17),
    (2.50, 0.16),
]
CONCRETE = [
    (0.35, 0.12),
    (0.45, 0.20),
    (0.55, 0.25),
    (0.70, 0.29),
    (0.90, 0.31),
    (1.06, 0.33),
    (1.35, 0.35),
    (1.42, 0.33),
    (1.55, 0.36),
    (1.80, 0.36),
    (1.94, 0.28),
    (2.10, 0.33),
    (2.20, 0.33),
    (2.34, 0.28),
    (2.50, 0.25),
]
SHINGLE_RED = [
    (0.35, 0.05),
    (0.45, 0.07),
    (0.50, 0.08),
    (0.55, 0.11),
    (0.58, 0.18),
    (0.62, 0.24),
    (0.70, 0.30),
    (0.76, 0.33),
    (0.86, 0.32),
    (0.95, 0.35),
    (1.06, 0.39),
    (1.30, 0.46),
    (1.55, 0.50),
    (1.80, 0.51),
    (1.93, 0.47),
    (2.10, 0.49),
    (2.20, 0.46),
    (2.50, 0.42),
]
SHINGLE_GRAY = [
    (0.35, 0.08),
    (0.45, 0.11),
    (0.53, 0.13),
    (0.70, 0.15),
    (0.90, 0.17),
    (1.06, 0.18),
    (1.30, 0.18),
    (1.55, 0.17),
    (1.90, 0.16),
    (2.20, 0.15),
    (2.34, 0.13),
    (2.50, 0.13),
]
BRICK = [
    (0.35, 0.06),
    (0.45, 0.08),
    (0.50, 0.09),
    (0.55, 0.13),
    (0.58, 0.18),
    (0.62, 0.23),
    (0.70, 0.27),
    (0.76, 0.29),
    (0.86, 0.28),
    (0.95, 0.30),
    (1.06, 0.33),
    (1.30, 0.38),
    (1.55, 0.41),
    (1.80, 0.42),
    (1.93, 0.37),
    (2.10, 0.40),
    (2.20, 0.38),
    (2.50, 0.34),
]
WOOD = [
    (0.35, 0.12),
    (0.40, 0.18),
    (0.50, 0.38),
    (0.60, 0.55),
    (0.70, 0.65),
    (0.80, 0.71),
    (0.90, 0.74),
    (1.06, 0.77),
    (1.13, 0.76),
    (1.20, 0.70),
    (1.28, 0.71),
    (1.36, 0.66),
    (1.45, 0.51),
    (1.50, 0.49),
    (1.55, 0.52),
    (1.65, 0.59),
    (1.73, 0.53),
    (1.83, 0.53),
    (1.93, 0.38),
    (2.00, 0.38),
    (2.10, 0.32),
    (2.20, 0.38),
    (2.27, 0.30),
    (2.34, 0.29),
    (2.50, 0.22),
]
BARK = [
    (0.35, 0.07),
    (0.45, 0.10),
    (0.55, 0.15),
    (0.65, 0.20),
    (0.75, 0.27),
    (0.90, 0.36),
    (1.06, 0.43),
    (1.13, 0.45),
    (1.20, 0.44),
    (1.30, 0.47),
    (1.45, 0.38),
    (1.50, 0.38),
    (1.55, 0.40),
    (1.66, 0.44),
    (1.73, 0.41),
    (1.83, 0.42),
    (1.93, 0.30),
    (2.00, 0.31),
    (2.10, 0.27),
    (2.20, 0.31),
    (2.31, 0.24),
    (2.50, 0.19),
]

# name: (what it is, how it was made and from which sources, how far to trust it, reflectance)
SPECTRA = {
    "aluminum": (
        "Aluminium, clean and smooth",
        "Fresnel with the Lorentz-Drude model of Rakic et al. 1998",
        "+-3 % for the clean metal; weathered or rough sheets reflect 10 to 30 % less, and not diffusely",
        aluminum,
    ),
    "copper": (
        "Copper, clean and smooth",
        "Fresnel with the Lorentz-Drude model of Rakic et al. 1998",
        "+-3 % beyond 0.65 um, +-20 % near its edge at 0.57 um and below, as the model is; brown or green "
        "patina reflects far less",
        copper,
    ),
    "water": (
        "Water, clear and deep, at normal incidence",
        "Fresnel with n of Hale and Querry 1973",
        "+-3 % for a still surface; what comes out of turbid or shallow water is not in it",
        water,
    ),
    "snow": (
        "Snow, settled, grains of 0.4 mm",
        "Kokhanovsky and Zege 2004 with k of ice by Warren and Brandt 2008, "
        "rounded; 3 % of the visible lost to impurities, 1.8 % reflected by the surface",
        "+-3 % below 0.8 um, +-15 % to 1.3 um, +-50 % of the low values beyond: new snow is brighter, old darker",
        snow,
    ),
    "deciduous": (
        "A green broad leaf",
        "model of plates of Jacquemoud and Baret 1990: 1.6 layers, pigments 42 ug/cm2, "
        "water 0.011 cm, dry matter 0.005 g/cm2; water by Hale and Querry 1973 and Kou et al. 1993",
        "+-20 %: leaves differ by kind and season",
        lambda: leaf(1.6, 42.0, 0.011, 0.005),
    ),
    "conifer": (
        "Needles of a conifer, as a twig",
        "model of plates of Jacquemoud and Baret 1990: 2.0 layers, pigments "
        "55 ug/cm2, water 0.025 cm, dry matter 0.015 g/cm2; 0.85 of it for the shade between needles",
        "+-25 %",
        lambda: 0.85 * leaf(2.0, 55.0, 0.025, 0.015),
    ),
    "grass": (
        "Living turf, seen from above",
        "model of plates of Jacquemoud and Baret 1990, leaves over leaves: 1.5 "
        "layers, pigments 35 ug/cm2, water 0.012 cm, dry matter 0.004 g/cm2; 0.68 of it for shade and gaps",
        "+-20 %",
        lambda: 0.68 * leaf(1.5, 35.0, 0.012, 0.004, pile=True),
    ),
    "grass_dry": (
        "Dry grass, standing",
        "model of plates of Jacquemoud and Baret 1990, leaves over leaves: 1.8 layers, "
        "no chlorophyll, water 0.0005 cm, dry matter 0.005 g/cm2, brown pigments; 0.66 of it for shade and "
        "gaps; shape and levels after Elvidge 1990",
        "+-25 %",
        lambda: 0.66 * leaf(1.8, 0.0, 0.0005, 0.005, brown=0.9, pile=True),
    ),
    "wood": (
        "Softwood, planed and dry",
        "linear between typical levels; features of cellulose and lignin after "
        "Elvidge 1990 and Curran 1989",
        "+-20 %; grey, weathered wood: half of it below 0.8 um",
        WOOD,
    ),
    "bark": (
        "Bark of trees",
        "linear between typical levels after Elvidge 1990",
        "+-35 %: from beech to pine",
        BARK,
    ),
    "soil": (
        "Bare loam, dry",
        "linear between levels after the kinds of Stoner and Baumgardner 1981",
        "+-35 %; wet soil: half of it",
        SOIL,
    ),
    "sand": (
        "Quartz sand, dry",
        "linear between typical levels",
        "+-25 %; wet sand: half of it",
        SAND,
    ),
    "asphalt": (
        "Asphalt of a road, some years old",
        "linear between levels after Herold et al. 2004",
        "+-35 %: new asphalt half of it, old asphalt up to 1.5 of it",
        ASPHALT,
    ),
    "concrete": (
        "Concrete, weathered",
        "linear between levels after Herold et al. 2004",
        "+-25 %",
        CONCRETE,
    ),
    "brick": ("Red brick", "linear between typical levels; iron oxide at 0.86 um", "+-25 %", BRICK),
    "shingle_red": (
        "Red clay tile",
        "linear between levels after Herold et al. 2004; iron oxide at 0.86 um",
        "+-25 %",
        SHINGLE_RED,
    ),
    "shingle_gray": (
        "Gray shingle: slate or bitumen",
        "linear between typical levels after Herold et al. 2004",
        "+-30 %",
        SHINGLE_GRAY,
    ),
}

README = """# Spectra

Reflectance spectra, 0.35 to 2.5 um, for scene materials: `helios_spectra NAME` in an MTL file selects `NAME.txt` if no
reflectance is given; its value at the wavelength of the scanner is used. `../make_spectra.py` writes them and this page
from physical models and published levels; no file of a spectral library was used. Each file states its derivation, its
sources and its uncertainty; most levels are typical ones. For work that depends on reflectance put measured spectra
(ECOSTRESS, USGS; text of two columns, um and percent) into a folder `spectra` of your own asset directory.

Values are hemispherical reflectances; a scanner uses them as diffuse. Metals and still water are specular: their returns
depend on the orientation, and their spectra are upper or lower bounds.

| name | what | 532 nm | 905 nm | 1064 nm | 1550 nm | uncertainty, relative |
|---|---|---|---|---|---|---|
"""


def make(source):
    """The reflectance of a model or of levels, in percent."""
    return 100.0 * np.clip(source() if callable(source) else interpolate(source), 0.0, 1.0)


def write(path, what, how, trust, values):
    lines = [
        f"{what}. Reflectance [percent] over the wavelength [um].",
        f"Made by make_spectra.py of vtkHelios: {how}.",
        f"Trust, of the value: {trust}.",
        "",
    ]
    lines += [f"{x:.2f}\t{y:.3f}" for x, y in zip(WAVELENGTHS, values)]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def main():
    folder = (
        pathlib.Path(sys.argv[1])
        if len(sys.argv) > 1
        else pathlib.Path(__file__).absolute().parent / "spectra"
    )
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for name, (what, how, trust, source) in sorted(SPECTRA.items()):
        values = make(source)
        write(folder / f"{name}.txt", what, how, trust, values)
        levels = " | ".join(
            f"{y:.1f}" for y in np.interp([x / 1000 for x in LINES_NM], WAVELENGTHS, values)
        )
        rows.append(f"| {name} | {what} | {levels} | {trust} |\n")
    (folder / "README.md").write_text(README + "".join(rows), encoding="ascii")


if __name__ == "__main__":
    main()
