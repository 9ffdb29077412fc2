// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A plan drawn over its scene: coloured places, and numbers.

#ifndef heliosPlanLayer_h
#define heliosPlanLayer_h

#include "heliosColorMaps.h"
#include "heliosLegend.h"
#include "heliosPose.h"

#include <vtkSmartPointer.h>

#include <json/forwards.h>

#include <string>
#include <vector>

class vtkActor;
class vtkPoints;
class vtkProp;
class vtkRenderer;
class vtkTextActor;

namespace helios::viewer
{

/// Drawn relative to an origin [m].
class PlanLayer
{
public:
  PlanLayer(vtkRenderer* renderer, const Vec3& origin);
  virtual ~PlanLayer();
  PlanLayer(const PlanLayer&) = delete;
  void operator=(const PlanLayer&) = delete;

  void SetVisible(bool visible);
  bool IsVisible() const { return this->Visible; }

  /// Hides numbers behind the camera; call before every frame.
  void Update();

  /// Returns the coverage, as text.
  virtual std::string Describe() const = 0;

  /// Returns the meaning of the colours.
  virtual Legend MakeLegend() const = 0;

  /// Adds numbers to the state file.
  virtual void Describe(Json::Value& state) const = 0;

protected:
  Vec3 ToRenderer(const double place[3]) const { return Vec3(place) - this->Origin; }

  /// Adds points of a size [pixels], in their own colours or in one.
  void AddPoints(vtkPoints* points, const std::vector<Rgb>& colors, float size);
  void AddActor(vtkActor* actor);

  /// Adds a number over the picture, at a position in renderer coordinates.
  void AddLabel(const std::string& text, const Vec3& place);

private:
  vtkRenderer* Renderer;
  Vec3 Origin;
  bool Visible = true;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<vtkSmartPointer<vtkTextActor>> Labels;
};

} // namespace helios::viewer

#endif
