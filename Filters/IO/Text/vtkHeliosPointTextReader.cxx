// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointTextReader.h"

#include "heliosPointParser.h"
#include "heliosStatus.h"
#include "heliosTextLayout.h"
#include "heliosXyzParser.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

vtkStandardNewMacro(vtkHeliosPointTextReader);

namespace names = vtkHeliosArrayNames;

/// The layout of a file, as long as its size and time are the same.
class vtkHeliosPointTextReader::Layout : public helios::TextLayout
{
public:
  std::string Path;
  std::int64_t Size = 0;
  std::filesystem::file_time_type Time;
  double FullColor = 255.0;

  bool IsOf(const helios::LineFile& file) const
  {
    return this->Path == file.GetPath() && this->Size == file.GetSize() &&
      this->Time == GetTime(file);
  }
  void SetFile(const helios::LineFile& file)
  {
    this->Path = file.GetPath();
    this->Size = file.GetSize();
    this->Time = GetTime(file);
  }

private:
  static std::filesystem::file_time_type GetTime(const helios::LineFile& file)
  {
    std::error_code ignored;
    return std::filesystem::last_write_time(file.GetPath(), ignored);
  }
};

vtkHeliosPointTextReader::vtkHeliosPointTextReader()
  : Parts(std::make_unique<helios::PartNumbers>())
{
  this->SetNumberOfInputPorts(0);
}

vtkHeliosPointTextReader::~vtkHeliosPointTextReader()
{
  this->SetFileName(nullptr);
}

const char* vtkHeliosPointTextReader::GetArrayOfColumn(const char* name)
{
  return name ? helios::FindNamedColumn(name).Array : nullptr;
}

int vtkHeliosPointTextReader::GetComponentOfColumn(const char* name)
{
  return name ? helios::FindNamedColumn(name).Component : 0;
}

const char* vtkHeliosPointTextReader::GetCommonName(const char* array)
{
  return array ? helios::GetCommonName(array) : nullptr;
}

int vtkHeliosPointTextReader::GetNumberOfColumns() const
{
  return this->Known ? this->Known->NumberOfColumns : 0;
}

const char* vtkHeliosPointTextReader::GetKind() const
{
  switch (this->Known ? this->Known->Kind : helios::TextKind::Plain)
  {
    case helios::TextKind::Echoes:
      return "echoes";
    case helios::TextKind::Named:
      return "named columns";
    case helios::TextKind::Pts:
      return "PTS";
    case helios::TextKind::Ptx:
      return "PTX";
    default:
      return "x y z";
  }
}

int vtkHeliosPointTextReader::GetNumberOfScans() const
{
  return this->Known ? static_cast<int>(this->Known->Scans.size()) : 0;
}

bool vtkHeliosPointTextReader::GetScanMatrix(int scan, double matrix[16]) const
{
  if (scan < 0 || scan >= this->GetNumberOfScans())
  {
    return false;
  }
  const helios::TextScan& known = this->Known->Scans[static_cast<std::size_t>(scan)];
  std::copy_n(known.Matrix, 16, matrix);
  return known.HasMatrix;
}

void vtkHeliosPointTextReader::SetPartNames(vtkStringArray* partNames)
{
  std::vector<std::string> known;
  for (vtkIdType part = 0; partNames && part < partNames->GetNumberOfValues(); ++part)
  {
    known.push_back(partNames->GetValue(part));
  }
  this->Parts = std::make_unique<helios::PartNumbers>(std::move(known));
  this->Modified();
}

