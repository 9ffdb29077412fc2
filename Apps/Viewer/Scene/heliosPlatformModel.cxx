// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlatformModel.h"

#include "heliosPlatformKind.h"
#include "heliosPose.h"

#include <vtkAppendPolyData.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkDiskSource.h>
#include <vtkLineSource.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTubeFilter.h>

namespace helios::viewer
{

namespace
{

/// Assembles parts.
class Model
{
public:
  void AddBox(const Vec3& center, const Vec3& size)
  {
    vtkNew<vtkCubeSource> box;
    box->SetCenter(center[0], center[1], center[2]);
    box->SetXLength(size[0]);
    box->SetYLength(size[1]);
    box->SetZLength(size[2]);
    this->Add(box->GetOutputPort());
  }

  void AddRod(const Vec3& from, const Vec3& to, double radius)
  {
    vtkNew<vtkLineSource> line;
    line->SetPoint1(from[0], from[1], from[2]);
    line->SetPoint2(to[0], to[1], to[2]);
    vtkNew<vtkTubeFilter> tube;
    tube->SetInputConnection(line->GetOutputPort());
    tube->SetRadius(radius);
    tube->SetNumberOfSides(16);
    tube->CappingOn();
    this->Add(tube->GetOutputPort());
  }

  void AddBall(const Vec3& center, double radius)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(center[0], center[1], center[2]);
    ball->SetRadius(radius);
    ball->SetThetaResolution(16);
    ball->SetPhiResolution(12);
    this->Add(ball->GetOutputPort());
  }

  void AddDisk(const Vec3& center, double radius)
  {
    vtkNew<vtkDiskSource> disk;
    disk->SetInnerRadius(0.0);
    disk->SetOuterRadius(radius);
    disk->SetCircumferentialResolution(24);
    vtkNew<vtkTransform> place;
    place->Translate(center.GetData());
    vtkNew<vtkTransformPolyDataFilter> moved;
    moved->SetTransform(place);
    moved->SetInputConnection(disk->GetOutputPort());
    this->Add(moved->GetOutputPort());
  }

  vtkSmartPointer<vtkPolyData> Get()
  {
    this->Parts->Update();
    return this->Parts->GetOutput();
  }

private:
  void Add(vtkAlgorithmOutput* part) { this->Parts->AddInputConnection(part); }

