# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small built-in surveys, scenes and clouds, the basis of the seeds."""

import numpy as np

PLANE = "# ground and a wall\nmtllib a.mtl\nv -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\n" \
    "v -20 21 0\nv 20 21 0\nv 20 21 8\nv -20 21 8\nvn 0 0 1\nvt 0 0\n" \
    "g floor\nusemtl grass\nf 1 2 3 4\no wall\nusemtl brick\nf 5/1/1 6/1/1 7/1/1\nf -4 -2 -1\n"  # fmt: skip
MATERIALS = "# two\nnewmtl grass\nKd 0.1 0.6 0.1\nhelios_reflectance 0.5\nhelios_isGround true\n" \
    "helios_classification 2\nnewmtl brick\nKd 0.7 0.2 0.1\nKs 0.1 0.1 0.1\nNs 10\n" \
    "helios_reflectance 0.3\nhelios_spectra wood\nhelios_classification 6\n"  # fmt: skip
SPECTRUM = "Name: wood\nType: made up\nX Units: Wavelength (micrometers)\n\n" \
    "0.4\t12.5\n0.9 40\n1.064, 45.25\n1.55 30\n14 2.5\n"  # fmt: skip
POINTS = "0;0;0;0;0;1\n0;0;1;0;0;1\n1;0;0;0;1;0\n1;1;0.5;0;1;0\n"
CROWN = """\
VOXEL SPACE
#min_corner: -4 -4 10
#max_corner: 4 4 12
#split: 2 2 1
#res: 4 #max_pad: 1.6
i j k PadBVTotal transmittance
0 0 0 0.5 0.5
1 0 0 1.6 0.1
0 1 0 0 1
1 1 0 0.2 0.8
"""
PATH = """\
#HEADER: "t", "roll", "pitch", "yaw", "x", "y", "z"
0,0,0,350,-10,0,60
0.5,1,2,355,-5,1,61
1,2,1,1,0,2,60
1.5,0,0,5,5,3,59
2,0,0,9,10,4,60
"""

