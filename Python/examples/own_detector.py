# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A plug-in: an echo detector in Python, which finds the largest sample of each waveform.

vtkhelios run survey.xml --plugin own_detector.py --detector largest, or echoDetector="largest" in
<FWFSettings> of the survey.
"""

import numpy as np

import vtkhelios


def find_largest(waveforms):
    samples = waveforms.samples
    bins, highest = samples.argmax(axis=1), samples.max(axis=1)
    rows = np.flatnonzero(highest > waveforms.threshold)
    return rows, bins[rows] * waveforms.bin_size, highest[rows], waveforms.pulse_length


vtkhelios.add_detector("largest", find_largest)
