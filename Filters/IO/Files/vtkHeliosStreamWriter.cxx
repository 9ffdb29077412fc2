// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosStreamWriter.h"

#include "heliosColumn.h"
#include "heliosPartFile.h"
#include "heliosTextFormat.h"

#include <vtkFieldData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <fstream>
#include <vector>

namespace
{

// Size of the text that one thread formats at a time [bytes].
constexpr vtkIdType ChunkSize = 1 << 16;

// Size of the text that is copied at a time [bytes].
constexpr std::size_t CopySize = 1 << 20;

/// Formats the rows of a block in rounds of chunks; one round is in memory at a time.
class RowFormatter
{
public:
  using FormatRow = std::function<void(vtkIdType row, helios::TextBuffer& text)>;

  RowFormatter(vtkIdType count, vtkIdType bytesPerRow, const FormatRow& format)
    : Count(count)
    , RowsPerChunk(std::max<vtkIdType>(1, ChunkSize / std::max<vtkIdType>(1, bytesPerRow)))
    , Format(format)
    , Chunks(8 * static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads()))
  {
  }

  /// Formats the next round and calls use(text) for its chunks in order; false if use returns
  /// false.
  template <typename UseT>
  bool NextRound(const UseT& use)
  {
    const auto count = std::min(static_cast<vtkIdType>(this->Chunks.size()),
      (this->Count - this->Next + this->RowsPerChunk - 1) / this->RowsPerChunk);
    vtkSMPTools::For(0, count, 1,
      [this](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType chunk = begin; chunk < end; ++chunk)
        {
          this->FormatChunk(chunk);
        }
      });
    this->Next += count * this->RowsPerChunk;
    return std::all_of(this->Chunks.begin(), this->Chunks.begin() + count,
      [this, &use](const Chunk& chunk)
      {
        this->NumberOfRows += chunk.NumberOfRows;
        return use(chunk.Text);
      });
  }

  bool HasRows() const { return this->Next < this->Count; }

  /// Returns the number of rows so far with finite numbers.
  vtkIdType GetNumberOfRows() const { return this->NumberOfRows; }

private:
  struct Chunk
  {
    helios::TextBuffer Text;
    vtkIdType NumberOfRows = 0;
  };

  void FormatChunk(vtkIdType index)
  {
    Chunk& chunk = this->Chunks[static_cast<std::size_t>(index)];
    chunk.Text.Cut(0);
    chunk.NumberOfRows = 0;
    const vtkIdType first = this->Next + index * this->RowsPerChunk;
    const vtkIdType last = std::min(this->Count, first + this->RowsPerChunk);
    for (vtkIdType row = first; row < last; ++row)
    {
      const std::size_t size = chunk.Text.GetSize();
      this->Format(row, chunk.Text);
      if (chunk.Text.IsFinite())
      {
        ++chunk.NumberOfRows;
      }
      else
      {
        chunk.Text.Cut(size);
      }
    }
  }

  vtkIdType Count;
  vtkIdType RowsPerChunk;
  const FormatRow& Format;
  std::vector<Chunk> Chunks;
  vtkIdType Next = 0;
  vtkIdType NumberOfRows = 0;
};

} // namespace

//------------------------------------------------------------------------------
vtkHeliosStreamWriter::vtkHeliosStreamWriter()
  : File(std::make_unique<helios::PartFile>())
{
}

