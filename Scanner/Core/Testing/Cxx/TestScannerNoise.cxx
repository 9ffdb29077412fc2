// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Noise and errors of the instrument, and the ground truth.
#include "heliosScannerBench.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosErrorModel.h"
#include "vtkHeliosRotatingMirror.h"

#include <vtkFieldData.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;

namespace
{

/// The standard deviation of a column about a value.
double Deviation(vtkPolyData* echoes, const char* name, double about)
{
  double sum = 0;
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    sum += std::pow(Value(echoes, name, i) - about, 2);
  }
  return std::sqrt(sum / static_cast<double>(echoes->GetNumberOfPoints()));
}

/// 20000 ideal rays at a wall at a range.
struct NoiseBench : Bench
{
  explicit NoiseBench(double range)
    : Bench(MakeScene({ Wall(range) }))
  {
    this->Scanner->SetDuration(0.2);
    this->Scanner->GetBeamSampler()->SetBeamDivergence(0);
    this->Scanner->SetSeed(3);
  }
};

class KnownErrors : public vtkHeliosErrorModel
{
public:
  static KnownErrors* New() { VTK_STANDARD_NEW_BODY(KnownErrors); }
  vtkTypeMacro(KnownErrors, vtkHeliosErrorModel);
  double GetRangeError(double theta) const override { return 0.01 + theta; }
  double GetDeflectionError(double) const override { return 0.002; }
  double GetHeadError(double) const override { return 0.003; }
  double GetRangeNoiseFactor(double range) const override { return range / 50; }
};

} // namespace

TEST_CASE("Noise: constant, range-dependent and amplitude-dependent", "[Noise]")
{
  // 20000 draws: the standard error of the standard deviation is 1 / sqrt(2 n) = 0.5 %; 4 of these.
  NoiseBench bench(40);
  bench.Scanner->SetRangeAccuracy(0.003);
  CHECK(Deviation(bench.Run(), names::Range, 40) == Approx(0.003).epsilon(0.02));
  bench.Scanner->SetRangeAccuracyPerMeter(1e-4); // 4 mm
  CHECK(Deviation(bench.Run(), names::Range, 40) == Approx(0.005).epsilon(0.02));
  const double amplitude = Value(bench.Run(), names::Amplitude, 0);
  bench.Scanner->SetRangeAccuracyAtThreshold(0.12);
  bench.Scanner->GetEchoDetector()->SetDetectionThreshold(0.1 * amplitude); // 12 mm
  CHECK(Deviation(bench.Run(), names::Range, 40) == Approx(0.013).epsilon(0.02));
}

TEST_CASE("Noise: angle noise moves the pulse, not the computed point", "[Noise]")
{
  // A wall at 45 degrees: a tilt e about one axis changes the range by 40 e.
  Bench bench(MakeScene({ { { -50, -10, -50 }, { 100, 0, 0 }, { 0, 100, 100 } } }));
  bench.Scanner->SetDuration(0.2);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  bench.Scanner->SetAngleAccuracy(1e-4);
  bench.Scanner->GenerateTruthOn();
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 20000);
  CHECK(Deviation(echoes, names::Range, 40) == Approx(0.004).epsilon(0.02));
  vtkDataArray* truth = echoes->GetPointData()->GetArray(names::TruePoint);
  vtkDataArray* normal = echoes->GetPointData()->GetArray(names::Normal);
  REQUIRE(truth);
  REQUIRE(normal);
  for (vtkIdType i = 0; i < 100; ++i)
  {
    CHECK(echoes->GetPoint(i)[0] == 0.0); // on the reported axis
    CHECK(echoes->GetPoint(i)[2] == 0.0);
    const double* p = truth->GetTuple3(i);
    CHECK(p[1] - p[2] == Approx(40).epsilon(1e-12)); // on the wall
    CHECK(p[2] != 0.0);
    const double* n = normal->GetTuple3(i);
    CHECK(std::abs(n[1] - -n[2]) < 1e-12);
  }
}

TEST_CASE("Noise: true points do not change the echoes", "[Noise]")
{
  NoiseBench bench(40);
  CHECK_FALSE(bench.Run()->GetPointData()->HasArray(names::TruePoint));
  bench.Scanner->SetRangeAccuracy(0.01);
  bench.Scanner->GenerateTruthOn();
  vtkPolyData* echoes = bench.Run();
  vtkDataArray* truth = echoes->GetPointData()->GetArray(names::TruePoint);
  CHECK(truth->GetTuple3(7)[1] == 40.0);
  CHECK(echoes->GetPoint(7)[1] != 40.0);
}

TEST_CASE("Noise: error expressions rotate the beam and change the range", "[Noise]")
{
  // Pulse 0 of the mirror is along y: theta is 0.
  Bench bench(MakeScene({ Wall(50) }));
  vtkNew<vtkHeliosRotatingMirror> mirror;
  bench.Scanner->SetBeamDeflector(mirror);
  bench.Scanner->SetDuration(1e-5);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  vtkNew<KnownErrors> errors;
  bench.Scanner->SetErrorModel(errors);
  bench.Scanner->GenerateTruthOn();
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1);
  const double range = 50 / (std::cos(0.002) * std::cos(0.003));
  CHECK(Value(echoes, names::Range, 0) == Approx(range + 0.01).epsilon(1e-13));
  CHECK(echoes->GetPoint(0)[1] == Approx(range + 0.01).epsilon(1e-13));
  CHECK(echoes->GetPoint(0)[0] == Approx(0).margin(1e-12));
  const double* truth = echoes->GetPointData()->GetArray(names::TruePoint)->GetTuple3(0);
  CHECK(truth[1] == Approx(50).epsilon(1e-13));
  CHECK(truth[0] == Approx(-50 * std::tan(0.003)).epsilon(1e-10));
  CHECK(truth[2] == Approx(range * std::sin(0.002)).epsilon(1e-10));
  // The factor applies to the range noise.
  bench.Scanner->SetBeamDeflector(bench.Deflector);
  bench.Scanner->SetDuration(0.2);
  bench.Scanner->SetRangeAccuracy(0.01);
  CHECK(Deviation(bench.Run(), names::Range, range + 0.01) == Approx(0.01).epsilon(0.02));
}

TEST_CASE("Noise: detector noise has its standard deviation, independent for each bin", "[Noise]")
{
  Bench bench(MakeScene({ Wall(100) }));
  bench.Scanner->SetDuration(2e-3);
  bench.Scanner->GenerateWaveformsOn();
  bench.Scanner->SetDetectorNoise(1e-9);
  bench.Scanner->GetEchoDetector()->SetDetectionThreshold(1e-7);
  vtkPolyData* echoes = bench.Run();
  CHECK(echoes->GetNumberOfPoints() >= 200);
  auto* table = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
  REQUIRE(table->GetNumberOfRows() == 200);
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  double sum = 0;
  int count = 0;
  for (vtkIdType row = 0; row < 200; ++row)
  {
    const vtkIdType first = table->GetValueByName(row, names::Offset).ToTypeInt64();
    for (vtkIdType i = first; i < first + 5; ++i, ++count) // the pulse is below 1e-5 there
    {
      sum += std::pow(samples->GetComponent(i, 0) - 0, 2);
    }
  }
  CHECK(std::sqrt(sum / count) == Approx(1e-9).epsilon(0.1));
}
