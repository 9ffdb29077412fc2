# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waveforms of the pulses of a sample, in steps of 1/4095 of their peak."""

import numpy as np

from ..array_names import (
    BIN_SIZE, COUNT, GPS_TIME, OFFSET, PULSE_IDS, SAMPLES, START_TIME, WAVEFORM_IDS,
)  # fmt: skip
from ._pack import pack_columns
from ._sample import hashes

MAXIMUM_SAMPLES = 6_000_000  # limit of a page, about 1 byte each
GROUP = 64  # waveforms decoded together
FULL = 4095  # code of the largest sample of a waveform
TIME_STEP = 1e-4  # step of start and bin size [ns]


def link_pulses(arrays, tables):
    """Returns the PulseIds of points in tables of waveforms: their own, else by WaveformIds or
    GpsTime.

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
    """The waveforms of given pulses with at most a number of samples; the ones with the smallest hashes."""

    def __init__(self, pulses, limit=MAXIMUM_SAMPLES):
        self.limit = limit
        self.seen = 0  # waveforms of the given pulses
        self._pulses = np.unique(pulses)
        self._tables = []
        self._size = 0
        self._highest = np.uint64(2**64 - 1)

    def add(self, table):
        """Adds the rows of a table: a dict of the arrays of a vtkTable of waveforms."""
        wanted = np.isin(table[PULSE_IDS], self._pulses) & (table[COUNT] > 0)
        self.seen += int(np.count_nonzero(wanted))
        rows = np.flatnonzero(wanted & (hashes(table[PULSE_IDS]) <= self._highest))
        self._tables.append(_trim(_select(table, rows)))
        self._size += len(self._tables[-1][SAMPLES])
        if self._size > 2 * self.limit:
            self.shrink()

    def shrink(self):
        """Drops the waveforms beyond the limit; returns the others as one table, by PulseIds."""
        table = _join(self._tables)
        _, rows = np.unique(table[PULSE_IDS], return_index=True)
        if table[COUNT][rows].sum() > self.limit:
            keys = hashes(table[PULSE_IDS][rows])
            order = np.argsort(keys)
            sizes = np.cumsum(table[COUNT][rows[order]])
            kept = order[: max(1, int(np.searchsorted(sizes, self.limit, "right")))]
            self._highest = keys[kept[-1]]
            rows = rows[np.sort(kept)]
        self._tables = [_select(table, rows)]
        self._size = len(self._tables[0][SAMPLES])
        return self._tables[0]

    def pack(self, store):
        """Adds the waveforms to a store; returns their description for JSON, or None without any."""
        if self.seen == 0:
            return None
        table = self.shrink()
        peaks = np.maximum.reduceat(table[SAMPLES], table[OFFSET])
        codes = _codes(table, peaks)
        count = len(table[PULSE_IDS])
        first_stream = len(store.lengths)
        store.add(pack_columns([table[PULSE_IDS]]))
        for begin in range(0, count, GROUP):
            store.add(_pack_group(table, peaks, codes, slice(begin, min(count, begin + GROUP))))
        return {
            "pulses": first_stream, "firstStream": first_stream + 1, "count": count, "of": self.seen,
            "firstPulses": table[PULSE_IDS][::GROUP].tolist(), "group": GROUP,
            "timeStep": TIME_STEP, "full": FULL,
        }  # fmt: skip


def _pack_group(table, peaks, codes, rows):
    """Pulse, start, bin, peak and number of samples of each, and then all samples."""
    begin = table[OFFSET][rows.start]
    end = table[OFFSET][rows.stop - 1] + table[COUNT][rows.stop - 1]
    return pack_columns([
        table[PULSE_IDS][rows], _steps(table[START_TIME][rows]), _steps(table[BIN_SIZE][rows]),
        peaks[rows].view(np.uint32).astype(np.int64), table[COUNT][rows], codes[begin:end],
    ])  # fmt: skip


def _codes(table, peaks):
    """Samples in steps of the peak of their waveform over FULL."""
    scale = np.where(peaks > 0, FULL / np.where(peaks > 0, peaks, 1), 0).astype(np.float64)
    codes = np.rint(table[SAMPLES] * np.repeat(scale, table[COUNT]))
    return codes.clip(-FULL, FULL).astype(np.int64)


def _trim(table):
    """Waveforms without the samples at their ends that are 0 at the resolution of the page, but one."""
    offset, count, samples = table[OFFSET], table[COUNT], table[SAMPLES]
    if len(offset) == 0:
        return table
    peaks = np.maximum.reduceat(samples, offset)
    filled = np.abs(samples) * FULL >= 0.5 * np.repeat(peaks, count)
    place = np.arange(len(samples)) - np.repeat(offset, count)
    first = np.minimum.reduceat(np.where(filled, place, len(samples)), offset)
    last = np.maximum.reduceat(np.where(filled, place, -1), offset)
    is_empty = (last < 0) | (peaks <= 0)
    first = np.where(is_empty, 0, np.maximum(first - 1, 0))
    last = np.where(is_empty, count - 1, np.minimum(last + 1, count - 1))
    shifted = {
        **table, START_TIME: table[START_TIME] + first * table[BIN_SIZE],
        OFFSET: offset + first, COUNT: last + 1 - first,
    }  # fmt: skip
    return _select(shifted, np.arange(len(offset)))


def _select(table, rows):
    """Returns the rows of a table, with their samples one after the other."""
    offset, count = table[OFFSET][rows], table[COUNT][rows].astype(np.int64)
    starts = np.cumsum(count) - count
    index = np.repeat(offset - starts, count) + np.arange(int(count.sum()))
    return {
        PULSE_IDS: table[PULSE_IDS][rows].astype(np.int64), START_TIME: table[START_TIME][rows],
        BIN_SIZE: table[BIN_SIZE][rows], OFFSET: starts, COUNT: count,
        SAMPLES: np.asarray(table[SAMPLES][index], np.float32),
    }  # fmt: skip


def _join(tables):
    """One table of several."""
    joined = {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}
    joined[OFFSET] = np.cumsum(joined[COUNT]) - joined[COUNT]
    return joined


def _steps(times):
    return np.rint(times / TIME_STEP).astype(np.int64)
