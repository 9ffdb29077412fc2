# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Made by Python/make_stubs.py from vtkHelios*ArrayNames.h; do not edit.
"""Names of all arrays that vtkHelios reads or writes.

>>> from vtkhelios.array_names import AMPLITUDE, GPS_TIME
>>> cloud[GPS_TIME]
"""

# Scene: cell data. MaterialIds indexes the material columns, PartIds the scene parts.
MATERIAL_IDS = "MaterialIds"
PART_IDS = "PartIds"
NORMALS = "Normals"  # unit vectors; used for incidence if present
EDGE_DEFECTS = "EdgeDefects"  # bits, see vtkHeliosMeshRepair
# u v of each of the three corners; NaN: none
TEXTURE_COORDINATES = "TextureCoordinates"

# Instances of a scene (vtkHeliosScene): point data, with Orientation, MaterialIds, PartIds.
PROTOTYPE_IDS = "PrototypeIds"
SCALE = "Scale"
FIRST_CELL_IDS = "FirstCellIds"  # int64, of the first triangle
MOTION_IDS = "MotionIds"  # -1: at rest

# Input clouds: point data (with Normals); scenes made from clouds: cell data. RGB of echoes:
# vtkHeliosScanner, GenerateColors.
RGB = "RGB"  # [0..1]
VOXEL_IDS = "VoxelIds"  # solid voxel that a triangle bounds

# Scene: material columns in the field data, one row per material.
MATERIAL_NAME = "Material.Name"
MATERIAL_REFLECTANCE = "Material.Reflectance"  # [0..1], NaN: not set
MATERIAL_SPECULARITY = "Material.Specularity"  # [0..1]
MATERIAL_SPECULAR_EXPONENT = "Material.SpecularExponent"
MATERIAL_CLASSIFICATION = "Material.Classification"
MATERIAL_IS_GROUND = "Material.IsGround"
MATERIAL_SPECTRUM = "Material.Spectrum"
# Mirrors and glass: columns that only scenes with them have. 1 mirror, 2 pane, 3 volume, 4 water,
# 5 leaf, 6 retroreflector
MATERIAL_OPTICS = "Material.Optics"
# 0 none, 1 water, 2 soda-lime glass, 3 BK7, 4 fused silica
MATERIAL_DISPERSION = "Material.Dispersion"
MATERIAL_MIRROR_REFLECTANCE = "Material.MirrorReflectance"  # [0..1]
MATERIAL_REFRACTIVE_INDEX = "Material.RefractiveIndex"
MATERIAL_THICKNESS = "Material.Thickness"  # pane only [m]
MATERIAL_ATTENUATION = "Material.Attenuation"  # inside [1/m]
MATERIAL_BACKSCATTER = "Material.Backscatter"  # [1/(m sr)]
MATERIAL_TRANSMITTANCE = "Material.Transmittance"  # [0..1]
MATERIAL_RETROREFLECTION = "Material.Retroreflection"  # [1/sr]
MATERIAL_MEAN_SQUARE_SLOPE = "Material.MeanSquareSlope"
# Columns that only scenes read with colours have.
MATERIAL_COLOR = "Material.Color"  # red green blue, [0..1]
MATERIAL_TEXTURE = "Material.Texture"  # path of an image

# Scene: field data. CRS is a WKT string or "EPSG:n".
CRS = "CRS"
PART_NAME = "Part.Name"
NOTES = "Notes"  # sentences on triangles that readers cut

# Raster of heights: point data of an image, pixel by pixel, and its field data.
HEIGHTS = "Heights"  # [m], NaN: none
GEO_TRANSFORM = "GeoTransform"  # six values, in GDAL's order

# Turbid voxels: cell data of an image, and its field data.
PAD = "PAD"  # plant area density [m2/m3], NaN: unknown
TRANSMITTANCE = "Transmittance"  # [0..1], NaN: unknown
MAXIMUM_PAD = "MaximumPAD"  # one value
LEAF_PROJECTION = "LeafProjection"  # rows x y z G(direction)

