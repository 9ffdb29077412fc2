// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosEchoDetector
 * @brief   finds the echoes in a received waveform
 *
 * A strategy, const and thread-safe once set up. The scanner and the filters on
 * stored waveforms call the same detector on the same float samples.
 *
 * To add one: subclass, implement Detect().
 *
 * @sa
 * vtkHeliosPeakDetector vtkHeliosScanner
 */

#ifndef vtkHeliosEchoDetector_h
#define vtkHeliosEchoDetector_h

#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkObject.h"

#include <limits> // For the missing Deviation
#include <vector> // For the echoes

/// A received waveform: Samples[i] [W] was received at i BinSize.
struct vtkHeliosWaveform
{
  const float* Samples;
  vtkIdType Count;
  double BinSize;     ///< [ns]
  double PulseLength; ///< [ns], full width at half maximum of the transmitted pulse
};

/// An echo in a waveform.
struct vtkHeliosDetectedEcho
{
  double Time;      ///< [ns] after the first sample
  double Amplitude; ///< [W]
  double Width;     ///< [ns], full width at half maximum
  /// RMS of the samples about the fitted echo over its Amplitude; NaN where no echo was fitted.
  double Deviation = std::numeric_limits<double>::quiet_NaN();
};

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosEchoDetector : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosEchoDetector, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the smallest amplitude of an echo [W]. Valid range: [0, 1e6].
   * Default: 1e-13.
   */
  vtkSetClampMacro(DetectionThreshold, double, 0.0, 1e6);
  double GetDetectionThreshold() const { return this->DetectionThreshold; }
  ///@}

  /**
   * Whether echoes have a Deviation. Default: no.
   */
  virtual bool GivesDeviation() const { return false; }

  /**
   * Whether an echo is a maximum of the waveform and may be found without bins
   * where that is faster. Default: no.
   */
  virtual bool FindsMaxima() const { return false; }

  /**
   * Appends the echoes of a waveform in order of time. Thread-safe.
   */
  virtual void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const = 0;

protected:
  vtkHeliosEchoDetector() = default;
  ~vtkHeliosEchoDetector() override = default;

  double DetectionThreshold = 1e-13;

private:
  vtkHeliosEchoDetector(const vtkHeliosEchoDetector&) = delete;
  void operator=(const vtkHeliosEchoDetector&) = delete;
};

#endif
