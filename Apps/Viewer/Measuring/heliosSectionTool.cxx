// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSectionTool.h"

#include "heliosCloudView.h"
#include "heliosHud.h"
#include "heliosSceneView.h"
#include "heliosTicks.h"
#include "heliosViewer.h"

#include <json/json.h>

#include <algorithm>
#include <cmath>

namespace helios::viewer
{

namespace
{

constexpr double ThicknessShare = 0.04; // share of the length of the section
constexpr double ThicknessStep = 1.5;

} // namespace

//------------------------------------------------------------------------------
std::optional<Slab> MakeSlab(const Vec3& from, const Vec3& to, double thickness)
{
  const Vec3 way = to - from;
  const double length = std::hypot(way[0], way[1]);
  if (!(length > 0.0))
  {
    return std::nullopt;
  }
  Slab slab;
  slab.Normal = Vec3(-way[1] / length, way[0] / length, 0.0); // to the left of the line
  const double middle = slab.Normal.Dot(from);
  slab.Low = middle - 0.5 * thickness;
  slab.High = middle + 0.5 * thickness;
  return slab;
}

//------------------------------------------------------------------------------
SectionTool::SectionTool(Viewer& viewer)
  : Owner(viewer)
  , Line(viewer.GetRenderer())
{
}

//------------------------------------------------------------------------------
std::vector<KeyHelp> SectionTool::GetKeys() const
{
  return { { "S", "section: on, off; then click its two ends", "S" },
    { ">", "thicker section", "greater" }, { "<", "thinner section", "less" } };
}

//------------------------------------------------------------------------------
bool SectionTool::OnKey(const std::string& key, bool control)
{
  if (control)
  {
    return false;
  }
  if (key == "S" || (this->IsOn && key == "Escape"))
  {
    this->SetOn(!this->IsOn);
    return true;
  }
  if (this->Shown && (key == "greater" || key == "less"))
  {
    this->SetThickness(this->Thickness * (key == "greater" ? ThicknessStep : 1.0 / ThicknessStep));
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
void SectionTool::SetOn(bool on)
{
  this->IsOn = on;
  this->Ends.clear();
  this->Shown.reset();
  this->Apply();
}

//------------------------------------------------------------------------------
void SectionTool::SetThickness(double thickness)
{
  this->Thickness = thickness;
  this->Shown = MakeSlab(this->Ends[0], this->Ends[1], thickness);
  this->Apply();
}

//------------------------------------------------------------------------------
void SectionTool::Apply()
{
  this->Owner.GetCloudView().SetSection(this->Shown);
  SceneView* scene = this->Owner.GetSceneView();
  scene ? scene->SetSection(this->Shown) : void();
  std::vector<Vec3> local;
  for (std::size_t i = 0; i < this->Ends.size() && !this->Shown; ++i)
  {
    local.push_back(this->Ends[i] - this->Owner.GetOrigin());
  }
  this->Line.SetPoints(local, this->Owner.GetHud().GetTheme().Mark);
  this->Owner.Redraw();
}

//------------------------------------------------------------------------------
bool SectionTool::OnClick(int x, int y)
{
  if (!this->IsOn || this->Shown)
  {
    return false;
  }
  const auto position = PickPosition(this->Owner, x, y);
  if (!position)
  {
    this->Owner.ShowMessage("no point is there; click on an echo or a surface");
    return true;
  }
  this->Ends.push_back(*position);
  if (this->Ends.size() < 2)
  {
    this->Apply();
    return true;
  }
  const Vec3 way = this->Ends[1] - this->Ends[0];
  const double length = std::hypot(way[0], way[1]);
  if (!(length > 0.0))
  {
    this->Ends.pop_back();
    this->Owner.ShowMessage("the ends of a section must differ; click another point");
    return true;
  }
  this->SetThickness(RoundDown(ThicknessShare * length));
  this->ViewAcross();
  return true;
}

//------------------------------------------------------------------------------
/// Views at right angles to the section, the first end at the left.
void SectionTool::ViewAcross()
{
  const Vec3 center = 0.5 * (this->Ends[0] + this->Ends[1]) - this->Owner.GetOrigin();
  const Vec3 way = this->Ends[1] - this->Ends[0];
  this->Owner.SetCameraMode(CameraMode::Free);
  this->Owner.GetCamera().SetSideView(
    center, this->Shown->Normal, 0.55 * std::hypot(way[0], way[1]));
}

//------------------------------------------------------------------------------
void SectionTool::OnNewSurvey()
{
  this->SetOn(false);
}

//------------------------------------------------------------------------------
std::string SectionTool::GetStatus() const
{
  if (!this->IsOn)
  {
    return {};
  }
  return this->Shown     ? "section, " + DescribeValue(this->Thickness, "m") + " thick"
    : this->Ends.empty() ? "section: click its first end"
                         : "section: click its second end";
}

//------------------------------------------------------------------------------
void SectionTool::Describe(Json::Value& state) const
{
  Json::Value& value = state["section"];
  value["on"] = this->IsOn;
  value["shown"] = this->Shown.has_value();
  value["thickness"] = this->Shown ? this->Thickness : 0.0;
}

} // namespace helios::viewer
