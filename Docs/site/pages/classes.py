# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page for every wrapped class, with all properties and methods, in Python and C++."""

import re
import sys

import vtkhelios

from . import markdown

FOLDER = "classes"
DECLARATION = re.compile(r"^C\+\+: ([^\n]+(?:\n {4}[^\n]+)*)", re.M)
SIGNATURE = re.compile(r"^(\w+\([^\n]*(?:\n(?!C\+\+)[^\n]*)*?\)\s*->\s*[^\n]+)\nC\+\+:", re.M)
ACCESSORS = re.compile(r"(Get|Set)\w+|\w+(On|Off)|Set\w+To\w+|Get\w+M(in|ax)Value")
BOILERPLATE = {"IsA", "IsTypeOf", "NewInstance", "SafeDownCast"}
BOILERPLATE |= {"GetNumberOfGenerationsFromBase", "GetNumberOfGenerationsFromBaseType"}


def make(folder):
    """Writes the pages and their index."""
    own = [getattr(vtkhelios, name) for name in vtkhelios.__all__ if name.startswith("vtkHelios")]
    (folder / FOLDER).mkdir()
    for cls in own:
        (folder / FOLDER / f"{cls.__name__}.md").write_text(page(cls))
    (folder / FOLDER / "index.md").write_text(index(own))
    return [f"{FOLDER}/index"]


def index(own):
    """The page that lists the classes by their module."""
    modules = {}
    for cls in own:
        modules.setdefault(cls.__module__.rpartition(".")[2], []).append(cls)
    lines = ["# Classes\n", "The classes of every module, in C++ and Python.\n"]
    for module, members in sorted(modules.items()):
        rows = [[_link(cls), markdown.line(summary(cls))] for cls in members]
        lines += [f"## {module}\n", markdown.table(["class", ""], rows)]
    return "\n".join([*lines, markdown.contents([cls.__name__ for cls in own])])


def page(cls):
    """The page of one class."""
    parts = [f"# {cls.__name__}\n", markdown.line(_sentence(summary(cls))) + "\n"]
    bases = [base for base in cls.__mro__[1:] if base.__name__.startswith("vtk")]
    derived = f" : public {bases[0].__name__}" if bases else ""
    parts.append(f"```{{cpp:class}} {cls.__name__}{derived}\n:no-contents-entry:\n```\n")
    if bases:
        chain = [_link(base) if _is_own(base) else base.__name__ for base in bases[:3]]
        parts.append(f"Derived from {', '.join(chain)}.\n")
    text, _, related = description(cls).partition("@sa")
    parts.append(markdown.prose(text) + "\n")
    if related:
        parts.append(f"See also {', '.join(map(_mention, related.split()))}.\n")
    parts += _properties(cls)
    for base in filter(_is_own, bases):
        if own_properties(base):
            names = ", ".join(markdown.code(name) for name in own_properties(base))
            parts.append(f"Properties of {_link(base)}: {names}.\n")
    parts += _methods(cls)
    return "\n".join(parts)


def own_properties(cls):
    """The properties that a class adds to its bases, by name."""
    kind = sys.modules["vtkhelios.core.properties"].Property
    found = {name: value for name, value in vars(cls).items() if isinstance(value, kind)}
    stock = next(base for base in cls.__mro__ if not _is_own(base))
    return {
        name: found[name] for name in sorted(found) if not hasattr(stock, f"Get{found[name].camel}")
    }


def own_methods(cls):
    """Returns the methods that a class adds, without methods of its properties and of all VTK
    classes."""
    accessors = {
        f"{verb}{value.camel}" for value in own_properties(cls).values() for verb in ("Get", "Set")
    }
    found = {}
    for name, method in sorted(vars(cls).items()):
        is_method = callable(method) and name[0].isupper() and not isinstance(method, type)
        if is_method and name not in BOILERPLATE | accessors and not _belongs(name, accessors):
            found[name] = method
    return found


def summary(cls):
    """Returns a class's description in one sentence without its name."""
    first = " ".join((cls.__doc__ or "").split("\n\n")[0].split())
    return first.partition(" - ")[2] or first


def description(cls):
    """The rest of its documentation."""
    text = (cls.__doc__ or "").partition("\n\n")[2]
    return re.sub(r"^Superclass: \w+\s*", "", text.strip())


def _properties(cls):
    own = own_properties(cls)
    if not own:
        return []
    parts = ["## Properties\n"]
    for name, value in own.items():
        fact = value.kind if value.setter_name else f"{value.annotation}, read only"
        accessors = [f"{verb}{value.camel}" for verb in ("Set", "Get")]
        parts += [
            f"### {markdown.escape(name)}\n",
            f"{fact}\n",
            *(declarations(cls, method) for method in accessors if hasattr(cls, method)),
            markdown.prose(value.__doc__) + "\n",
        ]
    return parts


def _methods(cls):
    parts = []
    for name, method in own_methods(cls).items():
        text = method.__doc__ or ""
        signatures = [" ".join(found.split()) for found in SIGNATURE.findall(text)]
        told = text.rpartition("C++:")[2].partition("\n\n")[2]
        parts += [f"### {name}\n", "```python\n" + "\n".join(signatures or [name]) + "\n```\n"]
        parts += [declarations(cls, name), markdown.prose(told) + "\n"]
    return ["## Methods\n", *parts] if parts else []


def declarations(cls, name):
    """The declarations in C++ of a method, each with an anchor."""
    found = DECLARATION.findall(getattr(cls, name).__doc__ or "")
    found = [re.sub(r"\boverride$", "", " ".join(text.split()).rstrip(";")) for text in found]
    named = [
        re.sub(rf"(?<!\w){name}\(", f"{cls.__name__}::{name}(", text, count=1) for text in found
    ]
    return "".join(
        f"```{{cpp:function}} {text.strip()}\n:no-contents-entry:\n```\n"
        for text in dict.fromkeys(named)
    )


def _belongs(name, accessors):
    """Returns whether a method is one of a property's others: SetXToY, XOn, GetXMinValue."""
    stems = {accessor[3:] for accessor in accessors}
    found = re.fullmatch(r"Set(\w+?)To\w+|(\w+)(?:On|Off)|Get(\w+)M(?:in|ax)Value", name)
    return bool(found) and any(group in stems for group in found.groups())


def _sentence(text):
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")


def _is_own(cls):
    return cls.__module__.startswith("vtkhelios.")


def _mention(name):
    cls = getattr(vtkhelios, name, None)
    return _link(cls) if cls else name


def _link(cls):
    return f"[{cls.__name__}]({cls.__name__}.md)"
