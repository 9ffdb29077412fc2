// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlRules.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace helios
{

namespace
{

constexpr auto Text = XmlKind::Text;
constexpr auto Real = XmlKind::Real;
constexpr auto Integer = XmlKind::Integer;
constexpr auto Boolean = XmlKind::Boolean;
constexpr auto RealList = XmlKind::RealList;
constexpr auto Vector = XmlKind::Vector;
constexpr auto Rotated = XmlKind::Rotation;
constexpr auto Reference = XmlKind::Reference;
constexpr auto Used = XmlUse::Used;
constexpr auto Ignored = XmlUse::Ignored;
constexpr auto Later = XmlUse::NotModelled;

// Sufficient for any survey; no division or square below overflows.
constexpr XmlRange Frequency = { 1e-3, 1e9, false };
constexpr XmlRange Distance = { 1e-3, 1e9, false };
constexpr XmlRange Seconds = { 1e-3, 1e9, false };
constexpr XmlRange Moment = { -1e12, 1e12, false };
constexpr XmlRange PulseLength = { 1e-2, 1e3, false };
constexpr XmlRange NotNegative = { 0.0, 1e12, false };
constexpr XmlRange Fraction = { 0.0, 1.0, false };
constexpr XmlRange Share = { 1e-6, 1.0, false };
constexpr XmlRange TimeStep = { 1e-9, 1.0, false };
constexpr XmlRange RangeTolerance = { 1e-6, 1.0, false };
constexpr XmlRange EnergyTolerance = { 1e-4, 1.0, false };
constexpr XmlRange Angle = { -360.0, 360.0, false };
constexpr XmlRange HalfAngle = { 0.0, 360.0, false };
constexpr XmlRange HeadAngle = { -1e6, 1e6, false };
constexpr XmlRange Column = { 0.0, 999.0, false };
constexpr XmlRange ScanFrequency = { 0.0, 1e6, false };
constexpr XmlRange RotorFrequency = { -1e6, 1e6, false };
constexpr XmlRange WedgeAngle = { -89.0, 89.0, false };
constexpr XmlRange RefractiveIndex = { 1.0, 10.0, false };
constexpr XmlRange Steps = { 1.0, 1e9, false };
constexpr XmlRange GridStep = { 1e-3, 1e6, false };
constexpr XmlRange RightAngle = { 0.0, 90.0, false };
constexpr XmlRange Elevation = { -90.0, 90.0, false };
constexpr bool Repeats = true;

// One row per name.
// clang-format off
const std::vector<XmlValueRule> NoiseValues = {
  { "type" },
  { "mean", Real },
  { "stdev", Real, Used, "", NotNegative },
  { "min", Real },
  { "max", Real },
  { "clipEnabled", Boolean },
  { "clipMin", Real },
  { "clipMax", Real },
  { "fixedLifespan", Integer, Used, "pulses", { 0.0, 1e9, false } },
};

const std::vector<XmlValueRule> ScannerValues = {
  { "id" },
  { "name" },
  { "optics" },
  { "pulseFreqs_Hz", RealList, Used, "Hz", Frequency },
  { "pulseLength_ns", Real, Used, "ns", PulseLength },
  { "beamDivergence_rad", Real, Used, "rad", Fraction },
  { "wavelength_nm", Real, Used, "nm", { 200.0, 20000.0, false } },
  { "averagePower_w", Real, Used, "W", NotNegative },
  { "opticalEfficiency", Real, Used, "", Share },
  { "receiverDiameter_m", Real, Used, "m", { 1e-6, 100.0, false } },
  { "atmosphericVisibility_km", Real, Used, "km", { 1e-3, 1e300, false } },
  { "receivedEnergyMin_W", Real, Used, "nW", { 0.0, 1e15, false } },
  { "accuracy_m", Real, Used, "m", { 0.0, 1e3, false } },
  { "rangeMin_m", Real, Used, "m", NotNegative },
  { "rangeMax_m", Real, Used, "m", NotNegative },
  { "maxNOR", Integer, Used, "", { 0.0, 255.0, false } },
  { "scanAngleMax_deg", Real, Used, "deg", HalfAngle },
  { "scanAngleEffectiveMax_deg", Real, Used, "deg", HalfAngle },
  { "scanFreqMin_Hz", Real, Used, "Hz", ScanFrequency },
  { "scanFreqMax_Hz", Real, Used, "Hz", ScanFrequency },
  { "headRotatePerSecMax_deg", Real, Used, "deg/s", { 0.0, 1e6, false } },
  { "deflectAngle_deg", Real, Ignored, "deg" },
  { "visModel" },
  { "beamQualityFactor", Real, Used, "", { 1.0, 1e4, false } },
  { "atmosphericExtinction_1_m", Real, Used, "1/m", { 0.0, 1e3, false } },
  { "detectorNoise_nW", Real, Used, "nW", { 0.0, 1e15, false } },
  { "solarIrradiance_W_m2_nm", Real, Used, "W/m^2/nm", { 0.0, 1e6, false } },
  { "filterBandwidth_nm", Real, Used, "nm", { 0.0, 1e6, false } },
  { "fieldOfView_rad", Real, Used, "rad", Fraction },
  { "accuracyPerMeter", Real, Used, "m/m", Fraction },
  { "accuracyAtThreshold_m", Real, Used, "m", { 0.0, 1e3, false } },
  { "angleAccuracy_rad", Real, Used, "rad", { 0.0, 0.1, false } },
  { "scanProduct", Real, Used, "deg Hz", Frequency },
  { "scanPattern" },
  { "turningPulses", Integer, Used, "", { 0.0, 1e9, false } },
  { "numFibers", Integer, Used, "", { 1.0, 1e6, false } },
  { "rotorFreq1_Hz", Real, Used, "Hz", RotorFrequency },
  { "rotorFreq2_Hz", Real, Used, "Hz", RotorFrequency },
  { "rotorFreq3_Hz", Real, Used, "Hz", RotorFrequency },
  { "angle1_deg", Real, Used, "deg", WedgeAngle },
  { "angle2_deg", Real, Used, "deg", WedgeAngle },
  { "angle3_deg", Real, Used, "deg", WedgeAngle },
  { "refrIndex1", Real, Used, "", RefractiveIndex },
  { "refrIndex2", Real, Used, "", RefractiveIndex },
  { "refrIndex3", Real, Used, "", RefractiveIndex },
  { "refrIndex_air", Real, Used, "", RefractiveIndex },
};

const std::vector<XmlElementRule> Rules = {
  { "document",
    {},
    { { "survey", Repeats },
      { "surveyPlanner", Repeats },
      { "scene", Repeats },
      { "scanner", Repeats },
      { "platform", Repeats },
      { "scannerSettings", Repeats },
      { "platformSettings", Repeats },
      { "FWFSettings", Repeats } } },

  { "survey",
    { { "name" },
      { "rayCaster" },
      { "rangeTolerance_m", Real, Used, "m", RangeTolerance },
      { "energyTolerance", Real, Used, "", EnergyTolerance },
      { "echoDetector" },
      { "pulseShape" },
      { "returnSelection" },
      { "scanner", Reference },
      { "platform", Reference },
      { "scene", Reference },
      { "id", Text, Ignored },
      { "numRuns", Integer, Ignored },
      { "simSpeed", Real, Ignored },
      { "defaultScannerSettings", Reference, Ignored },
      { "basePlatform", Reference, Used },
      { "rotationSpec", Text, Used },
      { "seed", Text, Used },
      { "legRandomOffset", Boolean, Used },
      { "legRandomOffsetMean", Real, Used, "m" },
      { "legRandomOffsetStdev", Real, Used, "m", NotNegative } },
    { { "leg", Repeats },
      { "scan", Repeats },
      { "FWFSettings" },
      { "detectorSettings" },
      { "pointCloudColor", false, Ignored },
      { "scannerMount" },
      { "origin", Repeats },
      { "positionXNoise" },
      { "positionYNoise" },
      { "positionZNoise" },
      { "attitudeXNoise" },
      { "attitudeYNoise" },
      { "attitudeZNoise" } } },

  { "surveyPlanner",
    { { "id" },
      { "name" },
      { "scene", Reference },
      { "platform", Reference },
      { "scanner", Reference },
      { "method" },
      { "pspRemoveOrder" },
      { "pspRemoveFirst" },
      { "minCoverage_percent", Real, Used, "%", { 1e-6, 100.0, false } },
      { "coverageOf" },
      { "gridSizePSP_m", Real, Used, "m", GridStep },
      { "gridSizePSPy_m", Real, Used, "m", GridStep },
      { "gridSizeVTP_m", Real, Used, "m", GridStep },
      { "vtpLines" },
      { "maxSlope_deg", Real, Used, "deg", RightAngle },
      { "groundOnly" },
      { "enclosed", Boolean },
      { "scannerHeight_m", Real, Used, "m", { 1e-6, 1e4, false } },
      { "hitTolerance_m", Real, Used, "m", { 1e-6, 1e3, false } },
      { "hitBehind", Boolean },
      { "scannerLimits", Boolean },
      { "rangeMin_m", Real, Used, "m", NotNegative },
      { "rangeMax_m", Real, Used, "m", Distance },
      { "elevationMin_deg", Real, Used, "deg", Elevation },
      { "elevationMax_deg", Real, Used, "deg", Elevation },
      { "maxIncidence_deg", Real, Used, "deg", RightAngle },
      { "minPointDensity_1_m2", Real, Used, "1/m^2", NotNegative },
      { "areaWeights", Boolean },
      { "minOverlap_percent", Real, Used, "%", { 0.0, 99.9, false } },
      { "timeLimit_s", Real, Used, "s", Seconds },
      { "interactive", Boolean, Ignored } },
    { { "scannerSettings" } } },

  { "leg",
    { { "scanner", Reference },
      { "platform", Reference },
      { "x", Real, Used, "m" },
      { "y", Real, Used, "m" },
      { "z", Real, Used, "m" },
      { "maxDuration_s", Real, Used, "s", { -1.0, 1e12, false } },
      { "id", Text, Ignored },
      { "stripId", Text, Used } },
    { { "platformSettings" }, { "scannerSettings" }, { "maxDuration_s" } } },

  { "scan",
    { { "scanner", Reference }, { "platform", Reference }, { "id", Text, Ignored } },
    { { "scannerRotation" }, { "leg", Repeats } } },

  { "scannerRotation",
    { { "axis", Text, Ignored },
      { "angle", Real, Ignored, "deg" },
      { "start", Real, Used, "deg", HeadAngle },
      { "end", Real, Used, "deg", HeadAngle } },
    {} },

  { "origin", { { "x", Real, Used, "m" }, { "y", Real, Used, "m" }, { "z", Real, Used, "m" } }, {} },

  { "platformSettings",
    { { "id" },
      { "name", Text, Ignored },
      { "template", Reference },
      { "x", Real, Used, "m" },
      { "y", Real, Used, "m" },
      { "z", Real, Used, "m" },
      { "crs" },
      { "onGround", Boolean },
      { "movePerSec_m", Real, Used, "m/s", { -1e9, 1e9, false } },
      { "stopAndTurn", Boolean, Used },
      { "smoothTurn", Boolean, Used },
      { "slowdownEnabled", Boolean, Used },
      { "yawAtDeparture_deg", Real, Used, "deg", Angle },
      { "trajectory", Text, Used },
      { "trajectory_seperator", Text, Used },
      { "trajectory_separator", Text, Used },
      { "tIndex", Integer, Used, "", Column },
      { "rollIndex", Integer, Used, "", Column },
      { "pitchIndex", Integer, Used, "", Column },
      { "yawIndex", Integer, Used, "", Column },
      { "xIndex", Integer, Used, "", Column },
      { "yIndex", Integer, Used, "", Column },
      { "zIndex", Integer, Used, "", Column },
      { "interpolationDomain", Text, Used },
      { "toRadians", Boolean, Used },
      { "syncGPSTime", Boolean, Used },
      { "slopeFilterThreshold", Real, Used, "", NotNegative },
      { "tStart", Real, Used, "s", Moment },
      { "tEnd", Real, Used, "s", Moment },
      { "teleportToStart", Boolean, Used } },
    {} },

  { "scannerSettings",
    { { "id" },
      { "name", Text, Ignored },
      { "template", Reference },
      { "active", Boolean },
      { "pulseFreq_hz", Real, Used, "Hz", Frequency },
      { "scanFreq_hz", Real, Used, "Hz", ScanFrequency },
      { "scanAngle_deg", Real, Used, "deg", HalfAngle },
      { "verticalAngleMin_deg", Real, Used, "deg", Angle },
      { "verticalAngleMax_deg", Real, Used, "deg", Angle },
      { "headRotatePerSec_deg", Real, Used, "deg/s", HeadAngle },
      { "headRotateStart_deg", Real, Used, "deg", HeadAngle },
      { "headRotateStop_deg", Real, Used, "deg", HeadAngle },
      { "beamDivergence_rad", Real, Used, "rad", Fraction },
      { "beamDivergenceRad", Real, Used, "rad", Fraction },
      { "trajectoryTimeInterval_s", Real, Used, "s", NotNegative },
      { "maxDuration_s", Real, Used, "s", { -1.0, 1e12, false } },
      { "verticalResolution_deg", Real, Used, "deg", HalfAngle },
      { "horizontalResolution_deg", Real, Used, "deg", HalfAngle },
      { "opticsWarmupPhase_s", Real, Used, "s", { 0.0, 1e6, false } },
      { "beamSampleQuality", Integer, Later } },
    { { "maxDuration_s" } } },

  { "FWFSettings",
    { { "binSize_ns", Real, Used, "ns", { 1e-4, 1e3, false } },
      { "beamSampleQuality", Integer, Used, "", { 1.0, 64.0, false } },
      { "rangeTolerance_m", Real, Used, "m", RangeTolerance },
      { "energyTolerance", Real, Used, "", EnergyTolerance },
      { "echoDetector" },
      { "pulseShape" },
      { "returnSelection" },
      { "winSize_ns", Real, Used, "ns", { 0.0, 1e6, false } },
      { "maxFullwaveRange_ns", Real, Used, "ns", { 0.0, 1e9, false } },
      { "id", Text, Ignored },
      { "name", Text, Ignored },
      { "apertureDiameter_m", Real, Used, "m", { 0.0, 100.0, false } },
      { "numFullwaveBins", Integer, Used, "", { 1.0, 1e6, false } },
      { "winSize", Real, Used, "bins", { 0.0, 1e6, false } },
      { "apartureDiameter", Real, Used, "m", { 0.0, 100.0, false } },
      { "scannerEfficiency", Real, Used, "", Share },
      { "atmosphericVisibility", Real, Used, "km", { 1e-3, 1e300, false } },
      { "scannerWaveLength", Real, Used, "nm", { 200.0, 20000.0, false } },
      { "beamDivergence_rad", Real, Used, "rad", Fraction },
      { "pulseLength_ns", Real, Used, "ns", PulseLength },
      { "numTimeBins", Integer, Later },
      { "minEchoWidth", Real, Later },
      { "peakEnergy", Real, Later } },
    {} },

  { "detectorSettings",
    { { "accuracy_m", Real, Used, "m", { 0.0, 1e3, false } },
      { "rangeMin_m", Real, Used, "m", NotNegative },
      { "rangeMax_m", Real, Used, "m", NotNegative },
      { "distanceMeasurementError" } },
    {} },

  { "rangeError", { { "expr" } }, {} },

  { "deflectionError", { { "expr" } }, {} },

  { "headError",
    { { "expr" }, { "zeroSinThreshold_deg", Real, Used, "deg", { 0.0, 89.0, false } } },
    {} },

  { "scanner",
    ScannerValues,
    { { "FWFSettings" },
      { "beamOrigin" },
      { "headRotateAxis" },
      { "incidentBeam" },
      { "channels" },
      { "rangeError" },
      { "deflectionError" },
      { "headError" } } },

  { "channels", {}, { { "channel", Repeats } } },

  { "channel",
    ScannerValues,
    { { "FWFSettings" },
      { "beamOrigin" },
      { "headRotateAxis" },
      { "incidentBeam" },
      { "rangeError" },
      { "deflectionError" },
      { "headError" } } },

  { "incidentBeam", { { "x", Real }, { "y", Real }, { "z", Real } }, {} },

  { "platform",
    { { "id" },
      { "name" },
      { "type" },
      { "model" },
      { "visModel" },
      { "drag", Real, Later, "", { 0.0, 1e3, true } },
      { "engine_max_force", Real, Later, "", { 0.0, 1e6, true } },
      { "speedup_magnitude", Real, Later, "1/s", { 0.0, 1e3, true } },
      { "slowdown_magnitude", Real, Later, "1/s", { 0.0, 1e3, true } },
      { "slowdown_distance", Real, Later, "m", NotNegative },
      { "base_pitch_deg", Real, Used, "deg", { -60.0, 60.0, false } },
      { "roll_speed_deg", Real, Used, "deg/s", { 1e-3, 1e4, false } },
      { "pitch_speed_deg", Real, Used, "deg/s", { 1e-3, 1e4, false } },
      { "yaw_speed_deg", Real, Used, "deg/s", { 1e-3, 1e4, false } },
      { "roll_offset_deg", Real, Used, "deg", { 1e-3, 85.0, false } },
      { "pitch_offset_deg", Real, Used, "deg", { 1e-3, 85.0, false } } },
    { { "scannerMount" },
      { "positionXNoise" },
      { "positionYNoise" },
      { "positionZNoise" },
      { "attitudeXNoise" },
      { "attitudeYNoise" },
      { "attitudeZNoise" } } },

  { "positionXNoise", NoiseValues, {} },
  { "positionYNoise", NoiseValues, {} },
  { "positionZNoise", NoiseValues, {} },
  { "attitudeXNoise", NoiseValues, {} },
  { "attitudeYNoise", NoiseValues, {} },
  { "attitudeZNoise", NoiseValues, {} },

  { "scannerMount",
    { { "x", Real, Used, "m" },
      { "y", Real, Used, "m" },
      { "z", Real, Used, "m" },
      { "rotations" } },
    { { "rot", Repeats } } },

  { "beamOrigin",
    { { "x", Real, Used, "m" },
      { "y", Real, Used, "m" },
      { "z", Real, Used, "m" },
      { "rotations" } },
    { { "rot", Repeats } } },

  { "headRotateAxis", { { "x", Real }, { "y", Real }, { "z", Real } }, {} },

  { "rot", { { "axis" }, { "angle_deg", Real, Used, "deg", { -1e6, 1e6, false } } }, {} },

  { "scene",
    { { "id" },
      { "name" },
      { "crs" },
      { "dynStep", Integer, Used, "", Steps },
      { "dynTimeStep", Real, Used, "s", TimeStep } },
    { { "part", Repeats },
      { "sunDir", false, Ignored },
      { "sky", false, Ignored },
      { "skybox", false, Ignored } } },

  { "part",
    { { "id" },
      { "name", Text, Ignored },
      { "dynStep", Integer, Used, "", Steps },
      { "dynTimeStep", Real, Used, "s", TimeStep },
      { "kdtDynStep", Integer, Used, "", Steps },
      { "kdtDynTimeStep", Real, Used, "s", TimeStep } },
    { { "filter", Repeats },
      { "color", false, Ignored },
      { "swap", Repeats },
      { "dmotion", Repeats } } },

  { "dmotion",
    { { "id" }, { "loop", Integer, Used, "", { 0.0, 1e9, false } }, { "next" } },
    { { "motion", Repeats } } },

  { "motion",
    { { "type" },
      { "vec", Vector, Used, "m" },
      { "axis", Vector },
      { "angle", Real, Used, "deg", { -1e6, 1e6, false } },
      { "center", Vector, Used, "m" },
      { "ortho", Vector },
      { "shift", Vector, Used, "m" },
      { "glide", Real, Used, "m" },
      { "selfMode", Boolean },
      { "autoCRS", Real, Ignored } },
    {} },

  { "swap",
    { { "swapStep", Integer, Used, "epochs", { 1.0, 9999.0, false } },
      { "keepCRS", Boolean },
      { "force_null", Boolean },
      { "swapIndices", Text, Later } },
    { { "filter", Repeats } } },

  { "filter", { { "type" } }, { { "param", Repeats } } },

  { "param", { { "type" }, { "key" }, { "value" }, { "rotations" } }, { { "rot", Repeats } } },

  { "filter:objloader",
    { { "filepath" },
      { "efilepath" },
      { "up" },
      { "recomputeVertexNormals", Boolean, Ignored },
      { "castShadows", Boolean, Ignored },
      { "receiveShadows", Boolean, Ignored } },
    {} },

  { "filter:geotiffloader",
    { { "filepath" }, { "efilepath" }, { "matfile" }, { "matname" } },
    {} },

  { "filter:xyzloader",
    { { "filepath" },
      { "efilepath" },
      { "separator" },
      { "voxelSize", Real, Used, "m", { 1e-6, 1e6, false } },
      { "maxColorValue", Real, Ignored },
      { "normalXIndex", Integer, Used, "", Column },
      { "normalYIndex", Integer, Used, "", Column },
      { "normalZIndex", Integer, Used, "", Column },
      { "rgbRIndex", Integer, Ignored },
      { "rgbGIndex", Integer, Ignored },
      { "rgbBIndex", Integer, Ignored },
      { "estimateNormals", Integer, Used, "", { 0.0, 1e9, false } },
      { "defaultNormal", Vector },
      { "snapNeighborNormal", Boolean },
      { "sparse", Boolean, Ignored },
      { "matfile" },
      { "matname" },
      { "randomMaterials", Integer, Used, "", { 0.0, 999999.0, false } },
      { "randomRange", Real, Used, "", { 0.0, 1.0, false } } },
    {} },

  { "filter:detailedvoxels",
    { { "filepath" },
      { "efilepath" },
      { "intersectionMode" },
      { "intersectionArgument", Real, Used, "", { 0.0, 100.0, false } },
      { "randomShift", Boolean },
      { "ladlut" },
      { "matfile" },
      { "matname" },
      { "randomMaterials", Integer, Used, "", { 0.0, 999999.0, false } },
      { "randomRange", Real, Used, "", { 0.0, 1.0, false } } },
    {} },

  { "filter:crs", { { "source" }, { "target" } }, {} },

  { "filter:repair", {}, {} },

  { "filter:simplify", { { "maximumDistance", Real, Used, "m", { 1e-9, 1e6, false } } }, {} },

  { "filter:scale", { { "scale", Real, Used, "", { 1e-9, 1e9, false } } }, {} },

  { "filter:translate",
    { { "offset", Vector, Used, "m" }, { "onGround", Integer, Used, "", { -1e9, 1e9, false } } },
    {} },

  { "filter:rotate", { { "rotation", Rotated } }, {} },
};
// clang-format on

template <typename RuleT>
const RuleT* FindByName(const std::vector<RuleT>& rules, const std::string& name)
{
  const auto found = std::find_if(
    rules.begin(), rules.end(), [&name](const RuleT& rule) { return name == rule.Name; });
  return found != rules.end() ? &*found : nullptr;
}

template <typename RuleT>
std::string FindNearest(const std::vector<RuleT>& rules, const std::string& name)
{
  std::vector<std::string> names;
  for (const RuleT& rule : rules)
  {
    names.emplace_back(rule.Name);
  }
  return FindNearestName(name, names);
}

/// Levenshtein's distance: the number of letters to insert, delete or replace.
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ row[j] + 1, row[j + 1] + 1, replaced });
    }
  }
  return row.back();
}

} // namespace

