// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rate of voxelizing points, in memory, and from a text file of which only voxels stay in memory.
// Times are processor times.
// Usage: BenchVoxelizer [repetitions] [rows of the file]

#include "vtkHeliosPointVoxelizer.h"
#include "vtkHeliosXyzReader.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkVoxelGrid.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace
{

constexpr vtkIdType NumberOfPoints = 10000000;

/// Points of rolling terrain with trees, at UTM coordinates in millimetres, in scan order: along
/// lines, or (scattered) in random order.
class Cloud
{
public:
  Cloud(vtkIdType count, bool isScattered)
    : Count(count)
    , IsScattered(isScattered)
  {
  }

  void GetPoint(vtkIdType i, long long millimetres[3]) const
  {
    const auto side = static_cast<vtkIdType>(std::sqrt(static_cast<double>(this->Count)));
    const vtkIdType place = this->IsScattered ? i * 7368787 % this->Count : i; // a prime
    const long long x = 100000 * (place % side) / side;
    const long long y = 100000 * (place / side) / side;
    const double height = 3000.0 * std::sin(x / 9000.0) + 2000.0 * std::cos(y / 7000.0);
    const unsigned hash = static_cast<unsigned>(place) * 2654435761u;
    const bool isTree = std::sin(x / 2500.0) * std::sin(y / 2500.0) > 0.5;
    millimetres[0] = 476000000LL + x;
    millimetres[1] = 5473000000LL + y;
    millimetres[2] = 110000 + static_cast<long long>(height) + (isTree ? hash % 12000 : hash % 30);
  }

  vtkSmartPointer<vtkPolyData> Make() const
  {
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(this->Count);
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      long long p[3];
      this->GetPoint(i, p);
      coordinates->SetTuple3(i, p[0] / 1000.0, p[1] / 1000.0, p[2] / 1000.0);
    }
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetData(coordinates);
    auto cloud = vtkSmartPointer<vtkPolyData>::New();
    cloud->SetPoints(points);
    return cloud;
  }

  bool Write(const std::string& path) const
  {
    std::FILE* file = std::fopen(path.c_str(), "w");
    for (vtkIdType i = 0; file && i < this->Count; ++i)
    {
      long long p[3];
      this->GetPoint(i, p);
      std::fprintf(file, "%lld.%03lld %lld.%03lld %lld.%03lld\n", p[0] / 1000, p[0] % 1000,
        p[1] / 1000, p[1] % 1000, p[2] / 1000, p[2] % 1000);
    }
    return file && std::fclose(file) == 0;
  }

  /// The number of voxels in integers: sorted and counted, no rounding anywhere.
  vtkIdType CountCells(long long millimetres) const
  {
    long long low[3] = { 1LL << 62, 1LL << 62, 1LL << 62 };
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      long long p[3];
      this->GetPoint(i, p);
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], p[axis]);
      }
    }
    std::vector<long long> keys(static_cast<std::size_t>(this->Count));
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      long long p[3];
      this->GetPoint(i, p);
      keys[static_cast<std::size_t>(i)] = (p[0] - low[0]) / millimetres +
        (((p[1] - low[1]) / millimetres) << 20) + (((p[2] - low[2]) / millimetres) << 40);
    }
    std::sort(keys.begin(), keys.end());
    return std::unique(keys.begin(), keys.end()) - keys.begin();
  }

private:
  vtkIdType Count;
  bool IsScattered;
};

/// Processor time of all threads [s]: other programs do not count.
double GetTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double GetMedian(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

template <typename Work>
double Measure(int repetitions, Work&& work)
{
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i)
  {
    const double start = GetTime();
    work();
    times.push_back(GetTime() - start);
  }
  return GetMedian(times);
}

/// The peak memory of the process so far [MiB].
double GetPeak()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

