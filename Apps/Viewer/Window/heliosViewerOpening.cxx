// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Opens other inputs, and asks for names of files.
#include "heliosViewer.h"

#include "heliosCloudView.h"
#include "heliosHud.h"
#include "heliosPlatformView.h"
#include "heliosSceneMover.h"
#include "heliosSceneView.h"
#include "heliosStatus.h"
#include "heliosViewerInputs.h"
#include "heliosViewerTool.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace helios::viewer
{

//------------------------------------------------------------------------------
Status Viewer::OpenInput(const std::string& path)
{
  const std::vector<std::string> before = this->Options.Inputs;
  const double start = this->Options.StartTime;
  this->Options.Inputs = { path };
  this->Options.StartTime = -1.0;
  const std::string kind = FindInputKind(path);
  if (kind == "points" || kind == "run") // the cloud is read where the last one was
  {
    this->Running.reset();
    this->Mover.reset();
    this->Mesh.reset();
    this->Platform.reset();
    this->PointsView->SetEyeDomeLighting(this->Options.EyeDome);
  }
  vtkSmartPointer<vtkHeliosSurvey> survey = this->Survey;
  this->Survey = nullptr;
  const Status status = ShowInputs(*this);
  if (!status.IsOk())
  {
    this->Options.Inputs = before;
    this->Options.StartTime = start;
    this->Survey = survey;
    this->PointsView->Update();
    this->Redraw();
    return status;
  }
  this->MessageUntil = 0.0;
  for (const auto& tool : this->Tools)
  {
    tool->OnNewInputs();
  }
  this->UpdateMenus();
  this->Window->SetWindowName((fs::path(path).filename().string() + " - vtkHelios").c_str());
  return status;
}

//------------------------------------------------------------------------------
void Viewer::OpenInputDialog()
{
  std::error_code error;
  const fs::path shown = this->Options.Inputs.empty() ? "" : this->Options.Inputs.front();
  this->Words->GetDialog().Open(fs::absolute(shown, error).string(), FindInputKind,
    [this](const std::string& path) { return this->OpenInput(path); });
  this->Redraw();
}

//------------------------------------------------------------------------------
void Viewer::OpenSurveyDialog()
{
  std::error_code error;
  this->Words->GetDialog().SaveAs(
    fs::absolute(this->Options.Save, error).string(),
    [](const std::string& path)
    {
      const std::string kind = FindInputKind(path);
      return kind == "survey" ? kind : "";
    },
    [this](const std::string& path)
    {
      this->Options.Save = fs::path(path).has_extension() ? path : path + ".xml";
      for (const auto& tool : this->Tools)
      {
        if (const Status status = tool->Save(); !status.IsOk())
        {
          return status;
        }
      }
      return Status();
    });
  this->Redraw();
}

//------------------------------------------------------------------------------
void Viewer::OpenStillDialog()
{
  std::error_code error;
  this->Words->GetDialog().SaveAs(
    fs::absolute("vtkhelios.png", error).string(),
    [](const std::string& path) { return fs::path(path).extension() == ".png" ? "picture" : ""; },
    [this](const std::string& path)
    {
      this->Words->GetDialog().Close(); // not in the picture
      this->SaveStill(fs::path(path).has_extension() ? path : path + ".png");
      return Status();
    });
  this->Redraw();
}

} // namespace helios::viewer
