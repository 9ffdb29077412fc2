// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Pulses into turbid voxels, against the Beer-Lambert law.
#include "heliosMaterialTable.h"
#include "heliosScannerBench.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace helios::testing;
using helios::Vec3;
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr int Pulses = 100000;

/// Cells of 0.5 m across the y axis, from a distance, of one density.
vtkSmartPointer<vtkImageData> MakeSlab(double from, double thickness, double density)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int deep = static_cast<int>(std::lround(2.0 * thickness));
  image->SetDimensions(5, deep + 1, 5);
  image->SetSpacing(0.5, 0.5, 0.5);
  image->SetOrigin(-1.0, from, -1.0);
  vtkNew<vtkDoubleArray> pad;
  pad->SetName(names::PAD);
  pad->SetNumberOfValues(image->GetNumberOfCells());
  pad->FillValue(density);
  image->GetCellData()->AddArray(pad);
  return image;
}

/// A bench whose pulses are single rays, with a slab before it.
struct TurbidBench : Bench
{
  TurbidBench(vtkPolyData* scene, vtkImageData* slab, vtkIdType pulses = Pulses)
    : Bench(scene)
  {
    this->Scanner->AddInputDataObject(2, slab);
    this->Scanner->GetBeamSampler()->SetBeamDivergence(0.0);
    this->Scanner->SetDuration(static_cast<double>(pulses) / this->Deflector->GetPulseFrequency());
    this->Scanner->SetSeed(42);
  }
};

struct Moments
{
  double Count = 0.0;
  double Mean = 0.0;
  double Variance = 0.0;
};

/// Computes the moments of the values of a column below a limit.
Moments MeasureBelow(vtkPolyData* echoes, const char* name, double limit)
{
  Moments m;
  double sum = 0.0;
  double squares = 0.0;
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    const double value = Value(echoes, name, i);
    if (value < limit)
    {
      ++m.Count;
      sum += value;
      squares += value * value;
    }
  }
  m.Mean = sum / m.Count;
  m.Variance = squares / m.Count - m.Mean * m.Mean;
  return m;
}

} // namespace

TEST_CASE("Scanner: the transmission of a turbid slab is exp(-k L)", "[ScannerTurbid]")
{
  const double k = 0.5 * 1.2; // G PAD
  const double depth = 2.0;
  TurbidBench bench(MakeScene({ Wall(20.0) }), MakeSlab(10.0, depth, 1.2));
  vtkPolyData* echoes = bench.Run();
  INFO(bench.Log->Errors);
  REQUIRE(echoes->GetNumberOfPoints() == Pulses);
  const Moments leaves = MeasureBelow(echoes, names::Range, 15.0);
  const double stopped = 1.0 - std::exp(-k * depth);
  const double sigma = std::sqrt(Pulses * stopped * (1.0 - stopped));
  CHECK(std::abs(leaves.Count - Pulses * stopped) < 4.0 * sigma);
  // Mean and variance of an exponential truncated at the depth of the slab.
  const double rest = depth * (1.0 - stopped) / stopped;
  const double mean = 1.0 / k - rest;
  const double variance = 1.0 / (k * k) - depth * depth * (1.0 - stopped) / (stopped * stopped);
  CHECK(std::abs(leaves.Mean - 10.0 - mean) < 4.0 * std::sqrt(variance / leaves.Count));
  CHECK(leaves.Variance == Approx(variance).epsilon(0.02));
}

TEST_CASE(
  "Scanner: first-leaf depths of a deep medium have mean 1/k and variance 1/k^2", "[ScannerTurbid]")
{
  const double k = 0.5 * 3.0;
  TurbidBench bench(MakeScene({ Wall(40.0) }), MakeSlab(10.0, 20.0, 3.0));
  const Moments leaves = MeasureBelow(bench.Run(), names::Range, 35.0);
  REQUIRE(leaves.Count == Pulses); // except exp(-30)
  CHECK(std::abs(leaves.Mean - 10.0 - 1.0 / k) < 4.0 / (k * std::sqrt(Pulses)));
  CHECK(leaves.Variance == Approx(1.0 / (k * k)).epsilon(0.03));
}

