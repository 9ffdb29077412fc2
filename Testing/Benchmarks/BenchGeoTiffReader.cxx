// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of vtkHeliosGeoTiffSceneReader for a mesh of 4000 x 4000 heights, against a bare GDAL read
// of the band and the allocation of the mesh's arrays.
// Usage: BenchGeoTiffReader [repetitions [side]]

#include "heliosTriangleMesh.h"
#include "vtkHeliosGeoTiffSceneReader.h"

#include <gdal.h>
#include <gdal_frmts.h>

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace
{

struct Layout
{
  const char* Name;
  std::vector<const char*> Options; // options of GDAL's writer
  bool HasHoles;                    // one pixel in 61
};

struct Raster
{
  std::int64_t Side;
  bool HasHoles;
  static constexpr float NoData = -9999.0f;

  bool IsHole(std::int64_t i) const { return this->HasHoles && i % 61 == 0; }
  float GetValue(std::int64_t i) const // exact in single precision
  {
    const std::int64_t x = i % this->Side;
    const std::int64_t y = i / this->Side;
    return this->IsHole(i) ? NoData : static_cast<float>((x * 3 + y * 5 + x * y / 4096) % 8192) / 8;
  }
};

bool Write(const Raster& raster, const Layout& layout, const std::string& path)
{
  const int side = static_cast<int>(raster.Side);
  std::vector<const char*> options = layout.Options;
  options.push_back(nullptr);
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), side, side, 1,
    GDT_Float32, const_cast<char**>(options.data()));
  if (!file)
  {
    return false;
  }
  double transform[6] = { 476000.0, 0.5, 0.0, 5473000.0, 0.0, -0.5 };
  GDALSetGeoTransform(file, transform);
  GDALRasterBandH band = GDALGetRasterBand(file, 1);
  GDALSetRasterNoDataValue(band, Raster::NoData);
  std::vector<float> values(static_cast<std::size_t>(raster.Side * raster.Side));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = raster.GetValue(static_cast<std::int64_t>(i));
  }
  const bool isGood = GDALRasterIO(band, GF_Write, 0, 0, side, side, values.data(), side, side,
                        GDT_Float32, 0, 0) == CE_None;
  GDALClose(file);
  return isGood;
}

/// Every point matches its pixel, and every triangle joins neighbours, in order.
bool IsRight(const Raster& raster, vtkPolyData* scene)
{
  const std::int64_t n = raster.Side;
  helios::TriangleMesh mesh;
  if (!mesh.Set(scene).IsOk())
  {
    return false;
  }
  std::vector<std::int64_t>
    pixels; // share of the points; holes are isolated, so no point is without triangle
  for (std::int64_t i = 0; i < n * n; ++i)
  {
    if (!raster.IsHole(i))
    {
      const double* p = mesh.GetPoints() + 3 * pixels.size();
      if (p[0] != 476000.25 + 0.5 * static_cast<double>(i % n) ||
        p[1] != 5472999.75 - 0.5 * static_cast<double>(i / n) ||
        p[2] != static_cast<double>(raster.GetValue(i)))
      {
        return false;
      }
      pixels.push_back(i);
    }
  }
  vtkIdType triangle = 0;
  const auto isNext = [&](std::int64_t a, std::int64_t b, std::int64_t c)
  {
    if (raster.IsHole(a) || raster.IsHole(b) || raster.IsHole(c))
    {
      return true;
    }
    const vtkTypeInt32* corners = mesh.GetCorners() + 3 * triangle++;
    return pixels[corners[0]] == a && pixels[corners[1]] == b && pixels[corners[2]] == c;
  };
  for (std::int64_t i = 0; i < n * (n - 1); ++i)
  {
    if (i % n + 1 < n && !(isNext(i, i + n, i + 1) && isNext(i + n, i + n + 1, i + 1)))
    {
      return false;
    }
  }
  return triangle == mesh.GetNumberOfTriangles() &&
    static_cast<std::int64_t>(pixels.size()) == mesh.GetNumberOfPoints();
}

double Seconds(std::chrono::steady_clock::time_point since)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