//------------------------------------------------------------------------------
vtkHeliosStreamWriter::~vtkHeliosStreamWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosStreamWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "NumberOfRecords: " << this->NumberOfRecords << "\n"
     << indent << "NumberOfBytes: " << this->NumberOfBytes << "\n"
     << indent << "CountOnly: " << this->CountOnly << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::PrepareOpen()
{
  if (this->IsOpen())
  {
    vtkErrorMacro(<< this->GetOpenName() << " is open already; Close() or Abandon() it first");
    return false;
  }
  this->HasFailed = false;
  this->NumberOfRecords = 0;
  this->NumberOfBytes = 0;
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; set it before Open()");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
const char* vtkHeliosStreamWriter::GetPartEnding()
{
  return helios::PartEnding;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::Open()
{
  if (!this->PrepareOpen())
  {
    return false;
  }
  if (!(this->CountOnly ? this->File->OpenCountOnly(this->FileName)
                        : this->File->Open(this->FileName)))
  {
    vtkErrorMacro(<< this->File->GetProblem() << "; choose another output folder");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::Reopen(
  vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes)
{
  if (!this->PrepareOpen())
  {
    return false;
  }
  if (!this->File->Reopen(this->FileName, static_cast<std::uint64_t>(fileSize)))
  {
    return this->FailFile(this->File->GetProblem());
  }
  this->NumberOfRecords = numberOfRecords;
  this->NumberOfBytes = numberOfBytes;
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::Flush()
{
  const std::string problem = this->CheckOpen() ? this->Sync() : std::string();
  return problem.empty() ? this->IsOpen() && !this->HasFailed : this->FailFile(problem);
}

//------------------------------------------------------------------------------
std::string vtkHeliosStreamWriter::Sync()
{
  return this->File->Sync().Message();
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::FailFile(const std::string& problem)
{
  this->HasFailed = this->IsOpen();
  vtkErrorMacro(<< problem
                << "; keep the output folder unchanged and with free space, and run again");
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::IsOpen() const
{
  return this->File->IsOpen();
}

//------------------------------------------------------------------------------
const std::string& vtkHeliosStreamWriter::GetOpenName() const
{
  return this->File->GetPath();
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosStreamWriter::GetFileSize() const
{
  return static_cast<vtkIdType>(this->File->GetSize());
}

//------------------------------------------------------------------------------
std::vector<helios::FileBlock> vtkHeliosStreamWriter::CollectBlocks()
{
  return { this->File->CollectBlock() };
}

//------------------------------------------------------------------------------
std::string vtkHeliosStreamWriter::GetHeadChecksum() const
{
  return {};
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::RestoreHead(const std::string& checksum)
{
  return this->GetHeadChecksum() == checksum;
}

//------------------------------------------------------------------------------
void vtkHeliosStreamWriter::EndHead()
{
  this->File->BeginBlock();
}

//------------------------------------------------------------------------------
/// Describes what remains of the written blocks.
std::string vtkHeliosStreamWriter::DescribeKept() const
{
  return this->File->IsRemoved()
    ? "nothing is kept, since " + this->File->GetPartPath() + " was removed"
    : std::to_string(this->NumberOfRecords) + " records are safe in " + this->GetSafePlace();
}

//------------------------------------------------------------------------------
std::string vtkHeliosStreamWriter::GetSafePlace() const
{
  return this->File->GetPartPath();
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::CheckOpen()
{
  if (!this->IsOpen())
  {
    vtkErrorMacro(<< (this->FileName ? this->FileName : "the file")
                  << " is not open; call Open() before Write() and Close()");
    return false;
  }
  if (this->HasFailed)
  {
    vtkErrorMacro(<< this->GetOpenName() << " lacks a block that could not be written; "
                  << this->DescribeKept() << "; call Abandon() and run again");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::Close()
{
  if (!this->CheckOpen())
  {
    this->Abandon();
    return false;
  }
  const bool isRemoved = this->File->IsRemoved();
  if (!this->File->Close())
  {
    vtkErrorMacro(<< this->File->GetProblem() << "; "
                  << (isRemoved ? std::string("nothing is kept; run again")
                                : std::to_string(this->NumberOfRecords) +
                           " records were written to " + this->GetSafePlace()));
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::ReplaceBy(const std::string& made)
{
  return this->File->ReplaceBy(made) || this->FailFile(this->File->GetProblem());
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::Abandon()
{
  if (!this->File->Abandon())
  {
    vtkErrorMacro(<< this->File->GetProblem());
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosStreamWriter::RefuseBlock(vtkDataObject* block, const char* type)
{
  vtkErrorMacro(<< this->GetOpenName() << ": a block is "
                << (block ? block->GetClassName() : "null") << ", not " << type << "; write "
                << this->GetBlockSource());
}

//------------------------------------------------------------------------------
vtkPolyData* vtkHeliosStreamWriter::GetPoints(vtkDataObject* block)
{
  auto* data = vtkPolyData::SafeDownCast(block);
  if (!data)
  {
    this->RefuseBlock(block, "vtkPolyData");
    return nullptr;
  }
  if (data->GetNumberOfPoints() > 0 && data->GetPoints()->GetDataType() != VTK_DOUBLE)
  {
    vtkErrorMacro(<< this->GetOpenName() << ": the points of a block are "
                  << data->GetPoints()->GetData()->GetDataTypeAsString()
                  << ", not double; call SetDataTypeToDouble() of vtkPoints before filling them");
    return nullptr;
  }
  return data;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::GetNumbers(
  vtkFieldData* data, const char* name, vtkIdType tuples, int components, helios::Column& column)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array)
  {
    vtkErrorMacro(<< this->GetOpenName() << ": the block has no array " << name << "; "
                  << this->GetBlockSource() << " have it");
    return false;
  }
  if (array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != tuples)
  {
    vtkErrorMacro(<< this->GetOpenName() << ": the array " << name << " of the block has "
                  << array->GetNumberOfTuples() << " x " << array->GetNumberOfComponents()
                  << " values, not " << tuples << " x " << components);
    return false;
  }
  column = helios::Column(array);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::GetIntegers(
  vtkFieldData* data, const char* name, vtkIdType tuples, helios::Column& column)
{
  if (!this->GetNumbers(data, name, tuples, 1, column))
  {
    return false;
  }
  if (!column.HasIntegers())
  {
    vtkErrorMacro(<< this->GetOpenName() << ": the array " << name << " of the block holds "
                  << data->GetArray(name)->GetDataTypeAsString() << "; it must hold integers");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::WriteRows(vtkIdType count, vtkIdType bytesPerRow,
  const std::function<void(vtkIdType row, helios::TextBuffer& text)>& format)
{
  const vtkIdType size = this->GetFileSize();
  RowFormatter rows(count, bytesPerRow, format);
  std::string* block = this->CountOnly ? this->BlockText : nullptr;
  const auto append = [this, block](const helios::TextBuffer& text)
  {
    if (block)
    {
      block->append(text.GetText(), text.GetSize());
    }
    return this->File->Append(text.GetText(), text.GetSize());
  };
  while (rows.HasRows())
  {
    if (!rows.NextRound(append))
    {
      return this->FailBlock(this->File->GetProblem(), size);
    }
  }
  this->NumberOfRecords += rows.GetNumberOfRows();
  this->NumberOfBytes += this->GetFileSize() - size;
  if (rows.GetNumberOfRows() < count)
  {
    vtkWarningMacro(<< this->GetOpenName() << ": " << count - rows.GetNumberOfRows() << " of "
                    << count << " records of a block have a number that is not finite: left out");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::CopyRows(
  const std::string& path, const helios::FileBlock& block, vtkIdType count)
{
  const vtkIdType start = this->GetFileSize();
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(block.Begin));
  std::vector<char> bytes(CopySize);
  for (std::uint64_t at = block.Begin; at < block.End; at += bytes.size())
  {
    bytes.resize(std::min<std::uint64_t>(CopySize, block.End - at));
    if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    {
      return this->FailBlock(path + ": its bytes " + std::to_string(block.Begin) + " to " +
          std::to_string(block.End) + " cannot be read",
        start);
    }
    if (!this->WriteBytes(bytes.data(), bytes.size(), start))
    {
      return false;
    }
  }
  this->NumberOfRecords += count;
  this->NumberOfBytes += this->GetFileSize() - start;
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::CopyRows(const std::string& rows, vtkIdType count)
{
  if (!this->WriteBytes(rows.data(), rows.size(), this->GetFileSize()))
  {
    return false;
  }
  this->NumberOfRecords += count;
  this->NumberOfBytes += static_cast<vtkIdType>(rows.size());
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::WriteText(const std::string& text)
{
  const vtkIdType size = this->GetFileSize();
  return this->File->Append(text.data(), text.size()) ||
    this->FailBlock(this->File->GetProblem(), size);
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::WriteBytes(const char* bytes, std::size_t count, vtkIdType start)
{
  return this->File->Append(bytes, count) || this->FailBlock(this->File->GetProblem(), start);
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::OverwriteBytes(vtkIdType place, const std::string& bytes)
{
  return this->File->Overwrite(static_cast<std::uint64_t>(place), bytes.data(), bytes.size()) ||
    this->FailBlock(this->File->GetProblem(), this->GetFileSize());
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::TruncateTo(vtkIdType size)
{
  return this->File->Cut(static_cast<std::uint64_t>(size)) ||
    this->FailFile(this->File->GetProblem());
}

//------------------------------------------------------------------------------
// NOLINTNEXTLINE(performance-unnecessary-value-param): truncation may replace that of the file
bool vtkHeliosStreamWriter::FailBlock(std::string problem, vtkIdType size)
{
  this->HasFailed = true;
  if (this->File->IsRemoved())
  {
    vtkErrorMacro(<< problem << "; " << this->DescribeKept() << "; run again");
    return false;
  }
  const bool isCut = this->File->Cut(static_cast<std::uint64_t>(size));
  vtkErrorMacro(<< problem << "; " << (isCut ? "" : "the first ") << this->NumberOfRecords
                << " records are safe in " << this->GetSafePlace()
                << (isCut ? "" : ", which has part of a block after them")
                << "; make room or choose another output folder, and run again");
  return false;
}