TEST_CASE("Scanner: leaves in front of a wall, also around the scanner", "[ScannerTurbid]")
{
  // The wall and the scanner are in the slab: 3 m of leaves are left.
  const double k = 0.5 * 0.8;
  TurbidBench bench(MakeScene({ Wall(3.0) }), MakeSlab(-5.0, 10.0, 0.8));
  const Moments leaves = MeasureBelow(bench.Run(), names::Range, 3.0 - 1e-9);
  const double stopped = 1.0 - std::exp(-k * 3.0);
  CHECK(std::abs(leaves.Count - Pulses * stopped) <
    4.0 * std::sqrt(Pulses * stopped * (1.0 - stopped)));
}

TEST_CASE("Scanner: overlapping grids add up", "[ScannerTurbid]")
{
  TurbidBench bench(MakeScene({ Wall(20.0) }), MakeSlab(10.0, 2.0, 0.5));
  bench.Scanner->AddInputDataObject(2, MakeSlab(10.0, 2.0, 0.7));
  const Moments leaves = MeasureBelow(bench.Run(), names::Range, 15.0);
  const double stopped = 1.0 - std::exp(-0.5 * 1.2 * 2.0);
  CHECK(std::abs(leaves.Count - Pulses * stopped) <
    4.0 * std::sqrt(Pulses * stopped * (1.0 - stopped)));
}

TEST_CASE("Scanner: a leaf returns the signal of a plane of its material", "[ScannerTurbid]")
{
  // So dense that every sub-ray stops at once: same echo as from a wall there.
  Bench wall(MakeScene({ Wall(10.0) }));
  TurbidBench dense(MakeScene({ Wall(20.0) }), MakeSlab(10.0, 1.0, 1e7), 1000);
  dense.Scanner->GetBeamSampler()->SetBeamDivergence(3e-4);
  for (const bool isFixed : { true, false })
  {
    for (Bench* bench : { &wall, static_cast<Bench*>(&dense) })
    {
      bench->Scanner->SetSampling(isFixed ? vtkHeliosScanner::FIXED : vtkHeliosScanner::TOLERANCE);
      bench->Run();
    }
    REQUIRE(dense.Scanner->GetOutput()->GetNumberOfPoints() == 1000);
    for (const char* name : { names::Range, names::Amplitude, names::EchoWidth })
    {
      const double truth = Value(wall.Scanner->GetOutput(), name, 0);
      CHECK(Value(dense.Scanner->GetOutput(), name, 0) == Approx(truth).epsilon(2e-5));
    }
    CHECK(Value(dense.Scanner->GetOutput(), names::IncidenceAngle, 0) == 0.0);
    CHECK(dense.Scanner->GetCount("pulsesOnPlane") == 0);
  }
}

TEST_CASE("Scanner: adaptive beams beside leaves detect them", "[ScannerTurbid]")
{
  // The head rotates from leaves to two walls alone, with an edge in all beams.
  const Rectangle upper{ { -50, 20, 1e-5 }, { 100, 0, 0 }, { 0, 0, 50 } };
  TurbidBench bench(MakeScene({ upper, Wall(30) }), MakeSlab(10.0, 1.0, 1e7), 200);
  bench.Scanner->SetSamplingToTolerance();
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(3e-4);
  bench.Scanner->SetHeadRotateStop(10.0);
  bench.Scanner->SetHeadRotateSpeed(5000.0);
  vtkPolyData* echoes = bench.Run();
  INFO(bench.Log->Errors);
  int beside = 0;
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    const double turn = vtkMath::RadiansFromDegrees(0.05 * Value(echoes, names::PulseIds, i));
    const double x = 10.0 * std::tan(turn); // leaves may begin here; they end at 1
    const double y = Value(echoes, names::Range, i) * std::cos(turn);
    CAPTURE(Value(echoes, names::PulseIds, i), x);
    if (x < 0.99)
    {
      CHECK(y == Approx(10.0).margin(1e-3));
    }
    if (x > 1.01)
    {
      const bool isFirst = Value(echoes, names::ReturnNumber, i) == 1;
      CHECK(Value(echoes, names::NumberOfReturns, i) == 2);
      CHECK(y == Approx(isFirst ? 20.0 : 30.0).margin(1e-3));
      ++beside;
    }
  }
  CHECK(beside > 160);
}

