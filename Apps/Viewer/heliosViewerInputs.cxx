// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosViewerInputs.h"

#include "heliosCloudReader.h"
#include "heliosEditTool.h"
#include "heliosErrorText.h"
#include "heliosInspector.h"
#include "heliosMeasureTool.h"
#include "heliosPlanFiles.h"
#include "heliosPlanTool.h"
#include "heliosSectionTool.h"
#include "heliosSimulation.h"
#include "heliosStatus.h"
#include "heliosViewer.h"
#include "heliosViewerTool.h"
#include "vtkHeliosDialect.h"
#include "vtkHeliosPlannerReader.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveyReader.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace helios::viewer
{

namespace
{

// Default scanner for a scene without one; required by the reader.
const char* const DefaultPlatform = "platforms.xml#tripod";
const char* const DefaultScanner = "scanners.xml#vz400_class_tls";

/// Sets an XML file and its search folders.
template <typename Reader>
void SetInput(Reader* reader, const std::string& fileName, const std::vector<std::string>& assets)
{
  reader->SetFileName(fileName.c_str());
  for (const std::string& folder : assets)
  {
    reader->AddAssetDirectory(folder.c_str());
  }
}

Status ShowSurveyFile(Viewer& viewer, const std::string& fileName)
{
  vtkNew<vtkHeliosSurveyReader> reader;
  ErrorText errors(reader);
  SetInput(reader.Get(), fileName, viewer.GetOptions().Assets);
  if (!reader->Read())
  {
    return Status::Error(errors.Get(fileName + ": cannot be read"));
  }
  viewer.ShowSurvey(reader->GetSurvey());
  return {};
}

/// Shows the scene of a file, and the marks that PlanTool draws above it.
Status ShowSceneFile(Viewer& viewer, const std::string& fileName, vtkPolyData* above = nullptr)
{
  vtkNew<vtkHeliosPlannerReader> reader;
  ErrorText errors(reader);
  SetInput(reader.Get(), fileName, viewer.GetOptions().Assets);
  reader->SetPlatform(DefaultPlatform); // any file: only its scene is shown
  reader->SetScanner(DefaultScanner);
  reader->UseMovingPartsOn();
  reader->KeepGridsOn();
  reader->InstancesOn();
  reader->Update();
  vtkPolyData* scene = reader->GetOutput();
  if (scene->GetNumberOfPolys() == 0 && !vtkHeliosScene::HasInstances(scene))
  {
    return Status::Error(
      errors.Get(fileName + ": has nothing to show; give a scene with triangles"));
  }
  std::vector<vtkSmartPointer<vtkImageData>> grids;
  for (int i = 0; reader->GetGrid(i); ++i)
  {
    grids.emplace_back(reader->GetGrid(i));
  }
  viewer.ShowScene(scene, grids, above);
  return {};
}

/// Returns whether a JSON file says at its begin that it is CityJSON.
bool IsCityJson(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string begin(1024, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin.find("\"CityJSON\"") != std::string::npos;
}

/// Shows the scene of the planned survey; PlanTool shows the rest.
Status ShowPlan(Viewer& viewer, const std::string& path)
{
  Plan plan;
  const Status status = ReadPlan(path, plan);
  if (!status.IsOk())
  {
    return status;
  }
  return plan.Survey.empty()
    ? Status::Error(path + ": has no survey.xml, which names the scene; plan again")
    : ShowSceneFile(viewer, plan.Survey, plan.Lines);
}

/// Returns the trajectories in the files of a run, as legs of a replay.
std::vector<SimulatedLeg> MakeLegs(
  const std::vector<vtkSmartPointer<vtkPolyData>>& trajectories, double end)
{
  std::vector<SimulatedLeg> legs;
  for (vtkPolyData* trajectory : trajectories)
  {
    SimulatedLeg leg;
    leg.Leg = static_cast<int>(legs.size());
    if (!leg.SetTrajectory(trajectory))
    {
      continue;
    }
    leg.StartTime = leg.Path.GetStartTime();
    leg.EndTime = leg.Path.GetEndTime();
    leg.IsMoving = !leg.Path.IsStatic();
    leg.Type = leg.IsMoving ? PlatformType::LinearPath : PlatformType::Static;
    leg.Kind = leg.IsMoving ? PlatformKind::Unknown : PlatformKind::Tripod;
    legs.push_back(leg);
  }
  std::stable_sort(legs.begin(), legs.end(),
    [](const SimulatedLeg& a, const SimulatedLeg& b) { return a.StartTime < b.StartTime; });
  for (std::size_t i = 0; i < legs.size(); ++i) // a scan position lasts until the next
  {
    const double next = i + 1 < legs.size() ? legs[i + 1].StartTime : end;
    legs[i].EndTime = legs[i].IsMoving ? legs[i].EndTime : std::max(next, legs[i].EndTime);
  }
  return legs;
}

/// Shows finished runs and clouds, all together.
Status ShowClouds(Viewer& viewer, const std::vector<std::string>& inputs)
{
  CloudReader reader;
  viewer.GetCloud().Clear();
  for (const std::string& input : inputs)
  {
    const Status status = reader.Read(input, viewer.GetCloud());
    if (!status.IsOk())
    {
      return status;
    }
  }
  double times[2] = { 0.0, 0.0 };
  viewer.GetCloud().GetTimeRange(times);
  viewer.ShowCloud(MakeLegs(reader.Trajectories, times[1]));
  return {};
}

} // namespace

//------------------------------------------------------------------------------
Status ShowInputs(Viewer& viewer)
{
  const std::vector<std::string>& inputs = viewer.GetOptions().Inputs;
  for (const std::string& input : inputs)
  {
    std::error_code error;
    if (!fs::exists(input, error))
    {
      return Status::Error(input + ": no such file; check the name");
    }
  }
  if (inputs.size() == 1 && IsPlan(inputs.front()))
  {
    return ShowPlan(viewer, inputs.front());
  }
  const bool isDocument = vtkHeliosDialect::IsDocument(inputs.front());
  const bool isScene = isDocument || vtkHeliosDialect::IsMesh(inputs.front());
  if (isScene && inputs.size() > 1)
  {
    return Status::Error(
      inputs.front() + ": a survey or a scene is shown by itself; leave out " + inputs[1]);
  }
  if (isDocument && vtkHeliosDialect::MayHaveSurvey(inputs.front()))
  {
    return ShowSurveyFile(viewer, inputs.front());
  }
  return isScene ? ShowSceneFile(viewer, inputs.front()) : ShowClouds(viewer, inputs);
}

//------------------------------------------------------------------------------
std::string FindInputKind(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    return IsPlan(path) ? "plan" : CloudReader::IsRun(path) ? "run" : "";
  }
  if (vtkHeliosDialect::IsDocument(path))
  {
    return vtkHeliosDialect::MayHaveSurvey(path) ? "survey" : "scene";
  }
  if (fs::path(path).extension() == ".json")
  {
    return IsCityJson(path) ? "scene" : "";
  }
  return vtkHeliosDialect::IsMesh(path) ? "scene" : CloudReader::CanRead(path) ? "points" : "";
}

//------------------------------------------------------------------------------
std::vector<std::unique_ptr<ViewerTool>> MakeTools(Viewer& viewer)
{
  std::vector<std::unique_ptr<ViewerTool>> tools;
  tools.push_back(std::make_unique<EditTool>(viewer));    // first: takes clicks while it is on
  tools.push_back(std::make_unique<MeasureTool>(viewer)); // these two also, before the inspector
  tools.push_back(std::make_unique<SectionTool>(viewer));
  tools.push_back(std::make_unique<Inspector>(viewer));
  tools.push_back(std::make_unique<PlanTool>(viewer));
  return tools;
}

} // namespace helios::viewer
