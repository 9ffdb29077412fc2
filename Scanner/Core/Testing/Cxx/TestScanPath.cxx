// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScanPath.h"

#include <catch2/catch.hpp>

using helios::BeamPath;
using helios::ChoosePath;
using helios::EchoPath;
using helios::ScanTraits;

TEST_CASE("ScanPath: of the beam", "[ScanPath]")
{
  ScanTraits traits;
  CHECK(ChoosePath(traits).Beam == BeamPath::Adaptive);
  CHECK(ChoosePath(traits).IsAdaptive());
  traits.FindsPlanes = true;
  CHECK(ChoosePath(traits).Beam == BeamPath::ConeFirst);
  CHECK(ChoosePath(traits).IsAdaptive());
  traits.IsFixed = true;
  CHECK(ChoosePath(traits).Beam == BeamPath::Fixed);
  CHECK_FALSE(ChoosePath(traits).IsAdaptive());
  for (const bool isFixed : { false, true })
  {
    traits.HasDivergence = false;
    traits.IsFixed = isFixed;
    CHECK(ChoosePath(traits).Beam == BeamPath::SingleRay);
    CHECK_FALSE(ChoosePath(traits).IsAdaptive());
    CHECK_FALSE(traits.IsAdaptive());
  }
}

TEST_CASE("ScanPath: traits and path agree on adaptive sampling", "[ScanPath]")
{
  for (int bits = 0; bits < 64; ++bits)
  {
    const ScanTraits traits{ (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0,
      (bits & 16) != 0, (bits & 32) != 0 };
    CHECK(traits.IsAdaptive() == ChoosePath(traits).IsAdaptive());
  }
}

TEST_CASE("ScanPath: of the echoes", "[ScanPath]")
{
  struct Row
  {
    bool HasDivergence, IsFixed, StoresWaveforms;
    EchoPath Plain; // if echoes are plain maxima
  };
  const Row rows[] = {
    { true, false, false, EchoPath::Maxima },
    { true, false, true, EchoPath::Maxima },
    { false, false, false, EchoPath::Maxima },
    { false, true, false, EchoPath::Maxima }, // one ray has no bins
    { false, true, true, EchoPath::Maxima },
    { true, true, false, EchoPath::BinnedMaxima },
    { true, true, true, EchoPath::Waveform },
  };
  for (const Row& row : rows)
  {
    ScanTraits traits;
    traits.HasDivergence = row.HasDivergence;
    traits.IsFixed = row.IsFixed;
    traits.StoresWaveforms = row.StoresWaveforms;
    CHECK(ChoosePath(traits).Echo == EchoPath::Waveform);
    traits.HasGaussianSum = true;
    CHECK(ChoosePath(traits).Echo == row.Plain);
    traits.MergesReturns = true;
    CHECK(ChoosePath(traits).Echo == EchoPath::Mean);
    traits.HasGaussianSum = false;
    CHECK(ChoosePath(traits).Echo == EchoPath::Mean);
  }
}