TEST_CASE("Scanner: the mean waveform of a turbid slab conserves energy", "[ScannerTurbid]")
{
  // Leaves and wall have the same reflectance, so the sum of power R^2 equals the wall's alone.
  TurbidBench bench(MakeScene({ Wall(20.0) }), MakeSlab(10.0, 2.0, 1.2), 1000);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(3e-4);
  bench.Scanner->GenerateSubRaysOn();
  bench.Run();
  vtkPolyData* hits = bench.Scanner->GetOutput(3);
  REQUIRE(hits->GetNumberOfPoints() == 19000);
  double leaves = 0.0;
  double all = 0.0;
  double squares = 0.0;
  for (vtkIdType i = 0; i < hits->GetNumberOfPoints(); ++i)
  {
    const double weight = Value(hits, names::Weight, i);
    all += weight;
    squares += weight * weight;
    leaves += Value(hits, names::Range, i) < 15.0 ? weight : 0.0;
  }
  CHECK(all == Approx(1000.0).epsilon(1e-12));
  // Each sub-ray has its own path: all of a pulse rarely stop.
  int pulsesStopped = 0;
  for (vtkIdType i = 0; i < hits->GetNumberOfPoints(); i += 19)
  {
    int count = 0;
    for (vtkIdType k = i; k < i + 19; ++k)
    {
      count += Value(hits, names::Range, k) < 15.0 ? 1 : 0;
    }
    pulsesStopped += count == 19 ? 1 : 0;
  }
  CHECK(pulsesStopped < 20);
  const double stopped = 1.0 - std::exp(-0.5 * 1.2 * 2.0);
  CHECK(std::abs(leaves - 1000.0 * stopped) < 4.0 * std::sqrt(squares * stopped * (1.0 - stopped)));
}

TEST_CASE("Scanner: wide beams have a sub-ray for each dm2 among leaves", "[ScannerTurbid]")
{
  const double stopped = 1.0 - std::exp(-0.5 * 1.2 * 2.0);
  for (const double diameter : { 1.0, 20.0 })
  {
    constexpr int pulses = 8;
    const auto slab = MakeSlab(100.0, 2.0, 1.2);
    slab->SetSpacing(20.0, 0.5, 20.0);
    slab->SetOrigin(-40.0, 100.0, -40.0);
    TurbidBench bench(
      MakeScene({ { { -90, 110, -90 }, { 180, 0, 0 }, { 0, 0, 180 } } }), slab, pulses);
    bench.Scanner->SetSamplingToTolerance();
    bench.Scanner->GetBeamSampler()->SetBeamDivergence(diameter / 100.0);
    bench.Scanner->GenerateSubRaysOn();
    bench.Run();
    INFO(bench.Log->Errors);
    vtkPolyData* hits = bench.Scanner->GetOutput(3);
    std::vector<double> all(pulses), leaves(pulses);
    for (vtkIdType i = 0; i < hits->GetNumberOfPoints(); ++i)
    {
      const auto pulse = static_cast<std::size_t>(Value(hits, names::PulseIds, i));
      const double weight = Value(hits, names::Weight, i);
      all[pulse] += weight;
      leaves[pulse] += Value(hits, names::Range, i) < 105.0 ? weight : 0.0;
    }
    const vtkIdType each = hits->GetNumberOfPoints() / pulses;
    CAPTURE(diameter, each);
    CHECK(each > (diameter < 2.0 ? 64 : 30000));
    CHECK(each < (diameter < 2.0 ? 4097 : 65537));
    for (std::size_t i = 0; i < pulses; ++i)
    {
      CHECK(leaves[i] / all[i] == Approx(stopped).margin(diameter < 2.0 ? 0.15 : 0.012));
    }
  }
}