# Waypoints: point data.
SPEED = "Speed"  # [m/s] towards the next waypoint
ON_GROUND = "OnGround"  # 1: z is set from the ground below
STOP_AND_TURN = "StopAndTurn"  # 1: a multicopter stops and turns there
SMOOTH_TURN = "SmoothTurn"  # 1: it cuts the corner there
YAW_AT_DEPARTURE = "YawAtDeparture"  # [deg], NaN: not set

# Trajectory: point data.
GPS_TIME = "GpsTime"  # [s] since GpsEpoch
ORIENTATION = "Orientation"  # unit quaternion w x y z, body to world
VELOCITY = "Velocity"  # [m/s]
LEG_IDS = "LegIds"
CLEARANCE = "Clearance"  # [m] to the scene, see vtkHeliosClearance

# Trajectory and clouds: field data. Epoch of GpsTime: one value, seconds of GPS time since 6
# January 1980. Missing or 0: unknown.
GPS_EPOCH = "GpsEpoch"

# Pulses and echoes: point data.
PULSE_IDS = "PulseIds"  # int64, emission index over the run
DIRECTION = "Direction"  # unit vector
SCAN_ANGLE = "ScanAngle"  # [deg]
SCAN_DIRECTION_FLAG = "ScanDirectionFlag"  # 1: toward larger angles
EDGE_OF_FLIGHT_LINE = "EdgeOfFlightLine"  # 1: last pulse of a scan line
CHANNEL_IDS = "ChannelIds"
COLUMN_IDS = "ColumnIds"  # int64, of spinning optics, in a revolution
HIT = "Hit"  # 1: the pulse has an echo
RETURN_NUMBER = "ReturnNumber"  # from 1
NUMBER_OF_RETURNS = "NumberOfReturns"
RANGE = "Range"  # [m]
AMPLITUDE = "Amplitude"  # [W]
RELATIVE_AMPLITUDE = "RelativeAmplitude"  # [dB] above the threshold
REFLECTANCE = "Reflectance"  # [dB] above a white diffuse plane
ECHO_WIDTH = "EchoWidth"  # [ns], full width at half maximum, two-way
DEVIATION = "Deviation"  # RMS residual of a fit over its amplitude
CLASSIFICATION_IDS = "ClassificationIds"
CELL_IDS = "CellIds"  # cells of the scene
INCIDENCE_ANGLE = "IncidenceAngle"  # [deg], from the normal
WAVEFORM_IDS = "WaveformIds"  # pulse id, -1: not stored
TRUE_POINT = "TruePoint"  # [m], without noise
WATER_DEPTH = "WaterDepth"  # [m], by vtkHeliosRefractionCorrection
SCATTERED_AMPLITUDE = "ScatteredAmplitude"  # [W], of light that was scattered more than once
SCATTERED_DEVIATION = "ScatteredDeviation"  # [W], its standard error
SPECULAR_EVENTS = "SpecularEvents"  # mirrors and glass on the way
NORMAL = "Normal"
RADIAL_VELOCITY = "RadialVelocity"  # [m/s], positive: moves away
PART_POSITION = "PartPosition"  # [m], shift of the part's centroid
PART_ORIENTATION = "PartOrientation"  # quaternion w x y z, since the start
PART_VELOCITY = "PartVelocity"  # [m/s], of the true point
WEIGHT = "Weight"  # energy fraction of a sub-ray in the pulse

# Clouds of LAS files: point data that echoes do not have.
INTENSITY = "Intensity"  # 16 bits
NEAR_INFRARED = "NearInfrared"  # 16 bits
USER_DATA = "UserData"  # 8 bits
# bits 1 synthetic, 2 key point, 4 withheld, 8 overlap
CLASSIFICATION_FLAGS = "ClassificationFlags"

