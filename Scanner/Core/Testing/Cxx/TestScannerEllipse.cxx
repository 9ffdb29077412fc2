// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scans with elliptical beams: their orientation, and adaptive sampling against sub-rays.
#include "heliosConstants.h"
#include "heliosPlaneEcho.h"
#include "heliosScannerBench.h"
#include "vtkHeliosConicMirror.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosErrorModel.h"
#include "vtkHeliosRotatingMirror.h"
#include "vtkHeliosSpinningChannels.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;

namespace
{

constexpr double W = 1e-3; // half angle of the major axis
constexpr double Ratio = 0.3;

void SetEllipse(vtkHeliosScanner* scanner, double angle)
{
  scanner->GetBeamSampler()->SetBeamDivergence(2.0 * W);
  scanner->GetBeamSampler()->SetDivergenceRatio(Ratio);
  scanner->GetBeamSampler()->SetMajorAxisAngle(angle);
}

/// An error model of half a degree towards x and z.
class Skewed : public vtkHeliosErrorModel
{
public:
  static Skewed* New() { VTK_STANDARD_NEW_BODY(Skewed); }
  vtkTypeMacro(Skewed, vtkHeliosErrorModel);
  bool MoveRay(double*, double direction[3]) const override
  {
    direction[0] += 0.009;
    direction[2] += 0.009;
    vtkMath::Normalize(direction);
    return true;
  }
};

/// A room about the origin.
vtkSmartPointer<vtkPolyData> MakeRoom()
{
  constexpr double h = 50.0;
  std::vector<Rectangle> walls;
  for (const double side : { -h, h })
  {
    walls.push_back({ { side, -h, -h }, { 0, 2 * h, 0 }, { 0, 0, 2 * h } });
    walls.push_back({ { -h, side, -h }, { 2 * h, 0, 0 }, { 0, 0, 2 * h } });
    walls.push_back({ { -h, -h, side }, { 2 * h, 0, 0 }, { 0, 2 * h, 0 } });
  }
  return MakeScene(walls);
}

/// The variances of the sub-rays of a pulse from the origin along two axes, and their covariance.
struct Spread
{
  double Major = 0.0, Minor = 0.0, Both = 0.0;
};
Spread GetSpread(vtkPolyData* hits, double pulse, const Vec3& axis, const Vec3& major)
{
  const Vec3 minor = major.Cross(axis);
  Spread spread;
  for (vtkIdType i = 0; i < hits->GetNumberOfPoints(); ++i)
  {
    if (Value(hits, names::PulseIds, i) == pulse)
    {
      const Vec3 p(hits->GetPoint(i));
      const double a = p.Dot(major) / p.Dot(axis);
      const double b = p.Dot(minor) / p.Dot(axis);
      const double weight = Value(hits, names::Weight, i);
      spread.Major += weight * a * a;
      spread.Minor += weight * b * b;
      spread.Both += weight * a * b;
    }
  }
  return spread;
}

/// The major axis of each pulse is in the plane of the beam and a cross axis, in the world.
void CheckOrientation(vtkHeliosScanner* scanner, const Vec3& cross)
{
  scanner->GetBeamSampler()->SetPatternToGaussLegendre();
  scanner->GetBeamSampler()->SetNumberOfRings(20);
  scanner->GeneratePulsesOn();
  scanner->GenerateSubRaysOn();
  scanner->Update();
  auto* pulses = vtkPolyData::SafeDownCast(scanner->GetOutputDataObject(2));
  auto* hits = vtkPolyData::SafeDownCast(scanner->GetOutputDataObject(3));
  const double s2 = helios::BeamMoments(2.0 * W, 1.5).Variance;
  REQUIRE(pulses->GetNumberOfPoints() > 10);
  for (vtkIdType i = 0; i < pulses->GetNumberOfPoints(); ++i)
  {
    const Vec3 axis(pulses->GetPointData()->GetArray(names::Direction)->GetTuple3(i));
    const Vec3 major = (cross - cross.Dot(axis) * axis).Normalized();
    const Spread spread = GetSpread(hits, Value(pulses, names::PulseIds, i), axis, major);
    CAPTURE(i, axis[0], axis[1], axis[2]);
    CHECK(spread.Major == Approx(s2).epsilon(1e-5));
    CHECK(spread.Minor == Approx(Ratio * Ratio * s2).epsilon(1e-5));
    CHECK(spread.Both == Approx(0.0).margin(1e-6 * s2));
  }
}

/// Adaptive sampling finds the echoes of many sub-rays.
void CheckAgainstSubRays(vtkPolyData* scene, double factor, double angle)
{
  Bench truth(scene);
  Bench bench(scene);
  for (Bench* b : { &truth, &bench })
  {
    SetEllipse(b->Scanner, angle);
    b->Scanner->GetBeamSampler()->SetBeamQualityFactor(factor);
    b->Tripod->SetHeading(3); // off diagonals
    b->Scanner->SetDuration(3e-5);
  }
  truth.Scanner->GetBeamSampler()->SetPatternToVogel();
  truth.Scanner->GetBeamSampler()->SetNumberOfSubRays(16384);
  truth.Scanner->SetBinSize(0.05);
  bench.Scanner->SetSamplingToTolerance();
  vtkPolyData* right = truth.Run();
  vtkPolyData* echoes = bench.Run();
  CAPTURE(
    factor, angle, bench.Scanner->GetCount("pulsesOnPlane"), bench.Scanner->GetCount("subRays"));
  REQUIRE(right->GetNumberOfPoints() >= 3);
  REQUIRE(echoes->GetNumberOfPoints() == right->GetNumberOfPoints());
  double full = 0.0;
  for (vtkIdType i = 0; i < right->GetNumberOfPoints(); ++i)
  {
    full = std::max(full, Value(right, names::Amplitude, i));
  }
  for (vtkIdType i = 0; i < right->GetNumberOfPoints(); ++i)
  {
    CHECK(Value(echoes, names::Range, i) ==
      Approx(Value(right, names::Range, i)).epsilon(0).margin(1e-3));
    CHECK(Value(echoes, names::Amplitude, i) ==
      Approx(Value(right, names::Amplitude, i)).epsilon(0).margin(0.01 * full));
    CHECK(Value(echoes, names::EchoWidth, i) ==
      Approx(Value(right, names::EchoWidth, i)).epsilon(1e-2));
  }
}

} // namespace

