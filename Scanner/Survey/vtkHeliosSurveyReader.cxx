// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurveyReader.h"

#include "heliosMessages.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlFile.h"
#include "vtkHeliosSurvey.h"

#include <vtkObjectFactory.h>

#include <exception>

vtkStandardNewMacro(vtkHeliosSurveyReader);

//------------------------------------------------------------------------------
vtkHeliosSurveyReader::vtkHeliosSurveyReader() = default;

//------------------------------------------------------------------------------
vtkHeliosSurveyReader::~vtkHeliosSurveyReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyReader::AddAssetDirectory(const char* directory)
{
  if (directory && *directory)
  {
    this->AssetDirectories.emplace_back(directory);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyReader::RemoveAllAssetDirectories()
{
  this->AssetDirectories.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
template <typename TaskT>
bool vtkHeliosSurveyReader::Try(TaskT task)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the name of a survey XML file.");
    return false;
  }
  try
  {
    return task();
  }
  catch (const std::exception& error) // standard library errors: out of memory, file system
  {
    vtkErrorMacro(<< this->FileName << ": cannot be read: " << error.what());
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyReader::Read()
{
  vtkNew<vtkHeliosSurvey> survey;
  const bool isGood = this->Try(
    [this, &survey]
    {
      using helios::AssetNeed;
      auto document = std::make_unique<helios::SurveyDocument>(this);
      document->SetAssetDirectories(this->AssetDirectories);
      document->SetNeeds(this->SceneRequired ? AssetNeed::Required : AssetNeed::Replaced,
        this->TrajectoriesRequired ? AssetNeed::Required : AssetNeed::Replaced);
      return document->Load(this->FileName) && survey->ReadDocument(std::move(document), this);
    });
  this->Survey = isGood ? survey.Get() : nullptr;
  return isGood;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyReader::Check()
{
  return this->Try(
    [this]
    {
      helios::Messages log(this);
      helios::CheckFile(this->FileName, this->AssetDirectories, log);
      return !log.HasError();
    });
}

//------------------------------------------------------------------------------
vtkHeliosSurvey* vtkHeliosSurveyReader::GetSurvey() const
{
  return this->Survey;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "SceneRequired: " << this->SceneRequired << "\n"
     << indent << "TrajectoriesRequired: " << this->TrajectoriesRequired << "\n";
  for (const std::string& directory : this->AssetDirectories)
  {
    os << indent << "AssetDirectory: " << directory << "\n";
  }
}
