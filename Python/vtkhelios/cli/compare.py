# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios compare: two clouds by metrics with confidence intervals."""

import pathlib

from .. import formats
from ..comparison import POINTS, SAMPLE
from ..comparison._compare import compare_watched
from ..core.files import cannot_be_written, write_whole
from ..reports import charts
from ..reports.comparison import comparison_lines, write_comparison_page
from ..reports.page import load_template
from ._messages import Messages, shown_problems
from ._parser import number, whole_number
from ._progress import make_progress
from ._stopping import set_outcome
from ._task import StepWatch
from ._units import add_height_unit_argument

SUMMARY = "compare two clouds: returns, spacing, planes, heights, distances, with intervals"

EPILOG = """\
input: A and B are each a file of points (see vtkhelios convert --help), the folder of a run, or a
folder of files and runs. Both have the same coordinate system; nothing is moved.

what it measures, of A, of B, and their difference with its 95 % confidence interval:
  not dependent on density   returns per pulse, multi-return share, spacing along and across scan
                             lines, mean height and height profile, noise and offset of planes that
                             both have, amplitude (or intensity), echo width, occluded cells
  dependent on density       density, nearest-neighbour spacing, distance to the other cloud
  by class                   share of points, returns per pulse, mean height
  with --mesh                signed distances to a mesh, positive on the side of its normals
What an input cannot give is listed as "not measured", with the reason.

registration: the shift of B against A that the planes of both show is printed, for each axis that
they determine. Clouds that share no ground are compared as wholes, without planes and distances.

intervals: points next to each other are not independent. The ground is divided into about 250 tiles,
and 400 times as many tiles are drawn with replacement, each with all its points of both clouds.
One in twenty intervals misses its value by chance. Histograms agree if they differ by less than 95 %
of the pairs that result when both clouds are exchanged in a random half of the tiles.

output: a table; --output page.html writes a page, and page.json beside it. The page needs matplotlib
and Jinja2: apt-get install python3-matplotlib python3-jinja2. See Docs/compare.md.

examples:
  vtkhelios compare real.laz output/village_als
  vtkhelios compare real.laz simulated.laz --output comparison.html
  vtkhelios compare strips_2023 strips_2024 --mesh city.obj --cell 0.5
  vtkhelios compare a.laz b.laz --json > comparison.json

exit codes: 0 done, also if the clouds differ; 1 failed (the reason is on standard error), 2 wrong
usage, 130 interrupted (nothing is written).
"""

OPTIONS = ("mesh", "cell", "points", "sample", "seed", "height_unit")


def add_arguments(parser):
    parser.epilog = EPILOG
    for name in "AB":
        parser.add_argument(
            name.lower(), metavar=name, help="a file, the folder of a run, or a folder of these"
        )
    parser.add_argument(
        "--mesh",
        metavar="FILE",
        help="also measure distances to this mesh (.obj, .tif, .ply, .stl, .gltf, .glb, CityJSON)",
    )
    parser.add_argument(
        "--cell",
        metavar="M",
        type=number(1e-3, 1e5),
        help="side of the cells of planes and occlusion [m] (default: the smallest power of two "
        "with 16 points in the median cell of either cloud)",
    )
    parser.add_argument(
        "--points",
        metavar="N",
        type=whole_number(10**9, lowest=1000),
        default=POINTS,
        help="maximum points of a cloud in memory; of larger clouds a random part of the tiles is "
        "compared, the same of both (default: %(default)s)",
    )
    parser.add_argument(
        "--sample",
        metavar="N",
        type=whole_number(10**8, lowest=10),
        default=SAMPLE,
        help="points of a cloud whose distances are measured (default: %(default)s)",
    )
    parser.add_argument(
        "--seed",
        metavar="N",
        type=whole_number(2**31 - 1),
        default=0,
        help="of tiles, samples and intervals (default: %(default)s)",
    )
    add_height_unit_argument(parser)
    parser.add_argument(
        "--output", "-o", metavar="FILE.html", help="write a page, and its JSON beside it"
    )
    parser.add_argument("--overwrite", action="store_true", help="replace existing files")
    parser.add_argument("--json", action="store_true", help="print the results as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def run(arguments):
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        try:
            with shown_problems(messages):
                return compare_files(arguments, messages)
        except ImportError as error:
            messages.error(f"{error}; or leave --output out")
        except formats.FormatError as error:
            messages.error(str(error))
        except MemoryError:
            messages.error("not enough memory; give fewer --points")
        return 1


def compare_files(arguments, messages):
    files = find_output(arguments)
    if files:
        charts.load()  # before all points are read
        load_template()
    set_outcome("nothing was written")
    result = measure(arguments, messages)
    for note in result.notes:
        messages.warning(note)
    for line in comparison_lines(result):
        messages.info(line)
    if arguments.json:
        print(result.to_json())
    if files:
        write(result, files)
        set_outcome(f"{files[0]} and {files[1]} are written")
        messages.info(f"written  {files[0]}, {files[1]}")
    return 0


def find_output(arguments):
    """Returns the page and the JSON file, or nothing; FormatError for names that cannot be used."""
    if not arguments.output:
        return ()
    page = pathlib.Path(arguments.output)
    if page.suffix.lower() != ".html":
        raise formats.FormatError(f"{page}: does not end in .html; give --output such a name")
    files = page, page.with_suffix(".json")
    for path in files:
        if path.exists() and not arguments.overwrite:
            raise formats.FormatError(f"{path}: already exists; give --overwrite to replace it")
    return files


def measure(arguments, messages):
    watch = StepWatch()
    options = {name: getattr(arguments, name) for name in OPTIONS}
    with make_progress(watch, messages, quiet=arguments.quiet):
        return compare_watched(arguments.a, arguments.b, watch.on_step, **options)


def write(result, files):
    texts = write_comparison_page(result), result.to_json() + "\n"
    for path, text in zip(files, texts):
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_whole(path, text)
        except OSError as error:
            raise formats.FormatError(cannot_be_written(error, path, "--output")) from error
