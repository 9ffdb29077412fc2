# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios view --html: the cloud of a run, of a file or of a survey as a page."""

import pathlib
import sys

from ... import formats
from ...core.files import cannot_be_written, write_whole
from ...core.pipeline import PipelineError
from ...core.plugins import load_plugin
from ...core.reading import is_document
from ...core.words import counted
from ...reports.run import readable
from ...surveys.survey import read_survey
from ...webcloud import LIMIT, Contents
from .._messages import Messages
from .._parser import Parser, whole_number
from .._progress import make_progress
from .._reading import add_assets_argument
from .._stopping import set_outcome
from .._task import Task
from ._arrays import NAMES, find_array

MAXIMUM_POINTS = 20_000_000

DESCRIPTION = """\
writes a point cloud as one HTML file that needs no network: levels of detail, colours by any array,
values and waveform of a picked point, distances. See Docs/viewer.md.
"""

EPILOG = f"""\
the cloud: a file (.xyz .csv .txt .asc .pts .ptx .las .laz .copc.laz .vtp .pvtp .ply .pcd .e57), the
folder of a run, or a survey (.xml, .yaml), which is run in memory. Of more than --points points a sample is taken.

examples:
  vtkhelios view output/village --html village.html
  vtkhelios view yard.laz --html yard.html --color-by Intensity --points 3000000
  vtkhelios view survey.xml --html survey.html --waveforms

--color-by also takes {", ".join(NAMES)}.
"""


def make_parser():
    parser = Parser(prog="vtkhelios view", description=DESCRIPTION, epilog=EPILOG)
    parser.add_argument(
        "input", metavar="CLOUD", help="a file of points, a run, or a survey (.xml, .yaml)"
    )
    parser.add_argument("--html", metavar="FILE", required=True, help="the page")
    parser.add_argument(
        "--points", metavar="N", type=whole_number(MAXIMUM_POINTS, 1), default=LIMIT,
        help="the most points of the page; 1,000,000 take about 20 MB (default: %(default)s)",
    )  # fmt: skip
    parser.add_argument("--color-by", metavar="ARRAY", help="the array of the first view (default: the "
                        "classes if there are several, else the colours, else the height)")  # fmt: skip
    parser.add_argument("--arrays", metavar="A,B", help="only these arrays (default: all)")
    parser.add_argument(
        "--waveforms", action="store_true", help="of a survey: also compute waveforms"
    )
    add_assets_argument(parser)
    parser.add_argument("--overwrite", action="store_true", help="replace an existing page")
    parser.add_argument("--quiet", action="store_true", help="print errors only")
    return parser


def start(words):
    """Writes the page; returns the exit code."""
    if {"-h", "--help"} & set(words):  # also without FILE
        words = ["--help"]
    arguments = make_parser().parse_args(words)
    with Messages(quiet=arguments.quiet) as messages:
        try:
            return _write(arguments, messages)
        except (formats.FormatError, PipelineError, FileNotFoundError) as error:
            messages.error(str(error))
        except OSError as error:
            messages.error(cannot_be_written(error, arguments.html, "--html"))
        return 1


def _write(arguments, messages):
    page = pathlib.Path(arguments.html)
    set_outcome(f"{page} was not written")
    if page.exists() and not arguments.overwrite:
        raise formats.FormatError(f"{page}: already exists; give --overwrite to replace it")
    contents = _read(arguments, messages)
    write_page(contents, page, find_array(arguments.color_by, contents))
    set_outcome(f"{page} is written")
    shown = min(contents.sample.limit, contents.sample.count)
    messages.info(
        f"page     {page} ({readable(page.stat().st_size)}), {shown:,} of {counted(contents.sample.count, 'point')}"
    )
    return 0


def write_page(contents, page, colour_by=None):
    """Writes the page of contents to a path."""
    text = contents.make_page(colour_by)
    page.parent.mkdir(parents=True, exist_ok=True)
    write_whole(page, text)


def _read(arguments, messages):
    """Returns the Contents of the input."""
    names = arguments.arrays.split(",") if arguments.arrays else None
    if is_document(arguments.input):
        contents = _run_survey(arguments, names)
    else:
        contents = _read_points(arguments, names, messages)
    _check_names(names, contents, arguments.input)
    return contents


def _run_survey(arguments, names):
    for file in arguments.plugin:
        load_plugin(file)
    survey = read_survey(arguments.input, arguments.assets)
    cloud = survey.run(
        progress=sys.stderr.isatty() and not arguments.quiet, waveforms=arguments.waveforms
    )
    return Contents.of_cloud(cloud, pathlib.Path(arguments.input).stem, arguments.points, names)


def _read_points(arguments, names, messages):
    with formats.open_reader(arguments.input) as reader:
        contents = Contents.of_reader(reader, arguments.points, names)
        task = Task("reading", reader.count)
        with make_progress(task, messages, quiet=arguments.quiet):
            for chunk in reader.chunks():
                task.advance(contents.add(chunk))
    for note in [*reader.notes, *filter(None, [contents.note])]:
        messages.warning(note)
    if dropped := contents.sample.dropped:
        messages.warning(
            f"{arguments.input}: {', '.join(sorted(dropped))}: not in all of its files; left out"
        )
    return contents


def _check_names(names, contents, path):
    """FormatError for an array of --arrays that the cloud does not have."""
    known = contents.sample.columns()
    for name in names or ():
        if name not in known:
            has = ", ".join(sorted(set(known) - {"points", "index"})) or "none"
            raise formats.FormatError(
                f"{path}: has no array {name} for --arrays; of those it has: {has}"
            )
