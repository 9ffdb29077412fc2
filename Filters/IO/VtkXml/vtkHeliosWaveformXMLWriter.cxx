// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosWaveformXMLWriter.h"

#include "heliosStatus.h"
#include "heliosWaveformTable.h"

#include <vtkDataSetAttributes.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>
#include <vtkXMLTableWriter.h>

vtkStandardNewMacro(vtkHeliosWaveformXMLWriter);

//------------------------------------------------------------------------------
void vtkHeliosWaveformXMLWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkHeliosWaveformXMLWriter::GetBlockSource() const
{
  return "the waveforms of vtkHeliosScanner (output port 1, with GenerateWaveforms on)";
}

//------------------------------------------------------------------------------
const char* vtkHeliosWaveformXMLWriter::GetPieceEnding() const
{
  return "vtt";
}

//------------------------------------------------------------------------------
const char* vtkHeliosWaveformXMLWriter::GetIndexElement() const
{
  return "PTable";
}

//------------------------------------------------------------------------------
vtkFieldData* vtkHeliosWaveformXMLWriter::GetRecords(vtkDataObject* block, vtkIdType& count)
{
  auto* table = vtkTable::SafeDownCast(block);
  if (!table)
  {
    this->RefuseBlock(block, "vtkTable");
    return nullptr;
  }
  const helios::Status status = helios::WaveformTable().Set(table);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< this->GetOpenName() << ": the block " << status.Message() << "; write "
                  << this->GetBlockSource());
    return nullptr;
  }
  count = table->GetNumberOfRows();
  return table->GetRowData();
}

//------------------------------------------------------------------------------
std::string vtkHeliosWaveformXMLWriter::DeclareArrays(const std::string& lines) const
{
  return "    <PRowData>\n" + lines + "    </PRowData>\n";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkXMLWriter> vtkHeliosWaveformXMLWriter::MakeWriter(vtkDataObject* block) const
{
  auto writer = vtkSmartPointer<vtkXMLTableWriter>::New();
  writer->SetInputData(block);
  return writer;
}
