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

#include <string> // For names

#ifndef __VTK_WRAP__
namespace Json
{
class Value;
}

namespace helios
{

class Status;

/// The value of Accuracy.
constexpr const char* InstrumentAccuracy = "instrument";

/// Properties of vtkHeliosRunOptions, which documents them. 0 and empty: as in the survey.
struct VTKHELIOSSCANNERRUN_EXPORT RunOptions
{
  int Epoch = 0;
  vtkIdType Seed = -1; ///< negative: as in the survey, else 0
  bool Noise = true;
  double RangeTolerance = 0.0;  ///< [m]
  double EnergyTolerance = 0.0; ///< relative
  std::string Accuracy;         ///< "instrument": tolerances from its noise
  int NumberOfSubRays = 0;      ///< fixed
  /// largest number for a beam in adaptive sampling; 0: the default of the scanner
  int MaximumSubRays = 0;
  std::string SubRayPattern; ///< pattern of fixed sub-rays
  int ScatteringOrders = 0;  ///< the most scatterings of light
  int ScatteringPaths = 0;   ///< paths of light of a pulse
  double BinSize = 0.0;      ///< [ns]
  std::string EchoDetector;
  std::string RayCaster;
  std::string Weather;        ///< see ParseWeather()
  std::string GpsStart;       ///< see vtkHeliosGpsTime::Parse()
  std::string Without;        ///< names of parts of the model, separated by blanks
  vtkIdType PulseStep = 1;    ///< a sample: every n-th pulse
  bool AccuracyReport = true; ///< changes no echo: not among those that are compared

  /// Whether a part of the model is left out.
  bool IsWithout(const std::string& part) const;

  /// The pattern of vtkHeliosBeamSampler for the fixed sub-rays: without SubRayPattern circles if
  /// they give that number, else a spiral.
  int GetPattern() const;

  bool operator==(const RunOptions& other) const;

  /// Returns an error if a value is not valid: which one, and what is expected.
  Status FindFault() const;

  /// Adds the options to those of a run's summary, without the epoch and the accuracy report.
  void Describe(Json::Value& options) const;

private:
  Status CheckSampling() const;
  Status CheckAccuracy() const;
  Status CheckScattering() const;
  Status CheckPattern() const;
  Status CheckParts() const;
  Status CheckWeather() const;
  Status CheckGpsStart() const;
};

} // namespace helios

#define vtkHeliosRunOptionsData , protected helios::RunOptions
#else
#define vtkHeliosRunOptionsData
#endif