  vtkNew<vtkAppendPolyData> Parts;
};

vtkSmartPointer<vtkPolyData> MakeTripod()
{
  Model model;
  for (const double angle : { 90.0, 210.0, 330.0 })
  {
    const Vec3 foot = Rotate(AxisAngle({ 0.0, 0.0, 1.0 }, angle), Vec3(0.5, 0.0, 0.0));
    model.AddRod(foot, Vec3(0.0, 0.0, 1.4), 0.025);
  }
  model.AddRod(Vec3(0.0, 0.0, 1.38), Vec3(0.0, 0.0, 1.45), 0.1);
  return model.Get();
}

vtkSmartPointer<vtkPolyData> MakeAircraft()
{
  Model model;
  model.AddRod(Vec3(0.0, -3.5, 0.2), Vec3(0.0, 3.5, 0.0), 0.55);
  model.AddBox(Vec3(0.0, 0.6, 0.5), Vec3(11.0, 1.4, 0.15));
  model.AddBox(Vec3(0.0, -3.3, 0.4), Vec3(3.6, 0.8, 0.1));
  model.AddBox(Vec3(0.0, -3.3, 1.0), Vec3(0.1, 0.9, 1.3));
  return model.Get();
}

vtkSmartPointer<vtkPolyData> MakeCar()
{
  Model model;
  model.AddBox(Vec3(0.0, 0.0, 0.7), Vec3(1.8, 4.4, 0.6));
  model.AddBox(Vec3(0.0, -0.5, 1.3), Vec3(1.6, 2.6, 0.6));
  model.AddBox(Vec3(0.0, -1.0, 1.65), Vec3(0.9, 0.6, 0.1)); // rack of the scanner
  model.AddRod(Vec3(0.0, -1.0, 1.65), Vec3(0.0, -1.0, 2.15), 0.05);
  for (const double x : { -0.8, 0.8 })
  {
    for (const double y : { -1.4, 1.4 })
    {
      model.AddRod(Vec3(x - 0.1, y, 0.35), Vec3(x + 0.1, y, 0.35), 0.35);
    }
  }
  return model.Get();
}

vtkSmartPointer<vtkPolyData> MakeTractor()
{
  Model model;
  model.AddBox(Vec3(0.0, 1.1, 1.1), Vec3(0.8, 2.2, 0.7));
  model.AddBox(Vec3(0.0, -0.6, 1.9), Vec3(1.4, 1.4, 1.6));
  model.AddBox(Vec3(0.0, -0.6, 0.9), Vec3(1.0, 1.6, 0.7));
  for (const double x : { -0.95, 0.95 })
  {
    model.AddRod(Vec3(x - 0.25, -0.8, 0.85), Vec3(x + 0.25, -0.8, 0.85), 0.85);
    model.AddRod(Vec3(x - 0.18, 1.6, 0.5), Vec3(x + 0.18, 1.6, 0.5), 0.5);
  }
  return model.Get();
}

/// A person with a backpack, from which a rod bears the scanner.
vtkSmartPointer<vtkPolyData> MakePerson()
{
  Model model;
  for (const double x : { -1.0, 1.0 })
  {
    model.AddRod(Vec3(0.14 * x, 0.1 * x, 0.0), Vec3(0.1 * x, 0.0, 0.85), 0.08);
    model.AddRod(Vec3(0.24 * x, 0.0, 1.4), Vec3(0.3 * x, -0.12 * x, 0.85), 0.05);
  }
  model.AddRod(Vec3(0.0, 0.0, 0.8), Vec3(0.0, 0.0, 1.45), 0.19);
  model.AddBall(Vec3(0.0, 0.02, 1.66), 0.13);
  model.AddBox(Vec3(0.0, -0.3, 1.2), Vec3(0.36, 0.22, 0.5));
  model.AddRod(Vec3(0.0, -0.3, 1.4), Vec3(0.0, -0.3, 2.0), 0.025);
  return model.Get();
}

vtkSmartPointer<vtkPolyData> MakeMulticopter()
{
  Model model;
  model.AddBox(Vec3(0.0, 0.0, 0.0), Vec3(0.3, 0.4, 0.12));
  for (const double angle : { 45.0, 135.0, 225.0, 315.0 })
  {
    const Vec3 arm = Rotate(AxisAngle({ 0.0, 0.0, 1.0 }, angle), Vec3(0.6, 0.0, 0.05));
    model.AddRod(Vec3(0.0, 0.0, 0.0), arm, 0.025);
    model.AddDisk(arm + Vec3(0.0, 0.0, 0.06), 0.3);
  }
  return model.Get();
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakePlatformModel(PlatformKind kind)
{
  switch (kind)
  {
    case PlatformKind::Tripod:
      return MakeTripod();
    case PlatformKind::Person:
      return MakePerson();
    case PlatformKind::Car:
      return MakeCar();
    case PlatformKind::Tractor:
      return MakeTractor();
    case PlatformKind::Multicopter:
      return MakeMulticopter();
    case PlatformKind::Aircraft:
      return MakeAircraft();
    case PlatformKind::Unknown:
      break;
  }
  Model ball;
  ball.AddBall(Vec3(0.0, 0.0, 0.0), 0.5);
  return ball.Get();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeScannerModel()
{
  Model model;
  model.AddRod(Vec3(0.0, 0.0, -0.16), Vec3(0.0, 0.0, 0.12), 0.09);
  model.AddRod(Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.13, 0.0), 0.05);
  return model.Get();
}

} // namespace helios::viewer
