// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey as plain data: what a reader makes and a player runs. No trace of its file format but the
// places (file:line) that messages name.

#ifndef heliosSurveyData_h
#define heliosSurveyData_h

#include "heliosPose.h"
#include "heliosReceiverData.h"

#include <vtkType.h>

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
  LinearPath
};

/// An instrument and its detector.
struct ScannerData
{
  std::string Id;
  std::string Name;
  std::string Where;
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
  double AirRefractiveIndex = 1.0; ///< around the prisms
  ReceiverData Receiver;
  Pose Beam;                       ///< in the frame of the head
  Vec3 HeadRotateAxis{ 0.0, 0.0, 1.0 };
};

struct PlatformData
{
  std::string Id;
  std::string Name;
  PlatformType Type = PlatformType::Static;
  Pose Mount; ///< of the scanner
};

enum class Loader
{
  Obj,
  GeoTiff,
  Xyz
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

/// The one material of a part whose file has none.
struct MaterialData
{
  std::string Where;
  std::string File; ///< MTL; empty: the default material
  std::string Name; ///< empty: the alphabetically first
};

/// From one coordinate system to another.
struct CrsData
{
  std::string Where;
  std::string Source; ///< empty: that of the file
  std::string Target;
};

/// A part of a scene: its files as one mesh, reprojected, repaired, simplified, rotated, scaled, moved.
struct PartData
{
  std::string Name;
  std::string Where;
  Loader Type = Loader::Obj;
  std::vector<std::string> Files;
  bool UpIsY = false;
  VoxelData Voxels;
  MaterialData Material;
  std::vector<CrsData> Crs;
  bool Repair = false;
  double SimplifyDistance = 0.0; ///< [m], that the surface may move; 0: not simplified
  Quaternion Rotation{ 1.0, 0.0, 0.0, 0.0 };
  double Scale = 1.0;
  Vec3 Translation{ 0.0, 0.0, 0.0 }; ///< [m]
  bool OnGround = false;             ///< its lowest vertex goes to the ground below
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

/// A leg with the settings it runs with: nothing is left to inherit or to clip.
struct LegData
{
  std::string Where;
  Vec3 Position{ 0.0, 0.0, 0.0 }; ///< [m], or what Crs counts in
  std::string Crs;                ///< of the position; empty: the scene's
  bool OnGround = false;
  double Speed = 70.0; ///< [m/s], to the next leg's position
  bool Active = true;
  double PulseFrequency = 0.0;         ///< [Hz]
  double ScanFrequency = 0.0;          ///< [Hz]
  double ScanAngle = 0.0;              ///< [deg], half
  double VerticalAngleMin = 0.0;       ///< [deg]
  double VerticalAngleMax = 0.0;       ///< [deg]
  double HeadRotateSpeed = 0.0;        ///< [deg/s]
  double HeadRotateStart = 0.0;        ///< [deg]
  double HeadRotateStop = 0.0;         ///< [deg]
  double BeamDivergence = 0.0;         ///< [rad]
  double TrajectoryTimeInterval = 0.0; ///< [s], 0: start and end of the leg only
  double MaximumDuration = -1.0;       ///< [s], negative: no limit
  double WarmUpTime = 0.0;             ///< [s], that the optics have moved before the leg

  /// How long the head turns [s]; 0 where it does not.
  double GetHeadTime() const
  {
    return this->HeadRotateSpeed != 0.0
      ? (this->HeadRotateStop - this->HeadRotateStart) / this->HeadRotateSpeed
      : 0.0;
  }
};

struct SurveyData
{
  std::string Name; ///< fit for the name of a folder
  std::string FileName;
  std::vector<std::string> Documents; ///< all files that the survey was read from
  std::string RayCaster;              ///< its name; empty: the default
  ScannerData Scanner;
  PlatformData Platform;
  SceneData Scene;
  std::vector<LegData> Legs;

  bool IsMoving() const { return this->Platform.Type != PlatformType::Static; }

  /// Whether pulses leave on a leg: the last of a moving platform is only an end point.
  bool Fires(std::size_t leg) const
  {
    return this->Legs[leg].Active && !(this->IsMoving() && leg + 1 == this->Legs.size());
  }
};

} // namespace helios

#endif
