// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Eye-dome lighting: shades what lies behind its neighbours.

#ifndef heliosEyeDome_h
#define heliosEyeDome_h

#include <vtkSmartPointer.h>

class vtkRenderPass;

namespace helios::viewer
{

/**
 * Returns a pass for a renderer. Of the eight neighbours of a pixel at two distances, those that
 * are closer to the camera darken it, by the ratio of their depths, down to 0.45 of its colour at
 * most: VTK's shading (vtkEDLShading) makes points behind sparse ones black.
 */
vtkSmartPointer<vtkRenderPass> MakeEyeDomePass();

} // namespace helios::viewer

#endif
