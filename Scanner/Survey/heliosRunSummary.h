// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a run was and did, as JSON.

#ifndef heliosRunSummary_h
#define heliosRunSummary_h

#include "heliosRunCounts.h"

#include <json/value.h>

namespace helios
{

class LegRunner;
class RunJournal;

/**
 * The fingerprint of a run that is done, and what came of it: "rayCaster", "sampling", "legs" (times,
 * counts, files), "totals", "checksum". Two runs of one fingerprint have the same. What a host adds to it is all
 * in "timings": "load_s", "run_s", "legs_s", "threads".
 */
Json::Value MakeSummary(
  const Json::Value& fingerprint, const RunJournal& journal, LegRunner& runner, double loadSeconds);

/// The checksum of all of a summary but its timings, which is its "checksum".
std::string ComputeChecksum(Json::Value summary);

/// The counts of a run by its summary.
RunCounts GetTotals(const Json::Value& summary);

} // namespace helios

#endif
