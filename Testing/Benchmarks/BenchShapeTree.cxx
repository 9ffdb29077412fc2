// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh that deforms: processor time to fit its tree to a frame, and to build it, on one thread.
// Usage: BenchShapeTree [triangles...]; default: 10000 100000 1000000
#include "heliosBeamTree.h"
#include "heliosBenchClock.h"
#include "heliosBoxRefit.h"
#include "heliosMeshFrames.h"
#include "heliosPlacedTree.h"
#include "heliosSceneTree.h"
#include "heliosShapeTree.h"
#include "heliosStopCheck.h"
#include "heliosThreadLoop.h"

#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace
{

constexpr int Repeats = 15;

/// A sphere, dented by waves of a phase.
vtkSmartPointer<vtkPolyData> MakeFrame(vtkIdType triangles, double phase)
{
  const auto rows = static_cast<vtkIdType>(std::sqrt(static_cast<double>(triangles) / 4.0) + 0.5);
  const vtkIdType columns = 2 * rows;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (vtkIdType i = 0; i <= rows; ++i)
  {
    for (vtkIdType k = 0; k < columns; ++k)
    {
      const double a = vtkMath::Pi() * (i + 0.5) / (rows + 1.0);
      const double b = 2.0 * vtkMath::Pi() * k / columns;
      const double r = 1.0 + 0.1 * std::sin(5.0 * a + phase) * std::cos(4.0 * b);
      points->InsertNextPoint(
        r * std::sin(a) * std::cos(b), r * std::sin(a) * std::sin(b), r * std::cos(a));
    }
  }
  for (vtkIdType i = 0; i < rows; ++i)
  {
    for (vtkIdType k = 0; k < columns; ++k)
    {
      const vtkIdType p = i * columns + k;
      const vtkIdType q = i * columns + (k + 1) % columns;
      polys->InsertNextCell({ p, p + columns, q + columns });
      polys->InsertNextCell({ p, q + columns, q });
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

/// Returns the first hits of rays from around a mesh.
double SumRanges(const helios::BeamTree& tree)
{
  double sum = 0.0;
  const helios::PlacedTree placed(tree, nullptr);
  for (int i = 0; i < 2000; ++i)
  {
    const double a = 0.0031 * i;
    vtkHeliosRay ray{ { 5.0 * std::cos(a), 5.0 * std::sin(a), 0.01 * std::sin(7.0 * a) },
      { -std::cos(a), -std::sin(a), 0.3 * std::sin(11.0 * a) } };
    vtkHeliosHit hit{ helios::NoHit, -1 };
    helios::SceneTree::Intersect(placed, ray, hit);
    sum += hit.CellId >= 0 ? hit.Range : 0.0;
  }
  return sum;
}

void Run(vtkIdType triangles)
{
  const helios::OneThreadScope alone;
  helios::MeshFrames frames;
  for (int frame = 0; frame < 3; ++frame)
  {
    frames.Add(MakeFrame(triangles, 0.3 * frame));
  }
  const auto count = static_cast<double>(frames.GetFrame(0)->GetNumberOfPolys());
  const helios::ShapePlan plan(frames);
  helios::MeshShape shape;
  helios::BeamTree tree;
  tree.CopyShape(plan.Tree, shape);
  helios::BoxRefit refit;
  std::vector<double> fits, builds;
  bool isSame = true;
  for (int i = 0; i < Repeats; ++i)
  {
    const std::size_t from = static_cast<std::size_t>(i) % 2;
    shape.From = frames.GetPoints(from);
    shape.To = frames.GetPoints(from + 1);
    const double start = helios::CpuSeconds();
    tree.Fit(plan.Order, 0.0, 1.0, refit);
    fits.push_back((helios::CpuSeconds() - start) / count * 1e9);
    helios::TriangleMesh mesh;
    isSame = isSame && mesh.Set(frames.GetFrame(from)).IsOk();
    helios::StopCheck never(nullptr);
    helios::BeamTree built;
    const double begin = helios::CpuSeconds();
    built.BuildWhole(mesh, never);
    builds.push_back((helios::CpuSeconds() - begin) / count * 1e9);
    isSame = isSame && SumRanges(built) == SumRanges(tree); // the fraction is 0
  }
  std::printf("%9.0f triangles: fit %6.2f ns a triangle, least %6.2f; build %7.1f; ratio %5.1f%s\n",
    count, helios::Median(fits), *std::min_element(fits.begin(), fits.end()),
    helios::Median(builds), helios::Median(builds) / helios::Median(fits),
    isSame ? "" : "  HITS DIFFER");
}

} // namespace

int main(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
  {
    Run(std::atoll(argv[i]));
  }
  for (const vtkIdType triangles : { 10000, 100000, 1000000 })
  {
    argc > 1 ? void() : Run(triangles);
  }
  return 0;
}
