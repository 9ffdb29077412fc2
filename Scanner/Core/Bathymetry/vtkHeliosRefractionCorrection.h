// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRefractionCorrection
 * @brief   moves echoes below water to where they are
 *
 * An instrument takes its beam for straight, at the speed of light in air. Port 0: the cloud, with
 * GpsTime; port 1: the surface of the water, triangles; port 2: the trajectory (points with
 * GpsTime, and Orientation for a LeverArm; one point: a tripod). The beam of an echo starts at the
 * trajectory at its time, towards the echo at the measured range R. If it meets the water at a
 * range H < R, it continues by Snell's law, for (R - H) / GroupIndex. Other echoes are not changed.
 *
 * The output is the cloud with the corrected points in double precision, and WaterDepth [m]: the
 * depth below the surface, along its normal; 0 of echoes that are not below it. Range and all other
 * arrays are copied from the input.
 *
 * @sa
 * vtkHeliosScanner
 */

#ifndef vtkHeliosRefractionCorrection_h
#define vtkHeliosRefractionCorrection_h

#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosRefractionCorrection : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosRefractionCorrection* New();
  vtkTypeMacro(vtkHeliosRefractionCorrection, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the refractive index of the water, of Snell's law. Valid range: [1, 4]. Default: 1.34.
   */
  vtkSetClampMacro(RefractiveIndex, double, 1.0, 4.0);
  vtkGetMacro(RefractiveIndex, double);
  ///@}

  ///@{
  /**
   * Set/Get the group index of the water, by which pulses are slower: 1.357 at 532 nm, where the
   * refractive index is 1.335. Valid range: [0, 4]; 0: the RefractiveIndex. Default: 0.
   */
  vtkSetClampMacro(GroupIndex, double, 0.0, 4.0);
  vtkGetMacro(GroupIndex, double);
  ///@}

  ///@{
  /**
   * Set/Get where beams start, in the frame of the trajectory [m]. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(LeverArm, double);
  vtkGetVector3Macro(LeverArm, double);
  ///@}

protected:
  vtkHeliosRefractionCorrection();
  ~vtkHeliosRefractionCorrection() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosRefractionCorrection(const vtkHeliosRefractionCorrection&) = delete;
  void operator=(const vtkHeliosRefractionCorrection&) = delete;

  double RefractiveIndex = 1.34;
  double GroupIndex = 0.0;
  double LeverArm[3] = { 0.0, 0.0, 0.0 };
};

#endif
