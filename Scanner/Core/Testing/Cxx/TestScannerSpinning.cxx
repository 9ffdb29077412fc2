// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A spinning head in the scanner: origins of beams, and columns.
#include "heliosScannerBench.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosSpinningChannels.h"

#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace helios::testing;
namespace names = vtkHeliosArrayNames;

namespace
{

/// Four beams that fire at once, 0.1 m from the axis and at heights of 0, 0.01, 0.02 and 0.03 m;
/// 100 columns a revolution.
void SetUp(vtkHeliosSpinningChannels* head)
{
  head->SetNumberOfChannels(4);
  for (int c = 0; c < 4; ++c)
  {
    head->SetFiringTime(c, 0.0);
    head->SetOriginOffset(c, 0.1);
    head->SetOriginHeight(c, 0.01 * c);
  }
  head->SetPulseFrequency(40000);
  head->SetScanFrequency(100);
}

} // namespace

TEST_CASE("ScannerSpinning: beams start at their origins in the head", "[ScannerSpinning]")
{
  const auto scene = MakeScene({ Wall(10, 100) });
  Bench bench(scene, { 1, 2, 3 });
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  bench.Scanner->SetBeamDeflector(head);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0.0);
  bench.Scanner->SetBeamOrigin(0, 0, 0.5);
  bench.Scanner->SetMountPosition(0.25, 0, 0);
  bench.Scanner->GeneratePulsesOn();
  vtkPolyData* echoes = bench.Run();
  vtkPolyData* pulses = bench.Scanner->GetOutput(2);
  REQUIRE(pulses->GetNumberOfPoints() == 400);
  for (const vtkIdType i : { 0, 3, 4, 41, 102, 399 })
  {
    const double turn = 2.0 * vtkMath::Pi() * static_cast<double>(i / 4) / 100.0;
    double p[3];
    pulses->GetPoint(i, p);
    CHECK(p[0] == Approx(1.25 - 0.1 * std::sin(turn)).epsilon(1e-14));
    CHECK(p[1] == Approx(2.0 + 0.1 * std::cos(turn)).epsilon(1e-14));
    CHECK(p[2] == Approx(3.5 + 0.01 * static_cast<double>(i % 4)).epsilon(1e-14));
  }
  REQUIRE(echoes->GetNumberOfPoints() > 100);
  CHECK(Value(echoes, names::Range, 0) == Approx(10.0 - 2.1).epsilon(1e-12)); // from its origin
  CHECK(echoes->GetPoint(0)[1] == Approx(10.0).epsilon(1e-13));
}

TEST_CASE("ScannerSpinning: origins turn with the head's mount", "[ScannerSpinning]")
{
  const auto scene = MakeScene({ Wall(10, 100) });
  Bench bench(scene, { 0, 0, 0 });
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  bench.Scanner->SetBeamDeflector(head);
  const double half = std::sqrt(0.5);
  bench.Scanner->SetBeamOrientation(half, half, 0, 0); // by 90 degrees about x: y to z, z to -y
  bench.Scanner->GeneratePulsesOn();
  bench.Run();
  vtkPolyData* pulses = bench.Scanner->GetOutput(2);
  double p[3];
  pulses->GetPoint(3, p); // 0.1 m along y, 0.03 m up
  CHECK(p[0] == Approx(0.0).margin(1e-15));
  CHECK(p[1] == Approx(-0.03).epsilon(1e-13));
  CHECK(p[2] == Approx(0.1).epsilon(1e-13));
}

TEST_CASE("ScannerSpinning: columns of echoes and pulses on request", "[ScannerSpinning]")
{
  const auto scene = MakeScene({ Wall(10, 100) });
  Bench bench(scene);
  vtkNew<vtkHeliosSpinningChannels> head;
  SetUp(head);
  bench.Scanner->SetBeamDeflector(head);
  bench.Scanner->SetDuration(0.025); // 2.5 revolutions
  bench.Scanner->GeneratePulsesOn();
  bench.Scanner->SetFirstPulseId(5000);
  bench.Scanner->SetPulseIdStride(3);
  CHECK_FALSE(bench.Run()->GetPointData()->HasArray(names::ColumnIds));
  CHECK_FALSE(bench.Scanner->GetOutput(2)->GetPointData()->HasArray(names::ColumnIds));
  bench.Scanner->GenerateColumnsOn();
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() > 300);
  REQUIRE(bench.Scanner->GetOutput(2)->GetNumberOfPoints() == 1000);
  for (vtkPolyData* points : { echoes, bench.Scanner->GetOutput(2) })
  {
    for (vtkIdType row = 0; row < points->GetNumberOfPoints(); ++row)
    {
      const auto index = static_cast<vtkIdType>(Value(points, names::PulseIds, row) - 5000.0) / 3;
      REQUIRE(Value(points, names::ColumnIds, row) == static_cast<double>(index / 4 % 100));
    }
  }
  bench.Scanner->SetBeamDeflector(bench.Deflector); // has no columns
  CHECK(Value(bench.Run(), names::ColumnIds, 7) == 0.0);
}