TEST_CASE("Ellipse: a mirror keeps the major axis across its lines", "[Ellipse]")
{
  Bench bench(MakeRoom());
  SetEllipse(bench.Scanner, 0.0);
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetMirrorAngle(80);
  mirror->SetPulseFrequency(2000);
  bench.Scanner->SetBeamDeflector(mirror);
  bench.Tripod->SetHeading(20); // turns x 20 degrees clockwise
  const double heading = vtkMath::RadiansFromDegrees(20.0);
  CheckOrientation(bench.Scanner, { std::cos(heading), -std::sin(heading), 0 });
}

TEST_CASE("Ellipse: a spinning head keeps the major axis upright", "[Ellipse]")
{
  Bench bench(MakeRoom());
  SetEllipse(bench.Scanner, 0.0);
  vtkNew<vtkHeliosSpinningChannels> head;
  head->SetNumberOfChannels(3);
  head->SetElevation(0, -30);
  head->SetElevation(2, 50);
  head->SetScanFrequency(100);
  head->SetPulseFrequency(3000);
  bench.Scanner->SetBeamDeflector(head);
  CheckOrientation(bench.Scanner, { 0, 0, 1 });
}

TEST_CASE("Ellipse: errors of the direction turn the footprint little", "[Ellipse]")
{
  Bench bench(MakeRoom());
  SetEllipse(bench.Scanner, 90.0);
  vtkNew<vtkHeliosConicMirror> mirror;
  mirror->SetScanAngle(20);
  mirror->SetPulseFrequency(2000);
  bench.Scanner->SetBeamDeflector(mirror);
  bench.Scanner->SetAngleAccuracy(2e-5);
  vtkNew<Skewed> errors;
  const bool isSkewed = GENERATE(false, true);
  bench.Scanner->SetErrorModel(isSkewed ? errors.Get() : nullptr);
  bench.Scanner->GeneratePulsesOn();
  bench.Scanner->GenerateSubRaysOn();
  bench.Run();
  auto* pulses = vtkPolyData::SafeDownCast(bench.Scanner->GetOutputDataObject(2));
  auto* hits = vtkPolyData::SafeDownCast(bench.Scanner->GetOutputDataObject(3));
  for (vtkIdType i = 0; i < pulses->GetNumberOfPoints(); ++i)
  {
    // reported direction
    Vec3 axis(pulses->GetPointData()->GetArray(names::Direction)->GetTuple3(i));
    axis = (axis + (isSkewed ? 0.009 : 0.0) * Vec3(1, 0, 1)).Normalized();
    const Vec3 minor = (Vec3(1, 0, 0) - axis[0] * axis).Normalized();
    const Spread spread = GetSpread(hits, static_cast<double>(i), axis, axis.Cross(minor));
    CHECK(spread.Minor < 0.15 * spread.Major);
  }
}

