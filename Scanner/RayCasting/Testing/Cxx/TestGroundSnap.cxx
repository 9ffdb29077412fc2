// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGroundSnap.h"

#include "heliosErrorObserver.h"
#include "heliosMaterialTable.h"
#include "heliosRayCastingScenes.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace
{

namespace names = vtkHeliosArrayNames;

/// A slope z = x / 10 over [0, 100]^2, and a roof at 20 over [40, 60]^2.
vtkSmartPointer<vtkPolyData> MakeSlopeAndRoof(bool slopeIsGround)
{
  helios::Soup soup;
  soup.AddTriangle({ 0, 0, 0 }, { 100, 0, 10 }, { 100, 100, 10 });
  soup.AddTriangle({ 0, 0, 0 }, { 100, 100, 10 }, { 0, 100, 0 });
  soup.AddTriangle({ 40, 40, 20 }, { 60, 40, 20 }, { 60, 60, 20 });
  soup.AddTriangle({ 40, 40, 20 }, { 60, 60, 20 }, { 40, 60, 20 });
  const auto scene = soup.GetPolyData();
  helios::MaterialTable materials(2);
  materials[0].IsGround = slopeIsGround;
  helios::SetMaterials(scene, materials);
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  for (int id : { 0, 0, 1, 1 })
  {
    ids->InsertNextValue(id);
  }
  scene->GetCellData()->AddArray(ids);
  return scene;
}

vtkSmartPointer<vtkPolyData> MakePoints(std::initializer_list<helios::Vec3> positions)
{
  vtkNew<vtkPoints> points; // float, as VTK makes them
  for (const helios::Vec3& p : positions)
  {
    points->InsertNextPoint(p.GetData());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

} // namespace

TEST_CASE("GroundSnap: onto the highest ground", "[GroundSnap]")
{
  for (bool slopeIsGround : { true, false })
  {
    vtkNew<vtkHeliosGroundSnap> snap;
    snap->SetInputData(0, MakePoints({ { 50, 50, -7 }, { 10, 0, 99 }, { 80, 20, 3 } }));
    snap->SetInputData(1, MakeSlopeAndRoof(slopeIsGround));
    snap->SetHeightAboveGround(1.5);
    snap->Update();
    vtkPolyData* result = snap->GetOutput();
    REQUIRE(result->GetNumberOfPoints() == 3);
    CHECK(result->GetPoints()->GetDataType() == VTK_DOUBLE);
    // Without a ground material everything is ground, also the roof.
    CHECK(result->GetPoint(0)[2] == Approx(slopeIsGround ? 6.5 : 21.5).epsilon(1e-14));
    CHECK(result->GetPoint(1)[2] == Approx(2.5).epsilon(1e-14));
    CHECK(result->GetPoint(2)[2] == Approx(9.5).epsilon(1e-14));
    CHECK(result->GetPoint(0)[0] == 50.0);
  }
}

TEST_CASE("GroundSnap: moves only points with OnGround", "[GroundSnap]")
{
  const auto points = MakePoints({ { 10, 10, 5 }, { 10, 10, 5 }, { -10, 10, 5 } });
  vtkNew<vtkIntArray> onGround;
  onGround->SetName(names::OnGround);
  for (int flag : { 1, 0, 0 })
  {
    onGround->InsertNextValue(flag);
  }
  points->GetPointData()->AddArray(onGround);
  vtkNew<vtkHeliosGroundSnap> snap;
  snap->SetInputData(0, points);
  snap->SetInputData(1, MakeSlopeAndRoof(true));
  snap->Update();
  CHECK(snap->GetOutput()->GetPoint(0)[2] == Approx(1.0).epsilon(1e-14));
  CHECK(snap->GetOutput()->GetPoint(1)[2] == 5.0);
  CHECK(snap->GetOutput()->GetPoint(2)[2] == 5.0);
  CHECK(snap->GetOutput()->GetPointData()->HasArray(names::OnGround));
}

TEST_CASE("GroundSnap: names the point without ground", "[GroundSnap]")
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkNew<vtkHeliosGroundSnap> snap;
  log->Watch(snap);
  snap->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, log);
  snap->SetInputData(0, MakePoints({ { 10, 10, 5 }, { -12.5, 1, 5 } }));
  snap->SetInputData(1, MakeSlopeAndRoof(true));
  snap->Update();
  CHECK(log->HasError("point 1 at x -12.5, y 1"));

  log->Clear();
  snap->SetInputData(0, MakePoints({ { 10, 10, 5 }, { 10, std::nan(""), 5 } }));
  snap->Update();
  CHECK(log->HasError("point 1 at x 10, y nan"));

  log->Clear();
  snap->SetInputData(0, MakePoints({ { 10, 10, 5 } }));
  snap->SetInputData(1, vtkSmartPointer<vtkPolyData>::New());
  snap->Update();
  CHECK(log->HasError("scene on port 1 is empty"));
}

TEST_CASE("GroundSnap: a point without ground stays with AllowMissing", "[GroundSnap]")
{
  vtkNew<vtkHeliosGroundSnap> snap;
  snap->SetInputData(0, MakePoints({ { 50, 20, 1 }, { -500, 0, 7 } }));
  snap->SetInputData(1, MakeSlopeAndRoof(true));
  snap->AllowMissingOn();
  snap->Update();
  vtkPolyData* output = snap->GetOutput();
  REQUIRE(output->GetNumberOfPoints() == 2);
  CHECK(output->GetPoint(0)[2] == Approx(5.0));
  CHECK(output->GetPoint(1)[2] == 7.0);
  vtkDataArray* found = output->GetPointData()->GetArray(names::OnGround);
  REQUIRE(found);
  CHECK(found->GetTuple1(0) == 1.0);
  CHECK(found->GetTuple1(1) == 0.0);
}

TEST_CASE("GroundSnap: a distant point does not reduce accuracy", "[GroundSnap]")
{
  const auto scene = MakeSlopeAndRoof(true);
  const double stray[3] = { 1e30, 1e30, 1e30 };
  const vtkIdType point = scene->GetPoints()->InsertNextPoint(stray);
  scene->GetPolys()->InsertNextCell({ point, point - 1, point - 2 });
  scene->GetCellData()->GetArray(names::MaterialIds)->InsertNextTuple1(0);
  vtkNew<vtkHeliosGroundSnap> snap;
  snap->SetInputData(0, MakePoints({ { 10, 10, 5 } }));
  snap->SetInputData(1, scene);
  snap->Update();
  CHECK(snap->GetOutput()->GetPoint(0)[2] == Approx(1.0).epsilon(1e-14));
}
