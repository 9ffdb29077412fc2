// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Wires and strips from 0.5 to 50 mm, 30 m to 4 km away, before the sky, a wall and terrain: the
// echoes lost, their amplitudes against a closed form, and the time against that of the fewest
// fixed sub-rays that are as good.
//
// The amplitude of a wire is the sum over its sides of the energy on the strip that a side covers
// of the beam, times the cosine of incidence; of a strip the energy alone. An echo counts from an
// amplitude of 2 % of the largest of its row on.
//
// Usage: BenchWires [--quick]

#include "heliosAccuracyScenes.h"
#include "heliosBenchClock.h"
#include "heliosTradeBench.h"

#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>

namespace
{

using namespace helios;
using namespace helios::bench;

constexpr double Divergence = 0.3e-3;
constexpr double HalfWidth = 0.5 * Divergence; // w [rad]
constexpr double Middle = 50.0;                // middle of the scene, along x and y [m]
constexpr double Height = 40.0;                // height of the wire [m]
constexpr double Depth = 0.5;                  // depth of its echoes [m]
constexpr double Tolerance = 1e-3;             // [m]; of the amplitude 1e-2

enum class Target
{
  Strip,
  Wire
};
enum class Background
{
  Sky,
  Wall,
  Terrain
};

/// Density of the energy of a truncated beam at s w from a line through its axis, by w.
double GetDensity(double s)
{
  const double rest = Truncation * Truncation - s * s;
  return rest > 0.0 ? std::sqrt(2.0 / vtkMath::Pi()) * std::exp(-2.0 * s * s) *
      std::erf(std::sqrt(2.0 * rest)) / (1.0 - std::exp(-2.0 * Truncation * Truncation))
                    : 0.0;
}

/// The energy between two lines, in w.
double GetEnergy(double low, double high)
{
  constexpr int steps = 64;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    sum += GetDensity(low + (high - low) * (i + 0.5) / steps);
  }
  return sum * (high - low) / steps;
}

/// Computes the amplitude of a target across the beam, relative to a plane's; its axis is at an
/// offset.
double GetAmplitude(Target target, double width, double offset, double beam)
{
  if (target == Target::Strip)
  {
    return GetEnergy((offset - 0.5 * width) / beam, (offset + 0.5 * width) / beam);
  }
  double sum = 0.0;
  for (int side = -2; side < 2; ++side) // the near four of eight sides
  {
    const double turn = 0.25 * vtkMath::Pi();
    const double low = 0.5 * width * std::sin(side * turn);
    const double high = 0.5 * width * std::sin((side + 1) * turn);
    sum += std::cos((side + 0.5) * turn) * GetEnergy((offset + low) / beam, (offset + high) / beam);
  }
  return sum;
}

TradeScene MakeScene(Target target, double width, double range, Background background)
{
  BenchScene scene;
  if (background == Background::Terrain)
  {
    scene.AddHills(400, 2 * Middle); // first: its points have the first ids
  }
  const double end = 40.0;
  if (target == Target::Strip)
  {
    scene.AddQuad({ Middle, Middle, Height }, { end, 0, 0 }, { 0, 0.5 * width, 0 });
  }
  else
  {
    AddCylinder(
      scene, { Middle - end, Middle, Height }, { Middle + end, Middle, Height }, 0.5 * width);
  }
  if (background == Background::Wall)
  {
    scene.AddQuad({ Middle, Middle, Height - 5 }, { Middle, 0, 0 }, { 0, Middle, 0 });
  }
  const double window = 1.2 * Truncation * HalfWidth * range;
  return { "", scene.Finish(), BenchOffset, { Middle, Middle, Height + range },
    { Middle - window, Middle - window, Height }, { 2 * window, 0, 0 }, { 0, 2 * window, 0 },
    Divergence, {} };
}

/// The largest amplitude of the echoes of a target, by pulse.
std::map<vtkIdType, double> GetEchoes(vtkPolyData* echoes, double range)
{
  namespace names = vtkHeliosArrayNames;
  vtkDataArray* pulses = echoes->GetPointData()->GetArray(names::PulseIds);
  vtkDataArray* ranges = echoes->GetPointData()->GetArray(names::Range);
  vtkDataArray* amplitudes = echoes->GetPointData()->GetArray(names::Amplitude);
  std::map<vtkIdType, double> found;
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    if (std::abs(ranges->GetTuple1(i) - range) < Depth)
    {
      double& amplitude = found[static_cast<vtkIdType>(pulses->GetTuple1(i))];
      amplitude = std::max(amplitude, amplitudes->GetTuple1(i));
    }
  }
  return found;
}

struct Errors
{
  double Lost = 0.0;      ///< number of the echoes that count
  double Amplitude = 0.0; ///< RMS, of the largest

