// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosConstants.h"
#include "vtkHeliosScanner.h"

#include "heliosRadiometry.h"
#include "heliosScanRun.h"
#include "heliosScannerBench.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosLinearPathPlatform.h"
#include "vtkHeliosOscillatingMirror.h"
#include "vtkHeliosRotatingMirror.h"
#include "vtkHeliosSpinningChannels.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;

using namespace helios::testing;

TEST_CASE("Scanner: a perpendicular wall", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  CHECK(bench.Log->Errors.empty());
  // The range at the beam's edge is longer by R s^2 / 2, with less power: a few micrometres at
  // most.
  CHECK(Value(echoes, names::Range, 0) == Approx(100).epsilon(0).margin(3e-6));
  const helios::LidarEquation equation{ 0.15, 0.99, helios::AtmosphericExtinction(23, 1064) };
  CHECK(Value(echoes, names::Amplitude, 0) == Approx(4 * equation(100, 0.5, 1)).epsilon(1e-6));
  CHECK(Value(echoes, names::EchoWidth, 0) == Approx(4).epsilon(1e-5)); // error of float samples
  CHECK(Value(echoes, names::IncidenceAngle, 0) == Approx(0).margin(0.02));
  CHECK(Value(echoes, names::NumberOfReturns, 0) == 1);
  CHECK(Value(echoes, names::WaveformIds, 0) == -1);
  CHECK(Value(echoes, names::PulseIds, 999) == 999);
  CHECK(Value(echoes, names::GpsTime, 999) == 999 / 100000.0);
  CHECK(bench.Scanner->GetCount("pulsesFired") == 1000);
  std::istringstream names(vtkHeliosScanner::GetCountNames());
  int count = 0;
  for (std::string name; names >> name; ++count)
  {
    CHECK(bench.Scanner->GetCount(name) >= 0);
  }
  CHECK(count == 12);
  CHECK(bench.Scanner->GetCount("none") == -1);
}

TEST_CASE("Scanner: energy is independent of the number of sub-rays", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  const double reference = Value(bench.Run(), names::Amplitude, 0);
  for (const int circles : { 1, 2, 5, 10 })
  {
    bench.Scanner->GetBeamSampler()->SetNumberOfCircles(circles);
    CHECK(Value(bench.Run(), names::Amplitude, 0) == Approx(reference).epsilon(1e-6));
  }
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  vtkPolyData* echoes = bench.Run();
  CHECK(Value(echoes, names::Amplitude, 0) == Approx(reference).epsilon(1e-6));
  CHECK(Value(echoes, names::Range, 0) == 100.0);
}

TEST_CASE("Scanner: an inclined plane gives the range on the axis and a wider echo", "[Scanner]")
{
  const double angle = 75 * 0.017453292519943295;
  const Vec3 slope(0, std::sin(angle), std::cos(angle));
  const auto scene =
    MakeScene({ { Vec3(-50, 100, 0) - 50.0 * slope, { 100, 0, 0 }, 100.0 * slope } });
  Bench bench(scene);
  vtkHeliosBeamSampler* sampler = bench.Scanner->GetBeamSampler();
  sampler->SetBeamDivergence(1e-3); // w = 0.5 mrad
  sampler->SetTruncation(3);
  sampler->SetNumberOfCircles(60);
  bench.Scanner->SetDuration(1e-4);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 10);
  // Expected: sigma_t 1.809093830 ns and peak ratio 0.938947208 of the untruncated beam.
  CHECK(Value(echoes, names::Range, 0) == Approx(100).epsilon(0).margin(5e-4));
  CHECK(
    Value(echoes, names::EchoWidth, 0) == Approx(helios::FwhmPerSigma * 1.809093830).epsilon(2e-4));
  const helios::LidarEquation equation{ 0.15, 0.99, helios::AtmosphericExtinction(23, 1064) };
  const double flat = 4 * equation(100, 0.5, std::cos(angle));
  CHECK(Value(echoes, names::Amplitude, 0) / flat == Approx(0.938947208).epsilon(2e-3));
}

