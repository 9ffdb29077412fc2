// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCityModel.h"

#include "heliosLineFile.h"

#include <json/json.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>

namespace helios
{

namespace
{

constexpr Json::ArrayIndex ObjectsPerBlock = 256;
constexpr std::size_t LongestLine = std::size_t(1) << 30; // a feature, or all of a small city

/// Levels of detail are ordered as numbers: 1.3 is above 1.2 and 1.
double ToNumber(const std::string& level)
{
  double number = -1.0;
  std::from_chars(level.data(), level.data() + level.size(), number);
  return number;
}

bool IsLower(const std::string& a, const std::string& b)
{
  return ToNumber(a) < ToNumber(b);
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Returns whether a file has one value per line.
bool IsSequence(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".jsonl";
}

bool AreFinite(const double* point)
{
  return std::all_of(point, point + 3, [](double x) { return std::isfinite(x); });
}

bool IsInstance(const Json::Value& geometry)
{
  return GetText(geometry, "type") == "GeometryInstance";
}

bool IsWord(const std::string& text)
{
  return !text.empty() &&
    std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
}

/// Returns "EPSG:7415" for https://www.opengis.net/def/crs/EPSG/0/7415 or
/// urn:ogc:def:crs:EPSG::7415; empty for another text.
std::string ParseCrs(const std::string& text)
{
  const char separator = text.rfind("urn:", 0) == 0 ? ':' : '/';
  const std::string start = std::string("def") + separator + "crs" + separator;
  const std::size_t begin = text.find(start);
  const std::size_t last = text.rfind(separator);
  if (begin == std::string::npos)
  {
    return {};
  }
  const std::size_t name = begin + start.size();
  const std::string authority = text.substr(name, text.find(separator, name) - name);
  const std::string code = text.substr(last + 1);
  return IsWord(authority) && IsWord(code) && last > name ? authority + ":" + code : "";
}

} // namespace

//------------------------------------------------------------------------------
CityModel::CityModel(SceneMesh& mesh, TextReport& report)
  : Mesh(mesh)
  , Report(report)
  , Geometry(this->File, mesh)
  , Templates(this->File, mesh, this->Geometry)
{
}

//------------------------------------------------------------------------------
bool CityModel::Read(const std::string& path)
{
  const Status status = this->ReadFile(path);
  return status.IsOk() || this->Report.Fail(status.Message());
}

//------------------------------------------------------------------------------
Status CityModel::ReadFile(const std::string& path)
{
  Status status;
  if (IsSequence(path))
  {
    status = this->ReadLines(path);
  }
  else
  {
    status = this->File.Read(path);
    status = status.IsOk() ? this->ReadHeader() : status;
  }
  status = status.IsOk() ? this->CheckLevels() : status;
  if (status.IsOk())
  {
    this->ReadCrs();
    this->Geometry.Warn(this->Report);
  }
  return status;
}

//------------------------------------------------------------------------------
Status CityModel::ReadHeader()
{
  Status status = this->CheckVersion();
  status = status.IsOk() ? this->ReadTransform() : status;
  status = status.IsOk() ? this->ReadVertices(this->File) : status;
  return status.IsOk() ? this->ReadObjects(this->File) : status;
}

//------------------------------------------------------------------------------
Status CityModel::ReadLines(const std::string& path)
{
  LineFile file;
  if (Status status = file.Open(path); !status.IsOk())
  {
    return status;
  }
  file.SetLongestLine(LongestLine);
  file.SetRange(0, file.GetSize());
  std::string_view text;
  std::int64_t line = 0;
  while (file.NextLine(text))
  {
    ++line;
    const bool isBlank = std::all_of(text.begin(), text.end(), TextWords::IsBlank);
    const Status status = isBlank ? Status() : this->ReadLine(path, text, line);
    if (!status.IsOk())
    {
      return status;
    }
    if (line % ObjectsPerBlock == 0 && this->OnBlock &&
      !this->OnBlock(static_cast<double>(file.GetNextLine()) / static_cast<double>(file.GetSize())))
    {
      return Status::Error(Place(path, line) + "reading was aborted here; update again to read it");
    }
  }
  if (!file.GetError().empty())
  {
    return Status::Error(file.GetError());
  }
  return this->HasHeader
    ? Status()
    : Status::Error(path + ": is empty; its first line must be the metadata, of type \"CityJSON\"");
}

//------------------------------------------------------------------------------
/// Reads the metadata, or a feature with vertices of its own.
Status CityModel::ReadLine(const std::string& path, std::string_view text, std::int64_t line)
{
  if (!this->HasHeader)
  {
    this->HasHeader = true;
    const Status status = this->File.Parse(path, std::string(text), line);
    return status.IsOk() ? this->ReadHeader() : status;
  }
  JsonFile feature;
  Status status = feature.Parse(path, std::string(text), line);
  if (status.IsOk() && GetText(feature.GetRoot(), "type") != "CityJSONFeature")
  {
    return Status::Error(feature.GetPlace(feature.GetRoot()) + "type is " +
      Quote(GetText(feature.GetRoot(), "type")) +
      ", not \"CityJSONFeature\"; only the first line is the metadata: write the file again");
  }
  status = status.IsOk() ? this->ReadVertices(feature) : status;
  status = status.IsOk() ? this->ReadObjects(feature) : status;
  this->Geometry.SetFile(this->File);
  this->Objects = nullptr;
  return status;
}

//------------------------------------------------------------------------------
Status CityModel::CheckVersion()
{
  const Json::Value& root = this->File.GetRoot();
  const std::string type = GetText(root, "type");
  const std::string version = GetText(root, "version");
  if (type != "CityJSON")
  {
    return Status::Error(this->File.GetPlace(GetMember(root, "type")) + "type is " + Quote(type) +
      ", not \"CityJSON\"; give a file of CityJSON" +
      (type == "CityJSONFeature"
          ? ", or a text sequence (.city.jsonl) whose first line is the metadata"
          : ""));
  }
  if (version != "1.1" && version != "2.0")
  {
    return Status::Error(this->File.GetPlace(GetMember(root, "version")) + "version " +
      Quote(version) + " is not supported: expected 1.1 or 2.0; upgrade the file, as with cjio");
  }
  return {};
}

//------------------------------------------------------------------------------
Status CityModel::ReadTransform()
{
  const Json::Value& transform = GetMember(this->File.GetRoot(), "transform");
  return ReadNumbers(GetMember(transform, "scale"), this->Scale, 3) &&
      ReadNumbers(GetMember(transform, "translate"), this->Translation, 3)
    ? Status()
    : Status::Error(this->File.GetPlace(transform) +
        "transform has no scale and translate of three numbers each; write the file again");
}

//------------------------------------------------------------------------------
/// Adds a point for every vertex: scale times integer plus translation, in double precision.
Status CityModel::ReadVertices(const JsonFile& file)
{
  const Json::Value& vertices = GetMember(file.GetRoot(), "vertices");
  const std::int64_t first = this->Mesh.GetNumberOfPoints();
  if (!vertices.isArray() || first + static_cast<std::int64_t>(vertices.size()) > MaximumCorners)
  {
    return Status::Error(file.GetPlace(vertices) + "vertices are " + Describe(vertices) +
      ", not a list of at most " + std::to_string(MaximumCorners - first) +
      "; write the file again");
  }
  for (const Json::Value& vertex : vertices)
  {
    double p[3] = { 0.0, 0.0, 0.0 };
    const bool isRead = ReadNumbers(vertex, p, 3);
    std::transform(p, p + 3, this->Scale, p, std::multiplies<>());
    std::transform(p, p + 3, this->Translation, p, std::plus<>());
    if (!isRead || !AreFinite(p))
    {
      return Status::Error(file.GetPlace(vertex) + "vertex " +
        std::to_string(this->Mesh.GetNumberOfPoints() - first) + " is " + Describe(vertex) +
        ", not three numbers that are finite after the transform; correct it");
    }
    this->Mesh.AddPoint(p[0], p[1], p[2]);
  }
  this->Ids.resize(vertices.size());
  std::iota(this->Ids.begin(), this->Ids.end(), static_cast<vtkTypeInt32>(first));
  return {};
}

//------------------------------------------------------------------------------
Status CityModel::ReadObjects(const JsonFile& file)
{
  const Json::Value& objects = GetMember(file.GetRoot(), "CityObjects");
  if (!objects.isObject())
  {
    return Status::Error(file.GetPlace(objects) + "CityObjects are " + Describe(objects) +
      ", not an object; write the file again");
  }
  this->Geometry.SetFile(file);
  this->Objects = &objects;
  Json::ArrayIndex done = 0;
  for (auto object = objects.begin(); object != objects.end(); ++object)
  {
    const Status status = this->AddObject(object.name(), *object);
    if (!status.IsOk())
    {
      return status;
    }
    if (++done % ObjectsPerBlock == 0 && this->OnBlock &&
      !this->OnBlock(static_cast<double>(done) / objects.size()))
    {
      return Status::Error(file.GetPath() + ": reading was aborted at object " +
        std::to_string(done) + "; update again to read it");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status CityModel::AddObject(const std::string& name, const Json::Value& object)
{
  const std::string type = GetText(object, "type");
  this->Geometry.SetObject(name, type);
  if (type.empty())
  {
    return this->Geometry.Fail(object, "has no type; write the file again");
  }
  const std::string level = this->ChooseLevel(object);
  const Json::Value& geometries = GetMember(object, "geometry");
  bool hasSurfaces = false;
  bool isUsed = false;
  for (Json::ArrayIndex i = 0; geometries.isArray() && i < geometries.size(); ++i)
  {
    const std::string own = this->FindLevel(geometries[i]);
    hasSurfaces = hasSurfaces || !own.empty();
    if (!own.empty())
    {
      this->Levels.insert(own);
    }
    if (!own.empty() && own == level)
    {
      isUsed ? void() : this->Mesh.StartPart(name);
      isUsed = true;
      const Status status = this->AddGeometry(geometries[i]);
      if (!status.IsOk())
      {
        return status;
      }
    }
  }
  this->NumberOfObjects += hasSurfaces;
  this->NumberOfUsed += isUsed;
  return {};
}

//------------------------------------------------------------------------------
Status CityModel::AddGeometry(const Json::Value& geometry)
{
  return IsInstance(geometry) ? this->Templates.Add(geometry, this->Ids)
                              : this->Geometry.Add(geometry, this->Ids);
}

//------------------------------------------------------------------------------
/// Returns the level of detail of a geometry with surfaces, for an instance the level of its
/// template; else empty.
std::string CityModel::FindLevel(const Json::Value& geometry) const
{
  const Json::Value& shape = IsInstance(geometry) ? this->Templates.Find(geometry) : geometry;
  if (GetCityDepth(shape) < 0)
  {
    return {};
  }
  const std::string level = GetText(shape, "lod");
  return level.empty() ? "0" : level;
}

//------------------------------------------------------------------------------
std::string CityModel::FindHighestLevel(const Json::Value& object) const
{
  std::string highest;
  const Json::Value& geometries = GetMember(object, "geometry");
  for (Json::ArrayIndex i = 0; geometries.isArray() && i < geometries.size(); ++i)
  {
    highest = std::max(highest, this->FindLevel(geometries[i]), IsLower);
  }
  return highest;
}

//------------------------------------------------------------------------------
/// Returns an object with parts (BuildingPart ...) of a higher level of detail is given by its
/// parts alone.
std::string CityModel::ChooseLevel(const Json::Value& object) const
{
  if (!this->LevelOfDetail.empty())
  {
    return this->LevelOfDetail;
  }
  const std::string own = this->FindHighestLevel(object);
  const Json::Value& objects = *this->Objects;
  const Json::Value& children = GetMember(object, "children");
  for (Json::ArrayIndex i = 0; children.isArray() && i < children.size(); ++i)
  {
    const Json::Value& child = children[i].isString() ? GetMember(objects, children[i].asCString())
                                                      : Json::Value::nullSingleton();
    if (EndsWith(GetText(child, "type"), "Part") && IsLower(own, this->FindHighestLevel(child)))
    {
      return {};
    }
  }
  return own;
}

//------------------------------------------------------------------------------
Status CityModel::CheckLevels()
{
  if (this->LevelOfDetail.empty() || this->NumberOfUsed == this->NumberOfObjects)
  {
    return {};
  }
  std::string all;
  for (const std::string& level : this->Levels)
  {
    all += (all.empty() ? "" : ", ") + level;
  }
  const std::string text = " of " + std::to_string(this->NumberOfObjects) +
    " objects have the level of detail " + Quote(this->LevelOfDetail) + "; the file has " + all;
  if (this->NumberOfUsed == 0)
  {
    return Status::Error(this->File.GetPath() + ": none" + text + ": give one of them");
  }
  this->Report.Warn(this->File.GetPath() + ": only " + std::to_string(this->NumberOfUsed) + text +
    ": the others are left out");
  return {};
}

//------------------------------------------------------------------------------
void CityModel::ReadCrs()
{
  const Json::Value& given =
    GetMember(GetMember(this->File.GetRoot(), "metadata"), "referenceSystem");
  this->Crs = given.isString() ? ParseCrs(given.asString()) : "";
  if (!given.isNull() && this->Crs.empty())
  {
    this->Report.Warn(this->File.GetPlace(given) + "referenceSystem " + Describe(given) +
      " is not understood and not used: expected https://www.opengis.net/def/crs/EPSG/0/7415; the "
      "scene has no coordinate system");
  }
}

} // namespace helios
