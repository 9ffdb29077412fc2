// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCityGeometry.h"

#include "heliosJsonFile.h"
#include "heliosTextFile.h"

#include <json/json.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace helios
{

//------------------------------------------------------------------------------
int GetCityDepth(const Json::Value& geometry)
{
  constexpr struct
  {
    const char* Type;
    int Depth;
  } types[] = { { "MultiSurface", 0 }, { "CompositeSurface", 0 }, { "Solid", 1 },
    { "MultiSolid", 2 }, { "CompositeSolid", 2 } };
  const std::string type = GetText(geometry, "type");
  const auto* found = std::find_if(
    std::begin(types), std::end(types), [&type](const auto& each) { return type == each.Type; });
  return found == std::end(types) ? -1 : found->Depth;
}

//------------------------------------------------------------------------------
CityGeometry::CityGeometry(const JsonFile& file, SceneMesh& mesh)
  : File(&file)
  , Mesh(mesh)
  , Materials(mesh.Materials)
  , Polygons(mesh)
{
}

//------------------------------------------------------------------------------
const JsonFile& CityGeometry::SetFile(const JsonFile& file)
{
  return *std::exchange(this->File, &file);
}

//------------------------------------------------------------------------------
void CityGeometry::SetObject(const std::string& name, const std::string& type)
{
  this->ObjectName = name;
  this->ObjectType = type;
}

//------------------------------------------------------------------------------
Status CityGeometry::Fail(const Json::Value& value, const std::string& message) const
{
  return Status::Error(
    this->File->GetPlace(value) + "object " + Quote(this->ObjectName) + ": " + message);
}

//------------------------------------------------------------------------------
Status CityGeometry::Add(const Json::Value& geometry, const std::vector<vtkTypeInt32>& ids)
{
  this->Ids = &ids;
  const Json::Value& semantics = GetMember(geometry, "semantics");
  this->Surfaces = &GetMember(semantics, "surfaces");
  return this->AddLevel(
    GetMember(geometry, "boundaries"), GetMember(semantics, "values"), GetCityDepth(geometry));
}

//------------------------------------------------------------------------------
/// Adds the surfaces of a level. The values of semantics are nested like the boundaries, without
/// rings; null stands for none.
Status CityGeometry::AddLevel(const Json::Value& boundaries, const Json::Value& values, int depth)
{
  if (!boundaries.isArray())
  {
    return this->Fail(boundaries,
      "boundaries of the geometry have " + Describe(boundaries) +
        " in place of a list; write the file again");
  }
  for (Json::ArrayIndex i = 0; i < boundaries.size(); ++i)
  {
    const Json::Value& value =
      values.isArray() && i < values.size() ? values[i] : Json::Value::nullSingleton();
    const Status status = depth > 0 ? this->AddLevel(boundaries[i], value, depth - 1)
                                    : this->AddSurface(boundaries[i], value);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status CityGeometry::AddSurface(const Json::Value& surface, const Json::Value& value)
{
  int row = -1;
  Status status = this->FindRow(value, row);
  if (!status.IsOk() || row < 0)
  {
    return status;
  }
  if (!surface.isArray())
  {
    return this->Fail(
      surface, "a surface is " + Describe(surface) + ", not a list of rings; write the file again");
  }
  this->Rings.clear();
  for (const Json::Value& ring : surface)
  {
    status = this->ReadRing(ring);
    if (!status.IsOk())
    {
      return status;
    }
  }
  if (3 * (this->Mesh.GetNumberOfTriangles() + surface.size()) > MaximumCorners)
  {
    return this->Fail(surface,
      "more than " + std::to_string(MaximumCorners / 3) +
        " triangles; split "
        "the file into several scene parts");
  }
  this->Polygons.Add(this->Rings, row, [&] { return this->Fail(surface, "").Message(); });
  return {};
}

//------------------------------------------------------------------------------
/// Finds the material of a surface, -1 if nothing is there.
Status CityGeometry::FindRow(const Json::Value& value, int& row)
{
  std::string surface;
  if (!value.isNull())
  {
    const Json::Value& all = *this->Surfaces;
    const std::int64_t index = ReadIndex(value, all.isArray() ? all.size() : 0);
    if (index < 0)
    {
      return this->Fail(value,
        "semantics refer to surface " + Describe(value) + ", but there are " +
          std::to_string(all.isArray() ? all.size() : 0) + "; correct the index");
    }
    surface = GetText(all[static_cast<Json::ArrayIndex>(index)], "type");
  }
  row = IsVirtual(surface) ? -1 : this->Materials.FindRow(this->ObjectType, surface);
  return {};
}

//------------------------------------------------------------------------------
Status CityGeometry::ReadRing(const Json::Value& ring)
{
  if (!ring.isArray() || ring.size() < 3)
  {
    return this->Fail(ring,
      "a ring is " + Describe(ring) +
        ", not a list of three vertices or more; correct the surface, or remove it");
  }
  std::vector<vtkTypeInt32>& corners = this->Rings.emplace_back();
  for (const Json::Value& vertex : ring)
  {
    const std::int64_t index = ReadIndex(vertex, static_cast<std::int64_t>(this->Ids->size()));
    if (index < 0)
    {
      return this->Fail(vertex,
        "a ring refers to vertex " + Describe(vertex) + ", but there are " +
          std::to_string(this->Ids->size()) + ", counted from 0; correct the index");
    }
    corners.push_back((*this->Ids)[static_cast<std::size_t>(index)]);
  }
  return {};
}

} // namespace helios