TEST_CASE("Scanner: an edge in the beam gives two echoes", "[Scanner]")
{
  // The upper half of the beam hits a wall at 50 m, the lower one at 60 m.
  const auto scene = MakeScene({ { { -50, 50, 0.0001 }, { 100, 0, 0 }, { 0, 0, 50 } }, Wall(60) });
  Bench bench(scene);
  bench.Scanner->GetBeamSampler()->SetNumberOfCircles(8);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 2000);
  CHECK(Value(echoes, names::ReturnNumber, 0) == 1);
  CHECK(Value(echoes, names::ReturnNumber, 1) == 2);
  CHECK(Value(echoes, names::NumberOfReturns, 0) == 2);
  CHECK(Value(echoes, names::Range, 0) == Approx(50).epsilon(0).margin(1e-5));
  CHECK(Value(echoes, names::Range, 1) == Approx(60).epsilon(0).margin(1e-5));
  CHECK(Value(echoes, names::CellIds, 0) < 2);
  CHECK(Value(echoes, names::CellIds, 1) >= 2);

  bench.Scanner->SetMaximumNumberOfReturns(1);
  echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  CHECK(Value(echoes, names::NumberOfReturns, 0) == 1);
  CHECK(Value(echoes, names::Range, 0) == Approx(50).epsilon(0).margin(1e-5));
}

TEST_CASE("Scanner: hits outside the range gate block the sub-ray and return nothing", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(2), Wall(60) });
  Bench bench(scene);
  bench.Scanner->SetRangeMin(5);
  CHECK(bench.Run()->GetNumberOfPoints() == 0);
  CHECK(bench.Scanner->GetCount("hitsOutOfRange") == 19000);
  bench.Scanner->SetRangeMin(1);
  CHECK(bench.Run()->GetNumberOfPoints() == 1000);
  bench.Scanner->SetRangeMax(1.5);
  CHECK(bench.Run()->GetNumberOfPoints() == 0);
}

TEST_CASE("Scanner: the threshold, and the strongest signal below it", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  bench.Scanner->GetEchoDetector()->SetDetectionThreshold(1);
  CHECK(bench.Run()->GetNumberOfPoints() == 0);
  CHECK(bench.Scanner->GetCount("pulsesHit") == 1000);
  CHECK(bench.Scanner->GetLargestAmplitude() == Approx(4 * 2.494996110359e-07 * 1.1).epsilon(1e-4));
}

TEST_CASE("Scanner: range noise is normal, and the truth is without it", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  bench.Scanner->SetDuration(0.2);
  bench.Scanner->SetRangeAccuracy(0.02);
  bench.Scanner->SetSeed(5);
  vtkPolyData* echoes = bench.Run();
  const vtkIdType n = echoes->GetNumberOfPoints();
  REQUIRE(n == 20000);
  double sum = 0, sum2 = 0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double x = (Value(echoes, names::Range, i) - 100) / 0.02;
    sum += x;
    sum2 += x * x;
    CHECK(echoes->GetPoint(i)[1] == Approx(Value(echoes, names::Range, i)).epsilon(1e-15));
  }
  CHECK(std::abs(sum / n) < 5 / std::sqrt(1.0 * n));
  CHECK(std::abs(sum2 / n - 1) < 5 * std::sqrt(2.0 / n));
}

TEST_CASE("Scanner: byte-identical for any number of threads and pieces", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(60), { { -50, 50, 0.0001 }, { 100, 0, 0 }, { 0, 0, 50 } } });
  Bench bench(scene);
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetMirrorAngle(30);
  bench.Scanner->SetBeamDeflector(mirror);
  bench.Scanner->SetDuration(0.3);
  bench.Scanner->SetRangeAccuracy(0.01);
  bench.Scanner->SetHeadRotateSpeed(20);

  vtkSMPTools::Initialize(1);
  const std::string one = Bytes(bench.Run());
  REQUIRE(one.size() > 1000000);
  vtkSMPTools::Initialize(2);
  bench.Scanner->Modified();
  CHECK(Bytes(bench.Run()) == one);

  for (const int pieces : { 2, 7 })
  {
    std::vector<std::string> arrays;
    for (int piece = 0; piece < pieces; ++piece)
    {
      bench.Scanner->UpdatePiece(piece, pieces, 0);
      vtkPointData* data = bench.Scanner->GetOutput()->GetPointData();
      arrays.resize(static_cast<std::size_t>(data->GetNumberOfArrays()) + 1);
      for (std::size_t a = 0; a < arrays.size(); ++a)
      {
        vtkDataArray* array = a == 0 ? bench.Scanner->GetOutput()->GetPoints()->GetData()
                                     : data->GetArray(static_cast<int>(a) - 1);
        arrays[a].append(static_cast<const char*>(array->GetVoidPointer(0)),
          static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
      }
    }
    std::string together;
    for (const std::string& array : arrays)
    {
      together += array;
    }
    CHECK(together == one);
  }
}

