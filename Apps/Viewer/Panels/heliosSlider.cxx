// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSlider.h"

#include "heliosTheme.h"

#include <vtkCoordinate.h>
#include <vtkProperty2D.h>
#include <vtkSliderRepresentation2D.h>

namespace helios::viewer
{

//------------------------------------------------------------------------------
void SetUpSlider(vtkSliderRepresentation2D* slider)
{
  slider->GetPoint1Coordinate()->SetCoordinateSystemToDisplay();
  slider->GetPoint2Coordinate()->SetCoordinateSystemToDisplay();
  slider->SetTubeWidth(0.005);
  slider->SetSliderLength(0.012);
  slider->SetSliderWidth(0.02);
  slider->SetEndCapLength(0.0);
  slider->ShowSliderLabelOff();
}

//------------------------------------------------------------------------------
void PlaceSlider(vtkSliderRepresentation2D* slider, const Rect& track, const Theme& theme)
{
  const double y = track.Y + 0.5 * track.Height;
  slider->GetPoint1Coordinate()->SetValue(track.X, y);
  slider->GetPoint2Coordinate()->SetValue(track.Right(), y);
  slider->GetTubeProperty()->SetColor(Shade(theme.Groove).Rgb);
  slider->GetSliderProperty()->SetColor(Shade(theme.Handle).Rgb);
  slider->GetSelectedProperty()->SetColor(Shade(theme.HeldHandle).Rgb);
}

} // namespace helios::viewer
