// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosStreamWriter.h"

#include "heliosPartFile.h"
#include "heliosTextFormat.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <vector>

namespace
{

// Rows that one thread formats at a time, and rows in memory as text.
constexpr vtkIdType RowsPerChunk = 4096;
constexpr vtkIdType ChunksTogether = 64;

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
     << indent << "NumberOfBytes: " << this->NumberOfBytes << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::Open()
{
  this->IsOpen = false;
  this->NumberOfRecords = 0;
  this->NumberOfBytes = 0;
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set");
    return false;
  }
  this->IsOpen = this->File->Open(this->FileName);
  if (!this->IsOpen)
  {
    vtkErrorMacro(<< this->File->GetProblem() << "; choose another output folder");
  }
  return this->IsOpen;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::CheckOpen()
{
  if (!this->IsOpen)
  {
    vtkErrorMacro(<< (this->FileName ? this->FileName : "the writer")
                  << " is not open; call Open() before Write() and Close()");
  }
  return this->IsOpen;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::Close()
{
  if (!this->CheckOpen())
  {
    return false;
  }
  this->IsOpen = false;
  if (!this->File->Close())
  {
    vtkErrorMacro(<< this->File->GetProblem());
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::Abandon()
{
  this->IsOpen = false;
  this->File->Abandon();
  return true;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkHeliosStreamWriter::GetArray(vtkFieldData* data, const char* name, int components)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array)
  {
    vtkErrorMacro(<< this->FileName << ": the block has no array " << name
                  << "; the outputs of vtkHeliosScanner and of platforms have it");
  }
  else if (array->GetNumberOfComponents() != components)
  {
    vtkErrorMacro(<< this->FileName << ": the array " << name << " of the block has "
                  << array->GetNumberOfComponents() << " components, not " << components);
    return nullptr;
  }
  return array;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::AppendBytes(const char* bytes, std::size_t count)
{
  if (!this->File->Append(bytes, count))
  {
    vtkErrorMacro(<< this->File->GetProblem() << "; " << this->NumberOfRecords
                  << " records are safe in " << this->File->GetPartPath()
                  << "; make room or choose another output folder, and run again");
    return false;
  }
  this->NumberOfBytes += static_cast<vtkIdType>(count);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosStreamWriter::WriteRows(
  vtkIdType count, const std::function<void(vtkIdType row, helios::TextBuffer& text)>& format)
{
  std::vector<helios::TextBuffer> chunks(static_cast<std::size_t>(ChunksTogether));
  for (vtkIdType first = 0; first < count; first += ChunksTogether * RowsPerChunk)
  {
    const vtkIdType last = std::min(count, first + ChunksTogether * RowsPerChunk);
    const vtkIdType chunkCount = (last - first + RowsPerChunk - 1) / RowsPerChunk;
    vtkSMPTools::For(0, chunkCount, 1,
      [&chunks, &format, first, last](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType c = begin; c < end; ++c)
        {
          helios::TextBuffer& text = chunks[static_cast<std::size_t>(c)];
          text.Clear();
          const vtkIdType from = first + c * RowsPerChunk;
          for (vtkIdType row = from; row < std::min(last, from + RowsPerChunk); ++row)
          {
            format(row, text);
          }
        }
      });
    for (vtkIdType c = 0; c < chunkCount; ++c)
    {
      const helios::TextBuffer& text = chunks[static_cast<std::size_t>(c)];
      if (!this->AppendBytes(text.GetText(), text.GetSize()))
      {
        return false;
      }
      const vtkIdType from = first + c * RowsPerChunk;
      this->NumberOfRecords += std::min(last, from + RowsPerChunk) - from;
    }
  }
  return true;
}
