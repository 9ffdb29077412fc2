// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSyntheticScene
 * @brief   scenes made in code
 */

#ifndef vtkHeliosSyntheticScene_h
#define vtkHeliosSyntheticScene_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosSyntheticScene : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSyntheticScene* New();
  vtkTypeMacro(vtkHeliosSyntheticScene, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;



protected:
  vtkHeliosSyntheticScene();
  ~vtkHeliosSyntheticScene() override;

private:
  vtkHeliosSyntheticScene(const vtkHeliosSyntheticScene&) = delete;
  void operator=(const vtkHeliosSyntheticScene&) = delete;
};

#endif
