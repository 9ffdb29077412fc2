// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Amplitudes, optical depths, divergences, times and numbers of pulses at the extremes.
#include "heliosExtremeShots.h"

#include <vtkImageData.h>
#include <vtkMath.h>

#include <vtkCellData.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;

namespace
{

/// Walls across the y axis; the nearest covers the upper half of the beam.
vtkSmartPointer<vtkPolyData> MakeSteps(double near, double far)
{
  Triangles steps;
  steps.AddWall(near, -near, near, 0, near);
  steps.AddWall(far, -far, far, -far, far);
  return steps.GetScene();
}

} // namespace

TEST_CASE("Extremes: amplitudes over 600 decades, with fixed sampling over 60", "[Extremes]")
{
  double worst[2] = { 0.0, 0.0 };
  for (Way way : { Way::OneRay, Way::Adaptive, Way::Circles, Way::Spiral })
  {
    const bool isFloat = way == Way::Circles || way == Way::Spiral;
    for (double power : { 1e-290, 1e-100, 1e-50, 1e-30, 1e-20, 1e-10, 1.0, 1e12 })
    {
      Triangles wall;
      wall.AddWall(100, -50, 50, -50, 50);
      Shot shot(wall.GetScene());
      shot.SetWay(way);
      shot.Scanner->SetAveragePower(power);
      const auto echoes = shot.Fire();
      CAPTURE(power, isFloat);
      // Waveforms are float: samples below 1e-45 W are 0.
      REQUIRE(echoes.size() == (isFloat && power < 1e-35 ? 0 : 1));
      if (!echoes.empty())
      {
        const double error = std::abs(echoes[0].Amplitude / (power * GetFull(100)) - 1);
        worst[isFloat ? 1 : 0] = std::max(worst[isFloat ? 1 : 0], error);
        CHECK(std::abs(echoes[0].Range - 100) < 1e-5);
      }
    }
  }
  CHECK(worst[0] <= 1e-6); // error of energies
  CHECK(worst[1] <= 4e-7); // error of floats, and of the parabola through them
}

TEST_CASE("Extremes: surfaces at 1 mm and at 10,000 km in one beam, 20 decades apart", "[Extremes]")
{
  Shot shot(MakeSteps(1e-3, 1e7));
  const auto echoes = shot.Fire();
  REQUIRE(echoes.size() == 2);
  CHECK(std::abs(echoes[0].Range - 1e-3) < 1e-9);
  CHECK(std::abs(echoes[1].Range - 1e7) < 0.06); // R s^2: of the curvature
  CHECK(echoes[0].Amplitude / echoes[1].Amplitude == Approx(1e20).epsilon(0.03));
  CHECK(shot.Log->Warnings.empty());
}

TEST_CASE("Extremes: echoes farther apart than a waveform can be are kept by adaptive sampling",
  "[Extremes]")
{
  for (double far : { 19e3, 21e3, 39e3, 45e3, 1e6 })
  {
    for (bool isClose : { false, true }) // a third surface, to be binned with the first
    {
      Triangles walls;
      walls.AddWall(100, -50, 50, 0.0001, 50);
      walls.AddWall(far, -far, far, -far, far);
      if (isClose)
      {
        walls.AddWall(101, -50, 50, -0.001, 0.0001);
      }
      Shot shot(walls.GetScene());
      const auto echoes = shot.Fire();
      CAPTURE(far, isClose);
      REQUIRE(echoes.size() == (isClose ? 3 : 2));
      CHECK(std::abs(echoes.back().Range - far) < 1e-3 + 5.4e-9 * far); // R s^2
      CHECK(std::abs(echoes[0].Range - 100) < 1e-3);
      const double energy = GetStripEnergy(0.0001 / 0.015, 1.5);
      CHECK(echoes[0].Amplitude / GetFull(100) == Approx(energy).epsilon(2e-3));
      CHECK(shot.Log->Warnings.empty());

      shot.SetWay(Way::Circles); // which has the waveform of all
      const bool isCut = far > 40e3;
      CHECK(shot.Fire().size() == echoes.size() - (isCut ? 1 : 0));
      CHECK(
        shot.Log->HasWarning("1 waveforms were truncated: they exceed NumberOfBins, "
                             "MaximumWaveformLength or the longest that can be stored") == isCut);
    }
  }
}

