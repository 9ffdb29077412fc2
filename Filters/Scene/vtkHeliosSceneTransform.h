// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSceneTransform
 * @brief   rotates, scales and moves a scene part
 *
 * Input 0: a vtkPolyData, e.g. from vtkHeliosObjSceneReader. Output 0: the same with points
 *
 *   p' = Scale * (R p) + Translation,
 *
 * R by Rotation: always in this order, about the part's own origin, in double for any input
 * precision. Cells, field data and arrays pass by reference, points too if the transform is the
 * identity; active normals of points and cells are rotated. Without rotation and scale, a
 * coordinate differs from the input by a single addition.
 *
 * Errors: a property that is not finite, a rotation of zero length, a scale that is not positive.
 *
 * @sa
 * vtkHeliosSceneComposer
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

  ///@{
  /**
   * Set/Get the rotation, a quaternion w, x, y, z of any length. Valid range: not 0. Default: 1, 0,
   * 0, 0 (none).
   */
  vtkSetVector4Macro(Rotation, double);
  vtkGetVector4Macro(Rotation, double);
  ///@}

  ///@{
  /**
   * Set/Get the scale factor of the rotated part. Valid range: greater than 0. Default: 1.
   */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Set/Get the translation, applied last [m]. Valid range: finite. Default: 0, 0, 0.
   */
  vtkSetVector3Macro(Translation, double);
  vtkGetVector3Macro(Translation, double);
  ///@}

protected:
  vtkHeliosSceneTransform() = default;
  ~vtkHeliosSceneTransform() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosSceneTransform(const vtkHeliosSceneTransform&) = delete;
  void operator=(const vtkHeliosSceneTransform&) = delete;

  bool CheckProperties();

  double Rotation[4] = { 1.0, 0.0, 0.0, 0.0 };
  double Scale = 1.0;
  double Translation[3] = { 0.0, 0.0, 0.0 };
};

#endif