bool vtkHeliosPointTextReader::FindLayout(helios::LineFile& file, helios::TextReport& report)
{
  if (this->Known && this->Known->IsOf(file))
  {
    return true;
  }
  this->Known.reset();
  auto layout = std::make_unique<Layout>();
  layout->SetFile(file);
  const helios::Status status = helios::FindTextLayout(file, "", *layout, report);
  if (!status.IsOk())
  {
    return report.Fail(status.Message());
  }
  const int columns = layout->NumberOfColumns;
  if (columns < helios::FirstArrayColumn)
  {
    const std::string& path = file.GetPath();
    return report.Fail(columns > 0
        ? path + ": has " + std::to_string(columns) + " columns; give x y z, or the " +
          std::to_string(helios::NumberOfBasicColumns) + " columns of echoes"
        : path + ": has no points; give a file with points");
  }
  std::string unknown;
  for (const std::string& name : layout->Unknown)
  {
    unknown += (unknown.empty() ? "" : ", ") + helios::Quote(name);
  }
  if (!unknown.empty())
  {
    report.Warn(file.GetPath() + ": columns with unknown names are not read: " + unknown);
  }
  this->Known = std::move(layout);
  this->FindRanges(file);
  return true;
}

/// Finds what full colour is, and the range of intensities, from all rows: the first ones may be dark.
void vtkHeliosPointTextReader::FindRanges(helios::LineFile& file)
{
  helios::TextRow row(this->Known->Separators);
  row.SetKeepInvalid(true);
  std::vector<int> colors;
  std::vector<int> intensities;
  bool hasFractions = false;
  for (const helios::TextColumn& column : this->Known->Columns)
  {
    const bool isColor = column.Column.Type == VTK_FLOAT;
    if (isColor || std::string_view(column.Column.Array) == names::Intensity)
    {
      row.Need(column.Index);
      (isColor ? colors : intensities).push_back(column.Index);
      hasFractions = hasFractions || column.Column.IsFraction;
    }
  }
  helios::NumberRange shades;
  helios::NumberRange strengths;
  for (const helios::TextScan& scan : this->Known->Scans)
  {
    std::string_view line;
    file.SetRange(scan.Begin, colors.empty() && intensities.empty() ? scan.Begin : scan.End);
    while (file.NextLine(line))
    {
      const bool isRow = row.Read(line) == helios::TextRow::Good;
      for (std::size_t i = 0; isRow && i < colors.size(); ++i)
      {
        shades.Add(row.GetValue(colors[i]));
      }
      for (std::size_t i = 0; isRow && i < intensities.size(); ++i)
      {
        strengths.Add(row.GetValue(intensities[i]));
      }
    }
  }
  const bool isFraction = hasFractions || (shades.High <= 1.0 && !shades.IsWhole);
  this->Known->FullColor = isFraction ? 1.0 : shades.High > 255.0 ? 65535.0 : 255.0;
  this->IntensityRange[0] = strengths.Low;
  this->IntensityRange[1] = strengths.High;
  this->HasWholeIntensities = strengths.IsWhole;
}

bool vtkHeliosPointTextReader::ReadFile(
  helios::LineFile& file, vtkPolyData* cloud, helios::TextReport& report)
{
  this->Scan = 0;
  this->NumberOfDropped = 0;
  this->NumberOfCounted = 0.0;
  if (!this->FindLayout(file, report))
  {
    return false;
  }
  file.OnBlock = [this, size = static_cast<double>(file.GetSize())](std::int64_t bytes)
  {
    this->UpdateProgress(std::min(1.0, static_cast<double>(this->Begin + bytes) / size));
    return !this->AbortExecute;
  };
  this->FileSize = file.GetSize();
  const bool isPlain = this->Known->Kind == helios::TextKind::Plain && !this->Known->HasHeader &&
    this->Known->Separators == helios::BlankSeparators &&
    helios::GetColumnsToRead(this->Known->NumberOfColumns) == helios::FirstArrayColumn;
  const bool isRead = this->Known->Kind == helios::TextKind::Echoes || isPlain
    ? this->ReadEchoes(file, cloud, report)
    : this->ReadColumns(file, cloud, report);
  return !isRead && file.IsStopped()
    ? report.Fail(file.GetPlace() + "reading was aborted here; update again to read it")
    : isRead;
}

