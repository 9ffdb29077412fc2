# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waveforms of the pulses of a sample, in steps of 1/4095 of their peak."""

import numpy as np

from ..array_names import (
    BIN_SIZE, COUNT, GPS_TIME, OFFSET, PULSE_IDS, SAMPLES, START_TIME, WAVEFORM_IDS,
)  # fmt: skip
from ._pack import pack_columns
from ._sample import hashes

MOST_SAMPLES = 6_000_000  # of a page, about 1 byte each
GROUP = 64  # waveforms decoded together
FULL = 4095  # code of the largest sample of a waveform
TIME_STEP = 1e-4  # of start and bin size [ns]


def link_pulses(arrays, tables):
    """The PulseIds of points in tables of waveforms: their own, else by WaveformIds or GpsTime.

    Returns them, None if there is no such array, and the tables.
    """
    for name in (PULSE_IDS, WAVEFORM_IDS):
        if name in arrays:
            return arrays[name], tables
    tables = list(tables)  # LAS of an instrument is one table
    if GPS_TIME not in arrays or not tables:
        return None, tables
    times = np.concatenate([table[GPS_TIME] for table in tables])
    pulses = np.concatenate([table[PULSE_IDS] for table in tables])
    times, first = np.unique(times, return_index=True)
    place = np.searchsorted(times, arrays[GPS_TIME]).clip(0, max(0, len(times) - 1))
    if len(times) == 0:
        return None, tables
    return np.where(times[place] == arrays[GPS_TIME], pulses[first][place], -1), tables


class WaveformSample:
    """The waveforms of given pulses with at most a number of samples; those of the smallest hashes."""

    def __init__(self, pulses, limit=MOST_SAMPLES):
        self.limit = limit
        self.seen = 0  # waveforms of the given pulses
        self._pulses = np.unique(pulses)
        self._found = {}  # by pulse: start [ns], bin [ns], samples
        self._size = 0
        self._highest = np.uint64(2**64 - 1)

    def add(self, table):
        """Adds the rows of a table: a dict of the arrays of a vtkTable of waveforms."""
        wanted = np.isin(table[PULSE_IDS], self._pulses)
        self.seen += int(np.count_nonzero(wanted))
        rows = np.flatnonzero(wanted)
        keys = hashes(table[PULSE_IDS][rows])
        order = np.argsort(keys)
        order = order[keys[order] <= self._highest]
        sizes = np.cumsum(table[COUNT][rows[order]])
        for row in rows[order[: 1 + int(np.searchsorted(sizes, 2 * self.limit))]]:
            self._add_row(table, row)
        if self._size > 2 * self.limit:
            self._shrink()

    def _add_row(self, table, row):
        first, count = int(table[OFFSET][row]), int(table[COUNT][row])
        samples = np.array(table[SAMPLES][first : first + count])
        times = float(table[START_TIME][row]), float(table[BIN_SIZE][row])
        self._found[int(table[PULSE_IDS][row])] = (*times, samples)
        self._size += count

    def pack(self, store):
        """Adds the waveforms to a store; returns their description for JSON, or None without any."""
        self._shrink()
        pulses = np.array(sorted(self._found), np.int64)
        if len(pulses) == 0:
            return None
        groups = np.split(pulses, range(GROUP, len(pulses), GROUP))
        first_stream = len(store.lengths)
        store.add(pack_columns([pulses]))
        for group in groups:
            store.add(self._pack_group(group))
        return {
            "pulses": first_stream, "firstStream": first_stream + 1, "firstPulses": [int(group[0]) for group in groups],
            "group": GROUP, "count": len(pulses), "of": self.seen, "timeStep": TIME_STEP, "full": FULL,
        }  # fmt: skip

    def _pack_group(self, group):
        """Pulse, start, bin, peak and number of samples of each, and then all samples."""
        starts, bins, samples = zip(*(_trim(*self._found[int(pulse)]) for pulse in group))
        peaks = np.array([float(part.max(initial=0)) for part in samples], np.float32)
        codes = [np.rint(part / (peak or 1) * FULL) for part, peak in zip(samples, peaks)]
        head = [
            group, _steps(starts), _steps(bins), peaks.view(np.uint32).astype(np.int64),
            np.array([len(part) for part in samples], np.int64),
        ]  # fmt: skip
        joined = np.concatenate(codes).clip(-FULL, FULL).astype(np.int64)
        return pack_columns([*head, joined])

    def _shrink(self):
        if self._size <= self.limit:
            return
        pulses = np.array(list(self._found), np.int64)
        pulses = pulses[np.argsort(hashes(pulses))]
        sizes = np.cumsum([len(self._found[int(pulse)][2]) for pulse in pulses])
        kept = pulses[: max(1, int(np.searchsorted(sizes, self.limit, "right")))]
        self._found = {int(pulse): self._found[int(pulse)] for pulse in kept}
        self._size = int(sizes[len(kept) - 1])
        self._highest = hashes(kept[-1:])[0]


def _trim(start, size, samples):
    """A waveform without the samples at its ends that are 0 at the resolution of the page, but one."""
    peak = float(samples.max(initial=0))
    filled = np.flatnonzero(np.abs(samples) * FULL >= 0.5 * peak) if peak > 0 else []
    if len(filled) == 0:
        return start, size, samples
    first, last = max(0, filled[0] - 1), filled[-1] + 2
    return start + first * size, size, samples[first:last]


def _steps(times):
    return np.rint(np.array(times) / TIME_STEP).astype(np.int64)
