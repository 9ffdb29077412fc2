// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPointNames.h"

#include "heliosFileBytes.h"
#include "heliosInputFile.h"
#include "heliosJsonFile.h"
#include "heliosPartFile.h"
#include "heliosSha256.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFoliageArrayNames.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <system_error>

#include <json/json.h>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

constexpr const char* Ending = ".names.json";
constexpr const char* Format = "vtkHelios names of points";
constexpr int Version = 1;
constexpr const char* PointEndings[] = { ".copc.laz", ".las", ".laz" };

struct Table
{
  const char* Array; ///< array of the field data
  const char* Key;   ///< in the file
};
constexpr Table Tables[] = { { vtkHeliosArrayNames::PartName, "parts" },
  { vtkHeliosArrayNames::MaterialName, "materials" },
  { vtkHeliosFoliageArrayNames::SpeciesName, "species" },
  { vtkHeliosFoliageArrayNames::OrganName, "organs" } };

vtkStringArray* GetNames(vtkFieldData* fields, const Table& table)
{
  auto* names =
    fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray(table.Array)) : nullptr;
  return names && names->GetNumberOfValues() > 0 ? names : nullptr;
}

bool Exists(const std::string& path)
{
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// Checks what is common to all files of names.
Status CheckFormat(const JsonFile& file)
{
  const Json::Value& root = file.GetRoot();
  const Json::Value& version = GetMember(root, "version");
  if (GetText(root, "format") != Format)
  {
    return Status::Error(file.GetPath() + ": is no file of names: its format is not \"" + Format +
      "\"; give it another name");
  }
  return version.isInt() && version.asInt() == Version
    ? Status()
    : Status::Error(file.GetPlace(version) + "version is " + Describe(version) + "; " +
        std::to_string(Version) + " can be read: use a newer vtkHelios, or write it again");
}

Status CheckNames(const JsonFile& file, const Json::Value& names)
{
  if (!names.isArray())
  {
    return Status::Error(file.GetPlace(names) + "is " + Describe(names) +
      ", not a list of names; write the file again");
  }
  for (const Json::Value& name : names)
  {
    if (!name.isString())
    {
      return Status::Error(
        file.GetPlace(name) + "the name " + Describe(name) + " is no text; write the file again");
    }
  }
  return {};
}

/// Returns the SHA-256 of all other members, whatever their layout.
std::string ComputeChecksum(Json::Value root)
{
  root.removeMember("checksum");
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "";
  Sha256 digest;
  digest.Add(Json::writeString(builder, root));
  return digest.Finish();
}

/// Checks the checksum: a file without one was made, or changed, by hand.
Status CheckChecksum(const JsonFile& file)
{
  const Json::Value& checksum = GetMember(file.GetRoot(), "checksum");
  return checksum.isNull() || checksum == ComputeChecksum(file.GetRoot())
    ? Status()
    : Status::Error(file.GetPlace(checksum) +
        "its names do not match their checksum; remove \"checksum\" if they were changed on "
        "purpose, or write the file again");
}

/// Opens a file of names.
Status OpenNames(const std::string& path, JsonFile& file)
{
  const Status status = file.Read(path);
  return status.IsOk() ? CheckFormat(file) : status;
}

/// Adds the names in a file to field data.
Status AddNames(
  const JsonFile& file, const std::string& points, vtkIdType count, vtkFieldData* fields)
{
  const Json::Value& number = GetMember(file.GetRoot(), "points");
  if (ReadIndex(number, std::numeric_limits<std::int64_t>::max()) != count)
  {
    return Status::Error(file.GetPlace(number) + "is for a file of " + Describe(number) +
      " points, and " + points + " has " + std::to_string(count) +
      "; correct \"points\" if the names are right, or remove the file");
  }
  for (const Table& table : Tables)
  {
    const Json::Value& names = GetMember(file.GetRoot(), table.Key);
    if (names.isNull())
    {
      continue;
    }
    if (const Status status = CheckNames(file, names); !status.IsOk())
    {
      return status;
    }
    vtkNew<vtkStringArray> array;
    array->SetName(table.Array);
    for (const Json::Value& name : names)
    {
      array->InsertNextValue(name.asString());
    }
    fields->AddArray(array);
  }
  return {};
}

std::string EncodeRoot(const Json::Value& root)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "  ";
  builder["emitUTF8"] = true;
  return Json::writeString(builder, root) + "\n";
}

