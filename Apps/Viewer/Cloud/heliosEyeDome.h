// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Eye-dome lighting (Boucheny 2009): pixels are darker the more their neighbours are in front.

#ifndef heliosEyeDome_h
#define heliosEyeDome_h

#include <vtkSmartPointer.h>

class vtkRenderPass;

namespace helios::viewer
{

/// Shades solid props; 2D props are drawn over it unchanged.
vtkSmartPointer<vtkRenderPass> MakeEyeDomePass();

} // namespace helios::viewer

#endif
