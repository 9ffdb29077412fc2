# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a run makes besides the echoes: one table, for Python, the command line and the report page."""

from typing import NamedTuple


class Output(NamedTuple):
    name: str  # of Survey.run() and run_to(); with hyphens the option of vtkhelios run
    source: str  # property of vtkHeliosSurveySource; empty: of files only
    player: str  # property of vtkHeliosSurveyPlayer
    key: str  # in the options of run_summary.json
    title: str  # of a report page
    state: str  # there, if it is on
    help: str  # of the command line

    @property
    def option(self):
        return f"--{self.name.replace('_', '-')}"


OUTPUTS = (
    Output(
        "waveforms", "generate_waveforms", "write_waveforms", "waveforms",
        "waveforms", "written",
        help="also write the waveforms (as text, as VTK XML, or as LAS with point format 9 or 10)",
    ),
    Output(
        "waveforms_in_points", "", "waveforms_in_points", "waveformsInPoints",
        "waveforms in the files of points", "yes",
        help="with --format las --waveforms: only legNNN_points.las, with point format 9 or 10, "
        "which PDAL and QGIS refuse (default: point format 6 or 7, and legNNN_fullwave.las)",
    ),
    Output(
        "scan_flags", "generate_scan_flags", "write_scan_flags", "scanFlags",
        "scan direction and edge flags", "written",
        help="echoes in text and VTK XML with the scan direction flag and the edge of flight line; "
        "in text as columns 12 and 13 (default: only in LAS, which always has them)",
    ),
    Output(
        "decibels", "generate_decibels", "write_decibels", "decibels",
        "amplitude and reflectance in dB", "written",
        help="echoes with the amplitude above the detection threshold and the reflectance [dB]: in "
        "text as columns 14 and 15 after those of --scan-flags, in LAS as RIEGL names them",
    ),
    Output(
        "colors", "generate_colors", "write_colors", "colors",
        "colours of surfaces", "written, as RGB",
        help="echoes with the colour of the surface, Kd and map_Kd of OBJ files, as RGB; with "
        "--format las or vtp",
    ),
    Output(
        "pulses", "generate_pulses", "write_pulses", "pulses",
        "pulses", "written",
        help="also write the pulses, including those without a hit",
    ),
    Output(
        "hits", "generate_sub_rays", "write_hits", "hits",
        "hits of sub-rays", "written",
        help="also write every hit of the sub-rays of a beam, with its share of the pulse (Weight): "
        "what leaf-area estimates need of partial hits; always VTK XML, a file per block, large",
    ),
    Output(
        "truth", "generate_truth", "write_truth", "truth",
        "points and normals without noise", "written",
        help="with --format vtp: also write the true point and normal of every echo, without noise "
        "and navigation errors (TruePoint, Normal)",
    ),
    Output(
        "columns", "generate_columns", "write_columns", "columns",
        "columns of spinning optics", "written",
        help="with --format vtp: also write the column of every echo and pulse in the revolution of a "
        "spinning head (ColumnIds); its beams are ChannelIds",
    ),
    Output(
        "split_by_channel", "", "split_by_channel", "splitByChannel",
        "files", "one per channel",
        help="one file per scanner channel: legNNN_points_dev<channel>.xyz",
    ),
)  # fmt: skip


def in_memory():
    """Names in Python, and properties of vtkHeliosSurveySource."""
    return {output.name: output.source for output in OUTPUTS if output.source}


def in_files():
    """Names in Python, and properties of vtkHeliosSurveyPlayer."""
    return {output.name: output.player for output in OUTPUTS}
