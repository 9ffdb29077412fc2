// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes fully storable in LAS, the bytes of LAS files, and a reader for them.

#ifndef heliosLasTesting_h
#define heliosLasTesting_h

#include "heliosTempFolder.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosLASReader.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkStringArray.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace helios
{

/// Reads a number from the bytes of a file.
template <typename T>
T GetNumber(const std::string& bytes, std::size_t at)
{
  T value = 0;
  if (at + sizeof(T) <= bytes.size())
  {
    std::memcpy(&value, bytes.data() + at, sizeof(T));
  }
  return value;
}

template <typename T>
void SetNumber(std::string& bytes, std::size_t at, T value)
{
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

/// A header of an old version, and zero-filled points.
inline std::string MakeOld(int minor, int format, std::uint32_t count, std::uint16_t length)
{
  const std::uint16_t sizes[] = { 227, 227, 227, 235, 375, 393 };
  const std::uint16_t size = sizes[minor];
  std::string bytes(size + count * length, '\0');
  bytes.replace(0, 4, "LASF");
  bytes[24] = 1;
  bytes[25] = static_cast<char>(minor);
  SetNumber<std::uint16_t>(bytes, 94, size);
  SetNumber<std::uint32_t>(bytes, 96, size);
  bytes[104] = static_cast<char>(format);
  SetNumber<std::uint16_t>(bytes, 105, length);
  SetNumber<std::uint32_t>(bytes, 107, count);
  for (std::size_t k = 0; k < 3; ++k)
  {
    SetNumber(bytes, 131 + 8 * k, 0.01);
    SetNumber(bytes, 155 + 8 * k, 100.0 * static_cast<double>(k));
  }
  if (minor >= 4)
  {
    SetNumber<std::uint64_t>(bytes, 247, count);
  }
  return bytes;
}

/// Inserts a variable length record after the header.
inline void AddRecord(
  std::string& bytes, const std::string& user, std::uint16_t id, const std::string& data)
{
  std::string record(54, '\0');
  record.replace(2, user.size(), user);
  SetNumber(record, 18, id);
  SetNumber(record, 20, static_cast<std::uint16_t>(data.size()));
  record += data;
  const auto begin = GetNumber<std::uint32_t>(bytes, 96);
  SetNumber(bytes, 96, begin + static_cast<std::uint32_t>(record.size()));
  SetNumber(bytes, 100, GetNumber<std::uint32_t>(bytes, 100) + 1);
  bytes.insert(begin, record);
}

inline std::string MakeExtra(const std::string& name, char type, char options = 0)
{
  std::string entry(192, '\0');
  entry[2] = type;
  entry[3] = options;
  entry.replace(4, name.size(), name);
  return entry;
}

inline void AddVectors(vtkPolyData* echoes, vtkDataArray* array, const char* name, double value)
{
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(echoes->GetNumberOfPoints());
  for (vtkIdType i = 0; i < 3 * echoes->GetNumberOfPoints(); ++i)
  {
    array->SetVariantValue(i, value * (1.0 + std::sin(static_cast<double>(i))));
  }
  echoes->GetPointData()->AddArray(array);
}

inline void SetCrs(vtkPolyData* echoes, const std::string& crs)
{
  vtkNew<vtkStringArray> text;
  text->SetName(vtkHeliosArrayNames::CRS);
  text->InsertNextValue(crs);
  echoes->GetFieldData()->AddArray(text);
}

inline void SetEpoch(vtkPolyData* echoes, double epoch)
{
  AddColumn<vtkDoubleArray>(
    echoes->GetFieldData(), vtkHeliosArrayNames::GpsEpoch, 1, [epoch](vtkIdType) { return epoch; });
}

/// Echoes with all arrays of the scanner.
inline vtkSmartPointer<vtkPolyData> MakeLasEchoes(vtkIdType count)
{
  namespace names = vtkHeliosArrayNames;
  auto echoes = MakeEchoes(count);
  vtkPointData* data = echoes->GetPointData();
  AddColumn<vtkUnsignedCharArray>(
    data, names::ReturnNumber, count, [](vtkIdType i) { return 1 + i % 15; });
  AddColumn<vtkUnsignedCharArray>(
    data, names::NumberOfReturns, count, [](vtkIdType) { return 15; });
  AddColumn<vtkIntArray>(
    data, names::ClassificationIds, count, [](vtkIdType i) { return 11 * i % 256; });
  AddColumn<vtkIntArray>(data, names::LegIds, count, [](vtkIdType i) { return i % 5 - 1; });
  AddColumn<vtkIntArray>(data, names::ChannelIds, count, [](vtkIdType i) { return i % 32; });
  AddColumn<vtkDoubleArray>(data, names::ScanAngle, count,
    [](vtkIdType i) { return 0.006 * static_cast<double>(i % 60001 - 30000); });
  AddColumn<vtkTypeInt64Array>(
    data, names::WaveformIds, count, [](vtkIdType i) { return i % 2 == 0 ? -1 : i; });
  AddColumn<vtkFloatArray>(
    data, names::Range, count, [](vtkIdType i) { return 0.1 * static_cast<double>(i); });
  vtkNew<vtkDoubleArray> truth;
  AddVectors(echoes, truth, names::TruePoint, 1e5);
  return echoes;
}

/// Truncates a file to half its size at the first progress event.
class FileCut : public vtkCommand
{
public:
  static FileCut* New() { return new FileCut; }

  void Execute(vtkObject*, unsigned long, void* progress) override
  {
    if (!this->IsDone && *static_cast<double*>(progress) > 0.0)
    {
      this->IsDone = true;
      std::filesystem::resize_file(this->Path, std::filesystem::file_size(this->Path) / 2);
    }
  }

  std::string Path;
  bool IsDone = false;
};

struct LasReading
{
  vtkNew<vtkHeliosLASReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = WatchErrors(this->Reader);
  vtkSmartPointer<ErrorObserver> Quiet = WatchErrors(this->Reader->GetExecutive());

  explicit LasReading(const std::string& path) { this->Reader->SetFileName(path.c_str()); }

  /// True if there was no error.
  bool Read(int piece = 0, int count = 1)
  {
    this->Reader->Modified();
    this->Log->Clear();
    this->Reader->UpdatePiece(piece, count, 0);
    return this->Log->Errors.empty();
  }

  vtkPolyData* Cloud() { return this->Reader->GetOutput(); }
  vtkIdType CountPoints() { return this->Cloud()->GetNumberOfPoints(); }
  vtkDataArray* Get(const char* name) { return this->Cloud()->GetPointData()->GetArray(name); }
};

/// Counts values of an array that differ by more than a tolerance from the values of another, from
/// a tuple of the first on; -1 if the shapes differ.
inline vtkIdType CountWrong(
  vtkDataArray* read, vtkDataArray* written, vtkIdType from = 0, double tolerance = 0.0)
{
  const vtkIdType count = written->GetNumberOfTuples();
  if (!read || read->GetNumberOfComponents() != written->GetNumberOfComponents() ||
    read->GetNumberOfTuples() < from + count)
  {
    return -1;
  }
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int k = 0; k < written->GetNumberOfComponents(); ++k)
    {
      const double difference = read->GetComponent(from + i, k) - written->GetComponent(i, k);
      wrong += std::abs(difference) <= tolerance ? 0 : 1;
    }
  }
  return wrong;
}

} // namespace helios

#endif
