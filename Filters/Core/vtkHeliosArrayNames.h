// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosArrayNames
 * @brief   names of all arrays that vtkHelios reads or writes
 *
 * Echo arrays follow the spelling of LAS and PDAL; the others follow VTK. No
 * other file contains an array name literal. A comment begins with the unit
 * in brackets, if there is one.
 *
 * Python: vtkhelios/array_names.py, made from this file by Python/make_stubs.py.
 */

#ifndef vtkHeliosArrayNames_h
#define vtkHeliosArrayNames_h

namespace vtkHeliosArrayNames
{

///@{
/** Scene: cell data. MaterialIds indexes the material columns, PartIds the scene parts. */
inline constexpr const char* MaterialIds = "MaterialIds";
inline constexpr const char* PartIds = "PartIds";
inline constexpr const char* Normals = "Normals"; // unit vectors; used for incidence if present
inline constexpr const char* EdgeDefects = "EdgeDefects"; // bits, see vtkHeliosMeshRepair
// u v of each of the three corners; NaN: none
inline constexpr const char* TextureCoordinates = "TextureCoordinates";
///@}

///@{
/** Instances of a scene (vtkHeliosScene): point data, with Orientation, MaterialIds, PartIds. */
inline constexpr const char* PrototypeIds = "PrototypeIds";
inline constexpr const char* Scale = "Scale";
inline constexpr const char* FirstCellIds = "FirstCellIds"; // int64, of the first triangle
inline constexpr const char* MotionIds = "MotionIds";       // -1: at rest
///@}

///@{
/** Input clouds: point data (with Normals); scenes made from clouds: cell data. RGB of echoes:
 * vtkHeliosScanner, GenerateColors. */
inline constexpr const char* RGB = "RGB";           // [0..1]
inline constexpr const char* VoxelIds = "VoxelIds"; // solid voxel that a triangle bounds
///@}

///@{
/** Scene: material columns in the field data, one row per material. */
inline constexpr const char* MaterialName = "Material.Name";
inline constexpr const char* MaterialReflectance = "Material.Reflectance"; // [0..1], NaN: not set
inline constexpr const char* MaterialSpecularity = "Material.Specularity"; // [0..1]
inline constexpr const char* MaterialSpecularExponent = "Material.SpecularExponent";
inline constexpr const char* MaterialClassification = "Material.Classification";
inline constexpr const char* MaterialIsGround = "Material.IsGround";
inline constexpr const char* MaterialSpectrum = "Material.Spectrum";
// Mirrors and glass: columns that only scenes with them have. 1 mirror, 2 pane, 3 volume, 4 water,
// 5 leaf, 6 retroreflector
inline constexpr const char* MaterialOptics = "Material.Optics";
// 0 none, 1 water, 2 soda-lime glass, 3 BK7, 4 fused silica
inline constexpr const char* MaterialDispersion = "Material.Dispersion";
inline constexpr const char* MaterialMirrorReflectance = "Material.MirrorReflectance"; // [0..1]
inline constexpr const char* MaterialRefractiveIndex = "Material.RefractiveIndex";
inline constexpr const char* MaterialThickness = "Material.Thickness";             // pane only [m]
inline constexpr const char* MaterialAttenuation = "Material.Attenuation";         // inside [1/m]
inline constexpr const char* MaterialBackscatter = "Material.Backscatter";         // [1/(m sr)]
inline constexpr const char* MaterialTransmittance = "Material.Transmittance";     // [0..1]
inline constexpr const char* MaterialRetroreflection = "Material.Retroreflection"; // [1/sr]
inline constexpr const char* MaterialMeanSquareSlope = "Material.MeanSquareSlope";
// Columns that only scenes read with colours have.
inline constexpr const char* MaterialColor = "Material.Color";     // red green blue, [0..1]
inline constexpr const char* MaterialTexture = "Material.Texture"; // path of an image
///@}

///@{
/** Scene: field data. CRS is a WKT string or "EPSG:n". */
inline constexpr const char* CRS = "CRS";
inline constexpr const char* PartName = "Part.Name";
inline constexpr const char* Notes = "Notes"; // sentences on triangles that readers cut
///@}

///@{
/** Raster of heights: point data of an image, pixel by pixel, and its field data. */
inline constexpr const char* Heights = "Heights";           // [m], NaN: none
inline constexpr const char* GeoTransform = "GeoTransform"; // six values, in GDAL's order
///@}

///@{
/** Turbid voxels: cell data of an image, and its field data. */
inline constexpr const char* PAD = "PAD"; // plant area density [m2/m3], NaN: unknown
inline constexpr const char* Transmittance = "Transmittance";   // [0..1], NaN: unknown
inline constexpr const char* MaximumPAD = "MaximumPAD";         // one value
inline constexpr const char* LeafProjection = "LeafProjection"; // rows x y z G(direction)
///@}

///@{
/** Waypoints: point data. */
inline constexpr const char* Speed = "Speed";             // [m/s] towards the next waypoint
inline constexpr const char* OnGround = "OnGround";       // 1: z is set from the ground below
inline constexpr const char* StopAndTurn = "StopAndTurn"; // 1: a multicopter stops and turns there
inline constexpr const char* SmoothTurn = "SmoothTurn";   // 1: it cuts the corner there
inline constexpr const char* YawAtDeparture = "YawAtDeparture"; // [deg], NaN: not set
///@}

///@{
/** Trajectory: point data. */
inline constexpr const char* GpsTime = "GpsTime";         // [s] since GpsEpoch
inline constexpr const char* Orientation = "Orientation"; // unit quaternion w x y z, body to world
inline constexpr const char* Velocity = "Velocity";       // [m/s]
inline constexpr const char* LegIds = "LegIds";
inline constexpr const char* Clearance = "Clearance"; // [m] to the scene, see vtkHeliosClearance
///@}

/** Trajectory and clouds: field data. Epoch of GpsTime: one value, seconds of GPS
 * time since 6 January 1980. Missing or 0: unknown. */
inline constexpr const char* GpsEpoch = "GpsEpoch";

///@{
/** Pulses and echoes: point data. */
inline constexpr const char* PulseIds = "PulseIds";   // int64, emission index over the run
inline constexpr const char* Direction = "Direction"; // unit vector
inline constexpr const char* ScanAngle = "ScanAngle"; // [deg]
inline constexpr const char* ScanDirectionFlag = "ScanDirectionFlag"; // 1: toward larger angles
inline constexpr const char* EdgeOfFlightLine = "EdgeOfFlightLine"; // 1: last pulse of a scan line
inline constexpr const char* ChannelIds = "ChannelIds";
inline constexpr const char* ColumnIds = "ColumnIds"; // int64, of spinning optics, in a revolution
inline constexpr const char* Hit = "Hit";             // 1: the pulse has an echo
inline constexpr const char* ReturnNumber = "ReturnNumber"; // from 1
inline constexpr const char* NumberOfReturns = "NumberOfReturns";
inline constexpr const char* Range = "Range";                         // [m]
inline constexpr const char* Amplitude = "Amplitude";                 // [W]
inline constexpr const char* RelativeAmplitude = "RelativeAmplitude"; // [dB] above the threshold
inline constexpr const char* Reflectance = "Reflectance"; // [dB] above a white diffuse plane
inline constexpr const char* EchoWidth = "EchoWidth"; // [ns], full width at half maximum, two-way
inline constexpr const char* Deviation = "Deviation"; // RMS residual of a fit over its amplitude
inline constexpr const char* ClassificationIds = "ClassificationIds";
inline constexpr const char* CellIds = "CellIds";               // cells of the scene
inline constexpr const char* IncidenceAngle = "IncidenceAngle"; // [deg], from the normal
inline constexpr const char* WaveformIds = "WaveformIds";       // pulse id, -1: not stored
inline constexpr const char* TruePoint = "TruePoint";           // [m], without noise
inline constexpr const char* WaterDepth = "WaterDepth"; // [m], by vtkHeliosRefractionCorrection
inline constexpr const char* ScatteredAmplitude =
  "ScatteredAmplitude"; // [W], of light that was scattered more than once
inline constexpr const char* ScatteredDeviation = "ScatteredDeviation"; // [W], its standard error
inline constexpr const char* SpecularEvents = "SpecularEvents"; // mirrors and glass on the way
inline constexpr const char* Normal = "Normal";
inline constexpr const char* RadialVelocity = "RadialVelocity"; // [m/s], positive: moves away
inline constexpr const char* PartPosition = "PartPosition";     // [m], shift of the part's centroid
inline constexpr const char* PartOrientation =
  "PartOrientation";                                        // quaternion w x y z, since the start
inline constexpr const char* PartVelocity = "PartVelocity"; // [m/s], of the true point
inline constexpr const char* Weight = "Weight"; // energy fraction of a sub-ray in the pulse
///@}

///@{
/** Clouds of LAS files: point data that echoes do not have. */
inline constexpr const char* Intensity = "Intensity";       // 16 bits
inline constexpr const char* NearInfrared = "NearInfrared"; // 16 bits
inline constexpr const char* UserData = "UserData";         // 8 bits
// bits 1 synthetic, 2 key point, 4 withheld, 8 overlap
inline constexpr const char* ClassificationFlags = "ClassificationFlags";
///@}

///@{
/** Waveforms: columns of the table, and Samples in its field data. */
inline constexpr const char* Origin = "Origin";             // [m]
inline constexpr const char* StartTime = "StartTime";       // [ns], two-way, after the emission
inline constexpr const char* BinSize = "BinSize";           // [ns]
inline constexpr const char* Offset = "Offset";             // index of the first sample
inline constexpr const char* Count = "Count";               // number of samples
inline constexpr const char* Samples = "Samples";           // float32 [W]
inline constexpr const char* PulseLength = "PulseLength";   // [ns], one value in the field data
inline constexpr const char* PulseSamples = "PulseSamples"; // rows [ns], power, in the field data
///@}

///@{
/** Planning: point data of candidates (Visibility to Selected) and of visibility test points. */
inline constexpr const char* Slope = "Slope";           // [deg], from the horizontal
inline constexpr const char* Visibility = "Visibility"; // one bit per test point, in 64-bit words
inline constexpr const char* ViewshedSize = "ViewshedSize"; // number of visible test points
inline constexpr const char* Exclusivity = "Exclusivity";   // test points no other selected sees
inline constexpr const char* MeanIncidenceAngle = "MeanIncidenceAngle"; // [deg]
inline constexpr const char* Selected = "Selected";                     // 1: scan from here
inline constexpr const char* NewlyCovered = "NewlyCovered"; // test points added by a selection
inline constexpr const char* Area = "Area";                 // [m2] represented by a test point
inline constexpr const char* Coverable = "Coverable"; // 1: visible from at least one candidate
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