TEST_CASE("Extremes: pulses of 0.01 ns to 1 ms, by float samples and without", "[Extremes]")
{
  double worst = 0.0;
  for (double length : { 0.01, 1.0, 4.0, 100.0, 1e3, 1e6 })
  {
    for (double perPulse : { 2.5, 16.0, 400.0 })
    {
      for (Way way : { Way::Adaptive, Way::Circles })
      {
        const double bin = length / perPulse;
        if (bin < 1e-4 || bin > 1e3)
        {
          continue;
        }
        Triangles wall;
        wall.AddWall(1e-3, -1, 1, -1, 1);
        Shot shot(wall.GetScene());
        shot.SetWay(way);
        shot.Scanner->SetPulseLength(length);
        shot.Scanner->SetBinSize(bin);
        const auto echoes = shot.Fire();
        CAPTURE(length, perPulse);
        REQUIRE(echoes.size() == 1);
        // Half an ulp of each of three samples moves the parabola's peak.
        const double sigma = length / 2.3548200450309493;
        const double bound = way == Way::Adaptive
          ? 1e-10
          : 0.5 * 0.299792458 * 4 * 0x1p-25 * sigma * sigma / bin + 1e-10;
        worst = std::max(worst, std::abs(echoes[0].Range - 1e-3) / bound);
      }
    }
  }
  CHECK(worst <= 1.0);
}

TEST_CASE("Extremes: a limit of the waveform cuts farther echoes", "[Extremes]")
{
  for (Way way : { Way::Adaptive, Way::Circles })
  {
    Shot shot(MakeSteps(100, 150));
    shot.SetWay(way);
    CHECK(shot.Fire().size() == 2);
    shot.Scanner->SetMaximumWaveformLength(100); // 15 m
    CHECK(shot.Fire().size() == 1);
  }
}

TEST_CASE("Extremes: the atmosphere at optical depths to 700", "[Extremes]")
{
  double worst[2] = { 0.0, 0.0 };
  for (double depth : { 0.0, 1e-12, 1.0, 50.0, 300.0, 700.0, 760.0 })
  {
    for (double range : { 1.37, 123.4, 98765.4 })
    {
      for (Way way : { Way::OneRay, Way::Adaptive, Way::Circles })
      {
        Triangles wall;
        wall.AddWall(range, -range, range, -range, range);
        Shot shot(wall.GetScene());
        shot.SetWay(way);
        shot.Scanner->SetAveragePower(1e12); // denormal numbers would have fewer digits
        shot.Scanner->SetAtmosphericExtinction(0.5 * depth / range);
        const auto echoes = shot.Fire();
        CAPTURE(depth, range, way == Way::OneRay);
        // exp(-745) is 0 in double; the samples of fixed sampling are float.
        const bool isSeen = way == Way::Circles ? depth < 60 : depth < 740;
        const bool isNone = way == Way::Circles ? depth > 100 : depth > 750;
        CHECK((isSeen || isNone));
        REQUIRE(echoes.size() == (isSeen ? 1 : 0));
        if (isSeen)
        {
          const double truth = 1e12 * GetFull(range) * std::exp(-depth);
          const double error = std::abs(echoes[0].Amplitude / truth - 1);
          double& most = worst[way == Way::OneRay ? 0 : 1];
          const double bound = way == Way::OneRay ? HalfUlp * (4 + 2 * depth) : 5e-6 * (1 + depth);
          most = std::max(most, error / bound);
        }
      }
    }
  }
  CHECK(worst[0] <= 1.0); // rounding of the exponent
  CHECK(worst[1] <= 1.0);
}

TEST_CASE("Extremes: nothing passes turbid voxels of an optical depth of 700", "[Extremes]")
{
  Triangles wall;
  wall.AddWall(120, -50, 50, -50, 50);
  Shot shot(wall.GetScene());
  vtkNew<vtkImageData> slab; // 1 m deep; G is 0.5
  slab->SetDimensions(2, 2, 2);
  slab->SetOrigin(-10, 100, -10);
  slab->SetSpacing(20, 1, 20);
  vtkNew<vtkDoubleArray> density;
  density->SetName(names::PAD);
  density->InsertNextValue(1400);
  slab->GetCellData()->AddArray(density);
  shot.Scanner->AddInputDataObject(2, slab);
  shot.Scanner->SetDuration(0.05);
  shot.SetWay(Way::OneRay);
  double sum = 0.0;
  const auto echoes = shot.Fire();
  REQUIRE(echoes.size() == 5000);
  for (const ShotEcho& echo : echoes)
  {
    CHECK(echo.Range < 100.053); // 37 mean free paths: as deep as random numbers in double go
    sum += echo.Range - 100;
  }
  CHECK(sum / 5000 == Approx(1 / 700.0).epsilon(0.06)); // 4 standard errors
}

