// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Cost and accuracy of beam sampling: processor time per pulse against missed and extra echoes,
// range and amplitude errors, over eight scenes; one parameter varied at a time. Prints a table,
// writes it as CSV (plot_scanner_trade.py draws it), and prints the gain of adaptive sampling.
//
// The reference has 4096 sub-rays per pulse and bins of 0.1 ns; its own error is its distance from
// one of 8192. It must agree with closed forms on plane, step and sphere, or no table is written.
//
// Usage: BenchScannerTrade [--quick] [--scene NAME] [table.csv]

#include "heliosBenchClock.h"
#include "heliosTradeBench.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using helios::CpuSeconds;
using helios::Median;
using helios::WallSeconds;

namespace
{

using namespace helios::bench;
using helios::Vec3;

constexpr double LongTime = 1.0; // time of a run timed only once [s]

const Way Reference{ "Vogel", 4096, 0.1 };
const Way Doubled{ "Vogel", 8192, 0.1 };
const double Tolerances[] = { 1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4 };

std::vector<Way> GetWays()
{
  std::vector<Way> ways;
  for (const int rings : { 2, 4, 8 })
  {
    ways.push_back({ "GL", rings });
  }
  for (const int circles : { 1, 2, 3, 4 })
  {
    ways.push_back({ "circles", circles });
  }
  for (const int subRays : { 64, 256, 1024 })
  {
    ways.push_back({ "Vogel", subRays });
  }
  for (const double bin : { 0.1, 0.5, 1.0 })
  {
    ways.push_back({ "Vogel", 256, bin });
  }
  for (const double tolerance : Tolerances)
  {
    ways.push_back(ByTolerance(tolerance));
  }
#ifdef HELIOS_HAS_DETECTORS
  ways.push_back({ "Vogel", 256, 0.25, "gaussians" });
  ways.push_back(ByTolerance(1e-3, "gaussians"));
#endif
  return ways;
}

/// Cost and errors of a method.
struct Row
{
  Way How;
  double SubRays = 0.0;       // per pulse
  std::vector<double> Times;  // [s] per pulse, one thread; one per round, or only one
  std::vector<double> Times2; // two threads, wall time
  double OnPlane = 0.0;       // pulses in closed form [%]
  double NoBins = 0.0;        // pulses by Newton's method [%]
  TradeErrors Errors;

  double GetSeconds() const { return this->Times.empty() ? 0.0 : Median(this->Times); }
  double GetSeconds2() const { return this->Times2.empty() ? 0.0 : Median(this->Times2); }

  /// Speed-up over another method: the median of the rounds, for machines of varying speed.
  double GetSpeedUp(const Row& other) const
  {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(this->Times.size(), other.Times.size()); ++i)
    {
      ratios.push_back(other.Times[i] / this->Times[i]);
    }
    return Median(ratios);
  }
};

template <typename ClockT, typename WorkT>
double GetSeconds(ClockT clock, WorkT work)
{
  const double start = clock();
  work();
  return clock() - start;
}

/// Times a method once more, less a run of one pulse; skipped if slow.
void Time(Bench& bench, Row& row)
{
  if (!row.Times.empty() && row.Times[0] * bench.Pulses > LongTime)
  {
    return;
  }
  bench.Set(row.How);
  vtkSMPTools::Initialize(1);
  const double empty = GetSeconds(CpuSeconds, [&bench] { bench.Fire(1); });
  const double one = GetSeconds(CpuSeconds, [&bench] { bench.Fire(bench.Pulses); });
  vtkSMPTools::Initialize(2);
  const double two = GetSeconds(WallSeconds, [&bench] { bench.Fire(bench.Pulses); });
  const double fired = bench.Pulses;
  row.Times.push_back((one - empty) / fired);
  row.Times2.push_back((two - empty) / fired);
  row.SubRays = static_cast<double>(bench.Scanner->GetCount("subRays")) / fired;
  row.OnPlane = 100.0 * static_cast<double>(bench.Scanner->GetCount("pulsesOnPlane")) / fired;
  row.NoBins = 100.0 * static_cast<double>(bench.Scanner->GetCount("pulsesWithoutBins")) / fired;
}

