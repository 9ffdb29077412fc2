// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of vtkHeliosObjSceneReader for a terrain of two million triangles, against a bare
// tinyobjloader in double precision on the same files.
// Usage: BenchObjReader [repetitions]

#include "vtkHeliosObjSceneReader.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace
{

constexpr std::int64_t Side = 1001; // vertices
constexpr vtkIdType NumberOfTriangles = 2 * (Side - 1) * (Side - 1);

/// A grid of hills; coordinates are integers in a decimal unit, so that their doubles are known.
struct Terrain
{
  const char* Name;
  int Decimals;
  std::int64_t UnitsPerMetre;
  std::int64_t Origin[3]; // [m]

  /// Coordinates of a vertex [units].
  void GetVertex(std::int64_t i, std::int64_t p[3]) const
  {
    const std::int64_t x = i % Side;
    const std::int64_t y = i / Side;
    p[0] = this->Origin[0] * this->UnitsPerMetre + x * 513 * this->UnitsPerMetre / 1000;
    p[1] = this->Origin[1] * this->UnitsPerMetre + y * 487 * this->UnitsPerMetre / 1000;
    p[2] = this->Origin[2] * this->UnitsPerMetre + (x * x * 7919 + y * y * 104729 + x * y) % 9973;
  }
};

bool WriteTerrain(const Terrain& terrain, const std::string& path)
{
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file)
  {
    return false;
  }
  for (std::int64_t i = 0; i < Side * Side; ++i)
  {
    std::int64_t p[3];
    terrain.GetVertex(i, p);
    std::fputc('v', file);
    for (const std::int64_t units : p)
    {
      std::fprintf(file, " %s%lld.%0*lld", units < 0 ? "-" : "",
        static_cast<long long>(std::abs(units) / terrain.UnitsPerMetre), terrain.Decimals,
        static_cast<long long>(std::abs(units) % terrain.UnitsPerMetre));
    }
    std::fputc('\n', file);
  }
  for (std::int64_t y = 0; y + 1 < Side; ++y)
  {
    for (std::int64_t x = 1; x < Side; ++x)
    {
      const long long a = y * Side + x;
      std::fprintf(file, "f %lld %lld %lld\nf %lld %lld %lld\n", a, a + 1, a + Side, a + 1,
        a + Side + 1, a + Side);
    }
  }
  return std::fclose(file) == 0;
}

/// Every point is the double nearest to its decimals: an integer quotient rounds correctly.
bool IsRight(const Terrain& terrain, vtkPolyData* scene)
{
  if (scene->GetNumberOfCells() != NumberOfTriangles || scene->GetNumberOfPoints() != Side * Side)
  {
    return false;
  }
  for (std::int64_t i = 0; i < Side * Side; ++i)
  {
    std::int64_t units[3];
    terrain.GetVertex(i, units);
    const double* p = scene->GetPoint(i);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (p[axis] != static_cast<double>(units[axis]) / static_cast<double>(terrain.UnitsPerMetre))
      {
        return false;
      }
    }
  }
  return true;
}

double GetMedian(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double Seconds(std::chrono::steady_clock::time_point since)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

bool RunOurs(const Terrain& terrain, const std::string& path, std::vector<double>& times)
{
  vtkNew<vtkHeliosObjSceneReader> reader;
  reader->SetFileName(path.c_str());
  const auto start = std::chrono::steady_clock::now();
  reader->Update();
  times.push_back(Seconds(start));
  if (times.size() == 1)
  {
    std::printf("%-6s scene in memory: %.1f bytes per triangle\n", terrain.Name,
      1024.0 * reader->GetOutput()->GetActualMemorySize() / NumberOfTriangles);
  }
  return IsRight(terrain, reader->GetOutput());
}

bool RunTiny(const std::string& path, std::vector<double>& times)
{
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warnings, errors;
  const auto start = std::chrono::steady_clock::now();
  const bool good =
    tinyobj::LoadObj(&attributes, &shapes, &materials, &warnings, &errors, path.c_str());
  times.push_back(Seconds(start));
  return good && shapes.size() == 1 && attributes.vertices.size() == 3 * Side * Side &&
    shapes[0].mesh.num_face_vertices.size() == static_cast<std::size_t>(NumberOfTriangles);
}

bool Compare(const Terrain& terrain, const std::string& folder, int repetitions)
{
  const std::string path = folder + '/' + terrain.Name + ".obj";
  if (!WriteTerrain(terrain, path))
  {
    std::fprintf(stderr, "%s cannot be written\n", path.c_str());
    return false;
  }
  std::vector<double> ours, tiny;
  for (int i = 0; i < repetitions; ++i)
  {
    if (!RunOurs(terrain, path, ours) || !RunTiny(path, tiny))
    {
      std::fprintf(stderr, "%s was read wrongly\n", path.c_str());
      return false;
    }
  }
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  const double median = GetMedian(ours);
  std::printf("%-6s %lld triangles, %.0f MB: vtkHelios %.3f s (%.0f MB/s), tinyobjloader %.3f s, "
              "ratio %.3f (median of %d)\n",
    terrain.Name, static_cast<long long>(NumberOfTriangles), megabytes, median, megabytes / median,
    GetMedian(tiny), median / GetMedian(tiny), repetitions);
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  namespace fs = std::filesystem;
  const int repetitions = std::max(1, argc > 1 ? std::atoi(argv[1]) : 5);
  std::string name = (fs::temp_directory_path() / "vtkHeliosBenchXXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  const Terrain local = { "local", 6, 1000000, { -256, -243, 10 } };
  const Terrain utm = { "utm", 3, 1000, { 476000, 5473000, 110 } };
  const bool good =
    Compare(local, folder.string(), repetitions) && Compare(utm, folder.string(), repetitions);
  fs::remove_all(folder);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
