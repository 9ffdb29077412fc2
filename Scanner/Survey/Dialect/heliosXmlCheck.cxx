// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlCheck.h"

#include "heliosCoordinateSystem.h"
#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlScanner.h"
#include "heliosXmlScene.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRayCasterFactory.h"

#include <algorithm>

namespace helios
{

namespace
{

void CheckCrs(const std::string& text, const char* name, const std::string& where, Messages& log)
{
  CoordinateSystem crs;
  const Status status = text.empty() ? Status() : crs.Set(text);
  if (!status.IsOk())
  {
    log.Error(where + ": " + name + "=\"" + text + "\" " + status.Message());
  }
}

void CheckPartCrs(const PartData& part, Messages& log)
{
  for (const CrsData& crs : part.Crs)
  {
    CheckCrs(crs.Source, "source", crs.Where, log);
    CheckCrs(crs.Target, "target", crs.Where, log);
  }
}

void CheckSceneCrs(const SceneData& scene, Messages& log)
{
  CheckCrs(scene.Crs, "crs", scene.Where, log);
  for (const PartData& part : scene.Parts)
  {
    CheckPartCrs(part, log);
    for (const SwapData& swap : part.Swaps)
    {
      CheckPartCrs(swap.Part, log);
    }
  }
}

void CheckRayCaster(const std::string& name, const std::string& where, Messages& log)
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkHeliosRayCasterFactory::GetNumberOfBackends(); ++i)
  {
    names.emplace_back(vtkHeliosRayCasterFactory::GetBackendName(i));
  }
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
  {
    log.Error(where + ": rayCaster=\"" + name + "\" is not in this build; give one of " +
      JoinChoices(names));
  }
}

void CheckScannerElement(const XmlElement& element, const Assets& assets, Messages& log)
{
  const int before = log.GetNumberOfErrors();
  const ScannerData scanner = ReadScanner(element, assets);
  if (log.GetNumberOfErrors() == before)
  {
    CheckScanner(scanner, log);
  }
}

} // namespace

//------------------------------------------------------------------------------
void CheckSurveyNames(const SurveyData& survey, const std::string& where, Messages& log)
{
  CheckRayCaster(survey.RayCaster, where, log);
  CheckSceneCrs(survey.Scene, log);
  for (const LegData& leg : survey.Legs)
  {
    CheckCrs(leg.Crs, "crs", leg.Where, log);
    CheckCrs(leg.Trajectory.Crs, "trajectoryCrs", leg.Where, log);
  }
}

//------------------------------------------------------------------------------
void CheckAssets(const XmlElement& root, Assets& assets, Messages& log)
{
  const std::vector<XmlElement> scanners = root.GetChildren("scanner");
  const std::vector<XmlElement> platforms = root.GetChildren("platform");
  const std::vector<XmlElement> scenes = root.GetChildren("scene");
  for (const XmlElement& scanner : scanners)
  {
    CheckScannerElement(scanner, assets, log);
  }
  for (const XmlElement& platform : platforms)
  {
    ReadPlatform(platform);
  }
  for (const XmlElement& scene : scenes)
  {
    CheckSceneCrs(ReadScene(scene, assets), log);
  }
  const bool holdsNothing = scanners.empty() && platforms.empty() && scenes.empty() &&
    !root.GetChild("survey") && !root.GetChild("surveyPlanner") &&
    !root.GetChild("platformSettings") && !root.GetChild("scannerSettings") &&
    !root.GetChild("FWFSettings");
  if (holdsNothing)
  {
    log.Error(
      root.Where() + ": <document> is empty; add a <survey>, <scene>, <scanner> or <platform>");
  }
}

} // namespace helios
