// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosReceiverSetup.h"

#include "heliosConstants.h"
#include "heliosEchoComparison.h"
#include "heliosRadiometry.h"
#include "heliosSurveyData.h"
#include "heliosWeather.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosExpressionErrorModel.h"
#include "vtkHeliosGaussianDecomposition.h"
#include "vtkHeliosPanoramicErrorModel.h"
#include "vtkHeliosPeakDetector.h"
#include "vtkHeliosPhotonCountingDetector.h"
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
constexpr double LeastThresholds = 2.0;
constexpr double Separation = 0.6; // of the same echoes, in c sigma
constexpr double FullReflectance = 0.5;

void SetUpRadiometry(const ScannerData& data, const RunOptions& options, vtkHeliosScanner* scanner)
{
  const ReceiverData& receiver = data.Receiver;
  scanner->SetPulseLength(data.PulseLength);
  scanner->SetAveragePower(data.AveragePower);
  scanner->SetWavelength(data.Wavelength);
  scanner->SetOpticalEfficiency(data.OpticalEfficiency);
  scanner->SetReceiverDiameter(data.ReceiverDiameter);
  scanner->SetAtmosphericVisibility(data.AtmosphericVisibility);
  const bool hasAir = !options.IsWithout("atmosphere");
  scanner->SetAtmosphericExtinction(hasAir ? receiver.Extinction : 0.0);
  scanner->SetAtmosphericLidarRatio(hasAir ? receiver.LidarRatio : 0.0);
  scanner->SetDropletDiameter(receiver.DropletDiameter);
  scanner->SetMaximumSpecularEvents(receiver.MaximumSpecularEvents);
  scanner->SetLeastSpecularShare(receiver.LeastSpecularShare);
  scanner->SetWeather(!hasAir ? "" : options.Weather.empty() ? receiver.Weather : options.Weather);
  scanner->SetSolarIrradiance(receiver.SolarIrradiance);
  scanner->SetFilterBandwidth(receiver.FilterBandwidth);
  scanner->SetFieldOfView(receiver.FieldOfView);
  if (receiver.PulseShape == "sampled")
  {
    scanner->SetPulseShapeToSampled();
    scanner->SetPulseFileName(receiver.PulseFile.c_str());
  }
  else if (receiver.PulseShape == "helios")
  {
    scanner->SetPulseShapeToHelios();
  }
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

void SetUpWaveforms(
  const ReceiverData& receiver, const RunOptions& options, vtkHeliosScanner* scanner)
{
  const double size = options.BinSize > 0.0 ? options.BinSize : receiver.BinSize;
  scanner->SetBinSize(size);
  scanner->SetMaximumWaveformLength(receiver.MaximumLength);
  // as long as with the bins of the survey
  const double bins = std::ceil(receiver.NumberOfBins * (receiver.BinSize / size));
  scanner->SetNumberOfBins(static_cast<int>(std::min(bins, double(VTK_INT_MAX))));
}

void SetUpReturns(const ScannerData& data, const RunOptions& options, vtkHeliosScanner* scanner)
{
  const std::string& selection = data.Receiver.ReturnSelection;
  scanner->SetMergeReturns(options.IsWithout("waveform"));
  scanner->SetRangeMin(data.RangeMin);
  scanner->SetRangeMax(data.RangeMax);
  scanner->SetMTAZone(data.MTAZone);
  scanner->SetMaximumNumberOfReturns(data.MaximumNumberOfReturns);
  scanner->SetReturnSelection(selection == "first" ? vtkHeliosScanner::FIRST
      : selection == "last"                        ? vtkHeliosScanner::LAST
      : selection == "strongest"                   ? vtkHeliosScanner::STRONGEST
      : selection == "firstAndLast"                ? vtkHeliosScanner::FIRST_AND_LAST
                                                   : vtkHeliosScanner::ALL);
}

void SetUpNoise(const ScannerData& data, bool hasNoise, vtkHeliosScanner* scanner)
{
  const ReceiverData& receiver = data.Receiver;
  const double factor = hasNoise ? 1.0 : 0.0;
  scanner->SetRangeAccuracy(factor * data.Accuracy);
  scanner->SetRangeAccuracyPerMeter(factor * receiver.AccuracyPerMeter);
  scanner->SetRangeAccuracyAtThreshold(factor * receiver.AccuracyAtThreshold);
  scanner->SetAngleAccuracy(factor * receiver.AngleAccuracy);
  scanner->SetDetectorNoise(factor * receiver.DetectorNoise);
  scanner->SetSaturationPower(receiver.Saturation);
}

/// Sets the values of a photon-counting receiver; what is random apart from the light is noise.
void SetUpPhotons(const ScannerData& data, bool hasNoise, vtkHeliosPhotonCountingDetector* photons)
{
  const double factor = hasNoise ? 1.0 : 0.0;
  photons->SetWavelength(data.Wavelength);
  photons->SetDetectionEfficiency(data.Receiver.PhotonEfficiency);
  photons->SetDarkCountRate(factor * data.Receiver.DarkCountRate);
  photons->SetTimeJitter(factor * data.Receiver.TimeJitter);
}

/// Makes the detector of a scanner, or of the options.
vtkSmartPointer<vtkHeliosEchoDetector> MakeDetector(
  const ScannerData& data, const RunOptions& options)
{
  const double window = data.Receiver.PeakWindow; // how far from a higher peak the next may be [ns]
  const std::string& name =
    options.EchoDetector.empty() ? data.Receiver.EchoDetector : options.EchoDetector;
  auto detector = vtkSmartPointer<vtkHeliosEchoDetector>::Take(
    vtkHeliosEchoDetection::MakeDetector(name.c_str()));
  if (!detector)
  {
    detector.TakeReference(vtkHeliosEchoDetection::MakeDetector(nullptr));
  }
  if (auto* peak = vtkHeliosPeakDetector::SafeDownCast(detector))
  {
    peak->SetMinimumSeparation(window);
  }
  if (auto* gaussian = vtkHeliosGaussianDecomposition::SafeDownCast(detector))
  {
    gaussian->SetMinimumSeparation(window);
  }
  if (auto* photons = vtkHeliosPhotonCountingDetector::SafeDownCast(detector))
  {
    SetUpPhotons(data, options.Noise, photons);
  }
  detector->SetDetectionThreshold(data.DetectionThreshold);
  detector->SetDeadTime(data.Receiver.DeadTime);
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
  const bool hasTolerance = options.RangeTolerance > 0.0 || options.EnergyTolerance > 0.0;
  const bool isFixed =
    options.NumberOfSubRays > 0 || (receiver.NumberOfCircles > 0 && !hasTolerance);
  return { !isFixed,
    options.RangeTolerance > 0.0 ? options.RangeTolerance : receiver.RangeTolerance,
    options.EnergyTolerance > 0.0 ? options.EnergyTolerance : receiver.EnergyTolerance };
}

//------------------------------------------------------------------------------
EchoMatching MakeMatching(const ScannerData& channel, double energyTolerance)
{
  EchoMatching matching;
  Air air;
  const bool hasWeather =
    ParseWeather(channel.Receiver.Weather, channel.Wavelength, air).IsOk() && air.LidarRatio > 0.0;
  const double extinction = hasWeather ? air.Extinction : channel.Receiver.Extinction;
  matching.Distance = Separation * SpeedOfLight * channel.PulseLength / FwhmPerSigma;
  matching.Extinction = extinction >= 0.0
    ? extinction
    : AtmosphericExtinction(channel.AtmosphericVisibility, channel.Wavelength);
  const LidarEquation equation{ channel.ReceiverDiameter, channel.OpticalEfficiency, 0.0 };
  matching.FullAmplitude = channel.AveragePower * equation(1.0, FullReflectance, 1.0);
  matching.LeastShare = std::max(LeastShare, energyTolerance);
  matching.LeastAmplitude = LeastThresholds * channel.DetectionThreshold;
  return matching;
}

//------------------------------------------------------------------------------
void SetUpReceiver(const ScannerData& data, const RunOptions& options, vtkHeliosScanner* scanner)
{
  SetUpRadiometry(data, options, scanner);
  vtkHeliosBeamSampler* sampler = scanner->GetBeamSampler();
  sampler->SetWavelength(data.Wavelength);
  sampler->SetBeamQualityFactor(data.Receiver.BeamQualityFactor);
  sampler->SetDivergenceRatio(
    data.MinorBeamDivergence > 0.0 ? data.MinorBeamDivergence / data.BeamDivergence : 1.0);
  sampler->SetMajorAxisAngle(data.MajorAxisAngle);
  SetUpSampling(data.Receiver, options, scanner);
  SetUpWaveforms(data.Receiver, options, scanner);
  SetUpReturns(data, options, scanner);
  SetUpNoise(data, options.Noise, scanner);
  SetUpErrors(data.Receiver.Errors, data.Receiver.Panoramic, scanner);
  scanner->SetEchoDetector(MakeDetector(data, options));
}

} // namespace helios