TEST_CASE("Scanner: byte-identical for every ray caster", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(60), { { -50, 50, 0.0001 }, { 100, 0, 0 }, { 0, 0, 50 } } });
  Bench bench(scene);
  const std::string byDefault = Bytes(bench.Run());
  vtkNew<vtkHeliosBvhRayCaster> bvh;
  bench.Scanner->SetRayCaster(bvh);
  CHECK(Bytes(bench.Run()) == byDefault);
}

TEST_CASE("Scanner: time windows contain every pulse once", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  vtkIdType next = 0;
  const std::array<double, 5> borders{ 0.0, 0.00123, 0.0033300001, 0.007, 1.0 };
  for (std::size_t w = 0; w + 1 < borders.size(); ++w)
  {
    bench.Scanner->SetTimeWindow(borders[w], borders[w + 1]);
    vtkPolyData* echoes = bench.Run();
    for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
    {
      REQUIRE(Value(echoes, names::PulseIds, i) == static_cast<double>(next++));
    }
    CHECK(bench.Scanner->GetNumberOfPulses() == echoes->GetNumberOfPoints());
  }
  CHECK(next == 1000);
}

TEST_CASE("Scanner: pulse windows contain every pulse once, also with time windows", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  vtkIdType next = 0;
  const std::array<vtkIdType, 5> borders{ 0, 1, 333, 333, VTK_ID_MAX };
  for (std::size_t w = 0; w + 1 < borders.size(); ++w)
  {
    bench.Scanner->SetPulseWindow(borders[w], borders[w + 1]);
    vtkPolyData* echoes = bench.Run();
    for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
    {
      REQUIRE(Value(echoes, names::PulseIds, i) == static_cast<double>(next++));
    }
    CHECK(bench.Scanner->GetNumberOfPulses() == echoes->GetNumberOfPoints());
  }
  CHECK(next == 1000);
  const double end = bench.Scanner->GetBeamDeflector()->GetPulseFrequency();
  bench.Scanner->SetTimeWindow(100 / end, 200 / end);
  for (const auto& [first, count] :
    { std::pair<vtkIdType, vtkIdType>{ 0, 100 }, { 150, 50 }, { 200, 0 }, { 5000, 0 } })
  {
    bench.Scanner->SetPulseWindow(first, 7000);
    CHECK(bench.Scanner->GetNumberOfPulses() == count);
  }
}

TEST_CASE(
  "Scanner: mount and head rotate the beam, lever arms rotate with the attitude", "[Scanner]")
{
  // Platform at (10, 20, 5) facing west; mount 1 m to its right and 2 m up, tilted up by 90
  // degrees.
  const auto ceiling = MakeScene({ { { -50, -50, 40 }, { 200, 0, 0 }, { 0, 200, 0 } } });
  Bench bench(ceiling, { 10, 20, 5 });
  bench.Tripod->SetHeading(-90);
  bench.Scanner->SetMountPosition(1, 0, 2);
  const helios::Quaternion up = helios::AxisAngle({ 1, 0, 0 }, 90);
  bench.Scanner->SetMountOrientation(up[0], up[1], up[2], up[3]);
  bench.Scanner->SetBeamOrigin(0, 0.5, 0); // along the beam: upwards
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  bench.Scanner->GeneratePulsesOn();
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  vtkPolyData* pulses = bench.Scanner->GetOutput(2);
  REQUIRE(pulses->GetNumberOfPoints() == 1000);
  double origin[3];
  pulses->GetPoint(0, origin);
  CHECK(origin[0] == Approx(10).epsilon(1e-14));
  CHECK(origin[1] == Approx(21).epsilon(1e-14)); // the right of a platform facing west is north
  CHECK(origin[2] == Approx(7.5).epsilon(1e-14));
  CHECK(Value(echoes, names::Range, 0) == Approx(32.5).epsilon(1e-14));
  CHECK(Value(pulses, names::Hit, 0) == 1);
}