bool RunInMemory(bool isScattered, double size, int repetitions)
{
  const Cloud source(NumberOfPoints, isScattered);
  const vtkSmartPointer<vtkPolyData> cloud = source.Make();
  const vtkIdType cells = source.CountCells(std::llround(1000.0 * size));
  vtkNew<vtkHeliosPointVoxelizer> voxelizer;
  voxelizer->SetInputData(cloud);
  voxelizer->SetVoxelSize(size);
  const auto run = [&]
  {
    voxelizer->Modified();
    voxelizer->Update();
  };
  const double plain = Measure(repetitions, run);
  if (voxelizer->GetNumberOfVoxels() != cells)
  {
    std::fprintf(stderr, "%lld cells of %g m, but %lld are right\n",
      static_cast<long long>(voxelizer->GetNumberOfVoxels()), size, static_cast<long long>(cells));
    return false;
  }
  const vtkIdType triangles = voxelizer->GetOutput()->GetNumberOfPolys();
  voxelizer->EstimateNormalsOn();
  const double withPlanes = Measure(repetitions, run);

  vtkNew<vtkVoxelGrid> reference; // averages the points of each voxel; no faces
  reference->SetInputData(cloud);
  reference->SetConfigurationStyleToLeafSize();
  reference->SetLeafSize(size, size, size);
  const double grid = Measure(repetitions,
    [&]
    {
      reference->Modified();
      reference->Update();
    });
  std::printf("%-9s %.2f m: %lld cells, %lld triangles: %.2f s, with planes %.2f s; vtkVoxelGrid "
              "%.2f s, ratio %.3f (median of %d)\n",
    isScattered ? "scattered" : "in lines", size, static_cast<long long>(cells),
    static_cast<long long>(triangles), plain, withPlanes, grid, plain / grid, repetitions);
  return true;
}

/// Parses the numbers of a file in a bare loop of std::from_chars: no checks, no storage.
double ParseBare(const std::string& path)
{
  const double start = GetTime();
  std::vector<char> block((1 << 20) + 256);
  std::FILE* file = std::fopen(path.c_str(), "rb");
  std::size_t left = 0;
  double sum = 0.0;
  for (std::size_t n = 1; file && n > 0;)
  {
    n = std::fread(block.data() + left, 1, 1 << 20, file);
    const char* at = block.data();
    const char* const end = at + left + n;
    const char* whole = end;
    while (whole != at && whole[-1] != '\n')
    {
      --whole;
    }
    while (at < whole)
    {
      double value = 0.0;
      at = std::from_chars(at, whole, value).ptr + 1;
      sum += value;
    }
    left = static_cast<std::size_t>(end - whole);
    std::copy(whole, end, block.data());
  }
  if (file)
  {
    std::fclose(file);
  }
  return sum > 0.0 ? GetTime() - start : 0.0;
}

bool RunFromFile(vtkIdType rows, const std::string& path)
{
  const Cloud source(rows, true);
  if (!source.Write(path))
  {
    std::fprintf(stderr, "%s cannot be written\n", path.c_str());
    return false;
  }
  const double before = GetPeak();
  const double bare = ParseBare(path);
  vtkNew<vtkHeliosXyzReader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<vtkHeliosPointVoxelizer> voxelizer;
  voxelizer->SetInputConnection(reader->GetOutputPort());
  voxelizer->SetVoxelSize(0.25);
  const double start = GetTime();
  voxelizer->Update();
  const double seconds = GetTime() - start;
  const double peak = GetPeak();
  const vtkIdType cells = source.CountCells(250);
  if (voxelizer->GetNumberOfPoints() != rows || voxelizer->GetNumberOfVoxels() != cells)
  {
    std::fprintf(stderr, "%lld of %lld rows were read into %lld of %lld cells\n",
      static_cast<long long>(voxelizer->GetNumberOfPoints()), static_cast<long long>(rows),
      static_cast<long long>(voxelizer->GetNumberOfVoxels()), static_cast<long long>(cells));
    return false;
  }
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  std::printf(
    "file      0.25 m: %lld rows, %.0f MB, %lld cells: %.1f s (two passes: %.0f MB/s); "
    "bare from_chars %.1f s, ratio %.2f to twice that; peak memory %.0f MiB, %.0f before\n",
    static_cast<long long>(rows), megabytes, static_cast<long long>(cells), seconds,
    2.0 * megabytes / seconds, bare, seconds / (2.0 * bare), peak, before);
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  const int repetitions = std::max(1, argc > 1 ? std::atoi(argv[1]) : 5);
  const vtkIdType rows = std::max(1000LL, argc > 2 ? std::atoll(argv[2]) : 10000000LL);
  std::string folder = (std::filesystem::temp_directory_path() / "vtkHeliosBenchXXXXXX").string();
  const std::filesystem::path path = std::filesystem::path(::mkdtemp(folder.data())) / "a.xyz";
  const bool good = RunFromFile(rows, path.string());
  std::filesystem::remove_all(folder);
  return good && RunInMemory(false, 0.25, repetitions) && RunInMemory(true, 0.25, repetitions) &&
      RunInMemory(true, 1.0, repetitions)
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
