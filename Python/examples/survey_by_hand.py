# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A terrestrial survey built by hand, filter by filter; its echoes as numpy arrays without a copy.

What `vtkhelios run` does with a survey file, this does with objects:

    synthetic scene ─────────────────────┬──────────────> port 0 ─┐
                                         │                        ├─ scanner ─> echoes
    waypoint ──> ground snap ──> tripod ─┼──────────────> port 1 ─┘
                     └─ scene ───────────┘

Run it with

    build/venv/bin/python Python/examples/survey_by_hand.py
"""

import numpy as np

import vtkhelios


def make_scene():
    """Blocks on flat ground. Any source of triangles works, e.g. vtkHeliosObjSceneReader."""
    return vtkhelios.vtkHeliosSyntheticScene(kind="blocks")


def make_platform(scene, x, y):
    """A tripod, 1.5 m above the ground below (or above) a waypoint."""
    waypoint = vtkhelios.Cloud.from_arrays([[x, y, 0.0]])
    snap = vtkhelios.vtkHeliosGroundSnap(height_above_ground=1.5)
    return (waypoint, scene) >> snap >> vtkhelios.vtkHeliosStaticPlatform()


def make_scanner(scene, platform):
    """A polygon mirror rotating once about the vertical axis: 100,000 pulses/s for 4 s."""
    mirror = vtkhelios.vtkHeliosRotatingMirror(
        pulse_frequency=100_000,  # Hz
        scan_frequency=100,  # lines/s
        mirror_angle=120,  # deg, half of the sweep of a facet
        vertical_angle_min=-40,  # deg
        vertical_angle_max=60,
    )
    beam = vtkhelios.vtkHeliosBeamSampler(
        beam_divergence=0.35e-3,  # rad, full angle at 1/e^2
        pattern="circles",
        number_of_circles=3,  # 19 sub-rays
    )
    scanner = vtkhelios.vtkHeliosScanner(
        beam_deflector=mirror,
        beam_sampler=beam,
        head_rotate_start=0,  # deg
        head_rotate_stop=360,
        head_rotate_speed=90,  # deg/s
        range_min=0.5,  # m
        range_max=600,
        range_accuracy=0.005,  # m, one sigma
    )
    return ((scene, platform) >> scanner).last


def main():
    scene = make_scene()
    scanner = make_scanner(scene, make_platform(scene, 0.0, 0.0))

    cloud = vtkhelios.Cloud(
        scanner()
    )  # views: nothing is copied; an error would raise PipelineError
    first = cloud["ReturnNumber"] == 1
    ranges = cloud["Range"]
    print(f"{scanner.number_of_pulses:,} pulses, {len(cloud):,} echoes, {first.sum():,} first ones")
    print(
        f"ranges from {ranges.min():.2f} to {ranges.max():.2f} m, median {np.median(ranges):.2f} m"
    )
    print(f"strongest echo {cloud['Amplitude'].max() * 1e9:.1f} nW")

    # Changing a property of the scanner re-runs the scanner only.
    scanner.range_accuracy = 0.0
    exact = vtkhelios.Cloud(scanner())
    print(f"range noise: {1000 * np.std(ranges - exact['Range']):.2f} mm")
    return vtkhelios.arrays(cloud.data)


if __name__ == "__main__":
    main()
