// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosOscillatingMirror
 * @brief   a mirror that swings: lines to and fro
 *
 * The beam turns about the x axis: at mirror angle beta it points to
 * (0, cos beta, sin beta), and beta swings between -ScanAngle and +ScanAngle,
 * ScanFrequency times a second to and fro, i.e. two lines each time. Pulse 0 is
 * at -ScanAngle. With the phase p = frac(i ScanFrequency / PulseFrequency),
 * taken exactly, and A = ScanAngle,
 * - triangular: beta = A (4 q - 1), q = p up to half the period, then 1 - p
 * - sinusoidal: beta = -A cos(2 pi p)
 *
 * No mirror turns at once. With TurningPulses T > 0 the triangle is rounded: the
 * mirror slows down evenly during the last T / 2 pulses before an end, speeds up
 * during the T / 2 after it, still reaches both ends, and is as much faster in
 * between. HELIOS++ does so over 100 pulses, in whole steps; where T pulses last
 * longer than a line, all of the line is spent turning.
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

  /// How the angle changes with time.
  enum Patterns
  {
    TRIANGULAR = 0,
    SINUSOIDAL = 1
  };

  ///@{
  /**
   * Set/Get how the mirror swings. Default: TRIANGULAR.
   */
  vtkSetClampMacro(Pattern, int, TRIANGULAR, SINUSOIDAL);
  vtkGetMacro(Pattern, int);
  void SetPatternToTriangular() { this->SetPattern(TRIANGULAR); }
  void SetPatternToSinusoidal() { this->SetPattern(SINUSOIDAL); }
  ///@}

  ///@{
  /**
   * Set/Get how often the mirror swings to and fro a second [Hz]. Valid range:
   * [0, 1e6]. Default: 50.
   */
  vtkSetClampMacro(ScanFrequency, double, 0.0, 1e6);
  vtkGetMacro(ScanFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get how far it swings to either side [deg]. Valid range: [0, 180].
   * Default: 20.
   */
  void SetScanAngle(double angle);
  vtkGetMacro(ScanAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get how many pulses a triangular mirror takes to turn. Valid range:
   * [0, 1e9]. Default: 0, it turns at once.
   */
  vtkSetClampMacro(TurningPulses, int, 0, 1000000000);
  vtkGetMacro(TurningPulses, int);
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;

  /**
   * The mirror angle beta [deg].
   */
  double GetScanAngle(vtkIdType pulse) const override;

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
