// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanTool.h"

#include "heliosFlightView.h"
#include "heliosPlanView.h"
#include "heliosViewer.h"

#include <json/json.h>

namespace helios::viewer
{

//------------------------------------------------------------------------------
PlanTool::PlanTool(Viewer& viewer)
  : Owner(viewer)
{
  this->OnNewInputs();
}

//------------------------------------------------------------------------------
PlanTool::~PlanTool() = default;

//------------------------------------------------------------------------------
std::vector<KeyHelp> PlanTool::GetKeys() const
{
  return this->IsWanted ? std::vector<KeyHelp>{ { "j", "the plan and its coverage", "j" } }
                        : std::vector<KeyHelp>();
}

//------------------------------------------------------------------------------
bool PlanTool::OnKey(const std::string& key, bool control)
{
  if (key != "j" || control || !this->View)
  {
    return false;
  }
  this->View->SetVisible(!this->View->IsVisible());
  this->Owner.Redraw();
  return true;
}

//------------------------------------------------------------------------------
bool PlanTool::OnFrame()
{
  const Vec3 origin = this->Owner.GetOrigin();
  if (!this->IsWanted || (this->View && origin == this->Origin))
  {
    this->View ? this->View->Update() : void();
    return false;
  }
  this->Origin = origin;
  this->View.reset();
  vtkRenderer* renderer = this->Owner.GetRenderer();
  if (this->Files.Lines)
  {
    this->View = std::make_unique<FlightView>(renderer, this->Files, origin);
  }
  else
  {
    this->View = std::make_unique<PlanView>(renderer, this->Files, origin);
  }
  return true;
}

//------------------------------------------------------------------------------
void PlanTool::OnNewInputs()
{
  const auto& inputs = this->Owner.GetOptions().Inputs;
  this->View.reset();
  this->Files = Plan();
  this->IsWanted =
    inputs.size() == 1 && IsPlan(inputs.front()) && ReadPlan(inputs.front(), this->Files).IsOk();
}

//------------------------------------------------------------------------------
void PlanTool::OnNewSurvey()
{
  this->View.reset();
  this->IsWanted = false;
}

//------------------------------------------------------------------------------
std::string PlanTool::GetStatus() const
{
  return this->View && this->View->IsVisible() ? this->View->Describe() : "";
}

//------------------------------------------------------------------------------
Legend PlanTool::GetLegend() const
{
  return this->View && this->View->IsVisible() ? this->View->MakeLegend() : Legend();
}

//------------------------------------------------------------------------------
void PlanTool::Describe(Json::Value& state) const
{
  if (this->View)
  {
    Json::Value& value = state["plan"];
    this->View->Describe(value);
    value["visible"] = this->View->IsVisible();
  }
}

} // namespace helios::viewer
