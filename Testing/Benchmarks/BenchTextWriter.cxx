// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Records per second written by one core: echoes as text against bare fprintf of the same columns,
// echoes as VTP, waveforms as text. Texts are compared before timing; then many more blocks are
// written, to check that memory does not grow.
// Usage: BenchTextWriter [repetitions [folder]]

#include "heliosBenchClock.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPointTextWriter.h"
#include "vtkHeliosPointXMLWriter.h"
#include "vtkHeliosWaveformTextWriter.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::CpuSeconds;
using helios::Median;
using helios::PeakMebibytes;

namespace
{

constexpr vtkIdType EchoCount = 1000000;
constexpr vtkIdType WaveformCount = 20000;
constexpr vtkIdType SamplesPerWaveform = 100;
constexpr int BlocksForMemory = 20;

template <typename ArrayT, typename ValueT>
void AddColumn(vtkFieldData* data, const char* name, vtkIdType count, ValueT value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetValue(i, static_cast<typename ArrayT::ValueType>(value(static_cast<double>(i))));
  }
  data->AddArray(array);
}

/// Echoes of an airborne scan in UTM coordinates.
vtkSmartPointer<vtkPolyData> MakeEchoes()
{
  auto echoes = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < EchoCount; ++i)
  {
    const double x = static_cast<double>(i);
    points->InsertNextPoint(
      478233.51 + 123.4567 * std::sin(x), 5471966.6981 + 1e-4 * x, 112.5 + 30 * std::cos(0.37 * x));
  }
  echoes->SetPoints(points);
  vtkFieldData* data = echoes->GetPointData();
  const vtkIdType n = EchoCount;
  AddColumn<vtkDoubleArray>(data, names::GpsTime, n, [](double i) { return 3e5 + i / 300000; });
  AddColumn<vtkTypeInt64Array>(data, names::PulseIds, n, [](double i) { return 20000000 + i; });
  AddColumn<vtkUnsignedCharArray>(data, names::ReturnNumber, n, [](double) { return 1; });
  AddColumn<vtkUnsignedCharArray>(data, names::NumberOfReturns, n, [](double) { return 2; });
  AddColumn<vtkDoubleArray>(
    data, names::Amplitude, n, [](double i) { return 1e-7 * (1.1 + std::sin(i)); });
  AddColumn<vtkDoubleArray>(
    data, names::EchoWidth, n, [](double i) { return 4.1 + 0.1 * std::cos(i); });
  AddColumn<vtkIntArray>(data, names::PartIds, n, [](double i) { return std::fmod(i, 7); });
  AddColumn<vtkIntArray>(data, names::ClassificationIds, n, [](double) { return 2; });
  return echoes;
}

vtkSmartPointer<vtkTable> MakeWaveforms()
{
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkFieldData* data = table->GetRowData();
  const vtkIdType n = WaveformCount;
  for (const char* name : { names::Origin, names::Direction })
  {
    vtkNew<vtkDoubleArray> vectors;
    vectors->SetName(name);
    vectors->SetNumberOfComponents(3);
    vectors->SetNumberOfTuples(n);
    vectors->Fill(std::sqrt(1.0 / 3));
    data->AddArray(vectors);
  }
  AddColumn<vtkTypeInt64Array>(data, names::PulseIds, n, [](double i) { return i; });
  AddColumn<vtkDoubleArray>(data, names::GpsTime, n, [](double i) { return i / 300000; });
  AddColumn<vtkDoubleArray>(data, names::StartTime, n, [](double i) { return 6666 + 0.25 * i; });
  AddColumn<vtkDoubleArray>(data, names::BinSize, n, [](double) { return 0.25; });
  AddColumn<vtkTypeInt64Array>(
    data, names::Offset, n, [](double i) { return i * SamplesPerWaveform; });
  AddColumn<vtkTypeInt64Array>(data, names::Count, n, [](double) { return SamplesPerWaveform; });
  AddColumn<vtkFloatArray>(table->GetFieldData(), names::Samples, n * SamplesPerWaveform,
    [](double i) { return 1e-7 * (1 + std::sin(i)); });
  return table;
}

template <typename WriterT>
double Write(vtkDataObject* block, const std::string& path, int blocks = 1)
{
  const double start = CpuSeconds();
  vtkNew<WriterT> writer;
  writer->SetFileName(path.c_str());
  bool good = writer->Open();
  for (int i = 0; i < blocks; ++i)
  {
    good = good && writer->Write(block);
  }
  good = good && writer->Close();
  return good ? CpuSeconds() - start : std::nan("");
}

