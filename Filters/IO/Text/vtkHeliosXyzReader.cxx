// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosXyzReader.h"

#include "heliosStatus.h"
#include "heliosXyzParser.h"

#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

vtkStandardNewMacro(vtkHeliosXyzReader);

namespace
{

using FileList = std::vector<std::unique_ptr<helios::LineFile>>;

/// Returns the first byte of piece i of n, computed without overflow of size * i.
std::int64_t GetPieceBegin(std::int64_t size, std::int64_t i, std::int64_t n)
{
  return size / n * i + size % n * i / n;
}

} // namespace

vtkHeliosXyzReader::vtkHeliosXyzReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkHeliosXyzReader::~vtkHeliosXyzReader() = default;

void vtkHeliosXyzReader::SetFileName(const char* name)
{
  if (this->FileNames.size() == 1 && name && this->FileNames[0] == name)
  {
    return;
  }
  this->RemoveAllFileNames();
  this->AddFileName(name);
}

void vtkHeliosXyzReader::AddFileName(const char* name)
{
  if (name && *name)
  {
    this->FileNames.emplace_back(name);
    this->Modified();
  }
}

void vtkHeliosXyzReader::RemoveAllFileNames()
{
  this->FileNames.clear();
  this->Modified();
}

const char* vtkHeliosXyzReader::GetFileName(int index) const
{
  return index >= 0 && index < this->GetNumberOfFileNames()
    ? this->FileNames[static_cast<std::size_t>(index)].c_str()
    : nullptr;
}

bool vtkHeliosXyzReader::CheckProperties()
{
  if (this->FileNames.empty())
  {
    vtkErrorMacro(<< "FileName is not set; give the file of points with SetFileName");
    return false;
  }
  if (!std::all_of(this->Separators.begin(), this->Separators.end(), helios::TextRow::IsSeparator))
  {
    vtkErrorMacro(<< "Separators is \"" << this->Separators
                  << "\"; give characters other than letters, digits and + - . # /, such as \",\"");
    return false;
  }
  if (!std::isfinite(this->MaximumColorValue) || this->MaximumColorValue <= 0.0)
  {
    vtkErrorMacro(<< "MaximumColorValue is " << this->MaximumColorValue
                  << "; set a number greater than 0, such as 255");
    return false;
  }
  return true;
}

/// Replaces the columns of a layout by those that are read: with names of the file, else as set.
void vtkHeliosXyzReader::SetColumns(helios::TextLayout& layout) const
{
  const struct
  {
    bool IsRead;
    const char* Names[3];
    int Indices[3];
  } wanted[] = { { this->ReadNormals, { "nx", "ny", "nz" },
                   { this->NormalXIndex, this->NormalYIndex, this->NormalZIndex } },
    { this->ReadColors, { "red", "green", "blue" },
      { this->RgbRIndex, this->RgbGIndex, this->RgbBIndex } } };
  const std::vector<helios::TextColumn> named = std::move(layout.Columns);
  layout.Columns.clear();
  for (const auto& array : wanted)
  {
    for (int k = 0; array.IsRead && k < 3; ++k)
    {
      helios::TextColumn column{ array.Indices[k], helios::FindNamedColumn(array.Names[k]) };
      for (const helios::TextColumn& known : named)
      {
        const bool isSame = std::string_view(known.Column.Array) == column.Column.Array;
        column.Index = isSame && known.Column.Component == k ? known.Index : column.Index;
      }
      layout.Columns.push_back(column);
    }
  }
}

/// Finds the layout of a file once after a change, since pieces may be read several times.
bool vtkHeliosXyzReader::FindLayout(helios::LineFile& file, helios::TextReport& report)
{
  if (this->LayoutTime < this->GetMTime())
  {
    this->Layouts.clear();
    this->LayoutTime = this->GetMTime();
  }
  const auto [found, isNew] = this->Layouts.try_emplace(file.GetPath());
  const helios::Status status = isNew
    ? helios::FindTextLayout(file, this->Separators, found->second, report)
    : helios::Status();
  if (!status.IsOk())
  {
    this->Layouts.erase(found);
    return report.Fail(status.Message());
  }
  if (isNew)
  {
    this->SetColumns(found->second);
  }
  return true;
}

int vtkHeliosXyzReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

