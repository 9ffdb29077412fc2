// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The inputs and results of a run, as JSON.

#ifndef heliosRunSummary_h
#define heliosRunSummary_h

#include "heliosScanCounts.h"

#include <json/value.h>

namespace helios
{

class LegRunner;
class RunJournal;

/**
 * Returns the fingerprint of a finished run and its results: "rayCaster", "sampling", "legs"
 * (times, counts, files, mount of the scanner), "carriers" of parts that are mounted on others,
 * "totals", "accuracy" unless it is null, "checksum". They are equal for runs with equal
 * fingerprints. All that depends on the host is in "timings": "load_s", "run_s",
 * "legs_s", "accuracy_s", "threads".
 */
Json::Value MakeSummary(const Json::Value& fingerprint, const RunJournal& journal,
  LegRunner& runner, const Json::Value& accuracy, double loadSeconds, double accuracySeconds);

/// Returns the checksum of a summary without its timings: its "checksum".
std::string ComputeChecksum(Json::Value summary);

/// Returns the total counts in a summary.
ScanCounts GetTotals(const Json::Value& summary);

} // namespace helios

#endif
