# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Statements of the documents on names, lists, options and files are true of the code."""

import argparse
import importlib.util
import pathlib
import re

import pytest
from _small_run import write_survey

import vtkhelios
from vtkhelios import cli, example_surveys, formats
from vtkhelios.core.run_files import FORMATS
from vtkhelios.scenes.scene import _OPTICS as OPTICS

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = ROOT / "Docs"
PAGES = [
    path
    for folder in (ROOT, *(path for path in ROOT.iterdir() if path.name[0].isupper()))
    for path in (folder.glob("*.md") if folder == ROOT else folder.rglob("*.md"))
    if path.name != "CHANGELOG.md"
]
TEXT = "\n".join(path.read_text() for path in PAGES)
# Options of other programs that pages may name, and of this project's scripts.
OTHER_PROGRAMS = {"--no-deps", "--memory-limit", "--version", "--help"}
for script in (*ROOT.glob("Testing/**/*.*"), *ROOT.glob("Python/studies/*.py")):
    scripts = script.suffix == ".sh" or {"Benchmarks", "studies"} & set(script.parts)
    if scripts or script.stem in ("fuzz", "resume"):
        OTHER_PROGRAMS |= set(re.findall(r'["|(/ ](--[a-z-]+)[")| ]', script.read_text()))
UNIT = "deg|m|ns|Hz|hz|rad|s|nm|nW|w|W|km|sr|percent"


def load_maker(name):
    spec = importlib.util.spec_from_file_location(name, ROOT / f"Python/{name}.py")
    maker = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(maker)
    return maker


MODELS = load_maker("make_models")
DIALECT = MODELS.Dialect(vtkhelios.vtkHeliosDialect.GetTables())


def first_cells(page, heading):
    """The words in code of the first cells of the first table after a line that starts with a text."""
    lines = page.read_text().split("\n")
    begin = next(i for i, line in enumerate(lines) if line.startswith(heading))
    table = next(i for i in range(begin, len(lines)) if lines[i].startswith("|"))
    end = next(i for i in range(table, len(lines)) if not lines[i].startswith("|"))
    cells = [line.split("|")[1] for line in lines[table + 2 : end]]
    return [word for cell in cells for word in re.findall(r"`([^`]+)`", cell)]


# Lists.


def test_the_models_page_is_of_today():
    text = MODELS.PAGE.read_text(encoding="utf-8")
    assert MODELS.make_page(text) == text, "run build/venv/bin/python Python/make_models.py"
    assert text.count("<!-- models: end -->") == 7


def test_loaders():
    types = DIALECT.choices("filter", "type")
    loaders = {name for name in types if name.endswith("loader")} | {"detailedvoxels"}
    assert set(first_cells(DOCS / "scenes.md", "## Loaders")) == loaders


def test_detectors():
    factory = vtkhelios.vtkHeliosEchoDetection
    names = {factory.GetDetectorName(i) for i in range(factory.GetNumberOfDetectors())}
    assert names == set(DIALECT.choices("FWFSettings", "echoDetector"))
    assert set(first_cells(DOCS / "instrument.md", "`echoDetector` is")) == names


def test_optics():
    names = set(DIALECT.choices("scanner", "optics"))
    row = next(
        line
        for line in (ROOT / "Data/Assets/README.md").read_text().split("\n")
        if line.startswith("| `optics`")
    )
    assert set(re.findall(r"`(\w+)`", row)) - {"optics"} == names


def test_ray_casters():
    factory = vtkhelios.vtkHeliosRayCasterFactory
    names = {factory.GetBackendName(i) for i in range(factory.GetNumberOfBackends())}
    listed = set(first_cells(DOCS / "ray-casters.md", "# Ray casters"))
    optional = {"embree", "cgal", "obbtree"}  # backends of modules that a build may leave out
    assert listed - optional <= names <= listed


def test_platforms():
    own = {"vtkHeliosInterpolatedPlatform"}  # has a page of its own, trajectories.md
    names = {cls.__name__ for cls in vtkhelios.vtkHeliosPlatform.__subclasses__()} - own
    assert set(first_cells(DOCS / "platforms.md", "# Platforms")) == names


def test_optics_of_materials():
    names = set(first_cells(DOCS / "materials.md", "## Kinds")) - {"illum"}
    assert names == set(OPTICS)


