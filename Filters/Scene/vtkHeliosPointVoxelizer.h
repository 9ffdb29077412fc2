// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointVoxelizer
 * @brief   points to solid cells
 */

#ifndef vtkHeliosPointVoxelizer_h
#define vtkHeliosPointVoxelizer_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkHeliosFiltersSceneModule.h" // For export macro

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosPointVoxelizer : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPointVoxelizer* New();
  vtkTypeMacro(vtkHeliosPointVoxelizer, vtkPolyDataAlgorithm);

protected:
  vtkHeliosPointVoxelizer() = default;
  ~vtkHeliosPointVoxelizer() override = default;

private:
  vtkHeliosPointVoxelizer(const vtkHeliosPointVoxelizer&) = delete;
  void operator=(const vtkHeliosPointVoxelizer&) = delete;
};

#endif