TEST_CASE("Scanner: the head rotates at its speed and ends the scan", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(10, 100) });
  Bench bench(scene);
  bench.Scanner->SetDuration(-1);
  bench.Scanner->SetHeadRotateStart(-30);
  bench.Scanner->SetHeadRotateStop(30);
  bench.Scanner->SetHeadRotateSpeed(600);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  CHECK(bench.Scanner->GetNumberOfPulses() == 10000); // 0.1 s at 100 kHz
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 10000);
  // right-handed about z: -30 degrees is to the right
  double p[3];
  echoes->GetPoint(0, p);
  CHECK(p[0] == Approx(10 * std::tan(30 * 0.017453292519943295)).epsilon(1e-13));
  echoes->GetPoint(5000, p);
  CHECK(p[0] == Approx(0).margin(1e-13));
}

TEST_CASE("Scanner: on a moving platform every pulse has its own origin and time", "[Scanner]")
{
  const auto scene = MakeScene({ { { -100, -100, 0 }, { 300, 0, 0 }, { 0, 300, 0 } } });
  vtkNew<vtkHeliosLinearPathPlatform> platform;
  platform->SetInputData(MakeWaypoints({ { 0, 0, 50 }, { 0, 100, 50 } }, 20.0));
  Bench bench(scene);
  bench.Scanner->SetInputConnection(1, platform->GetOutputPort());
  bench.Scanner->SetDuration(-1);
  bench.Deflector->SetPulseFrequency(1000);
  const helios::Quaternion down = helios::AxisAngle({ 1, 0, 0 }, -90);
  bench.Scanner->SetMountOrientation(down[0], down[1], down[2], down[3]);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 5000);
  for (const vtkIdType i : { 0, 1, 2499, 4999 })
  {
    CHECK(Value(echoes, names::GpsTime, i) == i / 1000.0);
    CHECK(echoes->GetPoint(i)[1] == Approx(0.02 * i).margin(1e-12));
    CHECK(Value(echoes, names::Range, i) == 50.0);
  }
  bench.Scanner->SetPoseInterval(0.5); // 10 m
  echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 5000);
  for (const vtkIdType i : { 0, 1, 499, 500, 2499, 4999 })
  {
    CHECK(Value(echoes, names::GpsTime, i) == i / 1000.0);
    CHECK(echoes->GetPoint(i)[1] == Approx(10.0 * (i / 500)).margin(1e-12));
  }
}

