// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Elliptical beams: closed forms, and visible areas against sub-rays.
#include "heliosBeamEllipse.h"
#include "heliosConstants.h"
#include "heliosFootprintScene.h"
#include "heliosPlaneEcho.h"
#include "heliosPulse.h"

#include <catch2/catch.hpp>

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <random>

using helios::Vec3;
using namespace helios::testing;

namespace
{

constexpr double W = 8e-4; // half angle of the major axis
constexpr double Ratio = 0.3;
constexpr double Range = 100.0;

/// A beam whose minor axis is rotated from z towards x.
void SetEllipse(FootprintScene& scene, double degrees, double truncation = 3.0)
{
  scene.Settings.HalfAngle = W;
  scene.Settings.Ratio = Ratio;
  scene.Settings.Truncation = truncation;
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  scene.Minor[0] = std::sin(angle);
  scene.Minor[2] = std::cos(angle);
}

/// A wall at 100 m where n . (x, z) is between two values, for a unit vector n.
void AddStrip(FootprintScene& scene, const double n[2], double from, double to)
{
  constexpr double far = 9.0;
  const auto at = [&](double across, double along, double* corner)
  {
    corner[0] = across * n[0] - along * n[1];
    corner[1] = Range;
    corner[2] = across * n[1] + along * n[0];
  };
  double corners[2][3][3];
  at(from, -far, corners[0][0]);
  at(to, -far, corners[0][1]);
  at(to, far, corners[0][2]);
  at(from, -far, corners[1][0]);
  at(to, far, corners[1][1]);
  at(from, far, corners[1][2]);
  scene.AddTriangle(corners[0]);
  scene.AddTriangle(corners[1]);
}

double GetTotal(const Cells& cells)
{
  double sum = 0.0;
  for (const auto& [id, cell] : cells)
  {
    sum += cell.Energy;
  }
  return sum;
}

/// The half angle of the beam at 1/e^2, projected on n: (n . major w)^2 + (n . minor q w)^2.
double GetHalfAngle(const FootprintScene& scene, const double n[2])
{
  const double minor = n[0] * scene.Minor[0] + n[1] * scene.Minor[2];
  const double major = n[0] * scene.Minor[2] - n[1] * scene.Minor[0];
  return W * std::hypot(major, Ratio * minor);
}

} // namespace

