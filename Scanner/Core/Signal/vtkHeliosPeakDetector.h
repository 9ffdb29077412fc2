// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPeakDetector
 * @brief   an echo is a local maximum of the waveform
 *
 * Each maximum that reaches DetectionThreshold is one echo, also a plateau. Time and amplitude are
 * the maximum of the parabola through the logarithms of the largest sample and its neighbours,
 * which is exact for a Gaussian; the width belongs to the Gaussian with this curvature. An echo of
 * one sample between zeros is at that sample and has the width of the pulse.
 *
 * In noise three samples are few, the more so for fine bins, and each echo has many maxima: set a
 * FitWindow (1.5 gives 1.3 times the Cramer-Rao bound) and a MinimumSeparation.
 *
 * @sa
 * vtkHeliosEchoDetector
 */

#ifndef vtkHeliosPeakDetector_h
#define vtkHeliosPeakDetector_h

#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosPeakDetector : public vtkHeliosEchoDetector
{
public:
  static vtkHeliosPeakDetector* New();
  vtkTypeMacro(vtkHeliosPeakDetector, vtkHeliosEchoDetector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the distance from the maximum within which samples are fitted,
   * weighted by the square of their amplitude [sigma of the pulse]; 0: the largest
   * and its neighbours. Valid range: [0, 3]. Default: 0.
   */
  vtkSetClampMacro(FitWindow, double, 0.0, 3.0);
  vtkGetMacro(FitWindow, double);
  ///@}

  ///@{
  /**
   * Set/Get the distance within which a smaller maximum is ignored [ns]; 0: all
   * count. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(MinimumSeparation, double, vtkHeliosInstrumentRanges::PeakWindow.Low,
    vtkHeliosInstrumentRanges::PeakWindow.High);
  vtkGetMacro(MinimumSeparation, double);
  ///@}

  bool FindsMaxima() const override
  {
    return this->FitWindow == 0.0 && this->MinimumSeparation == 0.0 && this->DeadTime == 0.0;
  }

  void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const override;

#ifndef __VTK_WRAP__
  void SetInstrument(const vtkHeliosInstrumentData& instrument) override;
#endif

protected:
  vtkHeliosPeakDetector() = default;
  ~vtkHeliosPeakDetector() override = default;

private:
  vtkHeliosPeakDetector(const vtkHeliosPeakDetector&) = delete;
  void operator=(const vtkHeliosPeakDetector&) = delete;

  double FitWindow = 0.0;
  double MinimumSeparation = 0.0;
};

#endif
