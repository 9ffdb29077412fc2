# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios report: a page of maps, histograms and numbers of a run."""

import json
import pathlib

from .. import formats
from ..core.files import cannot_be_written, write_whole
from ..core.run_files import SUMMARY_NAME
from ..core.words import counted
from ..formats._base import rows_of
from ..formats._run import RunReader, is_run
from ..formats._summary import REPORT, check_summary
from ..reports import charts
from ..reports.figures import Figures
from ..reports.page import load_template, write_page
from ..reports.run import readable
from ._messages import Messages
from ._parser import number, whole_number
from ._progress import make_progress
from ._stopping import set_outcome
from ._task import Task
from ._web import ReportCloud

SUMMARY = "write a report page of a run in HTML: maps, histograms, timings, inputs, the cloud"

EPILOG = """\
what the page shows: maps of the density and of the overlap, coverage, range, angle of incidence,
amplitude, echo width, echoes per pulse, classes, a table of the legs, timings, options, and the inputs
with their SHA-256. It needs no network. A second page beside it, report_cloud.html, shows the points
themselves: colours by any array, values and waveform of a picked point (see vtkhelios view --html).

For text runs (.xyz) ranges are computed from the trajectory, and incidence is not known: run with
--format las or vtp to store both. Points are read once, in chunks: memory does not grow with the run.

Needs matplotlib and Jinja2: apt-get install python3-matplotlib python3-jinja2.

examples:
  vtkhelios report output/village_als
  vtkhelios report output/village_als --output village.html --cell 0.5
  vtkhelios report output/village_als --cloud-points 0        without the page of the cloud

exit codes: 0 done, 1 failed (the reason is on standard error), 2 wrong usage, 130 interrupted.
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("folder", metavar="RUN", help="the folder of a run")
    parser.add_argument(
        "--output",
        "-o",
        metavar="FILE",
        help="the page (default: report.html in the folder of the run)",
    )
    parser.add_argument(
        "--cell",
        metavar="M",
        type=number(1e-3, 1e5),
        help="cell size of maps, coverage and overlap [m] (default: a power of two, with at most "
        "512 cells per side)",
    )
    parser.add_argument(
        "--cloud-points",
        metavar="N",
        type=whole_number(20_000_000),
        default=1_000_000,
        help="the most points of the page of the cloud, a sample of all; 0: no such page "
        "(default: %(default)s)",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace existing pages")
    parser.add_argument("--json", action="store_true", help="also print the numbers as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def run(arguments):
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        try:
            return make_report(arguments, messages)
        except ImportError as error:
            messages.error(str(error))
        except formats.FormatError as error:
            messages.error(str(error))
        except OSError as error:
            messages.error(
                f"{error.filename or arguments.folder}: {error.strerror}; choose another --output"
            )
        return 1


def make_report(arguments, messages):
    folder = pathlib.Path(arguments.folder)
    if not is_run(folder):
        problem = "is a file" if folder.is_file() else "no such folder"
        raise formats.FormatError(f"{folder}: {problem}; give the folder of a run")
    page = pathlib.Path(arguments.output or folder / "report.html")
    set_outcome(f"{page} was not written")
    cloud_page = ReportCloud(page, arguments.cloud_points)
    for path in filter(None, (page, cloud_page.path)):
        if path.exists() and not arguments.overwrite:
            raise formats.FormatError(f"{path}: already exists; give --overwrite to replace it")
    charts.load()  # before all points are read
    load_template()
    figures = Figures(arguments.cell)
    with RunReader(folder) as reader:
        check_summary(reader.summary, folder / SUMMARY_NAME, REPORT)
        task = Task("reading", reader.count)
        reader.keeps_invalid = True  # they are an error
        cloud_page.begin(reader)
        with make_progress(task, messages, quiet=arguments.quiet):
            for chunk in reader.chunks():
                figures.add(chunk, reader)
                cloud_page.add(chunk)
                task.advance(rows_of(chunk))
        if figures.count == 0:
            raise formats.FormatError(f"{folder}: has no points; run the survey again")
        try:
            page.parent.mkdir(parents=True, exist_ok=True)
            link = cloud_page.write()
            text = write_page(reader.summary, figures, reader, link)
            write_whole(page, text)
            set_outcome(f"{page} is written")
        except OSError as error:
            raise formats.FormatError(cannot_be_written(error, page, "--output")) from error
    for note in reader.notes:
        messages.warning(note)
    messages.info(
        f"report   {page} ({readable(len(text.encode()))}), {counted(figures.count, 'point')}"
    )
    if link:
        messages.info(f"cloud    {cloud_page.path} ({link['size']}), {link['points']} points")
    if arguments.json:
        print(json.dumps(figures.to_dict(), indent=2))
    return 0
