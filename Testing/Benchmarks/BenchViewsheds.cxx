// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Fraction of the ray caster's rate for bare occlusion rays kept by vtkHeliosViewsheds, on 2 M
// triangles of terrain with 10^4 candidates and 10^5 test points. Results are first compared bit
// for bit; repeats alternate, values are medians by processor time.
//
// Usage: BenchViewsheds [repetitions [candidates [ray caster]]]

#include "heliosBenchClock.h"
#include "heliosBenchScenes.h"

#include "vtkHeliosRayCasterFactory.h"
#include "vtkHeliosScanPositionCandidates.h"
#include "vtkHeliosViewsheds.h"
#include "vtkHeliosVisibilityTestPoints.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

using helios::CpuSeconds;
using helios::Median;
using helios::WallSeconds;

namespace
{

/// Every nth candidate, as a sample of all.
vtkSmartPointer<vtkPolyData> Thin(vtkPolyData* points, vtkIdType count)
{
  vtkNew<vtkPoints> kept;
  kept->SetDataTypeToDouble();
  const vtkIdType all = points->GetNumberOfPoints();
  for (vtkIdType i = 0; i < std::min(all, count); ++i)
  {
    kept->InsertNextPoint(points->GetPoint(i * all / std::min(all, count)));
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(kept);
  return result;
}

/// The visibility rays from a candidate to the test points, aimed 0.05 mm (5 cm / 1000) below the
/// surface.
std::vector<vtkHeliosRay> MakeRays(const double eye[3], vtkPolyData* testPoints)
{
  vtkDataArray* normals = testPoints->GetPointData()->GetArray("Normal");
  std::vector<vtkHeliosRay> rays;
  for (vtkIdType v = 0; v < testPoints->GetNumberOfPoints(); ++v)
  {
    const helios::Vec3 way =
      helios::Vec3(testPoints->GetPoint(v)) - helios::Vec3(eye[0], eye[1], eye[2]);
    const helios::Vec3 aim = way - 5e-5 * helios::Vec3(normals->GetTuple3(v));
    rays.push_back(
      { { eye[0], eye[1], eye[2] }, { aim[0], aim[1], aim[2] }, 1.0 - (1.0 / way.Norm()) * 0.05 });
  }
  return rays;
}

/// Bare rays of some candidates, built before timing.
struct Bare
{
  std::vector<std::vector<vtkHeliosRay>> Rays;
  std::vector<std::vector<unsigned char>> Hidden;

  double Run(const vtkHeliosRayCaster& caster)
  {
    const double start = CpuSeconds();
    for (std::size_t i = 0; i < this->Rays.size(); ++i)
    {
      caster.Occluded(
        this->Rays[i].data(), this->Hidden[i].data(), static_cast<vtkIdType>(this->Rays[i].size()));
    }
    return CpuSeconds() - start;
  }
};

/// Whether the filter's bits match the bare rays.
bool Check(const Bare& bare, vtkPolyData* views)
{
  vtkDataArray* rows = views->GetPointData()->GetArray("Visibility");
  const auto* words = static_cast<const unsigned long long*>(rows->GetVoidPointer(0));
  std::size_t different = 0, seen = 0;
  for (std::size_t c = 0; c < bare.Rays.size(); ++c)
  {
    const auto* row = words + c * static_cast<std::size_t>(rows->GetNumberOfComponents());
    for (std::size_t v = 0; v < bare.Rays[c].size(); ++v)
    {
      const bool isSeen = row[v / 64] >> (v % 64) & 1u;
      different += isSeen == (bare.Hidden[c][v] != 0);
      seen += isSeen;
    }
  }
  std::printf("%zu lines of sight, %.1f %% free, %zu different\n",
    bare.Rays.size() * bare.Rays[0].size(),
    100.0 * static_cast<double>(seen) / static_cast<double>(bare.Rays.size() * bare.Rays[0].size()),
    different);
  return different == 0;
}

} // namespace

int main(int argc, char* argv[])
{
  const int repetitions = argc > 1 ? std::atoi(argv[1]) : 5;
  const vtkIdType count = argc > 2 ? std::atoll(argv[2]) : 40;
  const auto scene = helios::MakeBenchTerrain();
  vtkNew<vtkHeliosScanPositionCandidates> candidates;
  candidates->SetInputData(scene);
  candidates->SetStep(10.0);
  candidates->SetMaximumSlope(60.0);
  candidates->Update();
  vtkNew<vtkHeliosVisibilityTestPoints> testPoints;
  testPoints->SetInputData(scene);
  testPoints->SetStep(3.16);
  testPoints->HorizontalOff();
  testPoints->Update();
  std::printf("%lld candidates, %lld of them used; %lld test points\n",
    static_cast<long long>(candidates->GetOutput()->GetNumberOfPoints()),
    static_cast<long long>(count),
    static_cast<long long>(testPoints->GetOutput()->GetNumberOfPoints()));

  const auto some = Thin(candidates->GetOutput(), count);
  vtkNew<vtkHeliosViewsheds> viewsheds;
  viewsheds->SetRayCaster(vtkSmartPointer<vtkHeliosRayCaster>::Take(
    vtkHeliosRayCasterFactory::Create(argc > 3 ? argv[3] : nullptr)));
  viewsheds->SetInputData(0, scene);
  viewsheds->SetInputData(1, some);
  viewsheds->SetInputData(2, testPoints->GetOutput());
  viewsheds->Update(); // builds the caster
  Bare bare;
  for (vtkIdType i = 0; i < std::min<vtkIdType>(40, some->GetNumberOfPoints()); ++i)
  {
    bare.Rays.push_back(MakeRays(some->GetPoint(i), testPoints->GetOutput()));
    bare.Hidden.emplace_back(bare.Rays.back().size());
  }
  const vtkHeliosRayCaster& caster = *viewsheds->GetRayCaster();
  bare.Run(caster);
  if (!Check(bare, viewsheds->GetOutput()))
  {
    return EXIT_FAILURE;
  }
  std::vector<double> rates, bareRates, ratios, wallRates;
  for (int i = 0; i < repetitions; ++i)
  {
    const double rays = static_cast<double>(bare.Rays.size() * bare.Rays[0].size());
    bareRates.push_back(1e-6 * rays / bare.Run(caster));
    viewsheds->Modified();
    const double start = CpuSeconds();
    const double wall = WallSeconds();
    viewsheds->Update();
    const double cast = 1e-6 * static_cast<double>(viewsheds->GetNumberOfRays());
    rates.push_back(cast / (CpuSeconds() - start));
    wallRates.push_back(cast / (WallSeconds() - wall));
    ratios.push_back(rates.back() / bareRates.back());
  }
  std::printf("%s: bare %.2f Mray/s, viewsheds %.2f Mray/s/core (%.0f %%), %.2f Mray/s in all\n",
    caster.GetName(), Median(bareRates), Median(rates), 100.0 * Median(ratios), Median(wallRates));
  return EXIT_SUCCESS;
}
