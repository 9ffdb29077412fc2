// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes per second written to LAS and read from it by one core: all arrays of the scanner, 10
// blocks of a million, against bare fwrite of as many bytes. The data are read back and compared
// before timing; then memory is checked not to grow with the blocks.
// Usage: BenchLas [repetitions [folder]]

#include "heliosBenchClock.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosLASReader.h"
#include "vtkHeliosLASWriter.h"

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
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::CpuSeconds;
using helios::Median;
using helios::PeakMebibytes;

namespace
{

constexpr vtkIdType EchoCount = 1000000;
constexpr int BlockCount = 10;
constexpr int BlocksForMemory = 20;

template <typename ArrayT, typename ValueT>
void AddColumn(vtkFieldData* data, const char* name, ValueT value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfValues(EchoCount);
  for (vtkIdType i = 0; i < EchoCount; ++i)
  {
    array->SetValue(i, static_cast<typename ArrayT::ValueType>(value(static_cast<double>(i))));
  }
  data->AddArray(array);
}

/// Echoes of an airborne scan in UTM coordinates, with all arrays of the scanner.
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
  AddColumn<vtkDoubleArray>(data, names::GpsTime, [](double i) { return 3e5 + i / 300000; });
  AddColumn<vtkTypeInt64Array>(data, names::PulseIds, [](double i) { return 20000000 + i; });
  AddColumn<vtkUnsignedCharArray>(data, names::ReturnNumber, [](double) { return 1; });
  AddColumn<vtkUnsignedCharArray>(data, names::NumberOfReturns, [](double) { return 2; });
  AddColumn<vtkDoubleArray>(data, names::Range, [](double i) { return 800 + std::sin(i); });
  AddColumn<vtkDoubleArray>(
    data, names::Amplitude, [](double i) { return 1e-7 * (1.1 + std::sin(i)); });
  AddColumn<vtkDoubleArray>(
    data, names::EchoWidth, [](double i) { return 4.1 + 0.1 * std::cos(i); });
  AddColumn<vtkDoubleArray>(
    data, names::ScanAngle, [](double i) { return 30 * std::sin(0.1 * i); });
  AddColumn<vtkIntArray>(data, names::ClassificationIds, [](double) { return 2; });
  AddColumn<vtkIntArray>(data, names::MaterialIds, [](double i) { return std::fmod(i, 3); });
  AddColumn<vtkIntArray>(data, names::PartIds, [](double i) { return std::fmod(i, 7); });
  AddColumn<vtkTypeInt64Array>(data, names::CellIds, [](double i) { return i; });
  AddColumn<vtkDoubleArray>(data, names::IncidenceAngle, [](double i) { return 90 * std::sin(i); });
  AddColumn<vtkTypeInt64Array>(data, names::WaveformIds, [](double) { return -1; });
  AddColumn<vtkIntArray>(data, names::LegIds, [](double) { return 4; });
  AddColumn<vtkIntArray>(data, names::ChannelIds, [](double) { return 0; });
  return echoes;
}

double Write(vtkPolyData* block, const std::string& path, int blocks, bool hasExtras = true)
{
  const double start = CpuSeconds();
  vtkNew<vtkHeliosLASWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetWriteExtraBytes(hasExtras);
  bool good = writer->Open();
  for (int i = 0; i < blocks; ++i)
  {
    good = good && writer->Write(block);
  }
  good = good && writer->Close();
  return good ? CpuSeconds() - start : std::nan("");
}

/// Writes as many bytes, without formatting.
double WriteBare(const std::string& path, std::uintmax_t bytes)
{
  const std::vector<char> block(1 << 20, 'x');
  const double start = CpuSeconds();
  std::FILE* file = std::fopen(path.c_str(), "wb");
  for (std::uintmax_t done = 0; file && done < bytes; done += block.size())
  {
    std::fwrite(block.data(), 1, block.size(), file);
  }
  if (file)
  {
    std::fclose(file);
  }
  return CpuSeconds() - start;
}

double Read(vtkHeliosLASReader* reader)
{
  const double start = CpuSeconds();
  bool good = true;
  for (int piece = 0; piece < BlockCount; ++piece)
  {
    reader->UpdatePiece(piece, BlockCount, 0);
    good = good && reader->GetOutput()->GetNumberOfPoints() == EchoCount;
  }
  return good ? CpuSeconds() - start : std::nan("");
}

/// All values of a block.
bool IsReadBack(vtkPolyData* echoes, vtkHeliosLASReader* reader)
{
  reader->UpdatePiece(BlockCount - 1, BlockCount, 0);
  vtkPolyData* read = reader->GetOutput();
  double worst = read->GetNumberOfPoints() == EchoCount ? 0.0 : 1.0;
  for (vtkIdType i = 0; worst < 1.0 && i < EchoCount; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      worst = std::max(worst, std::abs(read->GetPoint(i)[k] - echoes->GetPoint(i)[k]));
    }
  }
  vtkPointData* data = echoes->GetPointData();
  bool isSame = worst < 0.5001e-4;
  for (int a = 0; isSame && a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* written = data->GetArray(a);
    vtkDataArray* back = read->GetPointData()->GetArray(data->GetArrayName(a));
    const double room = written->GetName() == std::string(names::ScanAngle) ? 0.00301 : 0.0;
    for (vtkIdType i = 0; isSame && i < EchoCount; ++i)
    {
      isSame = back && std::abs(back->GetTuple1(i) - written->GetTuple1(i)) <= room;
    }
  }
  return isSame;
}

void Print(const char* what, const std::vector<double>& seconds)
{
  std::printf("%-28s %7.2f M points/s/core\n", what,
    1e-6 * static_cast<double>(EchoCount * BlockCount) / Median(seconds));
}

} // namespace

int main(int argc, char* argv[])
{
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  const std::filesystem::path base =
    argc > 2 ? std::filesystem::path(argv[2]) : std::filesystem::temp_directory_path();
  const auto folder = base / "vtkHeliosBenchLas";
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "points.las").string();
  const std::string bare = (folder / "bare").string();
  const auto echoes = MakeEchoes();
  vtkSMPTools::Initialize(1);

  Write(echoes, path, BlockCount);
  vtkNew<vtkHeliosLASReader> reader;
  reader->SetFileName(path.c_str());
  const bool isRight = IsReadBack(echoes, reader);
  const auto bytes = std::filesystem::file_size(path);
  std::vector<double> all, fields, bares, reads;
  for (int i = 0; isRight && i < repetitions; ++i)
  {
    fields.push_back(Write(echoes, path, BlockCount, false));
    all.push_back(Write(echoes, path, BlockCount));
    bares.push_back(WriteBare(bare, bytes));
    reads.push_back(Read(reader));
  }
  if (isRight)
  {
    std::printf("processor time, medians of %d; %d blocks of %lld echoes, %.0f bytes each with all "
                "arrays; read back and compared\n",
      repetitions, BlockCount, static_cast<long long>(EchoCount),
      static_cast<double>(bytes) / static_cast<double>(EchoCount * BlockCount));
    Print("write, all arrays", all);
    Print("write, without Extra Bytes", fields);
    Print("bare fwrite of the bytes", bares);
    std::printf("%-28s %7.2f\n", "time over bare fwrite", Median(all) / Median(bares));
    Print("read", reads);
    const double before = PeakMebibytes();
    Write(echoes, path, BlocksForMemory);
    std::printf(
      "peak memory after %d more blocks: + %.1f MiB\n", BlocksForMemory, PeakMebibytes() - before);
  }
  else
  {
    std::fprintf(stderr, "what was read differs from what was written\n");
  }
  std::filesystem::remove_all(folder);
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
