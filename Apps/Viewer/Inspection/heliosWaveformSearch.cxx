// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaveformSearch.h"

#include "heliosErrorText.h"
#include "heliosLasFile.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosLASReader.h"
#include "vtkHeliosRunFiles.h"
#include "vtkHeliosWaveformTextReader.h"
#include "vtkHeliosWaveformXMLReader.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace fs = std::filesystem;

namespace helios::viewer
{
namespace names = vtkHeliosArrayNames;
using RunFiles = vtkHeliosRunFiles;

namespace
{

constexpr double BytesPerPiece = 16e6;  // bytes of text read at a time
constexpr double BytesOfPoints = 400e3; // bytes of a LAS file: each may have a waveform

/// Returns whether it is a LAS file whose points refer to packets, in it or in a .wdp beside it.
bool HasPackets(const fs::path& path)
{
  std::error_code error;
  LasFile file;
  return path.extension() == ".las" && fs::is_regular_file(path, error) &&
    file.Open(path.string()).IsOk() && GetLasPointForm(file.GetHeader().Format).Wave >= 0;
}

bool HasWaveforms(const fs::path& path)
{
  return path.extension() == ".las"
    ? HasPackets(path)
    : RunFiles::GetKind(path.filename().string()) == RunFiles::WAVEFORMS;
}

void AddBeside(const fs::path& points, std::vector<std::string>& files)
{
  if (HasPackets(points))
  {
    files.push_back(points.string());
  }
  for (const char* format : { "xyz", "vtp", "las" })
  {
    const std::string name =
      RunFiles::GetBeside(points.filename().string(), RunFiles::WAVEFORMS, format);
    const fs::path path = points.parent_path() / name;
    std::error_code error;
    if (!name.empty() && fs::exists(path, error))
    {
      files.push_back(path.string());
    }
  }
}

/// Returns the rows of some pulses; null: none.
vtkSmartPointer<vtkTable> Select(vtkTable* table, vtkIdType first, vtkIdType last)
{
  auto* ids = vtkDataArray::SafeDownCast(table->GetColumnByName(names::PulseIds));
  vtkNew<vtkIdList> rows;
  for (vtkIdType i = 0; ids && i < table->GetNumberOfRows(); ++i)
  {
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(i));
    if (id >= first && id < last)
    {
      rows->InsertNextId(i);
    }
  }
  if (rows->GetNumberOfIds() == 0)
  {
    return nullptr;
  }
  auto found = vtkSmartPointer<vtkTable>::New();
  vtkDataSetAttributes* data = found->GetRowData();
  data->CopyAllOn();
  data->CopyAllocate(table->GetRowData(), rows->GetNumberOfIds());
  for (vtkIdType i = 0; i < rows->GetNumberOfIds(); ++i)
  {
    data->CopyData(table->GetRowData(), rows->GetId(i), i);
  }
  found->GetFieldData()->ShallowCopy(table->GetFieldData());
  return found;
}

/// Reads piece by piece until the pulses are found; a piece that has some ends the search.
template <typename Reader>
vtkSmartPointer<vtkTable> Search(Reader* reader, const std::string& file, int pieces,
  const std::pair<vtkIdType, vtkIdType>& pulses, const std::atomic<bool>& isEnding)
{
  const ErrorText errors(reader);
  for (int i = 0; i < pieces && !isEnding; ++i)
  {
    reader->UpdatePiece(i, pieces, 0);
    if (!errors.IsEmpty())
    {
      throw std::runtime_error(errors.Get(file));
    }
    auto found = Select(reader->GetOutput(), pulses.first, pulses.second);
    if (found)
    {
      return found;
    }
  }
  return nullptr;
}

/// Returns the number of pieces of a size in a file.
int CountPieces(const std::string& file, double bytesPerPiece)
{
  std::error_code error;
  const auto bytes = static_cast<double>(fs::file_size(file, error));
  return error ? 1 : 1 + static_cast<int>(std::min(1e6, bytes / bytesPerPiece));
}

/// Returns whether points refer to a waveform of these pulses.
bool NamesWaveform(vtkPolyData* points, const std::pair<vtkIdType, vtkIdType>& pulses)
{
  vtkDataArray* ids = points->GetPointData()->GetArray(names::WaveformIds);
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(i));
    if (id >= pulses.first && id < pulses.second)
    {
      return true;
    }
  }
  return false;
}

