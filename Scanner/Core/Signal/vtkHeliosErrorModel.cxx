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
bool vtkHeliosErrorModel::MoveRay(double[3], double[3]) const
{
  return false;
}

//------------------------------------------------------------------------------
double vtkHeliosErrorModel::GetRangeNoiseFactor(double) const
{
  return 1.0;
}

//------------------------------------------------------------------------------
std::string vtkHeliosErrorModel::GetTermName(int term) const
{
  static const char* const names[NUMBER_OF_TERMS] = { "GetRangeError()", "GetDeflectionError()",
    "GetHeadError()", "GetRangeNoiseFactor()" };
  return std::string(names[term]) + " of " + this->GetClassName();
}

//------------------------------------------------------------------------------
void vtkHeliosErrorModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
