// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Fraction of the ray caster's rate kept by the whole scanner: pulses with 19 sub-rays to echoes in
// memory, against the bare rays of the same pulses in one batch; and the same pulses with adaptive
// sampling, at 1 mm and 1 %, and at 10 mm and 10 %, with errors similar to 19 sub-rays
// (Docs/scanner-trade.md).
// Usage: BenchScanner [repetitions [scene]]

#include "heliosBenchClock.h"
#include "heliosBenchScenes.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosLinearPathPlatform.h"
#include "vtkHeliosRotatingMirror.h"
#include "vtkHeliosScanner.h"
#include "vtkHeliosStaticPlatform.h"

#include <vtkDoubleArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

namespace names = vtkHeliosArrayNames;
using helios::CpuSeconds;
using helios::Median;
using helios::Vec3;
using helios::WallSeconds;

namespace
{

/// A configured scanner over one of the scenes.
struct Survey
{
  std::string Name;
  vtkNew<vtkHeliosScanner> Scanner;
  vtkNew<vtkHeliosRotatingMirror> Mirror;
  vtkSmartPointer<vtkHeliosPlatform> Platform;

  Survey(const std::string& name, vtkPolyData* scene, vtkHeliosPlatform* platform,
    const std::vector<Vec3>& waypoints)
    : Name(name)
    , Platform(platform)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> speeds;
    speeds->SetName(names::Speed);
    for (const Vec3& waypoint : waypoints)
    {
      points->InsertNextPoint((waypoint + helios::BenchOffset).GetData());
      speeds->InsertNextValue(60.0);
    }
    vtkNew<vtkPolyData> path;
    path->SetPoints(points);
    path->GetPointData()->AddArray(speeds);
    this->Platform->SetInputData(path);
    this->Scanner->SetInputData(0, scene);
    this->Scanner->SetInputConnection(1, this->Platform->GetOutputPort());
    this->Scanner->SetBeamDeflector(this->Mirror);
    this->Scanner->SetSamplingToFixed();
    this->Scanner->GetBeamSampler()->SetPatternToCircles();
  }

  vtkPolyData* Run()
  {
    this->Scanner->Modified();
    this->Scanner->Update();
    return this->Scanner->GetOutput();
  }
};

/// Forwards the scanner's calls to another caster, and records the rays.
class Recorder : public vtkHeliosRayCaster
{
public:
  static Recorder* New();
  vtkTypeMacro(Recorder, vtkHeliosRayCaster);

  void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const override
  {
    this->Caster->Intersect(rays, hits, count);
    this->Rays.insert(this->Rays.end(), rays, rays + count);
  }
  void Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const override
  {
    this->Caster->Occluded(rays, occluded, count);
  }
  const char* GetName() const override { return "recorder"; }
  std::size_t GetAcceleratorSize() const override { return 0; }

  vtkHeliosRayCaster* Caster = nullptr;
  mutable std::vector<vtkHeliosRay> Rays;

protected:
  bool BuildAccelerator(const helios::TriangleMesh&) override { return true; }
};
vtkStandardNewMacro(Recorder);

/// The rays of all pulses of a survey, in order.
std::vector<vtkHeliosRay> GetRays(Survey& survey)
{
  survey.Run(); // builds the caster
  const vtkSmartPointer<vtkHeliosRayCaster> caster = survey.Scanner->GetRayCaster();
  vtkNew<Recorder> recorder;
  recorder->Caster = caster;
  survey.Scanner->SetRayCaster(recorder);
  vtkSMPTools::Initialize(1);
  survey.Run();
  survey.Scanner->SetRayCaster(caster);
  return std::move(recorder->Rays);
}

/// Every pulse with a hit has a first echo within the ranges of its sub-rays; no other has one.
bool Check(Survey& survey, const std::vector<vtkHeliosHit>& hits)
{
  vtkPolyData* echoes = survey.Run();
  vtkDataArray* ranges = echoes->GetPointData()->GetArray(names::Range);
  vtkDataArray* numbers = echoes->GetPointData()->GetArray(names::ReturnNumber);
  const auto subRays =
    static_cast<std::size_t>(survey.Scanner->GetBeamSampler()->GetNumberOfSubRays());
  vtkIdType echo = 0;
  for (std::size_t pulse = 0; pulse < hits.size() / subRays; ++pulse)
  {
    double nearest = 1e300, farthest = 0.0;
    for (std::size_t k = pulse * subRays; k < (pulse + 1) * subRays; ++k)
    {
      if (hits[k].CellId >= 0)
      {
        nearest = std::min(nearest, hits[k].Range);
        farthest = std::max(farthest, hits[k].Range);
      }
    }
    if (farthest == 0.0)
    {
      continue;
    }
    do
    {
      if (echo == echoes->GetNumberOfPoints() || ranges->GetTuple1(echo) < nearest - 1e-3 ||
        ranges->GetTuple1(echo) > farthest + 1e-3)
      {
        std::printf("%s: pulse %zu has no echo between its hits\n", survey.Name.c_str(), pulse);
        return false;
      }
      ++echo;
    } while (echo < echoes->GetNumberOfPoints() && numbers->GetTuple1(echo) > 1);
  }
  return echo == echoes->GetNumberOfPoints();
}