TEST_CASE(
  "Scanner: merged returns are one echo with their energy, at their mean range", "[Scanner]")
{
  // The upper half of the beam hits a wall at 50 m, the lower one at 60 m.
  const auto edge = MakeScene({ { { -50, 50, 0 }, { 100, 0, 0 }, { 0, 0, 50 } }, Wall(60) });
  const auto nearWall = MakeScene({ Wall(50) });
  const auto farWall = MakeScene({ Wall(60) });
  for (const bool isAdaptive : { false, true })
  {
    const auto run = [isAdaptive](vtkPolyData* scene)
    {
      Bench bench(scene);
      bench.Scanner->SetSampling(
        isAdaptive ? vtkHeliosScanner::TOLERANCE : vtkHeliosScanner::FIXED);
      bench.Scanner->GetBeamSampler()->SetPatternToVogel();
      bench.Scanner->GetBeamSampler()->SetNumberOfSubRays(1024);
      bench.Scanner->MergeReturnsOn();
      bench.Scanner->GenerateWaveformsOn();
      auto echoes = vtkSmartPointer<vtkPolyData>::New();
      echoes->ShallowCopy(bench.Run());
      auto* waveforms = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
      CHECK(waveforms->GetNumberOfRows() == 1000); // still stored
      return echoes;
    };
    const auto echoes = run(edge);
    const double first = Value(run(nearWall), names::Amplitude, 0);
    const double second = Value(run(farWall), names::Amplitude, 0);
    INFO("adaptive " << isAdaptive);
    REQUIRE(echoes->GetNumberOfPoints() == 1000); // not two
    CHECK(Value(echoes, names::NumberOfReturns, 0) == 1);
    CHECK(Value(echoes, names::Amplitude, 0) == Approx(0.5 * (first + second)).epsilon(2e-3));
    const double mean = (50.0 * first + 60.0 * second) / (first + second);
    CHECK(Value(echoes, names::Range, 0) == Approx(mean).epsilon(0).margin(0.02));
    CHECK(Value(echoes, names::EchoWidth, 0) > 5.0 * 4.0);
  }
  // The energy of a wide echo is not spread.
  const auto slope = MakeScene({ { { -500, -440, -500 }, { 1000, 0, 0 }, { 0, 1000, 1000 } } });
  Bench bench(slope);
  bench.Scanner->SetSamplingToTolerance();
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0.02);
  const double plain = Value(bench.Run(), names::Amplitude, 0);
  bench.Scanner->MergeReturnsOn();
  CHECK(Value(bench.Run(), names::Amplitude, 0) > 1.1 * plain);

  bench.Scanner->GetEchoDetector()->SetDetectionThreshold(1.0);
  CHECK(bench.Run()->GetNumberOfPoints() == 0);
}

TEST_CASE("Scanner: waveforms, sub-rays and pulses only on request", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(30) });
  Bench bench(scene);
  bench.Run();
  CHECK(vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1))->GetNumberOfRows() == 0);
  CHECK(bench.Scanner->GetOutput(2)->GetNumberOfPoints() == 0);
  CHECK(bench.Scanner->GetOutput(3)->GetNumberOfPoints() == 0);

  bench.Scanner->GenerateWaveformsOn();
  bench.Scanner->GenerateSubRaysOn();
  vtkPolyData* echoes = bench.Run();
  auto* table = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
  REQUIRE(table->GetNumberOfRows() == 1000);
  CHECK(bench.Scanner->GetOutput(3)->GetNumberOfPoints() == 19000);
  CHECK(Value(echoes, names::WaveformIds, 7) == 7);

  // The largest sample is at two-way time.
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  const vtkIdType first = table->GetValueByName(7, names::Offset).ToTypeInt64();
  const vtkIdType count = table->GetValueByName(7, names::Count).ToTypeInt64();
  vtkIdType best = first;
  for (vtkIdType i = first; i < first + count; ++i)
  {
    best = samples->GetComponent(i, 0) > samples->GetComponent(best, 0) ? i : best;
  }
  const double time = table->GetValueByName(7, names::StartTime).ToDouble() + 0.25 * (best - first);
  CHECK(time == Approx(2 * 30 / 0.299792458).epsilon(0).margin(0.126));
}

TEST_CASE("Scanner: echoes have the flags of their scan line on request", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(60) });
  Bench bench(scene);
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  mirror->SetScanFrequency(400.0);
  mirror->SetScanAngle(10.0);
  bench.Scanner->SetBeamDeflector(mirror);
  CHECK_FALSE(bench.Run()->GetPointData()->HasArray(names::EdgeOfFlightLine));
  bench.Scanner->GenerateScanFlagsOn();
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  CHECK(
    echoes->GetPointData()->GetArray(names::ScanDirectionFlag)->GetDataType() == VTK_UNSIGNED_CHAR);
  int edges = 0;
  for (vtkIdType row = 0; row < 1000; ++row)
  {
    const auto pulse = static_cast<vtkIdType>(Value(echoes, names::PulseIds, row));
    REQUIRE(Value(echoes, names::ScanDirectionFlag, row) == mirror->GetScanDirectionFlag(pulse));
    const double edge = Value(echoes, names::EdgeOfFlightLine, row);
    REQUIRE(edge == (mirror->IsEdgeOfFlightLine(pulse) ? 1.0 : 0.0));
    edges += edge > 0.0 ? 1 : 0;
  }
  CHECK(edges == 8); // 10 ms
}

