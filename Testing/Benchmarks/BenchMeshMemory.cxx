// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Bytes a triangle of a mesh in memory and of its tree, at rest and at the peak, time to build, time
// of a pulse under a tripod.
// Usage: BenchMeshMemory [millions of triangles [hills|soup [pulses]]]

#include "heliosBenchClock.h"
#include "heliosBenchScenes.h"
#include "vtkHeliosBeamRayCaster.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace
{

using helios::Vec3;

constexpr int RaysPerBeam = 19;
constexpr double Width = 1000.0; // [m]

/// Arrays of their final size: what a reader would have.
struct Arrays
{
  vtkNew<vtkDoubleArray> Points;
  vtkNew<vtkTypeInt32Array> Offsets;
  vtkNew<vtkTypeInt32Array> Corners;

  Arrays(vtkIdType points, vtkIdType triangles)
  {
    this->Points->SetNumberOfComponents(3);
    this->Points->SetNumberOfTuples(points);
    this->Corners->SetNumberOfValues(3 * triangles);
    this->Offsets->SetNumberOfValues(triangles + 1);
    for (vtkIdType i = 0; i <= triangles; ++i)
    {
      this->Offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
    }
  }

  void SetPoint(vtkIdType i, const Vec3& p)
  {
    const Vec3 moved = p + helios::BenchOffset;
    this->Points->SetTypedTuple(i, moved.GetData());
  }
  void SetTriangle(vtkIdType i, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    vtkTypeInt32* to = this->Corners->GetPointer(3 * i);
    to[0] = static_cast<vtkTypeInt32>(a);
    to[1] = static_cast<vtkTypeInt32>(b);
    to[2] = static_cast<vtkTypeInt32>(c);
  }

  vtkSmartPointer<vtkPolyData> Finish()
  {
    auto scene = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    points->SetData(this->Points);
    vtkNew<vtkCellArray> polys;
    polys->SetData(this->Offsets, this->Corners);
    scene->SetPoints(points);
    scene->SetPolys(polys);
    return scene;
  }
};

/// Hills that share their points.
vtkSmartPointer<vtkPolyData> MakeHills(vtkIdType triangles)
{
  const auto cells = static_cast<vtkIdType>(std::sqrt(static_cast<double>(triangles / 2)));
  Arrays arrays((cells + 1) * (cells + 1), 2 * cells * cells);
  const double step = Width / static_cast<double>(cells);
  for (vtkIdType j = 0; j <= cells; ++j)
  {
    for (vtkIdType i = 0; i <= cells; ++i)
    {
      const double x = step * static_cast<double>(i);
      const double y = step * static_cast<double>(j);
      arrays.SetPoint(j * (cells + 1) + i, { x, y, helios::GetHillHeight(x, y) });
    }
  }
  for (vtkIdType j = 0; j < cells; ++j)
  {
    for (vtkIdType i = 0; i < cells; ++i)
    {
      const vtkIdType a = j * (cells + 1) + i;
      const vtkIdType first = 2 * (j * cells + i);
      arrays.SetTriangle(first, a, a + 1, a + cells + 2);
      arrays.SetTriangle(first + 1, a, a + cells + 2, a + cells + 1);
    }
  }
  return arrays.Finish();
}

/// Triangles of random places and directions up to 10 m high, each with points of its own.
vtkSmartPointer<vtkPolyData> MakeSoup(vtkIdType triangles)
{
  Arrays arrays(3 * triangles, triangles);
  const double size = 0.5 * Width / std::sqrt(static_cast<double>(triangles));
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    const auto item = static_cast<std::uint64_t>(i);
    const auto place = helios::Uniform4(1, helios::RandomStream::Scene, item, 0);
    const Vec3 middle(Width * place[0], Width * place[1], 10 * place[2]);
    for (int corner = 0; corner < 3; ++corner)
    {
      const auto side = helios::Uniform4(
        1, helios::RandomStream::Scene, item, 1 + static_cast<std::uint64_t>(corner));
      arrays.SetPoint(
        3 * i + corner, middle + Vec3(side[0] - 0.5, side[1] - 0.5, side[2] - 0.5) * (2 * size));
    }
    arrays.SetTriangle(i, 3 * i, 3 * i + 1, 3 * i + 2);
  }
  return arrays.Finish();
}