ASSETS = """\
<document>
<platform id="tripod" type="static"><scannerMount x="0" y="0" z="1.5"/></platform>
<platform id="plane" type="linearpath"><scannerMount z="0.7">
<rot axis="x" angle_deg="-90"/><rot axis="z" angle_deg="90"/></scannerMount></platform>
<platform id="car" type="groundvehicle" drag="0.001"><scannerMount z="2">
<rot axis="x" angle_deg="-90"/></scannerMount><attitudeXNoise type="NORMAL" mean="0" stdev="0.001"
 clipEnabled="true" clipMin="-0.01" clipMax="0.01"/></platform>
<scanner id="tls" optics="rotating" accuracy_m="0.005" beamDivergence_rad="0.0004"
 headRotatePerSecMax_deg="60" pulseFreqs_Hz="2000, 300000" pulseLength_ns="5" rangeMin_m="0.5"
 receivedEnergyMin_W="0.002" scanAngleMax_deg="120" scanAngleEffectiveMax_deg="50"
 scanFreqMin_Hz="3" scanFreqMax_Hz="120" maxNOR="5"><FWFSettings beamSampleQuality="2"/>
<beamOrigin x="0" y="0" z="0.2"/></scanner>
<scanner id="als" optics="oscillating" pulseFreqs_Hz="2000" scanAngleMax_deg="20"
 scanFreqMax_Hz="80" averagePower_w="4" wavelength_nm="1064">
<rangeError expr="sin(THETA) * 0.001"/></scanner>
<scanner id="pair" optics="rotating" pulseFreqs_Hz="500" scanAngleMax_deg="60" scanFreqMax_Hz="90">
<channels><channel id="a"><beamOrigin><rot axis="z" angle_deg="2"/></beamOrigin></channel>
<channel id="b" wavelength_nm="532" optics="line" scanAngleMax_deg="9" numFibers="3"/></channels>
</scanner>
</document>
"""
SCENE = """\
<document><scene id="s" name="all" crs="EPSG:32632">
<part id="floor"><filter type="objloader"><param type="string" key="filepath" value="plane.obj"/>
<param type="string" key="up" value="z"/></filter>
<filter type="rotate"><param key="rotation" type="rotation"><rot axis="z" angle_deg="30"/></param>
</filter><filter type="scale"><param type="double" key="scale" value="1.5"/></filter></part>
<part id="hedge"><filter type="xyzloader">
<param type="string" key="filepath" value="points.xyz"/>
<param type="double" key="voxelSize" value="0.25"/><param type="string" key="separator" value=";"/>
</filter><filter type="translate"><param type="vec3" key="offset" value="1;2;3"/>
<param type="integer" key="onGround" value="1"/></filter></part>
<part id="crown"><filter type="detailedvoxels">
<param type="string" key="filepath" value="crown.vox"/>
<param type="string" key="intersectionMode" value="transmittive"/></filter></part>
</scene></document>
"""
SIMPLE_SCENE = """\
<document><scene id="s" name="plain"><part id="floor"><filter type="objloader">
<param type="string" key="filepath" value="plane.obj"/></filter></part></scene></document>
"""
STAND = """\
<document>
<survey name="stand" scene="scene.xml#s" platform="assets.xml#tripod" scanner="assets.xml#tls" seed="3">
<FWFSettings binSize_ns="0.25" winSize_ns="1" beamSampleQuality="2"/>
<leg><platformSettings x="1" y="2" onGround="true"/><scannerSettings
 pulseFreq_hz="2000" scanFreq_hz="50" headRotatePerSec_deg="10" headRotateStart_deg="-1"
 headRotateStop_deg="1" trajectoryTimeInterval_s="0.05"/></leg>
<leg><platformSettings x="5" y="-2" z="3"/><scannerSettings pulseFreq_hz="2000" scanFreq_hz="50"
 headRotatePerSec_deg="20" headRotateStart_deg="0" headRotateStop_deg="2"/></leg>
</survey></document>
"""
FLIGHT = """\
<document>
<platformSettings id="place" x="-2" y="2" z="60" movePerSec_m="20"/>
<scannerSettings id="base" pulseFreq_hz="2000" scanFreq_hz="50" scanAngle_deg="5"/>
<scannerSettings id="slow" template="base" scanFreq_hz="20"/>
<survey name="flight" scene="scene.xml#s" platform="assets.xml#plane" scanner="assets.xml#als">
<detectorSettings accuracy_m="0.01" rangeMax_m="500" distanceMeasurementError="0.001 * t"/>
<leg><platformSettings template="place"/><scannerSettings template="base" active="true"/></leg>
<leg><platformSettings template="place" x="0" onGround="false"/><scannerSettings template="slow"
 beamDivergence_rad="0.001" trajectoryTimeInterval_s="0.1" opticsWarmupPhase_s="0.1"/></leg>
<leg><platformSettings x="2" y="1e1" z="50"/><scannerSettings template="base" active="false"/></leg>
</survey></document>
"""
DRIVE = """\
<document>
<scannerSettings id="base" pulseFreq_hz="500" scanFreq_hz="50" scanAngle_deg="5"/>
<survey name="drive" scene="scene.xml#s" platform="assets.xml#car" scanner="assets.xml#pair" seed="7"
 legRandomOffset="true" legRandomOffsetMean="0" legRandomOffsetStdev="0.01">
<origin x="1" y="2" z="0"/><positionZNoise type="UNIFORM" min="-0.01" max="0.01" fixedLifespan="5"/>
<leg stripId="a"><platformSettings x="-4" z="5" movePerSec_m="8" stopAndTurn="false"/>
<scannerSettings template="base"/></leg>
<leg stripId="a"><platformSettings x="0" y="4" z="5" movePerSec_m="8" yawAtDeparture_deg="30"/>
<scannerSettings template="base"/></leg>
<leg><platformSettings x="3" y="4" z="5"/><scannerSettings template="base" active="false"/></leg>
</survey></document>
"""
RECORDED = """\
<document>
<survey name="recorded" scene="scene.xml#s" platform="interpolated" basePlatform="assets.xml#plane"
 scanner="assets.xml#als" rotationSpec="ARINC 705"><scannerMount z="1"><rot axis="x" angle_deg="-90"/>
</scannerMount>
<leg><platformSettings trajectory="path.csv" trajectory_separator="," tIndex="0" rollIndex="1"
 pitchIndex="2" yawIndex="3" xIndex="4" yIndex="5" zIndex="6" toRadians="true" tStart="0" tEnd="0.1"
 interpolationDomain="position_and_attitude" slopeFilterThreshold="0"/>
<scannerSettings pulseFreq_hz="1000" scanFreq_hz="50" scanAngle_deg="5"/></leg>
<leg><platformSettings tStart="1.5" tEnd="1.6" teleportToStart="true" syncGPSTime="false"/>
<scannerSettings pulseFreq_hz="1000" scanFreq_hz="50" scanAngle_deg="5"/></leg>
</survey></document>
"""
PLANNER = """\
<document>
<scannerSettings id="base" pulseFreq_hz="300000" scanFreq_hz="60"/>
<surveyPlanner id="yard" name="my yard" method="reduce" scene="scene.xml#s"
 platform="assets.xml#tripod" scanner="assets.xml#tls" minCoverage_percent="95"
 hitTolerance_m="0.05" interactive="false" gridSizePSP_m="5" gridSizePSPy_m="4" gridSizeVTP_m="2"
 pspRemoveOrder="viewshedSize" pspRemoveFirst="smallest" maxSlope_deg="15" groundOnly="auto"
 scannerHeight_m="1.7" scannerLimits="true" rangeMin_m="1" rangeMax_m="600" elevationMin_deg="-40"
 elevationMax_deg="60" maxIncidence_deg="80" minOverlap_percent="10" timeLimit_s="30">
<scannerSettings template="base" headRotatePerSec_deg="6"/>
</surveyPlanner></document>
"""

