// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosVersion.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkHeliosVersion);

//------------------------------------------------------------------------------
const char* vtkHeliosVersion::GetVersion()
{
  return VTKHELIOS_VERSION;
}
