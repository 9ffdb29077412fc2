// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunSummary.h"

#include "heliosLegRunner.h"
#include "heliosRunJournal.h"

#include <vtkSMPTools.h>

namespace helios
{

namespace
{

/// What a leg added to the counts.
Json::Value CountLeg(const RunCounts& before, const RunCounts& after)
{
  Json::Value leg;
  leg["pulses"] = Json::Int64(after.Pulses - before.Pulses);
  leg["pulsesFired"] = Json::Int64(after.PulsesFired - before.PulsesFired);
  leg["pulsesHit"] = Json::Int64(after.PulsesHit - before.PulsesHit);
  leg["points"] = Json::Int64(after.Echoes - before.Echoes);
  leg["firstReturns"] = Json::Int64(after.FirstReturns - before.FirstReturns);
  return leg;
}

Json::Value DescribeFiles(const LegProgress& progress)
{
  Json::Value files = Json::arrayValue;
  for (const FileProgress& file : progress.Files)
  {
    Json::Value& entry = files.append(Json::objectValue);
    entry["name"] = file.Name;
    entry["records"] = Json::Int64(file.Records);
    const bool hasPieces = file.Bytes != file.Size;
    entry["bytes"] = Json::Int64(hasPieces ? file.Size + file.Bytes : file.Size);
  }
  return files;
}

} // namespace

//------------------------------------------------------------------------------
Json::Value MakeSummary(
  const Json::Value& fingerprint, const RunJournal& journal, LegRunner& runner, double loadSeconds)
{
  Json::Value summary = fingerprint;
  summary["rayCaster"] = runner.GetRayCasterName();
  summary["sampling"] = runner.DescribeSampling();
  summary["legs"] = Json::arrayValue;
  Json::Value& timings = summary["timings"];
  double seconds = 0.0;
  RunCounts before;
  for (const LegPlan& plan : runner.GetPlans())
  {
    const LegProgress& progress = journal.GetLeg(plan.Leg);
    Json::Value leg = CountLeg(before, progress.Counts);
    leg["leg"] = Json::UInt(plan.Leg);
    leg["start_s"] = plan.StartTime;
    leg["duration_s"] = plan.Duration;
    leg["files"] = DescribeFiles(progress);
    summary["legs"].append(leg);
    timings["legs_s"].append(progress.Seconds);
    seconds += progress.Seconds;
    before = progress.Counts;
  }
  summary["totals"] = ToJson(runner.GetCounts());
  timings["load_s"] = loadSeconds;
  timings["run_s"] = seconds;
  timings["threads"] = vtkSMPTools::GetEstimatedNumberOfThreads();
  return summary;
}

//------------------------------------------------------------------------------
RunCounts GetTotals(const Json::Value& summary)
{
  return CountsFromJson(summary["totals"]);
}

} // namespace helios
