// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of vegetation as cubes, compared with counts and volumes.
#include "heliosErrorObserver.h"
#include "heliosMaterialTable.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosMemoryLimit.h"
#include "vtkHeliosVoxelCubes.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace names = vtkHeliosArrayNames;

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkDoubleArray> MakeColumn(const char* name, const std::vector<double>& values)
{
  auto column = vtkSmartPointer<vtkDoubleArray>::New();
  column->SetName(name);
  for (const double value : values)
  {
    column->InsertNextValue(value);
  }
  return column;
}

/// A grid of nx by ny by nz cells of half a metre at 10 20 30.
vtkSmartPointer<vtkImageData> MakeGrid(int nx, int ny, int nz, const std::vector<double>& pads,
  const std::vector<double>& transmittances = {})
{
  auto grid = vtkSmartPointer<vtkImageData>::New();
  grid->SetDimensions(nx + 1, ny + 1, nz + 1);
  grid->SetSpacing(0.5, 0.5, 0.5);
  grid->SetOrigin(10, 20, 30);
  grid->GetCellData()->AddArray(MakeColumn(names::PAD, pads));
  if (!transmittances.empty())
  {
    grid->GetCellData()->AddArray(MakeColumn(names::Transmittance, transmittances));
  }
  return grid;
}

/// Six times the volume within the triangles, by the divergence theorem.
double GetVolume(vtkPolyData* scene)
{
  double sum = 0.0;
  double c[6];
  scene->GetBounds(c);
  for (vtkIdType i = 0; i < scene->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> ids;
    scene->GetCellPoints(i, ids);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      scene->GetPoint(ids->GetId(k), p[k]);
      p[k][0] -= c[0];
      p[k][1] -= c[2];
      p[k][2] -= c[4];
    }
    sum += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
      p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
      p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  }
  return sum / 6.0;
}

struct Run
{
  vtkNew<vtkHeliosVoxelCubes> Filter;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  explicit Run(vtkImageData* grid)
  {
    this->Log->Watch(this->Filter);
    this->Log->Watch(this->Filter->GetExecutive());
    this->Filter->SetInputData(grid);
  }

  vtkPolyData* Update()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
};

} // namespace

TEST_CASE("VoxelCubes: fixed cubes have no faces between them", "[VoxelCubes]")
{
  Run run(MakeGrid(3, 3, 3, std::vector<double>(27, 1.0)));
  vtkPolyData* scene = run.Update();
  CHECK(run.Filter->GetNumberOfCubes() == 27);
  CHECK(scene->GetNumberOfCells() == 6 * 9 * 2); // 6 N^2 faces
  CHECK(GetVolume(scene) == Approx(27 * 0.125));
  const double bounds[6] = { 10, 11.5, 20, 21.5, 30, 31.5 };
  for (int i = 0; i < 6; ++i)
  {
    CHECK(scene->GetBounds()[i] == bounds[i]);
  }
  CHECK(scene->GetPoints()->GetDataType() == VTK_DOUBLE);
}

TEST_CASE("VoxelCubes: selection of opaque voxels", "[VoxelCubes]")
{
  const std::vector<double> pads = { 1.0, 0.0, NaN, 2.0, NaN, 1.0, 1.0 };
  const auto count = [](vtkImageData* grid, bool isScaled)
  {
    Run run(grid);
    run.Filter->SetMode(isScaled ? vtkHeliosVoxelCubes::SCALED : vtkHeliosVoxelCubes::FIXED);
    run.Update();
    return run.Filter->GetNumberOfCubes();
  };
  // Without a transmittance: cells with leaves.
  CHECK(count(MakeGrid(7, 1, 1, pads), false) == 4);
  CHECK(count(MakeGrid(7, 1, 1, pads), true) == 4);
  // With one: cells below 1, of any density; scaled cubes also need a size.
  const auto grid = MakeGrid(7, 1, 1, pads, { 0.5, 0.9, NaN, 1.0, 0.0, NaN, 0.0 });
  CHECK(count(grid, false) == 4);
  CHECK(count(grid, true) == 2);
}

