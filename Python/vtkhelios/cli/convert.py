# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios convert: points from one format to another."""

import argparse
import json
import pathlib
import time

from .. import formats
from ..core.reading import convert, is_document
from ..core.words import counted
from ..formats._run import RunReader, is_run
from ..points.conversion import Conversion
from ..points.selection import RETURNS, Selection
from ..reports.run import readable
from . import _meshes
from ._messages import Messages
from ._parser import number, whole_number
from ._progress import make_progress
from ._standard import NAME, folder_of_standard, is_standard, read_input, write_output
from ._stopping import set_outcome
from ._task import Task
from ._units import add_height_unit_argument

SUMMARY = (
    "convert points: text, LAS, LAZ, COPC, VTK, PLY, PCD, E57, and whole runs; meshes to OBJ; surveys "
    "to YAML and back"
)
STANDARD = ("inputs", "output")

EPILOG = """\
formats, by the end of a name, in and out:
  .xyz        text, the eleven columns of vtkhelios run
  .csv        text with a line of names, every array a column
              input also .txt .asc .pts .ptx: named columns, or any that begin with x y z
  .las .laz   LAS and LAZ (compressed); from one to the other needs laspy
  .copc.laz   COPC, LAZ in an octree for viewers
  .pvtp .vtp  VTK XML, in pieces, or in one file (held in memory as a whole)
  .ply        PLY, binary; every array is a property
  .pcd        PCD of the Point Cloud Library: floats relative to an origin; read as a whole
  .e57        E57, one scan per leg or input, with its pose; needs pye57
  input only: the folder of a run, with all its legs; every point has its leg id.

From LAS or LAZ to LAS or LAZ records are copied: nothing changes, no header record is lost. All
other conversions use arrays; data that the output format cannot store is reported. Points are
converted in chunks: memory does not grow with the files, except for .vtp and for input of .pcd.

Meshes (.ply .stl .gltf .glb .json: CityJSON, .tif) become OBJ, if the output ends in .obj: triangles,
and materials in an .mtl beside it.

Surveys, scenes, scanners and platforms in XML (.xml) become the same in YAML (.yaml, .yml), and back, with
their comments. Names of files in them are changed if OUTPUT is in another folder.

The output is named .part until it is complete; Ctrl-C and errors remove it. See Docs/files.md.

examples:
  vtkhelios convert output/village leg.laz             all legs of a run in one file
  vtkhelios convert output/village scans.e57           one scan per scan position
  vtkhelios convert output/village clouds --format laz one file per leg
  vtkhelios convert a.las b.las both.copc.laz --merge
  vtkhelios convert a.las ground.ply --class 2 --returns last
  vtkhelios convert a.las internal.las --waveforms internal
  vtkhelios convert delft.city.json delft.obj
  vtkhelios convert survey.xml survey.yaml
  vtkhelios convert village.laz - | head               as CSV to standard output
  pdal ... | vtkhelios convert - village.las --from csv

exit codes: 0 done, 1 failed (the reason is on standard error), 2 wrong usage, 130 interrupted.
"""