TEST_CASE(
  "Scanner: records of several batches are in order, and equal those of windows", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(60), { { -50, 50, 0.0001 }, { 100, 0, 0 }, { 0, 0, 50 } } });
  Bench bench(scene);
  vtkSMPTools::Initialize(2);
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetMirrorAngle(30);
  bench.Scanner->SetBeamDeflector(mirror);
  bench.Scanner->SetDuration(0.7);
  bench.Scanner->GetBeamSampler()->SetNumberOfCircles(2);
  bench.Scanner->GenerateWaveformsOn();
  bench.Scanner->GeneratePulsesOn();
  bench.Scanner->GenerateSubRaysOn();
  bench.Scanner->GenerateTruthOn();
  vtkPolyData* echoes = bench.Run();
  const auto getTable = [&bench]
  { return vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1)); };
  vtkTable* table = getTable();
  REQUIRE(bench.Scanner->GetOutput(2)->GetNumberOfPoints() == 70000); // 16384 per thread, batch
  REQUIRE(bench.Scanner->GetOutput(3)->GetNumberOfPoints() == 7 * 70000);
  REQUIRE(table->GetNumberOfRows() == 70000);
  REQUIRE(echoes->GetPointData()->GetArray(names::TruePoint)->GetNumberOfTuples() ==
    echoes->GetNumberOfPoints());
  vtkIdType samples = 0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    REQUIRE(table->GetValueByName(row, names::PulseIds).ToTypeInt64() == row);
    REQUIRE(table->GetValueByName(row, names::Offset).ToTypeInt64() == samples);
    REQUIRE(Value(bench.Scanner->GetOutput(2), names::PulseIds, row) == static_cast<double>(row));
    samples += table->GetValueByName(row, names::Count).ToTypeInt64();
  }
  const auto getSamples = [&getTable]
  {
    vtkDataArray* array = getTable()->GetFieldData()->GetArray(names::Samples);
    return std::string(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues()) * sizeof(float));
  };
  const std::string whole = getSamples();
  REQUIRE(whole.size() == static_cast<std::size_t>(samples) * sizeof(float));
  CHECK(table->GetFieldData()->GetArray(names::PulseLength)->GetNumberOfTuples() == 1);
  const double last = Value(echoes, names::Range, echoes->GetNumberOfPoints() - 1);

  std::string windows;
  for (const auto& [first, end] : { std::pair<vtkIdType, vtkIdType>{ 0, 30000 }, { 30000, 60000 },
         { 60000, 70000 } }) // each in one batch
  {
    bench.Scanner->SetPulseWindow(first, end);
    echoes = bench.Run();
    windows += getSamples();
  }
  CHECK(windows == whole);
  CHECK(Value(echoes, names::Range, echoes->GetNumberOfPoints() - 1) == last);
}

TEST_CASE("Scanner: a UTM offset moves the cloud and changes nothing else", "[Scanner]")
{
  const Vec3 shift(500000, 5500000, 300);
  const Rectangle wall = Wall(100);
  const auto near = MakeScene({ wall });
  const auto far = MakeScene({ { wall.Corner + shift, wall.A, wall.B } });
  Bench a(near), b(far, shift);
  vtkPolyData* local = a.Run();
  vtkPolyData* world = b.Run();
  REQUIRE(local->GetNumberOfPoints() == world->GetNumberOfPoints());
  for (const vtkIdType i : { 0, 500 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK(std::abs(world->GetPoint(i)[axis] - shift[axis] - local->GetPoint(i)[axis]) < 1e-8);
    }
  }
}

TEST_CASE("Scanner: only changed parts execute again", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  bench.Run();
  const vtkMTimeType before = bench.Scanner->GetOutput()->GetMTime();
  bench.Run();
  CHECK(bench.Scanner->GetOutput()->GetMTime() == before);
  bench.Deflector->SetPulseFrequency(50000);
  CHECK(bench.Run()->GetNumberOfPoints() == 500);
}