/// Pulses of a divergence of 0.3 mrad from a height in the middle.
std::vector<vtkHeliosRay> MakeRays(double height, int pulses)
{
  std::vector<vtkHeliosRay> rays;
  const Vec3 from = helios::BenchOffset + Vec3(0.5 * Width, 0.5 * Width, height);
  for (int i = 0; i < pulses; ++i)
  {
    const double angle = 2 * vtkMath::Pi() * (i % 1000) / 1000;
    const double down = 0.9 * i / pulses;
    const Vec3 axis = Vec3(std::cos(angle), std::sin(angle), -down).Normalized();
    for (int k = 0; k < RaysPerBeam; ++k)
    {
      const auto u = helios::Uniform4(2, helios::RandomStream::Scene, static_cast<std::uint64_t>(i),
        static_cast<std::uint64_t>(k));
      const Vec3 d = axis + Vec3(u[0] - 0.5, u[1] - 0.5, u[2] - 0.5) * 3e-4;
      rays.push_back({ { from[0], from[1], from[2] }, { d[0], d[1], d[2] } });
    }
  }
  return rays;
}

void MeasurePulses(const vtkHeliosRayCaster* caster, double height, int pulses)
{
  const std::vector<vtkHeliosRay> rays = MakeRays(height, pulses);
  std::vector<vtkHeliosHit> hits(rays.size());
  std::vector<double> seconds;
  for (int i = 0; i < 5; ++i)
  {
    const double start = helios::CpuSeconds();
    caster->IntersectBeams(rays.data(), hits.data(), RaysPerBeam, pulses);
    seconds.push_back(helios::CpuSeconds() - start);
  }
  vtkIdType found = 0;
  double sum = 0.0;
  for (const vtkHeliosHit& hit : hits)
  {
    found += hit.CellId >= 0 ? 1 : 0;
    sum += hit.CellId >= 0 ? hit.Range + 1e-6 * static_cast<double>(hit.CellId % 1000) : 0.0;
  }
  std::printf("pulses of %d rays: %.3f us, %lld hits, sum %.9f\n", RaysPerBeam,
    helios::Median(seconds) / pulses * 1e6, static_cast<long long>(found), sum);
}

} // namespace

int main(int argc, char** argv)
{
  const double millions = argc > 1 ? std::atof(argv[1]) : 1.0;
  const bool isSoup = argc > 2 && std::strcmp(argv[2], "soup") == 0;
  const int pulses = argc > 3 ? std::atoi(argv[3]) : 100000;
  const double before = helios::PeakMebibytes();
  const auto asked = static_cast<vtkIdType>(1e6 * millions);
  const vtkSmartPointer<vtkPolyData> scene = isSoup ? MakeSoup(asked) : MakeHills(asked);
  const auto count = static_cast<double>(scene->GetNumberOfCells());
  const double mesh = 1024.0 * static_cast<double>(scene->GetActualMemorySize());

  const double start = helios::WallSeconds();
  vtkNew<vtkHeliosBeamRayCaster> caster;
  if (!caster->Build(scene))
  {
    return EXIT_FAILURE;
  }
  const double built = helios::WallSeconds() - start;
  const auto tree = static_cast<double>(caster->GetMemorySize());
  const double peak = 1048576.0 * (helios::PeakMebibytes() - before);
  std::printf("%.0f triangles: mesh %.1f, tree %.1f bytes each, peak %.1f; built in %.2f s\n",
    count, mesh / count, tree / count, peak / count, built);
  const double ground = isSoup ? 6.0 : helios::GetHillHeight(0.5 * Width, 0.5 * Width);
  MeasurePulses(caster, ground + 2, pulses);
  return EXIT_SUCCESS;
}
