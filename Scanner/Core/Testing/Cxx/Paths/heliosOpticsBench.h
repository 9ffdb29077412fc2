// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with mirrors, glass and water before a scanner.

#ifndef heliosOpticsBench_h
#define heliosOpticsBench_h

#include "heliosMaterialTable.h"
#include "heliosRadiometry.h"
#include "heliosScannerBench.h"

#include <vtkCellData.h>
#include <vtkIntArray.h>

#include <cmath>
#include <limits>
#include <vector>

namespace helios
{
namespace testing
{

constexpr double Rounding = 8.0 * std::numeric_limits<double>::epsilon();

inline Material MakeMaterial(OpticsKind kind)
{
  Material material;
  material.Optics.Kind = kind;
  return material;
}

/// Rectangles, the first ones of a material, the others of the default one.
inline vtkSmartPointer<vtkPolyData> MakeOpticalScene(const std::vector<Rectangle>& optical,
  const Material& material, const std::vector<Rectangle>& opaque)
{
  std::vector<Rectangle> all = optical;
  all.insert(all.end(), opaque.begin(), opaque.end());
  const auto scene = MakeScene(all);
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosArrayNames::MaterialIds);
  for (std::size_t i = 0; i < 2 * all.size(); ++i)
  {
    ids->InsertNextValue(i < 2 * optical.size() ? 1 : 0);
  }
  scene->GetCellData()->AddArray(ids);
  SetMaterials(scene, { Material(), material });
  return scene;
}

/// One ray a pulse, along y, without noise.
struct RayBench : Bench
{
  explicit RayBench(vtkPolyData* scene)
    : Bench(scene)
  {
    this->Scanner->GetBeamSampler()->SetBeamDivergence(0.0);
    this->Scanner->SetDuration(1e-5);
    this->Scanner->SetRangeAccuracy(0.0);
    this->Scanner->SetGenerateTruth(true);
  }

  /// The amplitude of a surface of reflectance 0.5 that fills the beam.
  double GetAmplitude(double range, double cosine = 1.0) const
  {
    const LidarEquation equation{ this->Scanner->GetReceiverDiameter(),
      this->Scanner->GetOpticalEfficiency(),
      AtmosphericExtinction(
        this->Scanner->GetAtmosphericVisibility(), this->Scanner->GetWavelength()) };
    return this->Scanner->GetAveragePower() * equation(range, 0.5, cosine);
  }
};

inline Vec3 GetTruth(vtkPolyData* cloud, vtkIdType row)
{
  return Vec3(cloud->GetPointData()->GetArray(vtkHeliosArrayNames::TruePoint)->GetTuple3(row));
}

/// A square across a direction, about a centre.
inline Rectangle Across(const Vec3& centre, const Vec3& normal, double half)
{
  Vec3 a = normal.Cross(std::abs(normal[2]) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0));
  a.Normalize();
  Vec3 b = normal.Cross(a);
  b.Normalize();
  return { centre - half * a - half * b, 2.0 * half * a, 2.0 * half * b };
}

} // namespace testing
} // namespace helios

#endif
