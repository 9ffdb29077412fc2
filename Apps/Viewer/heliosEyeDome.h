// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Eye-dome lighting (Boucheny 2009): the more its neighbours are in front, the darker a pixel.

#ifndef heliosEyeDome_h
#define heliosEyeDome_h

#include <vtkSmartPointer.h>

class vtkRenderPass;

namespace helios
{

/// Shades what is solid; what is 2D is drawn over it as it is.
vtkSmartPointer<vtkRenderPass> MakeEyeDomePass();

} // namespace helios

#endif