namespace
{

constexpr double Variance = 0.2373622; // variance of a beam's angle along an axis, in w^2

struct PlaneErrors
{
  std::size_t Echoes = 0;
  double Truth = 0.0; // amplitude, of a full footprint
  double Range = 0.0;
  double Amplitude = 0.0;
};

/// The errors of the echo of a plane whose diagonal is in the beam.
PlaneErrors MeasurePlane(double divergence, double range, double degrees)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const TrueReturn truth = GetFirstEcho(0.5 * divergence,
    [=](const Vec3& d)
    {
      const double cosine = std::cos(angle) * d[1] - std::sin(angle) * d[2];
      return TrueReturn{ range * std::cos(angle) / cosine, cosine };
    });
  const Vec3 slope(0, 3 * range * std::sin(angle), 3 * range * std::cos(angle));
  const Vec3 side(3 * range, 0, 0);
  const Vec3 middle(0, range, 0);
  Triangles plane;
  plane.AddQuad(
    middle - slope - side, middle - slope + side, middle + slope + side, middle + slope - side);
  Shot shot(plane.GetScene());
  shot.Scanner->GetBeamSampler()->SetBeamDivergence(divergence);
  const auto echoes = shot.Fire();
  const double full = GetFull(truth.Range);
  PlaneErrors errors{ echoes.size(), truth.Power / full };
  if (!echoes.empty())
  {
    errors.Range = std::abs(echoes[0].Range - truth.Range);
    errors.Amplitude = std::abs(echoes[0].Amplitude - truth.Power) / full;
  }
  return errors;
}

} // namespace

TEST_CASE(
  "Extremes: divergences of 1e-9 to 0.5 rad, where equal ranges are nearly plane", "[Extremes]")
{
  double worstRange = 0.0;
  double worstAmplitude = 0.0;
  int count = 0;
  for (double divergence : { 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.5 })
  {
    const double w = 0.5 * divergence;
    for (double range : { 1e-3, 0.1, 1.0, 10.0, 100.0, 1000.0 })
    {
      for (double degrees : { 0.0, 30.0, 60.0, 75.0 })
      {
        const double tangent = std::tan(vtkMath::RadiansFromDegrees(degrees));
        if (range * Variance * w * w > 1e-3 || 1.5 * w * tangent > 0.2)
        {
          continue;
        }
        const PlaneErrors errors = MeasurePlane(divergence, range, degrees);
        if (errors.Truth < 0.02)
        {
          continue;
        }
        CAPTURE(divergence, range, degrees);
        REQUIRE(errors.Echoes == 1);
        worstRange = std::max(worstRange, errors.Range);
        worstAmplitude = std::max(worstAmplitude, errors.Amplitude);
        ++count;
      }
    }
  }
  CHECK(count > 100);
  CHECK(worstRange <= 1e-3);
  CHECK(worstAmplitude <= 0.01);
}

TEST_CASE("Extremes: where equal ranges are curved, ranges err by R s^2", "[Extremes]")
{
  double worstRange = 0.0;
  double worstAmplitude = 0.0;
  for (double divergence : { 0.02, 0.1, 0.3, 0.5 })
  {
    for (double range : { 0.01, 1.0, 10.0, 100.0 })
    {
      for (double degrees : { 0.0, 30.0, 60.0 })
      {
        const PlaneErrors errors = MeasurePlane(divergence, range, degrees);
        if (errors.Truth < 0.05)
        {
          continue;
        }
        const double curve = range * Variance * 0.25 * divergence * divergence;
        CAPTURE(divergence, range, degrees);
        REQUIRE(errors.Echoes == 1);
        worstRange = std::max(worstRange, errors.Range / (1e-3 + curve));
        worstAmplitude =
          std::max(worstAmplitude, errors.Amplitude / (0.08 + std::pow(curve / SigmaRange, 2) / 2));
      }
    }
  }
  CHECK(worstRange <= 1.0);
  CHECK(worstAmplitude <= 1.0);
}