TEST_CASE("Scanner: turbid voxels are independent of threads and pieces", "[ScannerTurbid]")
{
  TurbidBench bench(MakeScene({ Wall(20.0) }), MakeSlab(10.0, 2.0, 1.2), 5000);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(3e-4);
  bench.Scanner->SetSamplingToTolerance();
  const std::string whole = Bytes(bench.Run());
  vtkNew<vtkPolyData> last;
  std::string ids;
  vtkIdType count = 0;
  std::string ranges;
  const auto append = [](std::string& to, vtkDataArray* from)
  {
    to.append(static_cast<const char*>(from->GetVoidPointer(0)),
      static_cast<std::size_t>(from->GetNumberOfValues() * from->GetDataTypeSize()));
  };
  std::string wholeRanges;
  append(wholeRanges, bench.Scanner->GetOutput()->GetPointData()->GetArray(names::Range));
  const vtkIdType wholeCount = bench.Scanner->GetOutput()->GetNumberOfPoints();
  for (int piece = 0; piece < 3; ++piece)
  {
    bench.Scanner->UpdatePiece(piece, 3, 0);
    count += bench.Scanner->GetOutput()->GetNumberOfPoints();
    append(ranges, bench.Scanner->GetOutput()->GetPointData()->GetArray(names::Range));
  }
  CHECK(count == wholeCount);
  CHECK(ranges == wholeRanges);
  vtkSMPTools::Initialize(1);
  bench.Scanner->Modified();
  bench.Scanner->UpdatePiece(0, 1, 0);
  CHECK(Bytes(bench.Scanner->GetOutput()) == whole);
  vtkSMPTools::Initialize(0);
  bench.Scanner->SetSeed(43);
  CHECK(Bytes(bench.Run()) != whole);
}

TEST_CASE("Scanner: beams beside turbid voxels are unaffected", "[ScannerTurbid]")
{
  const auto run = [](bool hasVoxels)
  {
    Bench bench(MakeScene({ Wall(20.0) }));
    bench.Scanner->SetSamplingToTolerance();
    const auto slab = MakeSlab(10.0, 2.0, 1.2);
    slab->SetOrigin(1.0, 10.0, 0.0);
    if (hasVoxels)
    {
      bench.Scanner->AddInputDataObject(2, slab);
    }
    std::string bytes = Bytes(bench.Run());
    CHECK(bench.Scanner->GetCount("pulsesOnPlane") == 1000);
    return bytes;
  };
  CHECK(run(true) == run(false));
}

TEST_CASE(
  "Scanner: materials, parts and cells of voxels follow those of the scene", "[ScannerTurbid]")
{
  const auto scene = MakeScene({ Wall(20.0) });
  helios::Material stone;
  stone.Name = "stone";
  stone.Classification = 6;
  helios::SetMaterials(scene, { stone });
  vtkNew<vtkStringArray> parts;
  parts->SetName(names::PartName);
  parts->InsertNextValue("wall");
  scene->GetFieldData()->AddArray(parts);
  const auto slab = MakeSlab(10.0, 1.0, 1e7);
  helios::Material leaf;
  leaf.Name = "leaf";
  leaf.Classification = 4;
  leaf.Reflectance = 0.2;
  helios::Material needle = leaf;
  needle.Classification = 5;
  helios::SetMaterials(slab, { leaf, needle });
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  ids->SetNumberOfValues(slab->GetNumberOfCells());
  ids->FillValue(1);
  slab->GetCellData()->AddArray(ids);
  TurbidBench bench(scene, slab, 1000);
  bench.Scanner->GenerateTruthOn();
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  CHECK(Value(echoes, names::MaterialIds, 0) == 2);
  CHECK(Value(echoes, names::ClassificationIds, 0) == 5);
  CHECK(Value(echoes, names::PartIds, 0) == 1);
  const vtkIdType triangles = scene->GetNumberOfCells();
  CHECK(Value(echoes, names::CellIds, 0) == triangles + 2 + 2 * 4 * 2); // above x 0, z 0
  const double* normal = echoes->GetPointData()->GetArray(names::Normal)->GetTuple3(0);
  CHECK(Vec3(normal).Norm() == 0.0);
  auto* all =
    vtkStringArray::SafeDownCast(echoes->GetFieldData()->GetAbstractArray(names::PartName));
  REQUIRE(all);
  REQUIRE(all->GetNumberOfValues() == 2);
  CHECK(all->GetValue(0) == "wall");
  CHECK(all->GetValue(1) == "1");
}

