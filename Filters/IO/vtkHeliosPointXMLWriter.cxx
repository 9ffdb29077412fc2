// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointXMLWriter.h"

#include "heliosPartFile.h"

#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <sstream>

vtkStandardNewMacro(vtkHeliosPointXMLWriter);

namespace
{

constexpr std::size_t CompressorBlockSize = 1 << 20;

/// The type's name in VTK's XML files.
std::string GetTypeName(vtkDataArray* array)
{
  const char* kind = "Int";
  if (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT)
  {
    kind = "Float";
  }
  else if (array->GetDataTypeMin() >= 0)
  {
    kind = "UInt";
  }
  return kind + std::to_string(8 * array->GetDataTypeSize());
}

std::string EscapeXml(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    switch (c)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
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

/// The cause of a file that is not whole.
std::string Explain(unsigned long error)
{
  return error == vtkErrorCode::NoError || error == vtkErrorCode::OutOfDiskSpaceError
    ? "No space left on device"
    : vtkErrorCode::GetStringFromErrorCode(error);
}

/// Takes the messages of VTK's writer, so that there is one error and not two.
class Silence : public vtkCommand
{
public:
  static Silence* New() { return new Silence; }
  void Execute(vtkObject*, unsigned long, void*) override {}
};

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPointXMLWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHeliosPointXMLWriter::GetBlockSource() const
{
  return "the echoes of vtkHeliosScanner (output port 0)";
}

//------------------------------------------------------------------------------
std::string vtkHeliosPointXMLWriter::GetPieceName(int piece) const
{
  char number[24];
  std::snprintf(number, sizeof(number), "_%04d.vtp", piece);
  return std::filesystem::path(this->GetOpenName()).replace_extension().string() + number;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPointXMLWriter::GetSafePlace() const
{
  if (this->NumberOfPieces == 0)
  {
    return "no file";
  }
  const std::string first = this->GetPieceName(0);
  return this->NumberOfPieces == 1 ? first
                                   : first + " to " + this->GetPieceName(this->NumberOfPieces - 1);
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::Open()
{
  if (!this->Superclass::Open())
  {
    return false;
  }
  this->Arrays.clear();
  this->HasHead = false;
  this->NumberOfPieces = 0;
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::CheckArrays(vtkPolyData* echoes)
{
  std::string arrays;
  vtkPointData* data = echoes->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const char* name = data->GetArrayName(i);
    if (!array || !name || array->GetNumberOfTuples() != echoes->GetNumberOfPoints())
    {
      vtkErrorMacro(<< this->GetOpenName() << ": the array " << (name ? name : "without a name")
                    << " of a block is not one tuple of numbers a point");
      return false;
    }
    if (std::strpbrk(name, "<&\""))
    {
      vtkErrorMacro(<< this->GetOpenName() << ": the array " << name
                    << " of a block has a name that "
                    << "VTK's XML cannot hold; rename it without <, & and \"");
      return false;
    }
    arrays += "      " + Declare(array, name) + "\n";
  }
  if (this->NumberOfPieces > 0 && arrays != this->Arrays)
  {
    vtkErrorMacro(<< this->GetOpenName() << ": a block has other arrays than those before, which "
                  << "had\n"
                  << this->Arrays << "and not\n"
                  << arrays << "  write it to another file");
    return false;
  }
  this->Arrays = arrays;
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::WriteHead()
{
  if (this->HasHead)
  {
    return true;
  }
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n"
       << "<VTKFile type=\"PPolyData\" version=\"1.0\" header_type=\"UInt64\">\n"
       << "  <PPolyData GhostLevel=\"0\">\n"
       << "    <PPointData>\n"
       << this->Arrays << "    </PPointData>\n"
       << "    <PPoints>\n"
       << "      <PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
       << "    </PPoints>\n";
  this->HasHead = this->WriteText(text.str());
  return this->HasHead;
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::WriteFoot()
{
  return this->WriteHead() && this->WriteText("  </PPolyData>\n</VTKFile>\n");
}

//------------------------------------------------------------------------------
std::int64_t vtkHeliosPointXMLWriter::WritePiece(vtkPolyData* echoes, const std::string& name)
{
  const std::string part = name + ".part";
  vtkNew<vtkXMLPolyDataWriter> writer;
  const auto silence = vtkSmartPointer<Silence>::Take(Silence::New());
  writer->AddObserver(vtkCommand::ErrorEvent, silence);
  writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  writer->SetFileName(part.c_str());
  writer->SetInputData(WithVertices(echoes));
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  writer->SetIdTypeToInt64();
  writer->SetCompressorTypeToLZ4();
  writer->SetBlockSize(CompressorBlockSize);
  writer->Write();
  const std::int64_t size = helios::GetSizeOfWhole(part, "</VTKFile>\n");
  const std::string problem = writer->GetErrorCode() != vtkErrorCode::NoError || size < 0
    ? part + " cannot be written: " + Explain(writer->GetErrorCode())
    : helios::RenameFile(part, name);
  if (!problem.empty())
  {
    helios::RemoveFile(part);
    this->FailBlock(problem, this->GetFileSize());
    return -1;
  }
  return size;
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::Write(vtkDataObject* block)
{
  vtkPolyData* echoes = this->CheckOpen() ? this->GetPoints(block) : nullptr;
  if (!echoes)
  {
    return false;
  }
  if (echoes->GetNumberOfPoints() == 0)
  {
    return true;
  }
  const std::string name = this->GetPieceName(this->NumberOfPieces);
  const std::string source = std::filesystem::path(name).filename().string();
  if (!this->CheckArrays(echoes) || !this->WriteHead())
  {
    return false;
  }
  const std::int64_t size = this->WritePiece(echoes, name);
  if (size < 0 || !this->WriteText("    <Piece Source=\"" + EscapeXml(source) + "\"/>\n"))
  {
    return false;
  }
  this->NumberOfBytes += size;
  ++this->NumberOfPieces;
  this->NumberOfRecords += echoes->GetNumberOfPoints();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::Close()
{
  if (!this->CheckOpen())
  {
    this->Abandon();
    return false;
  }
  if (!this->WriteFoot())
  {
    this->Superclass::Abandon();
    return false;
  }
  return this->Superclass::Close();
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLWriter::Abandon()
{
  const bool good = !this->IsOpen() || this->WriteFoot();
  return this->Superclass::Abandon() && good;
}
