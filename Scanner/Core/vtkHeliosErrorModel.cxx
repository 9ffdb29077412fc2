// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosErrorModel.h"

//------------------------------------------------------------------------------
double vtkHeliosErrorModel::GetRangeError(double) const
{
  return 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosErrorModel::GetDeflectionError(double) const
{
  return 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosErrorModel::GetHeadError(double) const
{
  return 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosErrorModel::GetRangeNoiseFactor(double) const
{
  return 1.0;
}

//------------------------------------------------------------------------------
void vtkHeliosErrorModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
