// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A sampled pulse from a text file, or from an array.

#ifndef heliosPulseTable_h
#define heliosPulseTable_h

#include "heliosStatus.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <string>

class vtkDataArray;

namespace helios
{

class PulseShape;

/// Reads a time [ns] and a power per line, with a blank, comma or semicolon between them. An error
/// has file:line.
VTKHELIOSSCANNERCORE_EXPORT Status ReadPulse(const std::string& fileName, PulseShape& shape);

/// Reads the pulse from rows of a time [ns] and a power; an error names the array and the row.
VTKHELIOSSCANNERCORE_EXPORT Status ReadPulse(vtkDataArray* samples, PulseShape& shape);

} // namespace helios

#endif