def class_list(text):
    """Returns an argparse type: classes, as 2 or 2,6."""
    try:
        classes = [int(word) for word in text.split(",")]
    except ValueError:
        classes = [-1]
    if not all(0 <= each <= 255 for each in classes):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a list of classes 0 to 255, such as 2 or 2,6"
        )
    return classes


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.usage = "%(prog)s [options] INPUT [INPUT ...] OUTPUT"
    parser.add_argument(
        "inputs",
        metavar="FILE",
        nargs="+",
        help="files, folders of runs, or - (standard input); the last one is OUTPUT, a file, - "
        "(standard output), or with --format a folder",
    )
    parser.add_argument("--output", "-o", metavar="FILE", help="OUTPUT; all others are then inputs")
    parser.add_argument(
        "--format",
        choices=[kind[1:] for kind in formats.WRITTEN],
        help="OUTPUT is a folder: one file of this format per input, or per leg of a run; or the format "
        "of standard output (default of that: csv)",
    )
    parser.add_argument(
        "--from",
        dest="source_format",
        choices=[kind[1:] for kind in formats.FORMATS],
        default="xyz",
        help="format of standard input (default: %(default)s)",
    )
    parser.add_argument("--merge", action="store_true", help="merge several inputs into one file")
    parser.add_argument("--overwrite", action="store_true", help="replace existing files")
    parser.add_argument(
        "--crs",
        metavar="CRS",
        help="the coordinate system of the output (EPSG:n ...): points in another one are "
        "transformed; an input without one is assumed to be in this one",
    )
    parser.add_argument(
        "--epoch",
        metavar="YEAR",
        type=number(1900, 2200),
        help="epoch of the coordinates for --crs between systems that move with plates, a decimal "
        "year (default: from the GPS times, if these are not seconds of the week)",
    )
    add_height_unit_argument(parser)
    parser.add_argument(
        "--returns",
        choices=RETURNS,
        default="all",
        help="returns to keep: all, first, last, or single ones (default: %(default)s)",
    )
    parser.add_argument(
        "--class",
        dest="classes",
        metavar="N,N",
        type=class_list,
        help="keep only points of these classes",
    )
    parser.add_argument(
        "--every",
        metavar="N",
        type=whole_number(10**9, lowest=1),
        default=1,
        help="keep every Nth point, before other selections (default: %(default)s)",
    )
    parser.add_argument(
        "--skip-invalid", action="store_true", help="drop points that are not finite"
    )
    parser.add_argument(
        "--waveforms",
        choices=["internal", "external"],
        help="LAS and LAZ: store waveform packets in the file, or beside it as .wdp (default: "
        "unchanged)",
    )
    parser.add_argument("--json", action="store_true", help="print the results as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def run(arguments):
    if arguments.output is None:
        arguments.output = arguments.inputs.pop()
    is_text = not (arguments.json or is_standard(arguments.output))
    with Messages(quiet=arguments.quiet, results=is_text) as messages:
        if not arguments.inputs:
            messages.error(f"OUTPUT is missing: the only file is {arguments.output}")
            return 2
        try:
            if is_standard(arguments.output) or NAME in arguments.inputs:
                return convert_standard(arguments, messages)
            if is_document(arguments.inputs[0]) and is_document(arguments.output):
                return convert_document(arguments, messages)
            if arguments.output.lower().endswith(".obj"):
                return _meshes.convert(arguments, messages)
            conversions = plan(arguments)
            refuse(conversions, arguments.overwrite)
            return convert_all(conversions, arguments, messages)
        except formats.FormatError as error:
            messages.error(str(error))
        except OSError as error:
            messages.error(
                f"{error.filename or arguments.output}: cannot be read or written: "
                f"{error.strerror or error}; check permissions and free disk space"
            )
        except MemoryError:
            messages.error("not enough memory; give --every, or fewer inputs")
        return 1


def convert_standard(arguments, messages):
    """Converts standard input, or to standard output; returns an exit code."""
    to_output = is_standard(arguments.output)
    if to_output and arguments.json:
        raise formats.FormatError("-: standard output has the points; leave --json out")
    with folder_of_standard() as folder:
        given = folder / f"standard-input.{arguments.source_format}"
        if arguments.inputs.count(NAME) > 1:
            raise formats.FormatError("-: standard input is one file; give it once")
        if NAME in arguments.inputs:
            read_input(given)
        arguments.inputs = [str(given) if each == NAME else each for each in arguments.inputs]
        if to_output:
            arguments.output = str(folder / f"standard-output.{arguments.format or 'csv'}")
            arguments.format = None
        arguments.label = lambda text: str(text).replace(str(given), NAME)
        try:
            conversions = plan(arguments)
            refuse(conversions, arguments.overwrite)
            code = convert_all(conversions, arguments, messages)
        except formats.FormatError as error:
            raise formats.FormatError(arguments.label(error)) from None
        return code if not to_output or write_output(arguments.output) else 1


def convert_document(arguments, messages):
    """Converts a survey or another document; returns an exit code."""
    source, target = arguments.inputs[0], pathlib.Path(arguments.output)
    if len(arguments.inputs) > 1:
        raise formats.FormatError(
            f"{target}: is one file for several documents; convert one by one"
        )
    if not pathlib.Path(source).exists():
        raise formats.FormatError(f"{source}: no such file or folder; check its name")
    if target.exists() and target.samefile(source):
        raise formats.FormatError(f"{target}: is also an input; give another name")
    if target.exists() and not arguments.overwrite:
        raise formats.FormatError(f"{target}: already exists; give --overwrite to replace it")
    try:
        convert(source, target)
    except ValueError as error:
        raise formats.FormatError(str(error)) from None
    messages.info(f"written  {target}")
    if arguments.json:
        print(json.dumps([{"file": str(target), "inputs": [{"file": source}]}], indent=2))
    return 0


def plan(arguments):
    """Returns the conversions to run."""
    for path in arguments.inputs:
        if not pathlib.Path(path).exists():
            raise formats.FormatError(f"{path}: no such file or folder; check its name")
        if not is_run(path):
            formats.ending(path)
    output = arguments.output
    if arguments.format:
        return plan_folder(arguments)
    if pathlib.Path(output).is_dir():
        raise formats.FormatError(f"{output}: is a folder; give --format for files in it")
    if len(arguments.inputs) > 1 and not arguments.merge and formats.ending(output) != ".e57":
        raise formats.FormatError(
            f"{output}: is one file for {len(arguments.inputs)} inputs; give --merge, or a folder "
            "and --format"
        )
    formats.ending(output)
    inputs = [RunReader(path) if is_run(path) else path for path in arguments.inputs]
    return [make_conversion(arguments, inputs, output)]


def plan_folder(arguments):
    if pathlib.Path(arguments.output).is_file():
        raise formats.FormatError(f"{arguments.output}: is a file; with --format give a folder")
    if arguments.merge:
        raise formats.FormatError(
            f"{arguments.output}: is a folder, for one file per input; leave --merge or --format "
            "out"
        )
    conversions, names = [], {}
    for path in arguments.inputs:
        legs = RunReader(path).files if is_run(path) else [None]
        for leg in legs:
            name = pathlib.Path(leg or path).name
            stem = name[: -len(formats.ending(name))]
            target = pathlib.Path(arguments.output) / f"{stem}.{arguments.format}"
            if target in names:
                raise formats.FormatError(
                    f"{target}: would be the output of both {names[target]} and {path}; convert "
                    "these one by one"
                )
            names[target] = path
            source = RunReader(path, leg) if leg else path
            conversions.append(make_conversion(arguments, [source], target))
    return conversions


def make_conversion(arguments, inputs, output):
    selection = Selection(
        arguments.returns, arguments.classes, arguments.every, arguments.skip_invalid
    )
    return Conversion(
        inputs, output, selection, arguments.crs, arguments.waveforms, arguments.height_unit,
        arguments.epoch,
    )  # fmt: skip


def refuse(conversions, overwrite):
    """Inputs are never overwritten, nor other files without permission."""
    for conversion in conversions:
        sources = []
        for each in conversion.inputs:
            run = isinstance(each, RunReader)
            sources += [each.folder / name for name in each.files] if run else [pathlib.Path(each)]
        inputs = {path.resolve() for path in sources}
        inputs |= {path.with_suffix(".wdp") for path in inputs}
        for path in conversion.files():
            if path.resolve() in inputs and (path.exists() or path == conversion.files()[0]):
                raise formats.FormatError(f"{path}: is also an input; give another name")
        path = conversion.files()[0]
        if path.exists() and not overwrite:
            raise formats.FormatError(f"{path}: already exists; give --overwrite to replace it")


def convert_all(conversions, arguments, messages):
    results = []
    for conversion in conversions:
        task = Task(pathlib.Path(conversion.output).name)
        start = time.monotonic()
        set_outcome(f"{conversion.output} was not written")
        with make_progress(task, messages, quiet=arguments.quiet):
            conversion.run(task)
        set_outcome(f"{conversion.output} is written")
        seconds = time.monotonic() - start
        label = getattr(arguments, "label", str)  # standard input has another name
        conclude(conversion, seconds, messages, label)
        results.append(describe(conversion, seconds, label))
    if arguments.json:
        print(json.dumps(results, indent=2))
    return 0


def describe(conversion, seconds, label):
    """Returns the result of a conversion as a dictionary."""
    return {
        "file": conversion.output,
        "points": conversion.count,
        "bytes": size_of(conversion),
        "seconds": round(seconds, 3),
        "inputs": [
            {"file": label(path), "kind": kind, "points": count}
            for path, kind, count in conversion.kinds
        ],
        "dropped": conversion.lost,
        "skippedPoints": conversion.selection.invalid,
        "warnings": [label(note) for note in dict.fromkeys(conversion.notes)],
    }


def size_of(conversion):
    return sum(path.stat().st_size for path in conversion.files() if path.exists())


def conclude(conversion, seconds, messages, label):
    """Reports the result."""
    for note in dict.fromkeys(conversion.notes):
        messages.warning(label(note))
    for path, kind, count in conversion.kinds:
        messages.info(f"input    {label(path)}: {kind}, {counted(count, 'point')}")
    reasons = {}
    for name, reason in conversion.lost.items():
        reasons.setdefault(reason, []).append(name)
    for reason, names in reasons.items():
        messages.info(f"dropped  {', '.join(names)}: {reason}")
    if conversion.selection.invalid:
        messages.info(
            f"skipped  {counted(conversion.selection.invalid, 'point')} that are not finite"
        )
    size = size_of(conversion)
    messages.info(
        f"output   {conversion.output}: {counted(conversion.count, 'point')}, {readable(size)}, "
        f"{seconds:.2f} s, {conversion.count / max(seconds, 1e-9) / 1e6:.2f} M points/s"
    )
