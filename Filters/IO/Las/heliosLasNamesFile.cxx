// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasNamesFile.h"

#include "heliosInputFile.h"
#include "heliosPartFile.h"
#include "heliosPointNames.h"

#include <vtkFieldData.h>

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace helios
{

//------------------------------------------------------------------------------
LasNamesFile::LasNamesFile() = default;

//------------------------------------------------------------------------------
LasNamesFile::~LasNamesFile() = default;

//------------------------------------------------------------------------------
void LasNamesFile::Begin(const std::string& path, bool isResumed)
{
  this->Path = path;
  this->IsResumed = isResumed;
  this->Count = 0;
  this->Names->Initialize();
}

//------------------------------------------------------------------------------
std::string LasNamesFile::GetPart() const
{
  return this->Path + PartEnding;
}

//------------------------------------------------------------------------------
Status LasNamesFile::Add(vtkFieldData* fields)
{
  const vtkIdType count = CountPointNames(fields);
  if (count <= this->Count)
  {
    return {};
  }
  this->Count = count;
  this->Names->DeepCopy(fields);
  const Status status = CheckPointNames(this->Path);
  return status.IsOk() ? WritePointNames(this->GetPart(), 0, fields) : status;
}

//------------------------------------------------------------------------------
Status LasNamesFile::Finish(vtkIdType points)
{
  const InputWatch ignore([](const std::string&, const std::string&) {});
  if (this->Count == 0 && this->IsResumed)
  {
    Status status = ReadPointNames(this->GetPart(), 0, this->Names);
    if (!status.IsOk()) // the run ended while it wrote the names of the whole file
    {
      status = ReadPointNames(this->GetPart(), points, this->Names);
    }
    if (status.IsOk() && CountPointNames(this->Names) == 0)
    {
      status = ReadPointNames(this->Path, points, this->Names);
    }
    if (!status.IsOk())
    {
      return status;
    }
  }
  const Status status = WritePointNames(this->Path, points, this->Names);
  RemoveFile(GetPointNamesFile(this->GetPart()));
  return status;
}

//------------------------------------------------------------------------------
void LasNamesFile::CollectBlock(std::vector<FileBlock>& blocks) const
{
  std::error_code missing;
  const std::string path = GetPointNamesFile(this->Path);
  const std::uintmax_t size = std::filesystem::file_size(path, missing);
  if (!missing)
  {
    blocks.push_back(MakeFileBlock(path, 0, size));
  }
}

} // namespace helios
