// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInstanceParts.h"

#include "heliosHeightCache.h"
#include "heliosHeightField.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <sstream>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

std::string ToText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

vtkDataArray* FindArray(vtkPolyData* instances, const char* name)
{
  return instances ? instances->GetPointData()->GetArray(name) : nullptr;
}

/// Returns a named array of ids.
template <typename ArrayT>
vtkSmartPointer<ArrayT> MakeIds(const char* name)
{
  auto ids = vtkSmartPointer<ArrayT>::New();
  ids->SetName(name);
  return ids;
}

} // namespace

//------------------------------------------------------------------------------
Status Connection::Set(vtkDataSet* data)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (auto* raster = vtkImageData::SafeDownCast(data))
  {
    std::shared_ptr<const HeightField> field;
    const Status status = GetHeightField(raster, field);
    this->Triangles = field->GetNumberOfTriangles();
    this->Data = raster;
    return status.IsOk() ? status : Status::Error(": " + status.Message());
  }
  if (const Status status = CheckNoInstances(mesh); !status.IsOk())
  {
    return Status::Error(": " + status.Message());
  }
  if (!mesh || mesh->GetNumberOfCells() == 0)
  {
    return {};
  }
  this->Data = mesh;
  this->Triangles = mesh->GetNumberOfPolys();
  return mesh->GetNumberOfCells() == this->Triangles && mesh->GetPolys()->IsHomogeneous() == 3
    ? Status()
    : Status::Error(" has cells that are not triangles; pass it through vtkTriangleFilter first");
}

//------------------------------------------------------------------------------
vtkPolyData* Connection::GetMesh() const
{
  return vtkPolyData::SafeDownCast(this->Data);
}

//------------------------------------------------------------------------------
PartList GetMeshes(const ConnectionList& connections)
{
  PartList meshes;
  for (const Connection& connection : connections)
  {
    meshes.push_back(connection.GetMesh());
  }
  return meshes;
}

//------------------------------------------------------------------------------
Status InstanceParts::Set(
  const ConnectionList& connections, const std::vector<int>& ids, vtkPolyData* instances)
{
  *this = InstanceParts();
  this->All = connections;
  this->Parts = GetMeshes(connections);
  this->Instances = instances;
  const Status status = this->FindPrototypes();
  return status.IsOk() ? this->SetIds(ids) : status;
}

//------------------------------------------------------------------------------
Status InstanceParts::FindPrototypes()
{
  this->Numbers.assign(this->All.size(), -1);
  vtkDataArray* ids = FindArray(this->Instances, names::PrototypeIds);
  const vtkIdType count = this->Instances ? this->Instances->GetNumberOfPoints() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double id = ids ? ids->GetComponent(i, 0) : 0.0;
    if (!(id >= 0.0 && id < static_cast<double>(this->All.size())) ||
      !this->All[static_cast<std::size_t>(id)].Data)
    {
      return Status::Error(std::string(names::PrototypeIds) + " " + ToText(id) + " of instance " +
        std::to_string(i) +
        " is not valid: expected a connection of input 0 with triangles, 0 to " +
        std::to_string(this->All.size() - 1));
    }
    this->Uses.push_back(static_cast<std::size_t>(id));
    this->AddPrototype(this->Uses.back());
  }
  return {};
}

//------------------------------------------------------------------------------
void InstanceParts::AddPrototype(std::size_t connection)
{
  if (this->Numbers[connection] < 0)
  {
    this->Numbers[connection] = static_cast<int>(this->Prototypes.size());
    this->Prototypes.push_back(connection);
    this->Parts[connection] = nullptr;
  }
}

//------------------------------------------------------------------------------
Status InstanceParts::SetIds(const std::vector<int>& ids)
{
  int next = 0;
  this->Ids.assign(this->All.size(), -1);
  std::vector<int> all;
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    if (this->IsPrototype(i))
    {
      continue;
    }
    const int given = i < ids.size() ? ids[i] : -1;
    this->Ids[i] = given >= 0 ? given : next;
    next = std::max(next, this->Ids[i] + 1);
    all.push_back(this->Ids[i]);
    if (this->All[i].IsRaster())
    {
      this->Rows.push_back({ -1, i, this->Ids[i] });
      this->AddPrototype(i);
    }
  }
  const bool areSorted = std::is_sorted(all.begin(), all.end());
  vtkDataArray* given = FindArray(this->Instances, names::PartIds);
  for (std::size_t i = 0; i < this->Uses.size(); ++i)
  {
    const auto row = static_cast<vtkIdType>(i);
    const int id =
      given ? static_cast<int>(given->GetComponent(row, 0)) : next + static_cast<int>(i);
    this->GivenIds.push_back(id);
    this->Rows.push_back({ row, this->Uses[i], id });
  }
  std::stable_sort(this->Rows.begin(), this->Rows.end(),
    [](const Row& a, const Row& b) { return a.Part < b.Part; });
  all.insert(all.end(), this->GivenIds.begin(), this->GivenIds.end());
  const bool areAscending =
    areSorted && std::is_sorted(this->GivenIds.begin(), this->GivenIds.end());
  std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  if (twice != all.end() || !areAscending)
  {
    return Status::Error(twice != all.end()
        ? "Part id " + std::to_string(*twice) + " is given twice, by SetPartId or " +
          names::PartIds + " of the instances"
        : std::string("Part ids must ascend: those of SetPartId over the connections, and ") +
          names::PartIds + " over the instances");
  }
  this->NumberOfParts = all.empty() ? 0 : all.back() + 1;
  return {};
}

