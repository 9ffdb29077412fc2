// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunProgress.h"

#include <json/reader.h>
#include <json/writer.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <memory>

namespace helios
{

namespace
{

Json::Value ToJson(const FileProgress& file)
{
  Json::Value entry;
  entry["name"] = file.Name;
  entry["size"] = Json::Int64(file.Size);
  entry["records"] = Json::Int64(file.Records);
  entry["bytes"] = Json::Int64(file.Bytes);
  entry["whole"] = file.IsWhole;
  entry["head"] = file.Head;
  entry["blocks"] = Json::arrayValue;
  for (const FileBlock& block : file.Blocks)
  {
    Json::Value& part = entry["blocks"].append(Json::objectValue);
    part["name"] = block.Name;
    part["begin"] = Json::Int64(block.Begin);
    part["end"] = Json::Int64(block.End);
    part["check"] = block.Checksum;
    part["whole"] = block.IsWhole;
  }
  return entry;
}

/// Returns a required member of a type.
const Json::Value& Get(
  const Json::Value& value, const char* name, bool (Json::Value::*isType)() const, const char* type)
{
  const Json::Value* member =
    value.isObject() ? value.find(name, name + std::strlen(name)) : nullptr;
  if (!member || !(member->*isType)())
  {
    throw BadJson(std::string("\"") + name + "\" is " +
      (member ? ToLine(*member) + ", not " + type : std::string("missing")));
  }
  return *member;
}

std::string GetText(const Json::Value& value, const char* name)
{
  return Get(value, name, &Json::Value::isString, "a string").asString();
}

bool GetFlag(const Json::Value& value, const char* name)
{
  return Get(value, name, &Json::Value::isBool, "true or false").asBool();
}

const Json::Value& GetList(const Json::Value& value, const char* name)
{
  return Get(value, name, &Json::Value::isArray, "a list");
}

double GetNumber(const Json::Value& value, const char* name)
{
  const double number = Get(value, name, &Json::Value::isNumeric, "a number").asDouble();
  if (!(number >= 0.0 && number < VTK_DOUBLE_MAX))
  {
    throw BadJson(
      std::string("\"") + name + "\" is " + ToLine(value[name]) + ", not a number of at least 0");
  }
  return number;
}

/// Returns the name of a file in the run folder.
std::string GetName(const Json::Value& value)
{
  const std::string name = GetText(value, "name");
  if (name.empty() || name.find('/') != std::string::npos)
  {
    throw BadJson("\"name\" is \"" + name + "\", not the name of a file");
  }
  return name;
}

FileBlock BlockFromJson(const Json::Value& value)
{
  FileBlock block{ GetName(value), static_cast<std::uint64_t>(GetCount(value, "begin")),
    static_cast<std::uint64_t>(GetCount(value, "end")), GetText(value, "check"),
    GetFlag(value, "whole") };
  if (block.Begin >= block.End)
  {
    throw BadJson("\"end\" of a block of " + block.Name + " is not after its \"begin\"");
  }
  return block;
}

FileProgress FileFromJson(const Json::Value& value)
{
  FileProgress file{ GetName(value), GetCount(value, "size"), GetCount(value, "records"),
    GetCount(value, "bytes"), GetFlag(value, "whole"), GetText(value, "head"), {} };
  for (const Json::Value& block : GetList(value, "blocks"))
  {
    file.Blocks.push_back(BlockFromJson(block));
  }
  return file;
}

int GetSmallCount(const Json::Value& value, const char* name)
{
  const vtkIdType count = GetCount(value, name);
  if (count > VTK_INT_MAX)
  {
    throw BadJson(
      std::string("\"") + name + "\" is " + std::to_string(count) + ", which is too large");
  }
  return static_cast<int>(count);
}

ScanCounts ReadCounts(const Json::Value& value)
{
  ScanCounts counts;
  for (const CountName& count : CountNames)
  {
    counts.*count.Count = GetCount(value, count.Name);
  }
  counts.LargestAmplitude = GetNumber(value, "largestAmplitude_W");
  return counts;
}

} // namespace

//------------------------------------------------------------------------------
Json::Value ToJson(const ScanCounts& counts)
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
ScanCounts CountsFromJson(const Json::Value& value)
{
  try
  {
    return ReadCounts(value);
  }
  catch (const BadJson&)
  {
    return {};
  }
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
  try
  {
    // JSON readers may stop at NUL
    return text.find('\0') == std::string::npos &&
      reader->parse(text.data(), text.data() + text.size(), &value, &ignored) && value.isObject();
  }
  catch (const Json::Exception&) // nested too deep
  {
    return false;
  }
}

//------------------------------------------------------------------------------
vtkIdType GetCount(const Json::Value& value, const char* name)
{
  const Json::Value& count = Get(value, name, &Json::Value::isInt64, "a whole number");
  if (count.type() == Json::realValue)
  {
    throw BadJson(std::string("\"") + name + "\" is " + ToLine(count) + ", not a whole number");
  }
  if (count.asInt64() < 0)
  {
    throw BadJson(std::string("\"") + name + "\" is " + ToLine(count) + ", which is negative");
  }
  return count.asInt64();
}

//------------------------------------------------------------------------------
Json::Value ToJson(const LegProgress& progress)
{
  Json::Value value;
  value["blocks"] = progress.Blocks;
  if (progress.Pieces > 0)
  {
    value["pieces"] = progress.Pieces;
  }
  value["done"] = progress.IsDone;
  value["seconds"] = progress.Seconds;
  value["counts"] = ToJson(progress.Counts);
  value["files"] = Json::arrayValue;
  for (const FileProgress& file : progress.Files)
  {
    value["files"].append(ToJson(file));
  }
  return value;
}

//------------------------------------------------------------------------------
LegProgress ProgressFromJson(const Json::Value& value)
{
  LegProgress progress;
  progress.Blocks = GetSmallCount(value, "blocks");
  progress.Pieces = value.isMember("pieces") ? GetSmallCount(value, "pieces") : 0;
  progress.IsDone = GetFlag(value, "done");
  progress.Seconds = GetNumber(value, "seconds");
  progress.Counts = ReadCounts(Get(value, "counts", &Json::Value::isObject, "an object"));
  for (const Json::Value& file : GetList(value, "files"))
  {
    progress.Files.push_back(FileFromJson(file));
  }
  return progress;
}

//------------------------------------------------------------------------------
bool Follows(const LegProgress& before, const LegProgress& after)
{
  const bool isWhole = after.Pieces == 0;
  if (before.IsDone || after.Blocks < before.Blocks)
  {
    return false;
  }
  if (after.Blocks == before.Blocks)
  {
    return after.IsDone ? isWhole && before.Pieces == 0 : after.Pieces > before.Pieces;
  }
  return after.Blocks == before.Blocks + 1 && isWhole && !after.IsDone;
}

//------------------------------------------------------------------------------
bool HasGrown(const ScanCounts& before, const ScanCounts& after)
{
  return after.LargestAmplitude >= before.LargestAmplitude &&
    std::all_of(std::begin(CountNames), std::end(CountNames),
      [&](const CountName& count) { return after.*count.Count >= before.*count.Count; });
}

//------------------------------------------------------------------------------
bool IsRewritten(const FileProgress& file)
{
  return file.IsWhole &&
    std::any_of(file.Blocks.begin(), file.Blocks.end(),
      [&file](const FileBlock& block)
      {
        return block.Name == file.Name && block.Begin == 0 && block.IsWhole &&
          block.End == static_cast<std::uint64_t>(file.Size);
      });
}

//------------------------------------------------------------------------------
bool HasGrown(const FileProgress& before, const FileProgress& after)
{
  const bool isLarger = after.Size >= before.Size && after.Bytes >= before.Bytes;
  return !before.IsWhole && after.Records >= before.Records && (isLarger || IsRewritten(after));
}

} // namespace helios
