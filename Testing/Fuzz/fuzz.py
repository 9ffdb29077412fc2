#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Passes damaged files to all file readers of vtkHelios."""

import argparse
import collections
import contextlib
import os
import pathlib
import shutil
import sys
import tempfile
import time

from fuzzing import harness, outcomes

EPILOG = """\
what a case is:
  a good file, made by our own writers, is damaged in one to four places (bytes, numbers, lines,
  elements, integers of binary headers), the same way for the same --seed and number, and read. Files
  in seeds/TARGET, which failed once, are read as they are, too, and damaged further.

valid outcomes:
  accepted     the data is finite, in range, and as many records as the file has, by an independent count
  refused      an error with a message (PipelineError, or the command's own, exit code 1 or 2)
failures:
  crash        a signal ended the process
  hang         not done after --hang seconds (in two runs)
  traceback    any other exception
  silent       accepted, and a record lost or a number not finite or out of range, without a warning;
               or refused without a reason; or a good file refused
  memory       more than 1 GB and 20 times the file

Each failing input is saved to --failures as TARGET/SEED~NUMBER, with the command that runs it again.
Once fixed it is moved to seeds/TARGET (small files of our own making only).

examples:
  build/venv/bin/python Testing/Fuzz/fuzz.py --cases 5000            all targets, in about two minutes
  build/venv/bin/python Testing/Fuzz/fuzz.py --cases 100000          what Testing/run.sh --fuzz runs
  build/venv/bin/python Testing/Fuzz/fuzz.py --target obj --cases 2000
  build/venv/bin/python Testing/Fuzz/fuzz.py --target 'info-*' --target 'convert-*'
  build/venv/bin/python Testing/Fuzz/fuzz.py --target obj --input fuzz-failures/obj/plane.obj~17

exit codes: 0 no failure, 1 failures, 2 wrong usage.
"""

PACKAGE = pathlib.Path(__file__).absolute().parents[2] / "build/lib/python3/dist-packages"
COLUMNS = ("cases", "accepted", "refused", *outcomes.FAILURES)
SECONDS_BETWEEN_LINES = 1.0


def parse(argv):
    parser = argparse.ArgumentParser(
        description=__doc__, epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--cases", metavar="N", type=int, default=5000,
                        help="damaged files over all targets, shared by weight (default: %(default)s)")  # fmt: skip
    parser.add_argument("--target", metavar="NAME", action="append",
                        help="this target only, or those that match a*; may be repeated")  # fmt: skip
    parser.add_argument("--seed", metavar="N", type=int, default=1,
                        help="seed of the random numbers (default: %(default)s)")  # fmt: skip
    parser.add_argument("--jobs", metavar="N", type=int, default=2,
                        help="number of parallel processes (default: %(default)s)")  # fmt: skip
    parser.add_argument("--hang", metavar="S", type=float, default=harness.HANG,
                        help="time limit of a case [s] (default: %(default)s)")  # fmt: skip
    parser.add_argument("--case", metavar="N", help="this case of a target only, by its number")
    parser.add_argument("--input", metavar="FILE", type=pathlib.Path,
                        help="a saved file, SEED~WHAT, in place of damaged ones")  # fmt: skip
    parser.add_argument("--failures", metavar="DIR", type=pathlib.Path, default=pathlib.Path("fuzz-failures"),
                        help="folder for failing inputs (default: %(default)s)")  # fmt: skip
    parser.add_argument("--markdown", action="store_true", help="print the table as Markdown")
    parser.add_argument("--list", action="store_true", help="list the targets and exit")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    return parser, parser.parse_args(argv)


def choose(patterns, known):
    """The targets matched by patterns; a word that matches none, or None."""
    import fnmatch

    chosen = {}
    for pattern in patterns or ["*"]:
        names = fnmatch.filter(known, pattern)
        if not names:
            return chosen, pattern
        chosen |= {name: known[name] for name in names}
    return chosen, None


def share(targets, cases):
    """Number of mutants of each target."""
    total = sum(target.weight for target in targets)
    return [max(1, round(cases * target.weight / total)) if cases else 0 for target in targets]


def make_batches(target, seeds, mutants):
    """The valid files, earlier failures, and mutants, in batches."""
    cases = [f"seed:{name}" for name in dict.fromkeys(seed.name for seed in seeds)]
    cases += [f"kept:{name}" for name in target.kept()]
    cases += [str(number) for number in range(mutants)]
    size = harness.BATCH
    return [harness.Batch(target, seeds, cases[i : i + size]) for i in range(0, len(cases), size)]