/// Whether the reference matches the known closed forms.
bool CheckReference(Bench& bench, const TradeScene& scene, vtkPolyData* output)
{
  const RunEchoes reference = GetEchoes(output, bench.Pulses);
  double range = 0.0, share = 0.0;
  int known = 0, lost = 0;
  for (int i = 0; scene.Truth && i < bench.Pulses; ++i)
  {
    double d[3];
    bench.Aim->GetDirection(i, d);
    const ClosedForm truth = scene.Truth(Vec3(d));
    const auto& echoes = reference[static_cast<std::size_t>(i)];
    if (std::isnan(truth.Range))
    {
      continue;
    }
    ++known;
    if (echoes.empty())
    {
      ++lost;
      continue;
    }
    range = std::max(range, std::abs(echoes[0].Range - truth.Range));
    if (!std::isnan(truth.Share))
    {
      const double full = bench.GetFullAmplitude(truth.Range);
      share = std::max(share, std::abs(echoes[0].Amplitude / full - truth.Share));
    }
  }
  const bool isRight = lost == 0 && range < 2.5e-3 && share < 3e-3;
  if (scene.Truth)
  {
    std::printf("%s: the reference is within %.1e m and %.1e of the energy of closed forms, "
                "%d pulses%s\n",
      scene.Name.c_str(), range, share, known, isRight ? "" : ": WRONG");
  }
  return isRight;
}

class Table
{
public:
  explicit Table(const std::string& path)
    : File(path.empty() ? nullptr : std::fopen(path.c_str(), "w"))
  {
    this->Write("scene,pattern,size,sub_rays,bin_ns,detector,range_tolerance_m,us_per_pulse,"
                "pulses_per_s,pulses_per_s_2_threads,plane_pct,newton_pct,missed_pct,extra_pct,"
                "range_bias_m,range_rms_m,range_p99_m,amplitude_rms\n");
  }
  ~Table()
  {
    if (this->File)
    {
      std::fclose(this->File);
    }
  }
  Table(const Table&) = delete;
  void operator=(const Table&) = delete;

  void Add(const std::string& scene, const Row& r)
  {
    const TradeErrors& e = r.Errors;
    std::printf("%-8s %-9s %5d %7.1f rays %4.2f ns %-9s %7.0e m %9.3f us %5.1f%% plane %5.1f%% "
                "Newton %6.2f%% missed %6.2f%% extra %8.1e m %8.1e m %8.1e\n",
      scene.c_str(), r.How.Pattern.c_str(), r.How.Size, r.SubRays, r.How.BinSize,
      r.How.Detector.c_str(), r.How.RangeTolerance, 1e6 * r.GetSeconds(), r.OnPlane, r.NoBins,
      e.Missed, e.Extra, e.RangeRms, e.RangeP99, e.AmplitudeRms);
    std::fflush(stdout);
    char line[512];
    std::snprintf(line, sizeof line,
      "%s,%s,%d,%.2f,%.2f,%s,%g,%.4g,%.4g,%.4g,%.1f,%.1f,%.3f,%.3f,%.3g,%.3g,%.3g,%.3g\n",
      scene.c_str(), r.How.Pattern.c_str(), r.How.Size, r.SubRays, r.How.BinSize,
      r.How.Detector.c_str(), r.How.RangeTolerance, 1e6 * r.GetSeconds(),
      r.Times.empty() ? 0.0 : 1 / r.GetSeconds(), r.Times2.empty() ? 0.0 : 1 / r.GetSeconds2(),
      r.OnPlane, r.NoBins, e.Missed, e.Extra, e.RangeBias, e.RangeRms, e.RangeP99, e.AmplitudeRms);
    this->Write(line);
  }

private:
  void Write(const char* line) const
  {
    if (this->File)
    {
      std::fputs(line, this->File);
    }
  }
  std::FILE* File;
};

/// The fastest adaptive sampling that is no worse than a fixed one.
const Row* FindFastest(const std::vector<Row>& rows, const Row& fixed, const TradeErrors& floor)
{
  const Row* best = nullptr;
  for (const Row& row : rows)
  {
    if (row.How.IsByTolerance() && row.How.Detector == "peaks" &&
      row.Errors.IsNoWorse(fixed.Errors, floor) && (!best || row.GetSeconds() < best->GetSeconds()))
    {
      best = &row;
    }
  }
  return best;
}

