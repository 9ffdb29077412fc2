// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Clicked points, joined by lines, in front of everything.

#ifndef heliosMeasurementLine_h
#define heliosMeasurementLine_h

#include "heliosColorMaps.h"
#include "heliosPose.h"

#include <vtkNew.h>

#include <optional>
#include <vector>

class vtkActor2D;
class vtkPolyData;
class vtkRenderer;

namespace helios::viewer
{

class Viewer;

class MeasurementLine
{
public:
  /// Draws with a renderer, which must outlive the line.
  explicit MeasurementLine(vtkRenderer* renderer);
  ~MeasurementLine();
  MeasurementLine(const MeasurementLine&) = delete;
  void operator=(const MeasurementLine&) = delete;

  /// Sets points in renderer coordinates [m]; none: nothing is drawn.
  void SetPoints(const std::vector<Vec3>& points, const Rgb& color);

private:
  vtkRenderer* Renderer;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkActor2D> Actor;
};

/// Returns the point of the cloud or of the scene at a window pixel, in world coordinates [m].
std::optional<Vec3> PickPosition(Viewer& viewer, int x, int y);

} // namespace helios::viewer

#endif