TEST_CASE("BeamEllipse: a point and its moments there and back")
{
  helios::BeamEllipse ellipse(0.25);
  const double frame[3][3] = { { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const double minor[3] = { 0.6, 0, 0.8 }; // 0.8, 0.6 across
  ellipse.Align(frame, minor);
  double point[3] = { 0.8, 0.6, 7.0 };
  ellipse.ToCircle(point);
  CHECK(point[0] == Approx(3.2).epsilon(1e-14));
  CHECK(point[1] == Approx(2.4).epsilon(1e-14));
  CHECK(point[2] == 7.0);
  helios::EnergyMoments moments;
  moments.Energy = 1.0;
  moments.XX = point[0] * point[0];
  moments.XY = point[0] * point[1];
  moments.YY = point[1] * point[1];
  CHECK(ellipse.GetSquare(moments) == Approx(1.0).epsilon(1e-13));
  ellipse.FromCircle(point);
  CHECK(point[0] == Approx(0.8).epsilon(1e-14));
  CHECK(point[1] == Approx(0.6).epsilon(1e-14));
  double major[2] = { -0.6, 0.8 };
  ellipse.ToCircle(major);
  CHECK(major[0] == Approx(-0.6).epsilon(1e-14));
  CHECK(major[1] == Approx(0.8).epsilon(1e-14));
}

TEST_CASE("BeamEllipse: the energy beyond an edge is that of the error function")
{
  for (const double turn : { 0.0, 35.0, 90.0, -70.0 })
  {
    for (const double azimuth : { 0.0, 0.4, 1.5707963267948966, 2.5 })
    {
      for (const double offset : { 0.0, 0.01, 0.03, -0.02 })
      {
        FootprintScene scene;
        SetEllipse(scene, turn);
        const double n[2] = { std::cos(azimuth), std::sin(azimuth) };
        AddStrip(scene, n, offset, 9.0);
        scene.Build();
        CAPTURE(turn, azimuth, offset);
        const double x = offset / (Range * GetHalfAngle(scene, n));
        CHECK(GetTotal(scene.GetFootprint()) ==
          Approx(0.5 * std::erfc(std::sqrt(2.0) * x)).margin(3e-6)); // the cut has 1.5e-8
      }
    }
  }
}

TEST_CASE("BeamEllipse: a wire across the minor axis has less energy than one along it")
{
  for (const double turn : { 0.0, 20.0 })
  {
    double energies[2];
    for (const int along : { 0, 1 })
    {
      FootprintScene scene;
      SetEllipse(scene, turn);
      const double minor[2] = { scene.Minor[0], scene.Minor[2] };
      const double major[2] = { scene.Minor[2], -scene.Minor[0] };
      const double* n = along == 1 ? major : minor; // a wire along the minor axis: across the major
      constexpr double half = 1e-3;
      AddStrip(scene, n, -half, half);
      scene.Build();
      energies[along] = GetTotal(scene.GetFootprint());
      const double w = along == 1 ? W : Ratio * W;
      CHECK(energies[along] == Approx(std::erf(std::sqrt(2.0) * half / (Range * w))).margin(3e-6));
    }
    CHECK(energies[1] < 0.31 * energies[0]);
  }
}

TEST_CASE("BeamEllipse: the ranges on an inclined plane spread with the axis of the slope")
{
  // Checks the moment w / 2 of an untruncated beam along an axis; the energy beyond 3 w is left
  // out.
  for (const double turn : { 0.0, 50.0 })
  {
    for (const double azimuth : { 0.0, 0.7, 1.5707963267948966 })
    {
      FootprintScene scene;
      SetEllipse(scene, turn);
      scene.Settings.Depth = 0.01;
      const double slope[2] = { std::cos(azimuth), std::sin(azimuth) }; // axis of 45 degrees
      const auto at = [&](double x, double z, double* corner)
      {
        corner[0] = x;
        corner[1] = Range + slope[0] * x + slope[1] * z;
        corner[2] = z;
      };
      double corners[3][3];
      at(-5, -5, corners[0]);
      at(9, -3, corners[1]);
      at(-3, 9, corners[2]);
      scene.AddTriangle(corners);
      scene.Build();
      const double s = 0.5 * Range * GetHalfAngle(scene, slope);
      const Cell cell = scene.GetFootprint().at(0);
      CAPTURE(turn, azimuth);
      CHECK(std::sqrt(cell.Square) == Approx(s).epsilon(3e-5));
      // Range (1 + E[t^2] + E[g^2] / 2), without the weight of the power.
      const double own = 0.125 * W * W * (1.0 + Ratio * Ratio);
      CHECK(cell.Mean - Range == Approx(s * s / Range + Range * own).epsilon(1e-3));
    }
  }
}

TEST_CASE("BeamEllipse: the visible parts and the cells of clutter have the energies of sub-rays")
{
  std::mt19937 random(7); // NOLINT(cert-msc32-c, cert-msc51-cpp): the same scenes every time
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (const double turn : { 0.0, 25.0, -60.0 })
  {
    FootprintScene scene;
    SetEllipse(scene, turn, 1.5);
    for (int i = 0; i < 60; ++i)
    {
      double corners[3][3];
      const double middle[3] = { 0.13 * number(random), 100.0 + number(random),
        0.13 * number(random) };
      for (auto& corner : corners)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          corner[axis] = middle[axis] + 0.05 * number(random);
        }
      }
      scene.AddTriangle(corners);
    }
    scene.AddWall(103.0, -20.0, -20.0);
    scene.Build();
    Cells traced = scene.Trace();
    Cells parts = scene.GetFootprint();
    Cells cells = scene.Sample(512);
    CHECK(GetTotal(parts) == Approx(1.0).margin(1e-5));
    CHECK(parts.size() > 10);
    for (const auto& [id, cell] : traced)
    {
      CAPTURE(turn, id, cell.Energy);
      CHECK(parts[id].Energy == Approx(cell.Energy).margin(1e-3));
      CHECK(cells[id].Energy == Approx(cell.Energy).margin(2e-3));
      if (cell.Energy > 0.02)
      {
        CHECK(parts[id].Mean == Approx(cell.Mean).epsilon(0).margin(1e-3));
      }
    }
  }
}

