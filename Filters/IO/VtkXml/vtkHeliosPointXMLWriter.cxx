// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointXMLWriter.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <numeric>

vtkStandardNewMacro(vtkHeliosPointXMLWriter);

namespace
{

/// Returns the block itself, or a shallow copy with one vertex per point.
vtkSmartPointer<vtkPolyData> WithVertices(vtkPolyData* block)
{
  if (block->GetNumberOfCells() > 0)
  {
    return block;
  }
  const vtkIdType count = block->GetNumberOfPoints();
  vtkNew<vtkCellArray> vertices;
  vertices->Use64BitStorage();
  vertices->ResizeExact(count, count);
  vtkTypeInt64* offsets = vertices->GetOffsetsArray64()->GetPointer(0);
  std::iota(offsets, offsets + count + 1, 0);
  vtkTypeInt64* ids = vertices->GetConnectivityArray64()->GetPointer(0);
  std::iota(ids, ids + count, 0);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(block);
  copy->SetVerts(vertices);
  return copy;
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPointXMLWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkHeliosPointXMLWriter::GetBlockSource() const
{
  return "the echoes of vtkHeliosScanner (output port 0)";
}

//------------------------------------------------------------------------------
const char* vtkHeliosPointXMLWriter::GetPieceEnding() const
{
  return "vtp";
}

//------------------------------------------------------------------------------
const char* vtkHeliosPointXMLWriter::GetIndexElement() const
{
  return "PPolyData";
}

//------------------------------------------------------------------------------
vtkFieldData* vtkHeliosPointXMLWriter::GetRecords(vtkDataObject* block, vtkIdType& count)
{
  vtkPolyData* echoes = this->GetPoints(block);
  count = echoes ? echoes->GetNumberOfPoints() : 0;
  return echoes ? echoes->GetPointData() : nullptr;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPointXMLWriter::DeclareArrays(const std::string& lines) const
{
  return "    <PPointData>\n" + lines +
    "    </PPointData>\n"
    "    <PPoints>\n"
    "      <PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
    "    </PPoints>\n";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkXMLWriter> vtkHeliosPointXMLWriter::MakeWriter(vtkDataObject* block) const
{
  auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  writer->SetInputData(WithVertices(vtkPolyData::SafeDownCast(block)));
  return writer;
}
