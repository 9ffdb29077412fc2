// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances between clicked points.

#ifndef heliosMeasureTool_h
#define heliosMeasureTool_h

#include "heliosMeasurementLine.h"
#include "heliosViewerTool.h"

#include <string>
#include <vector>

namespace helios::viewer
{

class Viewer;

/// While it is on, two clicks on echoes or surfaces measure; the next click starts anew.
class MeasureTool : public ViewerTool
{
public:
  explicit MeasureTool(Viewer& viewer);

  std::string GetName() const override { return "Measure"; }
  std::vector<KeyHelp> GetKeys() const override;
  bool OnKey(const std::string& key, bool control) override;
  bool IsActive() const override { return this->IsOn; }
  bool OnClick(int x, int y) override;
  void OnNewSurvey() override;
  std::string GetStatus() const override;
  void Describe(Json::Value& state) const override;

private:
  void SetOn(bool on);
  void Show();

  Viewer& Owner;
  MeasurementLine Line;
  std::vector<Vec3> Points; ///< world [m]
  bool IsOn = false;
};

/// Describes a distance: "distance 5.000 m, horizontal 3.000 m, vertical 4.000 m".
std::string DescribeDistance(const Vec3& from, const Vec3& to);

} // namespace helios::viewer

#endif