class VTKHELIOSSCANNERRUN_EXPORT vtkHeliosRunOptions : public vtkObject vtkHeliosRunOptionsData
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
  vtkSetClampMacro(Epoch, int, 0, VTK_INT_MAX);
  vtkGetMacro(Epoch, int);
  ///@}

  ///@{
  /**
   * Set/Get the seed of all random numbers. Valid range: [0, 2^62], or -1: the survey's, else 0.
   * Default: -1.
   */
  vtkSetClampMacro(Seed, vtkIdType, -1, 4611686018427387904LL);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get whether there is noise: of ranges, directions, detector, platform and legs. Default: on.
   */
  vtkSetMacro(Noise, bool);
  vtkGetMacro(Noise, bool);
  vtkBooleanMacro(Noise, bool);
  ///@}

  ///@{
  /**
   * Set/Get the tolerances of adaptive beam sampling, in range [m] and in amplitude (relative), as
   * in vtkHeliosScanner; they override the survey. Valid range: 0 or [1e-6, 1], 0 or [1e-4, 1].
   * Default: 0, as in the survey.
   */
  vtkSetMacro(RangeTolerance, double);
  vtkGetMacro(RangeTolerance, double);
  double GetRangeToleranceMinValue() const;
  double GetRangeToleranceMaxValue() const;
  vtkSetMacro(EnergyTolerance, double);
  vtkGetMacro(EnergyTolerance, double);
  double GetEnergyToleranceMinValue() const;
  double GetEnergyToleranceMaxValue() const;
  ///@}

  ///@{
  /**
   * Set/Get what the tolerances follow that are not set: "instrument", adaptive beam sampling within a tenth of
   * the noise of each scanner, of its ranges (RangeAccuracy and RangeAccuracyPerMeter at RangeMin, in [1e-6, 1]
   * m) and of the amplitude of a full footprint (DetectorNoise there; at least 1 %). A scanner without range
   * noise has the tolerances of the survey, and a warning. Default: empty, the survey.
   */
  vtkSetMacro(Accuracy, const std::string&);
  vtkGetMacro(Accuracy, std::string);
  ///@}

  ///@{
  /**
   * Set/Get a fixed number of sub-rays of every pulse: 1, 7, 19, 37, 62 ... on circles, like
   * beamSampleQuality in surveys; any other number, rounded up to a multiple of 4, on a spiral.
   * Valid range: [0, 65536]. Default: 0, as in the survey.
   */
  vtkSetClampMacro(NumberOfSubRays, int, 0, 65536);
  vtkGetMacro(NumberOfSubRays, int);
  ///@}

  ///@{
  /**
   * Set/Get the pattern of these sub-rays, a name of GetSubRayPatternNames(); GaussLegendre has 4,
   * 16, 36 ... sub-rays, Circles 1, 7, 19 ..., Vogel any multiple of 4. Default: empty, Circles if
   * they give the number, else Vogel.
   */
  vtkSetMacro(SubRayPattern, const std::string&);
  vtkGetMacro(SubRayPattern, std::string);
  ///@}

  /**
   * Get the names of the patterns of vtkHeliosBeamSampler, separated by blanks.
   */
  static std::string GetSubRayPatternNames();

  ///@{
  /**
   * Set/Get the most sub-rays of a beam in adaptive sampling, as
   * vtkHeliosScanner::SetMaximumNumberOfSubRays(): a limit of its time. Valid range: 0 or [1024,
   * 2^24]. Default: 0, the default of the scanner.
   */
  vtkSetMacro(MaximumSubRays, int);
  vtkGetMacro(MaximumSubRays, int);
  int GetMaximumSubRaysMinValue() const;
  int GetMaximumSubRaysMaxValue() const;
  ///@}

  ///@{
  /**
   * Set/Get the most scatterings of light on its way, and the paths of light that are drawn for each
   * pulse, as vtkHeliosInstrument::SetScatteringOrders() and SetScatteringPaths(). Valid range: 0 or
   * [1, 64], 0 or [8, 65536]. Default: 0, as in the survey.
   */
  vtkSetMacro(ScatteringOrders, int);
  vtkGetMacro(ScatteringOrders, int);
  int GetScatteringOrdersMinValue() const;
  int GetScatteringOrdersMaxValue() const;
  vtkSetMacro(ScatteringPaths, int);
  vtkGetMacro(ScatteringPaths, int);
  int GetScatteringPathsMinValue() const;
  int GetScatteringPathsMaxValue() const;
  ///@}

  ///@{
  /**
   * Set/Get the bins of waveforms [ns]. Valid range: [0, 1e6]. Default: 0, as in the survey.
   */
  vtkSetMacro(BinSize, double);
  vtkGetMacro(BinSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the echo detector for waveforms, one of GetEchoDetectorNames(). Default: empty, the
   * survey's.
   */
  vtkSetMacro(EchoDetector, const std::string&);
  vtkGetMacro(EchoDetector, std::string);
  ///@}

  /**
   * Returns the names of the echo detectors, separated by blanks; the first is the default.
   */
  static std::string GetEchoDetectorNames();

  ///@{
  /**
   * Set/Get the ray caster by its name, vtkHeliosRayCasterFactory::GetBackendName(). Default: empty, that
   * of the survey, else the first.
   */
  vtkSetMacro(RayCaster, const std::string&);
  vtkGetMacro(RayCaster, std::string);
  ///@}

  ///@{
  /**
   * Set/Get a kind of weather and its amount, such as "fog 0.2", as
   * vtkHeliosInstrument::SetWeather(), for all scanners. Default: empty, the survey's.
   */
  vtkSetMacro(Weather, const std::string&);
  vtkGetMacro(Weather, std::string);
  ///@}

  ///@{
  /**
   * Set/Get when the survey starts, at GpsTime 0, as vtkHeliosGpsTime::Parse() reads it, such as
   * "2026-07-01 12:00:00" of UTC: points then have the field array GpsEpoch, and files of points
   * the times of a clock. Default: empty, the survey's, else not known.
   */
  vtkSetMacro(GpsStart, const std::string&);
  vtkGetMacro(GpsStart, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the parts of the model that are left out, names of GetModelPartNames() separated by
   * blanks: "divergence", all beams are one ray; "waveform", a pulse has one echo at the mean range
   * of its returns; "specular", surfaces are Lambertian; "spectra", materials with a spectrum have
   * the reflectance 0.5; "atmosphere", no extinction and no weather; "voxels", turbid voxels are air; "motion", the
   * platform stands still during a scan line (1 / scan frequency); "attitude", it has the orientation
   * of the last sample of its trajectory; "scattering", light is scattered once; "partMotion", parts of
   * the scene stand where they are at time 0 of the survey. Default: empty, none.
   */
  vtkSetMacro(Without, const std::string&);
  vtkGetMacro(Without, std::string);
  ///@}

  /**
   * Get the names of the parts of the model that can be left out, separated by blanks.
   */
  static std::string GetModelPartNames();

  ///@{
  /**
   * Set/Get how many pulses have one that is fired: a sample of the run, see
   * vtkHeliosScanner::SetPulseStep(). Valid range: [1, 2^53]. Default: 1, all.
   */
  vtkSetClampMacro(PulseStep, vtkIdType, 1, 9007199254740992LL);
  vtkGetMacro(PulseStep, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get whether a run of vtkHeliosSurveyPlayer computes some of its pulses again with a
   * reference, and adds "accuracy" to its summary. Changes no echo. Default: on.
   */
  vtkSetMacro(AccuracyReport, bool);
  vtkGetMacro(AccuracyReport, bool);
  vtkBooleanMacro(AccuracyReport, bool);
  ///@}

  ///@{
  /**
   * Get a field of a row of the table of options: "property", of this class; "name", in Python;
   * "key", in the options of run_summary.json, empty for one that changes no echo; "title", of a
   * report; "words", there, for a value, which {} stands for, times "scale"; "argument", of the
   * command line, empty for none, its "metavar", "help", and "choices", separated by blanks. Empty for
   * another row or field.
   */
  static int GetNumberOfOptions();
  static std::string GetOptionText(int option, const std::string& field);
  ///@}

#ifndef __VTK_WRAP__
  /// Returns all options.
  const helios::RunOptions& GetData() const
  {
    return *this;
  }
#endif

protected:
  vtkHeliosRunOptions();
  ~vtkHeliosRunOptions() override;

private:
  vtkHeliosRunOptions(const vtkHeliosRunOptions&) = delete;
  void operator=(const vtkHeliosRunOptions&) = delete;
};

#endif
