// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scanner on a tripod before scenes of rectangles.

#ifndef heliosScannerBench_h
#define heliosScannerBench_h

#include "heliosErrorObserver.h"
#include "heliosPose.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosScanner.h"
#include "vtkHeliosStaticPlatform.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <string>
#include <vector>

namespace helios
{
namespace testing
{

/// A user-defined deflector: all pulses along y.
class StraightAhead : public vtkHeliosBeamDeflector
{
public:
  static StraightAhead* New() { VTK_STANDARD_NEW_BODY(StraightAhead); }
  vtkTypeMacro(StraightAhead, vtkHeliosBeamDeflector);
  bool GetDirection(vtkIdType, double direction[3]) const override
  {
    direction[0] = direction[2] = 0.0;
    direction[1] = 1.0;
    return true;
  }
};

/// Rectangles given by a corner and two sides.
struct Rectangle
{
  Vec3 Corner, A, B;
};

inline vtkSmartPointer<vtkPolyData> MakeScene(const std::vector<Rectangle>& rectangles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (const Rectangle& r : rectangles)
  {
    const vtkIdType i = points->GetNumberOfPoints();
    for (const Vec3& p : { r.Corner, r.Corner + r.A, r.Corner + r.A + r.B, r.Corner + r.B })
    {
      points->InsertNextPoint(p.GetData());
    }
    polys->InsertNextCell({ i, i + 1, i + 2 });
    polys->InsertNextCell({ i, i + 2, i + 3 });
  }
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->SetPoints(points);
  scene->SetPolys(polys);
  return scene;
}

/// A wall across the y axis at a distance.
inline Rectangle Wall(double y, double half = 50.0)
{
  return { { -half, y, -half }, { 2 * half, 0, 0 }, { 0, 0, 2 * half } };
}

inline vtkSmartPointer<vtkPolyData> MakeWaypoints(
  std::initializer_list<Vec3> positions, double speed = 1.0)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> speeds;
  speeds->SetName(vtkHeliosArrayNames::Speed);
  for (const Vec3& p : positions)
  {
    points->InsertNextPoint(p.GetData());
    speeds->InsertNextValue(speed);
  }
  auto waypoints = vtkSmartPointer<vtkPolyData>::New();
  waypoints->SetPoints(points);
  waypoints->GetPointData()->AddArray(speeds);
  return waypoints;
}

/// A scanner on a tripod at the origin, facing y, for 10 ms: 1000 pulses of 19 sub-rays.
struct Bench
{
  vtkNew<vtkHeliosScanner> Scanner;
  vtkNew<StraightAhead> Deflector;
  vtkNew<vtkHeliosStaticPlatform> Tripod;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  explicit Bench(vtkPolyData* scene, Vec3 position = { 0, 0, 0 })
  {
    this->Tripod->SetInputData(MakeWaypoints({ position }));
    this->Scanner->SetInputData(0, scene);
    this->Scanner->SetInputConnection(1, this->Tripod->GetOutputPort());
    this->Scanner->SetBeamDeflector(this->Deflector);
    this->Scanner->SetDuration(0.01);
    this->Scanner->SetSamplingToFixed();
    this->Scanner->GetBeamSampler()->SetPatternToCircles();
    this->Log->Watch(this->Scanner);
    this->Log->Watch(this->Scanner->GetExecutive());
  }

  vtkPolyData* Run()
  {
    this->Scanner->Update();
    return this->Scanner->GetOutput();
  }
};

inline double Value(vtkPolyData* data, const char* name, vtkIdType row)
{
  return data->GetPointData()->GetArray(name)->GetComponent(row, 0);
}

/// All bytes of a cloud, in order.
inline std::string Bytes(vtkPolyData* data)
{
  std::string bytes;
  const auto append = [&bytes](vtkDataArray* array)
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
  };
  append(data->GetPoints()->GetData());
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    append(data->GetPointData()->GetArray(i));
  }
  return bytes;
}

} // namespace testing
} // namespace helios

#endif
