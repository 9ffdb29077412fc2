// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Single pulses of the scanner into extreme scenes.

#ifndef heliosExtremeShots_h
#define heliosExtremeShots_h

#include "heliosExtremeTruth.h"
#include "heliosScannerBench.h"
#include "vtkHeliosEchoDetector.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace helios
{
namespace testing
{

/// Local, UTM and geocentric coordinates.
const Vec3 Places[3] = { { 0, 0, 0 }, { 5e5, 5.5e6, 300 }, { 4e6, 6e5, 4.9e6 } };

constexpr double HalfUlp = 0x1p-53; // u

/// Triangles, built one by one.
struct Triangles
{
  std::vector<std::array<Vec3, 3>> All;

  void Add(const Vec3& a, const Vec3& b, const Vec3& c) { this->All.push_back({ a, b, c }); }
  void AddQuad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
  {
    this->Add(a, b, c);
    this->Add(a, c, d);
  }
  /// A rectangle across the y axis.
  void AddWall(double y, double left, double right, double low, double high)
  {
    this->AddQuad({ left, y, low }, { right, y, low }, { right, y, high }, { left, y, high });
  }
  /// A disc across the y axis, as a regular polygon of the same area.
  void AddDisc(const Vec3& centre, double radius, int sides)
  {
    const double step = 2 * std::acos(-1.0) / sides;
    const double reach = radius * std::sqrt(step / std::sin(step));
    const auto rim = [&](int i)
    { return centre + reach * Vec3(std::cos(i * step), 0, std::sin(i * step)); };
    for (int i = 0; i < sides; ++i)
    {
      this->Add(centre, rim(i), rim(i + 1 < sides ? i + 1 : 0));
    }
  }

  vtkSmartPointer<vtkPolyData> GetScene(const Vec3& offset = { 0, 0, 0 }) const
  {
    auto scene = MakeScene({});
    for (const auto& triangle : this->All)
    {
      vtkIdType ids[3];
      for (int i = 0; i < 3; ++i)
      {
        const Vec3 p = triangle[i] + offset;
        ids[i] = scene->GetPoints()->InsertNextPoint(p.GetData());
      }
      scene->GetPolys()->InsertNextCell(3, ids);
    }
    return scene;
  }
};

/// All pulses in one direction.
class OneDirection : public vtkHeliosBeamDeflector
{
public:
  static OneDirection* New() { VTK_STANDARD_NEW_BODY(OneDirection); }
  vtkTypeMacro(OneDirection, vtkHeliosBeamDeflector);
  bool GetDirection(vtkIdType, double direction[3]) const override
  {
    std::copy_n(this->Direction.GetData(), 3, direction);
    return true;
  }
  Vec3 Direction{ 0, 1, 0 };
};

/// The ways to sample a beam.
enum class Way
{
  Adaptive, ///< with the default tolerances
  Spiral,   ///< 4096 fixed sub-rays
  Circles,  ///< 19 fixed sub-rays
  OneRay
};

struct ShotEcho
{
  double Range, Amplitude;
  vtkIdType Cell;
};

/// One pulse of 1 W in vacuum, D = 0.15 m, eta = 1, no threshold; reflectance 0.5.
struct Shot : Bench
{
  vtkNew<OneDirection> Aim;

  explicit Shot(
    vtkPolyData* scene, const Vec3& origin = { 0, 0, 0 }, const Vec3& direction = { 0, 1, 0 })
    : Bench(scene, origin)
  {
    this->Aim->Direction = direction;
    this->Scanner->SetBeamDeflector(this->Aim);
    this->Scanner->SetDuration(1e-5);
    this->Scanner->SetAveragePower(1.0);
    this->Scanner->SetOpticalEfficiency(1.0);
    this->Scanner->SetAtmosphericExtinction(0.0);
    this->Scanner->GetEchoDetector()->SetDetectionThreshold(0.0);
    this->SetWay(Way::Adaptive);
  }

  void SetWay(Way way)
  {
    vtkHeliosBeamSampler* sampler = this->Scanner->GetBeamSampler();
    this->Scanner->SetSampling(
      way == Way::Adaptive ? vtkHeliosScanner::TOLERANCE : vtkHeliosScanner::FIXED);
    if (way == Way::Spiral)
    {
      sampler->SetPatternToVogel();
      sampler->SetNumberOfSubRays(4096);
    }
    if (way == Way::OneRay)
    {
      sampler->SetBeamDivergence(0.0);
    }
  }

  std::vector<ShotEcho> Fire()
  {
    vtkPolyData* cloud = this->Run();
    std::vector<ShotEcho> echoes;
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      echoes.push_back({ Value(cloud, vtkHeliosArrayNames::Range, i),
        Value(cloud, vtkHeliosArrayNames::Amplitude, i),
        static_cast<vtkIdType>(Value(cloud, vtkHeliosArrayNames::CellIds, i)) });
    }
    CAPTURE(this->Log->Errors);
    CHECK(this->Log->Errors.empty());
    return echoes;
  }
};

} // namespace testing
} // namespace helios

#endif
