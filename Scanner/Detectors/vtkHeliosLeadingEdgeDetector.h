// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosLeadingEdgeDetector
 * @brief   an echo is where the waveform rises through a level
 *
 * The discriminator of simple instruments: the time at which the waveform, linear between its
 * samples, rises through a level L, plus the time that a Gaussian pulse of PulseLength and
 * ReferenceAmplitude A0 takes from there to its peak, sigma sqrt(2 ln(A0 / L)). L is
 * DetectionThreshold, or Fraction of the largest sample where that is higher. The range walk
 * remains: the error of an echo of amplitude A > L is
 * - sigma (sqrt(2 ln(A0 / L)) - sqrt(2 ln(A / L)))
 *
 * too late for weak echoes, too early for strong ones. Amplitude is the largest sample before the
 * waveform falls below L, Width the full width at half the amplitude.
 *
 * @sa
 * vtkHeliosConstantFractionDetector vtkHeliosEchoDetection
 */

#ifndef vtkHeliosLeadingEdgeDetector_h
#define vtkHeliosLeadingEdgeDetector_h

#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosScannerDetectorsModule.h" // For export macro

class VTKHELIOSSCANNERDETECTORS_EXPORT vtkHeliosLeadingEdgeDetector : public vtkHeliosEchoDetector
{
public:
  static vtkHeliosLeadingEdgeDetector* New();
  vtkTypeMacro(vtkHeliosLeadingEdgeDetector, vtkHeliosEchoDetector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the level as a fraction of the largest sample of the waveform; 0:
   * the level is DetectionThreshold. Valid range: [0, 0.99]. Default: 0.
   */
  vtkSetClampMacro(Fraction, double, 0.0, 0.99);
  vtkGetMacro(Fraction, double);
  ///@}

  ///@{
  /**
   * Set/Get the amplitude without range walk [W]; 0: twice the level, or with a
   * Fraction the level over it. An amplitude below the level counts as the level.
   * Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(ReferenceAmplitude, double, 0.0, 1e6);
  vtkGetMacro(ReferenceAmplitude, double);
  ///@}

  double GetCalibrationAmplitude() const override;

  void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const override;

protected:
  vtkHeliosLeadingEdgeDetector() = default;
  ~vtkHeliosLeadingEdgeDetector() override = default;

private:
  vtkHeliosLeadingEdgeDetector(const vtkHeliosLeadingEdgeDetector&) = delete;
  void operator=(const vtkHeliosLeadingEdgeDetector&) = delete;

  double Fraction = 0.0;
  double ReferenceAmplitude = 0.0;
};

#endif
