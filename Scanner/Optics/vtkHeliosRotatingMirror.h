// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRotatingMirror
 * @brief   a polygon mirror: lines in one direction
 *
 * The beam turns about the x axis: at mirror angle beta it points to
 * (0, cos beta, sin beta). Each facet sweeps from -MirrorAngle to +MirrorAngle,
 * ScanFrequency times a second; pulse i is at
 * beta = MirrorAngle (2 frac(1/2 + i ScanFrequency / PulseFrequency) - 1),
 * the fraction taken exactly. Pulses leave only where
 * VerticalAngleMin < beta <= VerticalAngleMax.
 *
 * @sa
 * vtkHeliosBeamDeflector
 */

#ifndef vtkHeliosRotatingMirror_h
#define vtkHeliosRotatingMirror_h

#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosScannerOpticsModule.h" // For export macro

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosRotatingMirror : public vtkHeliosBeamDeflector
{
public:
  static vtkHeliosRotatingMirror* New();
  vtkTypeMacro(vtkHeliosRotatingMirror, vtkHeliosBeamDeflector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the lines scanned a second [Hz]. Valid range: [0, 1e6].
   * Default: 100.
   */
  vtkSetClampMacro(ScanFrequency, double, 0.0, 1e6);
  vtkGetMacro(ScanFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get half the angle that a facet sweeps [deg]. Valid range: (0, 360].
   * Default: 180.
   */
  vtkSetClampMacro(MirrorAngle, double, 1e-9, 360.0);
  vtkGetMacro(MirrorAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the window that pulses leave through [deg]. Valid range:
   * [-360, 360]. Default: -180 and 180.
   */
  vtkSetClampMacro(VerticalAngleMin, double, -360.0, 360.0);
  vtkGetMacro(VerticalAngleMin, double);
  vtkSetClampMacro(VerticalAngleMax, double, -360.0, 360.0);
  vtkGetMacro(VerticalAngleMax, double);
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;

  /**
   * The mirror angle beta [deg].
   */
  double GetScanAngle(vtkIdType pulse) const override;

protected:
  vtkHeliosRotatingMirror() = default;
  ~vtkHeliosRotatingMirror() override = default;

private:
  vtkHeliosRotatingMirror(const vtkHeliosRotatingMirror&) = delete;
  void operator=(const vtkHeliosRotatingMirror&) = delete;

  double ScanFrequency = 100.0;
  double MirrorAngle = 180.0;
  double VerticalAngleMin = -180.0;
  double VerticalAngleMax = 180.0;
};

#endif
