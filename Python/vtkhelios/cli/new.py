# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios new: a folder with an example survey to start from."""

import json
import os
import pathlib
import shlex

from ..core.files import cannot_be_written
from ..example_surveys import COMMANDS, KINDS, write_example
from ._messages import Messages

SUMMARY = "make a folder with a small scene, a survey and a README"

EPILOG = f"""\
kinds:
{chr(10).join(f"  {kind:8} {text}" for kind, text in KINDS.items())}

The survey is NAME/NAME.xml, the scene is NAME/scene.xml; NAME/README.md describes the files and what to
try. Every file may be changed. The same kind has the same bytes.

examples:
  vtkhelios new yard
  vtkhelios new stand --kind forest
  vtkhelios run stand/stand.xml --output stand/output

exit codes: 0 done, 1 failed: the folder exists or cannot be written, 2 wrong usage.
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("name", metavar="NAME", help="the new folder")
    parser.add_argument(
        "--kind",
        metavar="KIND",
        choices=list(KINDS),
        default="tls",
        help="what to make: %(choices)s (default: %(default)s)",
    )
    parser.add_argument("--json", action="store_true", help="print the files as JSON")


def run(arguments):
    with Messages(results=not arguments.json) as messages:
        try:
            files = write_example(arguments.kind, arguments.name)
        except FileExistsError as error:
            messages.error(str(error))
            return 1
        except OSError as error:
            messages.error(cannot_be_written(error, arguments.name, "NAME"))
            return 1
        folder = pathlib.Path(os.path.abspath(arguments.name))
        names = ", ".join(sorted(str(path.relative_to(folder)) for path in files))
        messages.info(f"{arguments.name}: {KINDS[arguments.kind]}: {names}")
        if arguments.json:
            result = {
                "folder": arguments.name,
                "kind": arguments.kind,
                "survey": f"{folder.name}.xml",
            }
            print(json.dumps({**result, "files": names.split(", ")}, indent=2))
        messages.info("to run it:")
        messages.info(f"  cd {shlex.quote(arguments.name)}")
        for words in COMMANDS.get(arguments.kind, ("run {0}.xml",)):
            messages.info(f"  vtkhelios {words.format(shlex.quote(folder.name))}")
        return 0
