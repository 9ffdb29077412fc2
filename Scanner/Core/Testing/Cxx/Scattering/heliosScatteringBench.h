// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes in which light is scattered, and sums over pulses of one ray.

#ifndef heliosScatteringBench_h
#define heliosScatteringBench_h

#include "heliosMaterialTable.h"
#include "heliosScannerBench.h"
#include "heliosScatteredLight.h"
#include "vtkHeliosBeamRayCaster.h"

#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <vector>

namespace helios
{
namespace testing
{

constexpr double Pi = 3.14159265358979323846;

/// Sets one material of a scene.
inline void SetMaterial(vtkDataObject* scene, double reflectance)
{
  helios::Material material;
  material.Reflectance = reflectance;
  helios::SetMaterials(scene, { material });
}

/// A sphere about the origin, whose triangles have its area within 0.1 %.
inline vtkSmartPointer<vtkPolyData> MakeSphere(double radius, double reflectance)
{
  constexpr int rings = 120, turns = 240;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (int i = 0; i <= rings; ++i)
  {
    const double angle = Pi * i / rings;
    for (int k = 0; k < turns; ++k)
    {
      const double azimuth = 2.0 * Pi * k / turns;
      points->InsertNextPoint(radius * std::sin(angle) * std::cos(azimuth),
        radius * std::sin(angle) * std::sin(azimuth), radius * std::cos(angle));
      if (i > 0)
      {
        const vtkIdType row = i * turns, above = row - turns, next = (k + 1) % turns;
        polys->InsertNextCell({ above + k, row + k, row + next });
        polys->InsertNextCell({ above + k, row + next, above + next });
      }
    }
  }
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->SetPoints(points);
  sphere->SetPolys(polys);
  SetMaterial(sphere, reflectance);
  return sphere;
}

/// A box of voxels of one density and reflectance.
inline vtkSmartPointer<vtkImageData> MakeBox(
  const Vec3& corner, double cell, const int cells[3], double density, double reflectance)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  image->SetSpacing(cell, cell, cell);
  image->SetOrigin(corner[0], corner[1], corner[2]);
  vtkNew<vtkDoubleArray> pad;
  pad->SetName(vtkHeliosArrayNames::PAD);
  pad->SetNumberOfValues(image->GetNumberOfCells());
  pad->FillValue(density);
  image->GetCellData()->AddArray(pad);
  SetMaterial(image, reflectance);
  return image;
}

/// The light of pulses along one ray, as sums over all of them.
struct LightBench
{
  vtkNew<vtkHeliosBeamRayCaster> Caster;
  SceneSurfaces Surfaces;
  TurbidMedium Medium;
  ScatteringSettings Settings;
  bool HasSurfaces = false;

  LightBench()
  {
    this->Settings.Orders = 2;
    this->Settings.Paths = 64;
    this->Settings.HalfFieldOfView = Pi;
    this->Settings.Power = 1.0;
    this->Settings.MaximumRange = 1e9;
    this->Settings.Step = 0.01;
    this->Settings.Seed = 7;
  }

  void SetScene(vtkPolyData* scene)
  {
    this->HasSurfaces = scene->GetNumberOfCells() > 0;
    REQUIRE((!this->HasSurfaces || this->Caster->Build(scene)));
    REQUIRE(this->Surfaces.Set(scene).IsOk());
  }

  void AddGrid(vtkImageData* grid)
  {
    vtkIdType first = 0;
    REQUIRE(this->Surfaces.AddGrid(grid, first).IsOk());
    REQUIRE(this->Medium.Add(grid, first).IsOk());
  }

  /// Returns a factor of the lidar equation: the power of a white surface at a range.
  double GetWhite(double range) const { return this->Settings.Equation.GetGain(range, 1.0); }

  struct Result
  {
    double Power = 0.0;  // mean of the pulses
    double Error = 0.0;  // standard error of the mean, as stated
    double Spread = 0.0; // the same, from the differences between pulses
    double Range = 0.0;  // mean
  };

  Result Run(const Vec3& receiver, const Vec3& axis, int pulses)
  {
    ScatteredLight light(this->Settings,
      { this->HasSurfaces ? this->Caster.Get() : nullptr, this->Surfaces, this->Medium,
        this->Settings.IsIsotropic, this->Settings.MaximumEvents });
    vtkHeliosRay ray;
    std::copy_n(receiver.GetData(), 3, ray.Origin);
    std::copy_n(axis.GetData(), 3, ray.Direction);
    const std::vector<vtkHeliosRay> rays{ ray };
    light.SetWeights({ 1.0 });
    Result sum;
    double squares = 0.0;
    for (vtkIdType id = 0; id < pulses; ++id)
    {
      light.Sample({ id, receiver, axis, rays });
      const ScatteredPower each = light.GetProfile().GetPower(0.0, 1e9, [](double) { return 1.0; });
      sum.Power += each.Power;
      sum.Error += each.Error * each.Error;
      squares += each.Power * each.Power;
      sum.Range += light.GetProfile().GetPower(0.0, 1e9, [](double range) { return range; }).Power;
    }
    const double n = pulses;
    sum.Range /= sum.Power;
    sum.Power /= n;
    sum.Error = std::sqrt(sum.Error) / n;
    sum.Spread = std::sqrt((squares / n - sum.Power * sum.Power) / (n - 1.0));
    return sum;
  }
};

/// Checks a result against a truth, within 4 standard errors that are at most a share of it.
inline void CheckTruth(
  const LightBench::Result& result, double truth, double share, double bias = 0.0)
{
  INFO(result.Power / truth << " of the truth, standard error " << result.Error / truth
                            << ", spread " << result.Spread / truth);
  CHECK(std::abs(result.Power - truth) < 4.0 * result.Error + bias * truth);
  CHECK(result.Error < share * truth);
  CHECK(result.Error == Approx(result.Spread).epsilon(0.25));
}

} // namespace testing
} // namespace helios

#endif
