// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes from the text files that vtkHeliosPointTextWriter writes.

#ifndef heliosPointTextFile_h
#define heliosPointTextFile_h

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios::viewer
{

/// Receives a block of points and the fraction read so far [0..1]; false stops.
using BlockFunction = std::function<bool(vtkPolyData*, double)>;

/// Whether the first row of a text file has the columns of vtkHeliosPointTextWriter.
bool IsPointText(const std::string& path);

/**
 * Reads such a file block by block: points, Amplitude [W], EchoWidth, ReturnNumber,
 * NumberOfReturns, PulseIds, PartIds, ClassificationIds, GpsTime and, if leg is not negative,
 * LegIds. PartIds are rows of partNames, to which new names are added; a numeric name is that part.
 * Returns an error with file:line, or an empty string.
 */
std::string ReadPointText(const std::string& path, int leg, std::vector<std::string>& partNames,
  const BlockFunction& onBlock);

} // namespace helios::viewer

#endif
