// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunSummary.h"

#include "heliosLegRunner.h"
#include "heliosRunJournal.h"

#include <vtkSMPTools.h>

#include <filesystem>

namespace helios
{

namespace
{

/// Returns the counts added by a leg.
Json::Value CountLeg(const ScanCounts& before, const ScanCounts& after)
{
  Json::Value leg;
  leg["pulses"] = Json::Int64(after.Pulses - before.Pulses);
  leg["pulsesFired"] = Json::Int64(after.PulsesFired - before.PulsesFired);
  leg["pulsesHit"] = Json::Int64(after.PulsesHit - before.PulsesHit);
  leg["points"] = Json::Int64(after.Echoes - before.Echoes);
  leg["firstReturns"] = Json::Int64(after.FirstReturns - before.FirstReturns);
  return leg;
}

/// Returns whether the records of a file are in separate pieces.
bool IsIndex(const std::string& name)
{
  const auto extension = std::filesystem::path(name).extension();
  return extension == ".pvtp" || extension == ".pvtt";
}

Json::Value DescribeFiles(const LegProgress& progress)
{
  Json::Value files = Json::arrayValue;
  for (const FileProgress& file : progress.Files)
  {
    Json::Value& entry = files.append(Json::objectValue);
    entry["name"] = file.Name;
    entry["records"] = Json::Int64(file.Records);
    entry["bytes"] = Json::Int64(IsIndex(file.Name) ? file.Size + file.Bytes : file.Bytes);
  }
  return files;
}

/// Returns where the scanner sits on a platform: shift [m] and unit quaternion w, x, y, z.
Json::Value DescribeMount(const Pose& mount)
{
  Json::Value described;
  for (int i = 0; i < 3; ++i)
  {
    described["position_m"].append(mount.Position[i]);
  }
  for (int i = 0; i < 4; ++i)
  {
    described["orientation"].append(mount.Orientation[i]);
  }
  return described;
}

/// Returns the carriers of the parts that are mounted on others, by name; null: there are none.
Json::Value DescribeCarriers(const SceneData& scene)
{
  Json::Value carriers;
  for (const PartData& part : scene.Parts)
  {
    if (!part.Motion.Mount.empty())
    {
      carriers[part.Name] = part.Motion.Mount;
    }
  }
  return carriers;
}

/// Returns the parts that moved: how, and how fast [m/s]; null: there are none.
Json::Value DescribeMoving(const LegRunner& runner)
{
  Json::Value parts;
  for (const PartSpeeds& part : runner.GetSpeeds())
  {
    Json::Value described;
    described["part"] = part.Name;
    described["motion"] = part.Motion;
    described["speed_m_s"].append(part.Minimum);
    described["speed_m_s"].append(part.Maximum);
    parts.append(described);
  }
  return parts;
}

} // namespace

//------------------------------------------------------------------------------
Json::Value MakeSummary(const Json::Value& fingerprint, const RunJournal& journal,
  LegRunner& runner, const Json::Value& accuracy, double loadSeconds, double accuracySeconds)
{
  Json::Value summary = fingerprint;
  summary["rayCaster"] = runner.GetRayCasterName();
  summary["sampling"] = runner.DescribeSampling();
  summary["legs"] = Json::arrayValue;
  Json::Value timings;
  timings["legs_s"] = Json::arrayValue;
  double seconds = 0.0;
  ScanCounts before;
  for (const LegPlan& plan : runner.GetPlans())
  {
    const LegProgress& progress = journal.GetLeg(plan.Leg);
    Json::Value leg = CountLeg(before, progress.Counts);
    leg["leg"] = Json::UInt(plan.Leg);
    leg["start_s"] = plan.StartTime;
    leg["duration_s"] = plan.Duration;
    leg["files"] = DescribeFiles(progress);
    leg["mount"] = DescribeMount(runner.GetSurvey().GetPlatform(plan.Leg).Mount);
    summary["legs"].append(leg);
    timings["legs_s"].append(progress.Seconds);
    seconds += progress.Seconds;
    before = progress.Counts;
  }
  const Json::Value carriers = DescribeCarriers(runner.GetSurvey().Scene);
  if (!carriers.isNull())
  {
    summary["carriers"] = carriers;
  }
  const Json::Value moving = DescribeMoving(runner);
  if (!moving.isNull())
  {
    summary["movingParts"] = moving;
  }
  summary["totals"] = ToJson(runner.GetCounts());
  if (!accuracy.isNull())
  {
    summary["accuracy"] = accuracy;
  }
  summary["checksum"] = ComputeChecksum(summary);
  timings["load_s"] = loadSeconds;
  timings["run_s"] = seconds;
  timings["accuracy_s"] = accuracySeconds;
  timings["threads"] = vtkSMPTools::GetEstimatedNumberOfThreads();
  summary["timings"] = timings;
  return summary;
}

//------------------------------------------------------------------------------
std::string ComputeChecksum(Json::Value summary)
{
  summary.removeMember("timings");
  summary.removeMember("checksum");
  Checksum sum;
  sum.Add(ToLine(summary));
  return sum.Finish();
}

//------------------------------------------------------------------------------
ScanCounts GetTotals(const Json::Value& summary)
{
  return CountsFromJson(summary["totals"]);
}

} // namespace helios