/// The gain of adaptive sampling, for any error and for errors above a tenth of the noise.
void PrintRatios(const std::vector<Row>& rows, const Row& fixed, const TradeErrors& self)
{
  TradeErrors noise = self; // a tenth of that at a signal-to-noise ratio of 50
  noise.RangeRms = std::max(self.RangeRms, 0.1 * 0.2075 / 50);
  noise.AmplitudeRms = std::max(self.AmplitudeRms, 0.1 / 50);
  const std::string name = fixed.How.Pattern + " " + std::to_string(std::lround(fixed.SubRays));
  std::printf("  %-11s", name.c_str());
  for (const TradeErrors& floor : { self, noise })
  {
    const Row* best = FindFastest(rows, fixed, floor);
    if (best)
    {
      std::printf(" %8.2f x (tolerance %g m)", best->GetSpeedUp(fixed), best->How.RangeTolerance);
    }
    else
    {
      std::printf("   no tolerance is as good");
    }
  }
  std::printf("\n");
}

/// Returns false if the reference is wrong.
bool RunScene(const TradeScene& scene, bool isQuick, Table& table)
{
  Bench bench(scene, isQuick ? 50 : 250);
  const vtkSmartPointer<vtkPolyData> reference = bench.Run(Reference);
  if (!CheckReference(bench, scene, reference))
  {
    return false;
  }
  Row self;
  self.How = Reference;
  self.SubRays = Reference.Size;
  self.Errors = Compare(reference, bench.Run(Doubled), Separation);
  table.Add(scene.Name, self);
  std::vector<Row> rows;
  for (const Way& way : GetWays())
  {
    Row row;
    row.How = way;
    row.Errors = Compare(bench.Run(way), reference, Separation);
    rows.push_back(row);
  }
  for (int round = 0; round < (isQuick ? 3 : 5); ++round)
  {
    std::for_each(rows.begin(), rows.end(), [&bench](Row& row) { Time(bench, row); });
  }
  std::for_each(rows.begin(), rows.end(), [&](const Row& row) { table.Add(scene.Name, row); });
  std::printf("%s: fixed / adaptive, time at no worse error; the same, errors below a tenth of "
              "the noise left out\n",
    scene.Name.c_str());
  for (const Row& row : rows)
  {
    const bool isNamed = row.SubRays == 256 || row.SubRays == 64 || row.SubRays == 19;
    if (isNamed && row.How.BinSize == 0.25 && row.How.Detector == "peaks")
    {
      PrintRatios(rows, row, self.Errors);
    }
    if (row.SubRays == 19)
    {
      std::printf("  19 sub-rays, two threads: %.2f Mpulse/s\n", 1e-6 / row.GetSeconds2());
    }
  }
  return true;
}

/// Command line options.
struct Options
{
  bool IsQuick = false;
  std::string Scene; // empty: all
  std::string Path;

  /// Returns false if not valid.
  bool Read(int argc, char** argv)
  {
    for (int i = 1; i < argc; ++i)
    {
      const std::string word = argv[i];
      const bool isScene = word == "--scene" && i + 1 < argc;
      const bool isPath = !word.empty() && word[0] != '-' && this->Path.empty();
      if (!isPath && !isScene && word != "--quick")
      {
        return false;
      }
      this->IsQuick |= word == "--quick";
      this->Scene = isScene ? argv[++i] : this->Scene;
      this->Path = isPath ? word : this->Path;
    }
    return true;
  }
};

bool Run(const Options& options)
{
  Table table(options.Path);
  bool isRight = true;
  for (TradeScene (*make)() : { MakePlaneScene, MakeStepScene, MakeSphereScene, MakePyramidScene,
         MakeCanopyScene, MakeTerrainScene, MakeStandScene, MakeWiresScene })
  {
    const TradeScene scene = make();
    if (options.Scene.empty() || options.Scene == scene.Name)
    {
      isRight &= RunScene(scene, options.IsQuick, table);
    }
  }
  return isRight;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  if (!options.Read(argc, argv))
  {
    std::fprintf(stderr, "usage: BenchScannerTrade [--quick] [--scene NAME] [table.csv]\n");
    return EXIT_FAILURE;
  }
  const bool isRight = Run(options);
  if (!isRight && !options.Path.empty())
  {
    std::remove(options.Path.c_str());
  }
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
