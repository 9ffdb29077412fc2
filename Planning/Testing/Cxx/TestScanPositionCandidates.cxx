// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosScanPositionCandidates.h"

#include "heliosMaterialTable.h"
#include "heliosPlanningTest.h"
#include "heliosPyramidScene.h"
#include "heliosSceneCrs.h"
#include "vtkHeliosArrayNames.h"

#include <catch2/catch.hpp>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::MakeFloor;

namespace
{

using Candidates = helios::FilterOverScene<vtkHeliosScanPositionCandidates>;

/// A roof of 2 m x 2 m, 5 m above ground of 10 m x 10 m; cells 0 and 1 are the ground.
vtkSmartPointer<vtkPolyData> MakeCarport(bool groundIsMarked)
{
  auto scene = helios::MakeTriangles({ { -5, -5, 0 }, { 5, -5, 0 }, { 5, 5, 0 }, { -5, 5, 0 },
                                       { -1, -1, 5 }, { 1, -1, 5 }, { 1, 1, 5 }, { -1, 1, 5 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 } });
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  for (const int id : { 0, 0, 1, 1 })
  {
    ids->InsertNextValue(id);
  }
  scene->GetCellData()->AddArray(ids);
  helios::MaterialTable materials(2);
  materials[0].IsGround = groundIsMarked;
  helios::SetMaterials(scene, materials);
  return scene;
}

int CountAbove(vtkPolyData* points, double z)
{
  int count = 0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    count += points->GetPoint(i)[2] > z;
  }
  return count;
}

/// An outline of points in the plane z = 7.
vtkSmartPointer<vtkPolyData> MakeOutline(
  const std::vector<std::array<double, 2>>& places, bool isLine)
{
  std::vector<std::array<double, 3>> corners;
  vtkNew<vtkIdList> ids;
  for (const auto& p : places)
  {
    ids->InsertNextId(static_cast<vtkIdType>(corners.size()));
    corners.push_back({ p[0], p[1], 7.0 });
  }
  auto outline = helios::MakePoints(corners);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(ids);
  isLine ? outline->SetLines(cells) : outline->SetPolys(cells);
  return outline;
}

} // namespace

TEST_CASE("ScanPositionCandidates: the grid begins half a step inside the scene",
  "[ScanPositionCandidates]")
{
  Candidates candidates(MakeFloor(5.25, 3.0));
  vtkPolyData* output = candidates.Update();
  REQUIRE(output->GetNumberOfPoints() == 100);
  CHECK(output->GetPoint(0)[0] == -4.75);
  CHECK(output->GetPoint(0)[1] == -4.75);
  CHECK(output->GetPoint(0)[2] == 4.5);
  CHECK(output->GetPoint(1)[0] == -3.75); // rows of x
  CHECK(output->GetPoint(10)[1] == -3.75);
  CHECK(output->GetPointData()->GetArray(names::Slope)->GetTuple1(42) == 0.0);
  CHECK(output->GetPointData()->GetArray(names::Normal)->GetComponent(42, 2) == 1.0);
  CHECK(output->GetPointData()->GetArray(names::CellIds)->GetTuple1(0) == 0.0);
  SECTION("own steps, height and region")
  {
    candidates.Filter->SetYStep(3.0);
    candidates.Filter->SetScannerHeight(2.0);
    candidates.Filter->SetRegion(-0.5, 2.5, -3.0, 3.0);
    output = candidates.Update();
    REQUIRE(output->GetNumberOfPoints() == 6);
    CHECK(output->GetPoint(0)[0] == 0.0);
    CHECK(output->GetPoint(0)[1] == -1.5);
    CHECK(output->GetPoint(5)[0] == 2.0);
    CHECK(output->GetPoint(5)[1] == 1.5);
    CHECK(output->GetPoint(5)[2] == 5.0);
  }
  SECTION("a step larger than the scene gives one position at its centre")
  {
    candidates.Filter->SetStep(50.0);
    output = candidates.Update();
    REQUIRE(output->GetNumberOfPoints() == 1);
    CHECK(output->GetPoint(0)[0] == 0.0);
  }
  SECTION("no step given: a twentieth of the diagonal")
  {
    candidates.Filter->SetStep(0.0); // 0.05 * 10.5 * sqrt 2 = 0.7425: 14 positions
    CHECK(candidates.Update()->GetNumberOfPoints() == 14 * 14);
  }
}

