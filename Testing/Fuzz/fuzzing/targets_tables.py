# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables that surveys refer to, and records of navigation: rows that are used, or errors at their line."""

import contextlib
import csv
import io
import struct

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios

from . import small_files
from .outcomes import check, check_count, check_finite, check_polydata, plain_lines
from .pulsewaves import make_pulsewaves
from .target import Seed, Target, collect_warnings, command_line, update
from .targets_survey import check_echoes, run_in_memory

STAND = """\
<document><survey name="stand" scene="scene.xml#s" platform="assets.xml#tripod" scanner="{scanner}">
<leg><platformSettings x="1" y="2" z="3"/><scannerSettings pulseFreq_hz="2000" scanFreq_hz="20"
 headRotatePerSec_deg="40" headRotateStart_deg="0" headRotateStop_deg="2"/></leg>
</survey></document>
"""
TREES = "model,x,y,z,yaw_deg,scale,id,classification\noak,8,1,,30,1.1,oldest,\nfir,7,3,0.5,,,,\n" \
    ',-8,2,,,,,\n"oak",3,-9,,,0.5,"a, b",17\n# a remark\nfir,0,9,,,,,\n'  # fmt: skip
PART_TABLE = """\
<document><scene id="s"><part><filter type="objloader"><param type="string" key="filepath"
 value="plane.obj"/></filter></part><partTable file="trees.csv" seed="3" yawMax_deg="360" scaleMin="0.8">
<model id="oak" classification="5"><filter type="objloader"><param type="string" key="filepath"
 value="tree.obj"/></filter></model><model id="fir" share="3"><filter type="objloader">
<param type="string" key="filepath" value="tree.obj"/></filter></model></partTable></scene></document>
"""
TREE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
BEAMS = "# a head\nelevation_deg,azimuth_deg,originOffset_m,firingTime_s\n-30,1.5,0.0158,0\n" \
    "-10,0,1e-2,2e-6\n5.5,-1.5,0,0\n"  # fmt: skip
SPINNING = """\
<document><scanner id="s" optics="spinning" pulseFreqs_Hz="2000" {more}>{parts}</scanner></document>
"""
PULSE = "# time [ns], power\n-2,0\n-1,0.3\n-0.5,0.8\n0,1\n0.5,0.9\n1,0.5\n3,0.1\n5,0\n"
LEAVES = "x,y,z,G\n0,0,1,0.8\n0.5,0,0.86,0.7\n0.7,0,0.7,0.5\n0.86,0,0.5,0.4\n1,0,0,0.3\n"
TURBID = """\
<document><scene id="s"><part><filter type="detailedvoxels"><param type="string" key="filepath"
 value="crown.vox"/><param type="string" key="intersectionMode" value="transmittive"/>
<param type="string" key="ladlut" value="leaves.csv"/></filter></part></scene></document>
"""


class SurveyTable(Target):
    """A table of a survey; accepted ones are run."""

    weight = 0.6

    def __init__(self, name, file, text, scene=small_files.SIMPLE_SCENE, scanner="assets.xml#tls"):
        self.name = name
        self._file, self._text = file, text
        self._scene, self._scanner = scene, scanner

    def make_seeds(self, folder):
        files = {**small_files.BESIDE, "scene.xml": self._scene, "tree.obj": TREE}
        if self._scanner.startswith("<"):
            files["own.xml"] = self._scanner
        scanner = "own.xml#s" if self._scanner.startswith("<") else self._scanner
        files["survey.xml"] = STAND.format(scanner=scanner)
        return [Seed(self._file, self._text.encode(), small_files.encoded(files))]

    def run(self, path, data):
        run_in_memory(path.with_name("survey.xml"))


class Parts(SurveyTable):
    """Tables of parts, in surveys and by Survey.add_parts(): a part per row."""

    weight = 1.0

    def __init__(self):
        super().__init__("part-table", "trees.csv", TREES, PART_TABLE)

    def run(self, path, data):
        with collect_warnings() as warned:
            survey = vtkhelios.read_survey(path.with_name("survey.xml"))
            check_echoes(survey.run(noise=False).polydata)
            names = survey.scene.GetFieldData().GetAbstractArray("Part.Name")
        parts = names.GetNumberOfValues() if names else 1
        check_count(parts - 1, count_rows(data), warned, "rows")


def count_rows(data):
    """Rows of a table below its names; None if ambiguous."""
    lines = plain_lines(data, ())
    if lines is None or b"\\" in data or any(line.count(b'"') % 2 for line in lines):
        return None
    rows = csv.reader(io.StringIO("\n".join(line.decode() for line in lines)))
    kept = [row for row in rows if not row[0].lstrip().startswith("#")]
    return len(kept) - 1


