// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Light in which walls of every direction can be told apart.

#ifndef heliosLights_h
#define heliosLights_h

class vtkProperty;
class vtkRenderer;

namespace helios::viewer
{

/// Lights a scene by the camera, from the south-west and from the north-east, all from above. A
/// level surface seen from above has its own colour.
void AddLights(vtkRenderer* renderer);

/// Sets a surface to be lit by them.
void SetUpSurface(vtkProperty* surface);

} // namespace helios::viewer

#endif
