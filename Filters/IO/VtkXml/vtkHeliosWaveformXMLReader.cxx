// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosWaveformXMLReader.h"

#include "heliosInputFile.h"
#include "heliosStatus.h"
#include "heliosVtkXmlReading.h"
#include "heliosWaveformTable.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>
#include <vtkXMLTableReader.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

vtkStandardNewMacro(vtkHeliosWaveformXMLReader);

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;

namespace
{

/// Appends the tuples of all arrays; false if the arrays differ.
bool AppendArrays(vtkFieldData* from, vtkFieldData* to)
{
  bool areSame = from->GetNumberOfArrays() == to->GetNumberOfArrays();
  for (int i = 0; areSame && i < to->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* target = to->GetAbstractArray(i);
    vtkAbstractArray* source = from->GetAbstractArray(target->GetName());
    areSame = source && source->GetDataType() == target->GetDataType() &&
      source->GetNumberOfComponents() == target->GetNumberOfComponents();
    if (areSame)
    {
      target->InsertTuples(target->GetNumberOfTuples(), source->GetNumberOfTuples(), 0, source);
    }
  }
  return areSame;
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosWaveformXMLReader::vtkHeliosWaveformXMLReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosWaveformXMLReader::~vtkHeliosWaveformXMLReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
bool vtkHeliosWaveformXMLReader::FindPieces()
{
  this->Pieces.clear();
  const std::string name = this->FileName ? this->FileName : "";
  if (const helios::Status status = helios::CheckInputFile(name); !status.IsOk())
  {
    vtkErrorMacro(<< name << ": " << status.Message());
    return false;
  }
  std::error_code ignored;
  if (name.empty() || !fs::is_regular_file(name, ignored))
  {
    vtkErrorMacro(<< (name.empty() ? "FileName is not set" : name + ": there is no such file")
                  << "; give a file of waveforms, .pvtt or .vtt");
    return false;
  }
  helios::VtkXmlFile file;
  if (!file.Open(name, "Table") && file.GetKind() == helios::VtkXmlFile::Kind::Other)
  {
    vtkErrorMacro(<< name
                  << ": is not a VTK XML file of tables; give a file of waveforms, .pvtt or "
                  << ".vtt (text: vtkHeliosWaveformTextReader); it " << file.GetProblem());
    return false;
  }
  this->Pieces = file.GetPieces();
  if (file.GetKind() == helios::VtkXmlFile::Kind::Single)
  {
    this->Pieces.push_back(name);
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosWaveformXMLReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return this->FindPieces();
}

//------------------------------------------------------------------------------
bool vtkHeliosWaveformXMLReader::AppendPiece(const std::string& name, vtkTable* waveforms)
{
  std::string fault;
  const auto piece = helios::ReadVtkXml<vtkXMLTableReader, vtkTable>(name, "Table", fault);
  helios::Status status = piece
    ? helios::WaveformTable().Set(piece)
    : helios::Status::Error("cannot be read; is it missing or incomplete? It " + fault);
  status = status.IsOk() ? helios::CheckValues(piece) : status;
  if (!status.IsOk())
  {
    vtkErrorMacro(<< name << ": the piece " << status.Message() << "; run the survey again");
    return false;
  }
  if (waveforms->GetNumberOfRows() == 0)
  {
    waveforms->DeepCopy(piece);
    return true;
  }
  vtkDataArray* samples = waveforms->GetFieldData()->GetArray(names::Samples);
  vtkDataArray* more = piece->GetFieldData()->GetArray(names::Samples);
  const vtkIdType shift = samples->GetNumberOfTuples();
  const vtkIdType firstRow = waveforms->GetNumberOfRows();
  if (piece->GetNumberOfRows() == 0)
  {
    return true;
  }
  samples->InsertTuples(shift, more->GetNumberOfTuples(), 0, more);
  if (!AppendArrays(piece->GetRowData(), waveforms->GetRowData()))
  {
    vtkErrorMacro(<< name << ": the piece has other columns than " << this->Pieces.front()
                  << "; are they of one run?");
    return false;
  }
  vtkDataArray* offsets = waveforms->GetRowData()->GetArray(names::Offset);
  for (vtkIdType row = firstRow; row < waveforms->GetNumberOfRows(); ++row)
  {
    offsets->SetComponent(row, 0, offsets->GetComponent(row, 0) + static_cast<double>(shift));
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosWaveformXMLReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  const bool isPiece = outInfo->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) != 0;
  const auto count =
    isPiece ? std::max<vtkIdType>(1, outInfo->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())) : 1;
  const vtkIdType piece = isPiece ? outInfo->Get(Pipeline::UPDATE_PIECE_NUMBER()) : 0;
  if (piece < 0 || piece >= count)
  {
    return 1;
  }
  const vtkIdType last = this->GetNumberOfPieces() * (piece + 1) / count;
  vtkNew<vtkTable> waveforms;
  for (vtkIdType i = this->GetNumberOfPieces() * piece / count; i < last; ++i)
  {
    if (!this->AppendPiece(this->Pieces[static_cast<std::size_t>(i)], waveforms))
    {
      return 0;
    }
    this->UpdateProgress(static_cast<double>(i + 1) / static_cast<double>(last));
  }
  vtkTable::GetData(outputVector)->ShallowCopy(waveforms);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosWaveformXMLReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "NumberOfPieces: " << this->GetNumberOfPieces() << "\n";
}