//------------------------------------------------------------------------------
const XmlValueRule* XmlElementRule::FindValue(const std::string& name) const
{
  return FindByName(this->Values, name);
}

//------------------------------------------------------------------------------
const XmlChildRule* XmlElementRule::FindChild(const std::string& name) const
{
  return FindByName(this->Children, name);
}

//------------------------------------------------------------------------------
std::string XmlElementRule::FindNearestValue(const std::string& name) const
{
  return FindNearest(this->Values, name);
}

//------------------------------------------------------------------------------
std::string XmlElementRule::FindNearestChild(const std::string& name) const
{
  return FindNearest(this->Children, name);
}

//------------------------------------------------------------------------------
std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

//------------------------------------------------------------------------------
const XmlElementRule* FindXmlRule(const std::string& element)
{
  return FindByName(Rules, element);
}

//------------------------------------------------------------------------------
const std::vector<XmlElementRule>& GetXmlRules()
{
  return Rules;
}

//------------------------------------------------------------------------------
std::string FindNearestName(const std::string& name, const std::vector<std::string>& names)
{
  const std::string wanted = ToLower(name);
  std::size_t best = std::max<std::size_t>(2, name.size() / 3) + 1;
  std::string nearest;
  for (const std::string& candidate : names)
  {
    const std::size_t distance = EditDistance(wanted, ToLower(candidate));
    if (distance < best && distance < candidate.size())
    {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

} // namespace helios
