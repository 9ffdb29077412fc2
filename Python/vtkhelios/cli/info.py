# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios info: describes and checks points, a run, a mesh or a survey; lists the scanners."""

import json
import pathlib

from .. import formats
from ..core.reading import is_document
from ..core.words import counted
from ..formats._names import NAME_KEYS
from . import _meshes
from ._inspect import Inspection, inspect_xml
from ._meshes import describe_crs
from ._messages import Messages
from ._progress import make_progress
from ._reading import add_assets_argument
from ._standard import NAME, folder_of_standard, is_standard, read_input
from ._task import Task
from ._units import add_height_unit_argument
from .list_ import list_entries

SUMMARY = "describe and check a file of points, a run, a mesh or a survey; list the scanners"
STANDARD = ("path",)

EPILOG = """\
Points, in any format of vtkhelios convert, and the folder of a run: format, bounds, spacing,
coordinate system, times, returns, classes, arrays; for LAS and LAZ also scale and offset, Extra Bytes,
waveforms, header records and extended records. All points are read, in chunks, and checked: counts and bounding box of
the header, return numbers, decreasing times, points that are not finite. Problems are warnings.

Meshes (.obj, .tif, .vrt, .stl, .gltf, .glb, .json and .jsonl: CityJSON, .ply with faces): triangles,
bounds, area, coordinate system, materials.

Surveys (.xml, .yaml): legs, scanner, platform, scene; vtkhelios validate lists their errors. Other
documents: their scenes with the parts, platforms, scanners and plans.

--scanners WORDS is vtkhelios list scanners WORDS.

examples:
  vtkhelios info leg000_points.laz
  vtkhelios info output/village --json
  vtkhelios convert village.laz - | vtkhelios info - --from csv
  vtkhelios info survey.xml --assets my_scenes
  vtkhelios info --scanners "riegl terrestrial"

exit codes: 0 done (with warnings or without), 1 failed, 2 wrong usage, 130 interrupted.
"""

MOST = 12  # maximum listed legs


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument(
        "path",
        metavar="FILE|RUN|SURVEY",
        nargs="?",
        help="points, a run, a mesh, or a survey or other document (.xml, .yaml); - is points of "
        "standard input",
    )
    parser.add_argument(
        "--from",
        dest="source_format",
        choices=[kind[1:] for kind in formats.FORMATS],
        default="xyz",
        help="format of standard input (default: %(default)s)",
    )
    parser.add_argument(
        "--scanners",
        metavar="WORDS",
        nargs="?",
        const="",
        help="list the scanners of the catalogue that have these words (default: all)",
    )
    add_assets_argument(parser)
    add_height_unit_argument(parser)
    parser.add_argument("--json", action="store_true", help="print it as a JSON object")


def run(arguments):
    with Messages(results=not arguments.json) as messages:
        if (arguments.path is None) == (arguments.scanners is None):
            messages.error("give a file, a run or a survey, or --scanners for the catalogue")
            return 2
        if arguments.scanners is not None:
            return list_entries(
                "scanners", arguments.scanners, arguments.assets, arguments.json, messages
            )
        if is_standard(arguments.path):
            return inspect_standard(arguments, messages)
        if not pathlib.Path(arguments.path).exists():
            messages.error(f"{arguments.path}: no such file or folder; check its name")
            return 1
        if is_document(arguments.path):
            facts = inspect_xml(arguments.path, arguments.assets, messages)
            return print_facts(facts, [], arguments, messages) if facts else 1
        if _meshes.is_mesh(arguments.path):
            facts = _meshes.inspect(arguments.path, messages)
            return print_facts(facts, [], arguments, messages) if facts else 1
        return inspect_points(arguments.path, arguments, messages)


def inspect_standard(arguments, messages):
    """Describes points of standard input; returns the exit code."""
    with folder_of_standard() as folder:
        given = str(read_input(folder / f"standard-input.{arguments.source_format}"))
        if not arguments.source_format.endswith(("las", "laz")) and starts_as_las(given):
            messages.error("-: begins as LAS, LAZ or COPC; give --from las, laz or copc.laz")
            return 1
        return inspect_points(given, arguments, messages, lambda text: text.replace(given, NAME))


def starts_as_las(path):
    with open(path, "rb") as file:
        return file.read(4) == b"LASF"


def inspect_points(path, arguments, messages, label=str):
    """Describes points of a file or a run; returns the exit code."""
    inspection = Inspection(path, arguments.height_unit)
    task = Task("reading")
    try:
        with make_progress(task, messages):
            inspection.run(task)
    except (formats.FormatError, OSError) as error:
        messages.error(label(str(error)))
        return 1
    facts = {**inspection.facts, "file": label(inspection.facts["file"])}
    warnings = [label(warning) for warning in inspection.warnings]
    return print_facts(facts, warnings, arguments, messages)


def print_facts(facts, warnings, arguments, messages):
    if arguments.json:
        print(json.dumps({**facts, "warnings": warnings}, indent=2))
        return 0
    for line in lines_of(facts):
        messages.info(line)
    for warning in warnings:
        messages.warning(warning)
    return 0


def lines_of(facts):
    if "triangles" in facts:
        return _meshes.describe_lines(facts)
    if "scenes" in facts:
        return document_lines(facts)
    return survey_lines(facts) if "scanner" in facts else point_lines(facts)


