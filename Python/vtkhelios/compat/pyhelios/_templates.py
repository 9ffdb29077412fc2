# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Templates of the settings of legs, in the document of a survey: legs have their values already."""

import pathlib
import xml.etree.ElementTree as ElementTree

from ...core.reading import is_document, read_xml
from ._settings import Settings

KINDS = ("scannerSettings", "platformSettings")


class Templates:
    """The templates of a document by their ids, and those of its legs."""

    def __init__(self, path):
        self._named = {kind: {} for kind in KINDS}
        self.legs = []  # ids of the templates of each leg, by the kind of settings
        if path and is_document(path) and pathlib.Path(path).is_file():
            self._read(ElementTree.fromstring(read_xml(path).strip()))

    def _read(self, root):
        for element in root:
            if element.tag in KINDS and element.get("id"):
                self._named[element.tag][element.get("id")] = element
        for leg in root.iter("leg"):
            found = {kind: leg.find(kind) for kind in KINDS}
            self.legs.append(
                {kind: each.get("template") for kind, each in found.items() if each is not None}
            )

    def find(self, leg, kind):
        """Returns the element of the template of a leg, or None."""
        names = self.legs[leg] if leg < len(self.legs) else {}
        return self._named[kind].get(names.get(kind))

    def remove_leg(self, leg):
        """Legs after a removed one move up."""
        del self.legs[leg : leg + 1]


def make_template(kind, element):
    """Returns the settings of a template: an object with the attributes of a kind of Settings, and id."""

    class Template(Settings):
        OWNER = kind.__name__
        SETTINGS = kind.SETTINGS

        def __init__(self):
            self._element = element

        @property
        def id(self):
            return element.get("id")

        def _read(self, attribute):
            return element.get(attribute, "")

        def _write(self, attribute, text):
            element.set(attribute, text)

    return Template()
