// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSceneFlatten
 * @brief   makes one mesh of a scene with instances
 *
 * Input 0: a scene (vtkPolyData; of a vtkHeliosScene, its instances, too). Output 0: one vtkPolyData
 * with all triangles in the order of their cell ids, with MaterialIds, PartIds, Normals (as far as
 * the scene has them) and the field data. A scene without instances passes by reference.
 *
 * Errors: instances with invalid values, more than 2^31 points or corners, more memory than there
 * is.
 *
 * @sa
 * vtkHeliosScene vtkHeliosSceneComposer
 */

#ifndef vtkHeliosSceneFlatten_h
#define vtkHeliosSceneFlatten_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosSceneFlatten : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSceneFlatten* New();
  vtkTypeMacro(vtkHeliosSceneFlatten, vtkPolyDataAlgorithm);

  /**
   * Computes the bounds of the mesh of a scene, x0 x1 y0 y1 z0 z1 [m], without making it. False
   * after an error: instances with invalid values.
   */
  bool ComputeBounds(vtkPolyData* scene, double bounds[6]);

protected:
  vtkHeliosSceneFlatten() = default;
  ~vtkHeliosSceneFlatten() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosSceneFlatten(const vtkHeliosSceneFlatten&) = delete;
  void operator=(const vtkHeliosSceneFlatten&) = delete;
};

#endif
