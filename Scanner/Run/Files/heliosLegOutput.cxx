// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegOutput.h"

#include "heliosRunProgress.h"
#include "heliosRunSettings.h"
#include "vtkHeliosCOPCWriter.h"
#include "vtkHeliosLASWriter.h"
#include "vtkHeliosPointTextWriter.h"
#include "vtkHeliosPointXMLWriter.h"
#include "vtkHeliosPulseTextWriter.h"
#include "vtkHeliosWaveformTextWriter.h"
#include "vtkHeliosWaveformXMLWriter.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace helios
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosStreamWriter> MakeWriter(int port, const RunSettings& settings)
{
  const bool isXml = settings.Format == "vtp";
  const bool isLas = vtkHeliosRunFiles::IsLas(settings.Format);
  vtkSmartPointer<vtkHeliosStreamWriter> writer;
  if (settings.Format == "copc" && port == EchoPort)
  {
    const auto copc = vtkSmartPointer<vtkHeliosCOPCWriter>::New();
    copc->LeavesPartOn();
    writer = copc;
  }
  else if (isLas && (port == EchoPort || port == WaveformPort))
  {
    const auto las = vtkSmartPointer<vtkHeliosLASWriter>::New();
    las->SetWriteWaveforms(port == WaveformPort || settings.Wants.WaveformsInPoints);
    las->SetWriteCompressed(vtkHeliosRunFiles::IsCompressed(settings.Format));
    writer = las;
  }
  else if (port == WaveformPort && isXml)
  {
    writer = vtkSmartPointer<vtkHeliosWaveformXMLWriter>::New();
  }
  else if (port == WaveformPort)
  {
    writer = vtkSmartPointer<vtkHeliosWaveformTextWriter>::New();
  }
  else if (isXml || port == HitPort) // large, and for programs: there is no text
  {
    writer = vtkSmartPointer<vtkHeliosPointXMLWriter>::New();
  }
  else if (port == PulsePort)
  {
    writer = vtkSmartPointer<vtkHeliosPulseTextWriter>::New();
  }
  else
  {
    const auto text = vtkSmartPointer<vtkHeliosPointTextWriter>::New();
    text->SetWriteScanFlags(settings.Wants.ScanFlags);
    text->SetWriteDecibels(settings.Wants.Decibels);
    writer = text;
  }
  return writer;
}

//------------------------------------------------------------------------------
bool LegOutput::HasWaveforms() const
{
  auto* las = vtkHeliosLASWriter::SafeDownCast(this->Writer);
  return las && las->GetWriteWaveforms();
}

//------------------------------------------------------------------------------
bool LegOutput::Write(const OutputPiece& piece) const
{
  if (!piece.Data)
  {
    const OutputRows& rows = piece.Rows;
    return rows.Count == 0 ||
      (rows.Path.empty() ? this->Writer->CopyRows(rows.Text, rows.Count)
                         : this->Writer->CopyRows(rows.Path, rows.Block, rows.Count));
  }
  auto* las = vtkHeliosLASWriter::SafeDownCast(this->Writer);
  if (las)
  {
    las->SetWaveforms(piece.Waveforms);
  }
  const bool isWritten = this->Writer->Write(piece.Data);
  if (las)
  {
    las->SetWaveforms(nullptr); // releases their memory
  }
  return isWritten;
}

//------------------------------------------------------------------------------
OutputPiece CollectPiece(const LegOutput& output, const PortGetter& get)
{
  OutputPiece piece;
  piece.Data = get(output.HasWaveforms() ? EchoPort : output.Port, output.Channel);
  if (output.HasWaveforms())
  {
    const vtkSmartPointer<vtkDataObject> waveforms = get(WaveformPort, output.Channel);
    piece.Waveforms = vtkTable::SafeDownCast(waveforms);
  }
  return piece;
}

//------------------------------------------------------------------------------
bool WriteOutputs(const LegOutputs& outputs, const LegPiece& piece)
{
  return std::equal(outputs.begin(), outputs.end(), piece.begin(),
    [](const LegOutput& output, const OutputPiece& part) { return output.Write(part); });
}

//------------------------------------------------------------------------------
bool EndBlock(const LegOutputs& outputs)
{
  return std::all_of(outputs.begin(), outputs.end(),
    [](const LegOutput& output) { return output.Writer->EndBlock(); });
}

//------------------------------------------------------------------------------
bool Close(const LegOutput& output, const std::function<bool()>& goesOn)
{
  if (auto* copc = vtkHeliosCOPCWriter::SafeDownCast(output.Writer))
  {
    copc->SetOnProgress([&goesOn](double) { return goesOn(); });
    const bool isClosed = copc->Close();
    copc->SetOnProgress({});
    return isClosed;
  }
  return output.Writer->Close();
}

//------------------------------------------------------------------------------
void RemoveParts(const LegOutputs& outputs)
{
  for (const LegOutput& output : outputs)
  {
    if (auto* copc = vtkHeliosCOPCWriter::SafeDownCast(output.Writer))
    {
      copc->RemovePart();
    }
  }
}

//------------------------------------------------------------------------------
std::string GetName(vtkHeliosStreamWriter* writer)
{
  return std::filesystem::path(writer->GetFileName()).filename().string();
}

//------------------------------------------------------------------------------
FileProgress CollectProgress(vtkHeliosStreamWriter* writer, bool isWhole)
{
  FileProgress progress{ GetName(writer), writer->GetFileSize(), writer->GetNumberOfRecords(),
    writer->GetNumberOfBytes(), isWhole, writer->GetHeadChecksum(), {} };
  const std::vector<FileBlock> blocks = writer->CollectBlocks();
  std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(progress.Blocks),
    [](const FileBlock& block) { return block.Begin < block.End; });
  return progress;
}

//------------------------------------------------------------------------------
std::vector<FileProgress> CollectProgress(const LegOutputs& outputs, bool isWhole)
{
  std::vector<FileProgress> files;
  for (const LegOutput& output : outputs)
  {
    files.push_back(CollectProgress(output.Writer, isWhole));
  }
  return files;
}

} // namespace helios
