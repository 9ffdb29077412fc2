// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's sliders in the place and colours of a panel.

#ifndef heliosSlider_h
#define heliosSlider_h

#include "heliosRect.h"

class vtkSliderRepresentation2D;

namespace helios::viewer
{

struct Theme;

/// Sets up a slider without labels: panels draw them.
void SetUpSlider(vtkSliderRepresentation2D* slider);

/// Places a slider along the middle of a rectangle [pixels].
void PlaceSlider(vtkSliderRepresentation2D* slider, const Rect& track, const Theme& theme);

} // namespace helios::viewer

#endif
