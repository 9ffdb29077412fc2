// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How many echoes a second one core writes as text. The reference is the same columns through
// fprintf. Usage: BenchTextWriter [repetitions]

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPointTextWriter.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <time.h>

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr vtkIdType Count = 1000000;

double CpuSeconds()
{
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

template <typename ArrayT, typename ValueT>
void AddColumn(vtkPolyData* echoes, const char* name, ValueT value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfValues(Count);
  for (vtkIdType i = 0; i < Count; ++i)
  {
    array->SetValue(i, static_cast<typename ArrayT::ValueType>(value(static_cast<double>(i))));
  }
  echoes->GetPointData()->AddArray(array);
}

/// Echoes of an airborne scan in UTM coordinates.
vtkSmartPointer<vtkPolyData> MakeEchoes()
{
  auto echoes = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < Count; ++i)
  {
    const double x = static_cast<double>(i);
    points->InsertNextPoint(
      478233.51 + 123.4567 * std::sin(x), 5471966.6981 + 1e-4 * x, 112.5 + 30 * std::cos(0.37 * x));
  }
  echoes->SetPoints(points);
  AddColumn<vtkDoubleArray>(echoes, names::GpsTime, [](double i) { return 100 + i / 300000; });
  AddColumn<vtkTypeInt64Array>(echoes, names::PulseIds, [](double i) { return 20000000 + i; });
  AddColumn<vtkUnsignedCharArray>(echoes, names::ReturnNumber, [](double) { return 1; });
  AddColumn<vtkUnsignedCharArray>(echoes, names::NumberOfReturns, [](double) { return 2; });
  AddColumn<vtkDoubleArray>(
    echoes, names::Amplitude, [](double i) { return 1e-7 * (1.1 + std::sin(i)); });
  AddColumn<vtkDoubleArray>(
    echoes, names::EchoWidth, [](double i) { return 4.1 + 0.1 * std::cos(i); });
  AddColumn<vtkIntArray>(echoes, names::PartIds, [](double i) { return std::fmod(i, 7); });
  AddColumn<vtkIntArray>(echoes, names::ClassificationIds, [](double) { return 2; });
  return echoes;
}

double WriteOurs(vtkPolyData* echoes, const std::string& path)
{
  const double start = CpuSeconds();
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  const bool good = writer->Open() && writer->Write(echoes) && writer->Close();
  return good ? CpuSeconds() - start : -1.0;
}

double WritePlain(vtkPolyData* echoes, const std::string& path)
{
  const double start = CpuSeconds();
  std::FILE* file = std::fopen(path.c_str(), "w");
  vtkPointData* data = echoes->GetPointData();
  const auto value = [data](const char* name, vtkIdType i)
  { return data->GetArray(name)->GetComponent(i, 0); };
  for (vtkIdType i = 0; i < Count; ++i)
  {
    double p[3];
    echoes->GetPoint(i, p);
    std::fprintf(file, "%.4f %.4f %.4f %.4f %.4f %d %d %lld %d %d %.9f\n", p[0], p[1], p[2],
      1e9 * value(names::Amplitude, i), value(names::EchoWidth, i),
      static_cast<int>(value(names::ReturnNumber, i)),
      static_cast<int>(value(names::NumberOfReturns, i)),
      static_cast<long long>(value(names::PulseIds, i)), static_cast<int>(value(names::PartIds, i)),
      static_cast<int>(value(names::ClassificationIds, i)), value(names::GpsTime, i));
  }
  std::fclose(file);
  return CpuSeconds() - start;
}

std::string Read(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

} // namespace

int main(int argc, char* argv[])
{
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  const auto folder = std::filesystem::temp_directory_path() / "vtkHeliosBenchTextWriter";
  std::filesystem::create_directories(folder);
  const std::string ours = (folder / "ours.xyz").string();
  const std::string plain = (folder / "plain.xyz").string();
  const auto echoes = MakeEchoes();
  vtkSMPTools::Initialize(1);
  WriteOurs(echoes, ours);
  WritePlain(echoes, plain);
  const bool right = Read(ours) == Read(plain);
  if (right)
  {
    std::vector<double> a, b;
    for (int i = 0; i < repetitions; ++i)
    {
      a.push_back(WriteOurs(echoes, ours));
      b.push_back(WritePlain(echoes, plain));
    }
    std::printf("one core, medians of %d: vtkHeliosPointTextWriter %.2f M points/s, fprintf %.2f, "
                "ratio %.2f\n",
      repetitions, 1e-6 * Count / Median(a), 1e-6 * Count / Median(b), Median(b) / Median(a));
  }
  else
  {
    std::printf("the texts differ\n");
  }
  std::filesystem::remove_all(folder);
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
