// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInteractorStyles.h"

#include <vtkInteractorStyleFlight.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

namespace helios::viewer
{

namespace
{

/// A VTK style without its keys.
template <typename Style>
class Keyless : public Style
{
public:
  static Keyless* New() { return new Keyless; }
  void OnChar() override {}
  void OnKeyPress() override {}
};

template <typename Style>
void Use(vtkRenderWindowInteractor* interactor)
{
  vtkNew<Keyless<Style>> style;
  interactor->SetInteractorStyle(style);
}

} // namespace

//------------------------------------------------------------------------------
void UseStyle(vtkRenderWindowInteractor* interactor, bool flies)
{
  flies ? Use<vtkInteractorStyleFlight>(interactor)
        : Use<vtkInteractorStyleTrackballCamera>(interactor);
}

} // namespace helios::viewer
