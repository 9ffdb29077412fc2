// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The bar at the bottom for reading and seeking the time.

#ifndef heliosTimeBar_h
#define heliosTimeBar_h

#include "heliosRect.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>

#include <functional>

class vtkRenderWindowInteractor;

namespace helios::viewer
{

struct Theme;

class TimeBar
{
public:
  /// Calls back with the sought time [s].
  TimeBar(vtkRenderWindowInteractor* interactor, std::function<void(double)> onSeek);
  ~TimeBar();

  void SetSpan(double start, double end);
  void SetTime(double time);

  /// Places the bar in a rectangle [pixels]; an empty one hides it.
  void Place(const Rect& track, const Theme& theme);
  const Rect& GetTrack() const { return this->Track; }

private:
  void Seek(bool isHeld);

  vtkNew<vtkSliderRepresentation2D> Bar;
  vtkNew<vtkSliderWidget> Widget;
  vtkNew<vtkCallbackCommand> Observer;
  std::function<void(double)> OnSeek;
  Rect Track;
  bool IsHeld = false; ///< by the user
};

} // namespace helios::viewer

#endif