TEST_CASE(
  "ScanPositionCandidates: keep the coordinate system of the scene", "[ScanPositionCandidates]")
{
  auto scene = MakeFloor(5.0, 0.0);
  helios::SetCRS(scene, "EPSG:32632");
  Candidates candidates(scene);
  CHECK(helios::GetCRS(candidates.Update()) == "EPSG:32632");
}

TEST_CASE(
  "ScanPositionCandidates: a slope equal to the limit is accepted", "[ScanPositionCandidates]")
{
  const double rise = std::tan(M_PI / 6.0); // 30 degrees
  Candidates candidates(helios::MakeTriangles(
    { { 0, 0, 0 }, { 10, 0, 10 * rise }, { 10, 10, 10 * rise }, { 0, 10, 0 } },
    { { 0, 2, 1 }, { 0, 2, 3 } })); // one triangle faces down: slopes ignore it
  candidates.Filter->SetMaximumSlope(30.0);
  vtkPolyData* output = candidates.Update();
  REQUIRE(output->GetNumberOfPoints() == 100);
  for (vtkIdType i = 0; i < 100; ++i)
  {
    CHECK(output->GetPointData()->GetArray(names::Slope)->GetTuple1(i) == Approx(30.0));
    CHECK(output->GetPointData()->GetArray(names::Normal)->GetComponent(i, 2) ==
      Approx(std::sqrt(0.75)));
  }
  candidates.Filter->SetMaximumSlope(29.9);
  CHECK(
    candidates.Fails("No candidate is left of 100 places: 0 have no surface below, at 0 the "
                     "highest surface is not ground, 100 are steeper than the maximum slope (29.9 "
                     "deg), 0 lie in excluded areas; allow a larger slope, or make the grid "
                     "finer."));
}

TEST_CASE(
  "ScanPositionCandidates: the steep sides of the pyramid are excluded", "[ScanPositionCandidates]")
{
  Candidates candidates(helios::MakePyramidScene());
  candidates.Filter->SetMaximumSlope(30.0);
  CHECK(candidates.Update()->GetNumberOfPoints() == 425); // 441 in all
}

TEST_CASE(
  "ScanPositionCandidates: lie on ground materials if there are any", "[ScanPositionCandidates]")
{
  Candidates marked(MakeCarport(true));
  CHECK(marked.Update()->GetNumberOfPoints() == 100);
  CHECK(CountAbove(marked.Update(), 2.0) == 0); // below the roof, too
  marked.Filter->SetSurfaceToHighest();
  CHECK(CountAbove(marked.Update(), 2.0) == 4);
  vtkDataArray* cells = marked.Update()->GetPointData()->GetArray(names::CellIds);
  CHECK(cells->GetTuple1(44) == 2.0);
  marked.Filter->SetSurfaceToOpenGround();
  CHECK(marked.Update()->GetNumberOfPoints() == 96);
  CHECK(CountAbove(marked.Update(), 2.0) == 0);
  marked.Filter->SetRegion(-1.0, 1.0, -1.0, 1.0);
  CHECK(marked.Fails("at 4 the highest surface is not ground, 0 are steeper than the maximum slope "
                     "(15 deg), 0 lie in excluded areas; use ground below other surfaces, too."));

  Candidates unmarked(MakeCarport(false));
  CHECK(CountAbove(unmarked.Update(), 2.0) == 0);
  unmarked.Filter->SetSurfaceToGround();
  CHECK(unmarked.Fails("Candidates are to be on the ground, but no material of the scene is ground "
                       "(Material.IsGround, "
                       "helios_isGround); mark the ground, or use the highest surface."));
}

