// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Cost of repairing and simplifying: triangles/s, number left at 1 mm, 1 cm and 10 cm, and the
// ratio of times to OpenMesh's own decimation, which gives no guarantee.
//   BenchMeshCare [squares a side of the terrain, 500]
#include "heliosTriangleMesh.h"
#include "vtkHeliosMeshRepair.h"
#include "vtkHeliosMeshSimplify.h"
#include "vtkHeliosSyntheticScene.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <stdexcept>

namespace
{

struct Traits : public OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// Processor time: other programs do not count.
double GetSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Mesh MakeMesh(vtkPolyData* scene)
{
  helios::TriangleMesh triangles;
  if (const helios::Status status = triangles.Set(scene); !status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  Mesh mesh;
  const double* points = triangles.GetPoints();
  for (vtkIdType i = 0; i < triangles.GetNumberOfPoints(); ++i)
  {
    mesh.add_vertex(OpenMesh::Vec3d(points + 3 * i) - OpenMesh::Vec3d(points));
  }
  const vtkTypeInt32* corners = triangles.GetCorners();
  for (vtkIdType i = 0; i < triangles.GetNumberOfTriangles(); ++i, corners += 3)
  {
    mesh.add_face(Mesh::VertexHandle(corners[0]), Mesh::VertexHandle(corners[1]),
      Mesh::VertexHandle(corners[2]));
  }
  return mesh;
}

/// OpenMesh's own: quadrics and ModHausdorff at half the distance, borders locked.
double TimeOpenMesh(vtkPolyData* scene, double distance, std::size_t& left)
{
  const double start = GetSeconds();
  Mesh mesh = MakeMesh(scene);
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  for (const auto vertex : mesh.vertices())
  {
    mesh.status(vertex).set_locked(mesh.is_boundary(vertex));
  }
  {
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
    OpenMesh::Decimater::ModHausdorffT<Mesh>::Handle hausdorff;
    decimater.add(quadric);
    decimater.add(hausdorff);
    decimater.module(quadric).unset_max_err();
    decimater.module(hausdorff).set_tolerance(0.5 * distance);
    decimater.initialize();
    decimater.decimate();
    mesh.garbage_collection();
  }
  left = mesh.n_faces();
  return GetSeconds() - start;
}

bool Repair(const char* name, vtkPolyData* scene)
{
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(scene);
  repair->MergePointsOn();
  const double start = GetSeconds();
  repair->Update();
  const double seconds = GetSeconds() - start;
  const auto count = static_cast<double>(scene->GetNumberOfCells());
  const vtkIdType dropped =
    repair->GetNumberOfDuplicateTriangles() + repair->GetNumberOfDegenerateTriangles();
  std::printf("%-8s repair   %9lld triangles in %6.2f s, %5.2f million/s\n", name,
    static_cast<long long>(scene->GetNumberOfCells()), seconds, 1e-6 * count / seconds);
  return repair->GetOutput()->GetNumberOfCells() + dropped == scene->GetNumberOfCells() &&
    repair->GetNumberOfNonFiniteTriangles() == 0;
}

bool Simplify(const char* name, vtkPolyData* scene, double distance, bool compare)
{
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputData(scene);
  simplify->SetMaximumDistance(distance);
  const double start = GetSeconds();
  simplify->Update();
  const double seconds = GetSeconds() - start;
  const auto left = static_cast<double>(simplify->GetOutput()->GetNumberOfCells());
  if (left == 0.0 || simplify->GetVerifiedDistance() > distance)
  {
    std::fprintf(stderr, "%s: %g m is exceeded\n", name, distance);
    return false;
  }
  std::printf("%-8s %5.3f m: %9lld triangles left, %5.1f %%; proved %7.5f m; %6.1f s", name,
    distance, static_cast<long long>(left),
    100.0 * left / static_cast<double>(scene->GetNumberOfCells()), simplify->GetVerifiedDistance(),
    seconds);
  if (compare)
  {
    std::size_t bareLeft = 0;
    const double bare = TimeOpenMesh(scene, distance, bareLeft);
    std::printf(
      "; OpenMesh alone %zu left, %6.1f s, ratio of times %.2f", bareLeft, bare, seconds / bare);
  }
  std::printf("\n");
  std::fflush(stdout);
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  vtkNew<vtkHeliosSyntheticScene> terrain;
  terrain->SetKindToTerrain();
  terrain->SetSize(250.0);
  terrain->SetHeight(10.0);
  terrain->SetResolution(std::max(2, argc > 1 ? std::atoi(argv[1]) : 500));
  terrain->SetOrigin(500000.0, 5500000.0, 300.0);
  terrain->Update();
  vtkNew<vtkHeliosSyntheticScene> canopy;
  canopy->SetKindToCanopy();
  canopy->SetOrigin(500000.0, 5500000.0, 300.0);
  canopy->Update();

  bool good = Repair("terrain", terrain->GetOutput()) && Repair("canopy", canopy->GetOutput());
  for (const double distance : { 0.001, 0.01, 0.1 })
  {
    good = good && Simplify("terrain", terrain->GetOutput(), distance, true) &&
      Simplify("canopy", canopy->GetOutput(), distance, false);
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
