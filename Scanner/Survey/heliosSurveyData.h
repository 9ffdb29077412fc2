// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey as plain data: what a reader makes and a player runs. No trace of its file format but the
// places (file:line) that messages name.

#ifndef heliosSurveyData_h
#define heliosSurveyData_h

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
  RisleyPrisms
};

/// A prism of Risley optics.
struct PrismData
{
  double WedgeAngle = 0.0; ///< [deg], its sign says which face is inclined; 0: there is none
  double RefractiveIndex = 1.0;
  double RotorFrequency = 0.0; ///< [Hz], its sign is the sense
};

enum class PlatformType
{
  Static,
  LinearPath,
  GroundVehicle,
  Multicopter,
  Interpolated
};

/// The file that says what a platform or a scanner looks like: nothing but a viewer opens it.
struct ModelData
{
  std::string Name;  ///< as it is given; empty: none is
  std::string Where; ///< file:line and what it says
  std::string File;  ///< empty: there is none of that name
};

/// An instrument and its detector: one channel, or the first of several.
struct ScannerData
{
  std::string Id;
  std::string Name;
  std::string Where;
  std::string Channel; ///< id; empty: there is one only
  Optics Type = Optics::RotatingMirror;
  std::vector<double> PulseFrequencies; ///< [Hz], that it offers; the first is the default
  double PulseLength = 4.0;             ///< [ns], full width at half maximum
  double BeamDivergence = 0.0003;       ///< [rad], full angle at 1/e^2
  double Wavelength = 1064.0;           ///< [nm]
  double AveragePower = 4.0;            ///< [W]
  double OpticalEfficiency = 0.99;      ///< [0..1]
  double ReceiverDiameter = 0.15;       ///< [m]
  double AtmosphericVisibility = 23.0;  ///< [km]
  double DetectionThreshold = 1e-13;    ///< [W]
  double Accuracy = 0.0;                ///< [m], standard deviation of a range
  double RangeMin = 0.0;                ///< [m]
  double RangeMax = VTK_DOUBLE_MAX;     ///< [m]
  int MaximumNumberOfReturns = 0;       ///< 0: all
  double ScanAngleMax = 0.0;            ///< [deg], half
  double ScanAngleEffectiveMax = 0.0;   ///< [deg], half
  double ScanFrequencyMin = 0.0;        ///< [Hz]
  double ScanFrequencyMax = 0.0;        ///< [Hz], 0: no limit
  double HeadRotateSpeedMax = 0.0;      ///< [deg/s]
  double ScanProduct = 1e6;             ///< [deg Hz], of angle and frequency: oscillating
  int TurningPulses = 0;                ///< oscillating
  bool IsSinusoidal = false;            ///< oscillating; else triangular
  int NumberOfFibers = 1;
  PrismData Prisms[3];
  double AirRefractiveIndex = 1.0;    ///< around the prisms
  Vec3 IncidentBeam{ 0.0, 1.0, 0.0 }; ///< into the first prism
  ReceiverData Receiver;
  Pose Beam; ///< in the frame of the head
  Vec3 HeadRotateAxis{ 0.0, 0.0, 1.0 };
  ModelData Model;                        ///< in the frame of the head
  std::vector<ScannerData> OtherChannels; ///< beside this one; each has none

  std::size_t GetNumberOfChannels() const { return 1 + this->OtherChannels.size(); }
  const ScannerData& GetChannel(std::size_t channel) const
  {
    return channel == 0 ? *this : this->OtherChannels[channel - 1];
  }
};

/// How one number of a platform is off by chance.
struct NoiseData
{
  bool IsUniform = false; ///< between Low and High; else normal
  double Mean = 0.0;
  double Deviation = 1.0;
  double Low = 0.0;
  double High = 1.0;
  bool IsClipped = false; ///< to ClipLow and ClipHigh
  double ClipLow = 0.0;
  double ClipHigh = 1.0;
  int Lifespan = 1; ///< pulses that a value lasts; 0: all
};

/// What vehicles are like, as files say it.
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
  PlatformType Type = PlatformType::Static;
  Pose Mount; ///< of the scanner
  VehicleData Vehicle;
  ModelData Model;       ///< in the frame of the platform
  bool HasNoise[6] = {}; ///< of position x, y, z, attitude x, y, z
  NoiseData Noise[6];    ///< [m], [rad]
};

enum class Loader
{
  Obj,
  GeoTiff,
  Xyz,
  Vegetation
};

/// How the points of a file become solid cells.
struct VoxelData
{
  double Size = 1.0;      ///< [m], of an edge
  std::string Separators; ///< of columns, beside blanks and tabs
  bool ReadNormals = false;
  int NormalIndex[3] = { 3, 4, 5 }; ///< columns, from 0
  bool EstimateNormals = false;
  Vec3 DefaultNormal{ 0.0, 0.0, 0.0 }; ///< of cells without one; 0: that of the faces
  bool SnapNeighborNormal = false;
};

/// What the cells of a grid of vegetation are to light.
enum class CellMode
{
  Turbid, ///< leaves that it passes by chance
  Scaled, ///< cubes, the denser the larger
  Fixed   ///< cubes
};

/// How the cells of .vox files meet light.
struct VegetationData
{
  CellMode Mode = CellMode::Turbid;
  double Exponent = 0.5;    ///< of scaled cubes
  bool RandomShift = false; ///< of scaled cubes in their cells
  std::string LeafTable;    ///< of the projection of leaves; empty: all directions alike
};

