# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scanners: what each is, and where its numbers come from."""

import functools
import pathlib
import typing

from ._files import CatalogueError, has_words, read_folders, read_root, shipped_assets

KINDS = {
    "checked": "read in the public copy that is named",
    "sheet": "on the data sheet that is named, but not read again when the entry was written",
    "derived": "from published numbers, by the sum that is given",
    "assumed": "not published",
}
USES = ("terrestrial", "mobile", "unmanned", "airborne", "spaceborne")
TEXTS = ("id", "name", "maker", "use", "optics", "spin", "visModel", "scanPattern")
LISTS = ("pulseFreqs_Hz", "facetPitches_deg", "facetRolls_deg")
SCANNERS = "scanners.xml"


class Source(typing.NamedTuple):
    """Where some numbers of a scanner come from."""

    kind: str  # one of KINDS, or as the file has it
    attributes: tuple  # names of attributes and elements; empty: all
    note: str


class Scanner(typing.NamedTuple):
    """A scanner of the catalogue; numbers in the units of Docs/dialect.md, and only those given."""

    reference: str  # reference in surveys: file.xml#id
    id: str
    name: str
    maker: str  # empty: a class of instruments
    use: str  # one of USES, or empty
    optics: str
    numbers: dict  # by attribute; values of LISTS are tuples
    channels: int  # channels that fire at once
    sources: tuple  # attributes of Source

    @property
    def pulse_frequencies(self):
        """The pulse frequencies of one channel [Hz], from the lowest to the highest; empty if not
        given."""
        return tuple(sorted(self.numbers.get("pulseFreqs_Hz", ())))

    @property
    def pulse_rate(self):
        """The highest number of pulses per second of all channels [Hz], or None."""
        frequencies = self.pulse_frequencies
        return frequencies[-1] * self.channels if frequencies else None

    @property
    def field_of_view(self):
        """The whole angle that is scanned [deg], or None: of prisms, it follows from the wedges."""
        largest = self.numbers.get("scanAngleMax_deg")
        half = self.numbers.get("scanAngleEffectiveMax_deg") or largest
        half = half if self.optics == "rotating" else largest
        return 2.0 * half if half and self.optics != "risley" else None

    @property
    def beam_divergence(self):
        """The full angle at 1/e2 of the first channel, along the major axis [rad], or None."""
        return self.numbers.get("beamDivergence_rad")

    @property
    def minor_beam_divergence(self):
        """That along the minor axis of an elliptical beam [rad], or None: a circular beam."""
        return self.numbers.get("beamDivergenceMinor_rad") or None

    def source_of(self, attribute):
        """Returns the Source of an attribute, or None."""
        return next(
            (each for each in self.sources if attribute in each.attributes or not each.attributes),
            None,
        )


def find_scanners(text="", assets=(), warn=None):
    """The scanners of the catalogue and of the XML files in folders, in the order of their files.

    text
        words that all occur in the reference, name, maker, use or optics, in upper or lower case.
        Default: none, all scanners.
    assets
        more folders; of each, its XML files and its subfolders' XML files. Default: none.
    warn
        called with the message of each file that cannot be read, which is then left out. Default:
        raise CatalogueError.
    """
    found = read_folders(read_file, [*assets, shipped_assets()], warn)
    return [each for each in found if has_words(text, _searched(each))]


def read_file(path, name=None):
    """Returns the scanners of a file, whose references begin with name. Raises CatalogueError."""
    name = name or pathlib.Path(path).name
    return [_read_scanner(element, path, name) for element in read_root(path).iter("scanner")]


@functools.cache
def find_file(scanner):
    """The file of the shipped catalogue that has a scanner of this id; scanners.xml if none has."""
    found = (each.reference for each in find_scanners() if each.id == scanner)
    return next(found, SCANNERS).partition("#")[0]


def _searched(scanner):
    words = (scanner.reference, scanner.name, scanner.maker, scanner.use, scanner.optics)
    return " ".join(words)


def _read_scanner(element, path, name):
    given = element.attrib
    numbers = {
        key: _number(key, value, f"{path}: scanner {given.get('id', '')}")
        for key, value in given.items()
        if key not in TEXTS
    }
    sources = tuple(
        Source(each.get("kind", ""), tuple(each.get("of", "").split()), _one_line(each))
        for each in element.iterfind("sources/source")
    )
    return Scanner(
        f"{name}#{given.get('id', '')}",
        given.get("id", ""),
        given.get("name", ""),
        given.get("maker", ""),
        given.get("use", ""),
        given.get("optics", ""),
        numbers,
        max(1, len(element.findall("channels/channel"))),
        sources,
    )


def _number(key, text, where):
    try:
        if key in LISTS:
            return tuple(float(word) for word in text.split(",") if word.strip())
        return float(text)
    except ValueError:
        raise CatalogueError(
            f'{where}: {key}="{text}" is not valid: expected a number; vtkhelios validate FILE '
            "lists all errors"
        ) from None


def _one_line(source):
    return " ".join(source.get("note", "").split())
