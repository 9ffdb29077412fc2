# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Echo detectors written in Python, which surveys find by their names."""

import functools
import os
import sys
import traceback
import typing

import numpy as np

from .. import _native
from ..vtkHeliosScannerDetectors import vtkHeliosEchoDetection
from .paths import to_vtk

_COLUMNS = "rows of waveforms, times [ns], amplitudes [W], widths [ns]"


class Waveforms(typing.NamedTuple):
    """A block of waveforms that a detector receives; read-only arrays of n waveforms."""

    samples: np.ndarray  # (n, m) float32 [W]: sample j at j bin_size; 0 after the last of a waveform
    counts: np.ndarray  # (n,) int64: their samples, at most m
    pulse_ids: np.ndarray  # (n,) int64, keys of random numbers, with the seed
    seed: int
    bin_size: float  # [ns]
    pulse_length: float  # [ns], full width at half maximum of the transmitted pulse
    threshold: float  # [W], the smallest amplitude of an echo


def add_detector(name, function):
    """Adds an echo detector, so that surveys (echoDetector="name"), runs and --detector find it.

    function
        returns the echoes of a block of Waveforms, up to 256 (fewer if they are long): four arrays of
        one length, or numbers for all echoes: rows, the index of the waveform of each echo; times
        after its first sample [ns]; amplitudes [W]; and widths [ns], full width at half maximum. In
        any order; the echoes within the dead time of the receiver are removed.

    Several threads call the function, and the division into blocks differs between runs: it keeps no
    state, and the echoes of a waveform depend on nothing else. An exception ends the run with an
    error. The file of the function is an input of runs, which do not resume with another one.

    >>> def largest(waveforms):
    ...     samples = waveforms.samples
    ...     bins, highest = samples.argmax(1), samples.max(1)
    ...     rows = np.flatnonzero(highest > waveforms.threshold)
    ...     return rows, bins[rows] * waveforms.bin_size, highest[rows], waveforms.pulse_length
    >>> vtkhelios.add_detector("largest", largest)
    """
    if not callable(function):
        raise TypeError(f"the detector {name!r} is {function!r}; give a function")
    if not _native.add_detector(name, functools.partial(_detect, name, function)):
        known = [
            vtkHeliosEchoDetection.GetDetectorName(i)
            for i in range(vtkHeliosEchoDetection.GetNumberOfDetectors())
        ]
        fault = "is taken" if name in known else "is empty or has blanks"
        raise ValueError(f"the name {name!r} of an echo detector {fault}; give another one")
    module = getattr(function, "__module__", None) or type(function).__module__
    file = getattr(sys.modules.get(module), "__file__", None)
    if file and os.path.isfile(file):
        vtkHeliosEchoDetection.SetDetectorFile(name, to_vtk(os.path.abspath(file)))


def _detect(name, function, samples, counts, pulse_ids, *rest):
    """Returns the echoes of a block as bytes for _native.add_detector(), or an error."""
    counts = np.frombuffer(counts, np.int64)
    samples = np.frombuffer(samples, np.float32).reshape(len(counts), -1)
    block = Waveforms(samples, counts, np.frombuffer(pulse_ids, np.int64), *rest)
    try:
        result = function(block)
    except Exception as error:
        frames = traceback.extract_tb(error.__traceback__)[1:]
        own = [each for each in frames if each.filename == frames[0].filename]
        place = f"{own[-1].filename}:{own[-1].lineno}: " if own else ""
        return f'echo detector "{name}": {place}{type(error).__name__}: {error}'
    try:
        return _pack(result, len(counts))
    except ValueError as error:
        return f'echo detector "{name}": {error}'


def _pack(result, count):
    """Returns the echoes in the order of rows and times as bytes; ValueError if one is not valid."""
    try:
        rows, *values = np.broadcast_arrays(*(np.atleast_1d(each) for each in result))
        valid = len(values) == 3 and rows.ndim == 1 and (rows.dtype.kind in "iu" or not rows.size)
        echoes = np.column_stack([rows, *values]).astype(np.float64)
    except (TypeError, ValueError):
        valid = False
    if not valid:
        raise ValueError(
            f"returned {_describe(result)}; give four arrays of one length: {_COLUMNS}"
        )
    bad = np.flatnonzero((rows < 0) | (rows >= count))
    if bad.size:
        raise ValueError(f"returned row {rows[bad[0]]}; give rows from 0 to {count - 1}")
    bad = np.flatnonzero(~np.isfinite(echoes).all(axis=1))
    if bad.size:
        raise ValueError(f"returned {echoes[bad[0]].tolist()} ({_COLUMNS}); give finite numbers")
    return echoes[np.lexsort((echoes[:, 1], echoes[:, 0]))].tobytes()


def _describe(result):
    """Returns the type of a result, of a tuple with its shapes."""
    if not isinstance(result, (tuple, list)):
        return type(result).__name__
    return f"shapes {', '.join(str(np.shape(each)) for each in result)}" if result else "nothing"