/// The one material of a part whose file has none.
struct MaterialData
{
  std::string Where;
  std::string File;         ///< MTL; empty: the default material
  std::string Name;         ///< empty: the alphabetically first
  int Count = 1;            ///< of materials: the others differ from it by chance
  double RandomRange = 1.0; ///< of their reflectances
};

/// From one coordinate system to another.
struct CrsData
{
  std::string Where;
  std::string Source; ///< empty: that of the file
  std::string Target;
};

struct SwapData;

/// A part of a scene: its files as one mesh, reprojected, repaired, simplified, rotated, scaled, moved.
struct PartData
{
  std::string Name;
  std::string Where;
  Loader Type = Loader::Obj;
  std::vector<std::string> Files;
  bool UpIsY = false;
  VoxelData Voxels;
  VegetationData Vegetation;
  MaterialData Material;
  std::vector<CrsData> Crs;
  bool Repair = false;
  double SimplifyDistance = 0.0; ///< [m], that the surface may move; 0: not simplified
  Quaternion Rotation{ 1.0, 0.0, 0.0, 0.0 };
  double Scale = 1.0;
  Vec3 Translation{ 0.0, 0.0, 0.0 }; ///< [m]
  bool OnGround = false;             ///< its lowest vertex goes to the ground below
  std::vector<SwapData> Swaps;       ///< what takes its place in later plays, in this order
  MotionData Motion;                 ///< from where it then is

  bool IsTurbid() const
  {
    return this->Type == Loader::Vegetation && this->Vegetation.Mode == CellMode::Turbid;
  }
};

/// What takes the place of a part in later plays: as whole a part as that, without swaps of its own.
struct SwapData
{
  PartData Part;
  int Plays = 1;          ///< that it lasts, at least 1
  bool IsRemoved = false; ///< nothing takes the place
};

struct SceneData
{
  std::string Id;
  std::string Name;
  std::string Where;
  std::string Crs; ///< of its parts that do not say theirs; empty: a frame of its own, in metres
  std::vector<PartData> Parts;
  std::vector<std::string> SpectraFolders; ///< that a spectrum is looked for in, in this order
};

/// What one channel does on a leg: nothing is left to inherit or to clip.
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
  double WarmUpTime = 0.0;       ///< [s], that the optics have moved before the leg

  /// How long the head turns [s]; 0 where it does not.
  double GetHeadTime() const
  {
    return this->HeadRotateSpeed != 0.0
      ? (this->HeadRotateStop - this->HeadRotateStart) / this->HeadRotateSpeed
      : 0.0;
  }
};

/// A trajectory in a file, and the part of it that a leg flies.
struct TrajectoryFileData
{
  static constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

  std::string Where;
  std::string File;
  std::string Separator = ",";
  int Columns[7] = { -1, -1, -1, -1, -1, -1, -1 }; ///< t, roll, pitch, yaw, x, y, z; -1: not given
  bool IsInRadians = false;
  bool HasAttitude = true;
  bool KeepsTime = false;      ///< else the clock starts at 0
  double SlopeThreshold = 0.0; ///< 0: every sample is kept
  double StartTime = NotGiven; ///< [s]
  double EndTime = NotGiven;   ///< [s]
  bool TeleportsToStart = false;
};

/// A leg and what its platform does.
struct LegData
{
  std::string Where;
  std::size_t Platform = 0;       ///< of the survey
  std::size_t Scanner = 0;        ///< of the survey
  bool StartsJourney = false;     ///< the platform does not come here from the leg before
  std::string Strip;              ///< whose files its points go to; empty: it has its own
  Vec3 Position{ 0.0, 0.0, 0.0 }; ///< [m], or what Crs counts in
  std::string Crs;                ///< of the position; empty: the scene's
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
  std::vector<ScanData> Scans;         ///< one a channel of its scanner

  /// How long the heads turn [s].
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

/// Chance that moves the position of every leg once.
struct LegOffsetData
{
  bool IsOn = false;
  double Mean = 0.0;      ///< [m]
  double Deviation = 0.1; ///< [m]
};

struct SurveyData
{
  std::string Name; ///< fit for the name of a folder
  std::string FileName;
  std::vector<std::string> Documents; ///< all files that the survey was read from
  std::string RayCaster;              ///< its name; empty: the default
  vtkIdType Seed = -1;                ///< negative: not given
  bool IsCanonical = false;           ///< how attitudes in files count; else as ARINC 705 has it
  LegOffsetData LegOffset;
  std::vector<ScannerData> Scanners;
  std::vector<PlatformData> Platforms;
  SceneData Scene;
  std::vector<LegData> Legs;

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

  /// Whether a leg ends where it is: the last one that a platform goes through.
  bool EndsJourney(std::size_t leg) const
  {
    return leg + 1 == this->Legs.size() || this->Legs[leg + 1].StartsJourney;
  }

  /// Whether pulses leave on a leg: that which ends the way of a moving platform is only an end point,
  /// unless its way comes from a file.
  bool Fires(std::size_t leg) const
  {
    const bool isEndPoint = this->IsMoving(leg) && this->EndsJourney(leg) &&
      this->GetPlatform(leg).Type != PlatformType::Interpolated;
    return this->Legs[leg].Active && !isEndPoint;
  }
};

} // namespace helios

#endif
