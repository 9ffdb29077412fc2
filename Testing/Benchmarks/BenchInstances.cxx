// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A stand of instances of a few trees on a raster of heights: memory, time to build, beams a second; and, if
// its triangles fit into one mesh, the same of the copies, which must have the same hits.
// Usage: BenchInstances [triangles of a tree [trees [copies: 0 or 1]]]
#include "heliosBenchClock.h"
#include "heliosConeProbe.h"
#include "heliosFlatScene.h"
#include "heliosPose.h"
#include "heliosRandom.h"
#include "heliosSceneGeometry.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace
{

using helios::Vec3;

constexpr int RaysPerBeam = 19;
constexpr int Prototypes = 10;
constexpr double Spacing = 4.0; // distance of the trees [m]

double Draw(std::uint64_t i, std::uint64_t k)
{
  return helios::Uniform4(3, helios::RandomStream::Scene, i, k)[0];
}

/// Makes square leaves in an ellipsoid, 4 m across, from 3 to 15 m; their area equals a leaf area
/// index of 4.
vtkSmartPointer<vtkPolyData> MakeTree(std::uint64_t number, vtkIdType triangles)
{
  const vtkIdType leaves = triangles / 2;
  const double side = std::sqrt(4.0 * vtkMath::Pi() * 4.0 / static_cast<double>(leaves));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->Allocate(4 * leaves);
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  polys->AllocateExact(2 * leaves, 6 * leaves);
  for (vtkIdType i = 0; i < leaves; ++i)
  {
    const auto key = number * 100000000 + static_cast<std::uint64_t>(i);
    const double z = 2 * Draw(key, 0) - 1;
    const double angle = 2 * vtkMath::Pi() * Draw(key, 1);
    const double radius = std::sqrt((1 - z * z) * Draw(key, 2));
    const Vec3 centre(2 * radius * std::cos(angle), 2 * radius * std::sin(angle), 9 + 6 * z);
    const helios::Quaternion turn = helios::AxisAngle(
      { Draw(key, 3) - 0.5, Draw(key, 4) - 0.5, Draw(key, 5) - 0.5 }, 360 * Draw(key, 6));
    const Vec3 u = 0.5 * side * helios::Rotate(turn, { 1, 0, 0 });
    const Vec3 v = 0.5 * side * helios::Rotate(turn, { 0, 1, 0 });
    const vtkIdType first = points->InsertNextPoint((centre - u - v).GetData());
    points->InsertNextPoint((centre + u - v).GetData());
    points->InsertNextPoint((centre + u + v).GetData());
    points->InsertNextPoint((centre - u + v).GetData());
    polys->InsertNextCell({ first, first + 1, first + 2 });
    polys->InsertNextCell({ first, first + 2, first + 3 });
  }
  points->Squeeze();
  auto tree = vtkSmartPointer<vtkPolyData>::New();
  tree->SetPoints(points);
  tree->SetPolys(polys);
  return tree;
}

double GetGround(double x, double y)
{
  return 4 * std::sin(0.02 * x) * std::cos(0.015 * y);
}

/// The ground of a square: a raster of up to 4000 x 4000 pixels of 0.1 m and more.
vtkSmartPointer<vtkImageData> MakeGround(double width)
{
  const double pixel = std::max(0.1, width / 3999.0);
  const int n = static_cast<int>(std::ceil(width / pixel)) + 1;
  vtkNew<vtkFloatArray> heights;
  heights->SetName(vtkHeliosArrayNames::Heights);
  for (int row = 0; row < n; ++row)
  {
    for (int column = 0; column < n; ++column)
    {
      heights->InsertNextValue(static_cast<float>(GetGround(column * pixel, width - row * pixel)));
    }
  }
  vtkNew<vtkDoubleArray> transform;
  transform->SetName(vtkHeliosArrayNames::GeoTransform);
  for (const double value : { -0.5 * pixel, pixel, 0.0, width + 0.5 * pixel, 0.0,
         -pixel }) // the first centre: x 0, y width
  {
    transform->InsertNextValue(value);
  }
  auto ground = vtkSmartPointer<vtkImageData>::New();
  ground->SetDimensions(n, n, 1);
  ground->GetPointData()->SetScalars(heights);
  ground->GetFieldData()->AddArray(transform);
  return ground;
}

vtkSmartPointer<vtkHeliosScene> MakeStand(vtkIdType triangles, int trees, double width)
{
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  for (int i = 0; i < Prototypes; ++i)
  {
    scene->AddPrototype(MakeTree(static_cast<std::uint64_t>(i), triangles));
  }
  scene->AddPrototype(MakeGround(width));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> prototypes;
  prototypes->SetName(vtkHeliosArrayNames::PrototypeIds);
  vtkNew<vtkDoubleArray> orientations, scales;
  orientations->SetName(vtkHeliosArrayNames::Orientation);
  orientations->SetNumberOfComponents(4);
  scales->SetName(vtkHeliosArrayNames::Scale);
  const auto add = [&](const Vec3& at, int prototype, double angle, double scale)
  {
    const helios::Quaternion q = helios::AxisAngle({ 0, 0, 1 }, angle);
    points->InsertNextPoint(at.GetData());
    prototypes->InsertNextValue(prototype);
    orientations->InsertNextTuple4(q.GetW(), q.GetX(), q.GetY(), q.GetZ());
    scales->InsertNextValue(scale);
  };
  add({ 0, 0, 0 }, Prototypes, 0.0, 1.0);
  const int perRow = static_cast<int>(width / Spacing);
  for (int i = 0; i < trees; ++i)
  {
    const auto key = static_cast<std::uint64_t>(i) + 99999999999;
    const double x = Spacing * (i % perRow + 0.2 + 0.6 * Draw(key, 0));
    const double y = Spacing * (i / perRow + 0.2 + 0.6 * Draw(key, 1));
    add({ x, y, GetGround(x, y) }, static_cast<int>(Prototypes * Draw(key, 2)), 360 * Draw(key, 3),
      0.7 + 0.6 * Draw(key, 4));
  }
  vtkNew<vtkPolyData> instances;
  instances->SetPoints(points);
  instances->GetPointData()->AddArray(prototypes);
  instances->GetPointData()->AddArray(orientations);
  instances->GetPointData()->AddArray(scales);
  scene->SetInstances(instances);
  return scene;
}

/// Beams of 0.3 mrad from a point to points of the ground.
std::vector<vtkHeliosRay> MakeRays(const Vec3& from, const Vec3& middle, double reach, int beams)
{
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < beams; ++i)
  {
    const double angle = 2 * vtkMath::Pi() * (i % 500) / 500;
    const double r = reach * std::sqrt((i / 500 + 0.5) / (beams / 500 + 1));
    const Vec3 aim = middle + Vec3(r * std::cos(angle), r * std::sin(angle), 8.0 * (i % 2));
    const Vec3 axis = (aim - from).Normalized();
    for (int k = 0; k < RaysPerBeam; ++k)
    {
      const auto key = static_cast<std::uint64_t>(i * RaysPerBeam + k) + 5000000000000;
      const Vec3 aside(Draw(key, 0) - 0.5, Draw(key, 1) - 0.5, Draw(key, 2) - 0.5);
      const Vec3 d = axis + aside * (k == 0 ? 0.0 : 3e-4);
      rays.push_back({ { from[0], from[1], from[2] }, { d[0], d[1], d[2] } });
    }
  }
  return rays;
}