/// Packets are read only of the first piece with some of the pulses.
vtkSmartPointer<vtkTable> SearchPackets(const std::string& file,
  const std::pair<vtkIdType, vtkIdType>& pulses, const std::atomic<bool>& isEnding)
{
  vtkNew<vtkHeliosLASReader> reader;
  const ErrorText errors(reader);
  reader->SetFileName(file.c_str());
  const int pieces = CountPieces(file, BytesOfPoints);
  vtkSmartPointer<vtkTable> found;
  for (int i = 0; i < pieces && !isEnding && !found; ++i)
  {
    reader->ReadWaveformsOff();
    reader->UpdatePiece(i, pieces, 0);
    if (errors.IsEmpty() && NamesWaveform(reader->GetOutput(), pulses))
    {
      reader->ReadWaveformsOn();
      reader->UpdatePiece(i, pieces, 0);
      found =
        Select(vtkTable::SafeDownCast(reader->GetOutputDataObject(1)), pulses.first, pulses.second);
    }
    if (!errors.IsEmpty())
    {
      throw std::runtime_error(errors.Get(file));
    }
  }
  return found;
}

vtkSmartPointer<vtkTable> SearchFile(const std::string& file,
  const std::pair<vtkIdType, vtkIdType>& pulses, const std::atomic<bool>& isEnding)
{
  if (fs::path(file).extension() == ".las")
  {
    return SearchPackets(file, pulses, isEnding);
  }
  if (fs::path(file).extension() == ".pvtt")
  {
    vtkNew<vtkHeliosWaveformXMLReader> reader;
    reader->SetFileName(file.c_str());
    reader->UpdateInformation();
    return Search(reader.Get(), file, std::max(1, reader->GetNumberOfPieces()), pulses, isEnding);
  }
  vtkNew<vtkHeliosWaveformTextReader> reader;
  reader->SetFileName(file.c_str());
  return Search(reader.Get(), file, CountPieces(file, BytesPerPiece), pulses, isEnding);
}

/// Moves the files of a leg to the front.
void MoveToFront(std::vector<std::string>& files, int leg)
{
  char name[32];
  std::snprintf(name, sizeof(name), "leg%03d_", leg);
  std::stable_partition(files.begin(), files.end(),
    [&name](const std::string& file) { return file.find(name) != std::string::npos; });
}

} // namespace

//------------------------------------------------------------------------------
std::vector<std::string> FindWaveformFiles(const std::vector<std::string>& inputs)
{
  std::vector<std::string> files;
  for (const std::string& input : inputs)
  {
    std::error_code error;
    if (!fs::is_directory(input, error))
    {
      AddBeside(input, files);
      continue;
    }
    for (const auto& entry :
      fs::recursive_directory_iterator(input, fs::directory_options::skip_permission_denied, error))
    {
      if (HasWaveforms(entry.path()))
      {
        files.push_back(entry.path().string());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

//------------------------------------------------------------------------------
WaveformSearch::~WaveformSearch()
{
  this->Stop();
}

//------------------------------------------------------------------------------
void WaveformSearch::Stop()
{
  this->IsEnding = true;
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
  this->IsEnding = false;
}

//------------------------------------------------------------------------------
std::future<PulseRecord> WaveformSearch::Find(
  const std::vector<std::string>& files, int leg, vtkIdType first, vtkIdType last)
{
  this->Stop();
  std::vector<std::string> order = files;
  MoveToFront(order, leg);
  std::packaged_task<PulseRecord()> task(
    [this, order, first, last]
    {
      for (const std::string& file : order)
      {
        const auto found = SearchFile(file, { first, last }, this->IsEnding);
        if (found)
        {
          return PulseRecord{ nullptr, found, nullptr, nullptr };
        }
      }
      throw std::runtime_error("pulse " + std::to_string(first) +
        " has no waveform in the files next to the points; were they written by the same run?");
    });
  std::future<PulseRecord> answer = task.get_future();
  this->Thread = std::thread(std::move(task));
  return answer;
}

} // namespace helios::viewer
