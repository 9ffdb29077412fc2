// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosConstantFractionDetector
 * @brief   an echo is where a fraction of the waveform equals the delayed waveform
 *
 * The discriminator without range walk: the time at which
 * - Fraction w(t) - w(t - Delay)
 *
 * falls through zero, w linear between its samples. It does not depend on the scale of w. For a
 * Gaussian of the pulse's sigma at t0 it is t0 + Delay / 2 + sigma^2 ln(Fraction) / Delay; the time
 * of an echo is the crossing less this offset from t0, hence the peak of an echo as wide as the
 * pulse. Amplitude is the largest sample within half a PulseLength of that time, at least
 * DetectionThreshold; Width is the full width at half the amplitude.
 *
 * @sa
 * vtkHeliosLeadingEdgeDetector vtkHeliosEchoDetection
 */

#ifndef vtkHeliosConstantFractionDetector_h
#define vtkHeliosConstantFractionDetector_h

#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosScannerDetectorsModule.h" // For export macro

class VTKHELIOSSCANNERDETECTORS_EXPORT vtkHeliosConstantFractionDetector
  : public vtkHeliosEchoDetector
{
public:
  static vtkHeliosConstantFractionDetector* New();
  vtkTypeMacro(vtkHeliosConstantFractionDetector, vtkHeliosEchoDetector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the fraction of the waveform that is not delayed. Valid range:
   * [0.01, 1]. Default: 0.5.
   */
  vtkSetClampMacro(Fraction, double, 0.01, 1.0);
  vtkGetMacro(Fraction, double);
  ///@}

  ///@{
  /**
   * Set/Get the delay [ns]; 0: PulseLength. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(Delay, double, 0.0, 1e6);
  vtkGetMacro(Delay, double);
  ///@}

  void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const override;

protected:
  vtkHeliosConstantFractionDetector() = default;
  ~vtkHeliosConstantFractionDetector() override = default;

private:
  vtkHeliosConstantFractionDetector(const vtkHeliosConstantFractionDetector&) = delete;
  void operator=(const vtkHeliosConstantFractionDetector&) = delete;

  double Fraction = 0.5;
  double Delay = 0.0;
};

#endif
