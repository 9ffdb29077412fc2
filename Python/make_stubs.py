# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the files of the package that follow from C++.

    build/venv/bin/python Python/make_stubs.py

vtkhelios/__init__.pyi: types of the wrapped classes for editors and type checkers. Methods come
from the signatures of VTK's wrapper, properties and their texts, with units and ranges, from the
C++ documentation.
vtkhelios/surveys/keywords.pyi: the keywords of runs, legs and plans, for the signatures of functions.
vtkhelios/array_names.py: the constants of the headers of array names; VTK wraps no constant texts.

A test fails when a file is out of date.
"""

import importlib
import inspect
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[1]
STUB = ROOT / "Python/vtkhelios/__init__.pyi"
KEYWORDS = ROOT / "Python/vtkhelios/surveys/keywords.pyi"
ARRAY_NAMES = ROOT / "Python/vtkhelios/array_names.py"
NAME_HEADERS = (
    "Filters/Core/vtkHeliosArrayNames.h",
    "Filters/Core/vtkHeliosFlightArrayNames.h",
    "Filters/Core/vtkHeliosFoliageArrayNames.h",
    "Filters/Core/Coordinates/vtkHeliosPointArrayNames.h",
    "Filters/PCL/vtkHeliosPCLArrayNames.h",
    "Scanner/Run/Batch/vtkHeliosBatchArrayNames.h",
)

HEAD = """\
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Made by Python/make_stubs.py; do not edit.
from pathlib import Path
from typing import Any, Literal, MutableSequence, Optional, Sequence, Tuple, Union, overload

"""
NAMES_HEAD = """\
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Made by Python/make_stubs.py from vtkHelios*ArrayNames.h; do not edit.
\"\"\"Names of all arrays that vtkHelios reads or writes.

>>> from vtkhelios.array_names import AMPLITUDE, GPS_TIME
>>> cloud[GPS_TIME]
\"\"\"
"""
THIN_LAYER = """\
from . import array_names as array_names, catalogue as catalogue
from .core.arrays import arrays as arrays
from .core.compose import Pipeline as Pipeline, select_ports as select_ports
from .clouds.filter import filter as filter
from .core.pipeline import PipelineError as PipelineError, update as update
from .comparison import Comparison as Comparison, compare as compare
from .fitting import Fit as Fit, fit as fit
from .leafarea import PlantArea as PlantArea, plant_area as plant_area
from .surveys.scanning import make_survey as make_survey, scan as scan
from .surveys.batch import Sensor as Sensor, scan_many as scan_many
from .clouds.cloud import Cloud as Cloud, Records as Records, read as read
from .core.detectors import add_detector as add_detector
from .core.plugins import load_plugin as load_plugin
from .flight import plan_flight as plan_flight
from .plans.plan import Plan as Plan, plan as plan
from .scenes.scene import Scene as Scene
from .surveys.survey import Survey as Survey, read_survey as read_survey

__version__: str

def data_directory() -> Path: ...
"""
PIPELINE_METHODS = """\
    def __rshift__(self, right: Any) -> Pipeline: ...
    def __rrshift__(self, left: Any) -> Pipeline: ...
    def __call__(self, data: Any = None) -> Any: ...
    def update(self) -> Any: ...
    @property
    def output(self) -> Any: ...