//------------------------------------------------------------------------------
std::vector<std::size_t> InstanceParts::GetOrder() const
{
  std::vector<int> first(this->Ids);
  for (std::size_t i = this->Rows.size(); i-- > 0;)
  {
    first[this->Rows[i].Connection] = this->Rows[i].Part;
  }
  std::vector<std::size_t> order(first.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&first](std::size_t a, std::size_t b) { return first[a] < first[b]; });
  return order;
}

//------------------------------------------------------------------------------
/// Returns the places of all instances: the given arrays, with defaults for rasters at their own
/// place.
vtkSmartPointer<vtkPolyData> InstanceParts::CopyInstances() const
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  if (this->Rows.size() == this->Uses.size())
  {
    made->ShallowCopy(this->Instances);
    return made;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Row& row : this->Rows)
  {
    double p[3] = { 0.0, 0.0, 0.0 };
    if (row.Given >= 0)
    {
      this->Instances->GetPoint(row.Given, p);
    }
    points->InsertNextPoint(p);
  }
  made->SetPoints(points);
  const double noTurn[4] = { 1.0, 0.0, 0.0, 0.0 };
  const double one[1] = { 1.0 };
  const double none[1] = { -1.0 };
  const std::pair<const char*, const double*> defaults[] = { { names::Orientation, noTurn },
    { names::Scale, one }, { names::MaterialIds, none } };
  for (const auto& [name, byDefault] : defaults)
  {
    vtkDataArray* given = FindArray(this->Instances, name);
    auto copy = given ? vtk::TakeSmartPointer(given->NewInstance()) : nullptr;
    if (copy)
    {
      copy->SetName(name);
      copy->SetNumberOfComponents(given->GetNumberOfComponents());
      made->GetPointData()->AddArray(copy);
    }
    for (std::size_t i = 0; copy && i < this->Rows.size(); ++i)
    {
      const vtkIdType row = this->Rows[i].Given;
      copy->InsertNextTuple(row >= 0 ? given->GetTuple(row) : byDefault);
    }
  }
  return made;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> InstanceParts::MakeInstances(const std::vector<int>& materials) const
{
  const auto prototypes = MakeIds<vtkIntArray>(names::PrototypeIds);
  const auto parts = MakeIds<vtkIntArray>(names::PartIds);
  const auto ids = MakeIds<vtkIntArray>(names::MaterialIds);
  const auto cells = MakeIds<vtkIdTypeArray>(names::FirstCellIds);
  const auto made = this->CopyInstances();
  vtkDataArray* given = FindArray(made, names::MaterialIds);
  bool hasRasters = false;
  std::size_t connection = 0;
  vtkIdType cell = 0;
  for (std::size_t i = 0; i < this->Rows.size(); ++i)
  {
    const Row& row = this->Rows[i];
    for (; connection < this->Parts.size() &&
         (this->IsPrototype(connection) || this->Ids[connection] < row.Part);
         ++connection)
    {
      cell += this->Parts[connection] ? this->Parts[connection]->GetNumberOfPolys() : 0;
    }
    const bool isRaster = this->All[row.Connection].IsRaster();
    const auto own =
      given ? static_cast<int>(given->GetComponent(static_cast<vtkIdType>(i), 0)) : -1;
    hasRasters = hasRasters || isRaster;
    prototypes->InsertNextValue(this->Numbers[row.Connection]);
    parts->InsertNextValue(row.Part);
    ids->InsertNextValue(own < 0 && isRaster ? materials[row.Connection] : own);
    cells->InsertNextValue(cell);
    cell += this->All[row.Connection].Triangles;
  }
  made->GetPointData()->AddArray(prototypes);
  made->GetPointData()->AddArray(parts);
  made->GetPointData()->AddArray(cells);
  if (hasRasters)
  {
    made->GetPointData()->AddArray(ids);
  }
  return made;
}

} // namespace helios
