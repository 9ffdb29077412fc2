// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A sample of the pulses of a scan.
#include "heliosPulseSubset.h"
#include "heliosScannerBench.h"

#include <vtkSMPTools.h>

#include <catch2/catch.hpp>

#include <set>
#include <vector>

namespace names = vtkHeliosArrayNames;
using namespace helios::testing;
using helios::PulseSubset;

namespace
{

std::vector<vtkIdType> GetIds(vtkPolyData* echoes)
{
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    ids.push_back(static_cast<vtkIdType>(Value(echoes, names::PulseIds, i)));
  }
  return ids;
}

} // namespace

TEST_CASE("A sample has one index in each group of Step")
{
  const PulseSubset sample(100, 7);
  vtkIdType before = sample.Get(0);
  std::set<vtkIdType> gaps;
  for (vtkIdType n = 1; n < 1000; ++n)
  {
    const vtkIdType index = sample.Get(n);
    CHECK(index > before);
    CHECK(index - before < 200);
    CHECK(sample.CountBelow(index) == n);
    CHECK(sample.CountBelow(index + 1) == n + 1);
    gaps.insert(index - before);
    before = index;
  }
  CHECK(gaps.size() > 100); // not in step with anything
}

TEST_CASE("A sample of every pulse is all pulses")
{
  const PulseSubset sample(1, 12345);
  CHECK(sample.Get(7) == 7);
  CHECK(sample.CountBelow(7) == 7);
}

TEST_CASE("Short scans with consecutive ids have as many samples together as one long scan")
{
  vtkIdType sampled = 0;
  for (vtkIdType first = 0; first < 1000000; first += 100)
  {
    const PulseSubset sample(1000, first);
    sampled += sample.CountBelow(100) - sample.CountBelow(0);
  }
  CHECK(sampled > 900);
  CHECK(sampled < 1100);
}

TEST_CASE("A scanner with a PulseStep fires some of the same pulses")
{
  Bench all(MakeScene({ Wall(10) }));
  all.Scanner->SetRangeAccuracy(0.01); // keyed by pulse
  Bench some(MakeScene({ Wall(10) }));
  some.Scanner->SetRangeAccuracy(0.01);
  some.Scanner->SetPulseStep(10);
  vtkPolyData* sample = some.Run();
  vtkPolyData* whole = all.Run();
  const auto ids = GetIds(sample);
  CHECK(some.Scanner->GetCount("pulsesFired") == sample->GetNumberOfPoints());
  CHECK(some.Scanner->GetNumberOfPulses() == 1000);
  REQUIRE(ids.size() >= 99);
  REQUIRE(ids.size() <= 101);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    for (const char* name : { names::Range, names::GpsTime, names::Amplitude })
    {
      CHECK(Value(sample, name, static_cast<vtkIdType>(i)) == Value(whole, name, ids[i]));
    }
  }
}

TEST_CASE("A sample is the same in pieces, windows and any number of threads")
{
  Bench bench(MakeScene({ Wall(10) }));
  bench.Scanner->SetPulseStep(7);
  vtkSMPTools::Initialize(1);
  const auto whole = GetIds(bench.Run());
  vtkSMPTools::Initialize(2);
  std::vector<vtkIdType> joined;
  for (int piece = 0; piece < 9; ++piece)
  {
    bench.Scanner->UpdatePiece(piece, 9, 0);
    const auto ids = GetIds(bench.Scanner->GetOutput());
    joined.insert(joined.end(), ids.begin(), ids.end());
  }
  CHECK(joined == whole);
  joined.clear();
  for (vtkIdType first = 0; first < 1000; first += 333)
  {
    bench.Scanner->SetPulseWindow(first, first + 333);
    bench.Scanner->UpdatePiece(0, 1, 0);
    const auto ids = GetIds(bench.Scanner->GetOutput());
    joined.insert(joined.end(), ids.begin(), ids.end());
  }
  CHECK(joined == whole);
}

TEST_CASE("A sample of ten days of pulses takes no longer than its pulses")
{
  Bench bench(MakeScene({ Wall(10) }));
  bench.Scanner->SetDuration(864000.0);
  bench.Scanner->SetPulseStep(864000000); // 100 of 86.4e9 pulses
  const vtkIdType count = bench.Run()->GetNumberOfPoints();
  CHECK(count >= 99);
  CHECK(count <= 101);
}
