# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pulse of an instrument, from the outgoing waveforms that it has recorded.

>>> from vtkhelios import measured_pulse
>>> table = measured_pulse.read_pulse("flight.pls")  # PulseWaves 0.3, with flight.wvs
>>> text = measured_pulse.to_text(table)  # a file for pulseShape="..."
"""

import os

import numpy as np

from ..array_names import BIN_SIZE, COUNT, OFFSET, SAMPLES
from ..core.arrays import arrays
from ..formats import FormatError, read_pulsewaves

__all__ = ["average_pulses", "read_pulse", "to_text"]

_ZERO_SAMPLES = 3  # the first ones, before the pulse
_FEWEST = 0.25  # samples in a step, of the median of all


def read_pulse(path, step=0.25):
    """Returns the mean outgoing pulse of a PulseWaves 0.3 file (.pls, .wvs beside it).

    Returns rows of a time [ns] from the peak and a power of the peak's, as average_pulses(). Raises
    FormatError for files that cannot be read, or have no outgoing waveforms with a pulse.
    """
    table = arrays(read_pulsewaves(path).outgoing)
    counts = table[COUNT]
    if not len(counts):
        raise FormatError(f"{os.fspath(path)}: has no outgoing waveforms; give a file with some")
    samples = table[SAMPLES].astype(float)
    pulses = [samples[first : first + n] for first, n in zip(table[OFFSET], counts)]
    try:
        return average_pulses(pulses, table[BIN_SIZE], step)
    except ValueError as error:
        raise FormatError(f"{os.fspath(path)}: {error}") from None


def average_pulses(pulses, bin_size, step=0.25):
    """The mean of recorded pulses, each a sequence of samples.

    pulses
        waveforms of the emitted pulse, which start before it.
    bin_size
        time between their samples [ns], one or one of each.
    step
        of the result [ns], positive: pulses that lie differently in their bins give a
        finer one than theirs.

    The zero of a pulse is the mean of its first three samples, its peak the top of the parabola through the
    logarithms of its largest sample and the neighbours. Returns an array of n x 2: the mean time
    [ns] from the peak and the mean power, of the peak's, of all samples in a step. Pulses without a
    peak inside, and steps with few samples, are left out. Raises ValueError if nothing is left.
    """
    if not step > 0:
        raise ValueError(f"step is {step!r}; give a positive time [ns]")
    sizes = np.broadcast_to(np.asarray(bin_size, float), len(pulses))
    found = [_normalize(np.asarray(pulse, float), size) for pulse, size in zip(pulses, sizes)]
    found = [each for each in found if each is not None]
    if not found:
        raise ValueError(f"none of {len(pulses)} outgoing waveforms has a peak inside")
    times, powers = (np.concatenate(each) for each in zip(*found))
    steps = np.floor(times / step + 0.5).astype(np.int64)
    steps -= steps.min()
    counts = np.bincount(steps)
    good = counts >= max(1.0, _FEWEST * np.median(counts[counts > 0]))
    mean_times = np.bincount(steps, times)[good] / counts[good]
    mean_powers = np.bincount(steps, powers)[good] / counts[good]
    return np.column_stack([mean_times, mean_powers])


def _normalize(samples, size):
    """Times from the peak and powers relative to it; None without a peak inside."""
    if len(samples) < _ZERO_SAMPLES + 3 or not np.isfinite(samples).all():
        return None
    samples = samples - samples[:_ZERO_SAMPLES].mean()
    top = int(samples.argmax())
    if not 0 < top < len(samples) - 1 or not samples[top - 1 : top + 2].min() > 0:
        return None
    left, peak, right = np.log(samples[top - 1 : top + 2])
    curvature = left - 2.0 * peak + right
    if not curvature < 0:
        return None
    shift = 0.5 * (left - right) / curvature
    height = np.exp(peak - 0.25 * (left - right) * shift)
    return size * (np.arange(len(samples)) - top - shift), samples / height


def to_text(table, comment="the mean outgoing pulse"):
    """Returns a table as text that pulseShape and PulseFileName read."""
    head = f"# {comment}\n# time [ns], power\n"
    return head + "".join(f"{time:.4f},{power:.5f}\n" for time, power in table)
