# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""What vtkhelios run writes besides the echoes, by options that are on or off."""

from typing import NamedTuple


class Output(NamedTuple):
    option: str
    setter: str  # of vtkHeliosSurveyPlayer
    help: str


OUTPUTS = (
    Output(
        "--waveforms",
        "SetWriteWaveforms",
        help="also write the waveforms (as text, as VTK XML, or as LAS with point format 9 or 10)",
    ),
    Output(
        "--waveforms-in-points",
        "SetWaveformsInPoints",
        help="with --format las --waveforms: only legNNN_points.las, with point format 9 or 10, "
        "which PDAL and QGIS refuse (default: point format 6 or 7, and legNNN_fullwave.las)",
    ),
    Output(
        "--scan-flags",
        "SetWriteScanFlags",
        help="echoes in text and VTK XML with the scan direction flag and the edge of flight line; "
        "in text as columns 12 and 13 (default: only in LAS, which always has them)",
    ),
    Output(
        "--decibels",
        "SetWriteDecibels",
        help="echoes with the amplitude above the detection threshold and the reflectance [dB]: in "
        "text as columns 14 and 15 after those of --scan-flags, in LAS as RIEGL names them",
    ),
    Output(
        "--colors",
        "SetWriteColors",
        help="echoes with the colour of the surface, Kd and map_Kd of OBJ files, as RGB; with "
        "--format las or vtp",
    ),
    Output(
        "--pulses",
        "SetWritePulses",
        help="also write the pulses, including those without a hit",
    ),
    Output(
        "--hits",
        "SetWriteHits",
        help="also write every hit of the sub-rays of a beam, with its share of the pulse (Weight): "
        "what leaf-area estimates need of partial hits; always VTK XML, large",
    ),
    Output(
        "--truth",
        "SetWriteTruth",
        help="with --format vtp: also write the true point and normal of every echo, without noise "
        "and navigation errors (TruePoint, Normal)",
    ),
    Output(
        "--columns",
        "SetWriteColumns",
        help="with --format vtp: also write the column of every echo and pulse in the revolution of a "
        "spinning head (ColumnIds); its beams are ChannelIds",
    ),
    Output(
        "--split-by-channel",
        "SetSplitByChannel",
        help="one file per scanner channel: legNNN_points_dev<channel>.xyz",
    ),
)


def add_output_arguments(parser):
    for output in OUTPUTS:
        parser.add_argument(output.option, action="store_true", help=output.help)


def set_outputs(player, arguments):
    for output in OUTPUTS:
        name = output.option.removeprefix("--").replace("-", "_")
        getattr(player, output.setter)(getattr(arguments, name))
