// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSceneComposer
 * @brief   parts into one scene
 */

#ifndef vtkHeliosSceneComposer_h
#define vtkHeliosSceneComposer_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosSceneComposer : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSceneComposer* New();
  vtkTypeMacro(vtkHeliosSceneComposer, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;



protected:
  vtkHeliosSceneComposer();
  ~vtkHeliosSceneComposer() override;

private:
  vtkHeliosSceneComposer(const vtkHeliosSceneComposer&) = delete;
  void operator=(const vtkHeliosSceneComposer&) = delete;
};

#endif
