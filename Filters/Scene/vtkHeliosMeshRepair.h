// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMeshRepair
 * @brief   takes out what no mesh should hold
 */

#ifndef vtkHeliosMeshRepair_h
#define vtkHeliosMeshRepair_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkHeliosFiltersSceneModule.h" // For export macro

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosMeshRepair : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosMeshRepair* New();
  vtkTypeMacro(vtkHeliosMeshRepair, vtkPolyDataAlgorithm);

protected:
  vtkHeliosMeshRepair() = default;
  ~vtkHeliosMeshRepair() override = default;

private:
  vtkHeliosMeshRepair(const vtkHeliosMeshRepair&) = delete;
  void operator=(const vtkHeliosMeshRepair&) = delete;
};

#endif
