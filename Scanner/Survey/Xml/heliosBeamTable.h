// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The beams of a spinning head in a text file.

#ifndef heliosBeamTable_h
#define heliosBeamTable_h

#include "heliosSurveyData.h"

#include <string>
#include <vector>

namespace helios
{

class Messages;

/// The maximum number of beams of a head.
constexpr std::size_t MaximumBeams = 100000;

/// Reads a table of beams, whose columns are the attributes of <beam>. Beams that were read before
/// an error are kept.
void ReadBeamTable(const std::string& path, std::vector<BeamData>& beams, Messages& log);

} // namespace helios

#endif
