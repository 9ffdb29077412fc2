// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGroundSnap
 * @brief   moves points onto the ground of a scene
 *
 * Port 0: points (vtkPolyData), e.g. waypoints. Port 1: the scene. Output: the
 * points, each moved vertically onto the highest surface with a ground material
 * (Material.IsGround) at its x, y; if the scene has no ground material, any
 * surface is ground. A point array OnGround limits this to the points where it
 * is not 0.
 *
 * Errors: no surface above or below a point, or a point that is not finite (the
 * message gives its x, y); an empty scene.
 *
 * @sa
 * vtkHeliosRayCaster
 */

#ifndef vtkHeliosGroundSnap_h
#define vtkHeliosGroundSnap_h

#include "vtkHeliosScannerRayCastingModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSSCANNERRAYCASTING_EXPORT vtkHeliosGroundSnap : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosGroundSnap* New();
  vtkTypeMacro(vtkHeliosGroundSnap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the height of the points above the ground [m]. Valid range:
   * [-1e6, 1e6]. Default: 0.
   */
  vtkSetClampMacro(HeightAboveGround, double, -1e6, 1e6);
  vtkGetMacro(HeightAboveGround, double);
  ///@}

  ///@{
  /**
   * Set/Get whether a point without ground above or below stays where it is: the output then has the
   * point array OnGround, 1 for the points that were moved, else 0. Default: off, it is an error.
   */
  vtkSetMacro(AllowMissing, bool);
  vtkGetMacro(AllowMissing, bool);
  vtkBooleanMacro(AllowMissing, bool);
  ///@}

protected:
  vtkHeliosGroundSnap();
  ~vtkHeliosGroundSnap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosGroundSnap(const vtkHeliosGroundSnap&) = delete;
  void operator=(const vtkHeliosGroundSnap&) = delete;

  double HeightAboveGround = 0.0;
  bool AllowMissing = false;
};

#endif
