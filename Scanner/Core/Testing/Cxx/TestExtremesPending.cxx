// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors of adaptive sampling at the extremes, that are known.
#include "heliosExtremeShots.h"

#include <vtkMath.h>

#include <cmath>
#include <random>

using helios::Vec3;
using namespace helios::testing;

TEST_CASE(
  "Pending: a plane has its echo within 1 mm and 1 % in beams of 0.02 to 0.5 rad", "[Pending]")
{
  for (double divergence : { 0.02, 0.1, 0.3, 0.5 })
  {
    for (double range : { 0.01, 1.0, 10.0, 100.0 })
    {
      for (double degrees : { 0.0, 30.0, 60.0, 75.0 })
      {
        const double angle = vtkMath::RadiansFromDegrees(degrees);
        const TrueReturn truth = GetFirstEcho(0.5 * divergence,
          [=](const Vec3& d)
          {
            const double cosine = std::cos(angle) * d[1] - std::sin(angle) * d[2];
            return TrueReturn{ range * std::cos(angle) / cosine, cosine };
          });
        if (truth.Power < 0.02 * GetFull(truth.Range) || (degrees > 70 && divergence > 0.2))
        {
          continue;
        }
        const Vec3 slope(0, 9 * range * std::sin(angle), 9 * range * std::cos(angle));
        const Vec3 side(9 * range, 0, 0);
        const Vec3 middle(0, range, 0);
        Triangles plane;
        plane.AddQuad(middle - slope - side, middle - slope + side, middle + slope + side,
          middle + slope - side);
        Shot shot(plane.GetScene());
        shot.Scanner->GetBeamSampler()->SetBeamDivergence(divergence);
        const auto echoes = shot.Fire();
        CAPTURE(divergence, range, degrees);
        REQUIRE(echoes.size() == 1);
        CHECK(std::abs(echoes[0].Range - truth.Range) <= 1e-3);
        CHECK(std::abs(echoes[0].Amplitude - truth.Power) <= 0.01 * GetFull(truth.Range));
      }
    }
  }
}

TEST_CASE("Pending: a grazing plane has one echo", "[Pending]")
{
  for (double height : { 0.01, 0.1, 1.0 })
  {
    Triangles ground;
    ground.AddQuad({ -1e6, -1e6, 0 }, { 1e6, -1e6, 0 }, { 1e6, 1e6, 0 }, { -1e6, 1e6, 0 });
    const double below = 1e-4;
    Shot shot(ground.GetScene(), { 0.1, 0.2, height }, Vec3(0, std::cos(below), -std::sin(below)));
    CAPTURE(height);
    CHECK(shot.Fire().size() == 1);
  }
}

TEST_CASE("Pending: with a waist, edges along the beam have the energies of sub-rays", "[Pending]")
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0, 1);
  for (int i = 0; i < 20; ++i)
  {
    const double w = i % 2 == 0 ? 1.5e-4 : 1e-3;
    const double rayleigh = 1.064e-6 / (vtkMath::Pi() * w * w);
    const double near = rayleigh * (0.1 + number(random));
    const double far = rayleigh * (1 + 5 * number(random));
    const double waist = w * rayleigh;
    Triangles triangles;
    triangles.Add({ -waist, near, waist * (number(random) - 0.5) },
      { waist, far, waist * (number(random) - 0.5) }, { 0, 0.5 * (near + far), 30 });
    triangles.AddWall(8 * rayleigh, -50, 50, -50, 50);
    const auto scene = triangles.GetScene();
    double energies[2] = { 0, 0 };
    for (int k = 0; k < 2; ++k)
    {
      Shot shot(scene);
      shot.SetWay(k == 0 ? Way::Adaptive : Way::Spiral);
      if (k == 1)
      {
        shot.Scanner->GetBeamSampler()->SetNumberOfSubRays(65536);
      }
      shot.Scanner->GetBeamSampler()->SetBeamDivergence(2 * w);
      shot.Scanner->GetBeamSampler()->SetBeamQualityFactor(1);
      shot.Scanner->GenerateSubRaysOn();
      shot.Run();
      vtkPolyData* hits = shot.Scanner->GetOutput(3);
      for (vtkIdType hit = 0; hit < hits->GetNumberOfPoints(); ++hit)
      {
        const bool isFirst = Value(hits, vtkHeliosArrayNames::CellIds, hit) == 0.0;
        energies[k] += isFirst ? Value(hits, vtkHeliosArrayNames::Weight, hit) : 0.0;
      }
    }
    CAPTURE(w, near, far);
    CHECK(std::abs(energies[0] - energies[1]) < 5e-3);
  }
}

TEST_CASE("Pending: a limit of the waveform is reported by adaptive sampling, too", "[Pending]")
{
  Triangles steps;
  steps.AddWall(100, -50, 50, 0, 50);
  steps.AddWall(150, -50, 50, -50, 50);
  Shot shot(steps.GetScene());
  shot.Scanner->SetMaximumWaveformLength(100); // 15 m
  CHECK(shot.Fire().size() == 1);
  CHECK(shot.Log->HasWarning("1 waveforms were truncated"));
}