std::string Encode(vtkIdType points, vtkFieldData* fields)
{
  Json::Value root;
  root["format"] = Format;
  root["version"] = Version;
  root["points"] = static_cast<Json::Int64>(points);
  for (const Table& table : Tables)
  {
    vtkStringArray* names = GetNames(fields, table);
    for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
    {
      root[table.Key].append(std::string(names->GetValue(i)));
    }
  }
  root["checksum"] = ComputeChecksum(root);
  return EncodeRoot(root);
}

} // namespace

//------------------------------------------------------------------------------
std::string GetPointNamesFile(const std::string& pointFile)
{
  const std::string part = PartEnding;
  if (pointFile.size() > part.size() &&
    pointFile.compare(pointFile.size() - part.size(), part.size(), part) == 0)
  {
    return GetPointNamesFile(pointFile.substr(0, pointFile.size() - part.size())) + part;
  }
  std::string lower = pointFile;
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string ending : PointEndings)
  {
    if (lower.size() > ending.size() &&
      lower.compare(lower.size() - ending.size(), ending.size(), ending) == 0)
    {
      return pointFile.substr(0, pointFile.size() - ending.size()) + Ending;
    }
  }
  return pointFile + Ending;
}

//------------------------------------------------------------------------------
vtkIdType CountPointNames(vtkFieldData* fields)
{
  vtkIdType count = 0;
  for (const Table& table : Tables)
  {
    vtkStringArray* names = GetNames(fields, table);
    count += names ? names->GetNumberOfValues() : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
Status ReadPointNames(const std::string& pointFile, vtkIdType points, vtkFieldData* fields)
{
  const std::string path = GetPointNamesFile(pointFile);
  if (!Exists(path))
  {
    return {};
  }
  JsonFile file;
  Status status = OpenNames(path, file);
  status = status.IsOk() ? CheckChecksum(file) : status;
  status = status.IsOk() ? AddNames(file, pointFile, points, fields) : status;
  return status.IsOk() ? status : Status::Error(status.Message() + " (names are not read)");
}

//------------------------------------------------------------------------------
Status CheckPointNamesUnchanged(const std::string& pointFile)
{
  const std::string path = GetPointNamesFile(pointFile);
  if (!Exists(path))
  {
    return {};
  }
  const InputWatch ignore([](const std::string&, const std::string&) {}); // an output
  JsonFile file;
  Status status = OpenNames(path, file);
  status = status.IsOk() ? CheckChecksum(file) : status;
  if (!status.IsOk())
  {
    return status;
  }
  constexpr double bytesPerByte = 2.0;
  std::string text;
  if (const Status read = ReadBytes(path, bytesPerByte, text); !read.IsOk())
  {
    return Status::Error(path + ": " + read.Message());
  }
  const bool isByHand = GetMember(file.GetRoot(), "checksum").isNull();
  return isByHand || text == EncodeRoot(file.GetRoot())
    ? Status()
    : Status::Error(path + ": was changed since it was written");
}

//------------------------------------------------------------------------------
Status CheckPointNames(const std::string& pointFile)
{
  const std::string path = GetPointNamesFile(pointFile);
  if (!Exists(path))
  {
    return {};
  }
  const InputWatch ignore([](const std::string&, const std::string&) {}); // an output
  JsonFile file;
  const Status status = OpenNames(path, file);
  return status.IsOk()
    ? status
    : Status::Error(status.Message() + " (it is not replaced by the names of " + pointFile + ")");
}

//------------------------------------------------------------------------------
Status WritePointNames(const std::string& pointFile, vtkIdType points, vtkFieldData* fields)
{
  const std::string path = GetPointNamesFile(pointFile);
  const bool hasNames = CountPointNames(fields) > 0;
  Status status = CheckPointNames(pointFile);
  if (hasNames)
  {
    return status.IsOk() ? WriteWhole(path, Encode(points, fields)) : status;
  }
  if (status.IsOk()) // else something else, which stays
  {
    RemoveFile(path);
  }
  return {};
}

} // namespace helios