"""
# name(arguments) -> result, up to the line with the C++ signature
SIGNATURE = re.compile(r"^(\w+)\(([^\n]*(?:\n(?!C\+\+)[^\n]*)*?)\)\s*->\s*([^\n]+)\nC\+\+:", re.M)
# A name and a type, which may be a tuple or a list.
ARGUMENT = re.compile(r"(\w+):(\((?:[^()]|\([^()]*\))*\)|\[[^\]]*\]|[\w.]+)")
PLAIN = {"int", "float", "str", "bool", "None", "bytes"}
STOCK = ["vtkCommonCore", "vtkCommonDataModel", "vtkCommonExecutionModel", "vtkCommonMath",
         "vtkCommonTransforms"]  # fmt: skip


class Types:
    """Converts wrapper types to Python types; records the required imports."""

    def __init__(self, package):
        self.own = {name for name in package.__all__ if name.startswith("vtkHelios")}
        self.stock = {}
        for name in STOCK:
            module = importlib.import_module(f"vtkmodules.{name}")
            self.stock |= {key: name for key in vars(module) if key.startswith("vtk")}
        self.used = set()

    def of(self, text, taken=False):
        """taken: of an argument, which accepts any sequence for a tuple."""
        text = " ".join(text.split())
        if text[:1] in "([":
            inner = text[1:-1].split(",")
            element = self.of(inner[0].strip("([ "), taken)
            if text[0] == "[":
                return f"MutableSequence[{element}]"
            if taken:
                return f"Sequence[{element}]"
            return f"Tuple[{', '.join([element] * len(inner))}]"
        if text in PLAIN or text in self.own:
            return text
        if text in self.stock:
            self.used.add(text)
            return text
        return "Any"

    def imports(self):
        lines = {}
        for name in sorted(self.used):
            lines.setdefault(self.stock[name], []).append(name)
        return "".join(
            f"from vtkmodules.{module} import {', '.join(names)}\n"
            for module, names in sorted(lines.items())
        )


def make_class(cls, types):
    """The block of a class."""
    base = cls.__mro__[1].__name__
    base = "" if base == "object" else f"({types.of(base)})"
    lines = [f"class {cls.__name__}{base}:", *_docstring(_brief(cls), "    ")]
    module = sys.modules["vtkhelios.core.properties"]
    mine = {name: value for name, value in vars(cls).items() if isinstance(value, module.Property)}
    for name in sorted(mine):
        lines += _property(mine[name], types)
    keywords = [
        f"{name}: {_annotation(value, types)} = ..."
        for name, value in module.properties(cls).items()
        if value.setter_name
    ]
    if keywords:
        lines.append(f"    def __init__(self, *, {', '.join(keywords)}) -> None: ...")
    if "__call__" in vars(cls):
        lines += PIPELINE_METHODS.rstrip("\n").split("\n")
    for name, method in sorted(vars(cls).items()):
        if (
            callable(method)
            and name[0] != "_"
            and name[0].isupper()
            and not isinstance(method, type)
        ):
            lines += _methods(name, method, types)
    return "\n".join(lines) + "\n"


def _brief(cls):
    """The first sentence of the class's documentation."""
    text = inspect.cleandoc(cls.__doc__ or cls.__name__).split("\n\n")[0]
    return " ".join(text.split())


def _docstring(text, indent):
    text = text.replace("\\", "\\\\").replace('"""', "'''")
    lines = text.split("\n")
    wrapped = [part for line in lines for part in textwrap.wrap(line, 96) or [""]]
    if len(wrapped) == 1:
        return [f'{indent}"""{wrapped[0]}"""']
    return [
        f'{indent}"""{wrapped[0]}',
        *(f"{indent}{line}".rstrip() for line in wrapped[1:]),
        f'{indent}"""',
    ]


def _annotation(value, types):
    if value.choices:
        names = ", ".join(f'"{name}"' for name in value.choices)
        return f"Union[Literal[{names}], int]"
    kind = types.of(value.annotation, taken=bool(value.setter_name))
    return f"Optional[{kind}]" if kind.startswith("vtk") or kind == "str" else kind


def _property(value, types):
    kind = _annotation(value, types)
    doc = _docstring(value.__doc__, "    ") if value.__doc__ else []
    if value.setter_name:
        return [f"    {value.name}: {kind}", *doc]
    inner = [f"    {line}" if line else line for line in doc] or ["        ..."]
    return ["    @property", f"    def {value.name}(self) -> {kind}:", *inner]


def _methods(name, method, types):
    """One line per overload."""
    lines = []
    for found, arguments, result in SIGNATURE.findall(method.__doc__ or ""):
        if found != name:
            continue
        given = [f"{key}: {types.of(kind, True)}" for key, kind in ARGUMENT.findall(arguments)]
        if "self" in arguments.split(":")[0]:
            line = f"    def {name}({', '.join(['self', *given])}) -> {types.of(result)}: ..."
            lines.append([line])
        else:
            line = f"    def {name}({', '.join(given)}) -> {types.of(result)}: ..."
            lines.append(["    @staticmethod", line])
    unique = [list(item) for item in dict.fromkeys(map(tuple, lines))]
    mark = ["    @overload"] if len(unique) > 1 else []
    return [line for item in unique for line in (*mark, *item)]


def make_blocks(package):
    """Blocks of text by class, and the whole head."""
    types = Types(package)
    classes = [getattr(package, name) for name in package.__all__ if name.startswith("vtkHelios")]
    blocks = {cls.__name__: make_class(cls, types) for cls in classes if isinstance(cls, type)}
    return HEAD + types.imports() + THIN_LAYER, blocks


KEYWORDS_HEAD = """\
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Made by Python/make_stubs.py; do not edit.
from typing import Any, Literal, Optional, Sequence, Tuple, TypedDict, Union

"""
PAIR, FLAG, NUMBER = "Tuple[float, float]", "bool", "float"
LEG_FLAGS = ("stop_and_turn", "smooth_turn", "active")


