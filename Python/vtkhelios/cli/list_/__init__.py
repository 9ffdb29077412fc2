# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios list: what a survey may name."""

import json

from ...core.reading import missing_folder
from ...core.words import counted
from .._messages import Messages
from .._reading import add_assets_argument
from . import _platforms, _scanners, _scenes

SUMMARY = "list what a survey may name: scanners, platforms, scenes"

EPILOG = """\
The first column is the name in a survey, as scanner="scanners.xml#riegl_vz400".

scanners and platforms: those of vtkHelios, and of the XML files in the folders of --assets and in their
subfolders. scenes: of the XML files in the working directory and in the folders of --assets; vtkHelios
has none, vtkhelios new makes some.

With words, those that have all of them: scanners in their id, name, maker, use (terrestrial, mobile,
unmanned, airborne, spaceborne) or optics; platforms in their id, name or type; scenes in their id or name.

examples:
  vtkhelios list scanners
  vtkhelios list scanners riegl terrestrial
  vtkhelios list platforms multicopter --json
  vtkhelios list scenes --assets my_scenes

exit codes: 0 done, 1 nothing found, or a folder is missing, 2 wrong usage.
"""

KINDS = {"scanners": _scanners, "platforms": _platforms, "scenes": _scenes}


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument(
        "kind", metavar="scanners|platforms|scenes", choices=list(KINDS), help="what to list"
    )
    parser.add_argument(
        "words", metavar="WORD", nargs="*", help="list those with these words (default: all)"
    )
    add_assets_argument(parser)
    parser.add_argument("--json", action="store_true", help="print it as a JSON object")


def run(arguments):
    with Messages(results=not arguments.json) as messages:
        return list_entries(
            arguments.kind, " ".join(arguments.words), arguments.assets, arguments.json, messages
        )


def list_entries(kind, text, assets, as_json, messages):
    """Prints the entries of a kind of KINDS that have the words of a text; returns the exit code."""
    if problem := missing_folder(assets):
        messages.error(problem)
        return 1
    module = KINDS[kind]
    found = module.find(text, assets, messages.warning)
    if not found:
        messages.error(module.explain_none(text))
        return 1
    if as_json:
        print(json.dumps({kind: [module.facts_of(each) for each in found]}, indent=2))
        return 0
    rows = [module.COLUMNS, *map(module.row_of, found)]
    widths = [max(len(row[k]) for row in rows) for k in range(len(module.COLUMNS))]
    for row in rows:
        messages.info("  ".join(map(str.ljust, row, widths)).rstrip())
    messages.info(f"{counted(len(found), kind.removesuffix('s'))}. {module.LEGEND}")
    return 0
