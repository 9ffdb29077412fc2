// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosArrayNames
 * @brief   the name of every array that vtkHelios reads or writes
 *
 * Echo arrays are spelled as in LAS and PDAL, the rest as VTK spells its own.
 * No other file spells an array name.
 */

#ifndef vtkHeliosArrayNames_h
#define vtkHeliosArrayNames_h

namespace vtkHeliosArrayNames
{

///@{
/** Scene: cell data. MaterialIds is a row of the material columns, PartIds the scene part. */
inline constexpr const char* MaterialIds = "MaterialIds";
inline constexpr const char* PartIds = "PartIds";
inline constexpr const char* Normals = "Normals";         // unit; where it is, incidence is from it
inline constexpr const char* EdgeDefects = "EdgeDefects"; // bits, see vtkHeliosMeshRepair
///@}

///@{
/** Clouds as input: point data (with Normals); scenes made of them: cell data. */
inline constexpr const char* RGB = "RGB";           // [0..1]
inline constexpr const char* VoxelIds = "VoxelIds"; // the solid cell that a triangle bounds
///@}

///@{
/** Scene: the material columns in the field data, one row a material. */
inline constexpr const char* MaterialName = "Material.Name";
inline constexpr const char* MaterialReflectance = "Material.Reflectance"; // [0..1], NaN: not given
inline constexpr const char* MaterialSpecularity = "Material.Specularity"; // [0..1]
inline constexpr const char* MaterialSpecularExponent = "Material.SpecularExponent";
inline constexpr const char* MaterialClassification = "Material.Classification";
inline constexpr const char* MaterialIsGround = "Material.IsGround";
inline constexpr const char* MaterialSpectrum = "Material.Spectrum";
///@}

///@{
/** Scene: field data. CRS is a WKT text or "EPSG:n". */
inline constexpr const char* CRS = "CRS";
inline constexpr const char* PartName = "Part.Name";
///@}

///@{
/** Turbid voxels: cell data of an image, and its field data. */
inline constexpr const char* PAD = "PAD"; // plant area density [m2/m3], NaN: not known
inline constexpr const char* Transmittance = "Transmittance";   // [0..1], NaN: not known
inline constexpr const char* MaximumPAD = "MaximumPAD";         // one value
inline constexpr const char* LeafProjection = "LeafProjection"; // rows x y z G(direction)
///@}

///@{
/** Waypoints: point data. */
inline constexpr const char* Speed = "Speed";             // [m/s] towards the next waypoint
inline constexpr const char* OnGround = "OnGround";       // 1: z comes from the ground below
inline constexpr const char* StopAndTurn = "StopAndTurn"; // 1: a multicopter rests and turns there
inline constexpr const char* SmoothTurn = "SmoothTurn";   // 1: it cuts the corner there
inline constexpr const char* YawAtDeparture = "YawAtDeparture"; // [deg], NaN: not given
///@}

///@{
/** Trajectory: point data. */
inline constexpr const char* GpsTime = "GpsTime";         // [s] since GpsEpoch
inline constexpr const char* Orientation = "Orientation"; // unit quaternion w x y z, body to world
inline constexpr const char* Velocity = "Velocity";       // [m/s]
inline constexpr const char* LegIds = "LegIds";
inline constexpr const char* Clearance = "Clearance"; // [m] from the scene, see vtkHeliosClearance
///@}

/** Trajectory and clouds: field data, the time that GpsTime counts from: one number, seconds of GPS
 * time since its own epoch, 6 January 1980; none or 0: not known. */
inline constexpr const char* GpsEpoch = "GpsEpoch";

///@{
/** Pulses and echoes: point data. */
inline constexpr const char* PulseIds = "PulseIds";   // int64, emission index over the run
inline constexpr const char* Direction = "Direction"; // unit vector
inline constexpr const char* ScanAngle = "ScanAngle"; // [deg]
inline constexpr const char* ChannelIds = "ChannelIds";
inline constexpr const char* Hit = "Hit";                   // 1: the pulse has an echo
inline constexpr const char* ReturnNumber = "ReturnNumber"; // from 1
inline constexpr const char* NumberOfReturns = "NumberOfReturns";
inline constexpr const char* Range = "Range";         // [m]
inline constexpr const char* Amplitude = "Amplitude"; // [W]
inline constexpr const char* EchoWidth = "EchoWidth"; // [ns], full width at half maximum, two-way
inline constexpr const char* Deviation = "Deviation"; // RMS residual of a fit over its amplitude
inline constexpr const char* ClassificationIds = "ClassificationIds";
inline constexpr const char* CellIds = "CellIds";               // of the scene
inline constexpr const char* IncidenceAngle = "IncidenceAngle"; // [deg], from the normal
inline constexpr const char* WaveformIds = "WaveformIds";       // pulse id, -1: not stored
inline constexpr const char* TruePoint = "TruePoint";           // without noise
inline constexpr const char* Normal = "Normal";
inline constexpr const char* Weight = "Weight"; // a sub-ray's share of the pulse's energy
///@}

///@{
/** Clouds of LAS files: point data that echoes have not. */
inline constexpr const char* Intensity = "Intensity";               // 16 bits
inline constexpr const char* NearInfrared = "NearInfrared";         // 16 bits
inline constexpr const char* UserData = "UserData";                 // 8 bits
inline constexpr const char* ScanDirection = "ScanDirection";       // 1: to larger angles
inline constexpr const char* EdgeOfFlightLine = "EdgeOfFlightLine"; // 1: the last before a turn
// bits 1 synthetic, 2 key point, 4 withheld, 8 overlap
inline constexpr const char* ClassificationFlags = "ClassificationFlags";
///@}

///@{
/** Waveforms: columns of the table, and Samples in its field data. */
inline constexpr const char* Origin = "Origin";           // [m]
inline constexpr const char* StartTime = "StartTime";     // [ns], two-way, after the emission
inline constexpr const char* BinSize = "BinSize";         // [ns]
inline constexpr const char* Offset = "Offset";           // of the first sample
inline constexpr const char* Count = "Count";             // of samples
inline constexpr const char* Samples = "Samples";         // float32 [W]
inline constexpr const char* PulseLength = "PulseLength"; // [ns], one value in the field data
///@}

///@{
/** Planning: point data of candidates (Visibility to Selected) and of visibility test points. */
inline constexpr const char* Slope = "Slope";               // [deg], from the horizontal
inline constexpr const char* Visibility = "Visibility";     // a bit a test point, in 64-bit words
inline constexpr const char* ViewshedSize = "ViewshedSize"; // test points seen
inline constexpr const char* Exclusivity = "Exclusivity"; // test points no other selected one sees
inline constexpr const char* MeanIncidenceAngle = "MeanIncidenceAngle"; // [deg]
inline constexpr const char* Selected = "Selected";                     // 1: scan from here
inline constexpr const char* NewlyCovered = "NewlyCovered";   // test points a selected one adds
inline constexpr const char* Area = "Area";                   // [m2] a test point stands for
inline constexpr const char* Coverable = "Coverable";         // 1: some candidate sees it
inline constexpr const char* NumberOfScans = "NumberOfScans"; // selected candidates that see it
inline constexpr const char* BestIncidenceAngle = "BestIncidenceAngle"; // [deg]; NaN: none
///@}

///@{
/** Field data of planned candidates: one value each. */
inline constexpr const char* PlanNumberOfSelected = "Plan.NumberOfSelected";
inline constexpr const char* PlanNumberCovered = "Plan.NumberCovered";         // test points
inline constexpr const char* PlanNumberCoverable = "Plan.NumberCoverable";     // test points
inline constexpr const char* PlanCoverage = "Plan.Coverage";                   // [%] of all
inline constexpr const char* PlanCoverableCoverage = "Plan.CoverableCoverage"; // [%]
inline constexpr const char* PlanLowerBound = "Plan.LowerBound";               // scans
inline constexpr const char* PlanBestBound = "Plan.BestBound";                 // whole scans
inline constexpr const char* PlanGap = "Plan.Gap";                             // [%]
inline constexpr const char* PlanIsProvedOptimal = "Plan.IsProvedOptimal";
inline constexpr const char* PlanWorstIncidenceAngle = "Plan.WorstIncidenceAngle";       // [deg]
inline constexpr const char* PlanMeanBestIncidenceAngle = "Plan.MeanBestIncidenceAngle"; // [deg]
///@}

} // namespace vtkHeliosArrayNames

#endif