TEST_CASE("Ellipse: the energy of an edge depends on the angle of the major axis", "[Ellipse]")
{
  constexpr double offset = 0.02;
  constexpr double range = 50.0;
  for (const double edge : { 0.0, 30.0, 90.0, 120.0 }) // heading of its normal, clockwise from x
  {
    const double turn = vtkMath::RadiansFromDegrees(edge);
    const Vec3 n(std::cos(turn), 0, -std::sin(turn));
    const Vec3 t(-n[2], 0, n[0]);
    const Vec3 corner = Vec3(0, range, 0) + offset * n - 30.2 * t;
    const auto scene = MakeScene({ { corner, 40.0 * n, 70.0 * t } });
    for (const bool isFixed : { false, true })
    {
      Bench bench(scene);
      SetEllipse(bench.Scanner, 30.0);
      bench.Scanner->GetBeamSampler()->SetTruncation(3.0);
      bench.Scanner->SetDuration(1e-5);
      if (isFixed)
      {
        bench.Scanner->GetBeamSampler()->SetPatternToVogel();
        bench.Scanner->GetBeamSampler()->SetNumberOfSubRays(65536);
      }
      else
      {
        bench.Scanner->SetSamplingToTolerance();
      }
      bench.Scanner->GetEchoDetector()->SetDetectionThreshold(0.0);
      vtkPolyData* echoes = bench.Run();
      REQUIRE(echoes->GetNumberOfPoints() == 1);
      const double power = Value(echoes, names::Amplitude, 0);
      Bench whole(MakeScene({ Wall(range) }));
      whole.Scanner->SetDuration(1e-5);
      const double full = Value(whole.Run(), names::Amplitude, 0);
      const double angle = turn - vtkMath::RadiansFromDegrees(30.0);
      const double w = range * W * std::hypot(std::cos(angle), Ratio * std::sin(angle));
      CAPTURE(edge, isFixed);
      CHECK(power / full == Approx(0.5 * std::erfc(std::sqrt(2.0) * offset / w)).margin(1e-3));
    }
  }
}

