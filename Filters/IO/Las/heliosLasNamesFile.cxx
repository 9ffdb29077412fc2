// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasNamesFile.h"

#include "heliosInputFile.h"
#include "heliosPartFile.h"
#include "vtkHeliosPointNames.h"

#include <vtkFieldData.h>

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace helios
{

namespace
{

Status ToStatus(const std::string& problem)
{
  return problem.empty() ? Status() : Status::Error(problem);
}

} // namespace

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
  const vtkIdType count = vtkHeliosPointNames::CountNames(fields);
  if (count <= this->Count)
  {
    return {};
  }
  this->Count = count;
  this->Names->DeepCopy(fields);
  const Status status = ToStatus(vtkHeliosPointNames::Check(this->Path));
  return status.IsOk() ? ToStatus(vtkHeliosPointNames::Write(this->GetPart(), 0, fields)) : status;
}

//------------------------------------------------------------------------------
Status LasNamesFile::Finish(vtkIdType points)
{
  const InputWatch ignore([](const std::string&, const std::string&) {});
  if (this->Count == 0 && this->IsResumed)
  {
    Status status = ToStatus(vtkHeliosPointNames::Read(this->GetPart(), 0, this->Names));
    if (status.IsOk() && vtkHeliosPointNames::CountNames(this->Names) == 0)
    {
      status = ToStatus(vtkHeliosPointNames::Read(this->Path, points, this->Names));
    }
    if (!status.IsOk())
    {
      return status;
    }
  }
  const Status status = ToStatus(vtkHeliosPointNames::Write(this->Path, points, this->Names));
  RemoveFile(vtkHeliosPointNames::GetFileName(this->GetPart()));
  return status;
}

//------------------------------------------------------------------------------
void LasNamesFile::CollectBlock(std::vector<FileBlock>& blocks) const
{
  std::error_code missing;
  const std::string path = vtkHeliosPointNames::GetFileName(this->Path);
  const std::uintmax_t size = std::filesystem::file_size(path, missing);
  if (!missing)
  {
    blocks.push_back(MakeFileBlock(path, 0, size));
  }
}

} // namespace helios
