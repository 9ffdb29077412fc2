// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Mouse control of the camera.

#ifndef heliosInteractorStyles_h
#define heliosInteractorStyles_h

class vtkRenderWindowInteractor;

namespace helios::viewer
{

/// Makes the user rotate the camera about its focal point, or fly it. VTK's own keys are off: the
/// viewer's keys apply.
void UseStyle(vtkRenderWindowInteractor* interactor, bool flies);

} // namespace helios::viewer

#endif
