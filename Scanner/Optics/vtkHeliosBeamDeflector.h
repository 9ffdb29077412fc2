// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosBeamDeflector
 * @brief   where each pulse leaves the scanner
 *
 * A strategy, const once set up. The direction of a pulse is a pure function of
 * its index, so any thread or machine can compute any pulse, and nothing
 * drifts.
 *
 * To add one: subclass, implement GetDirection() (and GetScanAngle() if the
 * angle is not the one from the y axis). It needs nothing else of vtkHelios.
 *
 * @sa
 * vtkHeliosRotatingMirror vtkHeliosConicMirror vtkHeliosScanner
 */

#ifndef vtkHeliosBeamDeflector_h
#define vtkHeliosBeamDeflector_h

#include "vtkHeliosScannerOpticsModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosBeamDeflector : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosBeamDeflector, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the pulses emitted a second [Hz]. Valid range: (0, 1e9].
   * Default: 100000.
   */
  vtkSetClampMacro(PulseFrequency, double, 1e-9, 1e9);
  vtkGetMacro(PulseFrequency, double);
  ///@}

  /**
   * The direction of a pulse in the scanner frame (x right, y forward, z up), a
   * unit vector. Returns false where the deflector lets no pulse out at that
   * index (the mirror is turned away); direction is then not set.
   */
  virtual bool GetDirection(vtkIdType pulse, double direction[3]) const = 0;

  /**
   * The angle of a pulse as the instrument reports it [deg]: by default the
   * angle between its direction and the y axis, 0 where no pulse leaves.
   */
  virtual double GetScanAngle(vtkIdType pulse) const;

protected:
  vtkHeliosBeamDeflector() = default;
  ~vtkHeliosBeamDeflector() override = default;

  double PulseFrequency = 100000.0;

private:
  vtkHeliosBeamDeflector(const vtkHeliosBeamDeflector&) = delete;
  void operator=(const vtkHeliosBeamDeflector&) = delete;
};

#endif
