// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCityTemplates.h"

#include "heliosJsonFile.h"
#include "heliosMemoryCheck.h"

#include <json/json.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace helios
{

namespace
{

constexpr std::int64_t InstancesPerCheck = 256;

const Json::Value& GetTemplates(const JsonFile& file, const char* name)
{
  return GetMember(GetMember(file.GetRoot(), "geometry-templates"), name);
}

/// Adds all valid indices in nested lists.
void CollectIndices(const Json::Value& lists, std::int64_t limit, std::vector<std::size_t>& all)
{
  if (lists.isArray())
  {
    for (const Json::Value& each : lists)
    {
      CollectIndices(each, limit, all);
    }
  }
  else if (const std::int64_t index = ReadIndex(lists, limit); index >= 0)
  {
    all.push_back(static_cast<std::size_t>(index));
  }
}

} // namespace

//------------------------------------------------------------------------------
std::int64_t CityTemplates::FindIndex(const Json::Value& instance) const
{
  const Json::Value& all = GetTemplates(this->File, "templates");
  return ReadIndex(GetMember(instance, "template"), all.isArray() ? all.size() : 0);
}

//------------------------------------------------------------------------------
const Json::Value& CityTemplates::Find(const Json::Value& instance) const
{
  const std::int64_t index = this->FindIndex(instance);
  return index < 0 ? Json::Value::nullSingleton()
                   : GetTemplates(this->File, "templates")[static_cast<Json::ArrayIndex>(index)];
}

//------------------------------------------------------------------------------
/// Adds a template, moved by a matrix and then to a vertex.
Status CityTemplates::Add(const Json::Value& instance, const std::vector<vtkTypeInt32>& ids)
{
  double matrix[16];
  const Json::Value& given = GetMember(instance, "transformationMatrix");
  if (!ReadNumbers(given, matrix, 16))
  {
    return this->Geometry.Fail(given.isNull() ? instance : given,
      "transformationMatrix is " + Describe(given) + ", not 16 numbers; correct it");
  }
  const Json::Value& boundaries = GetMember(instance, "boundaries");
  const std::int64_t place = boundaries.isArray() && boundaries.size() == 1
    ? ReadIndex(boundaries[0], static_cast<std::int64_t>(ids.size()))
    : -1;
  if (place < 0)
  {
    return this->Geometry.Fail(boundaries.isNull() ? instance : boundaries,
      "boundaries of a GeometryInstance are not the index of one vertex; correct them");
  }
  const Shape* shape = nullptr;
  Status status = this->CheckSize(instance);
  status = status.IsOk() ? this->ReadShape(instance, shape) : status;
  if (!status.IsOk())
  {
    return status;
  }
  double point[3];
  std::copy_n(
    this->Mesh.Points.GetValues() + 3 * std::int64_t(ids[static_cast<std::size_t>(place)]), 3,
    point);
  status = this->AddVertices(instance, *shape, matrix, point);
  if (!status.IsOk())
  {
    return status;
  }
  const JsonFile& file = this->Geometry.SetFile(this->File);
  status = this->Geometry.Add(this->Find(instance), this->Ids);
  this->Geometry.SetFile(file);
  return status;
}

//------------------------------------------------------------------------------
/// Checks the total size: a small file may have many copies of a large template.
Status CityTemplates::CheckSize(const Json::Value& instance)
{
  if (++this->NumberOfInstances % InstancesPerCheck != 0)
  {
    return {};
  }
  const Status status = CheckMemory("triangles of templates",
    static_cast<double>(this->Mesh.GetNumberOfTriangles()), BytesPerTriangle);
  return status.IsOk() ? status : this->Geometry.Fail(instance, status.Message());
}

//------------------------------------------------------------------------------
/// Reads the vertices of a template once.
Status CityTemplates::ReadShape(const Json::Value& instance, const Shape*& shape)
{
  const Json::Value& vertices = GetTemplates(this->File, "vertices-templates");
  if (!vertices.isArray())
  {
    return this->Geometry.Fail(instance,
      "vertices-templates are " + Describe(vertices) + ", not a list; write the file again");
  }
  const auto [found, isNew] = this->Shapes.emplace(this->FindIndex(instance), Shape());
  Shape& read = found->second;
  shape = &read;
  if (!isNew)
  {
    return {};
  }
  this->Ids.resize(vertices.size());
  CollectIndices(GetMember(this->Find(instance), "boundaries"), vertices.size(), read.Vertices);
  std::sort(read.Vertices.begin(), read.Vertices.end());
  read.Vertices.erase(std::unique(read.Vertices.begin(), read.Vertices.end()), read.Vertices.end());
  for (const std::size_t vertex : read.Vertices)
  {
    double v[3];
    const Json::Value& given = vertices[static_cast<Json::ArrayIndex>(vertex)];
    if (!ReadNumbers(given, v, 3))
    {
      return this->Geometry.Fail(given,
        "vertex " + std::to_string(vertex) + " of vertices-templates is " + Describe(given) +
          ", not three numbers; correct it");
    }
    read.Points.insert(read.Points.end(), v, v + 3);
  }
  return {};
}

//------------------------------------------------------------------------------
Status CityTemplates::AddVertices(
  const Json::Value& instance, const Shape& shape, const double* matrix, const double* place)
{
  if (this->Mesh.GetNumberOfPoints() + static_cast<std::int64_t>(shape.Vertices.size()) >
    MaximumCorners)
  {
    return this->Geometry.Fail(instance,
      "more than " + std::to_string(MaximumCorners) +
        " vertices in all; split the file into several scene parts");
  }
  const double* v = shape.Points.data();
  for (const std::size_t vertex : shape.Vertices)
  {
    double p[3];
    for (int row = 0; row < 3; ++row)
    {
      const double* m = matrix + 4 * row;
      p[row] = place[row] + (m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + m[3]);
    }
    if (!std::all_of(p, p + 3, [](double x) { return std::isfinite(x); }))
    {
      return this->Geometry.Fail(
        instance, "transformationMatrix moves a vertex to infinity; correct it");
    }
    this->Ids[vertex] = static_cast<vtkTypeInt32>(this->Mesh.GetNumberOfPoints());
    this->Mesh.AddPoint(p[0], p[1], p[2]);
    v += 3;
  }
  return {};
}

} // namespace helios