def test_formats_of_points():
    cells = first_cells(DOCS / "files.md", "| extension |")
    assert len(cells) == len(set(cells)), "an ending has two rows"
    assert set(cells) == set(formats.FORMATS)
    rows = [line for line in (DOCS / "files.md").read_text().split("\n") if "input only" in line]
    only_read = {word for row in rows for word in re.findall(r"`(\.\w+)`", row)}
    assert only_read == {name for name, kind in formats.FORMATS.items() if not kind[2]}


def test_readme():
    text = (ROOT / "README.md").read_text()
    kinds = re.search(r"of (\w+) kinds: (.*?)\.", text)
    assert re.findall(r"`(\w+)`", kinds[2]) == list(example_surveys.KINDS)
    assert kinds[1] == ("six", "seven", "eight", "nine")[len(example_surveys.KINDS) - 6]
    count = re.search(r"^(\d+) instruments:", (DOCS / "instruments.md").read_text(), re.M)[1]
    assert f"as are {count} instruments" in text


def test_the_package_of_the_libraries():
    """Its name has the version, as CMake/heliosDebian.cmake makes it."""
    text = TEXT + (ROOT / "Apps/Packages/Debian/build.sh").read_text()
    version = re.search(r"VERSION (\d+\.\d+)\.", (ROOT / "CMakeLists.txt").read_text())[1]
    assert set(re.findall(r"libvtkhelios(\d+\.\d+)", text)) == {version}


# Options.


def options_of_commands():
    """A dict from each subcommand to its options; without those that are hidden."""
    parsers = next(
        action
        for action in cli.make_parser()._actions
        if isinstance(action, argparse._SubParsersAction)
    ).choices
    found = {
        name: {
            option
            for action in parser._actions
            for option in action.option_strings
            if option.startswith("--") and action.help is not argparse.SUPPRESS
        }
        for name, parser in parsers.items()
    }
    sources = [
        ROOT / "Apps/Viewer/Window/heliosViewerOptions.cxx",
        *(ROOT / "Python/vtkhelios/cli/_web").glob("*.py"),
    ]
    for source in sources:  # sources of programs of their own
        found["view"] |= set(re.findall(r'"!?(--[a-z-]+)[ ",]', source.read_text()))
    return found


OPTIONS = options_of_commands()


def find_strange_options(text):
    """The options in a text that no command has: of command lines, and those in code by themselves."""
    known = set().union(*OPTIONS.values()) | OTHER_PROGRAMS
    strange = []
    for command, rest in re.findall(r"^(?:\S*/)?vtkhelios (\w+)(.*)$", text, re.M):
        words = re.findall(r"(?<![\w-])--[a-z][\w-]*", rest.split("#")[0])
        strange += [f"{command} {w}" for w in words if w not in OPTIONS.get(command, known)]
    for span in re.findall(r"(?<!`)`([^`\n]+)`(?!`)", text):
        words = re.findall(r"(?<![\w-])--[a-z][\w-]*", span)
        begin = re.match(r"vtkhelios (\w+)", span)
        if span.startswith("--") or begin:
            mine = OPTIONS.get(begin[1], known) if begin else known
            strange += [w for w in words if w not in mine]
    return strange


def without_other_programs(page):
    """The text of a page without the options of HELIOS++ and the command lines of scripts."""
    text = page.read_text()
    if page.name == "from-helios.md":
        cells = " ".join(re.findall(r"^\| (`-.*?) \| ", text, re.M))
        for name in set(re.findall(r"--[a-z]+[A-Z]\w*", cells)) | {
            "--test",
            "--kdt",
            "--unzip",
            "--silent",
        }:
            text = re.sub(rf"{name}\b", "", text)
        text = re.sub(r"^\| `-.*? \| ", "| ", text, flags=re.M)
    if page.name == "dialect.md":
        text = text.replace("`--legacyEnergyModel`", "")
    return re.sub(r"`[^`\n]*(?:\.sh|\.py|pip|cmake|dask|helios|venv)\b [^`\n]*`", "", text)


@pytest.mark.parametrize("command", sorted(OPTIONS))
def test_every_option_is_in_a_page(command):
    options = OPTIONS[command] - {"--help"}
    missing = [name for name in options if not re.search(rf"{name}(?![\w-])", TEXT)]
    assert missing == []


@pytest.mark.parametrize("page", PAGES, ids=lambda path: str(path.relative_to(ROOT)))
def test_every_option_of_a_page_exists(page):
    assert find_strange_options(without_other_programs(page)) == []


