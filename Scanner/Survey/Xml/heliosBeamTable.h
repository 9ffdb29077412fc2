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
constexpr std::size_t MostBeams = 100000;

/**
 * Reads a table of beams: a line with the names of columns, which are those of the attributes of
 * <beam>, then a line per beam; columns are separated by commas, and a line that starts with # is a
 * comment. Values are checked by the rules of <beam>. Beams that were read before an error are
 * kept.
 */
void ReadBeamTable(const std::string& path, std::vector<BeamData>& beams, Messages& log);

} // namespace helios

#endif
