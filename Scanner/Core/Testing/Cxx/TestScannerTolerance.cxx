// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Adaptive sampling against thousands of fixed sub-rays.
#include "heliosRandom.h"
#include "heliosScannerBench.h"
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosRotatingMirror.h"

#include <vtkFieldData.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;

namespace
{

/// A scanner that sweeps up and down over a scene.
struct Sweep : Bench
{
  vtkNew<vtkHeliosRotatingMirror> Mirror;

  explicit Sweep(vtkPolyData* scene)
    : Bench(scene)
  {
    this->Mirror->SetMirrorAngle(20);
    this->Mirror->SetPulseFrequency(20000);
    this->Scanner->SetBeamDeflector(this->Mirror);
    this->Scanner->SetHeadRotateSpeed(200);
    this->Scanner->SetDuration(0.05);
    this->Scanner->GetBeamSampler()->SetBeamDivergence(2e-3);
  }
};

/// Steps, slopes and slats at 40 to 60 m.
vtkSmartPointer<vtkPolyData> MakeSteps()
{
  return MakeScene({ Wall(60), { { -50, 50, 3 }, { 100, 0, 0 }, { 0, 0, 50 } },
    { { -50, 50.3, 1 }, { 100, 0, 0 }, { 0, 0, 2 } }, { { 0, 40, -10 }, { 5, 8, 0 }, { 0, 0, 9 } },
    { { -5, 45, -8 }, { 4, 0, 1 }, { 0, 3, 6 } } });
}

struct Comparison
{
  vtkIdType Matched = 0;
  vtkIdType Missed = 0;
  vtkIdType Extra = 0;
  double RangeRms = 0.0;
  double AmplitudeRms = 0.0;
};

/// The sum of the amplitudes of an echo's pulse.
double GetPower(vtkPolyData* echoes, vtkIdType echo)
{
  const vtkIdType first =
    echo + 1 - static_cast<vtkIdType>(Value(echoes, names::ReturnNumber, echo));
  const auto count = static_cast<vtkIdType>(Value(echoes, names::NumberOfReturns, echo));
  double sum = 0;
  for (vtkIdType i = first; i < first + count; ++i)
  {
    sum += Value(echoes, names::Amplitude, i);
  }
  return sum;
}

/// Echoes of the same pulse nearer than 0.3 m are the same; amplitudes are relative to the total
/// return of the pulse.
Comparison Compare(vtkPolyData* echoes, vtkPolyData* reference)
{
  Comparison c;
  vtkIdType j = 0;
  for (vtkIdType i = 0; i < reference->GetNumberOfPoints(); ++i)
  {
    const double pulse = Value(reference, names::PulseIds, i);
    while (j < echoes->GetNumberOfPoints() && Value(echoes, names::PulseIds, j) < pulse)
    {
      ++j;
    }
    vtkIdType best = -1;
    double nearest = 0.3;
    for (vtkIdType k = j;
         k < echoes->GetNumberOfPoints() && Value(echoes, names::PulseIds, k) == pulse; ++k)
    {
      const double away =
        std::abs(Value(echoes, names::Range, k) - Value(reference, names::Range, i));
      if (away < nearest)
      {
        nearest = away;
        best = k;
      }
    }
    if (best < 0)
    {
      ++c.Missed;
      continue;
    }
    ++c.Matched;
    c.RangeRms += nearest * nearest;
    const double away =
      Value(echoes, names::Amplitude, best) - Value(reference, names::Amplitude, i);
    c.AmplitudeRms += std::pow(away / GetPower(reference, i), 2);
  }
  c.Extra = echoes->GetNumberOfPoints() - c.Matched;
  const double n = static_cast<double>(c.Matched);
  c.RangeRms = std::sqrt(c.RangeRms / n);
  c.AmplitudeRms = std::sqrt(c.AmplitudeRms / n);
  return c;
}

/// A plane has the same echoes as with 40,000 sub-rays: one, and one of a leaf before a part of the
/// plane. The ranges in the beam spread over 6 q sigma_R, q = R w tan / (c sigma).
void CheckSteepPlane(double q, bool isLeaf, double tolerance)
{
  const double tangent = q * 0.509236;
  const double c = 1.0 / std::sqrt(1.0 + tangent * tangent);
  const Vec3 up(0.0, tangent * c, c);
  const Rectangle plane{ Vec3(-70.3, 2000, 0) - up * 210.7, { 200, 0, 0 }, up * 400.0 };
  const Rectangle leaf{ { 0.3, 1800, -5 }, { 10, 0, 0 }, { 0, 0, 10 } };
  Bench bench(isLeaf ? MakeScene({ plane, leaf }) : MakeScene({ plane }));
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(1e-3);
  bench.Scanner->SetSamplingToTolerance();
  bench.Scanner->SetRangeTolerance(tolerance);
  bench.Scanner->SetEnergyTolerance(10 * tolerance);
  bench.Scanner->SetDuration(1e-4); // 10 pulses
  Bench truth(isLeaf ? MakeScene({ plane, leaf }) : MakeScene({ plane }));
  truth.Scanner->GetBeamSampler()->SetBeamDivergence(1e-3);
  truth.Scanner->GetBeamSampler()->SetPatternToGaussLegendre();
  truth.Scanner->GetBeamSampler()->SetNumberOfRings(100);
  truth.Scanner->SetDuration(1e-4);
  vtkPolyData* echoes = bench.Run();
  vtkPolyData* right = truth.Run();
  CAPTURE(q, isLeaf, tolerance, bench.Scanner->GetCount("subRays"));
  REQUIRE(right->GetNumberOfPoints() == (isLeaf ? 20 : 10));
  REQUIRE(echoes->GetNumberOfPoints() == right->GetNumberOfPoints());
  const vtkIdType last = isLeaf ? 1 : 0;
  // deviation of the echo in range, for K = inf
  const double sigma = 0.254618 * std::sqrt(1.0 + q * q);
  CHECK(std::abs(Value(echoes, names::Range, last) - Value(right, names::Range, last)) <
    tolerance + 0.04 * sigma);
  CHECK(Value(echoes, names::Amplitude, last) ==
    Approx(Value(right, names::Amplitude, last)).epsilon(20 * tolerance));
}

} // namespace

