// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A vertical section: only what lies in a slab is drawn.

#ifndef heliosSectionTool_h
#define heliosSectionTool_h

#include "heliosMeasurementLine.h"
#include "heliosSlab.h"
#include "heliosViewerTool.h"

#include <optional>
#include <string>
#include <vector>

namespace helios::viewer
{

class Viewer;

/**
 * While it is on, two clicks set the line of a vertical slab; the camera then views it at right
 * angles, in parallel projection.
 */
class SectionTool : public ViewerTool
{
public:
  explicit SectionTool(Viewer& viewer);

  std::string GetName() const override { return "Section"; }
  std::vector<KeyHelp> GetKeys() const override;
  bool OnKey(const std::string& key, bool control) override;
  bool IsActive() const override { return this->IsOn; }
  bool OnClick(int x, int y) override;
  void OnNewSurvey() override;
  std::string GetStatus() const override;
  void Describe(Json::Value& state) const override;

private:
  void SetOn(bool on);
  void SetThickness(double thickness);
  void Apply();
  void ViewAcross();

  Viewer& Owner;
  MeasurementLine Line;
  std::vector<Vec3> Ends; ///< world [m]
  std::optional<Slab> Shown;
  double Thickness = 0.0; ///< [m]
  bool IsOn = false;
};

/// Returns the vertical slab along a line; none if its ends are above each other.
std::optional<Slab> MakeSlab(const Vec3& from, const Vec3& to, double thickness);

} // namespace helios::viewer

#endif
