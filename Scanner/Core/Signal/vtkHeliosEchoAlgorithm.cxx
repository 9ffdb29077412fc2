// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEchoAlgorithm.h"

#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>

#include <algorithm>
#include <utility>

namespace
{

using Outputs = vtkHeliosEchoAlgorithm::Outputs;
using Row = vtkHeliosEchoAlgorithm::OutputRow;

constexpr std::pair<const char*, const char * Row::*> Fields[] = { { "name", &Row::Name },
  { "source", &Row::Property }, { "player", &Row::FileProperty }, { "key", &Row::Key },
  { "arrays", &Row::Arrays }, { "formats", &Row::Formats }, { "title", &Row::Title },
  { "state", &Row::State }, { "help", &Row::Help } };

} // namespace

//------------------------------------------------------------------------------
/// Returns the rows in the order of the command line's help.
const std::vector<Row>& vtkHeliosEchoAlgorithm::GetOutputRows()
{
  // clang-format off
  static const std::vector<Row> rows = {
  { &Outputs::Waveforms, "waveforms", "GenerateWaveforms", "WriteWaveforms", "waveforms", true,
    "", "xyz las laz copc vtp", "waveforms", "written",
    "also write the waveforms (as text, as VTK XML, or as LAS with point format 9 or 10)" },
  { &Outputs::WaveformsInPoints, "waveforms_in_points", "", "WaveformsInPoints", "waveformsInPoints", true,
    "", "las laz", "waveforms in the files of points", "yes",
    "with --format las or laz and --waveforms: only legNNN_points.las, with point format 9 or 10, which PDAL and QGIS "
    "refuse (default: point format 6 or 7, and legNNN_fullwave.las)" },
  { &Outputs::ScanFlags, "scan_flags", "GenerateScanFlags", "WriteScanFlags", "scanFlags", true,
    "ScanDirectionFlag EdgeOfFlightLine", "xyz las laz copc vtp", "scan direction and edge flags", "written",
    "echoes in text and VTK XML with the scan direction flag and the edge of flight line; in text as columns "
    "12 and 13 (default: only in LAS, which always has them)" },
  { &Outputs::Decibels, "decibels", "GenerateDecibels", "WriteDecibels", "decibels", false,
    "RelativeAmplitude Reflectance", "xyz las laz copc vtp", "amplitude and reflectance in dB", "written",
    "echoes with the amplitude above the detection threshold and the reflectance [dB]: in text as columns 14 "
    "and 15 after those of --scan-flags, in LAS as RIEGL names them" },
  { &Outputs::Colors, "colors", "GenerateColors", "WriteColors", "colors", false,
    "RGB", "las laz copc vtp", "colours of surfaces", "written, as RGB",
    "echoes with the colour of the surface, Kd and map_Kd of OBJ files, as RGB; with --format las, laz, copc or vtp" },
  { &Outputs::Pulses, "pulses", "GeneratePulses", "WritePulses", "pulses", true,
    "", "xyz las laz copc vtp", "pulses", "written",
    "also write the pulses, including those without a hit" },
  { &Outputs::SubRays, "hits", "GenerateSubRays", "WriteHits", "hits", false,
    "", "xyz las laz copc vtp", "hits of sub-rays", "written",
    "also write every hit of the sub-rays of a beam, with its share of the pulse (Weight): what leaf-area "
    "estimates need of partial hits; always VTK XML, a file per block, large" },
  { &Outputs::Truth, "truth", "GenerateTruth", "WriteTruth", "truth", false,
    "TruePoint Normal", "vtp", "points and normals without noise", "written",
    "with --format vtp: also write the true point and normal of every echo, without noise and navigation "
    "errors (TruePoint, Normal)" },
  { &Outputs::Velocities, "velocities", "GenerateVelocities", "WriteVelocities", "velocities", false,
    "RadialVelocity", "vtp", "radial velocities", "written",
    "with --format vtp: also write the radial velocity of every echo, as FMCW instruments measure it: positive "
    "if scanner and target move apart (RadialVelocity) [m/s]" },
  { &Outputs::Motion, "motion", "GenerateMotion", "WriteMotion", "motion", false,
    "PartPosition PartOrientation PartVelocity", "vtp", "motion of parts", "written",
    "with --format vtp: also write shift and rotation of the part of every echo since the start, and the "
    "velocity of the point hit (PartPosition, PartOrientation, PartVelocity)" },
  { &Outputs::Columns, "columns", "GenerateColumns", "WriteColumns", "columns", false,
    "ColumnIds", "vtp", "columns of spinning optics", "written",
    "with --format vtp: also write the column of every echo and pulse in the revolution of a spinning head "
    "(ColumnIds); its beams are ChannelIds" },
  { &Outputs::SplitByChannel, "split_by_channel", "", "SplitByChannel", "splitByChannel", true,
    "", "xyz las laz copc vtp", "files", "one per channel",
    "one file per scanner channel: legNNN_points_dev<channel>.xyz" },
  };
  // clang-format on
  return rows;
}

//------------------------------------------------------------------------------
int vtkHeliosEchoAlgorithm::GetNumberOfOutputs()
{
  return static_cast<int>(GetOutputRows().size());
}

//------------------------------------------------------------------------------
const char* vtkHeliosEchoAlgorithm::GetOutputText(int output, const std::string& field)
{
  const auto* found = std::find_if(std::begin(Fields), std::end(Fields),
    [&field](const auto& each) { return each.first == field; });
  const bool isValid = output >= 0 && output < GetNumberOfOutputs() && found != std::end(Fields);
  return isValid ? GetOutputRows()[static_cast<std::size_t>(output)].*(found->second) : nullptr;
}

//------------------------------------------------------------------------------
vtkHeliosEchoAlgorithm::vtkHeliosEchoAlgorithm()
{
  this->SetNumberOfOutputPorts(Outputs::NumberOfPorts);
}

//------------------------------------------------------------------------------
vtkHeliosEchoAlgorithm::~vtkHeliosEchoAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkHeliosEchoAlgorithm::SetWantedOutputs(const Outputs& wanted)
{
  const auto& rows = GetOutputRows();
  if (!std::all_of(rows.begin(), rows.end(),
        [this, &wanted](const Row& row) { return this->Wanted.*row.Flag == wanted.*row.Flag; }))
  {
    this->Wanted = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHeliosEchoAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosEchoAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputs->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosEchoAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Row& row : GetOutputRows())
  {
    if (*row.Property)
    {
      os << indent << row.Property << ": " << this->Wanted.*row.Flag << "\n";
    }
  }
}
