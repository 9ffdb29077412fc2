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
  { "", "id", "what references name it by" },
  { "", "name", "a title" },
  { "", "template", "settings of the same kind that these start from; what is given here wins" },
  { "", "crs", "coordinate system, as EPSG:n, WKT or PROJ", "the scene's" },
  { "", "x", "right, or east", "0" },
  { "", "y", "forward, or north", "0" },
  { "", "z", "up", "0" },
  { "", "rotations", "whether each rot turns about fixed axes (global) or those turned before (local)",
    "global", "global local" },
  { "", "rangeTolerance_m", "the beam is sampled so that ranges are within this (root mean square)", "0.001" },
  { "", "energyTolerance", "and amplitudes within this share (root mean square)", "0.01" },
  { "", "echoDetector", "what makes echoes of waveforms", "peak", "peak gaussian cfd leadingEdge" },
  { "", "pulseShape", "gaussian, helios, or a text file of times [ns] and powers", "gaussian" },
  { "", "returnSelection", "the returns of a pulse that are kept", "all",
    "all first last strongest firstAndLast" },
  { "", "filepath", "the file", "" },
  { "", "efilepath", "a folder and a regular expression for file names; wins over filepath", "" },
  { "", "matfile", "an MTL file, the material of all cells", "the default material" },
  { "", "matname", "the material in matfile", "the alphabetically first" },
  { "", "randomMaterials", "how many materials are varied at random" },
  { "", "randomRange", "by how much", "1" },

  { "document", "", "the root of every file; its children come in any order and mix" },

  { "survey", "", "what is scanned, with what, from where. Of several in a file the first is run" },
  { "survey", "name", "names the folder of the output, too", "the name of the file" },
  { "survey", "id", "surveys are not referred to" },
  { "survey", "scanner", "the instrument, file.xml#id, #id or id", "the legs' own" },
  { "survey", "platform", "what carries it; interpolated: a trajectory from files", "the legs' own" },
  { "survey", "scene", "what is scanned", Required },
  { "survey", "rayCaster", "beam, embree, bvh, cgal or obbtree, as far as built", "beam" },
  { "survey", "numRuns", "how often is the caller's to say: vtkhelios run runs once" },
  { "survey", "simSpeed", "the speed of a picture" },
  { "survey", "defaultScannerSettings", "no program reads it; name templates in the legs" },
  { "survey", "basePlatform", "of platform=\"interpolated\": the platform whose mount and noise are taken" },
  { "survey", "rotationSpec", "the angle convention of trajectory files", "ARINC 705", "ARINC 705|CANONICAL" },
  { "survey", "seed", "key of the random numbers: a whole number, YYYY-MM-DD hh:mm:ss or AUTO; --seed wins", "AUTO" },
  { "survey", "legRandomOffset", "whether positions of legs are shifted at random, once", "false" },
  { "survey", "legRandomOffsetMean", "mean of that shift", "0" },
  { "survey", "legRandomOffsetStdev", "standard deviation of that shift", "0.1" },

  { "surveyPlanner", "", "where to scan a scene from, for vtkhelios plan: PSP are potential scan positions, VTP the points to be seen. Of several in a file the first is used" },
  { "surveyPlanner", "id", "its name where it has no other" },
  { "surveyPlanner", "name", "names the folder of the output, and the survey there", "the id, else the file's" },
  { "surveyPlanner", "scene", "what is to be scanned", Required },
  { "surveyPlanner", "platform", "what carries the scanner; it must stand", Required },
  { "surveyPlanner", "scanner", "the instrument", Required },
  { "surveyPlanner", "method", "reduce: takes away positions, as pspRemoveOrder says; bestcoverage, greedy: adds the best; best: reduces the problem first; optimal: proves the fewest",
    "reduce", "reduce bestcoverage greedy best optimal" },
  { "surveyPlanner", "pspRemoveOrder", "reduce: what the positions are taken away by", "viewshedSize",
    "viewshedSize meanIncidenceAngle" },
  { "surveyPlanner", "pspRemoveFirst", "reduce: which of them go first", "smallest", "smallest largest" },
  { "surveyPlanner", "minCoverage_percent", "share of the points that the positions must see", "100" },
  { "surveyPlanner", "coverageOf", "of which points: those that any position sees, or all", "coverable", "coverable all" },
  { "surveyPlanner", "gridSizePSP_m", "from position to position", "a twentieth of the scene's diagonal" },
  { "surveyPlanner", "gridSizePSPy_m", "the same along y", "gridSizePSP_m" },
  { "surveyPlanner", "gridSizeVTP_m", "from point to point", "gridSizePSP_m" },
  { "surveyPlanner", "vtpLines", "points are where lines of these directions meet surfaces", "all", "all vertical horizontal" },
  { "surveyPlanner", "maxSlope_deg", "steeper places are none to stand on", "15" },
  { "surveyPlanner", "groundOnly", "stand on ground only, by helios_isGround of materials; auto: if any is; open: with nothing above",
    "auto", "~auto true false 1 0 open" },
  { "surveyPlanner", "enclosed", "whether places that are closed all around count where there are others", "false" },
  { "surveyPlanner", "scannerHeight_m", "of the instrument above the place", "as the platform carries it" },
  { "surveyPlanner", "hitTolerance_m", "how far before a point a ray may end that sees it", "0.05" },
  { "surveyPlanner", "hitBehind", "whether a ray that ends farther behind a point than that sees it, too; false is the test of Bechtold and Hoefle (2016)", "true" },
  { "surveyPlanner", "scannerLimits", "whether ranges and field of view are those of the scanner", "false" },
  { "surveyPlanner", "rangeMin_m", "nothing is seen nearer", "0, or the scanner's" },
  { "surveyPlanner", "rangeMax_m", "nor farther", "no limit, or the scanner's" },
  { "surveyPlanner", "elevationMin_deg", "nothing is seen below this angle from the horizontal", "-90, or the scanner's" },
  { "surveyPlanner", "elevationMax_deg", "nor above this one", "90, or the scanner's" },
  { "surveyPlanner", "maxIncidence_deg", "nothing is seen at a larger angle from the normal of its surface", "90" },
  { "surveyPlanner", "minPointDensity_1_m2", "nothing is seen that gets fewer points a square metre from one position", "0" },
  { "surveyPlanner", "areaWeights", "points count by the area that they stand for", "false" },
  { "surveyPlanner", "minOverlap_percent", "share of its points that each scan has in common with others", "0" },
  { "surveyPlanner", "timeLimit_s", "optimal: how long it may search", "300" },
  { "surveyPlanner", "interactive", "the Java program asks between its steps" },

  { "leg", "", "a scan position; on a platform that moves, the way to the next leg" },
  { "leg", "id", "legs are numbered 0, 1, 2 ... in the order of the file" },
  { "leg", "maxDuration_s", "ends the leg after this time; negative: never; wins over scannerSettings", "-1" },
  { "leg", "stripId", "legs of one strip write one file" },
  { "leg", "x", "position, of the Java program's scan", "0" },
  { "leg", "y", "position, of the Java program's scan", "0" },
  { "leg", "z", "position, of the Java program's scan", "0" },
  { "leg", "platform", "the platform of this leg", "the survey's" },
  { "leg", "scanner", "the scanner of this leg", "the survey's" },
  { "maxDuration_s", "", "the attribute of this name, as a child" },
  { "scan", "", "legs with a platform and a scanner of their own, as the planner of the Java program writes them" },
  { "scan", "id", "scans are not referred to" },
  { "scan", "platform", "the platform of its legs", "the survey's" },
  { "scan", "scanner", "the scanner of its legs", "the survey's" },
  { "scannerRotation", "", "the turn of the head on each leg, as fast as it can" },
  { "scannerRotation", "axis", "the head turns about its own axis" },
  { "scannerRotation", "angle", "start and end say it" },
  { "scannerRotation", "start", "the head's angle when a leg starts", "0" },
  { "scannerRotation", "end", "and when it ends", "0" },

  { "platformSettings", "", "where a leg starts; at the top level, a template" },
  { "platformSettings", "name", "templates are named by id" },
  { "platformSettings", "x", "position", "0" },
  { "platformSettings", "y", "position", "0" },
  { "platformSettings", "z", "position; onGround replaces it", "0" },
  { "platformSettings", "onGround", "z is that of the ground below", "false" },
  { "platformSettings", "movePerSec_m", "speed to the next leg; of vehicles the highest", "70" },
  { "platformSettings", "stopAndTurn", "multicopter: hovers, turns, starts from rest", "true" },
  { "platformSettings", "smoothTurn", "multicopter: turns in flight; wins over stopAndTurn", "false" },
  { "platformSettings", "slowdownEnabled", "multicopter: brakes before waypoints and in turns", "true" },
  { "platformSettings", "yawAtDeparture_deg", "multicopter: heading it starts with, anticlockwise from north", "to the next leg" },
  { "platformSettings", "trajectory", "interpolated platform: the file of its trajectory" },
  { "platformSettings", "trajectory_seperator", "as trajectory_separator, as HELIOS++ spells it" },
  { "platformSettings", "trajectory_separator", "what stands between its columns", "," },
  { "platformSettings", "tIndex", "its column of time", "0" },
  { "platformSettings", "rollIndex", "its column of roll", "1" },
  { "platformSettings", "pitchIndex", "its column of pitch", "2" },
  { "platformSettings", "yawIndex", "its column of yaw", "3" },
  { "platformSettings", "xIndex", "its column of x", "4" },
  { "platformSettings", "yIndex", "its column of y", "5" },
  { "platformSettings", "zIndex", "its column of z", "6" },
  { "platformSettings", "interpolationDomain", "what the file says", "position_and_attitude",
    "position position_and_attitude" },
  { "platformSettings", "toRadians", "true: its angles are degrees; false: radians", "true" },
  { "platformSettings", "syncGPSTime", "GPS time is the file's time", "false" },
  { "platformSettings", "slopeFilterThreshold", "thins the file where it is straight; 0: not", "0" },
  { "platformSettings", "tStart", "the file's time at which the leg starts", "the file's first" },
  { "platformSettings", "tEnd", "and at which it ends", "the file's last" },
  { "platformSettings", "teleportToStart", "the platform jumps there", "false" },

  { "scannerSettings", "", "how a leg is scanned, or all legs of a plan; at the top level, a template" },
  { "scannerSettings", "name", "templates are named by id" },
  { "scannerSettings", "active", "whether the leg fires pulses", "true" },
  { "scannerSettings", "pulseFreq_hz", "pulses a second; one that is not in pulseFreqs_Hz warns", "the first of pulseFreqs_Hz" },
  { "scannerSettings", "scanFreq_hz", "lines, swings to and fro, or revolutions a second; clipped to the instrument's", "0" },
  { "scannerSettings", "scanAngle_deg", "half angle; 0: the instrument's; clipped to it", "scanAngleMax_deg" },
  { "scannerSettings", "verticalAngleMin_deg", "rotating: pulses leave from this mirror angle", "-scanAngle_deg" },
  { "scannerSettings", "verticalAngleMax_deg", "to this one; both are clipped to the instrument's width", "scanAngle_deg" },
  { "scannerSettings", "headRotatePerSec_deg", "the head's speed; clipped to the instrument's", "0" },
  { "scannerSettings", "headRotateStart_deg", "the head's angle when the leg starts", "0" },
  { "scannerSettings", "headRotateStop_deg", "and when it ends, where the platform stands", "0" },
  { "scannerSettings", "beamDivergence_rad", "full angle at 1/e2", "the scanner's" },
  { "scannerSettings", "beamDivergenceRad", "the same, as some schemas spell it", "the scanner's" },
  { "scannerSettings", "trajectoryTimeInterval_s", "between two lines of the trajectory; 0: start and end only", "0" },
  { "scannerSettings", "maxDuration_s", "ends the leg after this time; negative: never", "-1" },
  { "scannerSettings", "verticalResolution_deg", "rotating: between pulses of a line; sets scanFreq_hz", "0" },
  { "scannerSettings", "horizontalResolution_deg", "rotating: between lines; sets the head's speed", "0" },
  { "scannerSettings", "opticsWarmupPhase_s", "mirror and head have moved that long when the leg starts", "0" },
  { "scannerSettings", "beamSampleQuality", "give it in FWFSettings, which HELIOS uses" },

  { "FWFSettings", "", "sampling, waveforms and echoes; of a survey it wins over that of its scanner" },
  { "FWFSettings", "id", "it is not referred to" },
  { "FWFSettings", "name", "it is not referred to" },
  { "FWFSettings", "binSize_ns", "a bin of a waveform; light goes 0.15 m and back in 1 ns", "0.25" },
  { "FWFSettings", "beamSampleQuality", "circles of sub-rays, always as many: 1, 7, 19, 37 ... sub-rays", "by tolerance" },
  { "FWFSettings", "winSize_ns", "no echo within this time of a higher one", "0" },
  { "FWFSettings", "maxFullwaveRange_ns", "longest waveform; 0: as long as the target", "0" },
  { "FWFSettings", "apertureDiameter_m", "compared with receiverDiameter_m of the scanner, which is used" },
  { "FWFSettings", "apartureDiameter", "the same, as the Java program spells it" },
  { "FWFSettings", "numFullwaveBins", "bins of a waveform at most", "as many as needed" },
  { "FWFSettings", "winSize", "winSize_ns, in bins", "0" },
  { "FWFSettings", "scannerEfficiency", "opticalEfficiency of the scanner", "the scanner's" },
  { "FWFSettings", "atmosphericVisibility", "atmosphericVisibility_km of the scanner", "the scanner's" },
  { "FWFSettings", "scannerWaveLength", "wavelength_nm of the scanner", "the scanner's" },
  { "FWFSettings", "beamDivergence_rad", "that of the scanner", "the scanner's" },
  { "FWFSettings", "pulseLength_ns", "that of the scanner", "the scanner's" },
  { "FWFSettings", "numTimeBins", "samples of the outgoing pulse, which has a closed form here" },
  { "FWFSettings", "minEchoWidth", "its unit and use differ between Java versions" },
  { "FWFSettings", "peakEnergy", "averagePower_w is the power of the pulse" },

  { "detectorSettings", "", "of a survey; wins over what the scanner says" },
  { "detectorSettings", "accuracy_m", "as that of the scanner", "the scanner's" },
  { "detectorSettings", "rangeMin_m", "as that of the scanner", "the scanner's" },
  { "detectorSettings", "rangeMax_m", "as that of the scanner", "the scanner's" },
  { "detectorSettings", "distanceMeasurementError", "factor of the range noise, an expression of the range t [m]", "1" },

  { "rangeError", "", "an error of ranges" },
  { "rangeError", "expr", "an expression of the mirror's angle THETA [rad], in metres", Required },
  { "deflectionError", "", "an error of the mirror" },
  { "deflectionError", "expr", "an expression of the mirror's angle THETA [rad], in radians", Required },
  { "headError", "", "an error of the head" },
  { "headError", "expr", "an expression of the mirror's angle THETA [rad], in radians", Required },
  { "headError", "zeroSinThreshold_deg", "THETA stays this far from multiples of 180 degrees", "0" },

  { "scanner", "", "an instrument" },
  { "scanner", "optics", "what deflects the beam", Required, "rotating oscillating line conic palmer risley" },
  { "scanner", "pulseFreqs_Hz", "pulse frequencies that it offers, the default first", "the leg's" },
  { "scanner", "pulseLength_ns", "full width at half maximum", "4" },
  { "scanner", "beamDivergence_rad", "full angle at 1/e2", "0.0003" },
  { "scanner", "wavelength_nm", "reflectances of spectra are taken there", "1064" },
  { "scanner", "averagePower_w", "power of the pulse at its peak", "4" },
  { "scanner", "opticalEfficiency", "share of the light that is not lost in the optics", "0.99" },
  { "scanner", "receiverDiameter_m", "of its aperture", "0.15" },
  { "scanner", "atmosphericVisibility_km", "visibility, from which the extinction follows", "23" },
  { "scanner", "receivedEnergyMin_W", "weakest echo, in nanowatts whatever its name says", "0.0001" },
  { "scanner", "accuracy_m", "standard deviation of a range", "0" },
  { "scanner", "rangeMin_m", "nothing is measured nearer", "0" },
  { "scanner", "rangeMax_m", "nor farther", "no limit" },
  { "scanner", "maxNOR", "returns a pulse at most; 0: all", "0" },
  { "scanner", "scanAngleMax_deg", "half of what its mirror sweeps, half angle of its cone", "0" },
  { "scanner", "scanAngleEffectiveMax_deg", "rotating: half of its field of view", "scanAngleMax_deg" },
  { "scanner", "scanFreqMin_Hz", "lowest scan frequency", "0" },
  { "scanner", "scanFreqMax_Hz", "highest scan frequency; 0: no limit", "0" },
  { "scanner", "headRotatePerSecMax_deg", "highest speed of its head", "0" },
  { "scanner", "deflectAngle_deg", "no program reads it" },
  { "scanner", "visModel", "what vtkhelios view shows in the place of the head, as model of a platform; it turns with the head", "a simple one" },
  { "scanner", "beamQualityFactor", "M2 of the beam; not given: no waist" },
  { "scanner", "atmosphericExtinction_1_m", "extinction; wins over the visibility", "from the visibility" },
  { "scanner", "detectorNoise_nW", "standard deviation of the noise of waveforms", "0" },
  { "scanner", "solarIrradiance_W_m2_nm", "sunlight on the scene", "0" },
  { "scanner", "filterBandwidth_nm", "light that the receiver lets through", "1" },
  { "scanner", "fieldOfView_rad", "of the receiver, full angle", "0.001" },
  { "scanner", "accuracyPerMeter", "range noise that grows with the range", "0" },
  { "scanner", "accuracyAtThreshold_m", "range noise of the weakest echo", "0" },
  { "scanner", "angleAccuracy_rad", "standard deviation of the beam's direction", "0" },
  { "scanner", "scanProduct", "oscillating: scan angle times scan frequency at most", "1000000" },
  { "scanner", "scanPattern", "oscillating: how the mirror swings", "triangular", "triangular sinusoidal" },
  { "scanner", "turningPulses", "oscillating, triangular: pulses that the mirror takes to turn", "0" },
  { "scanner", "numFibers", "line: fibres side by side", "1" },
  { "scanner", "rotorFreq1_Hz", "risley: revolutions of the first prism, the sign is the sense", "0" },
  { "scanner", "rotorFreq2_Hz", "of the second", "0" },
  { "scanner", "rotorFreq3_Hz", "of the third", "0" },
  { "scanner", "angle1_deg", "risley: wedge of the first prism, its sign the face; 0: none", "0" },
  { "scanner", "angle2_deg", "of the second", "0" },
  { "scanner", "angle3_deg", "of the third", "0" },
  { "scanner", "refrIndex1", "risley: refractive index of the first prism", "1" },
  { "scanner", "refrIndex2", "of the second", "1" },
  { "scanner", "refrIndex3", "of the third", "1" },
  { "scanner", "refrIndex_air", "of what is around the prisms", "1" },

  { "channels", "", "the channels of an instrument that has several" },
  { "channel", "", "an emitter and its receiver; what it does not say is its scanner's" },
  { "channel", "id", "names files where channels are split", "its number" },
  { "incidentBeam", "", "risley: direction into the first prism", "0 1 0" },

  { "platform", "", "what carries the scanner" },
  { "platform", "type", "how it moves", "static", "static dummy linearpath groundvehicle multicopter" },
  { "platform", "model", "what vtkhelios view shows: an OBJ file, in m, x right, y forward, z up; no simulation opens it", "a simple one" },
  { "platform", "visModel", "the same; model wins", "a simple one" },
  { "platform", "drag", "groundvehicle, multicopter: the loss of speed a pulse, not used: vehicles have masses and forces" },
  { "platform", "engine_max_force", "multicopter: a force a pulse, not used: it tilts" },
  { "platform", "speedup_magnitude", "multicopter: a rate a pulse, not used" },
  { "platform", "slowdown_magnitude", "multicopter: a rate a pulse, not used" },
  { "platform", "slowdown_distance", "multicopter: not used: it brakes as late as its tilt allows" },
  { "platform", "base_pitch_deg", "multicopter: pitch in cruise at the fastest speed of its legs" },
  { "platform", "roll_speed_deg", "multicopter: rate of roll", "28.65" },
  { "platform", "pitch_speed_deg", "multicopter: rate of pitch", "85.94" },
  { "platform", "yaw_speed_deg", "multicopter: rate of yaw", "85.94" },
  { "platform", "roll_offset_deg", "multicopter: largest roll", "25" },
  { "platform", "pitch_offset_deg", "multicopter: largest pitch", "35" },

  { "positionXNoise", "", "noise of the platform's x [m]; of a survey it wins over the platform's" },
  { "positionYNoise", "", "noise of the platform's y [m]" },
  { "positionZNoise", "", "noise of the platform's z [m]" },
  { "attitudeXNoise", "", "noise of the platform's attitude about x [rad]" },
  { "attitudeYNoise", "", "noise of the platform's attitude about y [rad]" },
  { "attitudeZNoise", "", "noise of the platform's attitude about z [rad]" },
  { "", "type", "how values are distributed", "NORMAL", "~NORMAL UNIFORM" },
  { "", "mean", "of NORMAL", "0" },
  { "", "stdev", "of NORMAL", "1" },
  { "", "min", "of UNIFORM", "0" },
  { "", "max", "of UNIFORM", "1" },
  { "", "clipEnabled", "whether values are clamped", "false" },
  { "", "clipMin", "lowest value", "0" },
  { "", "clipMax", "highest value", "1" },
  { "", "fixedLifespan", "pulses that a value holds; 0: all", "1" },

  { "scannerMount", "", "where the scanner is on the platform, and how it is turned" },
  { "beamOrigin", "", "where the beam leaves the head, and how it is turned" },
  { "headRotateAxis", "", "what the head turns about; shorter than 0.1: not used" },
  { "headRotateAxis", "z", "up", "1 without the element, else 0" },
  { "rot", "", "a turn, right-handed; several go one after the other" },
  { "rot", "axis", "what it turns about; pitch, roll, yaw are x, y, z", Required, "x y z X Y Z pitch roll yaw" },
  { "rot", "angle_deg", "by how much", Required },
  { "origin", "", "shift of the legs that follow, of the Java program" },
  { "pointCloudColor", "", "colour of a picture" },

  { "scene", "", "the parts of what is scanned" },
  { "scene", "crs", "coordinate system of parts that do not bring theirs, as EPSG:n, WKT or PROJ", "a frame in metres" },
  { "scene", "dynStep", "pulses of a channel between updates of what moves", "1" },
  { "scene", "dynTimeStep", "time between updates of what moves, instead of dynStep", "as dynStep" },
  { "sunDir", "", "light of a picture; sunlight as noise is solarIrradiance_W_m2_nm of the scanner" },
  { "sky", "", "background of a picture" },
  { "skybox", "", "background of a picture" },
  { "part", "", "a mesh: a loader, then filters that turn, scale and move it, in this order" },
  { "part", "id", "becomes its name, and the object of its points", "its number" },
  { "part", "name", "parts are named by id" },
  { "part", "dynStep", "updates of the scene between those of the part", "1" },
  { "part", "dynTimeStep", "time between updates of the part: whole dynTimeStep of the scene, where it has one", "as dynStep" },
  { "part", "kdtDynStep", "updates that rays see at once, the last of them", "1" },
  { "part", "kdtDynTimeStep", "time between updates that rays see", "as kdtDynStep" },
  { "color", "", "colour of a picture" },
  { "swap", "", "geometry that replaces the part in later plays of the survey" },
  { "dmotion", "", "how the part moves: every step is all its motions, in their order; the first one starts" },
  { "dmotion", "id", "its name for next" },
  { "dmotion", "loop", "steps that it lasts; 0: for ever", Required },
  { "dmotion", "next", "id of the dmotion that follows; one that was before starts a cycle", "none: the part rests" },
  { "motion", "", "one motion of a step" },
  { "motion", "type", "what kind", Required,
    "~identity translation rotation reflection glideplane helical rotsym" },
  { "motion", "vec", "translation: by how much" },
  { "motion", "axis", "rotation, helical, rotsym: what it turns about, to the right" },
  { "motion", "angle", "by how much a step", "0" },
  { "motion", "center", "rotation, rotsym: a point on the axis", "0;0;0" },
  { "motion", "ortho", "reflection, glideplane: normal of the plane through 0;0;0" },
  { "motion", "shift", "glideplane: shift in the plane", "0;0;0" },
  { "motion", "glide", "helical: shift along the axis a step", "0" },
  { "motion", "selfMode", "0;0;0 is the centroid of the part, wherever it is then", "false" },
  { "motion", "autoCRS", "scenes are not shifted here: coordinates are always those of the scene" },
  { "swap", "swapStep", "plays that it lasts", "1" },
  { "swap", "keepCRS", "whether its geometry is shifted with the scene; here no scene is, so false only warns", "true" },
  { "swap", "force_null", "the part is taken out", "false" },
  { "swap", "swapIndices", "no program reads it" },
  { "filter", "", "a step of a part; its parameters are those of its type, below" },
  { "filter", "type", "which", Required },
  { "param", "", "a parameter of a filter" },
  { "param", "type", "string, double, integer, boolean, vec3 or rotation: not needed, the key says it" },
  { "param", "key", "its name", Required },
  { "param", "value", "its value; a rotation has rot children instead", "" },

  { "filter:objloader", "", "a Wavefront OBJ with its MTL" },
  { "filter:objloader", "up", "the axis that points up", "z", "~y z" },
  { "filter:objloader", "recomputeVertexNormals", "incidence is to the faces" },
  { "filter:objloader", "castShadows", "a picture's; rays always cast shadows" },
  { "filter:objloader", "receiveShadows", "a picture's" },
  { "filter:geotiffloader", "", "a raster of heights" },
  { "filter:geotiffloader", "filepath", "any raster that GDAL reads; the first band is height", "" },
  { "filter:xyzloader", "", "points as text, which become solid cubes" },
  { "filter:xyzloader", "separator", "characters between columns, beside blanks and tabs", "" },
  { "filter:xyzloader", "voxelSize", "edge of a cube", "1" },
  { "filter:xyzloader", "maxColorValue", "colours are not used" },
  { "filter:xyzloader", "normalXIndex", "column of the normal's x, from 0; one of three: normals are read", "3" },
  { "filter:xyzloader", "normalYIndex", "column of its y", "4" },
  { "filter:xyzloader", "normalZIndex", "column of its z", "5" },
  { "filter:xyzloader", "rgbRIndex", "colours are not used" },
  { "filter:xyzloader", "rgbGIndex", "colours are not used" },
  { "filter:xyzloader", "rgbBIndex", "colours are not used" },
  { "filter:xyzloader", "estimateNormals", "not 0: normals are fitted to the points of a cube", "0" },
  { "filter:xyzloader", "defaultNormal", "of cubes without one", "that of the faces" },
  { "filter:xyzloader", "snapNeighborNormal", "the normal of the point nearest the centre, not the mean", "false" },
  { "filter:xyzloader", "sparse", "storage of another program" },
  { "filter:detailedvoxels", "", "vegetation as AMAPVox voxels" },
  { "filter:detailedvoxels", "intersectionMode", "what a beam meets", "transmittive", "~transmittive scaled fixed" },
  { "filter:detailedvoxels", "intersectionArgument", "scaled: exponent of the edge", "0.5" },
  { "filter:detailedvoxels", "randomShift", "scaled: cubes are moved inside their cells", "false" },
  { "filter:detailedvoxels", "ladlut", "a table of leaf angles", "none" },
  { "filter:crs", "", "reprojects the part, before it is turned; also crstransform, transform" },
  { "filter:crs", "source", "the system that it is in", "the file's" },
  { "filter:crs", "target", "the system that it comes into", Required },
  { "filter:repair", "", "merges vertices, drops degenerate and double triangles" },
  { "filter:simplify", "", "fewer triangles, both surfaces proven within a distance; needs CGAL" },
  { "filter:simplify", "maximumDistance", "that distance", Required },
  { "filter:scale", "", "scales the part about its origin" },
  { "filter:scale", "scale", "factor; the last scale of a part counts", "1" },
  { "filter:translate", "", "moves the part. The last translate of a part counts" },
  { "filter:translate", "offset", "by how much", "0;0;0" },
  { "filter:translate", "onGround", "not 0: its lowest corner goes onto the ground below", "0" },
  { "filter:rotate", "", "turns the part about its origin; turns add up" },
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
