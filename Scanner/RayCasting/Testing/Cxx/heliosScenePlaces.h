// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The instances of scenes of tests.

#ifndef heliosScenePlaces_h
#define heliosScenePlaces_h

#include "heliosPose.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace helios
{

/// Instances of a scene under construction.
class ScenePlaces
{
public:
  ScenePlaces()
  {
    this->Prototypes->SetName(vtkHeliosArrayNames::PrototypeIds);
    this->Orientations->SetName(vtkHeliosArrayNames::Orientation);
    this->Orientations->SetNumberOfComponents(4);
    this->Scales->SetName(vtkHeliosArrayNames::Scale);
    this->Points->SetDataTypeToDouble();
  }

  void Add(int prototype, const Vec3& at, const Quaternion& q, double scale)
  {
    this->Points->InsertNextPoint(at.GetData());
    this->Prototypes->InsertNextValue(prototype);
    this->Orientations->InsertNextTuple4(q.GetW(), q.GetX(), q.GetY(), q.GetZ());
    this->Scales->InsertNextValue(scale);
  }

  vtkSmartPointer<vtkPolyData> Get() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    data->GetPointData()->AddArray(this->Prototypes);
    data->GetPointData()->AddArray(this->Orientations);
    data->GetPointData()->AddArray(this->Scales);
    return data;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIntArray> Prototypes;
  vtkNew<vtkDoubleArray> Orientations;
  vtkNew<vtkDoubleArray> Scales;
};

} // namespace helios

#endif
