// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPalmerMirror
 * @brief   a Palmer scanner: a wobbling mirror on a shaft at 45 degrees
 *
 * The laser shines along -x on a mirror whose shaft s = (1, 1, 0) / sqrt 2 bisects the incoming
 * beam and y: a mirror perpendicular to its shaft would reflect every pulse along y. The normal n
 * is tilted from the shaft by b = WobbleAngle and rotates about it with the phase phi = 2 pi frac(i
 * ScanFrequency / PulseFrequency), with an exact fraction:
 * - n = cos b s + sin b (sin phi (1, -1, 0) / sqrt 2 + cos phi (0, 0, 1))
 *
 * The law of reflection, d = e - 2 (e . n) n with e = (-1, 0, 0), is then
 * - d_x = sin 2b sin phi - sin^2 b cos^2 phi
 * - d_y = cos^2 b - sin^2 b sin^2 phi
 * - d_z = sqrt 2 sin b cos phi (cos b + sin b sin phi)
 *
 * On flat ground at height H this is an egg, not an ellipse: it reaches H tan 2b on either side
 * along x and H sqrt 2 tan b / sqrt(1 - tan^2 b) along z, widest at sin phi = tan b. Palmer
 * scanners have this arrangement, reviewed by Wehr and Lohr 1999 (ISPRS J. 54, 68-82).
 *
 * @sa
 * vtkHeliosBeamDeflector vtkHeliosConicMirror vtkHeliosScanner
 */

#ifndef vtkHeliosPalmerMirror_h
#define vtkHeliosPalmerMirror_h

#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosScannerOpticsModule.h" // For export macro

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosPalmerMirror : public vtkHeliosBeamDeflector
{
public:
  static vtkHeliosPalmerMirror* New();
  vtkTypeMacro(vtkHeliosPalmerMirror, vtkHeliosBeamDeflector);
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
   * Set/Get the angle between mirror normal and shaft [deg]; the beam is
   * deflected by up to twice as much. Valid range: [0, 45]. Default: 7.5.
   */
  void SetWobbleAngle(double angle);
  vtkGetMacro(WobbleAngle, double);
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;

protected:
  vtkHeliosPalmerMirror();
  ~vtkHeliosPalmerMirror() override = default;

private:
  vtkHeliosPalmerMirror(const vtkHeliosPalmerMirror&) = delete;
  void operator=(const vtkHeliosPalmerMirror&) = delete;

  void ComputeTilt();

  double ScanFrequency = 50.0;
  double WobbleAngle = 7.5;
  double SinWobble; // sine of WobbleAngle, saves a sine and cosine per pulse
  double CosWobble;
};

#endif
