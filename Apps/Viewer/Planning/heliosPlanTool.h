// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Plans written by vtkhelios plan, over their scenes.

#ifndef heliosPlanTool_h
#define heliosPlanTool_h

#include "heliosPlanFiles.h"
#include "heliosPlanLayer.h"
#include "heliosPose.h"
#include "heliosViewerTool.h"

#include <memory>
#include <string>
#include <vector>

namespace helios::viewer
{

class Viewer;

/// Shows the plan of scan positions or flight lines from a viewer's inputs, over its scene.
class PlanTool : public ViewerTool
{
public:
  explicit PlanTool(Viewer& viewer);
  ~PlanTool() override;

  std::string GetName() const override { return "Plan"; }
  std::vector<KeyHelp> GetKeys() const override;
  bool OnKey(const std::string& key, bool control) override;
  bool OnClick(int, int) override { return false; }
  bool OnFrame() override;
  void OnNewInputs() override;
  void OnNewSurvey() override;
  std::string GetStatus() const override;
  Legend GetLegend() const override;
  void Describe(Json::Value& state) const override;

private:
  Viewer& Owner;
  bool IsWanted = false; // the inputs include a plan
  Vec3 Origin{ 0.0, 0.0, 0.0 };
  Plan Files;
  std::unique_ptr<PlanLayer> View; // null: nothing is shown yet
};

} // namespace helios::viewer

#endif