double GetMedian(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double RunOurs(const Raster& raster, const std::string& path, bool isChecked, double& bytes)
{
  vtkNew<vtkHeliosGeoTiffSceneReader> reader;
  reader->SetFileName(path.c_str());
  const auto start = std::chrono::steady_clock::now();
  reader->Update();
  const double seconds = Seconds(start);
  vtkPolyData* scene = reader->GetOutput();
  bytes = 1024.0 * scene->GetActualMemorySize() / static_cast<double>(scene->GetNumberOfCells());
  return isChecked && !IsRight(raster, scene) ? -1.0 : seconds;
}

/// Reads the band in its stored type.
double RunRead(const Raster& raster, const std::string& path)
{
  const int side = static_cast<int>(raster.Side);
  const auto start = std::chrono::steady_clock::now();
  GDALDatasetH file = GDALOpen(path.c_str(), GA_ReadOnly);
  const std::unique_ptr<float[]> values(new float[raster.Side * raster.Side]);
  const bool isGood = GDALRasterIO(GDALGetRasterBand(file, 1), GF_Read, 0, 0, side, side,
                        values.get(), side, side, GDT_Float32, 0, 0) == CE_None;
  GDALClose(file);
  const double seconds = Seconds(start);
  return isGood && values[1] == raster.GetValue(1) ? seconds : -1.0;
}

/// Allocates the memory of a scene of this many points and triangles, and writes to it once.
double RunAllocate(std::int64_t points, std::int64_t triangles)
{
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::unique_ptr<char[]>> arrays;
  for (const std::int64_t size : { 24 * points, 12 * triangles, 4 * triangles + 4, 4 * triangles })
  {
    arrays.emplace_back(new char[size]);
    std::memset(arrays.back().get(), static_cast<int>(arrays.size()), size);
  }
  const double seconds = Seconds(start);
  return arrays[1][12 * triangles - 1] == 2 ? seconds : -1.0;
}

bool Compare(const Layout& layout, const std::string& path, std::int64_t side, int repetitions)
{
  const Raster raster{ side, layout.HasHoles };
  if (!Write(raster, layout, path))
  {
    std::fprintf(stderr, "%s cannot be written\n", path.c_str());
    return false;
  }
  std::vector<double> ours, reads, allocations;
  double bytes = 0.0;
  for (int i = 0; i < repetitions; ++i)
  {
    ours.push_back(RunOurs(raster, path, i == 0, bytes));
    reads.push_back(RunRead(raster, path));
    allocations.push_back(RunAllocate(side * side, 2 * (side - 1) * (side - 1)));
    if (ours.back() < 0.0 || reads.back() < 0.0 || allocations.back() < 0.0)
    {
      std::fprintf(stderr, "%s was read wrongly\n", layout.Name);
      return false;
    }
  }
  const double bare = GetMedian(reads) + GetMedian(allocations);
  std::printf("%-16s %lld x %lld: vtkHelios %.3f s, GDAL %.3f s + allocation %.3f s, ratio %.2f; "
              "%.1f bytes per triangle (median of %d)\n",
    layout.Name, static_cast<long long>(side), static_cast<long long>(side), GetMedian(ours),
    GetMedian(reads), GetMedian(allocations), GetMedian(ours) / bare, bytes, repetitions);
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  namespace fs = std::filesystem;
  const int repetitions = std::max(1, argc > 1 ? std::atoi(argv[1]) : 5);
  const std::int64_t side = std::max(2, argc > 2 ? std::atoi(argv[2]) : 4000);
  GDALRegister_GTiff();
  std::string folder = (fs::temp_directory_path() / "vtkHeliosBenchXXXXXX").string();
  const fs::path path = fs::path(::mkdtemp(folder.data())) / "a.tif";
  const Layout layouts[] = { { "strips", {}, false }, { "strips, holes", {}, true },
    { "tiles", { "TILED=YES" }, false },
    { "tiles, deflate", { "TILED=YES", "COMPRESS=DEFLATE", "PREDICTOR=3" }, true } };
  const bool isGood = std::all_of(std::begin(layouts), std::end(layouts),
    [&](const Layout& layout) { return Compare(layout, path.string(), side, repetitions); });
  fs::remove_all(folder);
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
