# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs cases in forked workers: one batch of a target each, no new interpreter per case.

A worker writes the number of a case to shared memory before it starts, and a line to a pipe when it
is done. If a worker dies, the parent knows the case: ended by the alarm it is a hang, else a crash;
another worker continues after it.
"""

import dataclasses
import faulthandler
import json
import mmap
import os
import pathlib
import pickle
import resource
import select
import shutil
import signal
import struct
import sys
import tempfile
import time
import traceback

from .outcomes import ALLOWED, Refused, Silent

HANG = 10.0  # [s]
MEMORY = 1 << 30  # [bytes], plus
MEMORY_FACTOR = 20  # times the file size
ADDRESSES = 1 << 30  # [bytes] of address space without memory: stacks, thread arenas
BATCH = 250  # cases of a worker
LONGEST_TEXT = 2000


@dataclasses.dataclass
class Result:
    """Result of a case."""

    target: str
    case: str
    outcome: str
    text: str = ""
    seconds: float = 0.0
    peak: int = 0  # [bytes] above the worker's previous memory

    @property
    def failed(self):
        return self.outcome not in ALLOWED


@dataclasses.dataclass
class Batch:
    target: object
    seeds: list
    cases: list


class _Worker:
    """A forked process, seen from the parent."""

    def __init__(self, batch, settings):
        self.batch = batch
        self.done = 0
        self._shared = mmap.mmap(-1, 8)
        self.folder = tempfile.mkdtemp(prefix="case-", dir=settings.folder)
        self.pipe, end = os.pipe()
        sys.stdout.flush()
        sys.stderr.flush()
        self.pid = os.fork()
        if self.pid == 0:
            os.close(self.pipe)
            _work(batch, settings, self._shared, end, self.folder)
        os.close(end)
        self._buffer = b""

    def read(self):
        """The available results, or None at the end."""
        data = os.read(self.pipe, 1 << 16)
        if not data:
            return None
        *lines, self._buffer = (self._buffer + data).split(b"\n")
        self.done += len(lines)
        return [Result(self.batch.target.name, **json.loads(line)) for line in lines]

    def close(self):
        """Waits for the end; returns a result if it failed."""
        os.close(self.pipe)
        _, status = os.waitpid(self.pid, 0)
        shutil.rmtree(self.folder, ignore_errors=True)
        if status == 0 and self.done == len(self.batch.cases):
            return None
        case = self.batch.cases[struct.unpack("q", self._shared[:])[0]]
        number = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
        if number == signal.SIGALRM:
            return Result(self.batch.target.name, case, "hang", "did not end in time")
        text = signal.Signals(number).name if number else f"exit code {os.WEXITSTATUS(status)}"
        return Result(self.batch.target.name, case, "crash", text)

    def rest(self):
        """The cases after the one that ended it."""
        return self.batch.cases[struct.unpack("q", self._shared[:])[0] + 1 :]


def _work(batch, settings, shared, pipe, folder):
    """A worker: never returns."""
    code = 1
    try:
        _set_up(folder)
        for number, case in enumerate(batch.cases):
            shared[:] = struct.pack("q", number)
            result = run_case(batch.target, batch.seeds, case, settings, folder)
            os.write(pipe, json.dumps(result).encode() + b"\n")
        code = 0
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(code)


def _set_up(folder):
    os.chdir(folder)
    os.environ.update(TMPDIR=folder, HOME=folder)
    tempfile.tempdir = folder
    null = os.open(os.devnull, os.O_WRONLY)  # library output that bypasses Python
    for number in (1, 2):
        os.dup2(null, number)
    faulthandler.disable()
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for number in (signal.SIGALRM, signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_DFL)
    try:
        from vtkmodules.vtkCommonCore import vtkSMPTools

        vtkSMPTools.Initialize(1)
    except ImportError:
        pass


def run_case(target, seeds, case, settings, folder):
    """Runs a case in this process; the fields of Result without target."""
    seed, data = target.make_input(seeds, case, settings.seed)
    if settings.input is not None:
        data = settings.input
    path = _place(folder, seed, data)
    size = len(data) + sum(map(len, seed.beside.values()))
    allowed = MEMORY + MEMORY_FACTOR * size
    before = _reset_peak()
    _limit_addresses(allowed + ADDRESSES)
    start = time.monotonic()
    signal.setitimer(signal.ITIMER_REAL, settings.hang)
    outcome, text = classify(target, path, data)
    signal.setitimer(signal.ITIMER_REAL, 0)
    seconds = time.monotonic() - start
    _limit_addresses(None)
    peak = max(0, _memory("VmHWM") - before)
    if peak > allowed and outcome in ALLOWED:
        outcome, text = "memory", f"{peak >> 20} MB for a file of {size} bytes; {text}"
    if case.startswith("seed:") and outcome == "refused" and settings.input is None:
        outcome, text = "silent", f"the good file is refused: {text}"
    return {"case": case, "outcome": outcome, "text": text[:LONGEST_TEXT],
            "seconds": round(seconds, 3), "peak": peak}  # fmt: skip


def classify(target, path, data):
    """The outcome of a case and its message."""
    from vtkhelios import PipelineError
    from vtkhelios.formats import FormatError

    try:
        target.run(path, data)
        return "accepted", ""
    except (Refused, PipelineError, FormatError) as error:
        text = str(error)
        return ("refused", text) if text.strip() else ("silent", "refused without a reason")
    except Silent as error:
        return "silent", str(error)
    except BaseException:
        return "traceback", traceback.format_exc()[-LONGEST_TEXT:]


def _place(folder, seed, data):
    """Writes the files of a case to the empty folder."""
    for entry in os.scandir(folder):
        if entry.is_dir(follow_symlinks=False):
            shutil.rmtree(entry.path, ignore_errors=True)
        else:
            os.unlink(entry.path)
    for name, content in {**seed.beside, seed.name: data}.items():
        path = pathlib.Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return pathlib.Path(folder, seed.name)


def _reset_peak():
    """Restarts the peak measurement; the current memory [bytes]."""
    try:
        pathlib.Path("/proc/self/clear_refs").write_text("5")
    except OSError:
        return _memory("VmHWM")
    return _memory("VmRSS")


def _memory(field):
    for line in pathlib.Path("/proc/self/status").read_text().splitlines():
        if line.startswith(field):
            return int(line.split()[1]) << 10
    return 0


def _limit_addresses(more):
    limit = resource.RLIM_INFINITY if more is None else _memory("VmSize") + more
    resource.setrlimit(resource.RLIMIT_AS, (limit, resource.RLIM_INFINITY))


def make_seeds(target, folder):
    """The seeds of a target, made in a separate process: its threads do not survive a fork."""
    place = tempfile.mkdtemp(prefix="seeds-", dir=folder)
    result = pathlib.Path(place, "seeds.pickle")
    sys.stdout.flush()
    sys.stderr.flush()
    pid = os.fork()
    if pid == 0:
        code = 1
        try:
            work = pathlib.Path(place, "work")
            work.mkdir()
            os.chdir(work)
            seeds = target.make_seeds(work)
            result.write_bytes(pickle.dumps(seeds))
            code = 0
        except BaseException:
            traceback.print_exc()
        finally:
            sys.stderr.flush()
            os._exit(code)
    _, status = os.waitpid(pid, 0)
    if status != 0:
        raise RuntimeError(f"the seeds of {target.name} cannot be made")
    seeds = pickle.loads(result.read_bytes())
    shutil.rmtree(place, ignore_errors=True)
    return seeds


@dataclasses.dataclass
class Settings:
    folder: str  # for the folders of workers
    seed: int = 1
    hang: float = HANG  # [s]
    input: bytes | None = None  # instead of the bytes of cases


def run_batches(batches, settings, jobs, on_result):
    """Runs batches, several at a time. A hang counts if the case, run again, also hangs."""
    queue = list(batches)
    workers = {}
    suspects = set()
    while queue or workers:
        while queue and len(workers) < jobs:
            worker = _Worker(queue.pop(0), settings)
            workers[worker.pipe] = worker
        for pipe in select.select(list(workers), [], [])[0]:
            worker = workers[pipe]
            results = worker.read()
            if results is None:
                del workers[pipe]
                _end(worker, queue, suspects, on_result)
            for result in results or []:
                on_result(result)


def _end(worker, queue, suspects, on_result):
    ended = worker.close()
    if ended is None:
        return
    batch = worker.batch
    cases = worker.rest()
    key = (ended.target, ended.case)
    if ended.outcome == "hang" and key not in suspects:
        suspects.add(key)  # on a busy machine single delays occur
        queue.insert(0, Batch(batch.target, batch.seeds, [ended.case]))
    else:
        on_result(ended)
    if cases:
        queue.insert(0, Batch(batch.target, batch.seeds, cases))
