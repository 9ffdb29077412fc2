// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialect: detectors, waveforms and errors.
#include "heliosStatus.h"
#include "heliosXmlTables.h"

#include "heliosSurveyData.h"
#include "heliosWeather.h"
#include "heliosXmlPulseShape.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosExpressionErrorModel.h"

namespace helios
{

using namespace rows;

namespace
{

constexpr auto Receiver = &ScannerData::Receiver;
constexpr XmlRange MechanicalOffset = { -1.0, 1.0 }; // [m]
constexpr XmlRange MechanicalTilt = { -10.0, 10.0 }; // [deg]

Status FindExpressionFault(const std::string& text)
{
  const std::string fault = vtkHeliosExpressionErrorModel::FindFault(text);
  return fault.empty() ? Status() : Status::Error(": " + fault);
}

} // namespace

//------------------------------------------------------------------------------
std::vector<std::string> GetEchoDetectorNames()
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkHeliosEchoDetection::GetNumberOfDetectors(); ++i)
  {
    names.emplace_back(vtkHeliosEchoDetection::GetDetectorName(i));
  }
  return names;
}

//------------------------------------------------------------------------------
Status FindFaultOfWeather(const std::string& text)
{
  const Status status = FindWeatherFault(text);
  return status.IsOk() ? status : Status::Error("; " + status.Message());
}

