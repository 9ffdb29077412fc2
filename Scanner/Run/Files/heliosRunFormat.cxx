// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunFormat.h"

#include "heliosMessages.h"
#include "heliosRunSettings.h"
#include "vtkHeliosRunFiles.h"

#include <vector>

namespace helios
{

namespace
{

Status CheckName(const std::string& format)
{
  if (!vtkHeliosRunFiles::GetFileName("", vtkHeliosRunFiles::POINTS, format).empty())
  {
    return {};
  }
  std::vector<std::string> formats;
  for (int i = 0; i < vtkHeliosRunFiles::GetNumberOfFormats(); ++i)
  {
    formats.emplace_back(vtkHeliosRunFiles::GetFormat(i));
  }
  return Status::Error("Format is \"" + format + "\"; give " + Enumerate(formats, "or") + ".");
}

Status CheckArrays(const std::string& format, const WantedOutputs& wants)
{
  if (wants.Colors && format == "xyz")
  {
    return Status::Error("WriteColors is on, but Format \"xyz\" has no colours; give las or vtp.");
  }
  if (wants.Truth && format != "vtp")
  {
    return Status::Error("WriteTruth is on, but files of the format " + format +
      " cannot store true points; set Format to vtp.");
  }
  if (wants.Columns && format != "vtp")
  {
    return Status::Error("WriteColumns is on, but files of the format " + format +
      " cannot store columns of revolutions; set Format to vtp.");
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
Status SetFormat(const std::string& format, RunSettings& settings)
{
  WantedOutputs& wants = settings.Wants;
  for (const Status& status : { CheckName(format), CheckArrays(format, wants) })
  {
    if (!status.IsOk())
    {
      return status;
    }
  }
  const bool isLas = format == "las";
  settings.Format = format;
  settings.WaveformsInPoints = settings.WaveformsInPoints && isLas && wants.Waveforms;
  wants.ScanFlags =
    wants.ScanFlags || isLas || (format == "xyz" && wants.Decibels); // one order of columns
  return {};
}

} // namespace helios
