# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line. A subcommand is one module of this package.

To add one: a module or a package, named as the subcommand (no leading underscore; a trailing one if
it is the name of a function of Python: list_), with

SUMMARY                 one line for ``vtkhelios --help``
add_arguments(parser)   its arguments; also parser.description and parser.epilog
run(arguments)          does it and returns the exit code
STANDARD                the arguments that may be - (standard input or output); default: none

or, where the arguments are another program's, instead of the last two

start(arguments)        does it, given the arguments as words, and returns the exit code

Signals end a command wherever it is (_stopping.py): what writes files calls set_outcome(), gives
them their names when they are complete, and runs C++ that takes long by run_native() or update().

Exit codes: 0 done, 1 failed, 2 wrong usage, 130 interrupted (143 terminated).
"""

import importlib
import pkgutil
import sys

from ..core.plugins import PluginError
from ..core.streams import standard_streams
from ..vtkHeliosFiltersCore import vtkHeliosVersion
from ._messages import say_error
from ._parser import Parser
from ._reading import load_plugins
from ._standard import explain_unsupported
from ._stopping import Stopping, is_stopping, leave, report_stop

DESCRIPTION = (
    "Simulates LiDAR surveys: reads a survey file and writes the echoes that the scanner would "
    "record. Also plans surveys: finds the positions to scan a scene from."
)

EPILOG = """\
examples:
  vtkhelios new yard --kind tls                     make a small scene and its survey, to start from
  vtkhelios run survey.xml                          run a survey; files go to ./output
  vtkhelios run survey.xml --assets my_scenes       also search my_scenes for scenes and scanners
  vtkhelios run --help                              all options and outputs of a run
  vtkhelios join output/village                     join the parts of a run of several computers
  vtkhelios plan scene.xml                          find scan positions, write them as a survey
  vtkhelios validate survey.xml                     list all its errors and warnings
  vtkhelios tradeoff survey.xml                     accuracy against time, what its scene requires
  vtkhelios view survey.xml                         watch it run
  vtkhelios detect leg000_fullwave.pvtt -o a.xyz    re-run echo detection on stored waveforms
  vtkhelios convert output/village village.laz      points to LAS, LAZ, COPC, E57, PLY, PCD, VTK, text
  vtkhelios instrument os1.json -o os1.xml          a scanner from the metadata of an Ouster sensor
  vtkhelios export output/street kitti --kitti      a run as KITTI, SemanticKITTI, S3DIS or MCAP
  vtkhelios info village.laz                        contents of a file, a run or a survey
  vtkhelios report output/village                   a report page of a run: maps, histograms, timings
  vtkhelios list scanners riegl                     what a survey may name
  vtkhelios doctor                                  what is installed, what is missing and for what
  vtkhelios help run                                describe a command
  vtkhelios compare real.laz output/village         two clouds: noise, spacing, returns, shift, heights
  vtkhelios fit real.laz --output fitted            the instrument and the flight of a cloud, as a survey
  vtkhelios leafarea output/stand                   plant area density in voxels, leaf area index

exit codes: 0 done, 1 failed (the reason is on standard error), 2 wrong usage, 130 interrupted
"""


def module_names():
    """Returns the modules of the subcommands: a dict from the name of each subcommand to its
    module's name."""
    found = [info.name for info in pkgutil.iter_modules(__path__) if not info.name.startswith("_")]
    return {name.rstrip("_"): name for name in found}


def command_names():
    """Returns the names of the subcommands, sorted."""
    return sorted(module_names())


def commands(names=None):
    """Returns the subcommands, all or those of given names: a dict from name to module."""
    modules = module_names()
    names = sorted(modules) if names is None else names
    return {name: importlib.import_module(f"{__name__}.{modules[name]}") for name in names}


def make_parser(names=None):
    """Returns the parser of the whole command line, or of the subcommands of given names."""
    parser = Parser(prog="vtkhelios", description=DESCRIPTION, epilog=EPILOG)
    parser.add_argument("--version", action="store_true", help="print the version and exit")
    subparsers = parser.add_subparsers(dest="command", metavar="COMMAND", title="commands")
    for name, module in commands(names).items():
        command = subparsers.add_parser(name, help=module.SUMMARY, description=module.SUMMARY)
        if not hasattr(module, "start"):
            module.add_arguments(command)
            command.set_defaults(run=module.run)
    return parser


def main(argv=None):
    """Runs a command line and returns its exit code; without words, the command line of the process."""
    is_process = argv is None
    try:
        code = main_in_streams(sys.argv[1:] if is_process else list(argv), is_process)
    except KeyboardInterrupt as interruption:  # while the results are printed
        code = report_stop(interruption)
    if is_process and code > 128:
        leave(code)
    return code


def main_in_streams(argv, is_process):
    with standard_streams() as results, Stopping(is_process):
        try:
            code = run_command(argv)
        except KeyboardInterrupt as interruption:
            code = report_stop(interruption)
        except UnicodeEncodeError as error:
            # section of a long one
            text = error.object[max(0, error.start - 200) : error.end + 200]
            say_error(f"{text}: is not UTF-8, and not supported here; give it another name")
            code = 1
        except Exception as error:
            if not is_stopping():  # else a library has made it of the interruption
                raise
            code = report_stop(error)
        except SystemExit as end:  # argparse ends
            raise SystemExit(written(results, end.code)) from None
        if code and is_stopping():
            code = report_stop(None)
        return written(results, code)


def run_command(argv):
    """Runs the given command and returns its exit code."""
    known = argv[:1] if argv and argv[0] in command_names() else None  # others are not imported
    if known:
        module = commands(known)[argv[0]]
        if hasattr(module, "start"):
            return module.start(argv[1:])
        try:
            load_plugins(argv)
        except PluginError as error:
            say_error(str(error))
            return 1
    parser = make_parser(known)
    arguments = parser.parse_args(argv)
    if arguments.version:
        print(f"vtkhelios {vtkHeliosVersion.GetVersion()}")
        return 0
    if not arguments.command:
        parser.print_help(sys.stderr)
        return 2
    supported = getattr(commands([arguments.command])[arguments.command], "STANDARD", ())
    if problem := explain_unsupported(arguments, supported):
        say_error(problem)
        return 2
    return arguments.run(arguments)


def written(results, code):
    """Returns the exit code, not 0 if results could not be printed."""
    results.flush()
    failure = results.failure()
    if failure is None:
        return code
    if not isinstance(failure, BrokenPipeError):  # closed by the reader: vtkhelios ... | head
        done = "" if code else "; the files that the command wrote are complete"
        say_error(f"standard output: {failure.strerror}: the output is lost{done}")
    return code or 1