bool vtkHeliosPointTextReader::ReadEchoes(
  helios::LineFile& file, vtkPolyData* cloud, helios::TextReport& report)
{
  file.SetRange(this->Begin, file.GetSize());
  helios::PointParser parser(this->Known->NumberOfColumns, this->KeepInvalid, *this->Parts, report);
  if (!parser.Read(file, this->MaximumNumberOfPoints))
  {
    return false;
  }
  this->End = file.GetNextLine();
  parser.MoveTo(cloud);
  this->AddPartNames(cloud);
  return true;
}

/// Reads the next rows of a scan.
bool vtkHeliosPointTextReader::ReadColumns(
  helios::LineFile& file, vtkPolyData* cloud, helios::TextReport& report)
{
  helios::XyzFormat format;
  format.MaximumColor = this->Known->FullColor;
  format.ColorCure = helios::FormatPlain(format.MaximumColor) + "; correct or remove the row";
  format.FirstNumber = 1;
  format.KeepInvalid = this->KeepInvalid;
  const bool isWhole = this->MaximumNumberOfPoints == 0;
  helios::XyzParser parser(format, report);
  parser.SetLayout(*this->Known);
  for (const helios::TextScan& scan : this->Known->Scans)
  {
    if (this->Begin < scan.End)
    {
      if (!parser.Read(file, scan, this->Begin, scan.End, this->MaximumNumberOfPoints))
      {
        return false;
      }
      this->End = file.GetNextLine();
      this->Scan = static_cast<int>(&scan - this->Known->Scans.data());
      if (!isWhole)
      {
        break;
      }
    }
  }
  const bool isAtEnd = this->Known->Scans.empty() || this->End >= this->Known->Scans.back().End;
  this->End = isAtEnd ? file.GetSize() : this->End;
  this->NumberOfDropped = parser.GetNumberOfDropped();
  this->NumberOfCounted = parser.GetNumberOfCounted();
  parser.MoveTo(cloud);
  return true;
}

bool vtkHeliosPointTextReader::Report(bool isRead, helios::TextReport& report)
{
  for (const std::string& warning : report.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!isRead)
  {
    vtkErrorMacro(<< report.Error);
  }
  return isRead;
}

bool vtkHeliosPointTextReader::ReadLayout()
{
  helios::TextReport report;
  if (!this->FileName || !*this->FileName)
  {
    return this->Report(report.Fail("FileName is not set; give the file of points"), report);
  }
  helios::LineFile file;
  const helios::Status status = file.Open(this->FileName);
  return this->Report(
    status.IsOk() ? this->FindLayout(file, report) : report.Fail(status.Message()), report);
}

void vtkHeliosPointTextReader::AddPartNames(vtkPolyData* cloud) const
{
  const std::vector<std::string>& parts = this->Parts->GetNames();
  if (!parts.empty())
  {
    vtkNew<vtkStringArray> array;
    array->SetName(names::PartName);
    for (const std::string& name : parts)
    {
      array->InsertNextValue(name);
    }
    cloud->GetFieldData()->AddArray(array);
  }
}

int vtkHeliosPointTextReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the file of points");
    return 0;
  }
  helios::TextReport report;
  bool isRead = false;
  try
  {
    helios::LineFile file;
    const helios::Status status = file.Open(this->FileName);
    isRead = status.IsOk() ? this->ReadFile(file, vtkPolyData::GetData(outputVector), report)
                           : report.Fail(status.Message());
  }
  catch (const std::bad_alloc&)
  {
    report.Fail(std::string(this->FileName) +
      ": not enough memory for its points; set MaximumNumberOfPoints");
  }
  if (!isRead)
  {
    vtkPolyData::GetData(outputVector)->Initialize();
  }
  return this->Report(isRead, report);
}

void vtkHeliosPointTextReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "Begin: " << this->Begin << "\n"
     << indent << "MaximumNumberOfPoints: " << this->MaximumNumberOfPoints << "\n"
     << indent << "KeepInvalid: " << this->KeepInvalid << "\n"
     << indent << "End: " << this->End << "\n"
     << indent << "FileSize: " << this->FileSize << "\n";
}
