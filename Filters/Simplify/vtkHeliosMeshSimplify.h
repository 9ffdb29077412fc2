// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMeshSimplify
 * @brief   fewer triangles within a guaranteed distance
 */

#ifndef vtkHeliosMeshSimplify_h
#define vtkHeliosMeshSimplify_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkHeliosFiltersSimplifyModule.h" // For export macro

class VTKHELIOSFILTERSSIMPLIFY_EXPORT vtkHeliosMeshSimplify : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosMeshSimplify* New();
  vtkTypeMacro(vtkHeliosMeshSimplify, vtkPolyDataAlgorithm);

protected:
  vtkHeliosMeshSimplify() = default;
  ~vtkHeliosMeshSimplify() override = default;

private:
  vtkHeliosMeshSimplify(const vtkHeliosMeshSimplify&) = delete;
  void operator=(const vtkHeliosMeshSimplify&) = delete;
};

#endif