TEST_CASE("ScanPositionCandidates: positions inside closed objects are dropped if there are others",
  "[ScanPositionCandidates]")
{
  // A box without floor, 2 m x 2 m and 5 m high, on ground of 10 m x 10 m, and alone.
  const std::vector<std::array<double, 3>> corners = { { -5, -5, 0 }, { 5, -5, 0 }, { 5, 5, 0 },
    { -5, 5, 0 }, { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 }, { -1, -1, 5 },
    { 1, -1, 5 }, { 1, 1, 5 }, { -1, 1, 5 } };
  std::vector<std::array<int, 3>> cells = { { 0, 1, 2 }, { 0, 2, 3 }, { 8, 9, 10 }, { 8, 10, 11 },
    { 4, 5, 9 }, { 4, 9, 8 }, { 5, 6, 10 }, { 5, 10, 9 }, { 6, 7, 11 }, { 6, 11, 10 } };
  const std::vector<std::array<int, 3>> door = { { 7, 4, 8 }, { 7, 8, 11 } };
  const auto addMaterials = [](vtkPolyData* scene)
  {
    vtkNew<vtkIntArray> ids;
    ids->SetName(names::MaterialIds);
    for (vtkIdType i = 0; i < scene->GetNumberOfCells(); ++i)
    {
      ids->InsertNextValue(i < 2 ? 0 : 1);
    }
    scene->GetCellData()->AddArray(ids);
    helios::MaterialTable materials(2);
    materials[0].IsGround = true;
    helios::SetMaterials(scene, materials);
    return scene;
  };
  auto open = helios::MakeTriangles(corners, cells);
  Candidates candidates(addMaterials(open));
  CHECK(candidates.Update()->GetNumberOfPoints() == 100); // one side is missing
  CHECK(candidates.Filter->GetNumberOfEnclosed() == 0);

  cells.insert(cells.end(), door.begin(), door.end());
  auto closed = helios::MakeTriangles(corners, cells);
  candidates.Filter->SetInputData(0, addMaterials(closed));
  CHECK(candidates.Update()->GetNumberOfPoints() == 96);
  CHECK(candidates.Filter->GetNumberOfEnclosed() == 4);
  candidates.Filter->SkipEnclosedOff();
  CHECK(candidates.Update()->GetNumberOfPoints() == 100);
  candidates.Filter->SkipEnclosedOn();
  candidates.Filter->SetRegion(-1.0, 1.0, -1.0, 1.0); // a hall: no open position
  CHECK(candidates.Update()->GetNumberOfPoints() == 4);
  CHECK(candidates.Filter->GetNumberOfEnclosed() == 0);
}

TEST_CASE(
  "ScanPositionCandidates: not on roofs where no material is ground, unless there are no others",
  "[ScanPositionCandidates]")
{
  Candidates candidates(MakeCarport(false));
  CHECK(candidates.Update()->GetNumberOfPoints() == 96);
  CHECK(candidates.Filter->GetNumberOnRoofs() == 4);
  candidates.Filter->SetSurfaceToHighest();
  CHECK(CountAbove(candidates.Update(), 2.0) == 4);
  CHECK(candidates.Filter->GetNumberOnRoofs() == 0);
  candidates.Filter->SetSurfaceToAutomatic();
  candidates.Filter->SetRegion(-1.0, 1.0, -1.0, 1.0);
  candidates.Update();
  CHECK(candidates.Log->HasWarning(
    "All of 4 places are 1.8 m or more above another surface, as on a roof, and "
    "are used; give helios_isGround true to the materials of the ground in the "
    ".mtl file."));
  CHECK(candidates.Filter->GetOutput()->GetNumberOfPoints() == 4);
  CHECK(candidates.Filter->GetNumberOnRoofs() == 0);
}