//------------------------------------------------------------------------------
std::vector<XmlElementRule> MakeReceiverRules()
{
  // clang-format off
  return {
  { "FWFSettings", "sampling, waveforms and echoes; that of a survey overrides that of its scanner",
    {
      Number("binSize_ns", "bin size of the waveform; 1 ns is 0.15 m of range").In("ns", InUnits(instrument::BinSize)).At<Receiver, &ReceiverData::BinSize>(),
      Integer("beamSampleQuality", "circles of sub-rays, a fixed count per pulse: 1, 7, 19, 37 ... sub-rays").In("", { 1.0, 64.0 }).Default("adaptive sampling").At<Receiver, &ReceiverData::NumberOfCircles>(),
      Number("rangeTolerance_m", "tolerance of ranges (95th percentile) in adaptive beam sampling").In("m", RangeTolerance).At<Receiver, &ReceiverData::RangeTolerance>(),
      Number("energyTolerance", "tolerance of amplitudes and of missed and invented echoes in adaptive beam sampling").In("", EnergyTolerance).At<Receiver, &ReceiverData::EnergyTolerance>(),
      Integer("scatteringOrders", "the most scatterings of light on its way back to the receiver; 1: light returns from what the beam meets").In("", InUnits(instrument::ScatteringOrders)).At<Receiver, &ReceiverData::ScatteringOrders>(),
      Integer("scatteringPaths", "paths of light drawn for each pulse that is scattered more than once; their standard error falls with the root of their number").In("", InUnits(instrument::ScatteringPaths)).At<Receiver, &ReceiverData::ScatteringPaths>(),
      Word("scatteringPhase", "leaf isotropic", "how turbid voxels scatter such light: as leaves of all orientations, or alike into all directions").Default("leaf").At<Receiver, &ReceiverData::ScatteringPhase>(),
      Word("echoDetector", "peak gaussian cfd leadingEdge photonCounting", "method of echo detection in waveforms").Default("peak").From(GetEchoDetectorNames).At<Receiver, &ReceiverData::EchoDetector>(),
      Text("pulseShape", "gaussian, helios, or a text file (CSV) of times [ns] and powers").Default("gaussian").Names(XmlFile::Beside).By<SetPulseShape, GetPulseShape, Receiver>(),
      Word("returnSelection", "all first last strongest firstAndLast", "the returns of a pulse that are kept").Default("all").At<Receiver, &ReceiverData::ReturnSelection>(),
      Number("winSize_ns", "an echo within this time of a higher one is discarded").In("ns", InUnits(instrument::PeakWindow)).At<Receiver, &ReceiverData::PeakWindow>(),
      Number("maxFullwaveRange_ns", "maximum length of the waveform; 0: as long as the target requires").In("ns", { 0.0, 1e9 }).At<Receiver, &ReceiverData::MaximumWaveformLength>(),
      Text("id", "never referenced").Ignored(),
      Text("name", "never referenced").Ignored(),
      Number("apertureDiameter_m", "not used; a warning if it differs from receiverDiameter_m of the scanner").In("m", { 0.0, 100.0 }),
      Integer("numFullwaveBins", "maximum number of bins of a waveform").In("", { 1.0, 1e6 }).Default("as many as needed").At<Receiver, &ReceiverData::NumberOfBins>(),
      Number("winSize", "winSize_ns, in bins").In("bins", { 0.0, 1e6 }).Default("0"),
      Number("apartureDiameter", "apertureDiameter_m in the spelling of the Java program").In("m", { 0.0, 100.0 }),
      Number("scannerEfficiency", "overrides opticalEfficiency of the scanner").In("", Share).Default("the scanner's").At<Receiver, &ReceiverData::OpticalEfficiency>(),
      Number("atmosphericVisibility", "overrides atmosphericVisibility_km of the scanner").In("km", InUnits(instrument::AtmosphericVisibility)).Default("the scanner's").At<Receiver, &ReceiverData::AtmosphericVisibility>(),
      Text("weather", "overrides weather of the scanner").Default("the scanner's").Checked(FindFaultOfWeather).At<Receiver, &ReceiverData::Weather>(),
      Number("scannerWaveLength", "overrides wavelength_nm of the scanner").In("nm", InUnits(instrument::Wavelength)).Default("the scanner's").At<Receiver, &ReceiverData::Wavelength>(),
      Number("beamDivergence_rad", "overrides beamDivergence_rad of the scanner").In("rad", Fraction).Default("the scanner's").At<&ScannerData::BeamDivergence>(),
      Number("pulseLength_ns", "overrides pulseLength_ns of the scanner").In("ns", PulseLength).Default("the scanner's").At<Receiver, &ReceiverData::PulseLength>(),
      Integer("numTimeBins", "samples of the emitted pulse, which has a closed form here").Later(),
      Number("minEchoWidth", "unit and use differ between Java versions").Later(),
      Number("peakEnergy", "the power of the pulse is averagePower_w").Later(),
    },
    {} },

  { "detectorSettings", "detector of a survey; overrides the values of the scanner",
    {
      Number("accuracy_m", "overrides accuracy_m of the scanner").In("m", InUnits(instrument::RangeAccuracy)).Default("the scanner's").At<Receiver, &ReceiverData::RangeAccuracy>(),
      Number("rangeMin_m", "overrides rangeMin_m of the scanner").In("m", NotNegative).Default("the scanner's").At<Receiver, &ReceiverData::RangeMin>(),
      Number("rangeMax_m", "overrides rangeMax_m of the scanner").In("m", NotNegative).Default("the scanner's").At<Receiver, &ReceiverData::RangeMax>(),
      Text("distanceMeasurementError", "factor of the range noise, an expression of the range t [m]").Default("1").Checked(FindExpressionFault).At<Receiver, &ReceiverData::Errors, &ErrorExpressions::RangeNoiseFactor>(),
    },
    {} },

  { "rangeError", "systematic error of ranges",
    {
      Text("expr", "an expression of the mirror angle THETA [rad], in metres").Required().Checked(FindExpressionFault).At<&ErrorExpressions::Range>(),
    },
    {} },

  { "deflectionError", "systematic error of the mirror angle",
    {
      Text("expr", "an expression of the mirror angle THETA [rad], in radians").Required().Checked(FindExpressionFault).At<&ErrorExpressions::Deflection>(),
    },
    {} },

  { "headError", "systematic error of the head angle",
    {
      Text("expr", "an expression of the mirror angle THETA [rad], in radians").Required().Checked(FindExpressionFault).At<&ErrorExpressions::Head>(),
      Number("zeroSinThreshold_deg", "minimum distance of THETA from multiples of 180 degrees").In("deg", { 0.0, 89.0 }).At<&ErrorExpressions::HeadZeroSinThreshold>(),
    },
    {} },

  { "panoramicError", "misalignments of a panoramic scanner, the model of NIST (Muralikrishnan et al. 2015)",
    {
      Number("horizontalBeamOffset_m", "x1n: offset of the beam from the shaft before the mirror, along y of the head").In("m", MechanicalOffset).At<&PanoramicErrorData::BeamOffset, 0>(),
      Number("verticalBeamOffset_m", "x1z: the same along z").In("m", MechanicalOffset).At<&PanoramicErrorData::BeamOffset, 1>(),
      Number("transitOffset_m", "x2: offset of the shaft from the axis of the head, along y").In("m", MechanicalOffset).At<&PanoramicErrorData::TransitOffset>(),
      Number("mirrorOffset_m", "x3: offset of the mirror along the shaft").In("m", MechanicalOffset).At<&PanoramicErrorData::MirrorOffset>(),
      Number("verticalIndexOffset_deg", "x4: added to the zenith angle, negative in the back face").In("deg", MechanicalTilt).At<&PanoramicErrorData::VerticalIndexOffset>(),
      Number("horizontalBeamTilt_deg", "x5n: tilt of the beam from the shaft before the mirror, towards y").In("deg", MechanicalTilt).At<&PanoramicErrorData::BeamTilt, 0>(),
      Number("verticalBeamTilt_deg", "x5z: the same towards z").In("deg", MechanicalTilt).At<&PanoramicErrorData::BeamTilt, 1>(),
      Number("mirrorTilt_deg", "x6: angle of the mirror to the shaft less the nominal one").In("deg", MechanicalTilt).At<&PanoramicErrorData::MirrorTilt>(),
      Number("transitTilt_deg", "x7: tilt of the shaft about y, its x end raised").In("deg", MechanicalTilt).At<&PanoramicErrorData::TransitTilt>(),
      Number("rangeOffset_m", "x10: the true range less the measured one").In("m", MechanicalOffset).At<&PanoramicErrorData::RangeOffset>(),
    },
    {} },
  };
  // clang-format on
}

} // namespace helios
