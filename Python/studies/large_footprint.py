# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Height percentiles of GEDI's footprints, against those of the same footprints from an airborne scan.

    build/venv/bin/python Python/studies/large_footprint.py OUT [--quick]

The stand of vtkhelios new --kind forest is flown over by GEDI (space.xml, nine footprints) and by an
aircraft. RH q is the height above the ground below which q percent of the energy of a waveform lies
(Dubayah et al. 2020, Science of Remote Sensing 1, 100002). From points it is computed as the
simulator of the mission does (Hancock et al. 2019, Earth and Space Science 6, 294): points, weighted
by the beam at their place, are folded with the pulse.
"""

import pathlib
import tempfile
import time

import numpy as np

import _study
import vtkhelios
from vtkhelios.example_surveys import forest, write_example

LIGHT = 0.299792458  # [m/ns]
SIGMA = 5.5  # footprint [m], 22 m at 1/e2
PULSE = 0.5 * LIGHT * 15.6 / 2.3548  # pulse along the beam [m]
STEP = 0.15  # step of profiles [m]
SUB_RAYS = 10_000  # beams in turbid voxels have a few hundred otherwise
PERCENTS = (25, 50, 75, 90, 98)
AIR = """\
<document><survey name="air" scene="scene.xml#stand" platform="platforms.xml#airplane_linearpath"
  scanner="instruments/riegl_airborne.xml#riegl_vq780ii">
  <leg><platformSettings x="0" y="-50" z="500" movePerSec_m="{speed}"/>
    <scannerSettings pulseFreq_hz="1000000" scanFreq_hz="200" scanAngle_deg="5"/></leg>
  <leg><platformSettings x="0" y="50" z="500"/><scannerSettings active="false"/></leg>
