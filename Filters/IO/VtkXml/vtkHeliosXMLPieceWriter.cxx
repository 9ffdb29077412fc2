// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosXMLPieceWriter.h"

#include "heliosPartFile.h"
#include "heliosStatus.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkInformationInformationVectorKey.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
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

/// Returns the name of the type in VTK XML files.
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

/// Counts the pieces listed by an index.
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

/// Removes the cached ranges of an array. VTK stores them once computed and then writes the array
/// differently: the bytes would depend on what was written before.
void EvenOut(vtkAbstractArray* array)
{
  vtkInformation* information = array->GetInformation();
  information->Remove(vtkAbstractArray::PER_COMPONENT());
  information->Remove(vtkAbstractArray::PER_FINITE_COMPONENT());
  information->Remove(vtkDataArray::L2_NORM_RANGE());
  information->Remove(vtkDataArray::L2_NORM_FINITE_RANGE());
}

void EvenOut(vtkDataObject* block)
{
  auto* points = vtkPointSet::SafeDownCast(block);
  if (points && points->GetPoints())
  {
    EvenOut(points->GetPoints()->GetData());
  }
  for (int type = 0; type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
  {
    vtkFieldData* data = block->GetAttributesAsFieldData(type);
    for (int i = 0; data && i < data->GetNumberOfArrays(); ++i)
    {
      EvenOut(data->GetAbstractArray(i));
    }
  }
}

/// Collects the messages of the VTK writer, to report a single error.
class Silence : public vtkCommand
{
public:
  static Silence* New() { return new Silence; }
  void Execute(vtkObject*, unsigned long, void*) override {}
};

} // namespace

//------------------------------------------------------------------------------
vtkHeliosXMLPieceWriter::vtkHeliosXMLPieceWriter()
  : PieceBlocks(std::make_unique<std::vector<helios::FileBlock>>())
{
}

//------------------------------------------------------------------------------
vtkHeliosXMLPieceWriter::~vtkHeliosXMLPieceWriter() = default;

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
  this->PieceBlocks->clear();
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
  this->Arrays.clear(); // the next block declares the arrays
  this->PieceBlocks->clear();
  this->HasHead = fileSize > 0;
  this->NumberOfPieces = CountPieces(this->GetOpenName() + helios::PartEnding);
  this->NumberOfPiecesOnDisk = this->NumberOfPieces;
  for (int piece = 0; piece < this->NumberOfPieces; ++piece)
  {
    const std::string name = this->GetPieceName(piece);
    if (helios::GetSizeOfWhole(name, PieceEnd) < 0)
    {
      this->FailFile(name + " is missing or incomplete, and the run cannot be resumed after it");
      this->Superclass::Abandon();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkHeliosXMLPieceWriter::Sync()
{
  helios::Status status;
  for (; !this->CountOnly && status.IsOk() && this->NumberOfPiecesOnDisk < this->NumberOfPieces;
       ++this->NumberOfPiecesOnDisk)
  {
    const std::string name = this->GetPieceName(this->NumberOfPiecesOnDisk);
    status = helios::SyncFile(name);
    status = status.IsOk() ? helios::SyncFolderOf(name) : status;
  }
  return status.IsOk() ? this->Superclass::Sync() : status.Message();
}

//------------------------------------------------------------------------------
std::vector<helios::FileBlock> vtkHeliosXMLPieceWriter::CollectBlocks()
{
  std::vector<helios::FileBlock> blocks = this->Superclass::CollectBlocks();
  blocks.insert(blocks.end(), this->PieceBlocks->begin(), this->PieceBlocks->end());
  this->PieceBlocks->clear();
  return blocks;
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
                    << " of a block is not one tuple of numbers per record");
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
  EvenOut(block);
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
  // The VTK file writers do not report why they fail.
  writer->SetWriteToOutputString(true);
  writer->Write();
  const std::string bytes = writer->GetOutputString();
  const helios::Status status = this->WritePieceFile(bytes, name);
  if (!status.IsOk())
  {
    helios::RemoveFile(name + helios::PartEnding);
    this->FailBlock(status.Message(), this->GetFileSize());
    return -1;
  }
  return static_cast<std::int64_t>(bytes.size());
}

//------------------------------------------------------------------------------
/// Writes the file.
helios::Status vtkHeliosXMLPieceWriter::WritePieceFile(
  const std::string& bytes, const std::string& name)
{
  if (this->CountOnly)
  {
    if (this->BlockText)
    {
      this->BlockText->append(bytes);
    }
    return {};
  }
  helios::PartFile file;
  if (!file.Open(name, helios::Folders::Need) || !file.Append(bytes.data(), bytes.size()) ||
    !file.Abandon())
  {
    return helios::Status::Error(file.GetProblem());
  }
  this->PieceBlocks->push_back(file.CollectBlock());
  this->PieceBlocks->back().IsWhole = true;
  return helios::RenameFile(file.GetPartPath(), name);
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
