// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How the mouse moves the camera.

#ifndef heliosInteractorStyles_h
#define heliosInteractorStyles_h

class vtkRenderWindowInteractor;

namespace helios
{

/// The user turns the camera about what it looks at, or flies it. VTK's own keys are off: those of
/// the viewer count.
void UseStyle(vtkRenderWindowInteractor* interactor, bool flies);

} // namespace helios

#endif
