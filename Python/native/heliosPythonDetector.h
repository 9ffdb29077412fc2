// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echo detectors that are functions in Python.

#ifndef heliosPythonDetector_h
#define heliosPythonDetector_h

#include "vtkPython.h" // Must be first

/**
 * Implements add_detector(name, detect): registers an echo detector for surveys; False if its name is
 * not valid. Threads call detect(samples, counts, pulse_ids, seed, bin_size, pulse_length, threshold)
 * for waveforms in blocks: samples are float32, padded with 0 to the longest waveform, counts and
 * pulse_ids are int64, as bytes. It returns the echoes as bytes, four float64 each: the row of their
 * waveform, time, amplitude and width, in order of rows and times; or an error as a text.
 */
PyObject* heliosAddDetector(PyObject* self, PyObject* args);

#endif