class NavigationReport(Target):
    """Error reports of navigation: the RMS is finite."""

    name = "navigation-report"
    kind = "mixed"

    def make_seeds(self, folder):
        head = '"GpsTime","NorthPositionRMS","EastPositionRMS","DownPositionRMS","RollRMS","PitchRMS","HeadingRMS"\n'
        rows = "".join(f"{k},0.0{k + 1},0.02,0.03,0.4,{k}e-1,1.5\n" for k in range(5))
        binary = b"".join(
            struct.pack("<10d", k, 0.01, 0.02, 0.03, 0, 0, 0, 0.4, 0.5, 1.5) for k in range(4)
        )
        return [Seed("smrmsg.txt", (head + rows).encode()), Seed("smrmsg.out", binary)]

    def run(self, path, data):
        report = vtkhelios.vtkHeliosNavigationReport()
        with vtkhelios.core.pipeline.MessageLog() as log:
            log.watch(report)
            good = report.Read(str(path))
        if not good:
            raise vtkhelios.PipelineError(log.errors)
        values = [report.GetRMS(k) for k in range(6)]
        check_finite("RMS", values)
        check(min(values) >= 0, f"RMS {values}")
        lines = plain_lines(data) if path.suffix == ".txt" else None
        rows = len(data) // 80 if path.suffix == ".out" else lines and len(lines) - 1
        check_count(report.GetNumberOfRows(), rows, (), "rows")


class Sbet(Target):
    """Binary trajectories: times in order, unit quaternions, every record."""

    name = "sbet"
    kind = "binary"

    def make_seeds(self, folder):
        records = [
            (10.0 + 0.1 * k, 0.85, 0.15 + 1e-7 * k, 300 + k, 10, 0, 0, 0.01 * k, 0.02, 1.5)
            for k in range(8)
        ]
        rows = (struct.pack("<17d", *record, *[0.0] * 7) for record in records)
        return [Seed("sbet.out", b"".join(rows))]

    def run(self, path, data):
        reader = vtkhelios.vtkHeliosTrajectoryReader()
        reader.SetFileName(str(path))
        reader.SetTargetCRS("EPSG:32632")
        way, warned = update(reader)
        check_polydata(way)
        times = vtk_to_numpy(way.GetPointData().GetArray("GpsTime"))
        check((np.diff(times) >= 0).all(), "times decrease")
        turns = vtk_to_numpy(way.GetPointData().GetArray("Orientation"))
        check(np.allclose(np.linalg.norm(turns, axis=1), 1.0), "no unit quaternions")
        check_count(len(times), len(data) // 136, warned, "records")


class Pulsewaves(Target):
    """Recorded outgoing pulses, as a file of a pulse shape that a survey reads."""

    name = "instrument-pulse"
    kind = "binary"
    weight = 0.5

    def make_seeds(self, folder):
        pulses, waves = make_pulsewaves()
        return [
            Seed("flight.pls", pulses, {"flight.wvs": waves}),
            Seed("flight.wvs", waves, {"flight.pls": pulses}),
        ]

    def run(self, path, data):
        table = path.with_name("pulse.csv")
        command_line("instrument", path.with_suffix(".pls"), "--output", table)
        instrument = vtkhelios.vtkHeliosScanner()
        instrument.SetPulseShapeToSampled()
        instrument.SetPulseFileName(str(table))
        with contextlib.closing(io.StringIO(table.read_text())) as lines:
            rows = np.loadtxt(lines, delimiter=",", ndmin=2)
        check_finite("pulse", rows)
        check(len(rows) > 0, "the pulse has no samples")


def make_targets():
    beams = SPINNING.format(
        more='headRotatePerSecMax_deg="3600"', parts='<beams file="beams.csv"/>'
    )
    shape = small_files.ASSETS.replace('id="tls"', 'id="s"').replace(
        '<FWFSettings beamSampleQuality="2"/>', '<FWFSettings beamSampleQuality="2" pulseShape="pulse.csv"/>'
    )  # fmt: skip
    return [
        Parts(),
        SurveyTable("beam-table", "beams.csv", BEAMS, scanner=beams),
        SurveyTable("pulse-shape", "pulse.csv", PULSE, scanner=shape),
        SurveyTable("leaf-table", "leaves.csv", LEAVES, scene=TURBID),
        NavigationReport(), Sbet(), Pulsewaves(),
    ]  # fmt: skip
