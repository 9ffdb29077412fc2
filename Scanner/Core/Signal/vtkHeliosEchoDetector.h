// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosEchoDetector
 * @brief   finds the echoes in a received waveform
 *
 * A strategy, const and thread-safe once set up. The scanner and the filters on
 * stored waveforms call the same detector on the same float samples.
 *
 * To add one: subclass, implement Detect(). Where many waveforms at once are faster, implement
 * DetectAll(), too, and PrefersBlocks().
 *
 * @sa
 * vtkHeliosPeakDetector vtkHeliosScanner
 */

#ifndef vtkHeliosEchoDetector_h
#define vtkHeliosEchoDetector_h

#include "vtkHeliosInstrumentData.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkObject.h"

#include <cstdint> // For the keys of random numbers
#include <limits>  // For the missing Deviation
#include <memory>  // For PrepareThreads()
#include <string>  // For errors
#include <vector>  // For the echoes

/// A received waveform: Samples[i] [W] was received at i BinSize.
struct vtkHeliosWaveform
{
  const float* Samples;
  vtkIdType Count;
  double BinSize;     ///< [ns]
  double PulseLength; ///< [ns], full width at half maximum of the transmitted pulse

  /// Inputs of detectors that draw random numbers: times from the first sample between which the
  /// receiver is armed [ns] (both 0: while there are samples), and the key of the numbers.
  double GateStart = 0.0;
  double GateStop = 0.0;
  std::uint64_t Seed = 0;
  std::uint64_t PulseId = 0;
};

/// An echo in a waveform.
struct vtkHeliosDetectedEcho
{
  double Time;      ///< [ns] after the first sample
  double Amplitude; ///< [W]
  double Width;     ///< [ns], full width at half maximum
  /// RMS of the samples about the fitted echo over its Amplitude; NaN where no echo was fitted.
  double Deviation = std::numeric_limits<double>::quiet_NaN();
  bool IsDark = false; ///< a count of the receiver itself, without light of the pulse
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
  vtkSetClampMacro(DetectionThreshold, double, vtkHeliosInstrumentRanges::DetectionThreshold.Low,
    vtkHeliosInstrumentRanges::DetectionThreshold.High);
  double GetDetectionThreshold() const { return this->DetectionThreshold; }
  ///@}

  ///@{
  /**
   * Set/Get the dead time of the receiver [ns]: an echo within this time after
   * the one before, which was detected, is lost. Valid range: [0, 1e6].
   * Default: 0.
   */
  vtkSetClampMacro(DeadTime, double, vtkHeliosInstrumentRanges::DeadTime.Low,
    vtkHeliosInstrumentRanges::DeadTime.High);
  vtkGetMacro(DeadTime, double);
  ///@}

#ifndef __VTK_WRAP__
  /// Sets the properties that are values of an instrument, as a survey does.
  virtual void SetInstrument(const vtkHeliosInstrumentData& instrument);
#endif

  /**
   * Returns whether echoes have a Deviation. Default: no.
   */
  virtual bool GivesDeviation() const
  {
    return false;
  }

  /**
   * Returns whether an echo is a maximum of the waveform and may be found without bins where that
   * is faster. Default: no.
   */
  virtual bool FindsMaxima() const
  {
    return false;
  }

  /**
   * Returns whether there may be echoes of pulses that return nothing: dark counts. Default: no.
   */
  virtual bool HasDarkCounts() const
  {
    return false;
  }

  /**
   * Returns the amplitude [W] for which times of pulses that are not Gaussian are calibrated: the
   * amplitude of the echo of a plane across the beam at the true range; 0: times are not
   * calibrated. Default: 1000 times the DetectionThreshold, or 1.
   */
  virtual double GetCalibrationAmplitude() const;

  /**
   * Appends the echoes of a waveform in order of time. Thread-safe.
   */
  virtual void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const = 0;

#ifndef __VTK_WRAP__
  using Echoes = std::vector<vtkHeliosDetectedEcho>;

  /// Returns whether DetectAll() is faster with many waveforms: the scanner then collects those of up
  /// to 256 pulses. Default: no.
  virtual bool PrefersBlocks() const
  {
    return false;
  }

  /// Appends the echoes of each of some waveforms to the echoes with its index. Returns false after an
  /// error, whose message ends a scan. Thread-safe; the echoes of a waveform do not depend on others.
  /// Default: calls Detect().
  virtual bool DetectAll(const std::vector<vtkHeliosWaveform>& waveforms,
    std::vector<Echoes>& echoes, std::string& error) const;

  /// Returns what the thread that starts others, and waits for them, holds while these detect echoes.
  /// Default: null.
  virtual std::shared_ptr<void> PrepareThreads() const;
#endif

protected:
  vtkHeliosEchoDetector() = default;
  ~vtkHeliosEchoDetector() override = default;

  /// Removes echoes, from an index on, within the dead time after one that remains.
  void RemoveDead(std::vector<vtkHeliosDetectedEcho>& echoes, std::size_t first) const;

  double DetectionThreshold = vtkHeliosInstrumentData().DetectionThreshold;
  double DeadTime = 0.0;

private:
  vtkHeliosEchoDetector(const vtkHeliosEchoDetector&) = delete;
  void operator=(const vtkHeliosEchoDetector&) = delete;
};

#endif