TEST_CASE("Ellipse: the echo of an inclined plane is widened by its axis", "[Ellipse]")
{
  const double s = std::sqrt(helios::BeamMoments(2.0 * W, 1.5).Variance);
  for (const double angle : { 0.0, 90.0, 40.0 })
  {
    // Inclined by 60 degrees, to z.
    const Vec3 slope(0, std::sqrt(0.75), 0.5);
    Bench bench(MakeScene({ { Vec3(-40.3, 100, 0) - 30.1 * slope, { 80, 0, 0 }, 60.0 * slope } }));
    SetEllipse(bench.Scanner, angle);
    bench.Scanner->SetSamplingToTolerance();
    bench.Scanner->SetDuration(1e-5);
    vtkPolyData* echoes = bench.Run();
    REQUIRE(echoes->GetNumberOfPoints() == 1);
    CHECK(bench.Scanner->GetCount("pulsesOnPlane") == 1);
    const double turn = vtkMath::RadiansFromDegrees(angle);
    const double own = s * std::hypot(std::sin(turn), Ratio * std::cos(turn));
    const double rise = 2.0 * 100.0 * own * std::sqrt(3.0) / helios::SpeedOfLight;
    const double sigma = 4.0 / helios::FwhmPerSigma;
    CHECK(Value(echoes, names::EchoWidth, 0) ==
      Approx(helios::FwhmPerSigma * std::hypot(sigma, rise)).epsilon(1e-5));
  }
}

TEST_CASE("Ellipse: adaptive sampling has the echoes of sub-rays", "[Ellipse]")
{
  const double factor = GENERATE(0.0, 20.0);
  const double angle = GENERATE(0.0, 25.0, 90.0);
  SECTION("on a plane")
  {
    CheckAgainstSubRays(
      MakeScene({ { { -20, 40, -50 }, { 40, 40, 0 }, { 0, 15, 90 } } }), factor, angle);
  }
  SECTION("on a ridge, a layer of two planes")
  {
    constexpr double edge = 1.0 / 1024;
    CheckAgainstSubRays(MakeScene({ { { -90, 150, edge - 50 }, { 200, 0, 0 }, { 0, 50, 50 } },
                          { { -90, 200, edge }, { 200, 0, 0 }, { 0, 52, 50 } } }),
      factor, angle);
  }
  SECTION("on steps and wires")
  {
    CheckAgainstSubRays(MakeScene({ Wall(60), { { -50, 50, 0.011 }, { 100, 0, 0 }, { 0, 0, 50 } },
                          { { 0.012, 47, -10 }, { 0.015, 0, 0 }, { 0, 0, 20 } },
                          { { -9, 44, -0.02 }, { 18, 0, 0 }, { 0, 0.2, 0.01 } } }),
      factor, angle);
  }
  SECTION("on too many slats to divide, or to collect")
  {
    const int count = GENERATE(2000, 80000);
    std::vector<Rectangle> slats = { Wall(60) };
    for (int i = -count / 2; i < count / 2; ++i)
    {
      const double step = 0.12 / count;
      slats.push_back(
        { { step * i - 2.62, 50 + 0.001 * (i % 2), 0.004 }, { step, 0, 0 }, { 0, 0, 1 } });
    }
    CheckAgainstSubRays(MakeScene(slats), factor, angle);
  }
}

TEST_CASE("Ellipse: a circular beam has no axes", "[Ellipse]")
{
  const auto scene = MakeScene({ Wall(60), { { -50, 50, 0.001 }, { 100, 0, 0 }, { 0, 0, 50 } } });
  Bench plain(scene);
  Bench turned(scene);
  turned.Scanner->GetBeamSampler()->SetMajorAxisAngle(50);
  for (Bench* bench : { &plain, &turned })
  {
    bench->Scanner->SetSamplingToTolerance();
    bench->Scanner->SetAngleAccuracy(1e-4);
  }
  const std::string bytes = Bytes(plain.Run());
  CHECK(plain.Scanner->GetOutput()->GetNumberOfPoints() > 1000);
  CHECK(Bytes(turned.Run()) == bytes);
}

TEST_CASE("Ellipse: a minor axis that is too thin is an error", "[Ellipse]")
{
  Bench bench(MakeScene({ Wall(60) }));
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(1e-8);
  bench.Scanner->GetBeamSampler()->SetDivergenceRatio(0.05);
  bench.Run();
  CHECK(
    bench.Log->HasError("DivergenceRatio 0.05 and BeamDivergence 1e-08 rad make a divergence of "
                        "5e-10 rad along the minor axis; give at least 1e-09 rad, or "
                        "DivergenceRatio 1 for a circular beam"));
}