TEST_CASE("Tolerance: range and amplitude are within the tolerances", "[Tolerance]")
{
  const auto scene = MakeSteps();
  Sweep reference(scene);
  reference.Scanner->GetBeamSampler()->SetPatternToVogel();
  reference.Scanner->GetBeamSampler()->SetNumberOfSubRays(6000);
  reference.Scanner->SetBinSize(0.1);
  vtkPolyData* truth = reference.Run();
  REQUIRE(truth->GetNumberOfPoints() > 1000);
  for (const double factor : { 10.0, 3.0, 1.0, 0.3 })
  {
    Sweep sweep(scene);
    sweep.Scanner->SetSamplingToTolerance();
    sweep.Scanner->SetRangeTolerance(1e-3 * factor);
    sweep.Scanner->SetEnergyTolerance(1e-2 * factor);
    const Comparison c = Compare(sweep.Run(), truth);
    CAPTURE(factor, c.Matched, c.Missed, c.Extra, c.RangeRms, c.AmplitudeRms,
      sweep.Scanner->GetCount("subRays"));
    CHECK(c.RangeRms < 1e-3 * factor);
    CHECK(c.AmplitudeRms < 1e-2 * factor);
    CHECK(c.Missed + c.Extra <= truth->GetNumberOfPoints() / 100);
    CHECK(sweep.Scanner->GetCount("pulsesOnPlane") + sweep.Scanner->GetCount("pulsesWithoutBins") +
        sweep.Scanner->GetCount("pulsesBinned") ==
      sweep.Scanner->GetCount("pulsesHit"));
  }
}