TEST_CASE("Scanner: voxels without triangles", "[ScannerTurbid]")
{
  vtkNew<vtkPolyData> nothing;
  for (const double divergence : { 0.0, 3e-4 })
  {
    TurbidBench bench(nothing, MakeSlab(10.0, 1.0, 2.0), 1000);
    bench.Scanner->SetSamplingToTolerance();
    bench.Scanner->GetBeamSampler()->SetBeamDivergence(divergence);
    vtkPolyData* echoes = bench.Run();
    INFO(bench.Log->Errors);
    CHECK(bench.Log->Errors.empty());
    REQUIRE(echoes->GetNumberOfPoints() > 300);
    CHECK(MeasureBelow(echoes, names::Range, 11.0).Count == echoes->GetNumberOfPoints());
    CHECK(Value(echoes, names::PartIds, 0) == 0);
  }
}

TEST_CASE("Scanner: bad voxels are errors", "[ScannerTurbid]")
{
  const auto error = [](vtkImageData* slab)
  {
    TurbidBench bench(MakeScene({ Wall(20.0) }), slab, 10);
    bench.Run();
    return bench.Log->Errors;
  };
  CHECK_THAT(
    error(MakeSlab(10.0, 1.0, -1.0)), Catch::Contains("PAD of cell 0 of the voxels is -1"));
  const auto slab = MakeSlab(10.0, 1.0, 1.0);
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  ids->SetNumberOfValues(slab->GetNumberOfCells());
  ids->FillValue(3);
  slab->GetCellData()->AddArray(ids);
  CHECK_THAT(error(slab),
    Catch::Contains("MaterialIds of voxel grid 0 ranges from 3 to 3, but its field data has 1"));
  ids->SetNumberOfValues(2);
  CHECK_THAT(error(slab), Catch::Contains("of voxel grid 0 has 2 tuples"));
}

TEST_CASE("Scanner: leaves in fog are the same, and fainter by Beer's law", "[ScannerTurbid]")
{
  constexpr vtkIdType pulses = 2000;
  const auto wall = MakeScene({ Wall(20.0) });
  TurbidBench clear(wall, MakeSlab(10.0, 2.0, 1.2), pulses);
  clear.Scanner->SetAtmosphericExtinction(0.0);
  TurbidBench foggy(wall, MakeSlab(10.0, 2.0, 1.2), pulses);
  foggy.Scanner->SetAtmosphericExtinction(0.05);
  foggy.Scanner->SetAtmosphericLidarRatio(1e6); // a faint echo of the fog before each other
  foggy.Scanner->SetRangeMin(2.0);
  vtkPolyData* a = clear.Run();
  vtkPolyData* b = foggy.Run();
  REQUIRE(a->GetNumberOfPoints() == pulses);
  REQUIRE(b->GetNumberOfPoints() == 2 * pulses);
  double error = 0.0;
  for (vtkIdType i = 0; i < pulses; ++i)
  {
    const double range = Value(a, names::Range, i);
    const double fainter = Value(b, names::Amplitude, 2 * i + 1) / Value(a, names::Amplitude, i);
    error = std::max(error, std::abs(Value(b, names::Range, 2 * i + 1) - range) / 1e-3);
    error = std::max(error, std::abs(fainter / std::exp(-2.0 * 0.05 * range) - 1.0) / 1e-3);
    CHECK(Value(b, names::CellIds, 2 * i + 1) == Value(a, names::CellIds, i));
  }
  CHECK(error < 1.0); // in millimetres, and in thousandths
}
