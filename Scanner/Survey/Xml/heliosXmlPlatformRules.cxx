// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialect: platforms, poses and noise.
#include "heliosXmlTables.h"

#include "heliosSurveyData.h"

namespace helios
{

using namespace rows;

namespace
{

constexpr auto Vehicle = &PlatformData::Vehicle;

/// The types in the order of the choices.
constexpr int PlatformTypes[] = { int(PlatformType::Static), int(PlatformType::Static),
  int(PlatformType::LinearPath), int(PlatformType::GroundVehicle), int(PlatformType::Multicopter) };

/// Range of vtkHeliosPlatformNoise::SetSlowError().
constexpr XmlRange CorrelationTime = { 1e-3, 1e9 };

/// Returns the attributes of a noise.
std::vector<XmlValueRule> MakeNoiseValues()
{
  // clang-format off
  return {
    Word("type", "~NORMAL UNIFORM", "distribution").At<&NoiseData::IsUniform>(),
    Number("mean", "mean of NORMAL").At<&NoiseData::Mean>(),
    Number("stdev", "standard deviation of NORMAL").In("", NotNegative).At<&NoiseData::Deviation>(),
    Number("min", "minimum of UNIFORM").At<&NoiseData::Low>(),
    Number("max", "maximum of UNIFORM").At<&NoiseData::High>(),
    Flag("clipEnabled", "whether values are clamped").At<&NoiseData::IsClipped>(),
    Number("clipMin", "lower limit").At<&NoiseData::ClipLow>(),
    Number("clipMax", "upper limit").At<&NoiseData::ClipHigh>(),
    Integer("fixedLifespan", "number of pulses for which a value is kept; 0: all").In("pulses", { 0.0, 1e9 }).At<&NoiseData::Lifespan>(),
  };
  // clang-format on
}

} // namespace

//------------------------------------------------------------------------------
std::vector<XmlElementRule> MakePlatformRules()
{
  // clang-format off
  return {
  { "platform", "the carrier of the scanner",
    {
      Text("id", "identifier for references").At<&PlatformData::Id>(),
      Text("name", "a title").At<&PlatformData::Name>(),
      Word("type", "static dummy linearpath groundvehicle multicopter", "type of motion").Meaning(PlatformTypes).At<&PlatformData::Type>(),
      Text("model", "model for vtkhelios view: an OBJ file in m, x right, y forward, z up; not used in simulations").Default("a simple model").Names(XmlFile::Optional).At<&PlatformData::Model, &ModelData::Name>(),
      Text("visModel", "as model; model overrides it").Default("a simple model").Names(XmlFile::Optional),
      Number("drag", "groundvehicle, multicopter: loss of speed per pulse; not used: vehicles have masses and forces").In("", { 0.0, 1e3, true }).Later(),
      Number("engine_max_force", "multicopter: force per pulse; not used: thrust follows from the tilt").In("", { 0.0, 1e6, true }).Later(),
      Number("speedup_magnitude", "multicopter: rate per pulse; not used").In("1/s", { 0.0, 1e3, true }).Later(),
      Number("slowdown_magnitude", "multicopter: rate per pulse; not used").In("1/s", { 0.0, 1e3, true }).Later(),
      Number("slowdown_distance", "multicopter: not used: it slows down as late as its maximum tilt allows").In("m", NotNegative).Later(),
      Number("base_pitch_deg", "multicopter: pitch in cruise at the highest speed of its legs").In("deg", { -60.0, 60.0 }).At<Vehicle, &VehicleData::BasePitch>(),
      Number("roll_speed_deg", "multicopter: roll rate").In("deg/s", { 1e-3, 1e4 }).At<Vehicle, &VehicleData::RollSpeed>(),
      Number("pitch_speed_deg", "multicopter: pitch rate").In("deg/s", { 1e-3, 1e4 }).At<Vehicle, &VehicleData::PitchSpeed>(),
      Number("yaw_speed_deg", "multicopter: yaw rate").In("deg/s", { 1e-3, 1e4 }).At<Vehicle, &VehicleData::YawSpeed>(),
      Number("roll_offset_deg", "multicopter: maximum roll").In("deg", { 1e-3, 85.0 }).At<Vehicle, &VehicleData::RollOffset>(),
      Number("pitch_offset_deg", "multicopter: maximum pitch").In("deg", { 1e-3, 85.0 }).At<Vehicle, &VehicleData::PitchOffset>(),
    },
    { One("scannerMount"), One("positionXNoise"), One("positionYNoise"), One("positionZNoise"), One("attitudeXNoise"), One("attitudeYNoise"), One("attitudeZNoise"), One("navigationError") } },

  { "positionXNoise", "noise of the platform's x [m]; that of a survey overrides that of its platform",
    MakeNoiseValues(),
    {} },

  { "positionYNoise", "noise of the platform's y [m]",
    MakeNoiseValues(),
    {} },

  { "positionZNoise", "noise of the platform's z [m]",
    MakeNoiseValues(),
    {} },

  { "attitudeXNoise", "noise of the platform's attitude about x [rad]",
    MakeNoiseValues(),
    {} },

  { "attitudeYNoise", "noise of the platform's attitude about y [rad]",
    MakeNoiseValues(),
    {} },

  { "attitudeZNoise", "noise of the platform's attitude about z [rad]",
    MakeNoiseValues(),
    {} },

  { "navigationError", "errors that the instrument does not know: points are reported without them; that of a survey overrides that of its platform",
    {
      Word("grade", "consumer tactical survey navigation", "a class of GNSS/IMU solutions, which gives the RMS that are not given").Default("none").At<&NavigationErrorData::Grade>(),
      Number("positionXRms_m", "RMS of the slow error of the position, east").In("m", { 0.0, 1e6 }).Default("that of the grade, else 0").At<&NavigationErrorData::PositionRMS, 0>(),
      Number("positionYRms_m", "RMS of the slow error of the position, north").In("m", { 0.0, 1e6 }).Default("that of the grade, else 0").At<&NavigationErrorData::PositionRMS, 1>(),
      Number("positionZRms_m", "RMS of the slow error of the position, up").In("m", { 0.0, 1e6 }).Default("that of the grade, else 0").At<&NavigationErrorData::PositionRMS, 2>(),
      Number("attitudeXRms_deg", "RMS of the slow error of the attitude about x of the body, nose up").In("deg", { 0.0, 180.0 }).Default("that of the grade, else 0").At<&NavigationErrorData::AttitudeRMS, 0>(),
      Number("attitudeYRms_deg", "RMS of the slow error of the attitude about y of the body, right side down").In("deg", { 0.0, 180.0 }).Default("that of the grade, else 0").At<&NavigationErrorData::AttitudeRMS, 1>(),
      Number("attitudeZRms_deg", "RMS of the slow error of the attitude about z of the body, to the left").In("deg", { 0.0, 180.0 }).Default("that of the grade, else 0").At<&NavigationErrorData::AttitudeRMS, 2>(),
      Number("positionTime_s", "correlation time of the position errors, a first-order Gauss-Markov process").In("s", CorrelationTime).At<&NavigationErrorData::PositionTime>(),
      Number("attitudeTime_s", "correlation time of the attitude errors").In("s", CorrelationTime).At<&NavigationErrorData::AttitudeTime>(),
      Number("boresightX_deg", "constant misalignment of the mount about x of the body").In("deg", { -180.0, 180.0 }).At<&NavigationErrorData::Boresight, 0>(),
      Number("boresightY_deg", "constant misalignment of the mount about y of the body").In("deg", { -180.0, 180.0 }).At<&NavigationErrorData::Boresight, 1>(),
      Number("boresightZ_deg", "constant misalignment of the mount about z of the body").In("deg", { -180.0, 180.0 }).At<&NavigationErrorData::Boresight, 2>(),
      Number("leverArmX_m", "error of the lever arm along x of the body").In("m", { -1e6, 1e6 }).At<&NavigationErrorData::LeverArm, 0>(),
      Number("leverArmY_m", "error of the lever arm along y of the body").In("m", { -1e6, 1e6 }).At<&NavigationErrorData::LeverArm, 1>(),
      Number("leverArmZ_m", "error of the lever arm along z of the body").In("m", { -1e6, 1e6 }).At<&NavigationErrorData::LeverArm, 2>(),
      Number("clockOffset_s", "true time of emission of a pulse less its GPS time").In("s", { -1e6, 1e6 }).At<&NavigationErrorData::ClockOffset>(),
    },
    {} },

  { "scannerMount", "position and orientation of the scanner on the platform",
    {
      Number("x", "coordinate to the right, or east").In("m").At<&Pose::Position, 0>(),
      Number("y", "coordinate forward, or north").In("m").At<&Pose::Position, 1>(),
      Number("z", "coordinate up").In("m").At<&Pose::Position, 2>(),
      Word("rotations", "global local", "whether each rot rotates about fixed axes (global) or about the axes already rotated (local)").Default("global"),
    },
    { Many("rot") } },

  { "beamOrigin", "position and orientation of the beam origin on the head",
    {
      Number("x", "coordinate to the right, or east").In("m").At<&Pose::Position, 0>(),
      Number("y", "coordinate forward, or north").In("m").At<&Pose::Position, 1>(),
      Number("z", "coordinate up").In("m").At<&Pose::Position, 2>(),
      Word("rotations", "global local", "whether each rot rotates about fixed axes (global) or about the axes already rotated (local)").Default("global"),
    },
    { Many("rot") } },

  { "headRotateAxis", "axis of the head rotation; not used if shorter than 0.1",
    {
      Number("x", "coordinate to the right, or east").Default("0"),
      Number("y", "coordinate forward, or north").Default("0"),
      Number("z", "coordinate up").Default("1 without the element, else 0"),
    },
    {} },

  { "rot", "a right-handed rotation; several are applied in their order",
    {
      Word("axis", "x y z X Y Z pitch roll yaw", "rotation axis; pitch, roll, yaw are x, y, z").Required(),
      Number("angle_deg", "rotation angle").In("deg", { -1e6, 1e6 }).Required(),
    },
    {} },
  };
  // clang-format on
}

} // namespace helios