TEST_CASE("Tolerance: a wall needs no sub-rays, an edge does", "[Tolerance]")
{
  Bench bench(MakeScene({ Wall(100) }));
  bench.Scanner->SetSamplingToTolerance();
  // Off the wall's diagonal, which two triangles share.
  bench.Tripod->SetHeading(3);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  CHECK(bench.Scanner->GetCount("pulsesOnPlane") == 1000);
  CHECK(bench.Scanner->GetCount("subRays") == 0);
  CHECK(Value(echoes, names::Range, 0) ==
    Approx(100 / std::cos(3 * 0.017453292519943295)).epsilon(1e-6));

  Bench edge(MakeScene({ { { -50, 50, 0.0001 }, { 100, 0, 0 }, { 0, 0, 50 } }, Wall(60) }));
  edge.Scanner->SetSamplingToTolerance();
  CHECK(edge.Run()->GetNumberOfPoints() == 2000);
  CHECK(
    edge.Scanner->GetCount("pulsesBinned") + edge.Scanner->GetCount("pulsesWithoutBins") == 1000);
  CHECK(edge.Scanner->GetCount("pulsesSampled") == 0);
  CHECK(edge.Scanner->GetCount("subRays") <= 4 * 1000); // parts of three triangles
}

/// Slats of which every second one is nearer, before a wall: more than can be divided.
vtkSmartPointer<vtkPolyData> MakeSlats(int count)
{
  std::vector<Rectangle> slats;
  for (int i = -count / 2; i < count / 2; ++i)
  {
    const double step = 0.04 / count;
    slats.push_back({ { step * i, 50 + 0.001 * (i % 2), 0.0001 }, { step, 0, 0 }, { 0, 0, 1 } });
  }
  slats.push_back(Wall(60));
  return MakeScene(slats);
}

TEST_CASE(
  "Tolerance: beams with too many surfaces are sampled until the answers agree", "[Tolerance]")
{
  Bench slats(MakeSlats(2000));
  slats.Scanner->SetSamplingToTolerance();
  slats.Scanner->SetDuration(0.0005); // 50 pulses
  vtkPolyData* echoes = slats.Run();
  CHECK(echoes->GetNumberOfPoints() == 100);
  CHECK(slats.Scanner->GetCount("pulsesSampled") == 50);
  CHECK(slats.Scanner->GetCount("pulsesUnresolved") == 0);
  // Half of the beam less 0.1 mm of a radius of 7.5 mm.
  const double full =
    Value(echoes, names::Amplitude, 0) + 1.44 * Value(echoes, names::Amplitude, 1);
  CHECK(Value(echoes, names::Amplitude, 0) / full ==
    Approx(0.5 * std::erfc(std::sqrt(2.0) * 0.0001 / 0.0075)).margin(1e-2));
  slats.Scanner->SetEnergyTolerance(2e-4);
  slats.Run();
  CHECK(slats.Scanner->GetCount("pulsesSampled") == 50);
  slats.Scanner->SetMaximumNumberOfSubRays(1024);
  CHECK(slats.Run()->GetNumberOfPoints() == 100);
  CHECK(slats.Scanner->GetCount("pulsesUnresolved") == 50);
  slats.Scanner->SetMaximumNumberOfSubRays(1 << 24);
  slats.Run();
  CHECK(slats.Scanner->GetCount("pulsesSampled") == 0); // 2000 surfaces can be divided then
}

TEST_CASE("Tolerance: beams with too many triangles to collect are sampled by rays", "[Tolerance]")
{
  Bench slats(MakeSlats(80000));
  slats.Scanner->SetSamplingToTolerance();
  slats.Scanner->SetDuration(0.00005); // 5 pulses
  CHECK(slats.Run()->GetNumberOfPoints() == 10);
  CHECK(slats.Scanner->GetCount("pulsesSampled") == 5);
  CHECK(slats.Scanner->GetCount("pulsesUnresolved") == 0);
  CHECK(slats.Scanner->GetCount("subRays") % (5 * 256) == 0);
}

TEST_CASE("Tolerance: the widest tolerances sample by rays if most beams are full", "[Tolerance]")
{
  const int count = GENERATE(10, 200);
  Bench slats(MakeSlats(count));
  slats.Scanner->SetSamplingToTolerance();
  slats.Scanner->SetDuration(0.0005); // 50 pulses
  slats.Scanner->SetRangeTolerance(0.1);
  slats.Scanner->SetEnergyTolerance(0.5);
  CHECK(slats.Run()->GetNumberOfPoints() == 100);
  CHECK((slats.Scanner->GetCount("subRays") == 50 * 116) == (count > 100));
  CHECK(slats.Scanner->DescribeSampling().find("116 sub-rays if most beams are full") !=
    std::string::npos);
  slats.Scanner->SetEnergyTolerance(0.1);
  CHECK(slats.Run()->GetNumberOfPoints() == 100);
  CHECK(slats.Scanner->GetCount("subRays") != 50 * 116);
}