  bool IsAsGoodAs(const Errors& other) const
  {
    return this->Lost <= other.Lost && this->Amplitude <= other.Amplitude;
  }
};

/// A row of the table.
class Row
{
public:
  Row(Target target, double width, double range, Background background, int side)
    : Range(range)
    , Scanner(MakeScene(target, width, range, background), side)
  {
    const double full = this->Scanner.GetFullAmplitude(range);
    for (const Vec3& d : this->Scanner.Aim->Directions)
    {
      const double offset = range * d[1] / -d[2];
      this->Expected.push_back(full * GetAmplitude(target, width, offset, HalfWidth * range));
    }
    this->Largest = *std::max_element(this->Expected.begin(), this->Expected.end());
    this->Scanner.Threshold = 0.01 * this->Largest;
  }

  Errors GetErrors(const Way& way)
  {
    const auto found = GetEchoes(this->Scanner.Run(way), this->Range);
    Errors errors;
    int count = 0;
    for (std::size_t i = 0; i < this->Expected.size(); ++i)
    {
      if (this->Expected[i] < 0.02 * this->Largest)
      {
        continue;
      }
      ++count;
      const auto echo = found.find(static_cast<vtkIdType>(i));
      const bool isFound = echo != found.end();
      errors.Lost += isFound ? 0.0 : 1.0;
      errors.Amplitude += isFound ? std::pow(echo->second / this->Expected[i] - 1.0, 2) *
          std::pow(this->Expected[i] / this->Largest, 2)
                                  : 0.0;
    }
    const double divisor = std::max(1.0, count - errors.Lost);
    return { errors.Lost / count, std::sqrt(errors.Amplitude / divisor) };
  }

  double GetMicroseconds(const Way& way)
  {
    this->Scanner.Set(way);
    std::vector<double> times;
    for (int round = 0; round < 3; ++round)
    {
      const double start = helios::CpuSeconds();
      this->Scanner.Fire(1);
      const double middle = helios::CpuSeconds();
      this->Scanner.Fire(this->Scanner.Pulses);
      times.push_back((helios::CpuSeconds() - middle) - (middle - start));
    }
    return 1e6 * helios::Median(times) / this->Scanner.Pulses;
  }

private:
  double Range;
  Bench Scanner;
  std::vector<double> Expected; ///< expected echoes of the pulses
  double Largest = 0.0;
};

/// False if an error exceeds the tolerance.
bool Run(Row& row, const char* name)
{
  const Way adaptive = ByTolerance(Tolerance);
  const Errors own = row.GetErrors(adaptive);
  const double time = row.GetMicroseconds(adaptive);
  const Errors limit = { std::max(own.Lost, 10 * Tolerance),
    std::max(own.Amplitude, 10 * Tolerance) };
  std::printf("%-8s %6.2f %% %7.3f %% %8.2f us", name, 100 * own.Lost, 100 * own.Amplitude, time);
  for (int size = 16; size <= 65536; size *= 4)
  {
    const Way fixed = { "Vogel", size, 0.02 };
    if (row.GetErrors(fixed).IsAsGoodAs(limit) || size == 65536)
    {
      const Errors errors = row.GetErrors(fixed);
      const double other = row.GetMicroseconds(fixed);
      std::printf("   %6d %10.2f us %8.1f x%s\n", size, other, other / time,
        errors.IsAsGoodAs(limit) ? "" : "  (and still worse)");
      break;
    }
  }
  std::fflush(stdout);
  return own.Lost <= 10 * Tolerance && own.Amplitude <= 10 * Tolerance;
}

} // namespace

int main(int argc, char* argv[])
{
  const bool isQuick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  const int side = isQuick ? 10 : 20;
  vtkSMPTools::Initialize(1);
  const char* backgrounds[] = { "sky", "wall", "terrain" };
  std::printf("Tolerance 1 mm, 1 %%; beam 0.3 mrad. Fixed: the fewest sub-rays on Vogel's spiral, "
              "of 16, 64, ... 65,536, whose errors are within 1 %%.\n");
  std::printf(
    "target    width   range  before     lost   amplitude      time    fixed        time\n");
  bool isGood = true;
  for (const Target target : { Target::Strip, Target::Wire })
  {
    for (const double width : { 0.5e-3, 5e-3, 50e-3 })
    {
      for (const double range : { 30.0, 300.0, 4000.0 })
      {
        for (int background = 0; background < 3; ++background)
        {
          Row row(target, width, range, static_cast<Background>(background), side);
          std::printf("%-6s %5.1f mm %5.0f m  ", target == Target::Strip ? "strip" : "wire",
            1e3 * width, range);
          isGood = Run(row, backgrounds[background]) && isGood;
        }
      }
    }
  }
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
