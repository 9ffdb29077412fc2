// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The platform with its scanner, its way, and the fan of beams that have just been measured.

#ifndef heliosPlatformView_h
#define heliosPlatformView_h

#include "heliosPose.h"
#include "heliosSimulation.h"

#include <vtkNew.h>
#include <vtkType.h>

#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace helios
{

enum class PlatformType;

class PlatformView
{
public:
  /// Everything is drawn less an origin [m].
  PlatformView(vtkRenderer* renderer, const Vec3& origin);
  ~PlatformView();

  /// The ways of all legs, as lines; positions of tripods, as points.
  void SetWays(const std::vector<SimulatedLeg>& legs);

  /// Platform, scanner and ways.
  void SetVisible(bool visible);

  /// Platform and scanner, which are in the way of an eye in the scanner's place.
  void SetModelVisible(bool visible);

  void SetFanVisible(bool visible);
  bool IsFanVisible() const;

  /// Puts the platform where it is now [m], and makes it no smaller than it can be seen.
  void Place(PlatformType type, const Pose& platform, const Pose& mount);

  /// The beams that end at these points, from the scanner [m].
  void SetFan(const Vec3& scanner, const std::vector<Vec3>& ends);

  vtkIdType GetNumberOfBeams() const;

private:
  double FindScale(const Vec3& position, double size) const;

  vtkRenderer* Renderer;
  Vec3 Origin;
  PlatformType Type;
  bool HasModel = false;
  bool IsVisible = true;
  vtkNew<vtkActor> Body;
  vtkNew<vtkActor> Scanner;
  vtkNew<vtkActor> Ways;
  vtkNew<vtkActor> Stands;
  vtkNew<vtkActor> Fan;
  vtkNew<vtkPolyData> Beams;
};

} // namespace helios

#endif
