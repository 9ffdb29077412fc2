# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks: a block of a survey as text and numbers, and what a worker process computes of it."""

import collections
import contextlib
import json
import os
import threading
import weakref

from vtkmodules.vtkCommonCore import vtkSMPTools

from ..core.paths import from_vtk
from ..core.pipeline import MessageLog, PipelineError, conclude
from ..core.plugins import load_plugin, loaded_plugins

MAXIMUM_SURVEYS = 2  # surveys that a worker keeps loaded

_here = weakref.WeakValueDictionary()  # by key: surveys of this process that tasks were made of
_loaded = collections.OrderedDict()  # by key: surveys read for tasks, the last used at the end
_lock = threading.Lock()


def make_task(survey, options):
    """Returns a survey with its options as JSON: no data, only what it is read from."""
    origin = survey.origin
    if origin is None:
        raise ValueError(
            "workers read a survey from files, and this one has a scene or a trajectory in memory; "
            "write these to files, name them in a survey, and read it by read_survey()"
        )
    origin.check(survey.vtk)
    _here[origin.key] = survey
    task = {
        "key": origin.key,
        "path": origin.path,
        "assets": origin.assets,
        "folder": origin.folder,
        "plugins": loaded_plugins(),
        "fingerprint": origin.get_fingerprint(survey),
        "options": options,
    }
    return json.dumps(task, default=_make_plain)


def _make_plain(value):
    """Returns a number of numpy as Python's; raises TypeError for data."""
    if getattr(value, "ndim", None) == 0:
        return value.item()
    raise TypeError(
        f"an option is of {type(value).__name__}, which tasks of a cluster cannot hold; give a "
        "number or a text, or run the survey without a cluster"
    )


def find_windows(read, task, legs):
    """Returns the ranges of pulse ids of legs, the number of pulses of all legs, and what was
    loaded."""
    with _naming_worker():
        task = json.loads(task)
        survey = _find_survey(read, task)
        windows, total = survey.pulse_windows(task["options"], legs)
        with _watching(survey.source_of(task["options"])) as source:
            return windows, total, from_vtk(source.ComputeLoadedFingerprint())


def compute_block(read, task, first, last, loaded=None):
    """The Cloud of the pulses first to last - 1, of the same files as find_windows()."""
    with _naming_worker():
        task = json.loads(task)
        survey = _find_survey(read, task)
        cloud = survey.run_window(task["options"], (first, last), _make_watch())
        if loaded is not None:
            _check_loaded(survey, task, loaded)
        return cloud


def _check_loaded(survey, task, loaded):
    """Raises PipelineError if a file that was opened differs from another worker's; hashes once."""
    with _watching(survey.source_of(task["options"])) as source:
        if from_vtk(source.ComputeLoadedFingerprint()) == loaded:
            return
        difference = from_vtk(source.CompareFingerprint(loaded))
    if difference:
        raise _other_survey(task, "another worker", difference)


@contextlib.contextmanager
def _watching(source):
    """Raises the errors of a source."""
    with MessageLog() as log:
        log.watch(source)
        yield source
    conclude(log)


def _other_survey(task, other, difference):
    return PipelineError(
        [
            f"{task['path']}: not the survey of {other}, since {difference}; give all workers "
            "the same files and version, and read the survey again after a change"
        ]
    )


def _find_survey(read, task):
    """The survey of a task; read, by the function read, if this process does not have it."""
    key = task["key"]
    with _lock:
        survey = _here.get(key) or _loaded.get(key)
        if survey is None:
            _set_threads()
            survey = _loaded[key] = _read_survey(read, task)
        if key in _loaded:
            _loaded.move_to_end(key)
        while len(_loaded) > MAXIMUM_SURVEYS:
            _loaded.popitem(last=False)
        return survey


def _read_survey(read, task):
    for file in task["plugins"]:
        load_plugin(file)
    folder = task["folder"]  # may be of another computer
    assets = [*task["assets"], os.path.dirname(task["path"])]
    survey = read(task["path"], assets + [folder] * os.path.isdir(folder))
    survey.warn = _find_warn()
    difference = from_vtk(survey.source().CompareFingerprint(task["fingerprint"]))
    if difference:
        raise _other_survey(task, "the client", difference)
    return survey


def _get_worker():
    """Returns the worker of Dask that this thread computes for, or None."""
    try:
        from distributed import get_worker

        return get_worker()
    except (ImportError, ValueError):
        return None


def _set_threads():
    """A worker in a process of its own computes a block with all its threads."""
    worker = _get_worker()
    if worker is not None and worker.nanny:
        vtkSMPTools.Initialize(worker.state.nthreads)


def _find_warn():
    """Returns a function that also warns the client; None: Python's."""
    if _get_worker() is None:
        return None
    from distributed import warn

    return warn


def _make_watch():
    """A value of progress= that ends a task that was cancelled."""
    worker = _get_worker()
    if worker is None:
        return None
    from distributed import Reschedule

    key = worker.get_current_task()

    def check(_share):
        task = worker.state.tasks.get(key)
        if task is None or task.state == "cancelled":
            raise Reschedule  # a cancelled task is forgotten; one wanted again is computed again

    return check


@contextlib.contextmanager
def _naming_worker():
    """Adds the worker to errors: its files and its memory are its own."""
    try:
        yield
    except (PipelineError, FileNotFoundError) as error:
        worker = _get_worker()
        if worker is None:
            raise
        text = f"{error} (on the worker {worker.address})"
        raise (
            PipelineError([text]) if isinstance(error, PipelineError) else type(error)(text)
        ) from None