TEST_CASE("VoxelCubes: scaled cubes have the given fraction of the edge", "[VoxelCubes]")
{
  Run run(MakeGrid(2, 2, 1, { 4.0, 1.0, 0.25, 0.0 }));
  run.Filter->SetModeToScaled();
  vtkPolyData* scene = run.Update();
  CHECK(run.Filter->GetNumberOfCubes() == 3);
  REQUIRE(scene->GetNumberOfCells() == 36);
  CHECK(GetVolume(scene) == Approx(0.125 * (1.0 + std::pow(0.5, 3) + std::pow(0.25, 3))));
  // The second cube is centred in its cell.
  CHECK(scene->GetPoint(8)[0] == Approx(10.5 + 0.125));
  CHECK(scene->GetPoint(8)[1] == Approx(20.125));
  run.Filter->SetExponent(1.0 / 3.0);
  CHECK(GetVolume(run.Update()) == Approx(0.125 * (1.0 + 0.25 + 0.0625)));
  run.Filter->SetExponent(0.0);
  CHECK(GetVolume(run.Update()) == Approx(0.125 * 3));
  SECTION("of a given largest density, and never beyond the cell")
  {
    const auto grid = MakeGrid(2, 2, 1, { 4.0, 1.0, 0.25, 0.0 });
    grid->GetFieldData()->AddArray(MakeColumn(names::MaximumPAD, { 1.0 }));
    run.Filter->SetInputData(grid);
    run.Filter->SetExponent(1.0);
    CHECK(GetVolume(run.Update()) == Approx(0.125 * (1.0 + 1.0 + std::pow(0.25, 3))));
  }
}

TEST_CASE("VoxelCubes: shifted cubes stay in their voxels, by the seed", "[VoxelCubes]")
{
  std::vector<double> pads(1000, 0.25);
  pads[0] = 1.0;
  Run run(MakeGrid(10, 10, 10, pads));
  run.Filter->SetModeToScaled();
  run.Filter->RandomShiftOn();
  vtkPolyData* scene = run.Update();
  REQUIRE(scene->GetNumberOfPoints() == 8000);
  double sum[3] = { 0, 0, 0 };
  for (vtkIdType cell = 1; cell < 1000; ++cell)
  {
    const double low[3] = { 10 + 0.5 * static_cast<double>(cell % 10),
      20 + 0.5 * static_cast<double>(cell / 10 % 10), 30 + 0.5 * static_cast<double>(cell / 100) };
    for (vtkIdType corner = 8 * cell; corner < 8 * cell + 8; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const double at = scene->GetPoint(corner)[axis] - low[axis];
        REQUIRE((at >= -1e-12 && at <= 0.5 + 1e-12));
        sum[axis] += at / (999 * 8);
      }
    }
  }
  for (const double mean : sum) // 0.25 with the standard deviation 0.25 / sqrt(12 * 999)
  {
    CHECK(mean == Approx(0.25).margin(4 * 0.25 / std::sqrt(12.0 * 999)));
  }
  CHECK(GetVolume(scene) == Approx(0.125 * (1.0 + 999 * 0.125)));
  const double before = scene->GetPoint(80)[0];
  run.Filter->Modified();
  CHECK(run.Update()->GetPoint(80)[0] == before);
  run.Filter->SetSeed(1);
  CHECK(run.Update()->GetPoint(80)[0] != before);
}

TEST_CASE("VoxelCubes: materials in turn", "[VoxelCubes]")
{
  for (const bool isScaled : { false, true })
  {
    Run run(MakeGrid(5, 1, 1, { 1, 0, 1, 0, 1 }));
    run.Filter->SetMode(isScaled ? vtkHeliosVoxelCubes::SCALED : vtkHeliosVoxelCubes::FIXED);
    run.Filter->SetNumberOfMaterials(3);
    vtkPolyData* scene = run.Update();
    auto* ids = vtkIntArray::SafeDownCast(scene->GetCellData()->GetArray(names::MaterialIds));
    REQUIRE(ids);
    REQUIRE(ids->GetNumberOfValues() == 36);
    CHECK(ids->GetValue(0) == 0);
    CHECK(ids->GetValue(12) == 2);
    CHECK(ids->GetValue(35) == 1);
    CHECK(helios::GetMaterials(scene).size() == 3);
  }
}

TEST_CASE("VoxelCubes: errors", "[VoxelCubes]")
{
  const auto grid = MakeGrid(2, 1, 1, { 1, 1 });
  Run run(grid);
  run.Filter->SetMaximumNumberOfCubes(1);
  run.Update();
  CHECK(run.Log->HasError("2 opaque cells"));
  CHECK(run.Log->HasError("MaximumNumberOfCubes (1)"));
  run.Filter->SetMaximumNumberOfCubes(2);
  vtkHeliosMemoryLimit::SetLimit(0.001);
  run.Update();
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK(run.Log->HasError("2 cubes of twelve triangles need about 0.0018 MB of memory"));
  grid->GetCellData()->Initialize();
  run.Update();
  CHECK(run.Log->HasError("has no cell array PAD"));
}
