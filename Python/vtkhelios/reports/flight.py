# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The result of a flight plan as text."""

from ..core.words import between, counted, digits, time_span
from .plan import print_rows

MAXIMUM_ROWS = 50
COLUMNS = (  # columns of the table of lines: title, text
    ("line", lambda row: str(row["line"])),
    ("x0 [m]", lambda row: f"{row['begin'][0]:.2f}"),
    ("y0 [m]", lambda row: f"{row['begin'][1]:.2f}"),
    ("x1 [m]", lambda row: f"{row['end'][0]:.2f}"),
    ("y1 [m]", lambda row: f"{row['end'][1]:.2f}"),
    ("z [m]", lambda row: heights(row)),
    ("heading [deg]", lambda row: f"{row['heading_deg']:.1f}"),
    ("length [m]", lambda row: f"{row['length_m']:,.1f}"),
    ("time [s]", lambda row: f"{row['time_s']:.1f}"),
)


def heights(row):
    low, high = row["lowest_m"], row["highest_m"]
    return f"{low:.1f}" if high - low < 0.05 else f"{low:.1f} to {high:.1f}"


def print_lines(rows):
    """The lines on standard output."""
    print_rows(rows[:MAXIMUM_ROWS], COLUMNS)
    if len(rows) > MAXIMUM_ROWS:
        print(f"and {len(rows) - MAXIMUM_ROWS} more; all are in lines.csv")


def flight_lines(report):
    """Yields the design and the prediction, as text."""
    scan, flight, predicted = report["scan"], report["flight"], report["predicted"]
    lines = (
        f", {scan['scanFrequency_Hz']:.4g} Hz scan frequency" if scan["scanFrequency_Hz"] else ""
    )
    yield (
        f"scan     {scan['scanner']}: {scan['pulseFrequency_Hz'] / 1000:g} kHz{lines}, swath of "
        f"{2 * scan['halfSwath_deg']:.1f} deg, {flight['swathWidth_m']:.4g} m"
    )
    height = predicted["flyingHeight_m"]
    lines = counted(flight["lines"], "line")
    if flight["lines"] > 1:
        lines += f" every {digits(flight['lineSpacing_m'])} m"
    yield (
        f"flight   {lines}, {flight['speed_m_s']:.4g} m/s; "
        f"{between(height['minimum'], height['maximum'], 'm')} above ground"
    )
    turns = (
        f"{flight['turnTime_s']:g} s"
        if flight["turnTime_s"]
        else f"radius {digits(flight['turnRadius_m'])} m"
    )
    yield (
        f"time     {time_span(flight['time_s'])}: lines {flight['lineLength_m'] / 1000:.4g} km, turns "
        f"{flight['turnLength_m'] / 1000:.4g} km ({turns})"
    )
    yield from predicted_lines(predicted)
    yield from step_lines(report)


def step_lines(report):
    """Yields what the next lower and higher pulse frequency would cost."""
    for name, step in report["steps"].items():
        yield f"{name:8} {describe_step(step)}"


def describe_step(step):
    """Returns the cost of another pulse frequency, or the reason why none exists."""
    if "reason" in step:
        return step["reason"]
    return (
        f"{step['pulseFrequency_Hz'] / 1000:g} kHz: {time_span(step['time_s'])} ({_change(step['timeFactor'], 'time')}), "
        f"{digits(step['speed_m_s'], 3)} m/s, {digits(step['flyingHeight_m'], 3)} m above ground, a strip of at least "
        f"{digits(step['strip_1_m2'], 3)} pulses/m² ({_change(step['pulsesFactor'], 'pulses', 'fewer')})"
    )


def _change(factor, what, less="less"):
    """Returns how much a factor changes something: 12 % more time."""
    percent = round(100 * (factor - 1))
    return (
        f"{abs(percent)} % {'more' if percent > 0 else less} {what}"
        if percent
        else f"the same {what}"
    )


def predicted_lines(predicted):
    strip, density = predicted["strip_1_m2"], predicted["density_1_m2"]
    yield (
        f"density  of a strip at least {strip['minimum']:.4g}, on average {predicted['meanOfStrips_1_m2']:.4g} "
        f"pulses/m²; of all at least {density['minimum']:.4g}, on average {density['mean']:.4g}"
    )
    if predicted["along_m"] is not None:
        yield (
            f"spacing  at most {predicted['along_m']:.3g} m along and {predicted['across_m']:.3g} m across, "
            "in a strip"
        )
    yield (
        f"covered  {predicted['covered_percent']:.2f} % of {predicted['area_m2']:,.0f} m², "
        f"{predicted['overlap_percent']:.1f} % by two strips or more; {predicted['met_percent']:.2f} % with "
        f"{predicted['required_1_m2']:.4g} pulses/m² or more of one strip"
    )


def lacks(report):
    """Warnings about what a plan does not reach."""
    predicted, settings = report["predicted"], report["settings"]
    if predicted["covered_percent"] < 100:
        yield (
            f"{100 - predicted['covered_percent']:.2f} % of the area is in no strip: the ground rises above "
            "the lines or drops below the largest range; give --terrain-following, or a larger "
            "--side-overlap"
        )
    if predicted["met_percent"] < 99:
        yield (
            f"{100 - predicted['met_percent']:.1f} % of the area has less than "
            f"{predicted['required_1_m2']:.4g} pulses/m² of one strip, on slopes or far below the lines; give "
            "--terrain-following, or lower --min-speed"
        )
    if predicted["flyingHeight_m"]["minimum"] < settings["nohd_m"] * (1 - 1e-9):
        yield (
            f"the lowest height above the ground is {predicted['flyingHeight_m']['minimum']:.4g} m, below "
            f"--nohd {settings['nohd_m']:g}; give a larger --max-climb or --flying-height"
        )


def check_lines(check):
    """Yields the result of a simulation."""
    predicted, simulated = check["predicted_1_m2"], check["simulated_1_m2"]
    yield (
        f"check    {check['firstReturns']:,} first returns in {counted(check['cells'], 'cell')} of {check['cell_m']:.3g} m: "
        f"predicted {predicted['mean']:.4g}, simulated {simulated['mean']:.4g} pulses/m² "
        f"({check['bias_percent']:+.2f} %); least {predicted['minimum']:.4g} and {simulated['minimum']:.4g}"
    )
    yield (
        f"         95 % of the cells agree within {check['within95_percent']:.1f} %; {check['empty']:,} of "
        f"{counted(check['gapCells'], 'cell')} of {check['gapCell_m']:.3g} m have no return"
    )