/// Writes the text through fprintf from bare arrays.
double WriteByFprintf(vtkPolyData* echoes, const std::string& path)
{
  const auto numbers = [echoes](const char* name)
  { return vtkDoubleArray::SafeDownCast(echoes->GetPointData()->GetArray(name))->GetPointer(0); };
  const auto bytes = [echoes](const char* name)
  {
    return vtkUnsignedCharArray::SafeDownCast(echoes->GetPointData()->GetArray(name))
      ->GetPointer(0);
  };
  const auto integers = [echoes](const char* name)
  { return vtkIntArray::SafeDownCast(echoes->GetPointData()->GetArray(name))->GetPointer(0); };
  const double* p = vtkDoubleArray::SafeDownCast(echoes->GetPoints()->GetData())->GetPointer(0);
  const double *amplitude = numbers(names::Amplitude), *width = numbers(names::EchoWidth);
  const double* time = numbers(names::GpsTime);
  const unsigned char *number = bytes(names::ReturnNumber), *total = bytes(names::NumberOfReturns);
  const int *part = integers(names::PartIds), *label = integers(names::ClassificationIds);
  const auto* pulse =
    vtkTypeInt64Array::SafeDownCast(echoes->GetPointData()->GetArray(names::PulseIds))
      ->GetPointer(0);

  const double start = CpuSeconds();
  std::FILE* file = std::fopen(path.c_str(), "w");
  for (vtkIdType i = 0; i < EchoCount; ++i)
  {
    std::fprintf(file, "%.4f %.4f %.4f %.4f %.4f %d %d %lld %d %d %.9f\n", p[3 * i], p[3 * i + 1],
      p[3 * i + 2], 1e9 * amplitude[i], width[i], number[i], total[i],
      static_cast<long long>(pulse[i]), part[i], label[i], time[i]);
  }
  std::fclose(file);
  return CpuSeconds() - start;
}

std::string Read(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

bool IsReadBack(vtkPolyData* echoes, const std::string& path)
{
  vtkNew<vtkXMLPPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* read = reader->GetOutput();
  const vtkIdType last = EchoCount - 1;
  return read->GetNumberOfPoints() == EchoCount &&
    std::equal(read->GetPoint(last), read->GetPoint(last) + 3, echoes->GetPoint(last));
}

void Print(const char* what, double count, const std::vector<double>& seconds, const char* unit)
{
  std::printf("%-28s %7.2f M %s/s/core\n", what, 1e-6 * count / Median(seconds), unit);
}

} // namespace

int main(int argc, char* argv[])
{
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  const std::filesystem::path base =
    argc > 2 ? std::filesystem::path(argv[2]) : std::filesystem::temp_directory_path();
  const auto folder = base / "vtkHeliosBenchTextWriter";
  std::filesystem::create_directories(folder);
  const std::string text = (folder / "ours.xyz").string();
  const std::string plain = (folder / "plain.xyz").string();
  const std::string pieces = (folder / "ours.pvtp").string();
  const std::string waves = (folder / "ours.txt").string();
  const auto echoes = MakeEchoes();
  const auto waveforms = MakeWaveforms();
  vtkSMPTools::Initialize(1);

  Write<vtkHeliosPointTextWriter>(echoes, text);
  Write<vtkHeliosPointXMLWriter>(echoes, pieces);
  WriteByFprintf(echoes, plain);
  const bool isRight = Read(text) == Read(plain) && IsReadBack(echoes, pieces);
  std::vector<double> texts, plains, vtps, waveTexts;
  for (int i = 0; isRight && i < repetitions; ++i)
  {
    texts.push_back(Write<vtkHeliosPointTextWriter>(echoes, text));
    plains.push_back(WriteByFprintf(echoes, plain));
    vtps.push_back(Write<vtkHeliosPointXMLWriter>(echoes, pieces));
    waveTexts.push_back(Write<vtkHeliosWaveformTextWriter>(waveforms, waves));
  }
  if (isRight)
  {
    std::printf(
      "processor time, medians of %d; text equals that of fprintf, VTP reads back\n", repetitions);
    Print("vtkHeliosPointTextWriter", EchoCount, texts, "points");
    Print("fprintf", EchoCount, plains, "points");
    std::printf("%-28s %7.2f\n", "ratio", Median(plains) / Median(texts));
    Print("vtkHeliosPointXMLWriter", EchoCount, vtps, "points");
    Print("vtkHeliosWaveformTextWriter", WaveformCount * SamplesPerWaveform, waveTexts, "samples");
    const double before = PeakMebibytes();
    Write<vtkHeliosPointTextWriter>(echoes, text, BlocksForMemory);
    Write<vtkHeliosPointXMLWriter>(echoes, pieces, BlocksForMemory);
    std::printf("peak memory after %d more blocks: + %.1f MiB\n", 2 * BlocksForMemory,
      PeakMebibytes() - before);
  }
  else
  {
    std::fprintf(stderr, "what was written differs from what should be\n");
  }
  std::filesystem::remove_all(folder);
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
