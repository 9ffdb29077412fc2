// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointTextReader.h"

#include "heliosPointParser.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <new>

vtkStandardNewMacro(vtkHeliosPointTextReader);

namespace names = vtkHeliosArrayNames;

vtkHeliosPointTextReader::vtkHeliosPointTextReader()
  : Parts(std::make_unique<helios::PartNumbers>())
{
  this->SetNumberOfInputPorts(0);
}

vtkHeliosPointTextReader::~vtkHeliosPointTextReader()
{
  this->SetFileName(nullptr);
}

int vtkHeliosPointTextReader::CountColumns(const char* fileName)
{
  helios::LineFile file;
  std::string_view row;
  const bool hasRow = fileName && file.Open(fileName).IsOk() && helios::FindFirstRow(file, row);
  return hasRow ? helios::CountColumns(row) : 0;
}

bool vtkHeliosPointTextReader::CanReadFile(const char* fileName)
{
  helios::LineFile file;
  std::string_view row;
  helios::PartNumbers parts;
  helios::TextReport report;
  return fileName && file.Open(fileName).IsOk() && helios::FindFirstRow(file, row) &&
    helios::PointParser(helios::CountColumns(row), false, parts, report).IsRow(row);
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

bool vtkHeliosPointTextReader::ReadFile(
  helios::LineFile& file, vtkPolyData* cloud, helios::TextReport& report)
{
  std::string_view row;
  const bool hasRow = helios::FindFirstRow(file, row);
  const int columns = hasRow ? helios::CountColumns(row) : 0;
  const std::string& path = file.GetPath();
  if (columns < helios::FirstArrayColumn)
  {
    return report.Fail(!file.GetError().empty() ? file.GetError()
        : hasRow ? path + ": has " + std::to_string(columns) + " columns; give x y z, or the " +
          std::to_string(helios::NumberOfBasicColumns) + " columns of echoes"
                 : path + ": has no points; give a file with points");
  }
  file.SetRange(this->Begin, file.GetSize());
  file.OnBlock = [this, size = static_cast<double>(file.GetSize())](std::int64_t bytes)
  {
    this->UpdateProgress(std::min(1.0, static_cast<double>(this->Begin + bytes) / size));
    return !this->AbortExecute;
  };
  helios::PointParser parser(columns, this->KeepInvalid, *this->Parts, report);
  if (!parser.Read(file, this->MaximumNumberOfPoints))
  {
    return file.IsStopped()
      ? report.Fail(file.GetPlace() + "reading was aborted here; update again to read it")
      : false;
  }
  this->End = file.GetNextLine();
  this->FileSize = file.GetSize();
  parser.MoveTo(cloud);
  this->AddPartNames(cloud);
  return true;
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
    vtkErrorMacro(<< report.Error);
  }
  return isRead;
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