# Waveforms: columns of the table, and Samples in its field data.
ORIGIN = "Origin"  # [m]
START_TIME = "StartTime"  # [ns], two-way, after the emission
BIN_SIZE = "BinSize"  # [ns]
OFFSET = "Offset"  # index of the first sample
COUNT = "Count"  # number of samples
SAMPLES = "Samples"  # float32 [W]
PULSE_LENGTH = "PulseLength"  # [ns], one value in the field data
PULSE_SAMPLES = "PulseSamples"  # rows [ns], power, in the field data

# Planning: point data of candidates (Visibility to Selected) and of visibility test points.
SLOPE = "Slope"  # [deg], from the horizontal
VISIBILITY = "Visibility"  # one bit per test point, in 64-bit words
VIEWSHED_SIZE = "ViewshedSize"  # number of visible test points
EXCLUSIVITY = "Exclusivity"  # test points no other selected sees
MEAN_INCIDENCE_ANGLE = "MeanIncidenceAngle"  # [deg]
SELECTED = "Selected"  # 1: scan from here
NEWLY_COVERED = "NewlyCovered"  # test points added by a selection
AREA = "Area"  # [m2] represented by a test point
COVERABLE = "Coverable"  # 1: visible from at least one candidate
NUMBER_OF_SCANS = "NumberOfScans"  # selected candidates that see it
BEST_INCIDENCE_ANGLE = "BestIncidenceAngle"  # [deg]; NaN: none

# Field data of planned candidates: one value each.
PLAN_NUMBER_OF_SELECTED = "Plan.NumberOfSelected"
PLAN_NUMBER_COVERED = "Plan.NumberCovered"  # test points
PLAN_NUMBER_COVERABLE = "Plan.NumberCoverable"  # test points
PLAN_COVERAGE = "Plan.Coverage"  # [%] of all
PLAN_COVERABLE_COVERAGE = "Plan.CoverableCoverage"  # [%]
PLAN_LOWER_BOUND = "Plan.LowerBound"  # scans
PLAN_BEST_BOUND = "Plan.BestBound"  # whole scans
PLAN_GAP = "Plan.Gap"  # [%]
PLAN_IS_PROVED_OPTIMAL = "Plan.IsProvedOptimal"
PLAN_WORST_INCIDENCE_ANGLE = "Plan.WorstIncidenceAngle"  # [deg]
PLAN_MEAN_BEST_INCIDENCE_ANGLE = "Plan.MeanBestIncidenceAngle"  # [deg]

# Waypoints: point data. 1: the scanner fires from there to the next waypoint.
ACTIVE = "Active"

# Cells of the ground: point data of their centres.
PULSE_DENSITY = "PulseDensity"  # [1/m2], of all strips
STRIP_DENSITY = "StripDensity"  # [1/m2], of the densest strip
NUMBER_OF_STRIPS = "NumberOfStrips"  # strips that reach the cell
FLYING_HEIGHT = "FlyingHeight"  # [m], of the nearest line above it

# Trees of a scene: field data, a value per part by PartIds, also of turbid voxels.
PART_TREE = "Part.Tree"  # number of the tree, -1: none
PART_SPECIES = "Part.Species"  # empty: not known

# Echoes of a scene with trees: point data, and field data with the names by number.
TREE_IDS = "TreeIds"  # number of the tree, -1: none
SPECIES_IDS = "SpeciesIds"  # row of Species.Name, -1: none
SPECIES_NAME = "Species.Name"
ORGAN_IDS = "OrganIds"  # 0 none, 1 leaf, 2 wood of a tree
ORGAN_NAME = "Organ.Name"  # none, leaf, wood

# Cells of vtkHeliosPlantAreaDensity: cell data of an image.
DENSITY_ERROR = "DensityError"  # [m2/m3], NaN: unknown
CELL_STATE = "CellState"  # 0 no beam, 1 seen, 2 shadowed, 3 saturated
NUMBER_OF_BEAMS = "NumberOfBeams"  # int64, that enter with some energy
NUMBER_OF_SHADOWED_BEAMS = "NumberOfShadowedBeams"  # int64, without any
GROUND_DISTANCE = "GroundDistance"  # [m], of the centre, NaN: unknown
PATH_LENGTH = "PathLength"  # [m], free, of all energy