TEST_CASE("BeamEllipse: a plane echo has the moments of the sub-rays")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamDivergence(2.0 * W);
  sampler->SetDivergenceRatio(Ratio);
  sampler->SetNumberOfRings(24);
  const helios::PlaneModel model{ helios::BeamMoments(2.0 * W, 1.5), 4.0 / helios::FwhmPerSigma,
    Ratio };
  for (const Vec3 slope : { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0.8, 0, -0.5) })
  {
    // Depth 1 / (1 - slope . d) on the axis at 1; the power of the axis is 1.
    double power = 0.0, mean = 0.0, square = 0.0;
    for (int k = 0; k < sampler->GetNumberOfSubRays(); ++k)
    {
      double d[3];
      sampler->GetDirection(k, d);
      const double cosine = d[1] - slope[0] * d[0] - slope[2] * d[2]; // relative to the axis'
      const double range = 1.0 / cosine;
      const double weight = sampler->GetWeight(k) * cosine / (range * range);
      power += weight;
      mean += weight * range;
      square += sampler->GetWeight(k) * (range - 1.0) * (range - 1.0);
    }
    mean /= power;
    const double tangent = std::hypot(slope[0], Ratio * slope[2]);
    const helios::PlaneEcho echo = model.GetEcho(1.0, 1.0, tangent, 1.0);
    const double unit = 2.0 / (helios::SpeedOfLight * model.Sigma);
    CAPTURE(slope[0], slope[2]);
    CHECK(echo.Range - 1.0 == Approx(mean - 1.0).epsilon(1e-5).margin(1e-12));
    CHECK(echo.Power * echo.Sigma / model.Sigma == Approx(power).epsilon(1e-9));
    if (tangent > 0.0)
    {
      CHECK(model.GetWidening(1.0, tangent) == Approx(unit * unit * square).epsilon(1e-4));
    }
  }
  double square = 0.0, fourth = 0.0; // moments of the angle, for normal incidence
  for (int k = 0; k < sampler->GetNumberOfSubRays(); ++k)
  {
    double d[3];
    sampler->GetDirection(k, d);
    const double half = 0.5 * (d[0] * d[0] + d[2] * d[2]) / (d[1] * d[1]);
    square += sampler->GetWeight(k) * half;
    fourth += sampler->GetWeight(k) * half * half;
  }
  const double s2 = model.Beam.Variance;
  CHECK(model.GetCurvature() * s2 * s2 == Approx(fourth - square * square).epsilon(1e-5));
  CHECK(helios::PlaneModel{ model.Beam, 1.0 }.GetCurvature() == 1.0 + model.Beam.Excess / 1.5);
}

TEST_CASE("BeamEllipse: the frame of a beam has its major axis at an angle from an axis")
{
  helios::BeamRoll roll;
  roll.IsOn = true;
  const Vec3 ahead(0, 1, 0);
  const auto column = [](const helios::Rotation& r, int i)
  { return Vec3(r.M[0][i], r.M[1][i], r.M[2][i]); };
  for (const double angle : { 0.0, 30.0, 90.0 })
  {
    roll.Angle = angle;
    const helios::Rotation frame = roll.GetFrame(ahead);
    const double a = vtkMath::RadiansFromDegrees(angle);
    // Clockwise as the scanner sees it: from x, on the right, down.
    CHECK((column(frame, 0) - Vec3(std::cos(a), 0, -std::sin(a))).Norm() < 1e-15);
    CHECK((column(frame, 2) - Vec3(std::sin(a), 0, std::cos(a))).Norm() < 1e-15);
  }
  // Checks the axes of a beam off the axis: orthonormal, right-handed, in the plane of the axis and
  // the beam.
  roll.Angle = 0.0;
  roll.CrossAxis = Vec3(0, 0, 1);
  const Vec3 beam = Vec3(0.3, -0.7, 0.4).Normalized();
  const helios::Rotation frame = roll.GetFrame(beam);
  CHECK((column(frame, 1) - beam).Norm() == 0.0);
  CHECK((column(frame, 0).Cross(beam) - column(frame, 2)).Norm() < 1e-15);
  CHECK(std::abs(column(frame, 0).Dot(beam)) < 1e-15);
  CHECK(std::abs(column(frame, 0).Dot(roll.CrossAxis.Cross(beam))) < 1e-15);
  CHECK(column(frame, 0)[2] > 0.0);
  // A beam along the axis has any.
  const helios::Rotation along = roll.GetFrame(roll.CrossAxis);
  CHECK(column(along, 0).Norm() == Approx(1.0));
}
