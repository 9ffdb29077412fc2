// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosScene.h"

#include "heliosHeightCache.h"
#include "heliosHeightField.h"
#include "heliosSimilarity.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkBoundingBox.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

vtkStandardNewMacro(vtkHeliosScene);

namespace
{

/// Returns the triangles of a prototype; none if it is not valid.
vtkIdType CountTriangles(vtkDataSet* prototype)
{
  std::shared_ptr<const helios::HeightField> field;
  if (auto* raster = vtkImageData::SafeDownCast(prototype))
  {
    return helios::GetHeightField(raster, field).IsOk() ? field->GetNumberOfTriangles() : 0;
  }
  auto* mesh = vtkPolyData::SafeDownCast(prototype);
  return mesh ? mesh->GetNumberOfPolys() : 0;
}

/// Returns a box of bounds; not valid if they are not set.
vtkBoundingBox MakeBox(const double bounds[6])
{
  vtkBoundingBox box;
  if (vtkMath::AreBoundsInitialized(bounds))
  {
    box.SetBounds(bounds);
  }
  return box;
}

/// Returns the box of a prototype; not valid if it has none.
vtkBoundingBox GetBox(vtkDataSet* prototype)
{
  double bounds[6];
  vtkMath::UninitializeBounds(bounds);
  std::shared_ptr<const helios::HeightField> field;
  auto* raster = vtkImageData::SafeDownCast(prototype);
  if (raster && helios::GetHeightField(raster, field).IsOk())
  {
    field->GetBounds(bounds);
  }
  else if (prototype && !raster)
  {
    prototype->GetBounds(bounds);
  }
  return MakeBox(bounds);
}

/// Returns the place of an instance; its arrays may be missing.
helios::Similarity GetPlace(vtkPolyData* instances, vtkIdType i)
{
  double quaternion[4] = { 1.0, 0.0, 0.0, 0.0 };
  double scale = 1.0;
  vtkDataArray* orientations =
    instances->GetPointData()->GetArray(vtkHeliosArrayNames::Orientation);
  vtkDataArray* scales = instances->GetPointData()->GetArray(vtkHeliosArrayNames::Scale);
  if (orientations && orientations->GetNumberOfComponents() == 4 &&
    i < orientations->GetNumberOfTuples())
  {
    orientations->GetTuple(i, quaternion);
  }
  if (scales && i < scales->GetNumberOfTuples())
  {
    scale = scales->GetComponent(i, 0);
  }
  return { quaternion, scale, instances->GetPoint(i) };
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosScene::SetInstances(vtkPolyData* instances)
{
  if (this->Instances != instances)
  {
    this->Instances = instances;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosScene::GetNumberOfInstances() const
{
  return this->Instances ? this->Instances->GetNumberOfPoints() : 0;
}

//------------------------------------------------------------------------------
void vtkHeliosScene::AddPrototype(vtkDataSet* prototype)
{
  if (!vtkPolyData::SafeDownCast(prototype) && !vtkImageData::SafeDownCast(prototype))
  {
    vtkErrorMacro(<< "AddPrototype: the prototype is "
                  << (prototype ? prototype->GetClassName() : "null")
                  << "; give a vtkPolyData of triangles, or a vtkImageData of heights.");
    return;
  }
  this->Prototypes.emplace_back(prototype);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkDataSet* vtkHeliosScene::GetPrototype(int prototype) const
{
  const bool isKnown = prototype >= 0 && prototype < this->GetNumberOfPrototypes();
  return isKnown ? this->Prototypes[static_cast<std::size_t>(prototype)].Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosScene::GetNumberOfTriangles() const
{
  vtkIdType count = const_cast<vtkHeliosScene*>(this)->GetNumberOfPolys();
  vtkDataArray* ids = this->Instances
    ? this->Instances->GetPointData()->GetArray(vtkHeliosArrayNames::PrototypeIds)
    : nullptr;
  std::map<vtkDataSet*, vtkIdType> counts;
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    vtkDataSet* prototype = this->GetPrototype(static_cast<int>(ids->GetComponent(i, 0)));
    const auto [known, isNew] = counts.emplace(prototype, 0);
    known->second = isNew ? CountTriangles(prototype) : known->second;
    count += known->second;
  }
  return count;
}

//------------------------------------------------------------------------------
bool vtkHeliosScene::HasInstances(vtkPolyData* scene)
{
  auto* whole = vtkHeliosScene::SafeDownCast(scene);
  return whole && whole->GetNumberOfInstances() > 0;
}

//------------------------------------------------------------------------------
void vtkHeliosScene::ComputeBounds()
{
  if (this->GetMTime() <= this->ComputeTime)
  {
    return;
  }
  vtkNew<vtkPolyData> mesh; // without the instances
  mesh->ShallowCopy(this);
  vtkBoundingBox all = MakeBox(mesh->GetBounds());
  std::vector<vtkBoundingBox> boxes;
  std::transform(
    this->Prototypes.begin(), this->Prototypes.end(), std::back_inserter(boxes), GetBox);
  vtkDataArray* ids = this->Instances
    ? this->Instances->GetPointData()->GetArray(vtkHeliosArrayNames::PrototypeIds)
    : nullptr;
  for (vtkIdType i = 0; i < this->GetNumberOfInstances(); ++i)
  {
    const double id = ids ? ids->GetComponent(i, 0) : 0.0;
    if (!(id >= 0.0 && id < static_cast<double>(boxes.size())) ||
      !boxes[static_cast<std::size_t>(id)].IsValid())
    {
      continue;
    }
    const helios::Similarity place = GetPlace(this->Instances, i);
    for (int corner = 0; corner < 8; ++corner)
    {
      double p[3];
      boxes[static_cast<std::size_t>(id)].GetCorner(corner, p);
      place.Apply(p, p);
      all.AddPoint(p);
    }
  }
  vtkMath::UninitializeBounds(this->Bounds);
  if (all.IsValid())
  {
    all.GetBounds(this->Bounds);
  }
  this->ComputeTime.Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosScene::Initialize()
{
  this->Superclass::Initialize();
  this->Instances = nullptr;
  this->Prototypes.clear();
}

//------------------------------------------------------------------------------
void vtkHeliosScene::ShallowCopy(vtkDataObject* from)
{
  this->Superclass::ShallowCopy(from);
  auto* scene = vtkHeliosScene::SafeDownCast(from);
  this->Instances = scene ? scene->Instances : nullptr;
  this->Prototypes = scene ? scene->Prototypes : decltype(this->Prototypes)();
}

//------------------------------------------------------------------------------
void vtkHeliosScene::DeepCopy(vtkDataObject* from)
{
  this->Superclass::DeepCopy(from);
  const auto copy = [](auto* data)
  {
    auto own = vtk::TakeSmartPointer(data->NewInstance());
    own->DeepCopy(data);
    return own;
  };
  auto* scene = vtkHeliosScene::SafeDownCast(from);
  this->Instances = scene && scene->Instances ? copy(scene->Instances.Get()) : nullptr;
  decltype(this->Prototypes) copies;
  for (int i = 0; scene && i < scene->GetNumberOfPrototypes(); ++i)
  {
    copies.emplace_back(copy(scene->GetPrototype(i)));
  }
  this->Prototypes = std::move(copies);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHeliosScene::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = this->Instances ? std::max(time, this->Instances->GetMTime()) : time;
  for (vtkDataSet* prototype : this->Prototypes)
  {
    time = std::max(time, prototype->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
unsigned long vtkHeliosScene::GetActualMemorySize()
{
  unsigned long size = this->Superclass::GetActualMemorySize();
  size += this->Instances ? this->Instances->GetActualMemorySize() : 0;
  for (vtkDataSet* prototype : this->Prototypes)
  {
    size += prototype->GetActualMemorySize();
  }
  return size;
}

//------------------------------------------------------------------------------
void vtkHeliosScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Prototypes: " << this->Prototypes.size() << "\n";
  os << indent << "Instances: " << this->GetNumberOfInstances() << "\n";
}
