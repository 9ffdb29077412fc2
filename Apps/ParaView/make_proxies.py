# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the proxies of the ParaView plugin, Plugin/*.xml, from the classes and their documentation.

    build/venv/bin/python Apps/ParaView/make_proxies.py

Names, defaults, choices and help of properties are those of the classes. What a class does not say
is in FILES: which classes have a proxy, their menus, and the names of ports. A test fails when a
file is out of date.
"""

import pathlib
import re
import typing
import xml.etree.ElementTree as ET

import vtkhelios
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkhelios.core.properties import Property, properties

PLUGIN = pathlib.Path(__file__).resolve().parent / "Plugin"
HEAD = """\
<!-- SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors -->
<!-- SPDX-License-Identifier: BSD-3-Clause -->
<!-- Made by Apps/ParaView/make_proxies.py; do not edit. -->
"""
POINTS = "Point Gaussian"  # outputs without cells are visible as this representation
STRATEGIES = "lidar_strategies"  # the group of proxies that are properties of others


class Port(typing.NamedTuple):
    """An input."""

    name: str
    is_optional: bool = False
    is_repeatable: bool = False


class Proxy(typing.NamedTuple):
    """A class with a proxy: what the class itself does not say."""

    cls: str
    label: str  # in menus; its words are the function in Python
    inputs: tuple = ()
    outputs: tuple = ()  # names; a single output needs none
    shown: tuple = ()  # properties that are always visible; none given: all
    omitted: tuple = ()
    strategies: dict = {}  # property: classes of its values
    extensions: str = ""  # file names that it reads
    representation: str = ""
    header: str = ""  # a class that only the plugin has
    base: str = ""  # its base class

    @property
    def name(self):
        return self.cls.replace("vtk", "")


SCENE = Port("Scene")
ECHOES = ("Echoes", "Waveforms", "Pulses", "Sub-ray hits")

FILES = {
    "scenes": (
        Proxy("vtkHeliosObjSceneReader", "OBJ Scene", extensions="obj"),
        Proxy(
            "vtkHeliosGeoTiffSceneReader",
            "GeoTIFF Terrain",
            omitted=("NoDataValue",),
            extensions="tif tiff",
        ),
        Proxy(
            "vtkHeliosLASReader",
            "LAS Points",
            outputs=("Points", "Waveforms"),
            extensions="las",
            representation=POINTS,
        ),
        Proxy("vtkHeliosSceneTransform", "Transform Scene", inputs=(SCENE,)),
        Proxy(
            "vtkHeliosSceneComposer",
            "Compose Scene",
            inputs=(Port("Parts", is_repeatable=True), Port("Instances", is_optional=True)),
        ),
    ),
    "surveys": (
        Proxy(
            "vtkHeliosSurveyFileSource",
            "LiDAR Survey",
            outputs=ECHOES,
            strategies={"Options": ("vtkHeliosRunOptions",)},
            header="Survey/vtkHeliosSurveyFileSource.h",
            base="vtkHeliosSurveySource",
        ),
        Proxy("vtkHeliosRunOptions", "Run Options", omitted=("AccuracyReport",)),
    ),
    "scanner": (
        Proxy("vtkHeliosStaticPlatform", "Static Platform", inputs=(Port("Waypoint"),)),
        Proxy("vtkHeliosLinearPathPlatform", "Linear Path Platform", inputs=(Port("Waypoints"),)),
        Proxy(
            "vtkHeliosScanner",
            "LiDAR Scanner",
            inputs=(
                SCENE,
                Port("Trajectory"),
                Port("Voxels", is_optional=True, is_repeatable=True),
            ),
            outputs=ECHOES,
            shown=(
                "BeamDeflector",
                "HeadRotateStart",
                "HeadRotateStop",
                "HeadRotateSpeed",
                "RangeMin",
                "RangeMax",
                "RangeAccuracy",
                "PulseLength",
                "Seed",
                "BeamOrigin",
                "MountPosition",
                "GenerateWaveforms",
            ),  # fmt: skip
            strategies={
                "BeamDeflector": (
                    "vtkHeliosRotatingMirror",
                    "vtkHeliosOscillatingMirror",
                    "vtkHeliosConicMirror",
                )
            },
            representation=POINTS,
        ),
        Proxy("vtkHeliosRotatingMirror", "Rotating Mirror"),
        Proxy("vtkHeliosOscillatingMirror", "Oscillating Mirror"),
        Proxy("vtkHeliosConicMirror", "Conic Mirror"),
    ),
    "planning": (
        Proxy(
            "vtkHeliosScanPositionCandidates",
            "Candidate Scan Positions",
            inputs=(SCENE, Port("ExcludedAreas", is_optional=True)),
            omitted=("Region",),
            representation=POINTS,
        ),
        Proxy(
            "vtkHeliosVisibilityTestPoints",
            "Visibility Test Points",
            inputs=(SCENE,),
            omitted=("Region",),
            representation=POINTS,
        ),
        Proxy(
            "vtkHeliosViewsheds",
            "Viewsheds",
            inputs=(SCENE, Port("Candidates"), Port("TestPoints")),
            representation=POINTS,
        ),
        Proxy(
            "vtkHeliosScanPositionPlanner",
            "Plan Scan Positions",
            inputs=(Port("Viewsheds"), Port("TestPoints")),
            outputs=("Candidates", "Test points", "Selected positions"),
            representation=POINTS,
        ),
    ),
}

# Properties of all algorithms; and PulseWindow, whose default exceeds the 32 bits that ParaView
# reads.
LEFT_OUT = {"AbortExecute", "Progress", "ProgressText", "PulseWindow"}


def make_files():
    """The texts of all files, by their paths."""
    return {PLUGIN / f"{name}.xml": make_file(proxies) for name, proxies in FILES.items()}


def make_file(proxies):
    root = ET.Element("ServerManagerConfiguration")
    groups = {}
    for proxy in proxies:
        group = find_group(proxy)
        if group not in groups:
            groups[group] = ET.SubElement(root, "ProxyGroup", name=group)
        groups[group].append(make_proxy(proxy))
    ET.indent(root)
    return HEAD + ET.tostring(root, encoding="unicode") + "\n"


def find_group(proxy):
    if not issubclass(find_class(proxy), vtkAlgorithm):
        return STRATEGIES
    return "filters" if proxy.inputs else "sources"


def find_class(proxy):
    """The wrapped class; of a class of the plugin, its base."""
    return getattr(vtkhelios, proxy.base or proxy.cls)


def make_proxy(proxy):
    cls, group = find_class(proxy), find_group(proxy)
    kind = "Proxy" if group == STRATEGIES else "SourceProxy"
    attributes = {"name": proxy.name, "class": proxy.cls, "label": proxy.label}
    element = ET.Element(kind, attributes)
    brief, text = describe_class(proxy, cls)
    ET.SubElement(element, "Documentation", short_help=brief, long_help=brief).text = text
    for index, port in enumerate(proxy.inputs):
        element.append(make_input(index, port))
    for own in make_own_properties(proxy):
        element.append(own)
    vtk_object = cls()
    for described in find_properties(proxy, cls):
        element.append(make_property(proxy, described, vtk_object))
    for index, name in enumerate(proxy.outputs):
        ET.SubElement(element, "OutputPort", name=name, index=str(index))
    if group != STRATEGIES:
        element.append(make_hints(proxy))
    return element


def make_hints(proxy):
    hints = ET.Element("Hints")
    ET.SubElement(hints, "ShowInMenu", category="LiDAR")
    if proxy.extensions:
        ET.SubElement(
            hints, "ReaderFactory", extensions=proxy.extensions, file_description=proxy.label
        )
    if proxy.representation:
        ET.SubElement(
            hints, "RepresentationType", view="RenderView", type=proxy.representation, port="0"
        )
    return hints


def describe_class(proxy, cls):
    """The brief and the first paragraph of a class."""
    if proxy.header:
        doc = (PLUGIN / proxy.header).read_text().split("*/")[0]
        brief = re.search(r"@brief\s+(.*)", doc)[1]
        text = re.search(r"@brief.*?\n \*\n(.*?)\n \*\n", doc, re.S)[1]
        return brief, collapse(text.replace(" * ", " "))
    head, _, text = cls.__doc__.partition("\n\n")
    return collapse(head.split(" - ", 1)[1]), collapse(text.split("\n\n")[1])


def collapse(text):
    return " ".join(text.split())


def make_input(index, port):
    """An input; the first one is called as ParaView's functions call it."""
    name = "Input" if index == 0 else port.name
    element = ET.Element(
        "InputProperty",
        name=name,
        label=split_words(name),
        command="AddInputConnection" if port.is_repeatable else "SetInputConnection",
        port_index=str(index),
    )
    if port.is_repeatable:
        element.attrib |= {"clean_command": "RemoveAllInputs", "multiple_input": "1"}
    groups = ET.SubElement(element, "ProxyGroupDomain", name="groups")
    for name in ("sources", "filters"):
        ET.SubElement(groups, "Group", name=name)
    types = ET.SubElement(element, "DataTypeDomain", name="input_type")
    ET.SubElement(
        types, "DataType", value="vtkImageData" if port.name == "Voxels" else "vtkPolyData"
    )
    ET.SubElement(element, "Documentation").text = f"{split_words(port.name)}."
    if port.is_optional:
        ET.SubElement(ET.SubElement(element, "Hints"), "Optional")
    return element


