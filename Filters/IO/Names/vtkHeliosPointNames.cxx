// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointNames.h"

#include "heliosPointNames.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkHeliosPointNames);

//------------------------------------------------------------------------------
std::string vtkHeliosPointNames::GetFileName(const std::string& pointFile)
{
  return helios::GetPointNamesFile(pointFile);
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosPointNames::CountNames(vtkFieldData* fields)
{
  return helios::CountPointNames(fields);
}

//------------------------------------------------------------------------------
bool vtkHeliosPointNames::Read(const std::string& pointFile, vtkIdType points, vtkFieldData* fields)
{
  const helios::Status status = helios::ReadPointNames(pointFile, points, fields);
  this->Message = status.Message();
  return status.IsOk();
}

//------------------------------------------------------------------------------
bool vtkHeliosPointNames::Check(const std::string& pointFile)
{
  const helios::Status status = helios::CheckPointNames(pointFile);
  this->Message = status.Message();
  return status.IsOk();
}

//------------------------------------------------------------------------------
bool vtkHeliosPointNames::Write(
  const std::string& pointFile, vtkIdType points, vtkFieldData* fields)
{
  const helios::Status status = helios::WritePointNames(pointFile, points, fields);
  this->Message = status.Message();
  return status.IsOk();
}

//------------------------------------------------------------------------------
std::string vtkHeliosPointNames::GetMessage() const
{
  return this->Message;
}
