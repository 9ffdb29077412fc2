// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPeakDetector
 * @brief   an echo is a local maximum of the waveform
 *
 * Each maximum that reaches DetectionThreshold is one echo, a plateau too. Time
 * and amplitude are those of the parabola through the logarithms of the largest
 * sample and its neighbours, which is exact for a Gaussian; the width is that
 * of the Gaussian with this curvature.
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

  bool FindsMaxima() const override { return true; }

  void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const override;

protected:
  vtkHeliosPeakDetector() = default;
  ~vtkHeliosPeakDetector() override = default;

private:
  vtkHeliosPeakDetector(const vtkHeliosPeakDetector&) = delete;
  void operator=(const vtkHeliosPeakDetector&) = delete;
};

#endif
