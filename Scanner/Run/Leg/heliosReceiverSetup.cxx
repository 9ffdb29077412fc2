// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosReceiverSetup.h"

#include "heliosConstants.h"
#include "heliosEchoComparison.h"
#include "heliosRadiometry.h"
#include "heliosSurveyData.h"
#include "heliosTolerances.h"
#include "heliosWeather.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosPanoramicErrorModel.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosScanner.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

// Echoes that are compared, as in Docs/instrument.md.
constexpr double LeastShare = 0.02;
constexpr double MinimumThresholds = 2.0;
constexpr double Separation = 0.6; // separation of equal echoes, in c sigma
constexpr double FullReflectance = 0.5;

constexpr double ShareOfNoise = 0.1; // tolerances of Accuracy "instrument"

/// The instrument of a run: what the options override, and without noise nothing that is random
/// apart from the light.
vtkHeliosInstrumentData MakeInstrument(const ReceiverData& receiver, const RunOptions& options)
{
  vtkHeliosInstrumentData made = receiver;
  if (options.BinSize > 0.0)
  {
    // equal length with the bins of the survey
    const double bins = std::ceil(made.NumberOfBins * (made.BinSize / options.BinSize));
    made.NumberOfBins = static_cast<int>(std::min(bins, double(VTK_INT_MAX)));
    made.BinSize = options.BinSize;
  }
  if (options.IsWithout("atmosphere"))
  {
    made.AtmosphericExtinction = made.AtmosphericLidarRatio = 0.0;
    made.Weather.clear();
  }
  else if (!options.Weather.empty())
  {
    made.Weather = options.Weather;
  }
  if (options.ScatteringOrders > 0)
  {
    made.ScatteringOrders = options.ScatteringOrders;
  }
  if (options.IsWithout("scattering"))
  {
    made.ScatteringOrders = 1;
  }
  if (options.ScatteringPaths > 0)
  {
    made.ScatteringPaths = options.ScatteringPaths;
  }
  if (!options.Noise)
  {
    made.RangeAccuracy = made.RangeAccuracyPerMeter = made.RangeAccuracyAtThreshold = 0.0;
    made.AngleAccuracy = made.DetectorNoise = made.DarkCountRate = made.TimeJitter = 0.0;
  }
  return made;
}

/// Returns the standard deviation of ranges at the shortest range: no range has less noise [m].
double GetRangeNoise(const ReceiverData& receiver)
{
  return std::hypot(receiver.RangeAccuracy, receiver.RangeAccuracyPerMeter * receiver.RangeMin);
}

/// Returns the tolerances that are a share of the noise, of an instrument with range noise.
Tolerances FindInstrumentTolerances(const ReceiverData& receiver)
{
  Tolerances tolerances;
  tolerances.Range =
    std::clamp(ShareOfNoise * GetRangeNoise(receiver), MinimumRangeTolerance, LargestTolerance);
  const double full = receiver.RangeMin > 0.0
    ? MakeMatching(receiver, 0.0).GetFullAmplitude(receiver.RangeMin)
    : VTK_DOUBLE_MAX;
  tolerances.Energy = std::clamp(
    ShareOfNoise * receiver.DetectorNoise / full, DefaultEnergyTolerance, LargestTolerance);
  return tolerances;
}

void SetFixedSubRays(const RunOptions& options, vtkHeliosBeamSampler* sampler)
{
  const int pattern = options.GetPattern();
  const int size = vtkHeliosBeamSampler::FindPatternSize(pattern, options.NumberOfSubRays);
  sampler->SetPattern(pattern);
  switch (pattern)
  {
    case vtkHeliosBeamSampler::GAUSS_LEGENDRE:
      sampler->SetNumberOfRings(size);
      break;
    case vtkHeliosBeamSampler::CIRCLES:
      sampler->SetNumberOfCircles(size);
      break;
    default:
      sampler->SetNumberOfSubRays(size);
  }
}

void SetUpSampling(
  const ReceiverData& receiver, const RunOptions& options, vtkHeliosScanner* scanner)
{
  const BeamSampling sampling = ChooseSampling(receiver, options);
  scanner->SetRangeTolerance(sampling.RangeTolerance);
  scanner->SetEnergyTolerance(sampling.EnergyTolerance);
  scanner->SetSampling(sampling.IsAdaptive ? vtkHeliosScanner::TOLERANCE : vtkHeliosScanner::FIXED);
  if (options.MaximumSubRays > 0)
  {
    scanner->SetMaximumNumberOfSubRays(options.MaximumSubRays);
  }
  vtkHeliosBeamSampler* sampler = scanner->GetBeamSampler();
  if (options.NumberOfSubRays > 0)
  {
    SetFixedSubRays(options, sampler);
  }
  else if (!sampling.IsAdaptive)
  {
    sampler->SetPatternToCircles();
    sampler->SetNumberOfCircles(receiver.NumberOfCircles);
  }
}

/// Makes the detector of a scanner, or of the options.
vtkSmartPointer<vtkHeliosEchoDetector> MakeDetector(
  const ReceiverData& receiver, const RunOptions& options)
{
  auto detector = vtkSmartPointer<vtkHeliosEchoDetector>::Take(
    vtkHeliosEchoDetection::MakeDetector(ChooseDetector(receiver, options).c_str()));
  if (!detector)
  {
    detector.TakeReference(vtkHeliosEchoDetection::MakeDetector(nullptr));
  }
  return detector;
}

