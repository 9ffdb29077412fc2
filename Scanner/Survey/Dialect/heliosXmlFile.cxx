// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlFile.h"

#include "heliosMessages.h"
#include "heliosXmlCheck.h"
#include "heliosXmlLeg.h"
#include "heliosXmlPlanner.h"
#include "heliosXmlRules.h"
#include "heliosXmlSurvey.h"

#include <filesystem>

namespace helios
{

//------------------------------------------------------------------------------
void CheckFile(
  const std::string& fileName, const std::vector<std::string>& assetDirectories, Messages& log)
{
  Assets assets(log, assetDirectories);
  const XmlDocument* document = assets.Load(fileName);
  if (!document)
  {
    return;
  }
  const XmlElement root = document->GetRoot();
  for (const XmlElement& survey : root.GetChildren("survey"))
  {
    SurveyData data;
    ReadSurvey(survey, assets, log, data);
    CheckSurveyNames(data, survey.Where(), log);
  }
  for (const XmlElement& planner : root.GetChildren("surveyPlanner"))
  {
    CheckPlanner(planner, assets, log);
  }
  CheckTemplates(root, assets);
  CheckAssets(root, assets, log);
}

//------------------------------------------------------------------------------
bool IsDocument(const std::string& fileName)
{
  const std::string ending = std::filesystem::path(fileName).extension().string();
  return ToLower(ending) == ".xml" || IsYaml(fileName);
}

//------------------------------------------------------------------------------
bool MayHaveSurvey(const std::string& fileName)
{
  Messages silent(nullptr);
  const auto document = XmlDocument::Load(fileName, silent);
  return !document || document->GetRoot().GetChild("survey");
}

} // namespace helios
