// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunJournal.h"

#include <json/reader.h>
#include <json/writer.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

namespace helios
{

namespace
{

/// A whole number of the counts, and its name in files.
struct CountName
{
  const char* Name;
  vtkIdType RunCounts::*Count;
};

constexpr CountName CountNames[] = { { "pulses", &RunCounts::Pulses },
  { "points", &RunCounts::Echoes }, { "firstReturns", &RunCounts::FirstReturns },
  { "pulsesFired", &RunCounts::PulsesFired }, { "pulsesHit", &RunCounts::PulsesHit },
  { "pulsesOnPlane", &RunCounts::PulsesOnPlane },
  { "pulsesWithoutBins", &RunCounts::PulsesWithoutBins },
  { "pulsesBinned", &RunCounts::PulsesBinned }, { "subRays", &RunCounts::SubRays },
  { "hitsOutOfRange", &RunCounts::HitsOutOfRange } };

Json::Value ToJson(const LegProgress& progress)
{
  Json::Value value;
  value["blocks"] = progress.Blocks;
  value["done"] = progress.IsDone;
  value["seconds"] = progress.Seconds;
  value["counts"] = ToJson(progress.Counts);
  value["files"] = Json::arrayValue;
  for (const FileProgress& file : progress.Files)
  {
    Json::Value& entry = value["files"].append(Json::objectValue);
    entry["name"] = file.Name;
    entry["size"] = Json::Int64(file.Size);
    entry["records"] = Json::Int64(file.Records);
    entry["bytes"] = Json::Int64(file.Bytes);
  }
  return value;
}

LegProgress ProgressFromJson(const Json::Value& value)
{
  LegProgress progress;
  progress.Blocks = value["blocks"].asInt();
  progress.IsDone = value["done"].asBool();
  progress.Seconds = value["seconds"].asDouble();
  progress.Counts = CountsFromJson(value["counts"]);
  for (const Json::Value& file : value["files"])
  {
    progress.Files.push_back({ file["name"].asString(), file["size"].asInt64(),
      file["records"].asInt64(), file["bytes"].asInt64() });
  }
  return progress;
}

} // namespace

//------------------------------------------------------------------------------
Json::Value ToJson(const RunCounts& counts)
{
  Json::Value value;
  for (const CountName& count : CountNames)
  {
    value[count.Name] = Json::Int64(counts.*count.Count);
  }
  value["largestAmplitude_W"] = counts.LargestAmplitude;
  return value;
}

//------------------------------------------------------------------------------
RunCounts CountsFromJson(const Json::Value& value)
{
  RunCounts counts;
  for (const CountName& count : CountNames)
  {
    counts.*count.Count = value[count.Name].asInt64();
  }
  counts.LargestAmplitude = value["largestAmplitude_W"].asDouble();
  return counts;
}

//------------------------------------------------------------------------------
std::string ToLine(const Json::Value& value)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "";
  return Json::writeString(builder, value);
}

//------------------------------------------------------------------------------
std::string ToText(const Json::Value& value)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "  ";
  return Json::writeString(builder, value) + "\n";
}

//------------------------------------------------------------------------------
bool FromText(const std::string& text, Json::Value& value)
{
  Json::CharReaderBuilder builder;
  Json::CharReaderBuilder::strictMode(&builder.settings_);
  const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
  std::string ignored;
  return reader->parse(text.data(), text.data() + text.size(), &value, &ignored) &&
    value.isObject();
}

//------------------------------------------------------------------------------
std::string WriteWhole(const std::string& path, const std::string& text)
{
  PartFile file;
  const bool good = file.Open(path) && file.Append(text.data(), text.size()) && file.Close();
  if (!good)
  {
    file.Abandon();
    RemoveFile(path + ".part");
  }
  return good ? std::string() : file.GetProblem();
}

//------------------------------------------------------------------------------
const FileProgress* LegProgress::FindFile(const std::string& name) const
{
  const auto isNamed = [&name](const FileProgress& file) { return file.Name == name; };
  const auto found = std::find_if(this->Files.begin(), this->Files.end(), isNamed);
  return found != this->Files.end() ? &*found : nullptr;
}

//------------------------------------------------------------------------------
RunJournal::RunJournal(const std::string& folder)
  : Path((std::filesystem::path(folder) / RunJournal::GetName()).string())
{
}

//------------------------------------------------------------------------------
bool RunJournal::Exists() const
{
  std::error_code ignored;
  return std::filesystem::is_regular_file(this->Path, ignored);
}

//------------------------------------------------------------------------------
std::string RunJournal::Create(const Json::Value& fingerprint)
{
  this->Fingerprint = fingerprint;
  this->Legs.clear();
  const std::string problem = WriteWhole(this->Path, ToLine(fingerprint) + "\n");
  return problem.empty() && !this->File.Open(this->Path) ? this->File.GetProblem() : problem;
}

//------------------------------------------------------------------------------
std::string RunJournal::Read()
{
  this->Legs.clear();
  this->Size = 0;
  this->Fingerprint = Json::nullValue;
  std::ifstream file(this->Path, std::ios::binary);
  bool isBroken = false;
  for (std::string line; std::getline(file, line) && !file.eof();)
  {
    if (isBroken)
    {
      return this->Path + " has a line that is damaged, and lines after it";
    }
    isBroken = !this->Take(line);
    this->Size += isBroken ? 0 : line.size() + 1;
  }
  return this->Fingerprint.isObject() ? std::string()
                                      : this->Path + " does not say which run it is of";
}

//------------------------------------------------------------------------------
bool RunJournal::Take(const std::string& line)
{
  Json::Value value;
  if (!FromText(line, value))
  {
    return false;
  }
  if (!this->Fingerprint.isObject())
  {
    this->Fingerprint = value;
    return true;
  }
  try
  {
    this->Legs[value["leg"].asUInt()] = ProgressFromJson(value);
  }
  catch (const Json::Exception&)
  {
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::string RunJournal::Continue()
{
  if (!this->File.Open(this->Path))
  {
    return this->File.GetProblem();
  }
  const std::string problem = this->Read(); // again: now nobody else writes
  return problem.empty() && !this->File.Cut(this->Size) ? this->File.GetProblem() : problem;
}

//------------------------------------------------------------------------------
std::string RunJournal::Append(std::size_t leg, const LegProgress& progress)
{
  this->Legs[leg] = progress;
  Json::Value line = ToJson(progress);
  line["leg"] = Json::UInt(leg);
  return this->File.Append(ToLine(line) + "\n") ? std::string() : this->File.GetProblem();
}

//------------------------------------------------------------------------------
const LegProgress& RunJournal::GetLeg(std::size_t leg) const
{
  static const LegProgress none;
  const auto found = this->Legs.find(leg);
  return found != this->Legs.end() ? found->second : none;
}

//------------------------------------------------------------------------------
void RunJournal::Remove()
{
  this->File.Close();
  RemoveFile(this->Path);
}

} // namespace helios
