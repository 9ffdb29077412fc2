// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunFormat.h"

#include "heliosMessages.h"
#include "heliosRunSettings.h"
#include "vtkHeliosRunFiles.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <vector>

namespace helios
{

namespace
{

using Outputs = vtkHeliosEchoAlgorithm::Outputs;

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
  return Status::Error("Format is \"" + format + "\"; give " + JoinChoices(formats, "or") + ".");
}

/// Checks that files of the format can have what is wanted; waveforms of other formats have files of
/// their own.
Status CheckOutputs(const std::string& format, const Outputs& wants)
{
  for (const auto& row : vtkHeliosEchoAlgorithm::GetOutputRows())
  {
    std::istringstream words(row.Formats);
    const std::vector<std::string> formats(std::istream_iterator<std::string>(words), {});
    if (wants.*row.Flag && row.Flag != &Outputs::WaveformsInPoints &&
      std::find(formats.begin(), formats.end(), format) == formats.end())
    {
      return Status::Error(std::string(row.FileProperty) + " is on, but files of the Format \"" +
        format + "\" cannot have " + row.Title + "; give " + JoinChoices(formats, "or") + ".");
    }
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
Status SetFormat(const std::string& format, RunSettings& settings)
{
  Outputs& wants = settings.Wants;
  for (const Status& status : { CheckName(format), CheckOutputs(format, wants) })
  {
    if (!status.IsOk())
    {
      return status;
    }
  }
  const bool isLas = vtkHeliosRunFiles::IsLas(format);
  settings.Format = format;
  wants.WaveformsInPoints = wants.WaveformsInPoints && isLas && format != "copc" && wants.Waveforms;
  wants.ScanFlags =
    wants.ScanFlags || isLas || (format == "xyz" && wants.Decibels); // one order of columns
  return {};
}

} // namespace helios