# Sums over the beams of a cell, to which further scans are added; energies are in pulses, paths
# times G.
ENTERING_ENERGY = "EnteringEnergy"
INTERCEPTED_ENERGY = "InterceptedEnergy"
INTERCEPTED_SQUARE = "InterceptedSquare"  # sum of squares, a beam each
FREE_PATH = "FreePath"  # [m]
HIT_PATH = "HitPath"  # [m], of squared intercepted energy
POTENTIAL_PATH = "PotentialPath"  # [m], without plants
POTENTIAL_PATH_SQUARE = "PotentialPathSquare"  # [m2]

# Field data: the steps of the three coordinates in the file, in their units, and, if the
# coordinates are unchanged, the three offsets of the file.
COORDINATE_SCALE = "CoordinateScale"

# Clouds of the PCL filters: point data.
CLUSTER_IDS = "ClusterIds"  # from 0, the largest; -1: no cluster
PLANE_IDS = "PlaneIds"  # from 0, in the order found; -1: no plane
CURVATURE = "Curvature"  # [0..1/3], see vtkHeliosPCLNormals
NUMBER_OF_POINTS = "NumberOfPoints"  # represented by a point

# Field data of planes: one row each.
PLANE_COEFFICIENTS = "Plane.Coefficients"  # a b c d, unit normal
PLANE_CENTRE = "Plane.Centre"  # [m]
PLANE_DEVIATION = "Plane.Deviation"  # [m], root mean square

# Field data of a registered cloud: 16 numbers, row by row.
REGISTRATION_MATRIX = "Registration.Matrix"

# Poses of scans: point data.
SCENE_IDS = "SceneIds"  # int64, from 0

# Field data of the echoes of scans: int64, where each begins, and the end.
OFFSETS = "Offsets"

# Units of the arrays that have one.
UNITS = {
    HEIGHTS: "m",
    SPEED: "m/s",
    YAW_AT_DEPARTURE: "deg",
    GPS_TIME: "s",
    VELOCITY: "m/s",
    CLEARANCE: "m",
    SCAN_ANGLE: "deg",
    RANGE: "m",
    AMPLITUDE: "W",
    RELATIVE_AMPLITUDE: "dB",
    REFLECTANCE: "dB",
    ECHO_WIDTH: "ns",
    INCIDENCE_ANGLE: "deg",
    TRUE_POINT: "m",
    WATER_DEPTH: "m",
    SCATTERED_AMPLITUDE: "W",
    SCATTERED_DEVIATION: "W",
    RADIAL_VELOCITY: "m/s",
    PART_POSITION: "m",
    PART_VELOCITY: "m/s",
    ORIGIN: "m",
    START_TIME: "ns",
    BIN_SIZE: "ns",
    PULSE_LENGTH: "ns",
    SLOPE: "deg",
    MEAN_INCIDENCE_ANGLE: "deg",
    AREA: "m2",
    BEST_INCIDENCE_ANGLE: "deg",
    PLAN_COVERAGE: "%",
    PLAN_COVERABLE_COVERAGE: "%",
    PLAN_GAP: "%",
    PLAN_WORST_INCIDENCE_ANGLE: "deg",
    PLAN_MEAN_BEST_INCIDENCE_ANGLE: "deg",
    FLYING_HEIGHT: "m",
    DENSITY_ERROR: "m2/m3",
    GROUND_DISTANCE: "m",
    PATH_LENGTH: "m",
    FREE_PATH: "m",
    HIT_PATH: "m",
    POTENTIAL_PATH: "m",
    POTENTIAL_PATH_SQUARE: "m2",
    PLANE_CENTRE: "m",
    PLANE_DEVIATION: "m",
}
