# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The layers of the Python package vtkhelios, and their violations.

A package uses packages of lower layers only, nothing uses the command line, and imports stand at the
top of a module, where this file sees them.
"""

import ast
import pathlib
import re
import typing

# From the bottom up; the packages of a layer are independent.
LAYERS = [
    ["array_names"],
    ["core"],
    ["catalogue", "cluster", "example_surveys", "exchange", "formats"],
    ["leafarea", "learning", "points", "scenes", "webcloud"],
    ["clouds"],
    ["surveys"],
    ["comparison", "compat"],
    ["fitting"],
    ["reports"],
    ["plans"],
    ["flight"],
]
LAYER = {name: number for number, names in enumerate(LAYERS) for name in names}

# Modules of users with the public names of one module of a package; nothing in the package uses them.
PUBLIC = {
    "cloud", "instruments", "measured_pulse", "pcl", "picture", "plan_picture", "planning", "scanning",
    "scene", "survey", "tradeoff",
}  # fmt: skip
TOP = {"cli", "__main__"}  # use anything; only __main__ uses cli
NO_MODULES = re.compile(
    r"_native|_pcl|_built_with|vtkHelios\w+|vtkmodules(\..*)?"
)  # compiled, or made

# Modules that a function may import: libraries that may be missing, and what takes long to load.
OPTIONAL = {
    "dask", "distributed", "jinja2", "laspy", "matplotlib", "mcap", "open3d",
    "pandas", "pye57", "pyvista", "rich", "rosbags",
}  # fmt: skip
LATE = {
    ("vtkhelios.plans.files", "vtkhelios.reports.plan_picture"): "VTK's rendering modules",
    ("vtkhelios.cli._run.ranks", "vtkhelios.vtkHeliosScannerMpi"): "loads MPI",
    ("vtkhelios.cli.run", "vtkhelios.formats._summary"): "a run starts without numpy",
}
# Modules that import others by a name that they compute.
BY_NAME = {
    "vtkhelios": "public names, once they are used",
    "vtkhelios.core.classes": "the wrapped modules of this build",
    "vtkhelios.cli": "the modules of the commands",
    "vtkhelios.formats._open": "the module of a format",
    "vtkhelios.example_surveys": "the module of a kind",
    "vtkhelios.exchange._meshes": "another VTK's numpy_support",
    "vtkhelios.core.packages": "optional packages",
    "vtkhelios.vtkmodules": "the VTK of a wheel",
}


class Import(typing.NamedTuple):
    """An import of a module."""

    user: str
    used: str
    line: int
    in_function: bool


class Package(typing.NamedTuple):
    """The modules of a package, by their full names, and all their imports."""

    modules: dict
    imports: list


def read_package(folder):
    """Reads all modules below a folder."""
    modules = {}
    for path in sorted(folder.rglob("*.py")):
        parts = (folder.name, *path.relative_to(folder).with_suffix("").parts)
        modules[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    imports = [read_imports(name, path, modules) for name, path in modules.items()]
    return Package(modules, [each for those in imports for each in those])


def read_imports(name, path, modules):
    """The imports of a module; of a name from a package that is no module, the package."""
    imports = []

    def visit(node, in_function):
        for child in ast.iter_child_nodes(node):
            if isinstance(child, (ast.Import, ast.ImportFrom)):
                for used in _used(name, path, child, modules):
                    imports.append(Import(name, used, child.lineno, in_function))
            visit(child, in_function or isinstance(child, (ast.FunctionDef, ast.Lambda)))

    visit(ast.parse(path.read_text()), False)
    return imports


def _used(name, path, node, modules):
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    base = node.module or ""
    if node.level:
        parts = name.split(".") + [""] * (path.name == "__init__.py")
        base = ".".join(filter(None, [*parts[: len(parts) - node.level], base]))
    root = base.partition(".")[0]
    full = [f"{base}.{alias.name}" for alias in node.names]
    inside = base.partition(".")[2]
    return [
        each
        if each in modules or NO_MODULES.fullmatch(each.removeprefix(f"{root}.")) and not inside
        else base
        for each in full
    ]


def package_of(name):
    """The package or module below the root that a module is in."""
    return name.split(".")[1] if "." in name else ""


def find_edge_faults(package):
    """Imports that do not point down, as lines of text."""
    faults = []
    for user, used, line, _ in package.imports:
        own, other = package_of(user), package_of(used)
        if used not in package.modules or own == other:
            continue
        where = f"{package.modules[user].name}:{line}: {user} imports {used}"
        if other == "cli":
            if own != "__main__":
                faults.append(f"{where}: nothing imports the command line")
        elif other in PUBLIC:
            faults.append(f"{where}, a module of public names; import its home")
        elif other == "":
            if own not in TOP:
                faults.append(f"{where}: the root imports everything; use core.classes.vtk_class()")
        elif other not in LAYER:
            faults.append(f"{where}: {other} has no layer: give it one in LAYERS")
        elif own in PUBLIC | TOP | {""}:
            if own == "" and other != "core":
                faults.append(f"{where}: the root imports core only, else by name")
        elif own not in LAYER:
            faults.append(f"{where}: {own} has no layer: give it one in LAYERS")
        elif LAYER[other] >= LAYER[own]:
            faults.append(f"{where}, which is not below it")
    return sorted(set(faults))


def find_hidden_imports(package):
    """Imports in functions that nothing permits, and imports by computed names, as lines of text."""
    faults = []
    for user, used, line, in_function in package.imports:
        is_optional = used.partition(".")[0] in OPTIONAL
        if in_function and not is_optional and (user, used) not in LATE:
            faults.append(
                f"{package.modules[user].name}:{line}: a function of {user} imports {used}"
            )
    for name, path in package.modules.items():
        if name not in BY_NAME and "import_module(" in path.read_text():
            faults.append(f"{path.name}: {name} calls import_module()")
    return faults


def find_unused_exceptions(package):
    """Entries of LATE and BY_NAME that no module needs any more."""
    late = {(each.user, each.used) for each in package.imports if each.in_function}
    unused = [f"{user} does not import {used} late" for user, used in LATE.keys() - late]
    for name in BY_NAME:
        if name not in package.modules or "import_module(" not in package.modules[name].read_text():
            unused.append(f"{name} does not call import_module()")
    return unused


def find_cycles(package, group=lambda name: name):
    """Groups of modules that import each other, directly or through others, as sets of names."""
    uses = {group(name): set() for name in package.modules}
    for user, used, *_ in package.imports:
        if used in package.modules and group(user) != group(used):
            uses[group(user)].add(group(used))

    def find_reachable(name):
        reached, stack = set(), [name]
        while stack:
            more = uses[stack.pop()] - reached
            reached |= more
            stack += more
        return reached

    reachable = {name: find_reachable(name) for name in uses}
    in_cycles = [name for name in uses if name in reachable[name]]
    cycles = {frozenset(b for b in reachable[a] if a in reachable[b]) for a in in_cycles}
    return [set(cycle) for cycle in cycles]


ROOT = pathlib.Path(__file__).resolve().parents[2]
