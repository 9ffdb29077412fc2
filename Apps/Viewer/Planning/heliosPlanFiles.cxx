// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanFiles.h"

#include "heliosErrorText.h"
#include "vtkHeliosPointXMLReader.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace helios::viewer
{

namespace
{

constexpr const char* PositionsName = "positions.vtp";
constexpr const char* LinesName = "lines.vtp";

fs::path GetFolder(const std::string& path)
{
  std::error_code error;
  return fs::is_directory(path, error) ? fs::path(path) : fs::path(path).parent_path();
}

/// Reads a file; null and an error if it is not valid, null alone if it is missing.
vtkSmartPointer<vtkPolyData> Read(const fs::path& path, Status& status)
{
  std::error_code error;
  if (!fs::exists(path, error))
  {
    return nullptr;
  }
  vtkNew<vtkHeliosPointXMLReader> reader;
  const ErrorText errors(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!errors.IsEmpty() || !reader->GetOutput())
  {
    status = Status::Error(path.string() + ": cannot be read; plan again");
    return nullptr;
  }
  return reader->GetOutput();
}

bool HasPoints(vtkPolyData* data)
{
  return data && data->GetNumberOfPoints() > 0;
}

} // namespace

//------------------------------------------------------------------------------
bool IsPlan(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    const fs::path folder(path);
    return fs::exists(folder / PositionsName, error) || fs::exists(folder / LinesName, error);
  }
  const fs::path name = fs::path(path).filename();
  return name == PositionsName || name == LinesName;
}

//------------------------------------------------------------------------------
Status ReadPlan(const std::string& path, Plan& plan)
{
  const fs::path folder = GetFolder(path);
  Status status;
  plan.Positions = Read(folder / PositionsName, status);
  plan.Candidates = Read(folder / "candidates.vtp", status);
  plan.TestPoints = Read(folder / "test_points.vtp", status);
  plan.Lines = Read(folder / LinesName, status);
  plan.Cells = Read(folder / "cells.vtp", status);
  std::error_code error;
  const fs::path survey = folder / "survey.xml";
  plan.Survey = fs::exists(survey, error) ? survey.string() : "";
  if (status.IsOk() && !HasPoints(plan.Positions) && !HasPoints(plan.Lines))
  {
    status = Status::Error(
      path + ": has no positions and no flight lines; plan again, or give another folder");
  }
  return status;
}

//------------------------------------------------------------------------------
double GetPlanned(vtkPolyData* points, const char* name, vtkIdType row, double missing)
{
  vtkDataArray* array = points->GetPointData()->GetArray(name);
  return array ? array->GetTuple1(row) : missing;
}

} // namespace helios::viewer
