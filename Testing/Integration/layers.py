# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The layers of vtkHelios, and their violations.

A module may use modules of lower layers only. It declares them in its vtk.module, and its sources
include no header of an undeclared module.
"""

import graphlib
import pathlib
import re

# Layers from the bottom up; the modules of a layer are independent.
LAYERS = [
    ["FiltersCore"],
    ["FiltersIO", "FiltersScene", "FiltersPCL"],
    ["FiltersSimplify"],
    ["ScannerOptics", "ScannerRayCasting", "ScannerPlatforms"],
    ["ScannerRayCastingEmbree", "ScannerRayCastingCgal", "ScannerRayCastingObbTree"],
    ["ScannerCore"],
    ["ScannerDetectors"],
    ["ScannerSurvey"],
    ["ScannerRun"],
    ["ScannerMpi"],
    ["PlanningCbc"],
    ["Planning"],
]
LAYER = {name: number for number, names in enumerate(LAYERS) for name in names}

# The home of each library (CGAL's GPL parts are in two optional modules); only sources (.cxx)
# include its headers.
HOMES = {
    r"embree[34]/": "ScannerRayCastingEmbree",
    r"pugixml": "ScannerSurvey",
    r"yaml\.h": "ScannerSurvey",
    r"json/": "FiltersIO ScannerRun",
    r"re2/": "ScannerSurvey",
    r"openssl/": "FiltersIO",
    r"lzf": "FiltersIO",
    r"(arithmetic|bytestream|integercompressor|lasreadpoint|laswritepoint|laszip)": "FiltersIO",
    r"vtkMPI": "ScannerMpi",
    r"Random123/": "FiltersCore",
    r"pcl/": "FiltersPCL",
    r"(unsupported/)?Eigen/": "ScannerDetectors",
    r"vtkExprTk": "ScannerDetectors",
    r"CGAL/Polygon_mesh_processing": "FiltersSimplify",
    r"CGAL/": "ScannerRayCastingCgal FiltersSimplify",
    r"OpenMesh/": "FiltersSimplify",
    r"gdal": "FiltersIO",
    r"(png|jpeglib|tiffio|tiff)\.h": "FiltersIO",
    r"GeographicLib/": "FiltersCore",
    r"proj\.h": "FiltersCore",
    r"(coin/)?(Cbc|Clp|Osi|Coin)": "PlanningCbc",
}

# Functions that open a file to read it. A unit that uses one calls CheckInputFile() or OpenInput()
# first, so that the file is an input of the run; except units that read other files.
_OPENING = re.compile(
    r"ifstream|\bfopen\(|\bO_RDONLY\b|\bGDALOpenEx\(|\bload_file\(|\bCanReadFile\(path"
)
_CHECKING = re.compile(r"\b(CheckInputFile|OpenInput)\(")
READ_NO_INPUTS = {
    "vtkHeliosMemoryLimit": "the kernel's limits",
    "heliosChecksum": "written bytes of an output",
    "heliosPartFile": "an output that is written",
    "heliosTextFileSink": "an output that is written",
    "vtkHeliosStreamWriter": "an output that is resumed",
    "vtkHeliosPCDWriter": "an output that is resumed",
    "vtkHeliosXMLPieceWriter": "an output that is resumed",
    "heliosRunFolder": "the summary of a run",
    "heliosRunJournal": "the journal of a run",
    "heliosLoadedGdal": "names of functions",
}

USES = ("DEPENDS", "PRIVATE_DEPENDS", "OPTIONAL_DEPENDS")
_INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)


def read_module(path):
    """A vtk.module file as a dict from keyword to its words."""
    entries, keyword = {}, None
    for line in path.read_text().splitlines():
        words = re.sub(r"#.*", "", line).strip()
        if re.fullmatch(r"[A-Z_]+", words):
            keyword = words
            entries[keyword] = []
        elif words:
            entries[keyword].append(words)
    return entries


def find_modules(root):
    """Every module below a folder: a dict from name to (vtk.module as a dict, folder)."""
    modules = {}
    for folder in ("Filters", "Scanner", "Planning"):
        for path in sorted((root / folder).rglob("vtk.module")):
            entries = read_module(path)
            modules[entries["NAME"][0].removeprefix("vtkHelios::")] = (entries, path.parent)
    return modules


def used_modules(entries):
    return [name for keyword in USES for name in entries.get(keyword, [])]


def find_edge_faults(modules):
    """Dependencies that do not point down, as lines of text."""
    faults = []
    for name, (entries, _) in modules.items():
        if name not in LAYER:
            faults.append(f"{name} has no layer: give it one in LAYERS")
            continue
        for used in used_modules(entries):
            own = used.removeprefix("vtkHelios::")
            if own != used and LAYER.get(own, len(LAYERS)) >= LAYER[name]:
                faults.append(f"{name} uses {own}, which is not below it")
            if re.match(r"VTK::(Rendering|Interaction|Views|GUISupport)", used):
                faults.append(f"{name} uses {used}: rendering belongs to Apps/Viewer and Python")
    return faults


def folders_of(folder):
    """The folders of a module: itself and its subfolders, without its tests and submodules."""
    return [folder] + [
        path
        for path in sorted(folder.iterdir())
        if path.is_dir() and path.name != "Testing" and not (path / "vtk.module").exists()
    ]


def sources_of(folder):
    """The sources of a module, without its tests and submodules."""
    return [
        path
        for each in folders_of(folder)
        for path in sorted(each.iterdir())
        if path.suffix in (".h", ".cxx")
    ]


def find_folder_cycles(folder):
    """Subfolders of a module that include each other's headers, as lists of names."""
    home = {path.name: path.parent for path in sources_of(folder)}
    uses = {each: set() for each in folders_of(folder)}
    for path in sources_of(folder):
        for header in _INCLUDE.findall(path.read_text()):
            uses[path.parent].add(home.get(pathlib.PurePath(header).name, path.parent))
    order = graphlib.TopologicalSorter({each: used - {each} for each, used in uses.items()})
    try:
        order.prepare()
    except graphlib.CycleError as cycle:
        return [[path.name for path in cycle.args[1]]]
    return []