TEST_CASE(
  "Extremes: times and ids of pulses are exact to 2^40 pulses, from 1 Hz to 10 MHz", "[Extremes]")
{
  for (double frequency : { 1.0, 3.0, 1e5, 299792.0, 1e7 })
  {
    const vtkIdType last = frequency > 10 ? vtkIdType(1) << 40 : std::llround(86400 * frequency);
    Triangles wall;
    wall.AddWall(100, -50, 50, -50, 50);
    Shot shot(wall.GetScene());
    shot.Aim->SetPulseFrequency(frequency);
    shot.Scanner->SetDuration(static_cast<double>(last) / frequency);
    shot.Scanner->SetFirstPulseId(last);
    CHECK(shot.Scanner->GetNumberOfPulses() == last);
    for (vtkIdType first : { vtkIdType(0), last / 3, last - 100 })
    {
      shot.Scanner->SetPulseWindow(first, first + 100);
      vtkPolyData* echoes = shot.Run();
      CAPTURE(frequency, first);
      REQUIRE(echoes->GetNumberOfPoints() == 100);
      int wrong = 0;
      for (vtkIdType i = 0; i < 100; ++i)
      {
        const Real time = static_cast<Real>(first + i) / static_cast<Real>(frequency);
        wrong += Value(echoes, names::GpsTime, i) != static_cast<double>(time) ? 1 : 0;
        wrong += Value(echoes, names::PulseIds, i) != static_cast<double>(last + first + i) ? 1 : 0;
      }
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("Extremes: a platform and a head after 24 h at 10 MHz", "[Extremes]")
{
  // 60 m/s over 5184 km; the head turns 3.1e7 degrees.
  constexpr double day = 86400.0;
  constexpr double frequency = 1e7;
  constexpr double speed = 60.0;
  constexpr double turn = 359.0; // [deg/s]
  Triangles wall;
  wall.AddWall(100, -50, 50, -50, 50);
  Shot shot(wall.GetScene());
  shot.Aim->SetPulseFrequency(frequency);
  const auto path = MakeWaypoints({ { 0, 0, 0 }, { speed * day, 0, 0 } });
  vtkNew<vtkDoubleArray> times;
  times->SetName(names::GpsTime);
  times->InsertNextValue(0);
  times->InsertNextValue(day);
  path->GetPointData()->AddArray(times);
  shot.Scanner->SetInputData(1, path);
  shot.Scanner->SetDuration(-1);
  shot.Scanner->SetHeadRotateSpeed(turn);
  shot.Scanner->GeneratePulsesOn();
  const vtkIdType count = shot.Scanner->GetNumberOfPulses();
  CHECK(count == 864000000000LL);
  shot.Scanner->SetPulseWindow(count - 1000, count);
  shot.Scanner->Update();
  vtkPolyData* pulses = shot.Scanner->GetOutput(2);
  REQUIRE(pulses->GetNumberOfPoints() == 1000);
  double place = 0.0;
  double direction = 0.0;
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    const Real time = static_cast<Real>(count - 1000 + i) / static_cast<Real>(frequency);
    const Real angle = std::fmod(turn * time, Real(360)) * std::acos(Real(-1)) / 180;
    const double* d = pulses->GetPointData()->GetArray(names::Direction)->GetTuple3(i);
    direction = std::max({ direction, std::abs(static_cast<double>(d[0] + std::sin(angle))),
      std::abs(static_cast<double>(d[1] - std::cos(angle))) });
    place = std::max(place,
      std::abs(static_cast<double>(pulses->GetPoint(i)[0] - static_cast<Real>(speed) * time)));
  }
  CHECK(place <= 4 * HalfUlp * speed * day);
  CHECK(direction <= 4 * HalfUlp * vtkMath::RadiansFromDegrees(turn * day));

  // Times of an epoch are doubles, too: half of 2.4e-7 s at 60 m/s.
  constexpr double epoch = 1.4e9;
  times->SetValue(0, epoch);
  times->SetValue(1, epoch + day);
  times->Modified();
  path->Modified();
  shot.Scanner->Update();
  place = 0.0;
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    const Real time = static_cast<Real>(count - 1000 + i) / static_cast<Real>(frequency);
    place = std::max(place,
      std::abs(static_cast<double>(pulses->GetPoint(i)[0] - static_cast<Real>(speed) * time)));
  }
  CHECK(place <= speed * 0x1p-23);
}

TEST_CASE("Extremes: a limit of the waveform is reported by adaptive sampling, too", "[Extremes]")
{
  Triangles steps;
  steps.AddWall(100, -50, 50, 0, 50);
  steps.AddWall(150, -50, 50, -50, 50);
  Shot shot(steps.GetScene());
  shot.Scanner->SetMaximumWaveformLength(100); // 15 m
  CHECK(shot.Fire().size() == 1);
  CHECK(shot.Log->HasWarning("1 waveforms were truncated"));
}
