// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMakePlatform.h"

#include "vtkHeliosLinearPathPlatform.h"

namespace helios
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosPlatform> MakePlatform(const SurveyData& survey, std::size_t leg)
{
  (void)survey;
  (void)leg;
  return vtkSmartPointer<vtkHeliosLinearPathPlatform>::New();
}

} // namespace helios