class Tally:
    """The results of all cases, and the progress line."""

    def __init__(self, total, quiet):
        self.rows = collections.defaultdict(collections.Counter)
        self.peak = collections.defaultdict(int)
        self.slowest = collections.defaultdict(lambda: (0.0, ""))
        self.failures = []
        self._total = total
        self._done = 0
        self._start = self._last = time.monotonic()
        self._quiet = quiet

    def add(self, result):
        row = self.rows[result.target]
        row["cases"] += 1
        row[result.outcome] += 1
        self.peak[result.target] = max(self.peak[result.target], result.peak)
        self.slowest[result.target] = max(
            self.slowest[result.target], (result.seconds, result.case)
        )
        if result.failed:
            self.failures.append(result)
        self._done += 1
        self._tell()

    def _tell(self):
        now = time.monotonic()
        if self._quiet or now - self._last < SECONDS_BETWEEN_LINES:
            return
        self._last = now
        rate = self._done / (now - self._start)
        line = (f"{self._done:,} of {self._total:,} cases, {len(self.failures)} failed, "
                f"{rate:.0f} cases/s, {(self._total - self._done) / rate:.0f} s left")  # fmt: skip
        end = "\r" if sys.stderr.isatty() else "\n"
        print(line.ljust(70), end=end, file=sys.stderr, flush=True)

    def table(self, markdown):
        """The table with its sums."""
        head = ["target", *COLUMNS, "peak MB", "slowest s"]
        rows = [
            [name, *(row[column] for column in COLUMNS), self.peak[name] >> 20,
             f"{self.slowest[name][0]:.2f}"]
            for name, row in sorted(self.rows.items())
        ]  # fmt: skip
        sums = [sum(row[i] for row in rows) for i in range(1, len(COLUMNS) + 1)]
        peak = max((row[-2] for row in rows), default=0)
        slowest = max((float(row[-1]) for row in rows), default=0.0)
        rows.append(["all", *sums, peak, f"{slowest:.2f}"])
        texts = [
            [f"{each:,}" if isinstance(each, int) else str(each) for each in row] for row in rows
        ]
        return _format([head, *texts], markdown)


def _format(rows, markdown):
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = []
    for row in rows:
        cells = [row[0].ljust(widths[0])]
        cells += [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]
        lines.append("| " + " | ".join(cells) + " |" if markdown else "  ".join(cells))
    rule = "|---|" + "---:|" * (len(widths) - 1) if markdown else "  ".join("-" * w for w in widths)
    lines.insert(1, rule)
    return "\n".join(lines)


def save(failure, target, seeds, arguments):
    """Saves a failing input; returns its command."""
    seed, data = target.make_input(seeds, failure.case, arguments.seed)
    if failure.case.startswith("kept:"):
        path = outcomes_folder(target) / failure.case[5:]
    else:
        number = failure.case.split(":")[0]
        path = arguments.failures / target.name / f"{seed.name.replace('/', '%')}~{number}"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    return f"{sys.executable} {__file__} --target {target.name} --input '{path}'"


def outcomes_folder(target):
    from fuzzing.target import KEPT

    return KEPT / target.name


def report(tally, targets, seeds, arguments):
    for failure in tally.failures:
        command = "" if arguments.input else save(failure, targets[failure.target],
                                                  seeds[failure.target], arguments)  # fmt: skip
        print(f"\nFAILED {failure.target} case {failure.case}: {failure.outcome}\n"
              f"{failure.text.strip()}\n  {command}")  # fmt: skip
    print()
    print(tally.table(arguments.markdown))


def main(argv=None):
    parser, arguments = parse(argv)
    if PACKAGE.is_dir():
        sys.path.insert(0, str(PACKAGE))
    from fuzzing.targets import ALL

    targets, unknown = choose(arguments.target, ALL)
    if unknown:
        parser.error(f"no target is called {unknown}; --list lists them")
    if arguments.list:
        for name, target in targets.items():
            print(f"{name:20} {' '.join(target.__doc__.split())}")
        return 0
    if (arguments.input or arguments.case) and len(targets) != 1:
        parser.error("--input and --case need one --target")
    if arguments.input and not arguments.input.is_file():
        parser.error(f"--input {arguments.input}: no such file")
    return run(targets, arguments)


def run(targets, arguments):
    missing = {name: target.missing() for name, target in targets.items()}
    for name in [name for name in targets if missing[name]]:
        print(f"{name} is skipped: {missing[name]} is not installed", file=sys.stderr)
        del targets[name]
    warm_up(targets.values())
    folder = tempfile.mkdtemp(prefix="vtkhelios-fuzz-")
    settings = harness.Settings(folder, arguments.seed, arguments.hang)
    try:
        seeds = {name: harness.make_seeds(target, folder) for name, target in targets.items()}
        batches = all_batches(targets, seeds, arguments, settings)
        tally = Tally(sum(len(batch.cases) for batch in batches), arguments.quiet)
        harness.run_batches(batches, settings, arguments.jobs, tally.add)
        report(tally, targets, seeds, arguments)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return 1 if tally.failures else 0


def warm_up(targets):
    """Imports shared modules for all workers."""
    import importlib

    modules = ["vtkhelios.cli", "vtkhelios.formats._run", "vtkhelios.formats._copc"]
    for target in targets:
        modules += target.modules
    for name in dict.fromkeys(modules):
        with contextlib.suppress(ImportError):
            importlib.import_module(name)
    with contextlib.suppress(ImportError, AttributeError):
        importlib.import_module("vtkhelios.cli").commands()


def all_batches(targets, seeds, arguments, settings):
    """All batches, targets in turn, for a good time estimate."""
    if arguments.input or arguments.case:
        target = next(iter(targets.values()))
        case = arguments.case
        if arguments.input:
            from fuzzing.target import seed_of

            settings.input = arguments.input.read_bytes()
            case = f"seed:{seed_of(seeds[target.name], arguments.input.name).name}"
        return [harness.Batch(target, seeds[target.name], [case])]
    parts = [make_batches(target, seeds[target.name], count)
             for target, count in zip(targets.values(), share(targets.values(), arguments.cases))]  # fmt: skip
    turns = max(map(len, parts))
    return [part[turn] for turn in range(turns) for part in parts if turn < len(part)]


if __name__ == "__main__":
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "RAYON_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    sys.exit(main())