TEST_CASE("Tolerance: the limit of sub-rays has a range", "[Tolerance]")
{
  Bench bench(MakeScene({ Wall(60) }));
  bench.Scanner->SetSamplingToTolerance();
  for (const int limit : { 1023, (1 << 24) + 1 })
  {
    bench.Scanner->SetMaximumNumberOfSubRays(limit);
    vtkNew<helios::ErrorObserver> observer;
    observer->Watch(bench.Scanner);
    bench.Run();
    CHECK(observer->HasError(
      "MaximumNumberOfSubRays is " + std::to_string(limit) + "; give 1024 to 16777216"));
  }
}

TEST_CASE("Tolerance: a curved surface is sampled where it fills the beam", "[Tolerance]")
{
  // Facets that differ by 10 degrees: 2 mm at the rim.
  constexpr double edge = 1.0 / 1024;
  const std::vector<Rectangle> roof = { { { -50, 50, -50 }, { 100, 0, 0 }, { 0, 0, 50 + edge } },
    { { -50, 50, edge }, { 100, 0, 0 }, { 0, 8.816, 50 } } };
  Bench bench(MakeScene(roof));
  bench.Tripod->SetHeading(3);
  bench.Scanner->SetSamplingToTolerance();
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  CHECK(bench.Scanner->GetCount("subRays") == 16 * 1000);
  CHECK(
    Value(echoes, names::Range, 0) == Approx(50 / std::cos(3 * 0.017453292519943295)).margin(2e-4));
}

TEST_CASE("Tolerance: a wire before a wall of many triangles is found", "[Tolerance]")
{
  const bool hasWire = GENERATE(false, true);
  std::vector<Rectangle> scene;
  for (int i = -1000; i < 1000; ++i)
  {
    scene.push_back({ { 4e-5 * i, 50, -1 }, { 4e-5, 0, 0 }, { 0, 0, 2 } });
  }
  if (hasWire)
  {
    scene.push_back({ { 0.003, 48, -1 }, { 0.001, 0, 0 }, { 0, 0, 2 } }); // 3 % of the energy
  }
  Bench bench(MakeScene(scene));
  bench.Scanner->SetSamplingToTolerance();
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(6e-4);
  bench.Scanner->GetEchoDetector()->SetDetectionThreshold(0.0);
  CHECK(bench.Run()->GetNumberOfPoints() == (hasWire ? 2000 : 1000));
  CHECK(bench.Scanner->GetCount("pulsesUnresolved") == 0);
}

TEST_CASE("Tolerance: energies are of the beam without its rim", "[Tolerance]")
{
  // The square |x|, |z| < h before the sky returns erf(sqrt(2) h / w)^2 of the beam, whose energy
  // within K w is 1 - exp(-2 K^2).
  const double h = 0.005;
  const double w = 0.025; // at 50 m
  const auto [range, energy, rim] = GENERATE(table<double, double, double>(
    { { 1e-3, 1e-2, 0.0 }, { 3e-3, 3e-2, 4.5e-3 }, { 1e-2, 1e-1, 1.5e-2 } }));
  Bench bench(MakeScene({ { { -h, 50, -h }, { 2 * h, 0, 0 }, { 0, 0, 2 * h } } }));
  Bench full(MakeScene({ Wall(50) }));
  for (Bench* each : { &bench, &full })
  {
    each->Scanner->SetSamplingToTolerance();
    each->Scanner->SetRangeTolerance(range);
    each->Scanner->SetEnergyTolerance(energy);
    each->Scanner->GetBeamSampler()->SetBeamDivergence(1e-3);
    each->Scanner->GetEchoDetector()->SetDetectionThreshold(0.0);
    REQUIRE(each->Run()->GetNumberOfPoints() == 1000);
  }
  const double share = std::pow(std::erf(std::sqrt(2.0) * h / w), 2) / (1.0 - std::exp(-4.5));
  const double amplitude = Value(bench.Run(), names::Amplitude, 0);
  CAPTURE(energy);
  CHECK(amplitude / Value(full.Run(), names::Amplitude, 0) ==
    Approx(share / (1.0 - rim)).epsilon(1e-4));
}