</survey></document>
"""


def make_folder(folder, speed):
    write_example("forest", folder)
    (folder / "air.xml").write_text(AIR.format(speed=speed), encoding="utf-8")
    return folder


def find_ground(x, y):
    """Returns the height of the ground at a footprint: the mean over the beam [m]."""
    offsets = np.linspace(-3, 3, 61)
    dx, dy = np.meshgrid(offsets, offsets)
    weights = np.exp(-0.5 * (dx**2 + dy**2))
    return np.average(forest.height_at(x + SIGMA * dx, y + SIGMA * dy), weights=weights)


def find_percentiles(heights, energies):
    """Returns the heights below which PERCENTS of the energies lie; heights increase."""
    shares = np.cumsum(energies) - 0.5 * energies
    return np.interp(np.array(PERCENTS) / 100.0 * energies.sum(), shares, heights)


class Waveforms:
    """The waveforms of a run that come from the stand: centres of footprints, and profiles."""

    def __init__(self, table):
        self._table = vtkhelios.arrays(table)
        offsets = self._table["Offset"], self._table["Count"]
        self._samples = [self._table["Samples"][a : a + n] for a, n in zip(*offsets)]
        self.centres = [self._find(row, 410e3)[:2] for row in range(len(self._samples))]

    def _find(self, row, distance):
        origin, direction = self._table["Origin"][row], self._table["Direction"][row]
        return origin + np.multiply.outer(distance, direction)

    def profile(self, row):
        """Returns heights, from below, and energies of a waveform."""
        samples = self._samples[row]
        times = self._table["StartTime"][row] + self._table["BinSize"][row] * np.arange(
            len(samples)
        )
        return self._find(row, 0.5 * LIGHT * times)[::-1, 2], np.asarray(samples[::-1], float)


def make_profile(cloud, centre, by_energy):
    """The profile of the points in a footprint, folded with the pulse; all points count alike, or by
    their energy."""
    away = np.linalg.norm(cloud.points[:, :2] - centre, axis=1)
    near = away < 3.0 * SIGMA
    weights = np.exp(-0.5 * (away[near] / SIGMA) ** 2)
    if by_energy:
        weights = weights * cloud["Amplitude"][near] * cloud["EchoWidth"][near]
    z = cloud.points[near, 2]
    edges = np.arange(z.min() - 6.0 * PULSE, z.max() + 6.0 * PULSE, STEP)
    counts, _ = np.histogram(z, edges, weights=weights)
    heights = 0.5 * (edges[1:] + edges[:-1])
    pulse = np.exp(-0.5 * (np.arange(-33, 34) * STEP / PULSE) ** 2)
    return heights, np.convolve(counts, pulse, "same")


def compare(waveforms, cloud):
    """The percentiles of each footprint: of the waveform, of points, and of their energies."""
    found = []
    for row, (x, y) in enumerate(waveforms.centres):
        ground = find_ground(x, y)
        profiles = [waveforms.profile(row)]
        profiles += [make_profile(cloud, (x, y), by_energy) for by_energy in (False, True)]
        found.append([find_percentiles(*profile) - ground for profile in profiles])
    return np.array(found)


def measure_costs(survey, counts):
    """A row for each number of sub-rays: seconds per footprint, and the mean and the largest difference
    of a percentile from the last [m]."""
    rows, found = [], []
    for count in counts:
        begin = time.process_time()
        waveforms = run_space(survey, count)
        seconds = (time.process_time() - begin) / len(waveforms.centres)
        found.append([find_percentiles(*waveforms.profile(row))
                      for row in range(len(waveforms.centres))])  # fmt: skip
        rows.append({"sub_rays": count, "seconds": seconds})
    for row, percentiles in zip(rows, found):
        change = np.abs(np.subtract(percentiles, found[-1]))
        row |= {"mean_m": change.mean(), "largest_m": change.max()}
    return rows


def run_space(survey, sub_rays=SUB_RAYS):
    cloud = survey.run(waveforms=True, noise=False, instances=True, sub_rays=sub_rays)
    return Waveforms(cloud.waveforms)


def summarize(found):
    """A row for each percentile: the mean, and the mean and deviation of the differences [m]."""
    for index, percent in enumerate(PERCENTS):
        own = found[:, 0, index]
        row = {"percentile": f"RH{percent}", "GEDI_m": own.mean()}
        for k, name in ((1, "points"), (2, "energies")):
            less = found[:, k, index] - own
            row |= {f"{name}_m": less.mean(), f"{name}_sigma_m": less.std(ddof=1)}
        yield row


def draw(waveforms, cloud, path):
    """Profiles of the first footprints, relative to their largest energy."""
    figure, axes = _study.make_figure(3)
    for row, one in enumerate(axes):
        x, y = waveforms.centres[row]
        names = ("GEDI", "points", "energies")
        profiles = [waveforms.profile(row)]
        profiles += [make_profile(cloud, (x, y), by_energy) for by_energy in (False, True)]
        for name, (heights, energies) in zip(names, profiles):
            one.plot(energies / energies.max(), heights - find_ground(x, y), label=name)
        one.set(title=f"x {round(x)} m, y {round(y)} m", xlabel="energy", ylabel="above ground [m]")
    axes[0].legend()
    _study.save_figure(figure, path)


def main():
    options = _study.arguments(__doc__)
    with tempfile.TemporaryDirectory() as scratch:
        folder = make_folder(pathlib.Path(scratch) / "stand", 60 if options.quick else 15)
        survey = vtkhelios.read_survey(folder / "space.xml")
        waveforms = run_space(survey)
        cloud = vtkhelios.read_survey(folder / "air.xml").run(noise=False, instances=True)
        found = compare(waveforms, cloud)
        counts = (1000, 10_000) if options.quick else (1000, 3000, 10_000, 30_000, 60_000)
        costs = measure_costs(survey, counts)
    numbers = {"percentiles": list(summarize(found)), "costs": costs}
    print(f"{len(waveforms.centres)} footprints, {len(cloud):,} points")
    for name, rows in numbers.items():
        _study.print_table(rows, name)
        _study.write_csv(options.out / f"large_footprint_{name}.csv", rows)
    draw(waveforms, cloud, options.out / "large_footprint.png")
    return numbers


if __name__ == "__main__":
    main()
