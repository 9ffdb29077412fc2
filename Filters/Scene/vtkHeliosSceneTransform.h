// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSceneTransform
 * @brief   rotates, scales and moves a scene part
 */

#ifndef vtkHeliosSceneTransform_h
#define vtkHeliosSceneTransform_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosSceneTransform : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSceneTransform* New();
  vtkTypeMacro(vtkHeliosSceneTransform, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;



protected:
  vtkHeliosSceneTransform();
  ~vtkHeliosSceneTransform() override;

private:
  vtkHeliosSceneTransform(const vtkHeliosSceneTransform&) = delete;
  void operator=(const vtkHeliosSceneTransform&) = delete;
};

#endif
