// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Points of LAS and LAZ as records.

#ifndef heliosLazRecords_h
#define heliosLazRecords_h

#include "vtkPython.h" // Must be first

/// Implements read_las_records(path as bytes, first, buffer): fills a buffer with points of a file,
/// compressed or not; returns the error as a text.
PyObject* heliosReadLasRecords(PyObject* self, PyObject* args);

/// Implements laz_record(format, length): the data of the record of LASzip.
PyObject* heliosLazRecord(PyObject* self, PyObject* args);

/// Implements encode_laz(format, length, points as bytes): a list of chunks, (points, bytes).
PyObject* heliosEncodeLaz(PyObject* self, PyObject* args);

/// Implements encode_laz_table(chunks): their table, of (points, number of bytes).
PyObject* heliosEncodeLazTable(PyObject* self, PyObject* args);

#endif