TEST_CASE("ScanPositionCandidates: given places replace the grid", "[ScanPositionCandidates]")
{
  Candidates candidates(MakeCarport(false));
  // On the ground, on the roof, below it, on it by its height, and beside the scene.
  candidates.Filter->SetInputData(2,
    helios::MakePoints(
      { { -3, 2, NAN }, { 0.5, 0.3, NAN }, { 0.5, 0.3, 0.0 }, { 0.5, 0.3, 5.5 }, { 70, 0, NAN } }));
  vtkPolyData* output = candidates.Update();
  REQUIRE(output->GetNumberOfPoints() == 3);
  CHECK(candidates.Filter->GetNumberOnRoofs() == 1);
  CHECK(output->GetPoint(0)[0] == -3.0);
  CHECK(output->GetPoint(0)[1] == 2.0);
  CHECK(output->GetPoint(0)[2] == 1.5);
  CHECK(output->GetPoint(1)[2] == 1.5);
  CHECK(output->GetPoint(2)[2] == 6.5);
  candidates.Filter->SetInputData(2, helios::MakePoints({ { 70, 0, NAN } }));
  CHECK(candidates.Fails("No candidate is left of 1 places: 1 have no surface below"));
  CHECK(candidates.Fails("move the places onto the scene, or give other places."));
  candidates.Filter->SetInputData(2, vtkNew<vtkPolyData>());
  CHECK(candidates.Fails("There is no place on port 2; give some."));
}

TEST_CASE("ScanPositionCandidates: none in an excluded area", "[ScanPositionCandidates]")
{
  Candidates candidates(MakeFloor(5.0, 0.0)); // positions at -4.5, -3.5 ... 4.5
  const bool isLine = GENERATE(false, true);
  SECTION("a square, border included")
  {
    const auto outline =
      MakeOutline({ { -0.5, -0.5 }, { 2.5, -0.5 }, { 2.5, 2.5 }, { -0.5, 2.5 } }, isLine);
    candidates.Filter->SetInputData(1, outline);
    CHECK(candidates.Update()->GetNumberOfPoints() == 100 - 16);
  }
  SECTION("a U open to the right: positions in its bay are kept")
  {
    const auto outline = MakeOutline(
      { { -2, -2 }, { 2, -2 }, { 2, -1 }, { -1, -1 }, { -1, 1 }, { 2, 1 }, { 2, 2 }, { -2, 2 } },
      isLine);
    candidates.Filter->SetInputData(1, outline);
    CHECK(candidates.Update()->GetNumberOfPoints() == 100 - (16 - 6));
  }
  SECTION("everything")
  {
    const auto outline = MakeOutline({ { -9, -9 }, { 9, -9 }, { 9, 9 }, { -9, 9 } }, isLine);
    candidates.Filter->SetInputData(1, outline);
    CHECK(candidates.Fails("100 lie in excluded areas; exclude less."));
  }
}

TEST_CASE("ScanPositionCandidates: bad input is an error", "[ScanPositionCandidates]")
{
  SECTION("an empty scene")
  {
    CHECK(Candidates(vtkNew<vtkPolyData>())
            .Fails("The scene on port 0 is empty; connect what is to be scanned."));
  }
  SECTION("corners that are not finite")
  {
    auto scene = MakeFloor(5.0, 0.0);
    scene->GetPoints()->SetPoint(1, NAN, 0.0, 0.0);
    CHECK(
      Candidates(scene).Fails("No rays can be cast onto the scene on port 0: cell 0 of the scene "
                              "has a corner that is not finite"));
  }
  Candidates candidates(MakeFloor(5.0, 0.0));
  SECTION("a region outside the scene")
  {
    candidates.Filter->SetRegion(20.0, 22.0, 0.0, 2.0);
    CHECK(candidates.Fails("No candidate is left of 4 places: 4 have no surface below, "));
    CHECK(candidates.Fails("move the region onto the scene, or make the grid finer."));
  }
  SECTION("a region upside down")
  {
    candidates.Filter->SetRegion(2.0, 1.0, 0.0, 2.0);
    CHECK(candidates.Fails("The region of candidates is x 2 to 1, y 0 to 2; the first of each must "
                           "not be above the second."));
  }
  SECTION("a grid too fine")
  {
    candidates.Filter->SetStep(1e-5);
    CHECK(candidates.Fails("1e+12 places need "));
    CHECK(
      candidates.Fails(" MiB, more than the memory limit (2048 MiB); make the grid of candidates "
                       "coarser."));
  }
  SECTION("abort")
  {
    helios::AbortAtProgress(candidates.Filter);
    CHECK(candidates.Fails("Aborted; update again for all candidates."));
  }
}