def find_unit_cycles(folders):
    """Units (a .h and .cxx of one name) that include each other's headers, as sets of names."""
    paths = [path for folder in folders for path in sources_of(folder)]
    home = {path.name: path.with_suffix("") for path in paths}
    uses = {path.with_suffix(""): set() for path in paths}
    for path in paths:
        unit = path.with_suffix("")
        names = {pathlib.PurePath(name).name for name in _INCLUDE.findall(path.read_text())}
        uses[unit] |= {home[name] for name in names & home.keys()} - {unit}

    def find_reachable(unit):
        reached, stack = set(), [unit]
        while stack:
            more = uses[stack.pop()] - reached
            reached |= more
            stack += more
        return reached

    reachable = {unit: find_reachable(unit) for unit in uses}
    in_cycles = [unit for unit in uses if unit in reachable[unit]]
    cycles = {frozenset(b for b in reachable[a] if a in reachable[b]) for a in in_cycles}
    return [{unit.name for unit in cycle} for cycle in cycles]


def find_include_faults(modules):
    """Headers included from undeclared modules, and libraries used outside their home."""
    owner = {
        path.name: name for name, (_, folder) in modules.items() for path in sources_of(folder)
    }
    faults = []
    for name, (entries, folder) in modules.items():
        allowed = {name} | {used.removeprefix("vtkHelios::") for used in used_modules(entries)}
        for path in sources_of(folder):
            for header in _INCLUDE.findall(path.read_text()):
                if owner.get(pathlib.PurePath(header).name, name) not in allowed:
                    faults.append(
                        f"{path.name} includes {header}, but {name} does not use that module"
                    )
                for pattern, home in HOMES.items():
                    if not re.match(pattern, header):
                        continue
                    if name not in home.split():
                        faults.append(f"{path.name} includes {header}, whose home is {home}")
                    elif path.name.startswith("vtkHelios") and path.suffix == ".h":
                        faults.append(f"{path.name} is public and includes {header}")
    return faults


def find_unchecked_files(modules):
    """Units that open files which no run would have among its inputs."""
    texts = {}
    for _, folder in modules.values():
        for path in sources_of(folder):
            texts[path.stem] = texts.get(path.stem, "") + path.read_text()
    return sorted(
        unit
        for unit, text in texts.items()
        if unit not in READ_NO_INPUTS and _OPENING.search(text) and not _CHECKING.search(text)
    )
