// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosOscillatingMirror
 * @brief   an oscillating mirror: lines in both directions
 *
 * The beam rotates about the x axis: at mirror angle beta it points to (0, cos
 * beta, sin beta), and beta oscillates between -ScanAngle and +ScanAngle with
 * ScanFrequency, two lines per period. Pulse 0 is at -ScanAngle. With the phase
 * p = frac(i ScanFrequency / PulseFrequency), an exact fraction, and
 * A = ScanAngle,
 * - triangular: beta = A (4 q - 1), q = p up to half the period, then 1 - p
 * - sinusoidal: beta = -A cos(2 pi p)
 *
 * A mirror cannot reverse instantly. With TurningPulses T > 0 the triangle is
 * rounded: the mirror decelerates evenly during the last T / 2 pulses before an
 * end, accelerates during the T / 2 after it, still reaches both ends, and is
 * faster in between. HELIOS++ does so over 100 pulses, in whole steps; if T
 * pulses last longer than a line, the whole line is a turn.
 *
 * @sa
 * vtkHeliosBeamDeflector vtkHeliosScanner
 */

#ifndef vtkHeliosOscillatingMirror_h
#define vtkHeliosOscillatingMirror_h

#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosScannerOpticsModule.h" // For export macro

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosOscillatingMirror : public vtkHeliosBeamDeflector
{
public:
  static vtkHeliosOscillatingMirror* New();
  vtkTypeMacro(vtkHeliosOscillatingMirror, vtkHeliosBeamDeflector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The scan angle over time.
  enum Patterns
  {
    TRIANGULAR = 0,
    SINUSOIDAL = 1
  };

  ///@{
  /**
   * Set/Get the scan angle over time. Default: TRIANGULAR.
   */
  vtkSetClampMacro(Pattern, int, TRIANGULAR, SINUSOIDAL);
  vtkGetMacro(Pattern, int);
  void SetPatternToTriangular() { this->SetPattern(TRIANGULAR); }
  void SetPatternToSinusoidal() { this->SetPattern(SINUSOIDAL); }
  ///@}

  ///@{
  /**
   * Set/Get the oscillation frequency of the mirror [Hz]. Valid range:
   * [0, 1e6]. Default: 50.
   */
  vtkSetClampMacro(ScanFrequency, double, 0.0, 1e6);
  vtkGetMacro(ScanFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum angle to either side [deg]. Valid range: [0, 180].
   * Default: 20.
   */
  void SetScanAngle(double angle);
  vtkGetMacro(ScanAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of pulses a triangular mirror takes to reverse. Valid
   * range: [0, 1e9]. Default: 0, instantly.
   */
  vtkSetClampMacro(TurningPulses, int, 0, 1000000000);
  vtkGetMacro(TurningPulses, int);
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;

  /**
   * Returns the mirror angle beta [deg].
   */
  double GetScanAngle(vtkIdType pulse) const override;

  ///@{
  /**
   * Returns 1 where p < 1/2; the edge is the last pulse of each half period. A mirror without
   * ScanFrequency has neither.
   */
  int GetScanDirectionFlag(vtkIdType pulse) const override;
  bool IsEdgeOfFlightLine(vtkIdType pulse) const override;
  ///@}

protected:
  vtkHeliosOscillatingMirror() = default;
  ~vtkHeliosOscillatingMirror() override = default;

private:
  vtkHeliosOscillatingMirror(const vtkHeliosOscillatingMirror&) = delete;
  void operator=(const vtkHeliosOscillatingMirror&) = delete;

  double ComputeTravel(double time) const;

  int Pattern = TRIANGULAR;
  double ScanFrequency = 50.0;
  double ScanAngle = 20.0;
  int TurningPulses = 0;
};

#endif