/// The time of adaptive sampling with a tolerance in range [m], and ten times as much in energy.
double MeasureTolerance(Survey& survey, double tolerance)
{
  survey.Scanner->SetSamplingToTolerance();
  survey.Scanner->SetRangeTolerance(tolerance);
  survey.Scanner->SetEnergyTolerance(10.0 * tolerance);
  const double start = WallSeconds();
  survey.Run();
  const double seconds = WallSeconds() - start;
  survey.Scanner->SetSamplingToFixed();
  return seconds;
}

bool Measure(Survey& survey, int repetitions)
{
  const std::vector<vtkHeliosRay> rays = GetRays(survey);
  std::vector<vtkHeliosHit> hits(rays.size());
  const auto count = static_cast<vtkIdType>(rays.size());
  vtkHeliosRayCaster* caster = survey.Scanner->GetRayCaster();
  const int subRays = survey.Scanner->GetBeamSampler()->GetNumberOfSubRays();
  const auto cast = [&]
  { caster->IntersectBeams(rays.data(), hits.data(), subRays, count / subRays); };
  cast();
  if (!Check(survey, hits))
  {
    return false;
  }
  std::vector<double> bare, one, ratio, wallOne, wallTwo, fine, wide;
  for (int i = 0; i < repetitions; ++i)
  {
    vtkSMPTools::Initialize(1);
    double start = CpuSeconds();
    cast();
    bare.push_back(CpuSeconds() - start);
    start = CpuSeconds();
    double wall = WallSeconds();
    survey.Run();
    one.push_back(CpuSeconds() - start);
    wallOne.push_back(WallSeconds() - wall);
    ratio.push_back(bare.back() / one.back());
    vtkSMPTools::Initialize(2);
    wall = WallSeconds();
    survey.Run();
    wallTwo.push_back(WallSeconds() - wall);
    fine.push_back(MeasureTolerance(survey, 1e-3));
    wide.push_back(MeasureTolerance(survey, 1e-2));
  }
  const double million = 1e-6 * static_cast<double>(count);
  std::printf("%-18s %7.2f %9.2f %12.3f %10.2f %13.2f %10.3f %10.3f %10.3f\n", survey.Name.c_str(),
    million / Median(bare), million / Median(one), million / 19 / Median(one), Median(ratio),
    Median(wallOne) / Median(wallTwo), million / 19 / Median(wallTwo), million / 19 / Median(fine),
    million / 19 / Median(wide));
  return true;
}

void SetUpTripod(Survey& survey)
{
  survey.Mirror->SetMirrorAngle(50);
  survey.Mirror->SetPulseFrequency(300000);
  survey.Mirror->SetScanFrequency(120);
  survey.Scanner->SetHeadRotateStop(360);
  survey.Scanner->SetHeadRotateSpeed(360);
}

void SetUpAircraft(Survey& survey, double swath)
{
  survey.Mirror->SetMirrorAngle(swath);
  survey.Mirror->SetPulseFrequency(200000);
  survey.Scanner->SetMountOrientation(0.5, -0.5, -0.5, 0.5); // y down, lines across track
  survey.Scanner->SetDuration(1.5);
}

} // namespace

int main(int argc, char* argv[])
{
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  const auto terrain = helios::MakeBenchTerrain();
  const auto canopy = helios::MakeBenchCanopy();
  const double ground = helios::GetHillHeight(503, 497) + 2;
  const double forest = helios::GetHillHeight(100.6, 99.4) + 2;
  vtkNew<vtkHeliosStaticPlatform> tripods[2];
  vtkNew<vtkHeliosLinearPathPlatform> aircraft[2];
  Survey a("terrain, tripod", terrain, tripods[0], { { 503, 497, ground } });
  Survey b("terrain, aircraft", terrain, aircraft[0], { { 500, 450, 600 }, { 500, 540, 600 } });
  Survey c("canopy, tripod", canopy, tripods[1], { { 100.6, 99.4, forest } });
  Survey d("canopy, aircraft", canopy, aircraft[1], { { 100, 55, 800 }, { 100, 145, 800 } });
  SetUpTripod(a);
  SetUpTripod(c);
  SetUpAircraft(b, 35);
  SetUpAircraft(d, 6);

  std::printf("19 sub-rays per pulse, echoes in memory; medians of %d\n", repetitions);
  const char* head = "%-18s %7s %9s %12s %10s %13s %10s %10s %10s\n";
  std::printf(head, "", "bare", "scanner", "scanner", "scanner /", "2 threads /", "2 threads",
    "1 mm, 1 %", "1 cm, 10 %");
  std::printf(head, "", "Mray/s", "Mray/s", "Mpulse/s", "bare", "1 thread", "Mpulse/s", "Mpulse/s",
    "Mpulse/s");
  bool right = true;
  const std::string only = argc > 2 ? argv[2] : "";
  for (Survey* survey : { &a, &b, &c, &d })
  {
    const bool isAsked = survey->Name.find(only) != std::string::npos;
    right = (!isAsked || Measure(*survey, repetitions)) && right;
  }
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
