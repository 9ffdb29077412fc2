// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPhotonCountingDetector
 * @brief   an echo is a detected photon, or a dark count
 *
 * A photon-counting receiver: detections are a Poisson process with the rate
 * - r(t) = DetectionEfficiency P(t) / (h c / Wavelength) + DarkCountRate
 *
 * of a waveform P(t), constant within each bin about its sample. After a
 * detection the receiver is blind for DeadTime (not extended by photons in it).
 * Each detection is an echo: at its time with a jitter, with the Amplitude of one
 * photon in PulseLength and the Width PulseLength. A pulse with the mean number N
 * of photons is detected with the probability 1 - exp(-N), and the first photon
 * of a strong echo comes early: the range walk of single-photon instruments
 * (Fouche 2003, Appl. Opt. 42, 5388-5398). A short DeadTime is a single-photon
 * receiver that counts several photons; in Geiger mode one longer than the range
 * gate leaves one echo a pulse. DetectionThreshold has no effect.
 *
 * Dark counts are drawn within the range gate of the scanner, also for pulses that
 * return nothing; of stored waveforms, within their samples. They are of no
 * surface: CellIds, MaterialIds and PartIds are -1. Counts of sunlight
 * outside the waveforms belong to DarkCountRate. A pulse has at most 255 counts.
 *
 * Random numbers are keyed by the seed of the scanner or filter, the pulse and the
 * count: the same for any threads and pieces.
 *
 * @sa
 * vtkHeliosEchoDetector vtkHeliosScanner
 */

#ifndef vtkHeliosPhotonCountingDetector_h
#define vtkHeliosPhotonCountingDetector_h

#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosScannerDetectorsModule.h" // For export macro

class VTKHELIOSSCANNERDETECTORS_EXPORT vtkHeliosPhotonCountingDetector
  : public vtkHeliosEchoDetector
{
public:
  static vtkHeliosPhotonCountingDetector* New();
  vtkTypeMacro(vtkHeliosPhotonCountingDetector, vtkHeliosEchoDetector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the probability that a received photon is detected. Valid range:
   * [0, 1]. Default: 0.3.
   */
  vtkSetClampMacro(DetectionEfficiency, double, vtkHeliosInstrumentRanges::PhotonEfficiency.Low,
    vtkHeliosInstrumentRanges::PhotonEfficiency.High);
  vtkGetMacro(DetectionEfficiency, double);
  ///@}

  ///@{
  /**
   * Set/Get the wavelength, which gives the energy of a photon [nm]. Valid range:
   * [200, 20000]. Default: 1064.
   */
  vtkSetClampMacro(Wavelength, double, vtkHeliosInstrumentRanges::Wavelength.Low,
    vtkHeliosInstrumentRanges::Wavelength.High);
  vtkGetMacro(Wavelength, double);
  ///@}

  ///@{
  /**
   * Set/Get the mean number of detections without light in a second [Hz]. A scanner
   * needs a RangeMax then. Valid range: [0, 1e10]. Default: 0.
   */
  vtkSetClampMacro(DarkCountRate, double, vtkHeliosInstrumentRanges::DarkCountRate.Low,
    vtkHeliosInstrumentRanges::DarkCountRate.High);
  vtkGetMacro(DarkCountRate, double);
  ///@}

  ///@{
  /**
   * Set/Get the standard deviation of the times of detections, normally distributed
   * [ns]. Valid range: [0, 1e3]. Default: 0.
   */
  vtkSetClampMacro(TimeJitter, double, vtkHeliosInstrumentRanges::TimeJitter.Low,
    vtkHeliosInstrumentRanges::TimeJitter.High);
  vtkGetMacro(TimeJitter, double);
  ///@}

  bool HasDarkCounts() const override { return this->DarkCountRate > 0.0; }

  /// Returns 0, no calibration: the range walk is part of the model.
  double GetCalibrationAmplitude() const override { return 0.0; }

  void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const override;

#ifndef __VTK_WRAP__
  void SetInstrument(const vtkHeliosInstrumentData& instrument) override;
#endif

protected:
  vtkHeliosPhotonCountingDetector() = default;
  ~vtkHeliosPhotonCountingDetector() override = default;

private:
  vtkHeliosPhotonCountingDetector(const vtkHeliosPhotonCountingDetector&) = delete;
  void operator=(const vtkHeliosPhotonCountingDetector&) = delete;

  double DetectionEfficiency = vtkHeliosInstrumentData().PhotonEfficiency;
  double Wavelength = vtkHeliosInstrumentData().Wavelength;
  double DarkCountRate = 0.0;
  double TimeJitter = 0.0;
};

#endif
