// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlNotes.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace helios
{

namespace
{

// One row per name: element, name, description, default, choices.
// clang-format off
const XmlNote Notes[] = {
  { "", "id", "identifier for references" },
  { "", "name", "a title" },
  { "", "template", "settings of the same kind used as defaults; values given here override them" },
  { "", "crs", "coordinate system, as EPSG:n, WKT or PROJ", "the scene's" },
  { "", "x", "coordinate to the right, or east", "0" },
  { "", "y", "coordinate forward, or north", "0" },
  { "", "z", "coordinate up", "0" },
  { "", "rotations", "whether each rot rotates about fixed axes (global) or about the axes already rotated (local)",
    "global", "global local" },
  { "", "rangeTolerance_m", "tolerance of ranges (root mean square) in adaptive beam sampling", "0.001" },
  { "", "energyTolerance", "relative tolerance of amplitudes (root mean square) in adaptive beam sampling", "0.01" },
  { "", "echoDetector", "method of echo detection in waveforms", "peak", "peak gaussian cfd leadingEdge" },
  { "", "pulseShape", "gaussian, helios, or a text file of times [ns] and powers", "gaussian" },
  { "", "returnSelection", "the returns of a pulse that are kept", "all",
    "all first last strongest firstAndLast" },
  { "", "filepath", "the file", "" },
  { "", "efilepath", "a folder and a regular expression for file names; overrides filepath", "" },
  { "", "matfile", "an MTL file, the material of all cells", "the default material" },
  { "", "matname", "the material in matfile", "the alphabetically first" },
  { "", "randomMaterials", "number of additional materials with a random change of the reflectance" },
  { "", "randomRange", "maximum of that change, up or down", "1" },

  { "document", "", "the root of every file; its children may be mixed in any order" },

  { "survey", "", "a scene, the instrument and the legs. Of several surveys in a file the first is run" },
  { "survey", "name", "title and name of the output folder", "the name of the file" },
  { "survey", "id", "surveys are never referenced" },
  { "survey", "scanner", "the instrument, file.xml#id, #id or id", "that of each leg" },
  { "survey", "platform", "the platform that carries it; interpolated: a trajectory from files", "that of each leg" },
  { "survey", "scene", "the scene to scan", Required },
  { "survey", "rayCaster", "beam, embree, bvh, cgal or obbtree, if this build has it", "beam" },
  { "survey", "numRuns", "the caller decides; vtkhelios run runs once" },
  { "survey", "simSpeed", "speed of the display" },
  { "survey", "defaultScannerSettings", "no program reads it; give the legs a template" },
  { "survey", "basePlatform", "with platform=\"interpolated\": the platform whose mount and noise are used" },
  { "survey", "rotationSpec", "the angle convention of trajectory files", "ARINC 705", "ARINC 705|CANONICAL" },
  { "survey", "seed", "seed of the random numbers: an integer, YYYY-MM-DD hh:mm:ss or AUTO; --seed overrides it", "AUTO" },
  { "survey", "legRandomOffset", "leg offset noise: whether each leg position gets one random offset", "false" },
  { "survey", "legRandomOffsetMean", "mean of that offset", "0" },
  { "survey", "legRandomOffsetStdev", "standard deviation of that offset", "0.1" },

  { "surveyPlanner", "", "planning of scan positions by vtkhelios plan: PSP are potential scan positions, VTP are visibility test points. Of several in a file the first is used" },
  { "surveyPlanner", "id", "used as the name if there is no name" },
  { "surveyPlanner", "name", "name of the output folder and of the survey in it", "the id, else the name of the file" },
  { "surveyPlanner", "scene", "the scene to scan", Required },
  { "surveyPlanner", "platform", "the platform that carries the scanner; it must be static", Required },
  { "surveyPlanner", "scanner", "the instrument", Required },
  { "surveyPlanner", "method", "reduce: removes positions in the order of pspRemoveOrder; bestcoverage, greedy: adds the best position; best: reduces the problem first; optimal: proves the minimum number",
    "reduce", "reduce bestcoverage greedy best optimal" },
  { "surveyPlanner", "pspRemoveOrder", "reduce: criterion by which positions are removed", "viewshedSize",
    "viewshedSize meanIncidenceAngle" },
  { "surveyPlanner", "pspRemoveFirst", "reduce: whether the smallest or the largest value is removed first", "smallest", "smallest largest" },
  { "surveyPlanner", "minCoverage_percent", "share of the test points that must be visible from the selected positions", "100" },
  { "surveyPlanner", "coverageOf", "base of the coverage: the test points visible from any position, or all", "coverable", "coverable all" },
  { "surveyPlanner", "gridSizePSP_m", "spacing of potential scan positions along x", "a twentieth of the scene's diagonal" },
  { "surveyPlanner", "gridSizePSPy_m", "spacing along y", "gridSizePSP_m" },
  { "surveyPlanner", "gridSizeVTP_m", "spacing of test points", "gridSizePSP_m" },
  { "surveyPlanner", "vtpLines", "test points are the intersections of surfaces with lines of these directions", "all", "all vertical horizontal" },
  { "surveyPlanner", "maxSlope_deg", "steeper places are excluded as scan positions", "15" },
  { "surveyPlanner", "groundOnly", "scan positions on ground only, by helios_isGround of materials; auto: if any material is ground; open: with nothing above",
    "auto", "~auto true false 1 0 open" },
  { "surveyPlanner", "enclosed", "whether places enclosed on all sides are used if there are others", "false" },
  { "surveyPlanner", "scannerHeight_m", "height of the instrument above the scan position", "from the platform" },
  { "surveyPlanner", "hitTolerance_m", "a test point is visible if the ray ends at most this far before it", "0.05" },
  { "surveyPlanner", "hitBehind", "whether a test point is also visible if the ray ends more than hitTolerance_m behind it; false is the test of Bechtold and Hoefle (2016)", "true" },
  { "surveyPlanner", "scannerLimits", "whether ranges and field of view of the scanner limit visibility", "false" },
  { "surveyPlanner", "rangeMin_m", "minimum range of visibility", "0, or the scanner's" },
  { "surveyPlanner", "rangeMax_m", "maximum range of visibility", "no limit, or the scanner's" },
  { "surveyPlanner", "elevationMin_deg", "minimum elevation angle of visibility, from the horizontal", "-90, or the scanner's" },
  { "surveyPlanner", "elevationMax_deg", "maximum elevation angle", "90, or the scanner's" },
  { "surveyPlanner", "maxIncidence_deg", "maximum incidence angle, from the surface normal", "90" },
  { "surveyPlanner", "minPointDensity_1_m2", "minimum point density from one scan position", "0" },
  { "surveyPlanner", "areaWeights", "whether test points are weighted by the area they represent", "false" },
  { "surveyPlanner", "minOverlap_percent", "share of its test points that each scan must share with the others", "0" },
  { "surveyPlanner", "timeLimit_s", "optimal: limit of the search time", "300" },
  { "surveyPlanner", "interactive", "the Java program prompts between its steps" },

  { "leg", "", "a scan position; on a moving platform, the trajectory to the next leg" },
  { "leg", "id", "legs are numbered 0, 1, 2 ... in the order of the file" },
  { "leg", "maxDuration_s", "ends the leg after this time; negative: never; overrides scannerSettings", "-1" },
  { "leg", "stripId", "legs with the same value write one file" },
  { "leg", "x", "position in a scan of the Java program", "0" },
  { "leg", "y", "position in a scan of the Java program", "0" },
  { "leg", "z", "position in a scan of the Java program", "0" },
  { "leg", "platform", "the platform of this leg", "the survey's" },
  { "leg", "scanner", "the scanner of this leg", "the survey's" },
  { "maxDuration_s", "", "the attribute of the same name, as a child element" },
  { "scan", "", "legs with their own platform and scanner, as written by the planner of the Java program" },
  { "scan", "id", "scans are never referenced" },
  { "scan", "platform", "the platform of its legs", "the survey's" },
  { "scan", "scanner", "the scanner of its legs", "the survey's" },
  { "scannerRotation", "", "head rotation on each leg, at maximum speed" },
  { "scannerRotation", "axis", "the head rotates about its own axis" },
  { "scannerRotation", "angle", "given by start and end" },
  { "scannerRotation", "start", "head angle at the start of a leg", "0" },
  { "scannerRotation", "end", "head angle at its end", "0" },

  { "platformSettings", "", "start and motion of a leg; at the top level, a template" },
  { "platformSettings", "name", "templates are referenced by id" },
  { "platformSettings", "x", "position", "0" },
  { "platformSettings", "y", "position", "0" },
  { "platformSettings", "z", "position; onGround replaces it", "0" },
  { "platformSettings", "onGround", "whether z is the height of the ground below", "false" },
  { "platformSettings", "movePerSec_m", "speed to the next leg; maximum speed of vehicles", "70" },
  { "platformSettings", "stopAndTurn", "multicopter: stops at the waypoint, turns, and starts from rest", "true" },
  { "platformSettings", "smoothTurn", "multicopter: turns in flight; overrides stopAndTurn", "false" },
  { "platformSettings", "slowdownEnabled", "multicopter: slows down before waypoints and in turns", "true" },
  { "platformSettings", "yawAtDeparture_deg", "multicopter: heading at departure, anticlockwise from north", "to the next leg" },
  { "platformSettings", "trajectory", "interpolated platform: the file of its trajectory" },
  { "platformSettings", "trajectory_seperator", "trajectory_separator in the spelling of HELIOS++" },
  { "platformSettings", "trajectory_separator", "column separator of the trajectory file", "," },
  { "platformSettings", "tIndex", "column of time, from 0", "0" },
  { "platformSettings", "rollIndex", "column of roll", "1" },
  { "platformSettings", "pitchIndex", "column of pitch", "2" },
  { "platformSettings", "yawIndex", "column of yaw", "3" },
  { "platformSettings", "xIndex", "column of x", "4" },
  { "platformSettings", "yIndex", "column of y", "5" },
  { "platformSettings", "zIndex", "column of z", "6" },
  { "platformSettings", "interpolationDomain", "which columns the trajectory file has", "position_and_attitude",
    "position position_and_attitude" },
  { "platformSettings", "toRadians", "true: the angles in the file are degrees; false: radians", "true" },
  { "platformSettings", "syncGPSTime", "whether GPS time is the time in the file", "false" },
  { "platformSettings", "slopeFilterThreshold", "thins straight parts of the trajectory; 0: no thinning", "0" },
  { "platformSettings", "tStart", "time in the file at the start of the leg", "the first one" },
  { "platformSettings", "tEnd", "time in the file at the end of the leg", "the last one" },
  { "platformSettings", "teleportToStart", "whether the platform jumps to the start of the leg", "false" },

  { "scannerSettings", "", "scan parameters of a leg, or of all legs of a plan; at the top level, a template" },
  { "scannerSettings", "name", "templates are referenced by id" },
  { "scannerSettings", "active", "whether the leg fires pulses", "true" },
  { "scannerSettings", "pulseFreq_hz", "pulse frequency; a value not in pulseFreqs_Hz causes a warning", "the first of pulseFreqs_Hz" },
  { "scannerSettings", "scanFreq_hz", "lines, mirror cycles or revolutions per second; clipped to the limits of the scanner", "0" },
  { "scannerSettings", "scanAngle_deg", "half angle, clipped to that of the scanner; 0: that of the scanner", "scanAngleMax_deg" },
  { "scannerSettings", "verticalAngleMin_deg", "rotating: vertical FOV min, as a mirror angle", "-scanAngle_deg" },
  { "scannerSettings", "verticalAngleMax_deg", "rotating: vertical FOV max; the window is clipped to the width of the scanner's", "scanAngle_deg" },
  { "scannerSettings", "headRotatePerSec_deg", "head rotation speed; clipped to the limit of the scanner", "0" },
  { "scannerSettings", "headRotateStart_deg", "horizontal FOV start: head angle at the start of the leg", "0" },
  { "scannerSettings", "headRotateStop_deg", "horizontal FOV end: head angle at the end of the leg, on a static platform", "0" },
  { "scannerSettings", "beamDivergence_rad", "full angle at 1/e2", "the scanner's" },
  { "scannerSettings", "beamDivergenceRad", "beamDivergence_rad in the spelling of some schemas", "the scanner's" },
  { "scannerSettings", "trajectoryTimeInterval_s", "time between two samples of the trajectory; 0: start and end only", "0" },
  { "scannerSettings", "maxDuration_s", "ends the leg after this time; negative: never", "-1" },
  { "scannerSettings", "verticalResolution_deg", "rotating: angle between pulses of a line; sets scanFreq_hz", "0" },
  { "scannerSettings", "horizontalResolution_deg", "rotating: angle between lines; sets the head rotation speed", "0" },
  { "scannerSettings", "opticsWarmupPhase_s", "time that mirror and head move before the leg starts", "0" },
  { "scannerSettings", "beamSampleQuality", "give it in FWFSettings, as HELIOS does" },

  { "FWFSettings", "", "sampling, waveforms and echoes; that of a survey overrides that of its scanner" },
  { "FWFSettings", "id", "never referenced" },
  { "FWFSettings", "name", "never referenced" },
  { "FWFSettings", "binSize_ns", "bin size of the waveform; 1 ns is 0.15 m of range", "0.25" },
  { "FWFSettings", "beamSampleQuality", "circles of sub-rays, a fixed count per pulse: 1, 7, 19, 37 ... sub-rays", "adaptive sampling" },
  { "FWFSettings", "winSize_ns", "an echo within this time of a higher one is discarded", "0" },
  { "FWFSettings", "maxFullwaveRange_ns", "maximum length of the waveform; 0: as long as the target requires", "0" },
  { "FWFSettings", "apertureDiameter_m", "not used; a warning if it differs from receiverDiameter_m of the scanner" },
  { "FWFSettings", "apartureDiameter", "apertureDiameter_m in the spelling of the Java program" },
  { "FWFSettings", "numFullwaveBins", "maximum number of bins of a waveform", "as many as needed" },
  { "FWFSettings", "winSize", "winSize_ns, in bins", "0" },
  { "FWFSettings", "scannerEfficiency", "overrides opticalEfficiency of the scanner", "the scanner's" },
  { "FWFSettings", "atmosphericVisibility", "overrides atmosphericVisibility_km of the scanner", "the scanner's" },
  { "FWFSettings", "scannerWaveLength", "overrides wavelength_nm of the scanner", "the scanner's" },
  { "FWFSettings", "beamDivergence_rad", "overrides beamDivergence_rad of the scanner", "the scanner's" },
  { "FWFSettings", "pulseLength_ns", "overrides pulseLength_ns of the scanner", "the scanner's" },
  { "FWFSettings", "numTimeBins", "samples of the emitted pulse, which has a closed form here" },
  { "FWFSettings", "minEchoWidth", "unit and use differ between Java versions" },
  { "FWFSettings", "peakEnergy", "the power of the pulse is averagePower_w" },

  { "detectorSettings", "", "detector of a survey; overrides the values of the scanner" },
  { "detectorSettings", "accuracy_m", "overrides accuracy_m of the scanner", "the scanner's" },
  { "detectorSettings", "rangeMin_m", "overrides rangeMin_m of the scanner", "the scanner's" },
  { "detectorSettings", "rangeMax_m", "overrides rangeMax_m of the scanner", "the scanner's" },
  { "detectorSettings", "distanceMeasurementError", "factor of the range noise, an expression of the range t [m]", "1" },

  { "rangeError", "", "systematic error of ranges" },
  { "rangeError", "expr", "an expression of the mirror angle THETA [rad], in metres", Required },
  { "deflectionError", "", "systematic error of the mirror angle" },
  { "deflectionError", "expr", "an expression of the mirror angle THETA [rad], in radians", Required },
  { "headError", "", "systematic error of the head angle" },
  { "headError", "expr", "an expression of the mirror angle THETA [rad], in radians", Required },
  { "headError", "zeroSinThreshold_deg", "minimum distance of THETA from multiples of 180 degrees", "0" },

  { "scanner", "", "an instrument" },
  { "scanner", "optics", "beam deflector", Required, "rotating oscillating line conic palmer risley" },
  { "scanner", "pulseFreqs_Hz", "supported pulse frequencies, the default first", "that of the leg" },
  { "scanner", "pulseLength_ns", "full width at half maximum", "4" },
  { "scanner", "beamDivergence_rad", "full angle at 1/e2", "0.0003" },
  { "scanner", "wavelength_nm", "wavelength, at which reflectances are taken from spectra", "1064" },
  { "scanner", "averagePower_w", "peak power of the pulse", "4" },
  { "scanner", "opticalEfficiency", "transmission of the optics", "0.99" },
  { "scanner", "receiverDiameter_m", "diameter of the receiver aperture", "0.15" },
  { "scanner", "atmosphericVisibility_km", "visibility, which determines the extinction", "23" },
  { "scanner", "receivedEnergyMin_W", "detection threshold, the weakest echo; in nanowatts despite its name", "0.0001" },
  { "scanner", "accuracy_m", "standard deviation of the range", "0" },
  { "scanner", "rangeMin_m", "minimum range", "0" },
  { "scanner", "rangeMax_m", "maximum range", "no limit" },
  { "scanner", "maxNOR", "maximum number of returns per pulse; 0: all", "0" },
  { "scanner", "scanAngleMax_deg", "half of the angle that the mirror sweeps, or half angle of the cone", "0" },
  { "scanner", "scanAngleEffectiveMax_deg", "rotating: half of the vertical field of view", "scanAngleMax_deg" },
  { "scanner", "scanFreqMin_Hz", "minimum scan frequency", "0" },
  { "scanner", "scanFreqMax_Hz", "maximum scan frequency; 0: no limit", "0" },
  { "scanner", "headRotatePerSecMax_deg", "maximum head rotation speed", "0" },
  { "scanner", "deflectAngle_deg", "no program reads it" },
  { "scanner", "visModel", "model of the head in vtkhelios view, a file as for model of a platform; it rotates with the head", "a simple model" },
  { "scanner", "beamQualityFactor", "M2 of the beam; without it the beam has no waist" },
  { "scanner", "atmosphericExtinction_1_m", "extinction; overrides the visibility", "from the visibility" },
  { "scanner", "detectorNoise_nW", "standard deviation of waveform noise", "0" },
  { "scanner", "solarIrradiance_W_m2_nm", "solar irradiance of the scene", "0" },
  { "scanner", "filterBandwidth_nm", "optical bandwidth of the receiver", "1" },
  { "scanner", "fieldOfView_rad", "field of view of the receiver, full angle", "0.001" },
  { "scanner", "accuracyPerMeter", "range noise proportional to the range", "0" },
  { "scanner", "accuracyAtThreshold_m", "range noise of the weakest detectable echo", "0" },
  { "scanner", "angleAccuracy_rad", "standard deviation of the beam's direction", "0" },
  { "scanner", "scanProduct", "oscillating: maximum of scan angle times scan frequency", "1000000" },
  { "scanner", "scanPattern", "oscillating: motion of the mirror", "triangular", "triangular sinusoidal" },
  { "scanner", "turningPulses", "oscillating, triangular: pulses during which the mirror reverses", "0" },
  { "scanner", "numFibers", "line: number of fibres", "1" },
  { "scanner", "rotorFreq1_Hz", "risley: rotation frequency of the first prism; the sign is the direction", "0" },
  { "scanner", "rotorFreq2_Hz", "risley: rotation frequency of the second prism", "0" },
  { "scanner", "rotorFreq3_Hz", "risley: rotation frequency of the third prism", "0" },
  { "scanner", "angle1_deg", "risley: wedge angle of the first prism; the sign selects the inclined face; 0: no prism", "0" },
  { "scanner", "angle2_deg", "risley: wedge angle of the second prism", "0" },
  { "scanner", "angle3_deg", "risley: wedge angle of the third prism", "0" },
  { "scanner", "refrIndex1", "risley: refractive index of the first prism", "1" },
  { "scanner", "refrIndex2", "risley: refractive index of the second prism", "1" },
  { "scanner", "refrIndex3", "risley: refractive index of the third prism", "1" },
  { "scanner", "refrIndex_air", "risley: refractive index around the prisms", "1" },

  { "channels", "", "the channels of a multi-channel instrument" },
  { "channel", "", "an emitter and its receiver; values not given are those of its scanner" },
  { "channel", "id", "used in file names if channels are split", "its number" },
  { "incidentBeam", "", "risley: direction of the beam into the first prism", "0 1 0" },

  { "platform", "", "the carrier of the scanner" },
  { "platform", "type", "type of motion", "static", "static dummy linearpath groundvehicle multicopter" },
  { "platform", "model", "model for vtkhelios view: an OBJ file in m, x right, y forward, z up; not used in simulations", "a simple model" },
  { "platform", "visModel", "as model; model overrides it", "a simple model" },
  { "platform", "drag", "groundvehicle, multicopter: loss of speed per pulse; not used: vehicles have masses and forces" },
  { "platform", "engine_max_force", "multicopter: force per pulse; not used: thrust follows from the tilt" },
  { "platform", "speedup_magnitude", "multicopter: rate per pulse; not used" },
  { "platform", "slowdown_magnitude", "multicopter: rate per pulse; not used" },
  { "platform", "slowdown_distance", "multicopter: not used: it slows down as late as its maximum tilt allows" },
  { "platform", "base_pitch_deg", "multicopter: pitch in cruise at the highest speed of its legs" },
  { "platform", "roll_speed_deg", "multicopter: roll rate", "28.65" },
  { "platform", "pitch_speed_deg", "multicopter: pitch rate", "85.94" },
  { "platform", "yaw_speed_deg", "multicopter: yaw rate", "85.94" },
  { "platform", "roll_offset_deg", "multicopter: maximum roll", "25" },
  { "platform", "pitch_offset_deg", "multicopter: maximum pitch", "35" },

  { "positionXNoise", "", "noise of the platform's x [m]; that of a survey overrides that of its platform" },
  { "positionYNoise", "", "noise of the platform's y [m]" },
  { "positionZNoise", "", "noise of the platform's z [m]" },
  { "attitudeXNoise", "", "noise of the platform's attitude about x [rad]" },
  { "attitudeYNoise", "", "noise of the platform's attitude about y [rad]" },
  { "attitudeZNoise", "", "noise of the platform's attitude about z [rad]" },
  { "", "type", "distribution", "NORMAL", "~NORMAL UNIFORM" },
  { "", "mean", "mean of NORMAL", "0" },
  { "", "stdev", "standard deviation of NORMAL", "1" },
  { "", "min", "minimum of UNIFORM", "0" },
  { "", "max", "maximum of UNIFORM", "1" },
  { "", "clipEnabled", "whether values are clamped", "false" },
  { "", "clipMin", "lower limit", "0" },
  { "", "clipMax", "upper limit", "1" },
  { "", "fixedLifespan", "number of pulses for which a value is kept; 0: all", "1" },

  { "scannerMount", "", "position and orientation of the scanner on the platform" },
  { "beamOrigin", "", "position and orientation of the beam origin on the head" },
  { "headRotateAxis", "", "axis of the head rotation; not used if shorter than 0.1" },
  { "headRotateAxis", "z", "coordinate up", "1 without the element, else 0" },
  { "rot", "", "a right-handed rotation; several are applied in their order" },
  { "rot", "axis", "rotation axis; pitch, roll, yaw are x, y, z", Required, "x y z X Y Z pitch roll yaw" },
  { "rot", "angle_deg", "rotation angle", Required },
  { "origin", "", "offset of the following legs, of the Java program" },
  { "pointCloudColor", "", "colour of the display" },

  { "scene", "", "the parts to scan" },
  { "scene", "crs", "coordinate system of parts without one of their own, as EPSG:n, WKT or PROJ", "a local frame in metres" },
  { "scene", "dynStep", "pulses of a channel between updates of moving parts", "1" },
  { "scene", "dynTimeStep", "time between updates of moving parts, instead of dynStep", "as dynStep" },
  { "sunDir", "", "light of the display; sunlight as noise is solarIrradiance_W_m2_nm of the scanner" },
  { "sky", "", "background of the display" },
  { "skybox", "", "background of the display" },
  { "part", "", "a mesh: a loader, then filters that rotate, scale and move it, in this order" },
  { "part", "id", "name of the part, and object of its points", "its number" },
  { "part", "name", "the name of a part is its id" },
  { "part", "dynStep", "updates of the scene per update of the part", "1" },
  { "part", "dynTimeStep", "time between updates of the part: a multiple of the scene's dynTimeStep, if it has one", "as dynStep" },
  { "part", "kdtDynStep", "updates of the part per update of the geometry that rays see", "1" },
  { "part", "kdtDynTimeStep", "time between updates of the geometry that rays see", "as kdtDynStep" },
  { "color", "", "colour of the display" },
  { "swap", "", "geometry that replaces the part in later epochs of the survey" },
  { "dmotion", "", "motion of the part: each step applies all its motions, in their order; the first dmotion starts" },
  { "dmotion", "id", "identifier for next" },
  { "dmotion", "loop", "number of steps; 0: without end", Required },
  { "dmotion", "next", "id of the next dmotion; an earlier one makes a cycle", "none: the part stops" },
  { "motion", "", "one motion of a step" },
  { "motion", "type", "type of motion", Required,
    "~identity translation rotation reflection glideplane helical rotsym" },
  { "motion", "vec", "translation: displacement per step" },
  { "motion", "axis", "rotation, helical, rotsym: rotation axis, right-handed" },
  { "motion", "angle", "angle per step", "0" },
  { "motion", "center", "rotation, rotsym: a point on the axis", "0;0;0" },
  { "motion", "ortho", "reflection, glideplane: normal of the plane through 0;0;0" },
  { "motion", "shift", "glideplane: displacement in the plane", "0;0;0" },
  { "motion", "glide", "helical: displacement along the axis per step", "0" },
  { "motion", "selfMode", "whether 0;0;0 is the current centroid of the part", "false" },
  { "motion", "autoCRS", "not needed: scenes are not shifted, coordinates are always those of the scene" },
  { "swap", "swapStep", "number of epochs", "1" },
  { "swap", "keepCRS", "whether its geometry is shifted with the scene; scenes are not shifted here, so false only causes a warning", "true" },
  { "swap", "force_null", "whether the part is removed", "false" },
  { "swap", "swapIndices", "no program reads it" },
  { "filter", "", "a processing step of a part; the parameters depend on the type, see below" },
  { "filter", "type", "type of filter", Required },
  { "param", "", "a parameter of a filter" },
  { "param", "type", "string, double, integer, boolean, vec3 or rotation: not needed, it follows from the key" },
  { "param", "key", "name of the parameter", Required },
  { "param", "value", "value of the parameter; a rotation has rot children instead", "" },

  { "filter:objloader", "", "a Wavefront OBJ file with its MTL files" },
  { "filter:objloader", "up", "the axis that points up", "z", "~y z" },
  { "filter:objloader", "recomputeVertexNormals", "incidence angles use the face normals" },
  { "filter:objloader", "castShadows", "for display only; parts always cast shadows" },
  { "filter:objloader", "receiveShadows", "for display only" },
  { "filter:geotiffloader", "", "a raster of heights" },
  { "filter:geotiffloader", "filepath", "any raster that GDAL reads; the first band is the height", "" },
  { "filter:xyzloader", "", "points as text, converted to solid voxels" },
  { "filter:xyzloader", "separator", "column separators besides blanks and tabs", "" },
  { "filter:xyzloader", "voxelSize", "edge length of a voxel", "1" },
  { "filter:xyzloader", "maxColorValue", "colours are not used" },
  { "filter:xyzloader", "normalXIndex", "column of the normal's x, from 0; if any of the three is given, normals are read", "3" },
  { "filter:xyzloader", "normalYIndex", "column of the normal's y", "4" },
  { "filter:xyzloader", "normalZIndex", "column of the normal's z", "5" },
  { "filter:xyzloader", "rgbRIndex", "colours are not used" },
  { "filter:xyzloader", "rgbGIndex", "colours are not used" },
  { "filter:xyzloader", "rgbBIndex", "colours are not used" },
  { "filter:xyzloader", "estimateNormals", "not 0: normals are estimated from the points of a voxel", "0" },
  { "filter:xyzloader", "defaultNormal", "normal of voxels without one", "that of the faces" },
  { "filter:xyzloader", "snapNeighborNormal", "whether a voxel has the normal of the point nearest its centre instead of the mean", "false" },
  { "filter:xyzloader", "sparse", "storage of other programs" },
  { "filter:detailedvoxels", "", "vegetation as AMAPVox voxels" },
  { "filter:detailedvoxels", "intersectionMode", "model of the voxels", "transmittive", "~transmittive scaled fixed" },
  { "filter:detailedvoxels", "intersectionArgument", "scaled: exponent of the edge length", "0.5" },
  { "filter:detailedvoxels", "randomShift", "scaled: whether cubes are shifted at random in their cells", "false" },
  { "filter:detailedvoxels", "ladlut", "a table of leaf angle distributions", "none" },
  { "filter:crs", "", "reprojects the part before it is rotated; also crstransform, transform" },
  { "filter:crs", "source", "source coordinate system", "that of the file" },
  { "filter:crs", "target", "target coordinate system", Required },
  { "filter:repair", "", "merges vertices, removes degenerate and duplicate triangles" },
  { "filter:simplify", "", "reduces the number of triangles; the two surfaces are guaranteed to be within a distance; needs CGAL" },
  { "filter:simplify", "maximumDistance", "maximum distance of the surfaces", Required },
  { "filter:scale", "", "scales the part about its origin" },
  { "filter:scale", "scale", "factor; the last scale of a part is used", "1" },
  { "filter:translate", "", "moves the part. The last translate of a part is used" },
  { "filter:translate", "offset", "displacement", "0;0;0" },
  { "filter:translate", "onGround", "not 0: the lowest corner is moved onto the ground below", "0" },
  { "filter:rotate", "", "rotates the part about its origin; rotations add up" },
  { "filter:rotate", "rotation", "rot children", "none" },
};
// clang-format on

/// The notes of a scanner's attributes, for channels, which inherit them.
std::vector<XmlNote> MakeChannelNotes()
{
  std::vector<XmlNote> notes;
  for (const XmlNote& note : Notes)
  {
    if (std::string(note.Element) == "scanner")
    {
      notes.push_back(note);
      notes.back().Default = "the scanner's";
    }
  }
  return notes;
}

const XmlNote* FindOfChannel(const std::string& name)
{
  static const std::vector<XmlNote> notes = MakeChannelNotes();
  const auto found = std::find_if(
    notes.begin(), notes.end(), [&name](const XmlNote& note) { return name == note.Name; });
  return found != notes.end() && !name.empty() ? &*found : nullptr;
}

const XmlNote* FindExactly(const std::string& element, const std::string& name)
{
  const auto* const found = std::find_if(std::begin(Notes), std::end(Notes),
    [&](const XmlNote& note) { return element == note.Element && name == note.Name; });
  return found != std::end(Notes) ? found : nullptr;
}

} // namespace

//------------------------------------------------------------------------------
const XmlNote& FindXmlNote(const std::string& element, const std::string& name)
{
  static const XmlNote none = { "", "", "" };
  const XmlNote* note = FindExactly(element, name);
  if (!note && element == "channel")
  {
    note = FindOfChannel(name);
  }
  if (!note && !name.empty())
  {
    note = FindExactly("", name);
  }
  return note ? *note : none;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetChoices(const XmlNote& note)
{
  const std::string text = *note.Choices == '~' ? note.Choices + 1 : note.Choices;
  const char separator =
    text.find('|') != std::string::npos ? '|' : ' '; // words may contain blanks
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; std::getline(stream, word, separator);)
  {
    words.push_back(word);
  }
  return words;
}

//------------------------------------------------------------------------------
bool IsRequired(const XmlNote& note)
{
  return std::string(note.Default) == Required;
}

} // namespace helios
