// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGaussianDecomposition
 * @brief   the echoes are the Gaussians whose sum is the waveform
 *
 * Starts from the maxima of the waveform, as vtkHeliosPeakDetector finds them, and fits the sum of
 * - A exp(-(t - c)^2 / (2 s^2))
 *
 * to the samples within 4 sigma of them, overlapping ones together, up to 12 (Levenberg-Marquardt;
 * Wagner et al. 2006, ISPRS J. 60, 100-112). An echo has the Amplitude A, the Time c, the Width
 * 2.3548 s (s is the standard deviation in time; the full width at half maximum is exported), and
 * as Deviation the RMS of the residuals within 2 sigma of c, over A. Under white noise times reach
 * the Cramer-Rao bound, std(c) = (sigma_n / A) sqrt(2 s dt / sqrt(pi)).
 *
 * The range is measured to a component's centre, not to a maximum of the waveform: where echoes
 * overlap the two differ, up to 2 s.
 *
 * A is positive, s above half the pulse's, c within 2.5 sigma of the pulse from its maximum. If a
 * fit does not converge, or ends on these bounds, the echo is the Gaussian of its maximum, with NaN
 * as Deviation; no echo is lost.
 *
 * @sa
 * vtkHeliosPeakDetector vtkHeliosEchoDetection
 */

#ifndef vtkHeliosGaussianDecomposition_h
#define vtkHeliosGaussianDecomposition_h

#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosScannerDetectorsModule.h" // For export macro

class VTKHELIOSSCANNERDETECTORS_EXPORT vtkHeliosGaussianDecomposition : public vtkHeliosEchoDetector
{
public:
  static vtkHeliosGaussianDecomposition* New();
  vtkTypeMacro(vtkHeliosGaussianDecomposition, vtkHeliosEchoDetector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the distance within which a smaller maximum is not a start of an
   * echo [ns]; 0: all are. Noise has many maxima: set the length of the pulse
   * then. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(MinimumSeparation, double, vtkHeliosInstrumentRanges::PeakWindow.Low,
    vtkHeliosInstrumentRanges::PeakWindow.High);
  vtkGetMacro(MinimumSeparation, double);
  ///@}

  ///@{
  /**
   * Set/Get whether an echo wider than the pulse is fitted as two of the pulse's
   * width, where these fit as well: below the separation at which a waveform has
   * two maxima. A slope widens echoes, too. Default: off.
   */
  vtkSetMacro(ResolveHidden, bool);
  vtkGetMacro(ResolveHidden, bool);
  vtkBooleanMacro(ResolveHidden, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether a constant background under overlapping echoes is fitted with
   * them, such as sunlight. Default: off.
   */
  vtkSetMacro(FitBackground, bool);
  vtkGetMacro(FitBackground, bool);
  vtkBooleanMacro(FitBackground, bool);
  ///@}

  ///@{
  /**
   * Set/Get the fraction of the largest sample of a waveform below which a maximum is no echo:
   * receivers ring after strong echoes. Valid range: [0, 1]. Default: 0, all that reach
   * DetectionThreshold.
   */
  vtkSetClampMacro(RelativeThreshold, double, 0.0, 1.0);
  vtkGetMacro(RelativeThreshold, double);
  ///@}

  ///@{
  /**
   * Set/Get the time after a maximum within which RelativeThreshold applies, as a fraction of
   * that maximum [ns]; 0: it applies to the whole waveform. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(RingingTime, double, 0.0, 1e6);
  vtkGetMacro(RingingTime, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of model evaluations per fit. Valid range:
   * [1, 10000]. Default: 100.
   */
  vtkSetClampMacro(MaximumNumberOfIterations, int, 1, 10000);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  bool GivesDeviation() const override { return true; }

  void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const override;

#ifndef __VTK_WRAP__
  void SetInstrument(const vtkHeliosInstrumentData& instrument) override;
#endif

protected:
  vtkHeliosGaussianDecomposition() = default;
  ~vtkHeliosGaussianDecomposition() override = default;

private:
  vtkHeliosGaussianDecomposition(const vtkHeliosGaussianDecomposition&) = delete;
  void operator=(const vtkHeliosGaussianDecomposition&) = delete;

  double MinimumSeparation = 0.0;
  bool ResolveHidden = false;
  bool FitBackground = false;
  double RelativeThreshold = 0.0;
  double RingingTime = 0.0;
  int MaximumNumberOfIterations = 100;
};

#endif
