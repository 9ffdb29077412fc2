# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios schema: the XML dialect as a schema, or as tables."""

import pathlib

import vtkhelios

from ..core.files import cannot_be_written, write_whole
from ._messages import Messages
from ._stopping import set_outcome

SUMMARY = "write the XML schema of surveys, scenes, scanners and platforms, or tables of it"

EPILOG = """\
The schema is made from the table that vtkhelios validates files with. Editors use it to complete
names and show their documentation; name it on the root element of a file:

  <document xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
            xsi:noNamespaceSchemaLocation="helios.xsd">

examples:
  vtkhelios schema > helios.xsd
  vtkhelios schema --output Data/Schemas    all files: one schema, under the HELIOS file names
  vtkhelios schema --tables                 every element and attribute as Markdown

exit codes: 0 done, 1 failed, 2 wrong usage.
"""

# The schema names in HELIOS files: the same dialect.
KINDS = ("platform", "scanner", "scene", "survey")

INCLUDE = """\
<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors -->
<!-- SPDX-License-Identifier: BSD-3-Clause -->
<!-- Made by vtkhelios schema: any file holds any mix of surveys, scenes, scanners, platforms. -->
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">
  <xs:include schemaLocation="helios.xsd"/>
</xs:schema>
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    what = parser.add_mutually_exclusive_group()
    what.add_argument(
        "--output",
        "-o",
        metavar="DIR",
        help="write helios.xsd and the files that include it to this folder",
    )
    what.add_argument("--tables", action="store_true", help="print the tables of Docs/dialect.md")


def make_files():
    """Returns the files of Data/Schemas: a dict from name to text."""
    files = {f"{kind}.xsd": INCLUDE for kind in KINDS}
    return {"helios.xsd": vtkhelios.vtkHeliosDialect.GetSchema(), **files}


def run(arguments):
    if arguments.tables:
        print(vtkhelios.vtkHeliosDialect.GetTables(), end="")
        return 0
    set_outcome("files with their final names are complete")
    files = make_files()
    if not arguments.output:
        print(files["helios.xsd"], end="")
        return 0
    folder = pathlib.Path(arguments.output)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            write_whole(folder / name, text)
    except OSError as error:
        with Messages() as messages:
            messages.error(cannot_be_written(error, folder, "--output"))
        return 1
    print("\n".join(str(folder / name) for name in files))
    return 0
