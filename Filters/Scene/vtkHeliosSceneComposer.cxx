// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSceneComposer.h"

#include "heliosCoordinateSystem.h"
#include "heliosInstanceParts.h"
#include "heliosMaterialTable.h"
#include "heliosPartMaterials.h"
#include "heliosSceneCrs.h"
#include "heliosSceneJoin.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

vtkStandardNewMacro(vtkHeliosSceneComposer);

namespace names = vtkHeliosArrayNames;
using helios::ConnectionList;
using helios::PartList;

namespace
{

/// Returns an error if two CRS texts are not equivalent.
helios::Status CompareCRS(const std::string& own, const std::string& before)
{
  helios::CoordinateSystem systems[2];
  for (const helios::Status& status : { systems[0].Set(own), systems[1].Set(before) })
  {
    if (!status.IsOk())
    {
      return helios::Status::Error(
        own + ", but earlier parts have " + before + ": " + status.Message());
    }
  }
  return systems[0] == systems[1]
    ? helios::Status()
    : helios::Status::Error(systems[0].GetName() + ", but earlier parts have " +
        systems[1].GetName() +
        "; reproject one of them: vtkHeliosReproject, or <filter type=\"crs\"> with target " +
        systems[1].GetLabel());
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosSceneComposer::vtkHeliosSceneComposer()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkHeliosSceneComposer::SetPartId(int part, int id)
{
  if (part < 0 || id < 0)
  {
    vtkErrorMacro(<< "Part " << part << " cannot have the id " << id
                  << "; parts and ids are numbered from 0");
    return;
  }
  const auto index = static_cast<std::size_t>(part);
  this->PartIds.resize(std::max(this->PartIds.size(), index + 1), -1);
  if (this->PartIds[index] != id)
  {
    this->PartIds[index] = id;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHeliosSceneComposer::GetPartId(int part) const
{
  const auto index = static_cast<std::size_t>(part);
  return part >= 0 && index < this->PartIds.size() ? this->PartIds[index] : -1;
}

//------------------------------------------------------------------------------
void vtkHeliosSceneComposer::SetPartIsSplit(int part, bool isSplit)
{
  if (part < 0)
  {
    vtkErrorMacro("Part " << part << " does not exist; parts are counted from 0");
    return;
  }
  const auto index = static_cast<std::size_t>(part);
  this->AreSplit.resize(std::max(this->AreSplit.size(), index + 1), false);
  if (this->AreSplit[index] != isSplit)
  {
    this->AreSplit[index] = isSplit;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosSceneComposer::GetPartIsSplit(int part) const
{
  const auto index = static_cast<std::size_t>(part);
  return part >= 0 && index < this->AreSplit.size() && this->AreSplit[index];
}

//------------------------------------------------------------------------------
void vtkHeliosSceneComposer::SetPartName(int part, const char* name)
{
  if (part < 0)
  {
    vtkErrorMacro(<< "Part " << part << " cannot have a name; parts are numbered from 0");
    return;
  }
  const auto index = static_cast<std::size_t>(part);
  const std::string text = name ? name : "";
  if (this->PartNames.size() <= index)
  {
    this->PartNames.resize(index + 1);
  }
  if (this->PartNames[index] != text)
  {
    this->PartNames[index] = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkHeliosSceneComposer::GetPartName(int part) const
{
  const auto index = static_cast<std::size_t>(part);
  const bool isNamed = index < this->PartNames.size() && !this->PartNames[index].empty();
  return isNamed ? this->PartNames[index] : std::to_string(part);
}

//------------------------------------------------------------------------------
int vtkHeliosSceneComposer::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  }
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), port == 0);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // for a clearer error message of this class
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkHeliosSceneComposer::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputVector, outputVector);
  }
  this->MakeOutput(inputVector[0], outputVector);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosSceneComposer::MakeOutput(
  vtkInformationVector* inputs, vtkInformationVector* outputVector)
{
  bool hasInstances = this->GetNumberOfInputConnections(1) > 0;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    hasInstances = hasInstances || vtkImageData::GetData(inputs, i);
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!output || hasInstances != (vtkHeliosScene::SafeDownCast(output) != nullptr))
  {
    const auto made = hasInstances
      ? vtkSmartPointer<vtkPolyData>(vtkSmartPointer<vtkHeliosScene>::New())
      : vtkSmartPointer<vtkPolyData>::New();
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
}

//------------------------------------------------------------------------------
int vtkHeliosSceneComposer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  ConnectionList parts;
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!this->FindParts(inputVector[0], parts))
  {
    return 0;
  }
  auto* scene = vtkHeliosScene::SafeDownCast(output);
  const bool isMade = scene
    ? this->ComposeInstances(parts, vtkPolyData::GetData(inputVector[1]), scene)
    : this->Compose(parts, output);
  if (!isMade || !this->AddCRS(output, parts))
  {
    output->Initialize();
    return 0;
  }
  AddNotes(output, parts);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosSceneComposer::Compose(const ConnectionList& connections, vtkPolyData* output)
{
  const PartList parts = helios::GetMeshes(connections);
  output->SetPoints(helios::JoinPoints(parts));
  output->SetPolys(helios::JoinCells(parts));
  if (!this->AddMaterialIds(output, connections))
  {
    return false;
  }
  output->GetCellData()->AddArray(helios::MakePartIds(parts));
  this->AddSurfaceArrays(parts, output);
  this->AddPartNames(output, static_cast<int>(parts.size()));
  helios::SplitParts(parts, this->AreSplit, output);
  return true;
}

//------------------------------------------------------------------------------
/// Adds Normals, (0, 0, 0) for parts without, and the arrays of colours.
void vtkHeliosSceneComposer::AddSurfaceArrays(const PartList& parts, vtkPolyData* output)
{
  vtkCellData* cells = output->GetCellData();
  if (const auto normals = helios::JoinCellArrays(parts, names::Normals, 3, 0.0f))
  {
    cells->SetNormals(normals);
  }
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  for (const auto& [name, components] :
    { std::pair(names::TextureCoordinates, 6), std::pair(names::RGB, 3) })
  {
    const auto array = this->PassColors ? helios::JoinCellArrays(parts, name, components, none)
                                        : vtkSmartPointer<vtkFloatArray>();
    if (array)
    {
      cells->AddArray(array);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosSceneComposer::ComposeInstances(
  const ConnectionList& all, vtkPolyData* instances, vtkHeliosScene* output)
{
  helios::InstanceParts split;
  if (const helios::Status status = split.Set(all, this->PartIds, instances); !status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  std::vector<vtkSmartPointer<vtkIntArray>> ids;
  std::vector<int> rows;
  if (!this->MapMaterials(all, split.GetOrder(), output, ids, rows))
  {
    return false;
  }
  const PartList& parts = split.GetParts();
  if (helios::CountTriangles(parts) > 0)
  {
    output->SetPoints(helios::JoinPoints(parts));
    output->SetPolys(helios::JoinCells(parts));
    vtkNew<vtkIntArray> materials;
    materials->SetName(names::MaterialIds);
    const auto partIds = helios::MakePartIds(parts);
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      for (vtkIdType cell = 0; parts[i] && cell < parts[i]->GetNumberOfPolys(); ++cell)
      {
        partIds->SetValue(materials->InsertNextValue(ids[i]->GetValue(cell)), split.GetPartId(i));
      }
    }
    output->GetCellData()->AddArray(materials);
    output->GetCellData()->AddArray(partIds);
    this->AddSurfaceArrays(parts, output);
  }
  for (const std::size_t connection : split.GetPrototypes())
  {
    const auto prototype = vtk::TakeSmartPointer(all[connection].Data->NewInstance());
    prototype->ShallowCopy(all[connection].Data);
    if (ids[connection])
    {
      prototype->GetCellData()->AddArray(ids[connection]);
    }
    output->AddPrototype(prototype);
  }
  output->SetInstances(split.MakeInstances(rows));
  this->AddPartNames(output, split, instances);
  helios::SplitParts(parts, this->AreSplit, output);
  return true;
}

//------------------------------------------------------------------------------
/// Sets the materials of a scene, merged from the materials of the parts in an order, and makes the
/// material ids of meshes, and the first row of each part.
bool vtkHeliosSceneComposer::MapMaterials(const ConnectionList& parts,
  const std::vector<std::size_t>& order, vtkPolyData* scene,
  std::vector<vtkSmartPointer<vtkIntArray>>& ids, std::vector<int>& firstRows)
{
  helios::MaterialTable table;
  ids.resize(parts.size());
  firstRows.assign(parts.size(), 0);
  for (const std::size_t i : order)
  {
    if (!parts[i].Data)
    {
      continue;
    }
    const std::vector<int> rows =
      helios::MergeMaterials(helios::GetMaterials(parts[i].Data), table);
    firstRows[i] = rows.front();
    vtkPolyData* mesh = parts[i].GetMesh();
    if (!mesh)
    {
      continue;
    }
    ids[i] = vtkSmartPointer<vtkIntArray>::New();
    ids[i]->SetName(names::MaterialIds);
    ids[i]->SetNumberOfValues(mesh->GetNumberOfPolys());
    const vtkIdType bad = helios::MapMaterialIds(mesh, rows, ids[i]->GetPointer(0));
    if (bad >= 0)
    {
      this->ReportMaterial(static_cast<int>(i), bad, rows.size());
      return false;
    }
  }
  helios::SetMaterials(scene, table);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSceneComposer::FindParts(vtkInformationVector* inputs, ConnectionList& parts)
{
  vtkIdType triangles = 0;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    helios::Connection part;
    if (const helios::Status status = part.Set(vtkDataSet::GetData(inputs, i)); !status.IsOk())
    {
      vtkErrorMacro(<< this->DescribePart(i) << status.Message());
      return false;
    }
    if (!part.Data)
    {
      vtkWarningMacro(<< this->DescribePart(i) << " has no triangles; it is left out");
    }
    parts.push_back(part);
    triangles += part.Triangles;
  }
  if (triangles == 0)
  {
    vtkErrorMacro(<< "The scene is empty: none of its " << parts.size()
                  << " parts has triangles; add parts with AddInputConnection");
    return false;
  }
  const PartList meshes = helios::GetMeshes(parts);
  const vtkIdType largest =
    std::max(helios::CountPoints(meshes), 3 * helios::CountTriangles(meshes));
  if (largest > std::numeric_limits<vtkTypeInt32>::max())
  {
    vtkErrorMacro(<< "The scene has " << helios::CountPoints(meshes) << " points and "
                  << helios::CountTriangles(meshes)
                  << " triangles, more than 2^31 points or corners; "
                  << "split it into several scenes");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSceneComposer::DescribePart(int part) const
{
  const std::string index = std::to_string(part);
  const std::string name = this->GetPartName(part);
  return "Part " + index + (name == index ? "" : " (" + name + ")");
}

//------------------------------------------------------------------------------
bool vtkHeliosSceneComposer::AddMaterialIds(vtkPolyData* scene, const ConnectionList& connections)
{
  const PartList parts = helios::GetMeshes(connections);
  if (vtkIntArray* single = helios::GetSingleMaterialIds(parts))
  {
    helios::SetMaterials(scene, helios::GetMaterials(helios::GetSinglePart(parts)));
    scene->GetCellData()->AddArray(single);
    return true;
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::vector<vtkSmartPointer<vtkIntArray>> all;
  std::vector<int> firstRows;
  if (!this->MapMaterials(connections, order, scene, all, firstRows))
  {
    return false;
  }
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  ids->SetNumberOfValues(helios::CountTriangles(parts));
  int* to = ids->GetPointer(0);
  for (const auto& own : all)
  {
    to = own ? std::copy_n(own->GetPointer(0), own->GetNumberOfValues(), to) : to;
  }
  scene->GetCellData()->AddArray(ids);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosSceneComposer::ReportMaterial(int part, vtkIdType triangle, std::size_t count)
{
  vtkErrorMacro(<< this->DescribePart(part) << ": triangle " << triangle
                << " has a material id that is not one of its " << count
                << " materials; material ids are rows of the material columns");
}

//------------------------------------------------------------------------------
bool vtkHeliosSceneComposer::AddCRS(vtkPolyData* scene, const ConnectionList& parts)
{
  std::string crs; // system of the first part that has one
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const std::string own = parts[i].Data ? helios::GetCRS(parts[i].Data) : std::string();
    const helios::Status status =
      crs.empty() || own.empty() || own == crs ? helios::Status() : CompareCRS(own, crs);
    if (!status.IsOk())
    {
      vtkErrorMacro(<< this->DescribePart(static_cast<int>(i)) << " has the CRS "
                    << status.Message());
      return false;
    }
    crs = crs.empty() ? own : crs;
  }
  helios::SetCRS(scene, crs);
  return true;
}

//------------------------------------------------------------------------------
/// Adds what the readers of the parts note.
void vtkHeliosSceneComposer::AddNotes(vtkPolyData* scene, const ConnectionList& parts)
{
  vtkNew<vtkStringArray> column;
  column->SetName(names::Notes);
  for (const helios::Connection& part : parts)
  {
    auto* own = vtkStringArray::SafeDownCast(
      part.Data ? part.Data->GetFieldData()->GetAbstractArray(names::Notes) : nullptr);
    for (vtkIdType i = 0; own && i < own->GetNumberOfValues(); ++i)
    {
      column->InsertNextValue(own->GetValue(i));
    }
  }
  if (column->GetNumberOfValues() > 0)
  {
    scene->GetFieldData()->AddArray(column);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosSceneComposer::AddPartNames(vtkPolyData* scene, int count) const
{
  vtkNew<vtkStringArray> column;
  column->SetName(names::PartName);
  for (int i = 0; i < count; ++i)
  {
    column->InsertNextValue(this->GetPartName(i));
  }
  scene->GetFieldData()->AddArray(column);
}

//------------------------------------------------------------------------------
void vtkHeliosSceneComposer::AddPartNames(
  vtkPolyData* scene, const helios::InstanceParts& split, vtkPolyData* instances) const
{
  std::vector<std::string> all(static_cast<std::size_t>(split.GetNumberOfParts()));
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = std::to_string(i);
  }
  for (std::size_t i = 0; i < split.GetParts().size(); ++i)
  {
    const bool isNamed = i < this->PartNames.size() && !this->PartNames[i].empty();
    if (split.GetPartId(i) >= 0 && isNamed)
    {
      all[static_cast<std::size_t>(split.GetPartId(i))] = this->PartNames[i];
    }
  }
  auto* given = vtkStringArray::SafeDownCast(
    instances ? instances->GetPointData()->GetAbstractArray(names::PartName) : nullptr);
  for (vtkIdType i = 0; given && i < given->GetNumberOfValues(); ++i)
  {
    std::string& name = all[static_cast<std::size_t>(split.GetInstancePart(i))];
    name = given->GetValue(i).empty() ? name : std::string(given->GetValue(i));
  }
  vtkNew<vtkStringArray> column;
  column->SetName(names::PartName);
  for (const std::string& name : all)
  {
    column->InsertNextValue(name);
  }
  scene->GetFieldData()->AddArray(column);
}

//------------------------------------------------------------------------------
void vtkHeliosSceneComposer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PartNames: " << this->PartNames.size() << " given\n"
     << indent << "PassColors: " << this->PassColors << "\n";
}