SURVEYS = {"stand.xml": STAND, "flight.xml": FLIGHT, "drive.xml": DRIVE, "recorded.xml": RECORDED}
BESIDE = {
    "scene.xml": SCENE, "assets.xml": ASSETS, "plane.obj": PLANE, "a.mtl": MATERIALS,
    "points.xyz": POINTS, "crown.vox": CROWN, "path.csv": PATH, "spectra/wood.txt": SPECTRUM,
    "wood.txt": SPECTRUM,
}  # fmt: skip


def encoded(files):
    return {name: text.encode() for name, text in files.items()}


def make_chunk(count=60):
    """Echoes at UTM coordinates, with all kinds of arrays."""
    random = np.random.default_rng(1)
    number = random.integers(1, 4, count).astype(np.uint8)
    return {
        "points": np.round(random.uniform(0, 100, (count, 3)) + [476000.0, 5473000.0, 110.0], 4),
        "GpsTime": np.arange(count) * 1e-5 + 3.0,
        "PulseIds": np.arange(count, dtype=np.int64) // 2 + 2**40,
        "ReturnNumber": number,
        "NumberOfReturns": (number + random.integers(0, 2, count)).astype(np.uint8),
        "Range": random.uniform(1, 300, count),
        "Amplitude": 10.0 ** random.uniform(-12, -4, count),
        "EchoWidth": random.uniform(4, 6, count),
        "ScanAngle": np.round(random.uniform(-30, 30, count) / 0.006) * 0.006,
        "ClassificationIds": random.integers(0, 12, count).astype(np.int32),
        "PartIds": random.integers(0, 3, count).astype(np.int32),
        "LegIds": np.full(count, 2, np.int32),
        "RGB": (random.integers(0, 256, (count, 3)) / 255.0).astype(np.float32),
        "TruePoint": random.uniform(0, 100, (count, 3)),
    }


def write_points(path, chunk, pieces=1):
    """Writes a point file with the vtkHelios writers."""
    from vtkhelios import formats

    header = formats.Header()
    header.crs, header.epoch = "EPSG:25832", 1.4e9
    rows = -(-len(chunk["points"]) // pieces)
    with formats.open_writer(path, header) as writer:
        for begin in range(0, len(chunk["points"]), rows):
            writer.write({name: values[begin : begin + rows] for name, values in chunk.items()})
    return path


def write_survey(folder, survey, scene=SCENE):
    """Writes a survey and all files it refers to; returns its path."""
    for name, text in {**BESIDE, "scene.xml": scene, "survey.xml": survey}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return folder / "survey.xml"


def run_survey(folder, survey, *options, scene=SCENE):
    """Runs a survey to files; returns the run folder."""
    from vtkhelios import cli

    path = write_survey(folder, survey, scene)
    arguments = ["run", path, "--output", folder / "out", "--threads", "1", "--quiet", *options]
    code = cli.main([str(each) for each in arguments])
    if code != 0:
        raise RuntimeError(f"the survey of seeds ended with {code}")
    return next((folder / "out").iterdir())


def files_below(folder):
    """The bytes of all files below a folder, by relative name."""
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*")) if path.is_file()
    }  # fmt: skip
