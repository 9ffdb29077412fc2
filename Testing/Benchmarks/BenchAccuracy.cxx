// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The accuracy that a tolerance promises (Docs/instrument.md) against the one it gives, and the
// cost of both, on scenes of thin, sparse, rough and far surfaces, and of sheets closely before walls.
//
// The reference has 65,536 sub-rays per pulse on Vogel's spiral; its own error is its distance from
// one of 32,768. Errors are of echoes of at least 2 % of a full footprint. Kept: within the
// tolerances, and no worse than 19 fixed sub-rays on circles.
//
// Usage: BenchAccuracy [--quick] [--scene NAME]

#include "heliosBenchClock.h"
#include "heliosSheetBenchScenes.h"
#include "heliosTradeBench.h"
#include "heliosTradeErrors.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace
{

using namespace helios::bench;

const double Tolerances[] = { 3e-2, 1e-2, 3e-3, 1e-3, 3e-4 };

Way Vogel(int size)
{
  return { "Vogel", size, 0.02 };
}

/// Quantity that the promise is about.
struct Accuracy
{
  double Half = 0.0; ///< median of the range error [m]
  double P95 = 0.0;
  double Rms = 0.0;
  double Lost = 0.0;      ///< missed and invented echoes, relative to the reference
  double Amplitude = 0.0; ///< RMS, of a full footprint
};

/// Compares all echoes, of half the threshold and more, for those that reach the threshold.
Accuracy GetAccuracy(vtkPolyData* run, vtkPolyData* reference, double threshold, double full)
{
  helios::EchoMatching matching;
  matching.Distance = 0.6 * Separation;
  matching.FullAmplitude = full;
  matching.LeastAmplitude = threshold;
  helios::EchoComparison comparison;
  helios::bench::Require(comparison.Add(run, reference, matching));
  const helios::EchoErrors errors = comparison.GetErrors();
  return { errors.RangeP50.Value, errors.RangeP95.Value, errors.RangeRms.Value, errors.Lost.Value,
    errors.AmplitudeRms.Value };
}

void Print(
  const char* scene, const char* way, double microseconds, const Accuracy& a, const char* end)
{
  std::printf("%-8s %-12s %9.2f us %8.3f %8.3f %8.3f mm %7.3f %% %7.3f %%  %s\n", scene, way,
    microseconds, 1e3 * a.Half, 1e3 * a.P95, 1e3 * a.Rms, 100 * a.Lost, 100 * a.Amplitude, end);
  std::fflush(stdout);
}

/// Whether all measures are within a tolerance, or the error of the reference.
bool IsKept(const Accuracy& a, const Accuracy& own, double range, double energy)
{
  return a.P95 <= std::max(range, 2 * own.P95) && a.Lost <= std::max(energy, 2 * own.Lost) &&
    a.Amplitude <= std::max(energy, 2 * own.Amplitude);
}

double GetMicroseconds(Bench& bench, const Way& way)
{
  bench.Set(way);
  vtkSMPTools::Initialize(1);
  std::vector<double> times;
  for (int round = 0; round < 3; ++round)
  {
    const double start = helios::CpuSeconds();
    bench.Fire(1);
    const double middle = helios::CpuSeconds();
    bench.Fire(bench.Pulses);
    times.push_back((helios::CpuSeconds() - middle) - (middle - start));
  }
  vtkSMPTools::Initialize(2);
  return 1e6 * helios::Median(times) / bench.Pulses;
}

/// Whether no measure is worse than another's, or its difference is within the error of the reference.
bool IsNoWorse(const Accuracy& a, const Accuracy& other, const Accuracy& own)
{
  return a.P95 <= other.P95 + own.P95 && a.Lost <= other.Lost + own.Lost &&
    a.Amplitude <= other.Amplitude + own.Amplitude;
}

bool Run(const TradeScene& scene, int side)
{
  Bench bench(scene, side);
  const double threshold = bench.Threshold;
  const double full = bench.GetFullAmplitude(1.0);
  bench.Threshold *= 0.5;
  vtkSMPTools::Initialize(2);
  const vtkSmartPointer<vtkPolyData> reference = bench.Run(Vogel(65536));
  const Accuracy own = GetAccuracy(bench.Run(Vogel(32768)), reference, threshold, full);
  Print(scene.Name.c_str(), "reference", 0.0, own, "");
  for (const int size : { 20, 64, 256, 1024, 4096 })
  {
    const Accuracy a = GetAccuracy(bench.Run(Vogel(size)), reference, threshold, full);
    Print(scene.Name.c_str(), ("Vogel " + std::to_string(size)).c_str(),
      GetMicroseconds(bench, Vogel(size)), a, "");
  }
  const Way circles = { "circles", 3, 0.02 };
  const Accuracy fixed = GetAccuracy(bench.Run(circles), reference, threshold, full);
  Print(scene.Name.c_str(), "circles 19", GetMicroseconds(bench, circles), fixed, "");
  bool isKept = true;
  for (const double tolerance : Tolerances)
  {
    const Way way = ByTolerance(tolerance);
    const Accuracy a = GetAccuracy(bench.Run(way), reference, threshold, full);
    const double time = GetMicroseconds(bench, way);
    const bool isGood = IsKept(a, own, tolerance, 10 * tolerance) && IsNoWorse(a, fixed, own);
    char name[32], share[64];
    std::snprintf(name, sizeof name, "%g mm", 1e3 * tolerance);
    std::snprintf(share, sizeof share, "%s, %.2f %% sampled", isGood ? "kept" : "NOT KEPT",
      100.0 * static_cast<double>(bench.Scanner->GetCount("pulsesSampled")) / bench.Pulses);
    Print(scene.Name.c_str(), name, time, a, share);
    isKept = isKept && isGood;
  }
  return isKept;
}

} // namespace

int main(int argc, char* argv[])
{
  int side = 60;
  std::string only;
  for (int i = 1; i < argc; ++i)
  {
    side = std::strcmp(argv[i], "--quick") == 0 ? 20 : side;
    only = std::strcmp(argv[i], "--scene") == 0 && i + 1 < argc ? argv[i + 1] : only;
  }
  std::printf("scene    sampling       per pulse   range error: half, p95, RMS; lost + invented; "
              "amplitude RMS\n");
  bool isKept = true;
  for (const TradeScene& scene : MakeAllAccuracyScenes())
  {
    if (only.empty() || scene.Name == only)
    {
      isKept = Run(scene, side) && isKept;
    }
  }
  return isKept ? EXIT_SUCCESS : EXIT_FAILURE;
}