// Reads the range of each file that belongs to the piece; the files are treated as one.
bool vtkHeliosXyzReader::ReadPiece(
  helios::XyzParser& parser, helios::TextReport& report, std::int64_t piece, std::int64_t count)
{
  FileList files;
  std::int64_t size = 0;
  for (const std::string& name : this->FileNames)
  {
    files.push_back(std::make_unique<helios::LineFile>());
    const helios::Status status = files.back()->Open(name);
    if (!status.IsOk())
    {
      return report.Fail(status.Message());
    }
    size += files.back()->GetSize();
  }
  const std::int64_t begin = GetPieceBegin(size, piece, count);
  const std::int64_t end = GetPieceBegin(size, piece + 1, count);
  std::int64_t start = 0; // offset of the file in the total bytes
  for (const auto& file : files)
  {
    if (!this->FindLayout(*file, report))
    {
      return false;
    }
    const vtkIdType known = parser.GetNumberOfPoints();
    const std::int64_t done = std::max<std::int64_t>(start - begin, 0);
    file->OnBlock = [this, done, length = static_cast<double>(end - begin)](std::int64_t bytes)
    {
      this->UpdateProgress(std::min(1.0, static_cast<double>(done + bytes) / length));
      return !this->AbortExecute;
    };
    const helios::TextLayout& layout = this->Layouts.at(file->GetPath());
    parser.SetLayout(layout);
    for (const helios::TextScan& scan : layout.Scans)
    {
      const std::int64_t from = std::max(begin - start, scan.Begin);
      const std::int64_t to = std::min(end - start, scan.End);
      if (from < to && !parser.Read(*file, scan, from, to))
      {
        return file->IsStopped()
          ? report.Fail(file->GetPlace() + "reading was aborted here; update again to read it")
          : false;
      }
    }
    if (file->GetSize() == 0 || (count == 1 && parser.GetNumberOfPoints() == known))
    {
      return report.Fail(file->GetPath() + ": has no points; give a file with rows x y z");
    }
    start += file->GetSize();
  }
  return true;
}

void vtkHeliosXyzReader::WarnOnce(const std::vector<std::string>& warnings)
{
  if (this->WarnedTime < this->GetMTime())
  {
    this->Warned.clear();
    this->WarnedTime = this->GetMTime();
  }
  for (const std::string& warning : warnings)
  {
    if (std::find(this->Warned.begin(), this->Warned.end(), warning) == this->Warned.end())
    {
      this->Warned.push_back(warning);
      vtkWarningMacro(<< warning);
    }
  }
}

int vtkHeliosXyzReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->CheckProperties())
  {
    return 0;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  const bool isPiece = outInfo->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) != 0;
  const int count = isPiece ? std::max(1, outInfo->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())) : 1;
  const int piece = isPiece ? outInfo->Get(Pipeline::UPDATE_PIECE_NUMBER()) : 0;
  if (piece < 0 || piece >= count)
  {
    return 1; // no part of the file
  }
  helios::XyzFormat format;
  format.MaximumColor = this->MaximumColorValue;
  format.ColorCure = "MaximumColorValue, " + helios::FormatPlain(this->MaximumColorValue) +
    "; set MaximumColorValue, or the column of the colour";
  helios::TextReport report;
  bool isRead = false;
  try
  {
    helios::XyzParser parser(format, report);
    isRead = this->ReadPiece(parser, report, piece, count);
    if (isRead)
    {
      parser.MoveTo(vtkPolyData::GetData(outputVector));
    }
  }
  catch (const std::bad_alloc&)
  {
    report.Error = this->FileNames[0] + ": not enough memory for its points; ask for it in pieces";
  }
  this->WarnOnce(report.Warnings);
  if (!isRead)
  {
    vtkErrorMacro(<< report.Error);
  }
  return isRead;
}

void vtkHeliosXyzReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const std::string& name : this->FileNames)
  {
    os << indent << "FileName: " << name << "\n";
  }
  os << indent << "Separators: \"" << this->Separators << "\"\n";
  os << indent << "ReadNormals: " << this->ReadNormals << " (columns " << this->NormalXIndex << ' '
     << this->NormalYIndex << ' ' << this->NormalZIndex << ")\n";
  os << indent << "ReadColors: " << this->ReadColors << " (columns " << this->RgbRIndex << ' '
     << this->RgbGIndex << ' ' << this->RgbBIndex << ")\n";
  os << indent << "MaximumColorValue: " << this->MaximumColorValue << "\n";
}
