// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialect: surveys.
#include "heliosXmlTables.h"

#include "heliosSurveyData.h"
#include "heliosXmlPulseShape.h"

namespace helios
{

using namespace rows;

namespace
{

constexpr auto Receiver = &ScannerData::Receiver;
constexpr auto LegOffset = &SurveyData::LegOffset;
constexpr auto GpsStart = &SurveyData::GpsStart;

} // namespace

//------------------------------------------------------------------------------
std::vector<XmlElementRule> MakeSurveyRules()
{
  // clang-format off
  return {
  { "document", "the root of every file; its children may be mixed in any order",
    {},
    { Many("survey"), Many("surveyPlanner"), Many("scene"), Many("scanner"), Many("platform"), Many("scannerSettings"), Many("platformSettings"), Many("FWFSettings") } },

  { "survey", "a scene, the instrument and the legs. Of several surveys in a file the first is run",
    {
      Text("name", "title and name of the output folder").Default("the name of the file"),
      Text("rayCaster", "beam, embree, bvh, cgal or obbtree, if this build has it").Default("beam").At<&SurveyData::RayCaster>(),
      Number("rangeTolerance_m", "tolerance of ranges (95th percentile) in adaptive beam sampling").In("m", RangeTolerance).At<Receiver, &ReceiverData::RangeTolerance>(),
      Number("energyTolerance", "tolerance of amplitudes and of missed and invented echoes in adaptive beam sampling").In("", EnergyTolerance).At<Receiver, &ReceiverData::EnergyTolerance>(),
      Integer("scatteringOrders", "the most scatterings of light on its way back to the receiver; 1: light returns from what the beam meets").In("", InUnits(instrument::ScatteringOrders)).At<Receiver, &ReceiverData::ScatteringOrders>(),
      Integer("scatteringPaths", "paths of light drawn for each pulse that is scattered more than once; their standard error falls with the root of their number").In("", InUnits(instrument::ScatteringPaths)).At<Receiver, &ReceiverData::ScatteringPaths>(),
      Word("scatteringPhase", "leaf isotropic", "how turbid voxels scatter such light: as leaves of all orientations, or alike into all directions").Default("leaf").At<Receiver, &ReceiverData::ScatteringPhase>(),
      Word("echoDetector", "peak gaussian cfd leadingEdge photonCounting", "method of echo detection in waveforms").Default("peak").From(GetEchoDetectorNames).At<Receiver, &ReceiverData::EchoDetector>(),
      Text("pulseShape", "gaussian, helios, or a text file of times [ns] and powers").Default("gaussian").Names(XmlFile::Beside).By<SetPulseShape, GetPulseShape, Receiver>(),
      Word("returnSelection", "all first last strongest firstAndLast", "the returns of a pulse that are kept").Default("all").At<Receiver, &ReceiverData::ReturnSelection>(),
      Reference("scanner", "the instrument, file.xml#id, #id or id").Default("that of each leg"),
      Reference("platform", "the platform that carries it; interpolated: a trajectory from files").Default("that of each leg"),
      Reference("scene", "the scene to scan").Required(),
      Text("id", "surveys are never referenced").Ignored(),
      Integer("numRuns", "the caller decides; vtkhelios run runs once").Ignored(),
      Number("simSpeed", "speed of the display").Ignored(),
      Reference("defaultScannerSettings", "no program reads it; give the legs a template").Ignored(),
      Reference("basePlatform", "with platform=\"interpolated\": the platform whose mount and noise are used"),
      Word("rotationSpec", "ARINC 705|CANONICAL|NAVIGATION", "the angle convention of trajectory files in text columns").At<&SurveyData::Convention>(),
      Text("seed", "seed of the random numbers: an integer, YYYY-MM-DD hh:mm:ss or AUTO; --seed overrides it").Default("AUTO").At<&SurveyData::Seed>(),
      Text("gpsStartTime", "when the survey starts, at GpsTime 0: YYYY-MM-DD hh:mm:ss of UTC, or with a zone (2026-07-01T12:00:00+02:00), Unix seconds, or GPS seconds as gps:1467000000; --gps-start overrides it").Default("not known").By<SetGpsStart, GetGpsStart, GpsStart>(),
      Flag("legRandomOffset", "leg offset noise: whether each leg position gets one random offset").At<LegOffset, &LegOffsetData::IsOn>(),
      Number("legRandomOffsetMean", "mean of that offset").In("m").At<LegOffset, &LegOffsetData::Mean>(),
      Number("legRandomOffsetStdev", "standard deviation of that offset").In("m", NotNegative).At<LegOffset, &LegOffsetData::Deviation>(),
    },
    { Many("leg"), Many("scan"), One("FWFSettings"), One("detectorSettings"), One("pointCloudColor", "colour of the display").Ignored(), One("scannerMount"), Many("origin"), One("positionXNoise"), One("positionYNoise"), One("positionZNoise"), One("attitudeXNoise"), One("attitudeYNoise"), One("attitudeZNoise"), One("navigationError") } },
  };
  // clang-format on
}

} // namespace helios
