// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosWaveformTextReader.h"

#include "heliosStatus.h"
#include "heliosWaveformParser.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>
#include <new>

vtkStandardNewMacro(vtkHeliosWaveformTextReader);

//------------------------------------------------------------------------------
vtkHeliosWaveformTextReader::vtkHeliosWaveformTextReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosWaveformTextReader::~vtkHeliosWaveformTextReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkHeliosWaveformTextReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosWaveformTextReader::ReadPiece(helios::WaveformParser& parser,
  helios::TextReport& report, std::int64_t piece, std::int64_t count)
{
  helios::LineFile file;
  const helios::Status status = file.Open(this->FileName);
  if (!status.IsOk())
  {
    return report.Fail(status.Message());
  }
  const std::int64_t size = file.GetSize();
  const auto getBegin = [size, count](std::int64_t i)
  { return size / count * i + size % count * i / count; };
  const std::int64_t begin = getBegin(piece);
  const std::int64_t end = getBegin(piece + 1);
  file.OnBlock = [this, length = static_cast<double>(end - begin)](std::int64_t bytes)
  {
    this->UpdateProgress(std::min(1.0, static_cast<double>(bytes) / std::max(1.0, length)));
    return !this->AbortExecute;
  };
  if (begin < end && !parser.Read(file, begin, end))
  {
    return file.IsStopped()
      ? report.Fail(file.GetPlace() + "reading was aborted here; update again to read it")
      : false;
  }
  return count > 1 || parser.GetNumberOfWaveforms() > 0 ||
    report.Fail(file.GetPath() + ": has no waveforms; give a file of a run with waveforms");
}

//------------------------------------------------------------------------------
int vtkHeliosWaveformTextReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the file of waveforms with SetFileName");
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
  const helios::WaveformFormat format{ this->OneWayTimes ? 2.0 : 1.0, this->BinSize };
  helios::TextReport report;
  try
  {
    helios::WaveformParser parser(format, report);
    if (this->ReadPiece(parser, report, piece, count))
    {
      parser.MoveTo(vtkTable::GetData(outputVector));
      return 1;
    }
  }
  catch (const std::bad_alloc&)
  {
    report.Error =
      std::string(this->FileName) + ": not enough memory for its waveforms; ask for it in pieces";
  }
  vtkErrorMacro(<< report.Error);
  return 0;
}

//------------------------------------------------------------------------------
void vtkHeliosWaveformTextReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "OneWayTimes: " << this->OneWayTimes << "\n"
     << indent << "BinSize: " << this->BinSize << "\n";
}
