// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosXMLPieceWriter.h"

#include "heliosPartFile.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkXMLWriter.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{

constexpr std::size_t CompressorBlockSize = 1 << 20;
constexpr const char* PieceEnd = "</VTKFile>\n";

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

/// The cause of a file that is not whole.
std::string Explain(unsigned long error)
{
  return error == vtkErrorCode::NoError || error == vtkErrorCode::OutOfDiskSpaceError
    ? "No space left on device"
    : vtkErrorCode::GetStringFromErrorCode(error);
}

/// The pieces that an index lists.
int CountPieces(const std::string& index)
{
  std::ifstream file(index);
  int count = 0;
  for (std::string line; std::getline(file, line);)
  {
    count += line.find("<Piece ") != std::string::npos ? 1 : 0;
  }
  return count;
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
void vtkHeliosXMLPieceWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
}

//------------------------------------------------------------------------------
std::string vtkHeliosXMLPieceWriter::GetPieceName(int piece) const
{
  char number[24];
  std::snprintf(number, sizeof(number), "_%04d.%s", piece, this->GetPieceEnding());
  return std::filesystem::path(this->GetOpenName()).replace_extension().string() + number;
}

//------------------------------------------------------------------------------
std::string vtkHeliosXMLPieceWriter::GetSafePlace() const
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
bool vtkHeliosXMLPieceWriter::Open()
{
  if (!this->Superclass::Open())
  {
    return false;
  }
  this->Arrays.clear();
  this->HasHead = false;
  this->NumberOfPieces = 0;
  this->NumberOfPiecesOnDisk = 0;
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosXMLPieceWriter::Reopen(
  vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes)
{
  if (!this->Superclass::Reopen(fileSize, numberOfRecords, numberOfBytes))
  {
    return false;
  }
  this->Arrays.clear(); // those of the next block
  this->HasHead = fileSize > 0;
  this->NumberOfPieces = CountPieces(this->GetOpenName() + ".part");
  this->NumberOfPiecesOnDisk = this->NumberOfPieces;
  for (int piece = 0; piece < this->NumberOfPieces; ++piece)
  {
    const std::string name = this->GetPieceName(piece);
    if (helios::GetSizeOfWhole(name, PieceEnd) < 0)
    {
      this->FailFile(name + " is not there whole, and cannot be gone on after");
      this->Superclass::Abandon();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosXMLPieceWriter::Flush()
{
  if (!this->CheckOpen())
  {
    return false;
  }
  std::string problem;
  for (; !this->CountOnly && problem.empty() && this->NumberOfPiecesOnDisk < this->NumberOfPieces;
       ++this->NumberOfPiecesOnDisk)
  {
    const std::string name = this->GetPieceName(this->NumberOfPiecesOnDisk);
    problem = helios::SyncFile(name);
    problem = problem.empty() ? helios::SyncFolderOf(name) : problem;
  }
  return problem.empty() ? this->Superclass::Flush() : this->FailFile(problem);
}

//------------------------------------------------------------------------------
bool vtkHeliosXMLPieceWriter::CheckArrays(vtkFieldData* data, vtkIdType records)
{
  std::string arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const char* name = data->GetArrayName(i);
    if (!array || !name || array->GetNumberOfTuples() != records)
    {
      vtkErrorMacro(<< this->GetOpenName() << ": the array " << (name ? name : "without a name")
                    << " of a block is not one tuple of numbers a record");
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
  if (this->NumberOfPieces > 0 && !this->Arrays.empty() && arrays != this->Arrays)
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
bool vtkHeliosXMLPieceWriter::WriteHead()
{
  if (!this->HasHead)
  {
    const std::string element = this->GetIndexElement();
    this->HasHead = this->WriteText("<?xml version=\"1.0\"?>\n<VTKFile type=\"" + element +
      "\" version=\"1.0\" header_type=\"UInt64\">\n  <" + element + " GhostLevel=\"0\">\n" +
      this->DeclareArrays(this->Arrays));
  }
  return this->HasHead;
}

//------------------------------------------------------------------------------
bool vtkHeliosXMLPieceWriter::WriteFoot()
{
  return this->WriteHead() &&
    this->WriteText(std::string("  </") + this->GetIndexElement() + ">\n</VTKFile>\n");
}

//------------------------------------------------------------------------------
std::int64_t vtkHeliosXMLPieceWriter::WritePiece(vtkDataObject* block, const std::string& name)
{
  const vtkSmartPointer<vtkXMLWriter> writer = this->MakeWriter(block);
  const auto silence = vtkSmartPointer<Silence>::Take(Silence::New());
  writer->AddObserver(vtkCommand::ErrorEvent, silence);
  writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  writer->SetIdTypeToInt64();
  writer->SetCompressorTypeToLZ4();
  writer->SetBlockSize(CompressorBlockSize);
  if (this->CountOnly)
  {
    writer->SetWriteToOutputString(true);
    writer->Write();
    return static_cast<std::int64_t>(writer->GetOutputString().size());
  }
  std::int64_t size = -1;
  const std::string problem = this->WritePieceFile(writer, name, size);
  if (!problem.empty())
  {
    helios::RemoveFile(name + ".part");
    this->FailBlock(problem, this->GetFileSize());
    return -1;
  }
  return size;
}

//------------------------------------------------------------------------------
std::string vtkHeliosXMLPieceWriter::WritePieceFile(
  vtkXMLWriter* writer, const std::string& name, std::int64_t& size)
{
  const std::string part = name + ".part";
  writer->SetFileName(part.c_str());
  writer->Write();
  size = helios::GetSizeOfWhole(part, PieceEnd);
  return writer->GetErrorCode() != vtkErrorCode::NoError || size < 0
    ? part + " cannot be written: " + Explain(writer->GetErrorCode())
    : helios::RenameFile(part, name);
}

//------------------------------------------------------------------------------
bool vtkHeliosXMLPieceWriter::Write(vtkDataObject* block)
{
  vtkIdType count = 0;
  vtkFieldData* records = this->CheckOpen() ? this->GetRecords(block, count) : nullptr;
  if (!records)
  {
    return false;
  }
  if (count == 0)
  {
    return true;
  }
  const std::string name = this->GetPieceName(this->NumberOfPieces);
  const std::string source = std::filesystem::path(name).filename().string();
  if (!this->CheckArrays(records, count) || !this->WriteHead())
  {
    return false;
  }
  const std::int64_t size = this->WritePiece(block, name);
  if (size < 0 || !this->WriteText("    <Piece Source=\"" + EscapeXml(source) + "\"/>\n"))
  {
    return false;
  }
  this->NumberOfBytes += size;
  ++this->NumberOfPieces;
  this->NumberOfRecords += count;
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosXMLPieceWriter::Close()
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
bool vtkHeliosXMLPieceWriter::Abandon()
{
  const bool good = !this->IsOpen() || this->WriteFoot();
  return this->Superclass::Abandon() && good;
}
