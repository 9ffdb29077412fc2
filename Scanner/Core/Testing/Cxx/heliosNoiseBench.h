// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scanner whose platform has noise, for tests.

#ifndef heliosNoiseBench_h
#define heliosNoiseBench_h

#include "heliosScannerBench.h"
#include "vtkHeliosPlatformNoise.h"

#include <vtkSMPTools.h>

#include <catch2/catch.hpp>

#include <vector>

namespace helios::testing
{

/// A scanner facing a wall along y from a level tripod, without divergence.
struct NoiseBench : Bench
{
  vtkNew<vtkHeliosPlatformNoise> Noise;

  NoiseBench()
    : Bench(MakeScene({ Wall(40) }), { 1, 2, 3 })
  {
    this->Scanner->GetBeamSampler()->SetBeamDivergence(0);
    this->Scanner->SetPlatformNoise(this->Noise);
    this->Scanner->SetSeed(11);
    this->Scanner->SetFirstPulseId(5);
    this->Scanner->GeneratePulsesOn();
    this->Scanner->GenerateTruthOn();
  }

  vtkPolyData* Pulses() { return vtkPolyData::SafeDownCast(this->Scanner->GetOutputDataObject(2)); }
  double Time(vtkIdType row)
  {
    return Value(this->Scanner->GetOutput(), vtkHeliosArrayNames::GpsTime, row);
  }
  Vec3 TruePoint(vtkIdType row)
  {
    vtkDataArray* array =
      this->Scanner->GetOutput()->GetPointData()->GetArray(vtkHeliosArrayNames::TruePoint);
    return Vec3(array->GetTuple3(row));
  }
};

/// Checks that the points are the same with one and two threads, and in seven pieces; returns the
/// bytes of all.
inline std::string CheckThreadsAndPieces(Bench& bench)
{
  vtkSMPTools::Initialize(1);
  const std::string whole = Bytes(bench.Run());
  const vtkIdType count = bench.Scanner->GetOutput()->GetNumberOfPoints();
  std::vector<Vec3> points;
  for (vtkIdType i = 0; i < count; ++i)
  {
    points.emplace_back(bench.Scanner->GetOutput()->GetPoint(i));
  }
  vtkSMPTools::Initialize(2);
  bench.Scanner->Modified();
  CHECK(Bytes(bench.Run()) == whole);
  vtkIdType at = 0;
  for (int piece = 0; piece < 7; ++piece)
  {
    bench.Scanner->UpdatePiece(piece, 7, 0);
    vtkPolyData* part = bench.Scanner->GetOutput();
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i, ++at)
    {
      REQUIRE(Vec3(part->GetPoint(i)) == points[static_cast<std::size_t>(at)]);
    }
  }
  CHECK(at == count);
  return whole;
}

/// Whether two points are near each other, relative to their size.
inline bool AreNear(const Vec3& a, const Vec3& b, double tolerance)
{
  return (a - b).Norm() < tolerance * (1 + b.Norm());
}

} // namespace helios::testing

#endif
