// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Helpers shared by the planning tests.

#ifndef heliosPlanningTest_h
#define heliosPlanningTest_h

#include "heliosErrorObserver.h"

#include <catch2/catch.hpp>
#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

namespace helios
{

inline vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<std::array<double, 3>>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : places)
  {
    points->InsertNextPoint(p.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

/// Triangles, of three corners each.
inline vtkSmartPointer<vtkPolyData> MakeTriangles(
  const std::vector<std::array<double, 3>>& places, const std::vector<std::array<int, 3>>& corners)
{
  auto scene = MakePoints(places);
  vtkNew<vtkCellArray> polys;
  for (const auto& c : corners)
  {
    polys->InsertNextCell({ c[0], c[1], c[2] });
  }
  scene->SetPolys(polys);
  return scene;
}

/// Two triangles over a square about the origin, at a height.
inline vtkSmartPointer<vtkPolyData> MakeFloor(double half, double z)
{
  return MakeTriangles(
    { { -half, -half, z }, { half, -half, z }, { half, half, z }, { -half, half, z } },
    { { 0, 1, 2 }, { 0, 2, 3 } });
}

/// A filter on a scene, with steps of 1 m and recorded errors.
template <typename FilterT>
struct FilterOverScene
{
  vtkNew<FilterT> Filter;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  explicit FilterOverScene(vtkPolyData* scene)
  {
    this->Filter->SetInputData(0, scene);
    this->Filter->SetStep(1.0);
    this->Log->Watch(this->Filter);
  }

  vtkPolyData* Update()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  /// Whether an update reports an error with this text.
  bool Fails(const std::string& text)
  {
    this->Update();
    INFO(this->Log->Errors);
    return this->Log->HasError(text);
  }
};

/// Aborts a filter at its next progress event.
inline void AbortAtProgress(vtkAlgorithm* filter)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* object, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(object)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
}

} // namespace helios

#endif