/// Traces the beams; returns their time [us].
double Trace(const vtkHeliosRayCaster* caster, const std::vector<vtkHeliosRay>& rays,
  std::vector<vtkHeliosHit>& hits)
{
  hits.assign(rays.size(), { 0.0, -1 });
  const auto beams = static_cast<vtkIdType>(rays.size()) / RaysPerBeam;
  std::vector<double> times;
  for (int i = 0; i < 3; ++i)
  {
    const double start = helios::CpuSeconds();
    caster->IntersectBeams(rays.data(), hits.data(), RaysPerBeam, beams);
    times.push_back((helios::CpuSeconds() - start) / static_cast<double>(beams) * 1e6);
  }
  return helios::Median(times);
}

/// The time of collecting the triangles of a cone [us].
double Collect(vtkHeliosRayCaster* caster, const std::vector<vtkHeliosRay>& rays, double& triangles)
{
  helios::ConeView view;
  const helios::ConeProbe* probe = caster->GetConeProbe();
  triangles = 0.0;
  const double start = helios::CpuSeconds();
  std::size_t count = 0;
  for (std::size_t i = 0; i < rays.size(); i += RaysPerBeam, ++count)
  {
    const Vec3 axis = Vec3(rays[i].Direction).Normalized();
    probe->Collect(rays[i].Origin, axis.GetData(), 1.5e-4, 0.0, 30000, view);
    triangles += static_cast<double>(view.Triangles.size());
  }
  triangles /= static_cast<double>(count);
  return (helios::CpuSeconds() - start) / static_cast<double>(count) * 1e6;
}

