# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The list of vtkhelios list scanners."""

from ...catalogue import find_scanners as find  # noqa: F401  of this list

COLUMNS = ("scanner", "name", "kind", "kHz", "field", "mrad", "source")
LEGEND = (
    "kHz: pulses per second of a channel; field: the whole angle that is scanned [deg]; mrad: full beam "
    "divergence at 1/e2. A survey names a scanner as in the first column; Docs/instruments.md has the "
    "source of each number. vtkhelios instrument writes the scanner of an Ouster sensor from its metadata"
)


def explain_none(text):
    """The error if nothing is found."""
    return (
        f'"{text}": no scanner has all these words in its id, name, maker, use or optics; '
        "vtkhelios list scanners lists all, and vtkhelios instrument makes one from a manufacturer's file"
    )


def row_of(scanner):
    """Returns the words of a line."""
    frequencies = [f"{frequency / 1e3:g}" for frequency in scanner.pulse_frequencies]
    rate = "-".join(dict.fromkeys([*frequencies[:1], *frequencies[-1:]]))
    return (
        scanner.reference,
        scanner.name,
        ", ".join(filter(None, (scanner.use, scanner.optics))),
        f"{scanner.channels} x {rate}" if scanner.channels > 1 else rate,
        _figure(scanner.field_of_view),
        _figure(scanner.beam_divergence and 1e3 * scanner.beam_divergence),
        document_of(scanner),
    )


def document_of(scanner):
    """Returns the document of its first source, in short."""
    note = scanner.sources[0].note if scanner.sources else ""
    return note.partition(";")[0].partition(": ")[0]


def _figure(value):
    return f"{value:.4g}" if value else ""


def facts_of(scanner):
    """Returns the facts that --json prints for a scanner."""
    return {
        "reference": scanner.reference,
        "id": scanner.id,
        "name": scanner.name,
        "maker": scanner.maker,
        "use": scanner.use,
        "optics": scanner.optics,
        "channels": scanner.channels,
        "pulseRate_Hz": scanner.pulse_rate,
        "fieldOfView_deg": scanner.field_of_view,
        "numbers": scanner.numbers,
        "sources": [
            {"kind": each.kind, "of": list(each.attributes), "note": each.note}
            for each in scanner.sources
        ],
    }
