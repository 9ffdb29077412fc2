// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey as plain data: made by a reader and run by a player. Independent of the file format,
// except for the places (file:line) in messages.

#ifndef heliosSurveyData_h
#define heliosSurveyData_h

#include "heliosFramesData.h"
#include "heliosMotionData.h"
#include "heliosPose.h"
#include "heliosReceiverData.h"

#include <vtkType.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace helios
{

enum class Optics
{
  RotatingMirror,
  OscillatingMirror,
  FiberArray,
  ConicMirror,
  PalmerMirror,
  RisleyPrisms,
  SpinningChannels
};

/// The names of optics in files, in the order of the enumeration.
constexpr const char* OpticsNames = "rotating oscillating line conic palmer risley spinning";

/// A prism of Risley optics.
struct PrismData
{
  double WedgeAngle = 0.0; ///< [deg], the sign gives the inclined face; 0: none
  double RefractiveIndex = 1.0;
  double RotorFrequency = 0.0; ///< [Hz], the sign gives the direction
  double RotorPhase = 0.0;     ///< [deg], at pulse 0
};

/// A beam of a spinning head.
struct BeamData
{
  double Elevation = 0.0;    ///< [deg]
  double Azimuth = 0.0;      ///< [deg], in the head
  double OriginOffset = 0.0; ///< [m], from the axis
  double OriginHeight = 0.0; ///< [m]
  double FiringTime = -1.0;  ///< [s], in a cycle; negative: evenly
};

enum class PlatformType
{
  Static,
  LinearPath,
  GroundVehicle,
  Multicopter,
  Interpolated
};

/// The 3D model file of a platform or a scanner: used by viewers only.
struct ModelData
{
  std::string Name;  ///< given name; empty: none
  std::string Where; ///< file:line and the attribute
  std::string File;  ///< empty: not found
};

/// An instrument and its detector: one channel, or the first of several.
struct ScannerData
{
  std::string Id;
  std::string Name;
  std::string Where;
  std::string File;    ///< file that it was read from; empty: none
  std::string Channel; ///< id; empty: the only one
  Optics Type = Optics::RotatingMirror;
  std::vector<double> PulseFrequencies; ///< [Hz], supported; the first is the default
  double BeamDivergence = 0.0003;       ///< [rad], full angle at 1/e^2; along the major axis
  double MinorBeamDivergence = 0.0;     ///< [rad], along the minor axis; 0: a circular beam
  double MajorAxisAngle = 0.0;          ///< [deg], from the axis across the scan lines
  double ScanAngleMax = 0.0;            ///< [deg], half
  double ScanAngleEffectiveMax = 0.0;   ///< [deg], half
  double ScanFrequencyMin = 0.0;        ///< [Hz]
  double ScanFrequencyMax = 0.0;        ///< [Hz], 0: no limit
  std::vector<double> FacetPitches;     ///< [deg], of a rotating mirror; empty: 0
  std::vector<double> FacetRolls;       ///< [deg], likewise
  double HeadRotateSpeedMax = 0.0;      ///< [deg/s]
  double ScanProduct = 1e6;             ///< [deg Hz], of angle and frequency: oscillating
  int TurningPulses = 0;                ///< oscillating
  bool IsSinusoidal = false;            ///< oscillating; else triangular
  int NumberOfFibers = 1;
  PrismData Prisms[3];
  double AirRefractiveIndex = 1.0;    ///< around the prisms
  Vec3 IncidentBeam{ 0.0, 1.0, 0.0 }; ///< into the first prism
  std::vector<BeamData> Beams;        ///< beams of a spinning head, in the order of firing
  std::string BeamFile;               ///< file of the beams; empty: none
  bool IsClockwise = false;           ///< the spin, seen from above
  double StartAngle = 0.0;            ///< [deg], azimuth of the head at pulse 0
  ReceiverData Receiver;
  Pose Beam; ///< in the frame of the head
  Vec3 HeadRotateAxis{ 0.0, 0.0, 1.0 };
  ModelData Model;                        ///< in the frame of the head
  std::vector<ScannerData> OtherChannels; ///< besides this one, without OtherChannels

  std::size_t GetNumberOfChannels() const { return 1 + this->OtherChannels.size(); }
  const ScannerData& GetChannel(std::size_t channel) const
  {
    return channel == 0 ? *this : this->OtherChannels[channel - 1];
  }
};

/// Noise of one component of a platform pose.
struct NoiseData
{
  bool IsOn = false;
  bool IsUniform = false; ///< between Low and High; else normal
  double Mean = 0.0;
  double Deviation = 1.0;
  double Low = 0.0;
  double High = 1.0;
  bool IsClipped = false; ///< to ClipLow and ClipHigh
  double ClipLow = 0.0;
  double ClipHigh = 1.0;
  int Lifespan = 1; ///< pulses per value; 0: all
};

/// Errors of position, attitude and calibration that the instrument does not know.
struct NavigationErrorData
{
  std::string Grade;                            ///< grade of vtkHeliosPlatformNoise; empty: none
  double PositionRMS[3] = { -1.0, -1.0, -1.0 }; ///< x, y, z [m]; negative: the grade's, else 0
  double AttitudeRMS[3] = { -1.0, -1.0, -1.0 }; ///< about x, y, z of the body [deg]; likewise
  double PositionTime = 60.0;                   ///< correlation time [s]
  double AttitudeTime = 60.0;                   ///< [s]
  /// angles of the mount about x, y, z of the body [deg]
  double Boresight[3] = { 0.0, 0.0, 0.0 };
  double LeverArm[3] = { 0.0, 0.0, 0.0 }; ///< [m]
  double ClockOffset = 0.0;               ///< [s]
};

/// Vehicle parameters, as in files.
struct VehicleData
{
  double BasePitch = -5.0;   ///< [deg]
  double RollSpeed = 28.65;  ///< [deg/s]
  double PitchSpeed = 85.94; ///< [deg/s]
  double YawSpeed = 85.94;   ///< [deg/s]
  double RollOffset = 25.0;  ///< [deg]
  double PitchOffset = 35.0; ///< [deg]
};

struct PlatformData
{
  std::string Id;
  std::string Name;
  std::string Where;
  std::string File; ///< file that it was read from; empty: none
  PlatformType Type = PlatformType::Static;
  Pose Mount; ///< mount of the scanner
  VehicleData Vehicle;
  ModelData Model;    ///< in the frame of the platform
  NoiseData Noise[6]; ///< noise of position x, y, z [m], attitude x, y, z [rad]
  NavigationErrorData Errors;
};

/// Loaders in the order of GetFilterTypes().
enum class Loader
{
  Obj,
  GeoTiff,
  Xyz,
  Vegetation,
  Ply,
  Stl,
  CityJson,
  Gltf,
  Las
};

/// How the points of a file become solid voxels.
struct VoxelData
{
  double Size = 1.0;      ///< [m], of an edge
  std::string Separators; ///< separators of columns, besides blanks and tabs
  bool ReadNormals = false;
  int NormalIndex[3] = { 3, 4, 5 }; ///< columns, from 0
  bool EstimateNormals = false;
  Vec3 DefaultNormal{ 0.0, 0.0, 0.0 }; ///< normal of cells without one; 0: normal of the faces
  bool SnapNeighborNormal = false;
  std::string Classes; ///< classes of a LAS file; empty: all
};

/// The optical model of the cells of a vegetation grid.
enum class CellMode
{
  Turbid, ///< randomly distributed leaves
  Scaled, ///< cubes, larger with density
  Fixed   ///< cubes
};

/// The optical properties of .vox cells.
struct VegetationData
{
  CellMode Mode = CellMode::Turbid;
  double Exponent = 0.5;    ///< exponent of scaled cubes
  bool RandomShift = false; ///< shift of scaled cubes in their cells
  std::string LeafTable;    ///< table of the projection of leaves; empty: isotropic
};

/// The material of a part whose file has none.
struct MaterialData
{
  std::string Where;
  std::string File;         ///< MTL; empty: the default material
  std::string Name;         ///< empty: the alphabetically first
  int Count = 1;            ///< number of materials: the others vary randomly from it
  double RandomRange = 1.0; ///< range of their reflectances
};

/// A transformation between coordinate systems.
struct CrsData
{
  std::string Where;
  std::string Source; ///< empty: system of the file
  std::string Target;
  double Epoch = 0.0;      ///< epoch of the coordinates, a decimal year; 0: not known
  double HeightUnit = 0.0; ///< unit of the file [m]; 0: stated by its system
};

struct SwapData;

/// A part of a scene: its files as one mesh, reprojected, repaired, simplified, rotated, scaled,
/// moved.
struct PartData
{
  std::string Name;
  std::string Where;
  Loader Type = Loader::Obj;
  std::vector<std::string> Files;
  bool UpIsY = false;
  std::string LevelOfDetail; ///< level of CityJSON; empty: the highest of each object
  VoxelData Voxels;
  VegetationData Vegetation;
  MaterialData Material;
  std::vector<CrsData> Crs;
  bool Repair = false;
  double SimplifyDistance = 0.0; ///< [m], tolerance of the surface; 0: not simplified
  int Classification = -1;       ///< class of its echoes; negative: class of the materials
  std::string Species;           ///< species of the tree that it is; empty: none or not known
  int Tree = -1;                 ///< number of the tree; negative: the part's, if it has a species
  Quaternion Rotation{ 1.0, 0.0, 0.0, 0.0 };
  double Scale = 1.0;
  Vec3 Translation{ 0.0, 0.0, 0.0 }; ///< [m]
  bool OnGround = false;             ///< its lowest vertex is moved to the ground below
  std::vector<SwapData> Swaps;       ///< its replacements in later epochs, in order
  MotionData Motion;                 ///< from its final position
  FramesData Frames;                 ///< frames of a mesh that deforms: its files, or an animation

  /// Returns whether it moves, may be carried, or deforms.
  bool IsMoving() const { return this->Motion.IsMoving() || this->Frames.IsGiven(); }

  /// Returns whether its points become solid voxels.
  bool IsCloud() const { return this->Type == Loader::Xyz || this->Type == Loader::Las; }

  bool IsTurbid() const
  {
    return this->Type == Loader::Vegetation && this->Vegetation.Mode == CellMode::Turbid;
  }
};

/// The replacement of a part in later epochs: a full part, but without swaps.
struct SwapData
{
  PartData Part;
  int Epochs = 1;         ///< epochs that it lasts, at least 1
  bool IsRemoved = false; ///< without replacement
};

struct SceneData
{
  std::string Id;
  std::string Name;
  std::string Where;
  std::string File; ///< file that it was read from; empty: none
  std::string Crs;  ///< system of parts without their own; empty: a local frame, in metres
  std::vector<PartData> Parts;
  std::vector<std::string> SpectraFolders; ///< searched for spectra, in order
};

/// The scan of one channel on a leg, with all inherited values and limits resolved.
struct ScanData
{
  double PulseFrequency = 0.0;   ///< [Hz]
  double ScanFrequency = 0.0;    ///< [Hz]
  double ScanAngle = 0.0;        ///< [deg], half
  double VerticalAngleMin = 0.0; ///< [deg]
  double VerticalAngleMax = 0.0; ///< [deg]
  double HeadRotateSpeed = 0.0;  ///< [deg/s]
  double HeadRotateStart = 0.0;  ///< [deg]
  double HeadRotateStop = 0.0;   ///< [deg]
  double BeamDivergence = 0.0;   ///< [rad]
  double WarmUpTime = 0.0;       ///< [s], motion of the optics before the leg

  /// Returns the duration of the head rotation [s]; 0 without rotation.
  double GetHeadTime() const
  {
    return this->HeadRotateSpeed != 0.0
      ? (this->HeadRotateStop - this->HeadRotateStart) / this->HeadRotateSpeed
      : 0.0;
  }
};

/// A leg and the settings of its platform.
struct LegData
{
  std::string Where;
  std::size_t Platform = 0;       ///< number of the survey's platform
  std::size_t Scanner = 0;        ///< number of the survey's scanner
  bool StartsTrajectory = false;  ///< the platform does not come from the previous leg
  std::string Strip;              ///< with shared output files; empty: none
  Vec3 Position{ 0.0, 0.0, 0.0 }; ///< [m], or the unit of Crs
  std::string Crs;                ///< system of the position; empty: the scene's
  bool OnGround = false;
  double Speed = 70.0; ///< [m/s], to the next leg's position
  bool StopAndTurn = true;
  bool SmoothTurn = false;
  bool SlowsDown = true;
  double YawAtDeparture = TrajectoryFileData::NotGiven; ///< [deg]
  TrajectoryFileData Trajectory;
  bool Active = true;
  double TrajectoryTimeInterval = 0.0; ///< [s], 0: start and end of the leg only
  double MaximumDuration = -1.0;       ///< [s], negative: no limit
  std::vector<ScanData> Scans;         ///< one per channel of its scanner

  /// Returns the duration of the head rotation [s].
  double GetHeadTime() const
  {
    double time = 0.0;
    for (const ScanData& scan : this->Scans)
    {
      time = std::max(time, scan.GetHeadTime());
    }
    return time;
  }
};

/// The settings of a leg as given; NaN: not given.
struct LegSettings
{
  static constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

  LegData Leg;   ///< with all settings that need no conversion; StartsTrajectory: in any case
  ScanData Scan; ///< likewise its head and its warm-up
  double PulseFrequency = NotGiven;
  double ScanFrequency = NotGiven;
  double ScanAngle = NotGiven;
  double VerticalAngleMin = NotGiven;
  double VerticalAngleMax = NotGiven;
  double BeamDivergence = NotGiven;
  double VerticalResolution = 0.0;   ///< [deg], 0: not given
  double HorizontalResolution = 0.0; ///< [deg], 0: not given
};

/// A random offset of the position of every leg.
struct LegOffsetData
{
  bool IsOn = false;
  double Mean = 0.0;      ///< [m]
  double Deviation = 0.1; ///< [m]
};

struct SurveyData
{
  std::string Name; ///< valid as a folder name
  std::string FileName;
  std::vector<std::string> Documents; ///< all files that the survey was read from
  std::string RayCaster;              ///< its name; empty: the default
  vtkIdType Seed = -1;                ///< negative: not given
  AngleConvention Convention = AngleConvention::Arinc705; ///< in trajectory files
  LegOffsetData LegOffset;
  std::string GpsStart; ///< see vtkHeliosGpsTime::Parse(); empty: not known
  std::vector<ScannerData> Scanners;
  std::vector<PlatformData> Platforms;
  SceneData Scene;
  std::vector<LegSettings> Settings; ///< settings of the legs
  std::vector<LegData> Legs;         ///< made of their settings

  const PlatformData& GetPlatform(std::size_t leg) const
  {
    return this->Platforms[this->Legs[leg].Platform];
  }
  const ScannerData& GetScanner(std::size_t leg) const
  {
    return this->Scanners[this->Legs[leg].Scanner];
  }
  bool IsMoving(std::size_t leg) const
  {
    return this->GetPlatform(leg).Type != PlatformType::Static;
  }

  /// Returns whether a leg is the last one of a platform's trajectory.
  bool EndsTrajectory(std::size_t leg) const
  {
    return leg + 1 == this->Legs.size() || this->Legs[leg + 1].StartsTrajectory;
  }

  /// Returns whether a leg fires pulses: the last leg of a moving platform is only an end point,
  /// unless its trajectory comes from a file.
  bool Fires(std::size_t leg) const
  {
    const bool isEndPoint = this->IsMoving(leg) && this->EndsTrajectory(leg) &&
      this->GetPlatform(leg).Type != PlatformType::Interpolated;
    return this->Legs[leg].Active && !isEndPoint;
  }
};

} // namespace helios

#endif
