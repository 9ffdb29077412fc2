// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosMeshSimplify.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkHeliosMeshSimplify);
