# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The blocks of a survey as tasks of Dask: in the process that wants the clouds."""

import collections
import itertools
import uuid

from ..core.watching import Progress
from . import need
from ._tasks import compute_block, find_windows, make_task

BLOCKS_PER_WORKER = 2  # computed in advance of the caller


def check_pulses(pulses):
    """Returns the pulses of a block as an int."""
    if pulses != int(pulses) or pulses < 1:
        raise ValueError(f"pulses is {pulses!r}; give a whole number of 1 or more")
    return int(pulses)


def split_windows(windows, pulses):
    """Yields the windows of pulse ids [first, last) in blocks of this many pulses, in order."""
    for first, last in windows:
        for begin in range(first, last, pulses):
            yield begin, min(begin + pulses, last)


def make_delayed(survey, pulses, legs, options):
    """Returns a list of dask.delayed Clouds."""
    delayed = need("dask").delayed
    pulses = check_pulses(pulses)
    task = make_task(survey, options)
    read = survey.origin.read
    windows, _, loaded = delayed(find_windows, pure=False)(read, task, legs).compute()
    compute, loaded = delayed(compute_block, pure=False), delayed(loaded)
    return [compute(read, task, *window, loaded) for window in split_windows(windows, pulses)]


def iterate_blocks(survey, client, pulses, progress, legs, options):
    """Yields the Clouds of a survey in order; the workers are a few blocks ahead."""
    _check_client(client)
    pulses = check_pulses(pulses)
    task = make_task(survey, options)
    read = survey.origin.read
    with Progress(progress) as watched:
        windows, total, loaded = client.submit(find_windows, read, task, legs, pure=False).result()
        blocks = split_windows(windows, pulses)
        for (_, last), cloud in _compute_in_order(client, (read, task), loaded, blocks):
            if watched.callback:
                watched.callback(None, last / total)
            yield cloud


def _compute_in_order(client, task, loaded, windows):
    """Yields (window, cloud); tasks that are not wanted any more are cancelled."""
    name, windows, pending = f"vtkhelios-{uuid.uuid4()}", iter(windows), collections.deque()
    try:
        while True:
            free = BLOCKS_PER_WORKER * max(1, len(client.nthreads())) - len(pending)
            for first, last in itertools.islice(windows, max(0, free)):
                key = f"{name}-{first}"
                future = client.submit(
                    compute_block, *task, first, last, loaded, key=key, pure=False
                )
                pending.append(((first, last), future))
            if not pending:
                return
            window, future = pending[0]
            cloud = future.result()
            pending.popleft()
            del future  # the workers forget the cloud
            yield window, cloud
    finally:
        client.cancel([future for _, future in pending])


def _check_client(client):
    kind = need("distributed").Client
    if not isinstance(client, kind):
        raise TypeError(f"client is of {type(client).__name__}; give a distributed.Client")
    if client.asynchronous:
        raise ValueError("client is asynchronous; give one that is not, or use to_delayed()")
