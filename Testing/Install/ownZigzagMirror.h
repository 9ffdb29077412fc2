// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ownZigzagMirror
 * @brief   a custom deflector outside of vtkHelios: it sweeps across track, back and forth
 *
 * Pulse i points to the angle ScanAngle (1 - |4 frac(i / PulsesPerPeriod) - 2|) from nadir, in the
 * xz plane.
 */

#ifndef ownZigzagMirror_h
#define ownZigzagMirror_h

#include <vtkHeliosBeamDeflector.h>

class ownZigzagMirror : public vtkHeliosBeamDeflector
{
public:
  static ownZigzagMirror* New();
  vtkTypeMacro(ownZigzagMirror, vtkHeliosBeamDeflector);

  ///@{
  /**
   * Set/Get the largest angle from nadir [deg]. Valid range: [0, 89]. Default: 30.
   */
  vtkSetClampMacro(ScanAngle, double, 0.0, 89.0);
  vtkGetMacro(ScanAngle, double);
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;
  double GetScanAngle(vtkIdType pulse) const override;

private:
  static constexpr vtkIdType PulsesPerPeriod = 100;
  double ScanAngle = 30.0;
};

#endif
