// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPointActor.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace helios::viewer
{

//------------------------------------------------------------------------------
PointActor::PointActor(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->Xyz->SetNumberOfComponents(3);
  this->Colors->SetNumberOfComponents(4);
  vtkNew<vtkPoints> points;
  points->SetData(this->Xyz);
  this->Data->SetPoints(points);
  this->Data->GetPointData()->SetScalars(this->Colors);
  this->Mapper->SetInputData(this->Data);
  this->Mapper->SetScaleFactor(0.0); // squares of a constant size
  this->Mapper->EmissiveOff();
  this->Actor->SetMapper(this->Mapper);
  this->Actor->PickableOff();
  this->Actor->GetProperty()->LightingOff();
  this->Actor->VisibilityOff();
  renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
PointActor::~PointActor()
{
  this->Renderer->RemoveActor(this->Actor);
}

//------------------------------------------------------------------------------
void PointActor::Show(const float* xyz, vtkIdType count)
{
  if (xyz != this->Shown || count != this->Count || this->Changed)
  {
    this->SetPoints(xyz, this->Rgba.data(), count);
  }
  this->SomeXyz = {};
  this->SomeRgba = {};
}

//------------------------------------------------------------------------------
void PointActor::ShowSome(const float* xyz, const std::vector<vtkIdType>& which)
{
  this->SomeXyz.clear();
  this->SomeRgba.clear();
  for (const vtkIdType i : which)
  {
    this->SomeXyz.insert(this->SomeXyz.end(), xyz + 3 * i, xyz + 3 * i + 3);
    const std::uint8_t* color = this->Rgba.data() + 4 * i;
    this->SomeRgba.insert(this->SomeRgba.end(), color, color + 4);
  }
  this->SetPoints(
    this->SomeXyz.data(), this->SomeRgba.data(), static_cast<vtkIdType>(which.size()));
}

//------------------------------------------------------------------------------
void PointActor::SetPoints(const float* xyz, const std::uint8_t* rgba, vtkIdType count)
{
  if (xyz != this->Shown || count != this->Count || !this->SomeXyz.empty())
  {
    this->Xyz->SetArray(const_cast<float*>(xyz), 3 * count, 1); // VTK only reads it
    this->Xyz->Modified();
    this->Data->GetPoints()->Modified();
  }
  this->Colors->SetArray(const_cast<std::uint8_t*>(rgba), 4 * count, 1);
  this->Colors->Modified();
  this->Data->Modified();
  this->Shown = xyz;
  this->Count = count;
  this->Changed = false;
}

//------------------------------------------------------------------------------
void PointActor::SetVisible(bool on)
{
  this->Actor->SetVisibility(on && this->Count > 0);
}

//------------------------------------------------------------------------------
bool PointActor::IsVisible() const
{
  return this->Actor->GetVisibility() != 0;
}

//------------------------------------------------------------------------------
void PointActor::SetPointSize(double size)
{
  this->Actor->GetProperty()->SetPointSize(static_cast<float>(size));
}

//------------------------------------------------------------------------------
void PointActor::SetPlanes(vtkPlaneCollection* planes)
{
  this->Mapper->SetClippingPlanes(planes);
}

//------------------------------------------------------------------------------
std::size_t PointActor::GetMemorySize() const
{
  return sizeof(*this) + this->Rgba.capacity() + this->SomeRgba.capacity() +
    this->SomeXyz.capacity() * sizeof(float);
}

} // namespace helios::viewer
