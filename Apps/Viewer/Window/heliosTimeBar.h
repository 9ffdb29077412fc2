// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The bar at the bottom for reading and seeking the time.

#ifndef heliosTimeBar_h
#define heliosTimeBar_h

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>

#include <functional>

class vtkRenderWindowInteractor;

namespace helios::viewer
{

class TimeBar
{
public:
  /// Calls back with the sought time [s].
  TimeBar(vtkRenderWindowInteractor* interactor, std::function<void(double)> onSeek);
  ~TimeBar();

  void SetSpan(double start, double end);
  void SetTime(double time);
  void SetVisible(bool visible);
  bool IsVisible() const;

  /// Ends of the bar, as fractions of the window's width, and its height from below.
  static constexpr double Left = 0.04;
  static constexpr double Right = 0.96;
  static constexpr double Height = 0.035;

private:
  void Seek(bool isHeld);

  vtkNew<vtkSliderRepresentation2D> Bar;
  vtkNew<vtkSliderWidget> Widget;
  vtkNew<vtkCallbackCommand> Observer;
  std::function<void(double)> OnSeek;
  bool IsHeld = false; ///< by the user
};

} // namespace helios::viewer

#endif
