// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs a scanner with a custom deflector over the plane z = 0 from 10 m above it. An echo at scan
// angle a must lie at range 10 m / cos a, on the plane.
#include "ownZigzagMirror.h"

#include <vtkHeliosBeamSampler.h>
#include <vtkHeliosScanner.h>
#include <vtkHeliosStaticPlatform.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
constexpr double Height = 10.0;
constexpr vtkIdType NumberOfPulses = 1000;

vtkSmartPointer<vtkPoints> MakePoints()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  return points;
}

void MakePlane(vtkPolyData* plane)
{
  auto points = MakePoints();
  for (const double y : { -50.0, 50.0 })
  {
    points->InsertNextPoint(-50.0, y, 0.0);
    points->InsertNextPoint(50.0, y, 0.0);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 3 });
  triangles->InsertNextCell({ 0, 3, 2 });
  plane->SetPoints(points);
  plane->SetPolys(triangles);
}

void MakeWaypoint(vtkPolyData* waypoint)
{
  auto points = MakePoints();
  points->InsertNextPoint(0.0, 0.0, Height);
  waypoint->SetPoints(points);
}

/// The largest distance of an echo from its expected position [m].
double FindLargestError(vtkPolyData* echoes)
{
  vtkDataArray* range = echoes->GetPointData()->GetArray("Range");
  vtkDataArray* angle = echoes->GetPointData()->GetArray("ScanAngle");
  double largest = 0.0;
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    const double expected = Height / std::cos(vtkMath::RadiansFromDegrees(angle->GetTuple1(i)));
    largest = std::max(largest, std::abs(range->GetTuple1(i) - expected));
    largest = std::max(largest, std::abs(echoes->GetPoint(i)[2]));
  }
  return largest;
}
} // namespace

int main()
{
  vtkNew<vtkPolyData> plane;
  MakePlane(plane);
  vtkNew<vtkPolyData> waypoint;
  MakeWaypoint(waypoint);

  vtkNew<vtkHeliosStaticPlatform> tripod;
  tripod->SetInputData(waypoint);

  vtkNew<ownZigzagMirror> mirror;
  mirror->SetPulseFrequency(1000.0);
  vtkNew<vtkHeliosBeamSampler> beam;
  beam->SetBeamDivergence(0.0);

  vtkNew<vtkHeliosScanner> scanner;
  scanner->SetInputData(0, plane);
  scanner->SetInputConnection(1, tripod->GetOutputPort());
  scanner->SetBeamDeflector(mirror);
  scanner->SetBeamSampler(beam);
  scanner->SetDuration(NumberOfPulses / mirror->GetPulseFrequency());
  scanner->Update();

  vtkPolyData* echoes = scanner->GetOutput();
  const double error = FindLargestError(echoes);
  std::cout << echoes->GetNumberOfPoints() << " echoes, largest error " << error << " m\n";
  return echoes->GetNumberOfPoints() == NumberOfPulses && error < 1e-9 ? 0 : 1;
}
