// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSceneClassify
 * @brief   sets the class of all materials of a mesh
 *
 * Input 0: a scene (vtkPolyData). Output 0: the same mesh by reference, with the class in all rows of
 * its material columns; a mesh without materials has the default material. Echoes have the class of
 * their material.
 *
 * @sa
 * vtkHeliosMaterialReader vtkHeliosSceneComposer
 */

#ifndef vtkHeliosSceneClassify_h
#define vtkHeliosSceneClassify_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosSceneClassify : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSceneClassify* New();
  vtkTypeMacro(vtkHeliosSceneClassify, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the class, one of LAS. Valid range: [0, 255]. Default: 0.
   */
  vtkSetClampMacro(Classification, int, 0, 255);
  vtkGetMacro(Classification, int);
  ///@}

protected:
  vtkHeliosSceneClassify() = default;
  ~vtkHeliosSceneClassify() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosSceneClassify(const vtkHeliosSceneClassify&) = delete;
  void operator=(const vtkHeliosSceneClassify&) = delete;

  int Classification = 0;
};

#endif
