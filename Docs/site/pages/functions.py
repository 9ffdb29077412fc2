# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the functions and classes of the Python package."""

import inspect

import vtkhelios

from . import markdown


def make(folder):
    """Writes the page."""
    names = [name for name in vtkhelios.__all__ if not name.startswith("vtkHelios")]
    parts = [
        "# Python functions and classes\n",
        "What `import vtkhelios` offers besides the classes.\n",
    ]
    for name in names:
        parts += describe(name, getattr(vtkhelios, name), "##")
    (folder / "functions.md").write_text("\n".join(parts))
    return ["functions"]


def describe(name, item, level):
    """A heading, the signature and the text of a function, a class or a property."""
    parts = [f"{level} {markdown.escape(name)}\n"]
    if callable(item):
        parts.append(f"```python\n{name}{signature(item)}\n```\n")
    parts.append(markdown.prose(inspect.getdoc(item)) + "\n")
    if inspect.isclass(item):
        for member, value in public_members(item).items():
            parts += describe(member, value, level + "#")
    return parts


def public_members(cls):
    """Documented methods and properties that a class defines, in the order of its source."""
    return {
        name: getattr(value, "__func__", value)
        for name, value in vars(cls).items()
        if not name.startswith("_") and inspect.getdoc(value) and not isinstance(value, type)
        if callable(value) or isinstance(value, (property, classmethod, staticmethod))
    }


def signature(item):
    """The arguments as text."""
    try:
        return str(inspect.signature(item))
    except (TypeError, ValueError):
        return "(...)"
