// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialect: scanners and their channels.
#include "heliosXmlTables.h"

#include "heliosSurveyData.h"

namespace helios
{

using namespace rows;

namespace
{

constexpr auto Receiver = &ScannerData::Receiver;
constexpr auto Prisms = &ScannerData::Prisms;

/// Catalogues give powers in nanowatts; receivedEnergyMin_W, too, despite its name.
constexpr double WattsPerNanowatt = 1e-9;
constexpr double NanowattsPerWatt = 1e9;

/// Returns the attributes of a scanner.
std::vector<XmlValueRule> MakeScannerValues()
{
  // clang-format off
  return {
    Text("id", "identifier for references"),
    Text("name", "a title").At<&ScannerData::Name>(),
    Word("optics", OpticsNames, "beam deflector").Required().At<&ScannerData::Type>(),
    Numbers("pulseFreqs_Hz", "supported pulse frequencies, the default first").In("Hz", Frequency).Default("that of the leg").At<&ScannerData::PulseFrequencies>(),
    Number("pulseLength_ns", "full width at half maximum").In("ns", PulseLength).At<Receiver, &ReceiverData::PulseLength>(),
    Number("beamDivergence_rad", "full angle at 1/e2").In("rad", Fraction).At<&ScannerData::BeamDivergence>(),
    Number("beamDivergenceMinor_rad", "elliptical beam: full angle at 1/e2 along the minor axis; beamDivergence_rad is that along the major axis, and that of a leg scales both; 0: a circular beam").In("rad", Fraction).At<&ScannerData::MinorBeamDivergence>(),
    Number("beamMajorAxis_deg", "elliptical beam: angle of the major axis about the beam, clockwise as the scanner sees it, from across the scan lines (spinning: from upright; risley: from x)").In("deg", Angle).At<&ScannerData::MajorAxisAngle>(),
    Number("wavelength_nm", "wavelength, at which reflectances are taken from spectra").In("nm", InUnits(instrument::Wavelength)).At<Receiver, &ReceiverData::Wavelength>(),
    Number("averagePower_w", "peak power of the pulse").In("W", InUnits(instrument::AveragePower)).At<Receiver, &ReceiverData::AveragePower>(),
    Number("opticalEfficiency", "transmission of the optics").In("", Share).At<Receiver, &ReceiverData::OpticalEfficiency>(),
    Number("receiverDiameter_m", "diameter of the receiver aperture").In("m", Aperture).At<Receiver, &ReceiverData::ReceiverDiameter>(),
    Number("atmosphericVisibility_km", "visibility, which determines the extinction").In("km", InUnits(instrument::AtmosphericVisibility)).At<Receiver, &ReceiverData::AtmosphericVisibility>(),
    Number("receivedEnergyMin_W", "detection threshold, the weakest echo; in nanowatts despite its name").In("nW", InUnits(instrument::DetectionThreshold, NanowattsPerWatt)).Scaled(WattsPerNanowatt).At<Receiver, &ReceiverData::DetectionThreshold>(),
    Number("accuracy_m", "standard deviation of the range").In("m", InUnits(instrument::RangeAccuracy)).At<Receiver, &ReceiverData::RangeAccuracy>(),
    Number("rangeMin_m", "minimum range").In("m", NotNegative).At<Receiver, &ReceiverData::RangeMin>(),
    Number("rangeMax_m", "maximum range").In("m", NotNegative).Default("no limit").At<Receiver, &ReceiverData::RangeMax>(),
    Integer("maxNOR", "maximum number of returns per pulse; 0: all").In("", { 0.0, instrument::LargestNumberOfReturns }).At<Receiver, &ReceiverData::MaximumNumberOfReturns>(),
    Integer("mtaZone", "zone of multiple-time-around ranges that all echoes are taken for; 1: each echo belongs to the last pulse emitted; 0: each is of its true pulse").In("", InUnits(instrument::MTAZone)).At<Receiver, &ReceiverData::MTAZone>(),
    Number("scanAngleMax_deg", "half of the angle that the mirror sweeps, or half angle of the cone").In("deg", HalfAngle).At<&ScannerData::ScanAngleMax>(),
    Number("scanAngleEffectiveMax_deg", "rotating: half of the vertical field of view").In("deg", HalfAngle).Default("scanAngleMax_deg").At<&ScannerData::ScanAngleEffectiveMax>(),
    Numbers("facetPitches_deg", "rotating: angle between the beam of each facet and the plane of the mirror, positive towards x").In("deg", FacetPitch).Default("facets are alike").At<&ScannerData::FacetPitches>(),
    Numbers("facetRolls_deg", "rotating: what each facet adds to the mirror angle").In("deg", FacetRoll).Default("0 each").At<&ScannerData::FacetRolls>(),
    Number("scanFreqMin_Hz", "minimum scan frequency").In("Hz", ScanFrequency).At<&ScannerData::ScanFrequencyMin>(),
    Number("scanFreqMax_Hz", "maximum scan frequency; 0: no limit").In("Hz", ScanFrequency).At<&ScannerData::ScanFrequencyMax>(),
    Number("headRotatePerSecMax_deg", "maximum head rotation speed").In("deg/s", { 0.0, 1e6 }).At<&ScannerData::HeadRotateSpeedMax>(),
    Number("deflectAngle_deg", "no program reads it").In("deg").Ignored(),
    Text("visModel", "model of the head in vtkhelios view, a file as for model of a platform; it rotates with the head").Default("a simple model").Names(XmlFile::Optional).At<&ScannerData::Model, &ModelData::Name>(),
    Number("beamQualityFactor", "M2 of the beam; without it the beam has no waist").In("", { 1.0, 1e4 }).At<Receiver, &ReceiverData::BeamQualityFactor>(),
    Number("atmosphericExtinction_1_m", "extinction; overrides the visibility").In("1/m", Extinction).Default("from the visibility").At<Receiver, &ReceiverData::AtmosphericExtinction>(),
    Number("lidarRatio_sr", "extinction of the air over its backscatter, which makes echoes; 0: no backscatter").In("sr", InUnits(instrument::AtmosphericLidarRatio)).At<Receiver, &ReceiverData::AtmosphericLidarRatio>(),
    Number("dropletDiameter_m", "with a lidar ratio: diameter of single drops, which return light at random places; 0: homogeneous air").In("m", InUnits(instrument::DropletDiameter)).At<Receiver, &ReceiverData::DropletDiameter>(),
    Text("weather", "fog, smoke or dust and the visibility in km, or rain, snow or sleet and mm/h, such as fog 0.2; overrides extinction and lidar ratio").Default("clear").Checked(FindFaultOfWeather).At<Receiver, &ReceiverData::Weather>(),
    Integer("maxSpecularEvents", "the most reflections and refractions of a path by mirrors, glass and water").In("", InUnits(instrument::MaximumSpecularEvents)).At<Receiver, &ReceiverData::MaximumSpecularEvents>(),
    Number("leastSpecularShare", "the least share of the energy of a sub-ray, out and back, with which such a path goes on").In("", InUnits(instrument::LeastSpecularShare)).At<Receiver, &ReceiverData::LeastSpecularShare>(),
    Number("detectorNoise_nW", "standard deviation of waveform noise").In("nW", InUnits(instrument::DetectorNoise, NanowattsPerWatt)).Scaled(WattsPerNanowatt).At<Receiver, &ReceiverData::DetectorNoise>(),
    Number("saturation_nW", "power to which the received signal is clipped; 0: no limit").In("nW", InUnits(instrument::SaturationPower, NanowattsPerWatt)).Scaled(WattsPerNanowatt).At<Receiver, &ReceiverData::SaturationPower>(),
    Number("deadTime_ns", "an echo within this time after a detected one is lost").In("ns", InUnits(instrument::DeadTime)).At<Receiver, &ReceiverData::DeadTime>(),
    Number("photonEfficiency", "photonCounting: probability that a received photon is detected").In("", InUnits(instrument::PhotonEfficiency)).At<Receiver, &ReceiverData::PhotonEfficiency>(),
    Number("darkCountRate_Hz", "photonCounting: mean number of counts without light in a second, within rangeMin_m and rangeMax_m").In("Hz", InUnits(instrument::DarkCountRate)).At<Receiver, &ReceiverData::DarkCountRate>(),
    Number("timeJitter_ns", "photonCounting: standard deviation of the times of counts").In("ns", InUnits(instrument::TimeJitter)).At<Receiver, &ReceiverData::TimeJitter>(),
    Number("solarIrradiance_W_m2_nm", "solar irradiance of the scene").In("W/m^2/nm", InUnits(instrument::SolarIrradiance)).At<Receiver, &ReceiverData::SolarIrradiance>(),
    Number("filterBandwidth_nm", "optical bandwidth of the receiver").In("nm", InUnits(instrument::FilterBandwidth)).At<Receiver, &ReceiverData::FilterBandwidth>(),
    Number("fieldOfView_rad", "field of view of the receiver, full angle").In("rad", InUnits(instrument::FieldOfView)).At<Receiver, &ReceiverData::FieldOfView>(),
    Number("accuracyPerMeter", "range noise proportional to the range").In("m/m", InUnits(instrument::RangeAccuracyPerMeter)).At<Receiver, &ReceiverData::RangeAccuracyPerMeter>(),
    Number("accuracyAtThreshold_m", "range noise of the weakest detectable echo").In("m", InUnits(instrument::RangeAccuracyAtThreshold)).At<Receiver, &ReceiverData::RangeAccuracyAtThreshold>(),
    Number("angleAccuracy_rad", "standard deviation of the beam's direction").In("rad", InUnits(instrument::AngleAccuracy)).At<Receiver, &ReceiverData::AngleAccuracy>(),
    Number("scanProduct", "oscillating: maximum of scan angle times scan frequency").In("deg Hz", Frequency).At<&ScannerData::ScanProduct>(),
    Word("scanPattern", "triangular sinusoidal", "oscillating: motion of the mirror").At<&ScannerData::IsSinusoidal>(),
    Integer("turningPulses", "oscillating, triangular: pulses during which the mirror reverses").In("", { 0.0, 1e9 }).At<&ScannerData::TurningPulses>(),
    Integer("numFibers", "line: number of fibres").In("", { 1.0, 1e6 }).At<&ScannerData::NumberOfFibers>(),
    Number("rotorFreq1_Hz", "risley: rotation frequency of the first prism; the sign is the direction").In("Hz", RotorFrequency).At<Prisms, 0, &PrismData::RotorFrequency>(),
    Number("rotorFreq2_Hz", "risley: rotation frequency of the second prism").In("Hz", RotorFrequency).At<Prisms, 1, &PrismData::RotorFrequency>(),
    Number("rotorFreq3_Hz", "risley: rotation frequency of the third prism").In("Hz", RotorFrequency).At<Prisms, 2, &PrismData::RotorFrequency>(),
    Number("rotorPhase1_deg", "risley: angle of the first prism at pulse 0").In("deg", Angle).At<Prisms, 0, &PrismData::RotorPhase>(),
    Number("rotorPhase2_deg", "risley: angle of the second prism at pulse 0").In("deg", Angle).At<Prisms, 1, &PrismData::RotorPhase>(),
    Number("rotorPhase3_deg", "risley: angle of the third prism at pulse 0").In("deg", Angle).At<Prisms, 2, &PrismData::RotorPhase>(),
    Number("angle1_deg", "risley: wedge angle of the first prism; the sign selects the inclined face; 0: no prism").In("deg", WedgeAngle).At<Prisms, 0, &PrismData::WedgeAngle>(),
    Number("angle2_deg", "risley: wedge angle of the second prism").In("deg", WedgeAngle).At<Prisms, 1, &PrismData::WedgeAngle>(),
    Number("angle3_deg", "risley: wedge angle of the third prism").In("deg", WedgeAngle).At<Prisms, 2, &PrismData::WedgeAngle>(),
    Number("refrIndex1", "risley: refractive index of the first prism").In("", RefractiveIndex).At<Prisms, 0, &PrismData::RefractiveIndex>(),
    Number("refrIndex2", "risley: refractive index of the second prism").In("", RefractiveIndex).At<Prisms, 1, &PrismData::RefractiveIndex>(),
    Number("refrIndex3", "risley: refractive index of the third prism").In("", RefractiveIndex).At<Prisms, 2, &PrismData::RefractiveIndex>(),
    Word("spin", "anticlockwise clockwise", "spinning: rotation of the head, seen from above").At<&ScannerData::IsClockwise>(),
    Number("spinStart_deg", "spinning: azimuth of the head at pulse 0, anticlockwise from y").In("deg", Angle).At<&ScannerData::StartAngle>(),
    Number("refrIndex_air", "risley: refractive index around the prisms").In("", RefractiveIndex).At<&ScannerData::AirRefractiveIndex>(),
  };
  // clang-format on
}

/// Makes the values of an instrument, with its place in the catalogue.
std::vector<XmlValueRule> MakeInstrumentValues()
{
  std::vector<XmlValueRule> values = MakeScannerValues();
  values.push_back(Text("maker", "for the list of vtkhelios info --scanners").Listed());
  values.push_back(
    Text("use", "terrestrial, mobile, unmanned or airborne, for the same list").Listed());
  return values;
}

/// Makes the values of a channel, which inherits values that it does not give.
std::vector<XmlValueRule> MakeChannelValues()
{
  std::vector<XmlValueRule> values = MakeScannerValues();
  for (XmlValueRule& value : values)
  {
    const std::string name = value.Name;
    if (name == "id")
    {
      value = Text("id", "used in file names if channels are split")
                .Default("its number")
                .At<&ScannerData::Channel>();
    }
    else if (name == "name")
    {
      value.Store = {};
    }
    else
    {
      value.DefaultText = "the scanner's";
      value.IsRequired = false;
    }
  }
  return values;
}

} // namespace

//------------------------------------------------------------------------------
std::vector<XmlElementRule> MakeScannerRules()
{
  // clang-format off
  return {
  { "scanner", "an instrument",
    MakeInstrumentValues(),
    { One("sources"), One("FWFSettings"), One("beamOrigin"), One("headRotateAxis"), One("incidentBeam"), One("beams"), One("channels"), One("rangeError"), One("deflectionError"), One("headError"), One("panoramicError") } },

  { "sources", "where the numbers of a scanner come from, for the list of vtkhelios info --scanners",
    {},
    { Many("source") } },

  { "source", "the source of some numbers",
    {
      Text("kind", "checked: read in the public copy that is named; sheet: on the data sheet; derived: by the sum that is given; assumed").Listed(),
      Text("of", "the attributes and elements with these numbers, with blanks between them; without it all").Listed(),
      Text("note", "the document and its year, the sum, or the reason").Listed(),
    },
    {} },

  { "channels", "the channels of a multi-channel instrument",
    {},
    { Many("channel") } },

  { "channel", "an emitter and its receiver; values not given are those of its scanner",
    MakeChannelValues(),
    { One("FWFSettings"), One("beamOrigin"), One("headRotateAxis"), One("incidentBeam"), One("beams"), One("rangeError"), One("deflectionError"), One("headError"), One("panoramicError") } },

  { "beams", "spinning: the beams in the order in which they fire; their numbers are the channels",
    {
      Text("file", "a CSV file with a line of names of columns, which are the attributes of beam, and a line per beam").Default("beam children").Names(XmlFile::Needed).At<&ScannerData::BeamFile>(),
    },
    { Many("beam") } },

  { "beam", "a beam of a spinning head",
    {
      Number("elevation_deg", "angle above the horizon").In("deg", Elevation).Required().At<&BeamData::Elevation>(),
      Number("azimuth_deg", "azimuth from the head's, anticlockwise").In("deg", Angle).At<&BeamData::Azimuth>(),
      Number("originOffset_m", "distance of its origin from the axis, in the direction of the head").In("m", BeamOffset).At<&BeamData::OriginOffset>(),
      Number("originHeight_m", "height of its origin").In("m", BeamOffset).At<&BeamData::OriginHeight>(),
      Number("firingTime_s", "time of its pulses after the start of a cycle, in which each beam fires once; negative: evenly").In("s", FiringTime).At<&BeamData::FiringTime>(),
    },
    {} },

  { "incidentBeam", "risley: direction of the beam into the first prism",
    {
      Number("x", "coordinate to the right, or east").Default("0"),
      Number("y", "coordinate forward, or north").Default("0"),
      Number("z", "coordinate up").Default("0"),
    },
    {} },
  };
  // clang-format on
}

} // namespace helios
