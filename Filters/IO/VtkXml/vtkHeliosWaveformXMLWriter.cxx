// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosWaveformXMLWriter.h"

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
  const std::string problem = helios::WaveformTable().Set(table);
  if (!problem.empty())
  {
    vtkErrorMacro(<< this->GetOpenName() << ": the block " << problem << "; write "
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
