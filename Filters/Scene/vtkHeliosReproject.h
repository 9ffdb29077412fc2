// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosReproject
 * @brief   a scene from one coordinate system to another
 */

#ifndef vtkHeliosReproject_h
#define vtkHeliosReproject_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkHeliosFiltersSceneModule.h" // For export macro

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosReproject : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosReproject* New();
  vtkTypeMacro(vtkHeliosReproject, vtkPolyDataAlgorithm);

protected:
  vtkHeliosReproject() = default;
  ~vtkHeliosReproject() override = default;

private:
  vtkHeliosReproject(const vtkHeliosReproject&) = delete;
  void operator=(const vtkHeliosReproject&) = delete;
};

#endif
