# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios doctor: what is installed, what works, what is missing and for what."""

import json

from ..core import diagnosis
from ._messages import Messages
from .view import find_viewer

SUMMARY = "list what is installed, what works, what is missing and for what"

EPILOG = """\
states:
  works     it is there and does its work
  missing   it is not installed; what it is for works when it is
  broken    it is installed and cannot be used, for the reason given

Each package of Python is imported in a process of its own, as some end the process. Nothing is
installed or changed. The commands keep the major version of numpy that is installed: packages of the
system are built for it.

examples:
  vtkhelios doctor
  vtkhelios doctor --json

exit codes: 0 nothing is broken; 1 something is; 2 wrong usage.
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("--json", action="store_true", help="print it as a JSON object")


def run(arguments):
    report = diagnosis.make_report(find_viewer())
    broken = [each for each in diagnosis.all_parts(report) if each["state"] == diagnosis.BROKEN]
    if arguments.json:
        print(json.dumps(report, indent=2))
        return int(bool(broken))
    with Messages() as messages:
        for title, parts in report.items():
            messages.info(title)
            for part in parts:
                messages.info(describe(part))
        for part in broken:
            messages.error(f"{part['name']}: {part['cure']}")
    return int(bool(broken))


def describe(part):
    """Returns the line of a part."""
    found = " ".join(filter(None, (part["version"], part["place"]))) or part["for"]
    use = f"; for {part['for']}" if part["for"] and found != part["for"] else ""
    cure = f"; {part['cure']}" if part["cure"] and part["state"] == diagnosis.MISSING else ""
    return f"  {part['state']:8} {part['name']:22} {found}{use}{cure}"
