// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointXMLWriter.h"

#include "heliosPartFile.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdio>
#include <filesystem>
#include <sstream>

vtkStandardNewMacro(vtkHeliosPointXMLWriter);

namespace
{

/// The type's name in VTK's XML files.
std::string GetTypeName(vtkDataArray* array)
{
  if (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT)
  {
    return "Float" + std::to_string(8 * array->GetDataTypeSize());
  }
  const bool isSigned = array->GetDataTypeMin() < 0;
  return (isSigned ? "Int" : "UInt") + std::to_string(8 * array->GetDataTypeSize());
}

std::string Declare(vtkDataArray* array, const char* name)
{
  std::ostringstream text;
  text << "<PDataArray type=\"" << GetTypeName(array) << "\" Name=\"" << name
       << "\" NumberOfComponents=\"" << array->GetNumberOfComponents() << "\"/>";
  return text.str();
}

/// The block itself, or a shallow copy with a vertex a point.
vtkSmartPointer<vtkPolyData> WithVertices(vtkPolyData* block)
{
  if (block->GetNumberOfCells() > 0)
  {
    return block;
  }
  const vtkIdType count = block->GetNumberOfPoints();
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(count, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
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
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::Open()
{
  this->NumberOfPieces = 0;
  this->Arrays.clear();
  return this->Superclass::Open();
}

//------------------------------------------------------------------------------
std::string vtkHeliosPointXMLWriter::GetPieceName(int piece) const
{
  char number[16];
  std::snprintf(number, sizeof(number), "_%04d.vtp", piece);
  return std::filesystem::path(this->FileName).replace_extension().string() + number;
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::Write(vtkDataObject* block)
{
  if (!this->CheckOpen())
  {
    return false;
  }
  auto* echoes = vtkPolyData::SafeDownCast(block);
  if (!echoes)
  {
    vtkErrorMacro(<< this->FileName << ": a block is not vtkPolyData");
    return false;
  }
  const std::string name = this->GetPieceName(this->NumberOfPieces);
  const std::string part = name + ".part";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(part.c_str());
  writer->SetInputData(WithVertices(echoes));
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  const bool written = writer->Write() && writer->GetErrorCode() == 0;
  const std::string problem =
    written ? helios::RenameFile(part, name) : part + " cannot be written";
  if (!problem.empty())
  {
    std::remove(part.c_str());
    vtkErrorMacro(<< problem << "; " << this->NumberOfRecords << " records are safe in "
                  << this->NumberOfPieces << " pieces beside " << this->FileName
                  << "; make room or choose another output folder, and run again");
    return false;
  }
  if (this->NumberOfPieces == 0)
  {
    vtkPointData* data = echoes->GetPointData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      this->Arrays.push_back(Declare(data->GetArray(i), data->GetArrayName(i)));
    }
  }
  ++this->NumberOfPieces;
  this->NumberOfRecords += echoes->GetNumberOfPoints();
  this->NumberOfBytes += static_cast<vtkIdType>(std::filesystem::file_size(name));
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::Close()
{
  if (!this->CheckOpen())
  {
    return false;
  }
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n"
       << "<VTKFile type=\"PPolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
          "header_type=\"UInt64\">\n"
       << "  <PPolyData GhostLevel=\"0\">\n"
       << "    <PPointData>\n";
  for (const std::string& array : this->Arrays)
  {
    text << "      " << array << "\n";
  }
  text << "    </PPointData>\n"
       << "    <PPoints><PDataArray type=\"Float64\" Name=\"Points\" "
          "NumberOfComponents=\"3\"/></PPoints>\n";
  for (int piece = 0; piece < this->NumberOfPieces; ++piece)
  {
    text << "    <Piece Source=\""
         << std::filesystem::path(this->GetPieceName(piece)).filename().string() << "\"/>\n";
  }
  text << "  </PPolyData>\n</VTKFile>\n";
  const std::string index = text.str();
  return this->AppendBytes(index.data(), index.size()) && this->Superclass::Close();
}
