// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The differences of two surveys as plain data. No member can be left out: the compiler counts them.

#ifndef heliosSurveyEquality_h
#define heliosSurveyEquality_h

#include "heliosSurveyData.h"

#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace helios
{
namespace test
{

/// The members of a struct in their order, and their names. A list with another number of members than
/// the struct does not compile.
#define HELIOS_MEMBERS(Type, ...)                                                                  \
  inline auto ListMembers(const Type& data)                                                        \
  {                                                                                                \
    const auto& [__VA_ARGS__] = data;                                                              \
    return std::tie(__VA_ARGS__);                                                                  \
  }                                                                                                \
  inline const char* ListNames(const Type&)                                                        \
  {                                                                                                \
    return #Type ", " #__VA_ARGS__;                                                                \
  }

/// Members that ReceiverData adds to its base, which a binding cannot list together with it.
struct OwnReceiverData
{
  const std::string& Where;
  int NumberOfCircles;
  double RangeTolerance;
  double EnergyTolerance;
  const std::string& EchoDetector;
  const ErrorExpressions& Errors;
  const PanoramicErrorData& Panoramic;
};

/// Has the members of ReceiverData: a new one changes the size, and does not compile.
struct ReceiverDataCopy : vtkHeliosInstrumentData
{
  std::string Where;
  int NumberOfCircles;
  double RangeTolerance;
  double EnergyTolerance;
  std::string EchoDetector;
  ErrorExpressions Errors;
  PanoramicErrorData Panoramic;
};
static_assert(sizeof(ReceiverDataCopy) == sizeof(ReceiverData), "list the members above");

// clang-format off
HELIOS_MEMBERS(Pose, Position, Orientation)
HELIOS_MEMBERS(Motion, Kind, Vector, Angle, Center, Shift, Glide, IsSelf)
HELIOS_MEMBERS(MotionSequence, Motions, Loop, Next)
HELIOS_MEMBERS(MotionData, Sequences, Pulses, Seconds, Every, IsContinuous, Where, Mount, Track)
HELIOS_MEMBERS(ErrorExpressions, Range, Deflection, Head, HeadZeroSinThreshold, RangeNoiseFactor, RangeName, DeflectionName, HeadName, RangeNoiseFactorName)
HELIOS_MEMBERS(PanoramicErrorData, BeamOffset, TransitOffset, MirrorOffset, VerticalIndexOffset, BeamTilt, MirrorTilt, TransitTilt, RangeOffset)
HELIOS_MEMBERS(vtkHeliosInstrumentData, PulseLength, PulseShape, PulseFile, AveragePower, Wavelength, BeamQualityFactor, OpticalEfficiency, ReceiverDiameter, BinSize, MaximumWaveformLength, NumberOfBins, DetectorNoise, SaturationPower, SolarIrradiance, FilterBandwidth, FieldOfView, AtmosphericVisibility, AtmosphericExtinction, AtmosphericLidarRatio, DropletDiameter, Weather, MaximumSpecularEvents, LeastSpecularShare, ScatteringOrders, ScatteringPaths, ScatteringPhase, RangeAccuracy, RangeAccuracyPerMeter, RangeAccuracyAtThreshold, AngleAccuracy, RangeMin, RangeMax, ReturnSelection, MaximumNumberOfReturns, MTAZone, DetectionThreshold, DeadTime, PeakWindow, PhotonEfficiency, DarkCountRate, TimeJitter)
HELIOS_MEMBERS(OwnReceiverData, Where, NumberOfCircles, RangeTolerance, EnergyTolerance, EchoDetector, Errors, Panoramic)
HELIOS_MEMBERS(PrismData, WedgeAngle, RefractiveIndex, RotorFrequency, RotorPhase)
HELIOS_MEMBERS(BeamData, Elevation, Azimuth, OriginOffset, OriginHeight, FiringTime)
HELIOS_MEMBERS(ModelData, Name, Where, File)
HELIOS_MEMBERS(ScannerData, Id, Name, Where, File, Channel, Type, PulseFrequencies, BeamDivergence, MinorBeamDivergence, MajorAxisAngle, ScanAngleMax, ScanAngleEffectiveMax, ScanFrequencyMin, ScanFrequencyMax, FacetPitches, FacetRolls, HeadRotateSpeedMax, ScanProduct, TurningPulses, IsSinusoidal, NumberOfFibers, Prisms, AirRefractiveIndex, IncidentBeam, Beams, BeamFile, IsClockwise, StartAngle, Receiver, Beam, HeadRotateAxis, Model, OtherChannels)
HELIOS_MEMBERS(NoiseData, IsOn, IsUniform, Mean, Deviation, Low, High, IsClipped, ClipLow, ClipHigh, Lifespan)
HELIOS_MEMBERS(NavigationErrorData, Grade, PositionRMS, AttitudeRMS, PositionTime, AttitudeTime, Boresight, LeverArm, ClockOffset)
HELIOS_MEMBERS(VehicleData, BasePitch, RollSpeed, PitchSpeed, YawSpeed, RollOffset, PitchOffset)
HELIOS_MEMBERS(PlatformData, Id, Name, Where, File, Type, Mount, Vehicle, Model, Noise, Errors)
HELIOS_MEMBERS(VoxelData, Size, Separators, ReadNormals, NormalIndex, EstimateNormals, DefaultNormal, SnapNeighborNormal, Classes)
HELIOS_MEMBERS(VegetationData, Mode, Exponent, RandomShift, LeafTable)
HELIOS_MEMBERS(MaterialData, Where, File, Name, Count, RandomRange)
HELIOS_MEMBERS(CrsData, Where, Source, Target, Epoch, HeightUnit)
HELIOS_MEMBERS(FramesData, Where, Rate, Start, End, Animation)
HELIOS_MEMBERS(PartData, Name, Where, Type, Files, UpIsY, LevelOfDetail, Voxels, Vegetation, Material, Crs, Repair, SimplifyDistance, Classification, Species, Tree, Rotation, Scale, Translation, OnGround, Swaps, Motion, Frames)
HELIOS_MEMBERS(SwapData, Part, Epochs, IsRemoved)
HELIOS_MEMBERS(SceneData, Id, Name, Where, File, Crs, Parts, SpectraFolders)
HELIOS_MEMBERS(ScanData, PulseFrequency, ScanFrequency, ScanAngle, VerticalAngleMin, VerticalAngleMax, HeadRotateSpeed, HeadRotateStart, HeadRotateStop, BeamDivergence, WarmUpTime)
HELIOS_MEMBERS(TrajectoryFileData, Where, File, Format, Crs, Body, Separator, Columns, IsInRadians, HasAttitude, KeepsTime, SlopeThreshold, StartTime, EndTime, TeleportsToStart)
HELIOS_MEMBERS(LegData, Where, Platform, Scanner, StartsTrajectory, Strip, Position, Crs, OnGround, Speed, StopAndTurn, SmoothTurn, SlowsDown, YawAtDeparture, Trajectory, Active, TrajectoryTimeInterval, MaximumDuration, Scans)
HELIOS_MEMBERS(LegSettings, Leg, Scan, PulseFrequency, ScanFrequency, ScanAngle, VerticalAngleMin, VerticalAngleMax, BeamDivergence, VerticalResolution, HorizontalResolution)
HELIOS_MEMBERS(LegOffsetData, IsOn, Mean, Deviation)
HELIOS_MEMBERS(SurveyData, Name, FileName, Documents, RayCaster, Seed, Convention, LegOffset, GpsStart, Scanners, Platforms, Scene, Settings, Legs)
// clang-format on

#undef HELIOS_MEMBERS

/// Collects the paths of members that differ, without places in messages and files that were read.
class Differences
{
public:
  template <typename T>
  void Compare(const T& a, const T& b, const std::string& path)
  {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
    {
      const bool areNumbers = !(a != a) || !(b != b); // NaN: not given
      this->Add(areNumbers && a != b, path);
    }
    else if constexpr (std::is_same_v<T, std::string>)
    {
      std::error_code ignored;
      this->Add(a != b && !std::filesystem::equivalent(a, b, ignored), path);
    }
    else if constexpr (std::is_same_v<T, Vec3> || std::is_same_v<T, Quaternion>)
    {
      for (int i = 0; i < a.GetSize(); ++i)
      {
        this->Compare(a[i], b[i], path + "[" + std::to_string(i) + "]");
      }
    }
    else if constexpr (std::is_array_v<T>)
    {
      for (std::size_t i = 0; i < std::extent_v<T>; ++i)
      {
        this->Compare(a[i], b[i], path + "[" + std::to_string(i) + "]");
      }
    }
    else
    {
      this->CompareMembers(a, b, path);
    }
  }

  void Compare(const ReceiverData& a, const ReceiverData& b, const std::string& path)
  {
    this->Compare<vtkHeliosInstrumentData>(a, b, path);
    const auto own = [](const ReceiverData& data)
    {
      return OwnReceiverData{ data.Where, data.NumberOfCircles, data.RangeTolerance,
        data.EnergyTolerance, data.EchoDetector, data.Errors, data.Panoramic };
    };
    this->CompareMembers(own(a), own(b), path);
  }

  template <typename T>
  void Compare(const std::vector<T>& a, const std::vector<T>& b, const std::string& path)
  {
    this->Add(a.size() != b.size(), path + " (number)");
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    {
      this->Compare(a[i], b[i], path + "[" + std::to_string(i) + "]");
    }
  }

  /// The paths, one a line; empty: none.
  const std::string& GetText() const { return this->Text; }

private:
  template <typename T>
  void CompareMembers(const T& a, const T& b, const std::string& path)
  {
    std::istringstream stream(ListNames(a));
    std::vector<std::string> names;
    for (std::string name; std::getline(stream, name, ',');)
    {
      names.push_back(name.substr(name.find_first_not_of(' ')));
    }
    std::size_t index = 0;
    const auto compare = [&](const auto& x, const auto& y)
    {
      const std::string& name = names[++index];
      IsPlace(names[0], name) ? void() : this->Compare(x, y, path + "." + name);
    };
    CompareEach(ListMembers(a), ListMembers(b), compare,
      std::make_index_sequence<std::tuple_size_v<decltype(ListMembers(a))>>());
  }

  template <typename TupleT, typename CompareT, std::size_t... I>
  static void CompareEach(
    const TupleT& a, const TupleT& b, const CompareT& compare, std::index_sequence<I...>)
  {
    (compare(std::get<I>(a), std::get<I>(b)), ...);
  }

  /// Whether a member only says where something was read.
  static bool IsPlace(const std::string& type, const std::string& member)
  {
    static const std::set<std::string> places = { "ScannerData.File", "PlatformData.File",
      "SceneData.File", "SceneData.SpectraFolders", "SurveyData.FileName", "SurveyData.Documents",
      "ErrorExpressions.RangeName", "ErrorExpressions.DeflectionName", "ErrorExpressions.HeadName",
      "ErrorExpressions.RangeNoiseFactorName", "ModelData.Name" };
    return member == "Where" || places.count(type + "." + member) > 0;
  }

  void Add(bool differs, const std::string& path)
  {
    this->Text += differs ? path + "\n" : std::string();
  }

  std::string Text;
};

/// The paths of members that differ, one a line; empty: none.
inline std::string FindDifferences(const SurveyData& a, const SurveyData& b)
{
  Differences differences;
  differences.Compare(a, b, "survey");
  return differences.GetText();
}

} // namespace test
} // namespace helios

#endif
