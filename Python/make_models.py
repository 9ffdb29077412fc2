# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of Docs/models.md, from what this build registers.

    build/venv/bin/python Python/make_models.py

A test fails when they are out of date.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "Docs/models.md"
MARKS = re.compile(r"(<!-- models: (\w+) -->\n).*?(<!-- models: end -->)", re.S)

# The defaults of the page: an element of the dialect and its attributes.
DEFAULTS = {
    "scanner": (
        "pulseLength_ns", "wavelength_nm", "beamDivergence_rad", "beamDivergenceMinor_rad",
        "averagePower_w", "receiverDiameter_m", "opticalEfficiency", "atmosphericVisibility_km",
        "weather", "receivedEnergyMin_W", "saturation_nW", "deadTime_ns", "mtaZone", "maxNOR",
        "accuracy_m", "detectorNoise_nW", "solarIrradiance_W_m2_nm", "maxSpecularEvents",
    ),
    "FWFSettings": (
        "rangeTolerance_m", "energyTolerance", "beamSampleQuality", "binSize_ns", "pulseShape",
        "echoDetector", "returnSelection", "scatteringOrders",
    ),
}  # fmt: skip
FILES = {"POINTS": "", "TRAJECTORY": "", "WAVEFORMS": "--waveforms", "PULSES": "--pulses",
         "HITS": "--hits"}  # fmt: skip


class Dialect:
    """The sections of the tables of the dialect, by their headings: a text, and rows of cells."""

    def __init__(self, tables):
        self.texts, self.rows = {}, {}
        for section in re.split(r"^### ", tables, flags=re.M)[1:]:
            heading, text, *lines = [line for line in section.split("\n") if line]
            name = re.sub(r"[`<>]|filter ", "", heading)
            rows = [re.split(r" ?\| ?", line)[1:-1] for line in lines[2:] if line[0] == "|"]
            self.texts[name] = text
            self.rows[name] = {row[0].strip("`"): row[1:] for row in rows}

    def choices(self, element, attribute):
        return re.split(", | and ", self.rows[element][attribute][2])


def make_table(titles, rows):
    lines = [titles, ["---"] * len(titles), *rows]
    return "".join(f"| {' | '.join(cells)} |\n".replace("|  |", "| |") for cells in lines)


def brief(cls):
    """Returns a class's description, by the first sentence of its documentation."""
    return " ".join(cls.__doc__.split("\n\n")[0].split()).partition(" - ")[2]


def make_loaders(dialect):
    from vtkhelios.formats import _endings

    endings = {}
    for ending in _endings.list_endings():
        endings.setdefault(_endings.describe(ending)[-1].strip("`"), []).append(f"`{ending}`")
    loaders = [name for name in dialect.choices("filter", "type") if name in endings]
    rows = [[f"`{name}`", ", ".join(endings[name]), dialect.texts[name]] for name in loaders]
    return make_table(["loader", "endings", "what it reads"], rows)


def make_optics(dialect):
    rows = []
    for name in dialect.choices("scanner", "optics"):
        own = [
            f"`{attribute}`"
            for attribute, cells in dialect.rows["scanner"].items()
            if re.match(rf"(?:\w+, )*{name}\b[^:]*:", cells[-1])
        ]
        rows.append([f"`{name}`", ", ".join(own)])
    return make_table(["`optics`", "its own attributes"], rows)


def make_deflectors(dialect):
    import vtkhelios

    classes = sorted(vtkhelios.vtkHeliosBeamDeflector.__subclasses__(), key=lambda c: c.__name__)
    rows = [[f"`{cls.__name__}`", brief(cls)] for cls in classes]
    return make_table(["deflector", "what it is"], rows)


def make_detectors(dialect):
    import vtkhelios

    factory = vtkhelios.vtkHeliosEchoDetection
    rows = []
    for index in range(factory.GetNumberOfDetectors()):
        name = factory.GetDetectorName(index)
        detector = factory.MakeDetector(name)
        rows.append([f"`{name}`", f"`{detector.GetClassName()}`", brief(type(detector))])
    return make_table(["`echoDetector`", "class", "an echo"], rows)


def make_platforms(dialect):
    types = [*dialect.choices("platform", "type"), "interpolated"]
    return f"Types of platforms: {', '.join(f'`{name}`' for name in types)}.\n"


def make_files(dialect):
    from vtkhelios.core import run_files

    rows = []
    for kind, option in FILES.items():
        number = getattr(run_files.Files, kind)
        names = [f"`{run_files.file_of_leg(0, number, name)}`" for name in run_files.FORMATS]
        rows.append([kind.lower(), f"`{option}`" if option else "always", *names])
    formats = [f"`--format {name}`" for name in run_files.FORMATS]
    return make_table(["files of a leg", "written", *formats], rows)


def make_defaults(dialect):
    rows = []
    for element, attributes in DEFAULTS.items():
        for name in attributes:
            _, unit, _, default, _, text = dialect.rows[element][name]
            rows.append([f"`<{element}>`", f"`{name}`", default, unit, text])
    return make_table(["element", "attribute", "default", "unit", "what it is"], rows)


def make_page(text):
    """The text of the page with the tables of today."""
    import vtkhelios

    dialect = Dialect(vtkhelios.vtkHeliosDialect.GetTables())
    return MARKS.sub(
        lambda found: found[1] + globals()[f"make_{found[2]}"](dialect) + found[3], text
    )


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT / "build/lib/python3/dist-packages"))
    PAGE.write_text(make_page(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