def make_keywords(package):
    """The text of keywords.pyi: dictionaries of the keywords of functions, and the attributes of a leg."""
    from vtkhelios.plans.settings import SETTINGS as plan
    from vtkhelios.surveys import options, outputs
    from vtkhelios.surveys.items import SETTINGS, attributes
    from vtkhelios.surveys.survey import _FILES

    types = Types(package)
    rows = sys.modules["vtkhelios.core.properties"].properties(package.vtkHeliosRunOptions)
    run = {name: _keyword(rows[key], types) for name, key in options.in_python().items()}
    run |= dict.fromkeys(outputs.in_memory(), FLAG) | {"instances": FLAG, "mesh": "Any"}
    files = dict.fromkeys(name for name in outputs.in_files() if name not in run) | dict.fromkeys(
        _FILES
    )
    leg = {name: PAIR if isinstance(target, tuple) else FLAG if name in LEG_FLAGS else NUMBER
           for name, target in SETTINGS.items()}  # fmt: skip
    more = {name: "Any" for name in attributes("leg") if name not in leg}
    own = {key: kind for key, kind in {**leg, **more}.items() if key != "trajectory"}  # a parameter
    place = {"position": "Sequence[float]", "on_ground": FLAG}
    tables = {
        "RunOptions": run,
        "FileOptions(RunOptions)": {name: kind or "Any" for name, kind in files.items()},
        "LegSettings": {name: f"Optional[{kind}]" for name, kind in own.items()},
        "ScanOptions(RunOptions, LegSettings)": {"progress": "Any"},
        "PlanSettings": dict.fromkeys(plan, "Any"),
    }
    blocks = [_dictionary(name, rows) for name, rows in tables.items()]
    lines = [f"    {name}: {kind}" for name, kind in {**place, **leg, **more}.items()]
    return KEYWORDS_HEAD + "\n".join([*blocks, "class LegAttributes:\n" + "\n".join(lines) + "\n"])


def _keyword(value, types):
    """Returns the type of a keyword; None is the default. Numbers have more than the words of today."""
    kind = _annotation(value, types)
    kind = "str" if kind.startswith("Union[Literal") or "str" in kind else kind
    return f"Optional[{kind}]" if kind in PLAIN else "Any"


def _dictionary(name, rows):
    name, _, bases = name.partition("(")
    base = bases.rstrip(")") or "TypedDict"
    lines = [f"    {key}: {kind}" for key, kind in rows.items()]
    return f"class {name}({base}, total=False):\n" + "\n".join(lines) + "\n"


# The comment of a group, a comment of the next name, or a name with its text and comment.
ENTRY = re.compile(
    r"/\*\*(?P<group>.*?)\*/|^// (?P<above>[^\n]*)"
    r'|const char\* (?P<name>\w+) =\s*"(?P<text>[^"]+)";(?: *// (?P<beside>[^\n]*))?',
    re.S | re.M,
)


def make_array_names(headers=NAME_HEADERS):
    """The text of array_names.py; without the package, which imports it."""
    lines, units = [NAMES_HEAD.rstrip("\n")], []
    for header in headers:
        body = (ROOT / header).read_text().split("\nnamespace ", 1)[1]
        for entry in ENTRY.finditer(body):
            if entry["name"]:
                name = re.sub("(?<=[a-z])(?=[A-Z])", "_", entry["name"]).upper()
                beside = entry["beside"] or ""
                lines.append(f'{name} = "{entry["text"]}"' + (f"  # {beside}" if beside else ""))
                if unit := re.match(r"\[([a-zA-Z%][^].]*)\]", beside):
                    units.append(f'    {name}: "{unit[1]}",')
            elif entry["above"]:
                lines.append(f"# {entry['above']}")
            else:
                text = " ".join(entry["group"].replace("\n *", " ").split())
                lines += ["", *(f"# {line}" for line in textwrap.wrap(text, 96))]
    lines += ["", "# Units of the arrays that have one.", "UNITS = {", *units, "}"]
    return "\n".join(lines) + "\n"


def main():
    ARRAY_NAMES.write_text(make_array_names())
    import vtkhelios

    head, blocks = make_blocks(vtkhelios)
    KEYWORDS.write_text(make_keywords(vtkhelios))
    STUB.write_text(head + "".join(f"\n{block}" for block in blocks.values()))
    print(f"{STUB.relative_to(ROOT)}: {len(blocks)} classes")


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT / "build/lib/python3/dist-packages"))
    main()