def split_words(camel):
    """A label; without its blanks it is the name in Python, so that units are in the help only."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", camel)


def make_own_properties(proxy):
    """Makes the properties of a class of the plugin, from its header: names of files and
    folders."""
    text = (PLUGIN / proxy.header).read_text() if proxy.header else ""
    for doc, body in re.findall(r"/\*\*\n((?:   \*[^/].*\n)*)   \*/\n((?:  \w.*;\n)+)", text):
        setter = re.search(r"void ((?:Set|Add)(\w+))\(const char\*", body)
        if setter:
            yield make_file_property(setter[1], setter[2], collapse(doc.replace("*", " ")), body)


def make_file_property(command, name, doc, body):
    attributes = dict(name=name, label=split_words(name), command=command, number_of_elements="1")
    if command.startswith("Add"):
        cleaner = re.search(r"void (RemoveAll(\w+))\(\)", body)
        attributes |= dict(name=cleaner[2], label=split_words(cleaner[2]), number_of_elements="0")
        attributes |= dict(clean_command=cleaner[1], repeat_command="1")
        attributes |= dict(number_of_elements_per_command="1")
    element = ET.Element("StringVectorProperty", attributes, animateable="0")
    ET.SubElement(element, "FileListDomain", name="files")
    if command.startswith("Add"):
        ET.SubElement(ET.SubElement(element, "Hints"), "UseDirectoryName")
    ET.SubElement(element, "Documentation").text = shorten(doc)
    return element


def find_properties(proxy, cls):
    found = [p for p in properties(cls).values() if isinstance(p, Property) and p.setter_name]
    found.sort(key=lambda described: described.camel != "FileName")  # first, the file
    for described in found:
        is_object = described.annotation.startswith("vtk")
        left_out = {*LEFT_OUT, *proxy.omitted}
        if described.camel not in left_out and (
            not is_object or described.camel in proxy.strategies
        ):
            yield described


def shorten(doc):
    """The help of a property, without what is true of all."""
    text = re.sub(r"^(?:Set/Get|Sets?|Gets?) (?:whether )?", "", collapse(doc))
    return text[:1].upper() + text[1:]


def make_property(proxy, described, vtk_object):
    is_shown = not proxy.shown or described.camel in proxy.shown
    common = {
        "name": described.camel,
        "label": split_words(described.camel),
        "command": described.setter_name,
    }
    if not is_shown:
        common["panel_visibility"] = "advanced"
    make = make_object if described.camel in proxy.strategies else make_value
    element = make(proxy, described, vtk_object, common)
    ET.SubElement(element, "Documentation").text = shorten(described.__doc__ or "")
    return element


def make_object(proxy, described, _vtk_object, common):
    element = ET.Element("ProxyProperty", common)
    domain = ET.SubElement(element, "ProxyListDomain", name="proxy_list")
    for name in proxy.strategies[described.camel]:
        ET.SubElement(domain, "Proxy", group=STRATEGIES, name=name.replace("vtk", ""))
    return element


def make_value(_proxy, described, vtk_object, common):
    value = getattr(vtk_object, f"Get{described.camel}")()
    values = value if isinstance(value, tuple) else (value,)
    signature = getattr(type(vtk_object), described.setter_name).__doc__
    if isinstance(values[0], bool):
        return make_numbers("Int", common, map(int, values), ("BooleanDomain", "bool"))
    if isinstance(values[0], int):
        kind = "IdType" if re.search(r"vtkIdType|long long", signature) else "Int"
        element = make_numbers(kind, common, values)
        add_choices(element, described, type(vtk_object))
        return element
    if isinstance(values[0], float):
        return make_numbers("Double", common, (f"{number:.17g}" for number in values))
    element = ET.Element("StringVectorProperty", common, number_of_elements="1")
    if described.camel.endswith("FileName"):
        ET.SubElement(element, "FileListDomain", name="files")
        element.set("animateable", "0")
    elif value:
        element.set("default_values", value)
    return element


def make_numbers(kind, common, values, domain=None):
    texts = [str(value) for value in values]
    more = {"number_of_elements": str(len(texts)), "default_values": " ".join(texts)}
    element = ET.Element(f"{kind}VectorProperty", {**common, **more})
    if domain:
        ET.SubElement(element, domain[0], name=domain[1])
    return element


def add_choices(element, described, cls):
    if not described.choices:
        return
    domain = ET.SubElement(element, "EnumerationDomain", name="enum")
    for name, (_, method) in described.choices.items():
        vtk_object = cls()
        getattr(vtk_object, method)()
        number = getattr(vtk_object, f"Get{described.camel}")()
        ET.SubElement(domain, "Entry", value=str(number), text=name.replace("_", " "))


def main():
    for path, text in make_files().items():
        path.write_text(text)
        print(f"{path.name}: {text.count('Proxy name')} proxies, {text.count('VectorProperty n')}")


if __name__ == "__main__":
    main()