def test_strange_options_are_found():
    text = (
        "vtkhelios run a.xml --formt las  # --none\n`--frmat` `vtkhelios run --mesh` `--format las`"
    )
    assert find_strange_options(text) == ["run --formt", "--frmat", "--mesh"]


# Names.


def find_strange_names(text):
    """Properties of classes, names of the package and attributes of the dialect that do not exist."""
    classes = re.findall(r"\b(vtkHelios\w+)::(\w+)", text)
    classes += [pair[::-1] for pair in re.findall(r"`(\w+)(?:\(\))?` of\s+`(vtkHelios\w+)`", text)]
    strange = []
    for name, member in classes:
        cls = getattr(vtkhelios, name, None)
        if cls and not any(hasattr(cls, verb + member) for verb in ("", "Set", "Get")):
            strange.append(f"{name}::{member}")
    known = {attribute for rows in DIALECT.rows.values() for attribute in rows}
    attributes = re.findall(rf'`(\w+_(?:{UNIT}))(?:="[^"`]*")?`', text)
    return strange + [name for name in attributes if name not in known]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: str(path.relative_to(ROOT)))
def test_names_in_pages_exist(page):
    text = page.read_text()
    if page.name == "running.md":  # keys of run_summary.json
        text = re.sub(r"^- `(legs|timings)`.*\n(?:  .*\n)*", "", text, flags=re.M)
    if page.name == "from-helios.md":
        text = text.replace("`speed_m_s`", "")  # a name of pyhelios
    assert find_strange_names(text) == []


def test_strange_names_are_found():
    text = "`vtkHeliosScanner::Wave` `Seeds` of `vtkHeliosRunOptions` `pulseLen_ns` `scanFreq_hz`"
    assert find_strange_names(text) == [
        "vtkHeliosScanner::Wave",
        "vtkHeliosRunOptions::Seeds",
        "pulseLen_ns",
    ]


# Files of a run.


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """The names that a run with all files writes, by format; without pieces."""
    folder = tmp_path_factory.mktemp("files")
    survey = write_survey(folder)
    written = {}
    for name in FORMATS:
        options = ("--waveforms", "--pulses", "--hits", "--no-accuracy-report", "--quiet")
        output = folder / name
        words = ["run", str(survey), "--output", str(output), "--format", name, *options]
        assert cli.main(words) == 0
        names = {path.name for path in output.rglob("*") if path.is_file()}
        written[name] = {each for each in names if not re.search(r"_\d{4}\.\w+$", each)}
    return written


@pytest.mark.parametrize("column, name", enumerate(FORMATS, 3))
def test_files_of_a_run(runs, column, name):
    table = re.search(r"<!-- models: files -->\n(.*?)<!--", MODELS.PAGE.read_text(), re.S)[1]
    cells = [row.split("|")[column].strip(" `") for row in table.strip().split("\n")[2:]]
    listed = {"run_summary.json", *cells}
    assert listed <= runs[name]
    for extra in runs[name] - listed:
        if extra.startswith("leg001"):
            assert extra.replace("leg001", "leg000") in runs[name]
        else:  # beside LAS
            place = extra.replace("leg000", "legNNN")
            assert f"`{place}`" in (DOCS / "files.md").read_text(), place


# The layout of CONTRIBUTING.md.


def find_unnamed_folders(text):
    """The folders of modules and of programs that the layout does not name in the row of their place."""
    rows = dict(re.findall(r"^\| `(\w+)/`(.*)$", text, re.M))
    modules = {path.parent for path in ROOT.glob("*/**/vtk.module") if "build" not in path.parts}
    programs = {path for path in (ROOT / "Apps").iterdir() if path.is_dir()}
    unnamed = [name.name for name in ROOT.iterdir() if name.is_dir() and is_ours(name)]
    unnamed = [name for name in unnamed if f"`{name}/`" not in text]
    for folder in modules | programs:
        place, *inner = folder.relative_to(ROOT).parts
        name = inner[1] if place == "Scanner" and len(inner) > 1 else (inner or [place])[0]
        if f"`{name}`" not in rows.get(place, ""):
            unnamed.append(str(folder.relative_to(ROOT)))
    return sorted(unnamed)


def is_ours(folder):
    """Whether a folder of the checkout is not made by a build."""
    return folder.name[0] not in "._" and folder.name != "build"


def test_the_layout_names_every_folder():
    text = (ROOT / "CONTRIBUTING.md").read_text().partition("## Code layout")[2]
    assert find_unnamed_folders(text.partition("\n## ")[0]) == []