TEST_CASE("Tolerance: the range gate is an edge on one triangle", "[Tolerance]")
{
  // Steep, off the diagonal; the axis hits it at 60 m.
  Bench bench(MakeScene({ { { -20, 40, -50 }, { 40, 40, 0 }, { 0, 0, 90 } } }));
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(2e-3);
  bench.Scanner->SetRangeMax(60.01);
  bench.Scanner->GetBeamSampler()->SetPatternToVogel();
  bench.Scanner->GetBeamSampler()->SetNumberOfSubRays(4096);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  const double range = Value(echoes, names::Range, 0);
  const double amplitude = Value(echoes, names::Amplitude, 0);

  bench.Scanner->SetSamplingToTolerance();
  echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  CHECK(bench.Scanner->GetCount("pulsesSampled") == 0);
  CHECK(Value(echoes, names::Range, 0) == Approx(range).epsilon(0).margin(1e-3));
  CHECK(Value(echoes, names::Amplitude, 0) == Approx(amplitude).epsilon(1e-2));
}

TEST_CASE("Tolerance: a plane has one echo at any incidence", "[Tolerance]")
{
  for (const double q : { 0.5, 2.0, 4.0, 6.0, 8.0, 10.0, 14.0 })
  {
    for (const double tolerance : { 1e-3, 3e-3, 1e-2 })
    {
      CheckSteepPlane(q, false, tolerance);
      CheckSteepPlane(q, true, tolerance);
    }
  }
}

TEST_CASE("Tolerance: the method does not depend on the requested outputs", "[Tolerance]")
{
  const auto scene = MakeSteps();
  Sweep sweep(scene);
  sweep.Scanner->SetSamplingToTolerance();
  vtkNew<vtkPolyData> alone;
  alone->DeepCopy(sweep.Run());
  sweep.Scanner->GenerateWaveformsOn();
  sweep.Scanner->GenerateSubRaysOn();
  sweep.Scanner->GeneratePulsesOn();
  vtkPolyData* together = sweep.Run();
  REQUIRE(together->GetNumberOfPoints() == alone->GetNumberOfPoints());
  for (vtkIdType i = 0; i < alone->GetNumberOfPoints(); ++i)
  {
    REQUIRE(Value(together, names::Range, i) == Value(alone, names::Range, i));
    REQUIRE(Value(together, names::WaveformIds, i) == Value(together, names::PulseIds, i));
  }
  // Every pulse with an echo has a waveform, and its sub-rays' weights are at most 1.
  auto* table = vtkTable::SafeDownCast(sweep.Scanner->GetOutputDataObject(1));
  CHECK(table->GetNumberOfRows() == sweep.Scanner->GetCount("pulsesHit"));
  vtkPolyData* hits = sweep.Scanner->GetOutput(3);
  double sum = 0;
  for (vtkIdType i = 0; i < hits->GetNumberOfPoints(); ++i)
  {
    sum += Value(hits, names::Weight, i);
  }
  CHECK(sum <= sweep.Scanner->GetCount("pulsesHit") * (1 + 1e-12));
  CHECK(sum > 0.9 * sweep.Scanner->GetCount("pulsesHit"));
}

TEST_CASE("Fixed: the echoes do not depend on the requested outputs", "[Tolerance]")
{
  Sweep sweep(MakeSteps());
  sweep.Scanner->GetBeamSampler()->SetNumberOfRings(3);
  const auto getBytes = [&sweep]()
  {
    vtkNew<vtkPolyData> echoes;
    echoes->DeepCopy(sweep.Run());
    echoes->GetPointData()->RemoveArray(names::WaveformIds);
    return Bytes(echoes);
  };
  const std::string alone = getBytes();
  REQUIRE(alone.size() > 100000);
  sweep.Scanner->GenerateWaveformsOn();
  const bool isSame = getBytes() == alone;
  CHECK(isSame);
}