def point_lines(facts):
    """Yields the facts of points."""
    yield f"format     {facts['format']}"
    yield f"points     {facts['points']:,}"
    if "bounds" in facts:
        yield from _meshes.bounds_lines(facts)
        if facts["spacing_m"] is not None:
            yield (
                f"spacing    about {facts['spacing_m']:.3g} m, in plan view: "
                f"{facts['density_m2']:.3g} points/m²"
            )
    yield f"crs        {describe_crs(facts['crs'])}"
    if "gpsTime_s" in facts:
        first, last = facts["gpsTime_s"].values()
        epoch = f", since {facts['gpsEpoch_s']:.0f} s of GPS time" if "gpsEpoch_s" in facts else ""
        yield f"time       {first:.6f} to {last:.6f} s{epoch}"
    for name in ("returns", "classes"):
        if facts[name]:
            total = max(1, sum(facts[name].values()))
            shares = (f"{key}: {n:,} ({100 * n / total:.1f} %)" for key, n in facts[name].items())
            yield f"{name:10} {', '.join(shares)}"
    yield from leg_lines(facts["legs"])
    for key in NAME_KEYS:
        yield from name_lines(key, facts.get(key, []))
    if "scale" in facts:
        yield f"scale      {facts['scale']}, offset {facts['offset']}"
        yield f"written by {facts['software'] or '?'} ({facts['system'] or '?'})"
    if "waveforms" in facts:
        yield f"waveforms  {facts['waveforms']['packets']}, {facts['waveforms']['bytes']:,} bytes"
    yield from array_lines(facts["arrays"])
    for extra in facts.get("extraBytes", []):
        yield f"extra      {extra['name']} ({extra['type']}): {extra['description'] or 'no description'}"
    for record in facts.get("headerRecords", []):
        yield f"record     {record['user']} {record['id']}: {record['description']}"
    for record in facts.get("extendedRecords", []):
        size = counted(record["bytes"], "byte")
        words = record["description"] or "no description"
        yield f"extended   {record['user']} {record['id']}, {size}: {words}"


def name_lines(key, entries):
    """Yields the names of parts or materials, the most frequent first."""
    if entries:
        entries = sorted(entries, key=lambda entry: -entry["points"])
        shown = [f"{each['name'] or each['id']}: {each['points']:,}" for each in entries[:MOST]]
        more = f", and {len(entries) - MOST} more" if len(entries) > MOST else ""
        yield f"{key:10} {', '.join(shown)}{more}"


def leg_lines(legs):
    if legs:
        shown = [f"{leg}: {count:,}" for leg, count in list(legs.items())[:MOST]]
        more = f", and {len(legs) - MOST} more" if len(legs) > MOST else ""
        yield f"legs       {', '.join(shown)}{more}"


def array_lines(arrays):
    words = []
    for array in arrays:
        size = f" x {array['components']}" if array["components"] > 1 else ""
        unit = f" [{array['unit']}]" if array["unit"] else ""
        words.append(f"{array['name']}{unit} ({array['type']}{size})")
    if words:
        yield f"arrays     {', '.join(words)}"


def document_lines(facts):
    """Yields the facts of a document without a survey."""
    yield f"document   {facts['file']}"
    for scene in facts["scenes"]:
        yield f"scene      {scene['id']}, {scene['name']}: {_count(scene['parts'], 'part')}"
        for part in scene["parts"][:MOST]:
            files = ", ".join(part["files"]) or "no file"
            yield f"part       {part['id'] or '-'}: {', '.join(part['filters'])}; {files}"
        if len(scene["parts"]) > MOST:
            yield f"           and {len(scene['parts']) - MOST} more"
        for table in scene["tables"]:
            yield f"table      {table or 'no file'}: a part for each row"
    for kind in ("platforms", "scanners", "plans"):
        if facts[kind]:
            yield f"{kind:10} {len(facts[kind])}: {', '.join(facts[kind])}"


def _count(things, word):
    return f"{len(things)} {word}{'s'[: len(things) != 1]}"


def moving_lines(parts):
    """Yields the parts that move, and how."""
    for index, part in enumerate(parts[:MOST]):
        yield f"{'' if index else 'moving':10} {part['part']}: {part['motion']}"
    if len(parts) > MOST:
        yield f"           and {len(parts) - MOST} more"


def survey_lines(facts):
    yield f"survey     {facts['name']} ({facts['file']})"
    yield f"scanner    {facts['scanner']}"
    yield f"platform   {facts['platform']}, {'moving' if facts['moving'] else 'static'}"
    yield f"scene      {facts['scene']}"
    yield from moving_lines(facts["movingParts"])
    if facts["epochs"] > 1:
        yield f"epochs     {facts['epochs']}"
    yield f"legs       {len(facts['legs'])}, {sum(leg['active'] for leg in facts['legs'])} active"
    for leg in facts["legs"][:MOST]:
        x, y, z = leg["position_m"]
        state = "" if leg["active"] else ", not active"
        ground = " above ground" if leg["onGround"] else ""
        yield (
            f"leg {leg['leg']:<6} ({x:.3f}, {y:.3f}, {z:.3f}) m{ground}, "
            f"{leg['pulseFrequency_Hz']:g} pulses/s, {leg['scanFrequency_Hz']:g} lines/s{state}"
        )
    if len(facts["legs"]) > MOST:
        yield f"           and {len(facts['legs']) - MOST} more"
