# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Base class of fuzz targets."""

import contextlib
import dataclasses
import io
import pathlib
import random
import re
import warnings
import zlib

from . import mutators
from .outcomes import Refused, check

KEPT = pathlib.Path(__file__).absolute().parents[1] / "seeds"  # inputs of all earlier failures
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
KEPT_SHARE = 0.1  # fraction of mutants made from kept files


@dataclasses.dataclass
class Seed:
    """A valid file. ``beside``: other files that a reader finds beside it, by name."""

    name: str
    data: bytes
    beside: dict = dataclasses.field(default_factory=dict)


class Target:
    """A reader and its files.

    Subclasses have ``name``, ``make_seeds`` and ``run``; instances are listed in targets.ALL.
    """

    name = ""
    kind = "text"  # key of mutators.KINDS
    weight = 1.0  # its fraction of the cases
    modules = ()  # to import before workers are forked

    def missing(self):
        """Its missing dependencies, or an empty string."""
        return ""

    def make_seeds(self, folder):
        """Valid files, created by vtkHelios in a temporary folder: a list of Seeds."""
        raise NotImplementedError

    def run(self, path, data):
        """Reads the file at a path. Raises Refused, or exceptions of readers; Silent by outcomes.check."""
        raise NotImplementedError

    def repair(self, data, random):
        """Repairs what would fail every case at one check, such as a checksum."""
        return data

    def make_input(self, seeds, case, seed_of_all):
        """The seed and the bytes of a case: ``seed:NAME`` (unchanged), ``kept:NAME`` or a number."""
        if case.startswith("seed:"):
            seed = next(each for each in seeds if each.name == case[5:])
            return seed, seed.data
        if case.startswith("kept:"):
            return seed_of(seeds, case[5:]), (KEPT / self.name / case[5:]).read_bytes()
        source = random.Random(f"{seed_of_all}/{self.name}/{case}")
        kept = self.kept()
        if kept and source.random() < KEPT_SHARE:
            name = source.choice(kept)
            seed, data = seed_of(seeds, name), (KEPT / self.name / name).read_bytes()
        else:
            seed = source.choice(seeds)
            data = seed.data
        return seed, self.repair(mutators.mutate(data, self.kind, source), source)

    def kept(self):
        """The names of the kept files: SEED~WHAT."""
        folder = KEPT / self.name
        return sorted(path.name for path in folder.glob("*~*")) if folder.is_dir() else []


def seed_of(seeds, name):
    """The seed named at the start of a saved file's name."""
    stem = name.split("~")[0].replace("%", "/")
    found = [each for each in seeds if each.name == stem]
    if not found:
        raise ValueError(
            f"{name} does not begin with the name of a seed and ~; seeds are "
            f"{', '.join(each.name for each in seeds)}"
        )
    return found[0]


def pick(data, choices):
    """One way to read, chosen by the bytes: the same in every run."""
    return choices[zlib.crc32(data) % len(choices)]


def command_line(*arguments, allowed=(0,)):
    """Runs a command in this process; returns standard output and error, or raises Refused."""
    from vtkhelios import cli
    from vtkmodules.vtkCommonCore import vtkOutputWindow

    out, error = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
        try:
            code = cli.main([str(each) for each in arguments])
        except SystemExit as ended:
            code = ended.code
        finally:
            vtkOutputWindow.GetInstance().RemoveAllObservers()
    told = error.getvalue()
    check(not CONTROL.search(told + out.getvalue()), f"control characters are printed: {told!r}")
    if code in allowed:
        check("error: " not in told, f"exit code {code} with an error: {told}")
        return out.getvalue(), told
    check(code in (1, 2), f"exit code {code}: {told}")
    check("error: " in told or code == 1 and ": error: " in out.getvalue(),
          f"exit code {code} without a reason: {told!r}")  # fmt: skip
    raise Refused(told or out.getvalue())


@contextlib.contextmanager
def collect_warnings():
    """The Python warnings of a block as a list."""
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        yield found


def update(algorithm):
    """The output of a reader, and its warnings; errors are PipelineErrors."""
    import vtkhelios

    with collect_warnings() as warned:
        output = vtkhelios.update(algorithm)
    return output, [str(each.message) for each in warned]


def need(*modules):
    """The missing ones of some modules."""
    missing = []
    for module in modules:
        try:
            __import__(module)
        except ImportError:
            missing.append(module)
    return ", ".join(missing)