TEST_CASE(
  "Tolerance: byte-identical for any number of threads, pieces, and ray caster", "[Tolerance]")
{
  const auto scene = MakeSteps();
  Sweep sweep(scene);
  sweep.Scanner->SetSamplingToTolerance();
  sweep.Scanner->SetRangeAccuracy(0.01);
  sweep.Scanner->SetAngleAccuracy(1e-5);
  vtkSMPTools::Initialize(1);
  const std::string one = Bytes(sweep.Run());
  REQUIRE(one.size() > 100000);
  vtkSMPTools::Initialize(2);
  sweep.Scanner->Modified();
  CHECK(Bytes(sweep.Run()) == one);
  vtkNew<vtkHeliosBvhRayCaster> bvh;
  sweep.Scanner->SetRayCaster(bvh);
  CHECK(Bytes(sweep.Run()) == one);
  vtkIdType points = 0;
  const vtkIdType all = sweep.Run()->GetNumberOfPoints();
  for (int piece = 0; piece < 3; ++piece)
  {
    sweep.Scanner->UpdatePiece(piece, 3, 0);
    points += sweep.Scanner->GetOutput()->GetNumberOfPoints();
  }
  CHECK(points == all);
}

TEST_CASE("Tolerance: a beam with a waist has the correct footprint at short range", "[Tolerance]")
{
  // 1550 nm, w = 0.15 mrad: w(10 m) = 3.6 mm, not 1.5 mm. An edge is 2 mm off the axis.
  const auto scene = MakeScene({ { { -5, 10, 0.002 }, { 10, 0, 0 }, { 0, 0, 5 } }, Wall(20) });
  Bench bench(scene);
  bench.Scanner->SetSamplingToTolerance();
  bench.Scanner->SetEnergyTolerance(1e-3);
  bench.Scanner->SetAtmosphericExtinction(0);
  bench.Scanner->SetDuration(1e-5);
  vtkHeliosBeamSampler* sampler = bench.Scanner->GetBeamSampler();
  sampler->SetBeamDivergence(0.3e-3);
  sampler->SetTruncation(3);
  CHECK(Value(bench.Run(), names::NumberOfReturns, 0) == 2); // 2 mm are 1.3 w
  const double energy = 4 * 0.99 * 0.5 * 0.25 * 0.0225 / 100;
  CHECK(Value(bench.Run(), names::Amplitude, 0) / energy ==
    Approx(0.5 * std::erfc(std::sqrt(2.0) * 0.002 / 0.0015)).margin(2e-3));
  sampler->SetBeamQualityFactor(1);
  sampler->SetWavelength(1550);
  CHECK(Value(bench.Run(), names::Amplitude, 0) / energy ==
    Approx(0.5 * std::erfc(std::sqrt(2.0) * 0.002 / 0.003615087)).margin(2e-3));
}

TEST_CASE("Tolerance: DescribeSampling reports the derived numbers", "[Tolerance]")
{
  Bench bench(MakeScene({ Wall(100) }));
  CHECK(bench.Scanner->DescribeSampling() == "fixed, 19 sub-rays per pulse");
  bench.Scanner->SetSamplingToTolerance();
  CHECK(
    bench.Scanner->DescribeSampling().find(
      "adaptive, visible areas of surfaces; beams full of leaves in 440 x 440 cells or more, of "
      "more than 512 surfaces in up to 1024 x 1024 cells; none for planar footprints; waveform "
      "bin ") == 0);
  bench.Scanner->SetRangeTolerance(1e-4);
  CHECK(bench.Scanner->DescribeSampling().find("adaptive, visible areas of surfaces; beams of more "
                                               "than 512 surfaces in up to 1024 x 1024") == 0);
  bench.Scanner->SetRangeTolerance(1e-3);
  bench.Scanner->SetMaximumNumberOfSubRays(1 << 20);
  CHECK(bench.Scanner->DescribeSampling().find("more than 2048 surfaces in up to 2048 x 2048") !=
    std::string::npos);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  CHECK(bench.Scanner->DescribeSampling() == "fixed, 1 sub-rays per pulse");
}
