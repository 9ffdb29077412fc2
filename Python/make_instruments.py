# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Docs/instruments.md from the catalogue of scanners, Data/Assets.

    build/venv/bin/python Python/make_instruments.py

A test fails when the page is out of date.
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "Docs/instruments.md"

HEAD = """\
# The catalogue of scanners

Made by `Python/make_instruments.py` from `Data/Assets`; do not edit. A survey names a scanner by file and id, as in
`scanner="instruments/riegl.xml#riegl_vz400i"`; `vtkhelios.scan()` needs the id only. `vtkhelios list scanners WORDS`
lists them. [Data/Assets](../Data/Assets/README.md) tells how to add one, and what each attribute means.

Each number is followed by the kind of its source:

{kinds}

The beam divergence is the full angle at 1/e², of elliptical beams that of each axis; other definitions are converted. The scan frequency counts lines, oscillations
(two lines each) or revolutions of a cone per second. The field is the whole angle that is scanned, the sweep that of a mirror
facet. The accuracy is one sigma of the range. What a data sheet does not give is assumed: amplitudes compare within an
instrument, not across instruments.

| not in the catalogue | because |
|---|---|
| polygons with unlike facets (RIEGL VUX-120, VUX-160) | their angles have not been looked up; `facetPitches_deg` and `facetRolls_deg` set them |
| photon-counting receivers with arrays of beams (SPL100, Geiger mode) | a pulse has one beam; the receiver itself is modelled (`echoDetector="photonCounting"`) |
"""

COLUMNS = {  # title: attribute, factor
    "pulses [kHz]": ("pulseFreqs_Hz", 1e-3),
    "λ [nm]": ("wavelength_nm", 1),
    "divergence [mrad]": ("beamDivergence_rad", 1e3),
    "pulse [ns]": ("pulseLength_ns", 1),
    "accuracy [mm]": ("accuracy_m", 1e3),
    "range min [m]": ("rangeMin_m", 1),
    "max [m]": ("rangeMax_m", 1),
    "field [°]": ("fieldOfView", 1),
    "sweep [°]": ("sweep", 1),
    "scan min [Hz]": ("scanFreqMin_Hz", 1),
    "max [Hz]": ("scanFreqMax_Hz", 1),
    "aperture [mm]": ("receiverDiameter_m", 1e3),
}
CLASSES = "Classes of instruments"


def make_page():
    """The page as a text."""
    from vtkhelios.catalogue import KINDS, find_scanners

    letters = "\n".join(f"- {kind[0]}: {kind}, {meaning}" for kind, meaning in KINDS.items())
    groups = {}
    for scanner in find_scanners():
        groups.setdefault(scanner.maker or CLASSES, []).append(scanner)
    order = sorted(groups, key=lambda maker: (maker == CLASSES, maker))
    chapters = (chapter for maker in order for chapter in make_chapter(maker, groups[maker]))
    count = sum(bool(each.maker) for group in groups.values() for each in group)
    return "\n".join([HEAD.format(kinds=letters), f"{count} instruments:", *chapters]) + "\n"


def make_chapter(maker, scanners):
    """The lines of one maker."""
    titles = ["scanner", "use", "optics", *COLUMNS]
    yield f"\n## {maker}\n"
    yield "| " + " | ".join(titles) + " |"
    yield "|---" * len(titles) + "|"
    for scanner in scanners:
        cells = [f"{scanner.name}<br>`{scanner.reference}`", scanner.use, optics_of(scanner)]
        cells += [make_cell(scanner, *column) for column in COLUMNS.values()]
        yield "| " + " | ".join(cells) + " |"
    yield "\nSources:\n"
    yield from (f"- {scanner.name}: {sources_of(scanner)}" for scanner in scanners)


def optics_of(scanner):
    return (
        f"{scanner.optics}, {scanner.channels} channels" if scanner.channels > 1 else scanner.optics
    )


def angle_of(scanner, title):
    """The field of a scanner or the sweep of its facets [deg], or None; and their attribute."""
    if title == "sweep":
        half = scanner.numbers.get("scanAngleMax_deg") if scanner.optics == "rotating" else None
        return half and 2 * half, "scanAngleMax_deg"
    limited = scanner.optics == "rotating" and "scanAngleEffectiveMax_deg" in scanner.numbers
    return scanner.field_of_view, "scanAngleEffectiveMax_deg" if limited else "scanAngleMax_deg"


def make_cell(scanner, attribute, factor):
    """A number with the letter of its source; of several frequencies the lowest and the highest."""
    value = scanner.numbers.get(attribute)
    if attribute in ("fieldOfView", "sweep"):
        value, attribute = angle_of(scanner, attribute)
    if value is None:
        return ""
    ends = (min(value), max(value)) if isinstance(value, tuple) else (value,)
    text = "–".join(dict.fromkeys(f"{factor * end:.6g}" for end in ends))
    minor = scanner.minor_beam_divergence if attribute == "beamDivergence_rad" else None
    text += f" × {factor * minor:.6g}" if minor else ""
    source = scanner.source_of(attribute)
    return f"{text} {source.kind[0]}" if source and source.kind else text


def sources_of(scanner):
    """The sources of a scanner in words."""
    words = []
    for source in scanner.sources:
        names = ", ".join(f"`{name}`" for name in source.attributes) or "all"
        words.append(f"*{source.kind}* {names}: {source.note}")
    return ". ".join(words) + "." if words else "in the comment of its entry."


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT / "build/lib/python3/dist-packages"))
    PAGE.write_text(make_page(), encoding="utf-8")
    print(PAGE)