TEST_CASE("Scanner: channels of a spinning head have their own ids and times", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(10, 100) });
  Bench bench(scene);
  vtkNew<vtkHeliosSpinningChannels> head;
  head->SetNumberOfChannels(4);
  for (int c = 0; c < 4; ++c)
  {
    head->SetElevation(c, 2.0 * c - 3.0);
    head->SetFiringTime(c, 1e-6 * c);
  }
  head->SetPulseFrequency(40000); // cycles of four at 10 kHz
  head->SetScanFrequency(0);
  bench.Scanner->SetBeamDeflector(head);
  bench.Scanner->SetChannelId(10);
  bench.Scanner->GeneratePulsesOn();
  bench.Scanner->GenerateWaveformsOn();
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 400);
  auto* table = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
  for (const vtkIdType i : { 0, 1, 2, 3, 399 })
  {
    const auto channel = static_cast<double>(i % 4);
    CHECK(Value(echoes, names::ChannelIds, i) == 10 + channel);
    CHECK(Value(bench.Scanner->GetOutput(2), names::ChannelIds, i) == 10 + channel);
    CHECK(table->GetValueByName(i, names::ChannelIds).ToInt() == 10 + i % 4);
    CHECK(Value(echoes, names::GpsTime, i) ==
      Approx(static_cast<double>(i / 4) / 10000 + 1e-6 * channel).epsilon(1e-12));
    CHECK(echoes->GetPoint(i)[2] / echoes->GetPoint(i)[1] ==
      Approx(std::tan((2 * channel - 3) * 0.017453292519943295)).epsilon(1e-12));
  }
}

TEST_CASE(
  "Scanner: a scan is watched by the thread that runs it, and stops all of them", "[Scanner]")
{
  std::vector<double> shares;
  bool goesOn = true;
  const helios::RunWatcher watcher = [&](double share)
  {
    shares.push_back(share);
    return goesOn;
  };
  helios::WorkWatch watch(watcher, 200);
  CHECK(watch.Report());
  std::thread([&watch] { watch.Count(50); }).join(); // does not report
  CHECK(shares == std::vector<double>{ 0.0 });
  watch.Count(50); // at once: too early
  CHECK(shares.size() == 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  goesOn = false;
  watch.Count(20);
  CHECK(shares == std::vector<double>{ 0.0, 0.6 });
  CHECK(watch.IsStopped());
  CHECK_FALSE(watch.Report()); // the watcher is not called again
  CHECK(shares.size() == 2);
}

TEST_CASE("Scanner: batches grow while they are fast and small", "[Scanner]")
{
  helios::BatchSize batch(2);
  CHECK(batch.GetChunks() == 2); // the first measures the cost of pulses
  CHECK(batch.GetMaximumPulses() == 16);
  for (vtkIdType pulses : { 64, 256 })
  {
    batch.Adapt(0.001, 1000);
    CHECK(batch.GetMaximumPulses() == pulses);
    CHECK(batch.GetChunks() == 2);
  }
  for (vtkIdType chunks : { 8, 32, 128, 128 })
  {
    batch.Adapt(0.001, 1000);
    CHECK(batch.GetChunks() == chunks);
  }
  batch.Adapt(0.2, 1000); // neither long nor short
  CHECK(batch.GetChunks() == 128);
  batch.Adapt(2.0, 1000);
  CHECK(batch.GetChunks() == 64);
  batch.Adapt(0.001, std::size_t(1) << 29);
  CHECK(batch.GetChunks() == 32);
  for (int i = 0; i < 5; ++i)
  {
    CHECK(batch.GetMaximumPulses() == 256);
    batch.Adapt(100.0, 0);
  }
  CHECK(batch.GetChunks() == 2);
  for (vtkIdType pulses : { 64, 32, 16, 8, 4, 2, 1, 1 })
  {
    batch.Adapt(100.0, 0);
    CHECK(batch.GetMaximumPulses() == pulses);
  }
}
