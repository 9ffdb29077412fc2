// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRunOptions
 * @brief   the options of a run
 *
 * What a survey leaves open, or what overrides it: epoch, random numbers, and how the beam is
 * sampled; and whether a run reports its accuracy. vtkHeliosSurveySource and vtkHeliosSurveyPlayer use the same options.
 *
 * @sa
 * vtkHeliosSurveySource vtkHeliosSurveyPlayer
 */

#ifndef vtkHeliosRunOptions_h
#define vtkHeliosRunOptions_h

#include "vtkHeliosScannerRunModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For the private data
#include <string> // For names

namespace helios
{
struct RunOptions;
}

class VTKHELIOSSCANNERRUN_EXPORT vtkHeliosRunOptions : public vtkObject
{
public:
  static vtkHeliosRunOptions* New();
  vtkTypeMacro(vtkHeliosRunOptions, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the epoch to run: which geometry the swapped parts of the scene have. Valid range: [0,
   * the survey's GetNumberOfEpochs() - 1]. Default: 0.
   */
  void SetEpoch(int epoch);
  int GetEpoch() const;
  ///@}

  ///@{
  /**
   * Set/Get the seed of all random numbers. Valid range: [0, 2^62], or -1: that of the survey, else
   * 0. Default: -1.
   */
  void SetSeed(vtkIdType seed);
  vtkIdType GetSeed() const;
  vtkIdType GetSeedMaxValue() const;
  ///@}

  ///@{
  /**
   * Set/Get whether ranges have the scanner's noise. Default: on.
   */
  void SetNoise(bool noise);
  bool GetNoise() const;
  vtkBooleanMacro(Noise, bool);
  ///@}

  ///@{
  /**
   * Set/Get the tolerances of adaptive beam sampling, in range [m] and in amplitude (relative), as
   * in vtkHeliosScanner; they override the survey. Valid range: 0 or [1e-6, 1], 0 or [1e-4, 1].
   * Default: 0, as in the survey.
   */
  void SetRangeTolerance(double tolerance);
  double GetRangeTolerance() const;
  double GetRangeToleranceMinValue() const;
  double GetRangeToleranceMaxValue() const;
  void SetEnergyTolerance(double tolerance);
  double GetEnergyTolerance() const;
  double GetEnergyToleranceMinValue() const;
  double GetEnergyToleranceMaxValue() const;
  ///@}

  ///@{
  /**
   * Set/Get a fixed number of sub-rays of every pulse: 1, 7, 19, 37, 62 ... on circles, as by
   * beamSampleQuality in surveys; any other number, rounded up to a multiple of 4, on a spiral. Valid range: [0, 65536]. Default: 0,
   * as in the survey.
   */
  void SetNumberOfSubRays(int count);
  int GetNumberOfSubRays() const;
  int GetNumberOfSubRaysMaxValue() const;
  ///@}

  ///@{
  /**
   * Set/Get the pattern of these sub-rays, a name of GetSubRayPatternNames(); GaussLegendre has 4,
   * 16, 36 ... sub-rays, Circles 1, 7, 19 ..., Vogel any multiple of 4. Default: empty, Circles if
   * they give the number, else Vogel.
   */
  void SetSubRayPattern(const std::string& name);
  std::string GetSubRayPattern() const;
  ///@}

  /**
   * The names of the patterns, separated by blanks: those of vtkHeliosBeamSampler.
   */
  static std::string GetSubRayPatternNames();

  ///@{
  /**
   * Set/Get the most sub-rays of a beam in adaptive sampling, as
   * vtkHeliosScanner::SetMaximumNumberOfSubRays(): a limit of its time. Valid range: 0 or [1024,
   * 2^24]. Default: 0, the default of the scanner.
   */
  void SetMaximumSubRays(int count);
  int GetMaximumSubRays() const;
  int GetMaximumSubRaysMinValue() const;
  int GetMaximumSubRaysMaxValue() const;
  ///@}

  ///@{
  /**
   * Set/Get the bins of waveforms [ns]. Valid range: [0, 1e6]. Default: 0, as in the survey.
   */
  void SetBinSize(double size);
  double GetBinSize() const;
  ///@}

  ///@{
  /**
   * Set/Get the echo detector for waveforms, one of GetEchoDetectorNames(). Default: empty, that of
   * the survey.
   */
  void SetEchoDetector(const std::string& name);
  std::string GetEchoDetector() const;
  ///@}

  /**
   * The names of the echo detectors, separated by blanks; the first is the default.
   */
  static std::string GetEchoDetectorNames();

  ///@{
  /**
   * Set/Get the ray caster by its name, vtkHeliosRayCasterFactory::GetBackendName(). Default: empty, that
   * of the survey, else the first.
   */
  void SetRayCaster(const std::string& name);
  std::string GetRayCaster() const;
  ///@}

  ///@{
  /**
   * Set/Get a kind of weather and its amount, such as "fog 0.2", as
   * vtkHeliosInstrument::SetWeather(), for all scanners. Default: empty, that of the survey.
   */
  void SetWeather(const std::string& weather);
  std::string GetWeather() const;
  ///@}

  ///@{
  /**
   * Set/Get when the survey starts, at GpsTime 0, as vtkHeliosGpsTime::Parse() reads it, such as
   * "2026-07-01 12:00:00" of UTC: points then have the field array GpsEpoch, and files of points the
   * times of a clock. Default: empty, that of the survey, else not known.
   */
  void SetGpsStart(const std::string& start);
  std::string GetGpsStart() const;
  ///@}

  ///@{
  /**
   * Set/Get the parts of the model that are left out, names of GetModelPartNames() separated by
   * blanks: "divergence", all beams are one ray; "waveform", a pulse has one echo at the mean range
   * of its returns; "specular", surfaces are Lambertian; "spectra", materials with a spectrum have
   * the reflectance 0.5; "atmosphere", no extinction and no weather; "voxels", turbid voxels are air; "motion", the
   * platform stands still during a scan line (1 / scan frequency); "attitude", it has the orientation
   * of the last sample of its trajectory. Default: empty, none.
   */
  void SetWithout(const std::string& parts);
  std::string GetWithout() const;
  ///@}

  /**
   * The names of the parts of the model that can be left out, separated by blanks.
   */
  static std::string GetModelPartNames();

  ///@{
  /**
   * Set/Get how many pulses have one that is fired: a sample of the run, as by
   * vtkHeliosScanner::SetPulseStep(). Valid range: [1, 2^53]. Default: 1, all.
   */
  void SetPulseStep(vtkIdType step);
  vtkIdType GetPulseStep() const;
  ///@}

  ///@{
  /**
   * Set/Get whether a run of vtkHeliosSurveyPlayer computes some of its pulses again with a
   * reference, and adds "accuracy" to its summary. Changes no echo. Default: on.
   */
  void SetAccuracyReport(bool report);
  bool GetAccuracyReport() const;
  vtkBooleanMacro(AccuracyReport, bool);
  ///@}

#ifndef __VTK_WRAP__
  /// All options.
  const helios::RunOptions& GetData() const
  {
    return *this->Data;
  }
#endif

protected:
  vtkHeliosRunOptions();
  ~vtkHeliosRunOptions() override;

private:
  vtkHeliosRunOptions(const vtkHeliosRunOptions&) = delete;
  void operator=(const vtkHeliosRunOptions&) = delete;

  template <typename T>
  void Set(T& option, const T& value);

  std::unique_ptr<helios::RunOptions> Data;
};

#endif
