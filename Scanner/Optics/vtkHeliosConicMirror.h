// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosConicMirror
 * @brief   a mirror that scans a cone
 *
 * The beam leaves the mirror at half angle ScanAngle from the y axis and
 * rotates about it with ScanFrequency. Pulse i at PulseFrequency f has azimuth
 * phi = 2 pi frac(i ScanFrequency / f), with an exact fraction, and the
 * direction (sin A sin phi, cos A, sin A cos phi); on flat ground below, the
 * centres of the footprints form a circle.
 *
 * @sa
 * vtkHeliosBeamDeflector vtkHeliosPalmerMirror vtkHeliosScanner
 */

#ifndef vtkHeliosConicMirror_h
#define vtkHeliosConicMirror_h

#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosScannerOpticsModule.h" // For export macro

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosConicMirror : public vtkHeliosBeamDeflector
{
public:
  static vtkHeliosConicMirror* New();
  vtkTypeMacro(vtkHeliosConicMirror, vtkHeliosBeamDeflector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the rotation frequency of the mirror [Hz]. Valid range: [0, 1e6].
   * Default: 50.
   */
  vtkSetClampMacro(ScanFrequency, double, 0.0, 1e6);
  vtkGetMacro(ScanFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get the half angle of the cone [deg]. Valid range: [0, 180].
   * Default: 20.
   */
  void SetScanAngle(double angle);
  vtkGetMacro(ScanAngle, double);
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;

  /**
   * Returns the half angle of the cone, for every pulse [deg].
   */
  double GetScanAngle(vtkIdType pulse) const override;

protected:
  vtkHeliosConicMirror();
  ~vtkHeliosConicMirror() override = default;

private:
  vtkHeliosConicMirror(const vtkHeliosConicMirror&) = delete;
  void operator=(const vtkHeliosConicMirror&) = delete;

  double ScanFrequency = 50.0;
  double ScanAngle = 20.0;
  double SinScanAngle; // sine of ScanAngle, saves a sine and cosine per pulse
  double CosScanAngle;
};

#endif
