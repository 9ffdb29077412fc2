// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMeasureTool.h"

#include "heliosFormat.h"
#include "heliosHud.h"
#include "heliosViewer.h"

#include <json/json.h>

#include <cmath>

namespace helios::viewer
{

//------------------------------------------------------------------------------
std::string DescribeDistance(const Vec3& from, const Vec3& to)
{
  const Vec3 way = to - from;
  return Format("distance %.3f m, horizontal %.3f m, vertical %.3f m", way.Norm(),
    std::hypot(way[0], way[1]), way[2]);
}

//------------------------------------------------------------------------------
MeasureTool::MeasureTool(Viewer& viewer)
  : Owner(viewer)
  , Line(viewer.GetRenderer())
{
}

//------------------------------------------------------------------------------
std::vector<KeyHelp> MeasureTool::GetKeys() const
{
  return { { "D", "measure distances: on, off; then click two points", "D" } };
}

//------------------------------------------------------------------------------
bool MeasureTool::OnKey(const std::string& key, bool control)
{
  if (control || !(key == "D" || (this->IsOn && key == "Escape")))
  {
    return false;
  }
  this->SetOn(!this->IsOn);
  return true;
}

//------------------------------------------------------------------------------
void MeasureTool::SetOn(bool on)
{
  this->IsOn = on;
  this->Points.clear();
  this->Show();
}

//------------------------------------------------------------------------------
bool MeasureTool::OnClick(int x, int y)
{
  if (!this->IsOn)
  {
    return false;
  }
  const auto position = PickPosition(this->Owner, x, y);
  if (!position)
  {
    this->Owner.ShowMessage("no point is there; click on an echo or a surface");
    return true;
  }
  if (this->Points.size() == 2)
  {
    this->Points.clear();
  }
  this->Points.push_back(*position);
  this->Show();
  return true;
}

//------------------------------------------------------------------------------
void MeasureTool::Show()
{
  std::vector<Vec3> local;
  for (const Vec3& point : this->Points)
  {
    local.push_back(point - this->Owner.GetOrigin());
  }
  this->Line.SetPoints(local, this->Owner.GetHud().GetTheme().Mark);
  this->Owner.Redraw();
}

//------------------------------------------------------------------------------
void MeasureTool::OnNewSurvey()
{
  this->SetOn(false);
}

//------------------------------------------------------------------------------
std::string MeasureTool::GetStatus() const
{
  if (!this->IsOn)
  {
    return {};
  }
  return this->Points.size() == 2 ? DescribeDistance(this->Points[0], this->Points[1])
    : this->Points.empty()        ? "measure: click the first point"
                                  : "measure: click the second point";
}

//------------------------------------------------------------------------------
void MeasureTool::Describe(Json::Value& state) const
{
  Json::Value& value = state["measure"];
  value["on"] = this->IsOn;
  value["points"] = Json::Value(Json::arrayValue);
  for (const Vec3& point : this->Points)
  {
    Json::Value one(Json::arrayValue);
    for (int i = 0; i < 3; ++i)
    {
      one.append(point[i]);
    }
    value["points"].append(one);
  }
  value["distance"] = this->Points.size() == 2 ? (this->Points[1] - this->Points[0]).Norm() : 0.0;
}

} // namespace helios::viewer