void SetPanoramicErrors(const PanoramicErrorData& data, vtkHeliosPanoramicErrorModel* model)
{
  model->SetHorizontalBeamOffset(data.BeamOffset[0]);
  model->SetVerticalBeamOffset(data.BeamOffset[1]);
  model->SetTransitOffset(data.TransitOffset);
  model->SetMirrorOffset(data.MirrorOffset);
  model->SetVerticalIndexOffset(data.VerticalIndexOffset);
  model->SetHorizontalBeamTilt(data.BeamTilt[0]);
  model->SetVerticalBeamTilt(data.BeamTilt[1]);
  model->SetMirrorTilt(data.MirrorTilt);
  model->SetTransitTilt(data.TransitTilt);
  model->SetRangeOffset(data.RangeOffset);
}

void SetUpErrors(
  const ErrorExpressions& errors, const PanoramicErrorData& panoramic, vtkHeliosScanner* scanner)
{
  if (!errors.IsEmpty() || !panoramic.IsEmpty())
  {
    vtkNew<vtkHeliosPanoramicErrorModel> model;
    SetPanoramicErrors(panoramic, model);
    model->SetRangeErrorExpression(errors.Range);
    model->SetDeflectionErrorExpression(errors.Deflection);
    model->SetHeadErrorExpression(errors.Head);
    model->SetZeroSinThreshold(errors.HeadZeroSinThreshold);
    model->SetRangeNoiseFactorExpression(errors.RangeNoiseFactor);
    model->SetTermName(vtkHeliosErrorModel::RANGE_ERROR, errors.RangeName);
    model->SetTermName(vtkHeliosErrorModel::DEFLECTION_ERROR, errors.DeflectionName);
    model->SetTermName(vtkHeliosErrorModel::HEAD_ERROR, errors.HeadName);
    model->SetTermName(vtkHeliosErrorModel::RANGE_NOISE_FACTOR, errors.RangeNoiseFactorName);
    scanner->SetErrorModel(model);
  }
}

} // namespace

//------------------------------------------------------------------------------
BeamSampling ChooseSampling(const ReceiverData& receiver, const RunOptions& options)
{
  const bool followsNoise = options.Accuracy == InstrumentAccuracy;
  const bool isAdaptive = options.RangeTolerance > 0.0 || options.EnergyTolerance > 0.0 ||
    followsNoise || receiver.NumberOfCircles == 0;
  const Tolerances own = followsNoise && HasRangeNoise(receiver)
    ? FindInstrumentTolerances(receiver)
    : Tolerances{ receiver.RangeTolerance, receiver.EnergyTolerance };
  return { options.NumberOfSubRays == 0 && isAdaptive,
    options.RangeTolerance > 0.0 ? options.RangeTolerance : own.Range,
    options.EnergyTolerance > 0.0 ? options.EnergyTolerance : own.Energy };
}

//------------------------------------------------------------------------------
const std::string& ChooseDetector(const ReceiverData& receiver, const RunOptions& options)
{
  return options.EchoDetector.empty() ? receiver.EchoDetector : options.EchoDetector;
}

//------------------------------------------------------------------------------
bool HasRangeNoise(const ReceiverData& receiver)
{
  return GetRangeNoise(receiver) > 0.0;
}

//------------------------------------------------------------------------------
EchoMatching MakeMatching(const ReceiverData& receiver, double energyTolerance)
{
  EchoMatching matching;
  Air air;
  const bool hasWeather =
    ParseWeather(receiver.Weather, receiver.Wavelength, air).IsOk() && air.LidarRatio > 0.0;
  const double extinction = hasWeather ? air.Extinction : receiver.AtmosphericExtinction;
  matching.Distance = Separation * SpeedOfLight * receiver.PulseLength / FwhmPerSigma;
  matching.Extinction = extinction >= 0.0
    ? extinction
    : AtmosphericExtinction(receiver.AtmosphericVisibility, receiver.Wavelength);
  const LidarEquation equation{ receiver.ReceiverDiameter, receiver.OpticalEfficiency, 0.0 };
  matching.FullAmplitude = receiver.AveragePower * equation(1.0, FullReflectance, 1.0);
  matching.LeastShare = std::max(LeastShare, energyTolerance);
  matching.LeastAmplitude = MinimumThresholds * receiver.DetectionThreshold;
  return matching;
}

//------------------------------------------------------------------------------
void SetUpReceiver(const ScannerData& data, const RunOptions& options, vtkHeliosScanner* scanner)
{
  const ReceiverData& receiver = data.Receiver;
  const vtkHeliosInstrumentData instrument = MakeInstrument(receiver, options);
  scanner->SetInstrument(instrument);
  scanner->SetMergeReturns(options.IsWithout("waveform"));
  vtkHeliosBeamSampler* sampler = scanner->GetBeamSampler();
  sampler->SetWavelength(instrument.Wavelength);
  sampler->SetBeamQualityFactor(instrument.BeamQualityFactor);
  sampler->SetDivergenceRatio(
    data.MinorBeamDivergence > 0.0 ? data.MinorBeamDivergence / data.BeamDivergence : 1.0);
  sampler->SetMajorAxisAngle(data.MajorAxisAngle);
  SetUpSampling(receiver, options, scanner);
  SetUpErrors(receiver.Errors, receiver.Panoramic, scanner);
  const vtkSmartPointer<vtkHeliosEchoDetector> detector = MakeDetector(receiver, options);
  detector->SetInstrument(instrument);
  scanner->SetEchoDetector(detector);
}

} // namespace helios
