# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A PlantArea in lines of text, and its profile as a picture."""

import numpy as np

from ..core.words import counted
from .charts import BLUE, ORANGE, load, to_png

ROWS = 30  # lines of the printed profile
BAR = 24  # characters of the densest layer


def leaf_area_lines(found):
    """Returns the results as lines for the terminal."""
    state = found.as_dict()["voxels"]
    known = (
        "with those that hit nothing" if found.knows_misses else "those that hit nothing unknown"
    )
    yield f"{found.name}: {counted(found.scans, 'scan')}, {counted(int(found.pulses), 'pulse')}, {known}"
    yield (
        f"{' x '.join(map(str, found.shape))} voxels of {found.voxel:g} m: {state['seen']:,} seen, "
        f"{state['shadowed']:,} shadowed, {state['noBeam']:,} without beams"
        + (f", {state['saturated']:,} saturated" if state["saturated"] else "")
    )
    yield (
        f"plant area {found.area:.5g} ± {found.area_error:.2g} m² in the voxels seen; LAI "
        f"{found.lai:.3f} ± {found.lai_error:.3f} over {found.ground_area:.5g} m² "
        f"({found.lai_seen:.3f} without the shadowed)"
    )
    yield from _profile_lines(found)


def _profile_lines(found):
    rows = found.profile()
    step = -(-len(rows) // ROWS) or 1
    largest = max((row["pad"] for row in rows if row["pad"] > 0), default=1.0)
    yield f"{'height m' if found.has_ground else 'z m':>9}  PAD m²/m³         seen"
    for row in rows[::-1][::step]:
        if np.isnan(row["pad"]):
            yield f"{row['height']:9.2f}  {'not seen':16}  {100 * row['seen']:4.0f} %"
            continue
        bar = "#" * round(BAR * row["pad"] / largest)
        value = f"{row['pad']:.3f} ± {row['pad_error']:.3f}"
        yield f"{row['height']:9.2f}  {value:16}  {100 * row['seen']:4.0f} %  {bar}".rstrip()
    if step > 1:
        yield f"(one layer of {step} is printed; {len(rows)} in all)"


def draw_profile(found):
    """Returns a PNG: density over height with its standard error, and the share that is seen."""
    rows = found.profile()
    height, pad, error, seen = (
        np.array([row[name] for row in rows]) for name in ("height", "pad", "pad_error", "seen")
    )
    figure, (left, right) = load().subplots(
        1, 2, figsize=(6.4, 4.2), sharey=True, layout="constrained",
        gridspec_kw={"width_ratios": (3, 1)},
    )  # fmt: skip
    low = np.maximum(pad - 2 * error, 0)
    left.fill_betweenx(height, low, pad + 2 * error, color=BLUE, alpha=0.25, linewidth=0)
    left.plot(pad, height, color=BLUE, linewidth=1.4)
    left.set_xlim(0, None)
    left.set_xlabel("plant area density [m²/m³], ± 2 standard errors")
    left.set_ylabel("height above ground [m]" if found.has_ground else "z [m]")
    left.set_title(f"LAI {found.lai:.2f} ± {found.lai_error:.2f}", loc="left")
    right.plot(100 * seen, height, color=ORANGE, linewidth=1.4)
    right.set_xlim(0, 102)
    right.set_xlabel("voxels seen [%]")
    return to_png(figure)
