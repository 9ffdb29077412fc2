// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes from the text files that vtkHeliosPointTextWriter writes.

#ifndef heliosPointTextFile_h
#define heliosPointTextFile_h

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/// Takes a block of points and the share of all that is read by then [0..1]; false stops.
using BlockFunction = std::function<bool(vtkPolyData*, double)>;

/// Whether the first row of a text file has the columns that vtkHeliosPointTextWriter writes.
bool IsPointText(const std::string& path);

/**
 * Reads such a file block by block: points, Amplitude [W], EchoWidth, ReturnNumber,
 * NumberOfReturns, PulseIds, PartIds, ClassificationIds, GpsTime and, where leg is not negative,
 * LegIds. PartIds are rows of partNames, to which new names are added; a name that is a number is
 * that part. Says with file:line what is wrong, or returns an empty text.
 */
std::string ReadPointText(const std::string& path, int leg, std::vector<std::string>& partNames,
  const BlockFunction& onBlock);

} // namespace helios

#endif
