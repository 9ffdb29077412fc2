// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegFiles.h"

#include "heliosSurveyData.h"
#include "vtkHeliosPointXMLWriter.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRunFiles.h"
#include "vtkHeliosTrajectoryTextWriter.h"
#include "vtkHeliosXMLPieceWriter.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>

namespace helios
{

namespace
{

constexpr int Ports[] = { EchoPort, WaveformPort, PulsePort, HitPort };

} // namespace

//------------------------------------------------------------------------------
LegFiles::LegFiles(const SurveyData& survey, const RunSettings& settings)
  : Survey(survey)
  , Settings(settings)
{
}

//------------------------------------------------------------------------------
/// Returns the path of a file of a leg; channel is empty for all channels.
std::string LegFiles::MakeFileName(const LegPlan& plan, int kind, const std::string& channel) const
{
  using Files = vtkHeliosRunFiles;
  const std::string& strip = this->Survey.Legs[plan.Leg].Strip;
  const std::string stem =
    strip.empty() ? Files::GetLegStem(static_cast<int>(plan.Leg)) : Files::GetStripStem(strip);
  const std::string name = Files::GetFileName(stem, kind, this->Settings.Format, channel);
  return (std::filesystem::path(this->Settings.Folder) / name).string();
}

//------------------------------------------------------------------------------
LegOutputs LegFiles::MakeOutputs(const LegPlan& plan) const
{
  LegOutputs outputs;
  for (const int port : Ports)
  {
    const bool isInPoints = port == WaveformPort && this->Settings.Wants.WaveformsInPoints;
    if (this->Settings.Wants.HasPort(port) && !isInPoints)
    {
      this->AddOutputs(plan, port, outputs);
    }
  }
  return outputs;
}

//------------------------------------------------------------------------------
/// Adds one file of a port, or one per channel.
void LegFiles::AddOutputs(const LegPlan& plan, int port, LegOutputs& outputs) const
{
  const ScannerData& scanner = this->Survey.GetScanner(plan.Leg);
  const std::size_t channels = scanner.GetNumberOfChannels();
  const bool isSplit = this->Settings.Wants.SplitByChannel && channels > 1;
  for (std::size_t k = 0; k < (isSplit ? channels : 1); ++k)
  {
    const std::string channel = isSplit ? scanner.GetChannel(k).Channel : "";
    LegOutput output{ MakeWriter(port, this->Settings), port,
      isSplit ? k : LegOutput::AllChannels };
    output.Writer->SetFileName(this->MakeFileName(plan, port, channel).c_str());
    outputs.push_back(output);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosStreamWriter> LegFiles::MakeTrajectoryWriter(const LegPlan& plan) const
{
  const bool isXml = this->Settings.Format == "vtp";
  vtkSmartPointer<vtkHeliosStreamWriter> writer;
  if (isXml)
  {
    writer = vtkSmartPointer<vtkHeliosPointXMLWriter>::New();
  }
  else
  {
    writer = vtkSmartPointer<vtkHeliosTrajectoryTextWriter>::New();
  }
  writer->SetFileName(this->MakeFileName(plan, vtkHeliosRunFiles::TRAJECTORY).c_str());
  return writer;
}

//------------------------------------------------------------------------------
const LegOutput& FindOutput(const LegOutputs& files, const LegOutput& output)
{
  return *std::find_if(files.begin(), files.end(),
    [&output](const LegOutput& file)
    { return file.Port == output.Port && file.Channel == output.Channel; });
}

//------------------------------------------------------------------------------
bool IsXml(const LegOutput& file)
{
  return vtkHeliosXMLPieceWriter::SafeDownCast(file.Writer) != nullptr;
}

//------------------------------------------------------------------------------
bool HasXml(const RunSettings& settings)
{
  bool hasXml = false;
  for (const int port : Ports)
  {
    const bool isWritten = settings.Wants.HasPort(port);
    hasXml = hasXml || (isWritten && IsXml({ MakeWriter(port, settings), port }));
  }
  return hasXml;
}

//------------------------------------------------------------------------------
RunSettings MakeRunPartSettings(RunSettings settings)
{
  settings.Format = vtkHeliosRunFiles::IsLas(settings.Format) ? "vtp" : settings.Format;
  settings.Wants.WaveformsInPoints = false;
  return settings;
}

} // namespace helios
