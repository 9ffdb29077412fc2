// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurveyFileSource.h"

#include "vtkHeliosSurveyReader.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtksys/SystemTools.hxx>

#include <numeric>

vtkStandardNewMacro(vtkHeliosSurveyFileSource);

namespace
{

void AddVertices(vtkPolyData* points)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(points->GetNumberOfPoints());
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(), vtkIdType(0));
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(1, ids);
  points->SetVerts(vertices);
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosSurveyFileSource::vtkHeliosSurveyFileSource() = default;

//------------------------------------------------------------------------------
vtkHeliosSurveyFileSource::~vtkHeliosSurveyFileSource() = default;

//------------------------------------------------------------------------------
void vtkHeliosSurveyFileSource::SetFileName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->FileName != text)
  {
    this->FileName = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkHeliosSurveyFileSource::GetFileName() const
{
  return this->FileName.c_str();
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyFileSource::AddAssetDirectory(const char* directory)
{
  if (directory && *directory)
  {
    this->AssetDirectories.emplace_back(directory);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyFileSource::RemoveAllAssetDirectories()
{
  this->AssetDirectories.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyFileSource::Reload()
{
  this->LastRead.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkHeliosSurveyFileSource::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!this->Read() || !this->Superclass::RequestData(request, inputs, outputs))
  {
    return 0;
  }
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    auto* points = vtkPolyData::GetData(outputs, port);
    if (points && points->GetNumberOfPoints() > 0)
    {
      AddVertices(points);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
/// Reads the survey unless that is done; false after an error.
bool vtkHeliosSurveyFileSource::Read()
{
  if (this->FileName.empty())
  {
    vtkErrorMacro("FileName is not set; give a survey, a HELIOS XML file");
    return false;
  }
  using System = vtksys::SystemTools;
  std::vector<std::string> names = this->AssetDirectories;
  names.push_back(System::GetFilenamePath(System::CollapseFullPath(this->FileName)));
  names.insert(names.end(), { ".", HELIOS_DATA, HELIOS_DATA "/Assets", this->FileName });
  if (names == this->LastRead)
  {
    return true;
  }
  vtkNew<vtkHeliosSurveyReader> reader;
  reader->SetFileName(names.back().c_str());
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
  {
    reader->AddAssetDirectory(names[i].c_str());
  }
  const bool isGood = reader->Read();
  this->SetSurvey(reader->GetSurvey());
  this->LastRead = isGood ? names : std::vector<std::string>();
  return isGood;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyFileSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  for (const std::string& directory : this->AssetDirectories)
  {
    os << indent << "AssetDirectory: " << directory << "\n";
  }
}