bool AreSame(const std::vector<vtkHeliosHit>& a, const std::vector<vtkHeliosHit>& b)
{
  bool areSame = a.size() == b.size();
  for (std::size_t i = 0; areSame && i < a.size(); ++i)
  {
    areSame = a[i].CellId == b[i].CellId && (a[i].CellId < 0 || a[i].Range == b[i].Range);
  }
  return areSame;
}

} // namespace

int main(int argc, char* argv[])
{
  const vtkIdType triangles = argc > 1 ? std::atoll(argv[1]) : 100000;
  const int trees = argc > 2 ? std::atoi(argv[2]) : 100;
  const bool hasCopies = argc > 3 ? std::atoi(argv[3]) != 0 : true;
  const double width = Spacing * std::ceil(std::sqrt(trees));
  const auto scene = MakeStand(triangles, trees, width);
  std::printf("%d trees of %lld triangles, %.3g in all; %.0f m of ground\n", trees,
    static_cast<long long>(triangles), static_cast<double>(scene->GetNumberOfTriangles()), width);

  vtkNew<vtkHeliosBeamRayCaster> caster, flat;
  double start = helios::WallSeconds();
  if (!caster->Build(scene))
  {
    return 1;
  }
  std::printf("instances: built in %.2f s, scene and trees %.0f MiB, peak %.0f MiB\n",
    helios::WallSeconds() - start,
    static_cast<double>(scene->GetActualMemorySize()) / 1024.0 +
      static_cast<double>(caster->GetMemorySize()) / 1048576.0,
    helios::PeakMebibytes());
  vtkNew<vtkPolyData> mesh;
  if (hasCopies)
  {
    start = helios::WallSeconds();
    const helios::Status status = helios::FlattenScene(scene, mesh);
    if (!status.IsOk() || !flat->Build(mesh))
    {
      std::printf("%s\n", status.Message().c_str());
      return 1;
    }
    std::printf("copies: built in %.2f s, peak %.0f MiB\n", helios::WallSeconds() - start,
      helios::PeakMebibytes());
  }
  const Vec3 middle(0.5 * width, 0.5 * width, 0.0);
  struct Scan
  {
    const char* Name;
    double Height;
    double Reach;
  };
  bool isRight = true;
  for (const Scan& scan : { Scan{ "tripod", 1.5, 40.0 }, Scan{ "aircraft", 800.0, 0.4 * width } })
  {
    const Vec3 from = middle + Vec3(0.1, 0.2, scan.Height + 4.0);
    const auto rays = MakeRays(from, middle, std::min(scan.Reach, 0.49 * width), 20000);
    std::vector<vtkHeliosHit> hits, truth;
    double found = 0.0;
    const double own = Trace(caster, rays, hits);
    const double cone = Collect(caster, rays, found);
    std::printf("%s: beam %.2f us, cone of %.0f triangles %.2f us", scan.Name, own, found, cone);
    if (hasCopies)
    {
      const double other = Trace(flat, rays, truth);
      isRight = isRight && AreSame(hits, truth);
      std::printf("; copies: beam %.2f us, cone %.2f us; hits %s", other,
        Collect(flat, rays, found), isRight ? "equal" : "DIFFER");
    }
    std::printf("\n");
  }
  return isRight ? 0 : 1;
}
