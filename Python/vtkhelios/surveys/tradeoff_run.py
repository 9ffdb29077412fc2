# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the ways to compute a survey, and the survey without parts of its model."""

import contextlib
import math
import time

import numpy as np
from vtkmodules.vtkCommonCore import vtkSMPTools

from ..array_names import PART_IDS, SCATTERED_AMPLITUDE
from ..core.classes import vtk_class, vtk_classes
from ..core.words import counted
from ..scenes import meshes as meshes
from ..scenes.scene import count_triangles, flatten, has_instances
from . import tradeoff as kinds
from .accuracy import MEASURES, POSITION, Estimate, Sampler
from .tradeoff import Row, Tradeoff

BINS_PER_PULSE = 50  # bins of the reference
# The reference is adaptive, at a tenth of the narrowest tolerance that it judges, with this many
# sub-rays where it samples. Its error is at most its difference from a coarser one.
FINER, MAXIMUM_SUB_RAYS = 0.1, 1 << 18
COARSER, MAXIMUM_SUB_RAYS_COARSE = 0.3, 1 << 16
MINIMUM_TOLERANCES = 1e-6, 1e-4  # [m] and relative: heliosTolerances.h
SUB_RAYS_OF_CHECK, CHECKED = 32768, 32  # pulses, about
CIRCLES = (1, 2, 3, 5, 9, 18)
SPIRALS, RINGS = (20, 64, 256), (2, 4, 8)  # sub-rays; rings
TOLERANCES = (0.03, 0.01, 0.003, 0.001, 0.0003)  # [m]; ten times as many of the energy
BINS = (0.02, 0.0625, 0.125, 0.25)  # bins per pulse length
BIN_CIRCLES = 5
DISTANCES = (0.01, 0.05)  # distances of simplified meshes [m]
ORDERS = 3  # scatterings of light, of surveys that have one
PART_DISTANCE = 0.05  # distance of simplified parts: one of them
MAXIMUM_TRIANGLES = 400_000  # triangles of a mesh that is simplified
LONGEST, SHARE_OF_MESH = 10.0, 0.2  # processor time of that [s], and of what is left
MAXIMUM_COPIED = 20_000_000  # triangles that ray casters without instances copy
PHOTON_COUNTING = "photonCounting"
MAXIMUM_GROUPS = 6  # largest groups of parts of the scene
CLEAR = 3.0  # times the error of the reference
# blocks of a run: vtkHeliosSurveyPlayer and its estimate
PULSES_PER_BLOCK, COPIES_OF_BLOCK = 262144, 2
MEBIBYTE = 1024**2
# Processor time that a tradeoff may take: so many times that of the run, and at least so many seconds. Settings are
# measured in any case, the other ways and parts while there is time.
RUNS, MINIMUM_SECONDS = 3.0, 10.0
REQUIRED = (kinds.SURVEY, kinds.SUB_RAYS, kinds.TOLERANCE)
PILOT = 8  # one of that many pulses of the sample tells the time of all
SHARE_OF_SETTINGS = 0.5  # share of that time for the samples of reference and settings
MINIMUM_PULSES = 100  # pulses of a thinned sample
SECONDS_PER_TRIANGLE = 6e-6  # time for the tree of another ray caster


def make_tradeoff(survey, pulses=2000, parts=True, on_step=None, seconds=None, **options):
    """See Survey.tradeoff(); on_step is called with a name and the fraction done."""
    options.setdefault("instances", True)
    return _Run(survey, pulses, parts, on_step, options, seconds).make()


def list_ways(noise=0.0):
    """Name, kind and options of each way that needs no other mesh; one has a tenth of the noise of ranges [m]."""
    yield "the survey as it is", kinds.SURVEY, {}
    sampler = vtk_class("vtkHeliosBeamSampler")

    def count(pattern, size):
        return sampler.CountSubRays(pattern, size)

    for circles in CIRCLES:
        number = count(sampler.CIRCLES, circles)
        options = {"sub_rays": number}
        yield f"{number} sub-ray{'s' if number > 1 else ''}", kinds.SUB_RAYS, options
    patterns = [(sampler.VOGEL, size) for size in SPIRALS]
    patterns += [(sampler.GAUSS_LEGENDRE, size) for size in RINGS]
    for pattern, size in patterns:
        name, number = sampler.GetPatternName(pattern), count(pattern, size)
        options = {"sub_rays": number, "sub_ray_pattern": name}
        yield f"{number} sub-rays, {name}", kinds.PATTERN, options
    for tolerance in TOLERANCES:
        choice = {"tolerance": tolerance, "energy_tolerance": min(1.0, 10 * tolerance)}
        yield f"tolerance {1e3 * tolerance:g} mm", kinds.TOLERANCE, choice
    if noise > 0.0:  # the tolerance of accuracy="instrument"
        tolerance = min(1.0, max(MINIMUM_TOLERANCES[0], 0.1 * noise))
        choice = {"tolerance": tolerance, "energy_tolerance": 0.01}
        yield f"tolerance {1e3 * tolerance:g} mm, 1 %", kinds.TOLERANCE, choice
    for bins in BINS:
        choice = {"sub_rays": count(sampler.CIRCLES, BIN_CIRCLES), "bin_size": bins}
        yield f"bins of {bins:g} pulses", kinds.BINS, choice
    for name in vtk_class("vtkHeliosRunOptions").GetEchoDetectorNames().split():
        if name == PHOTON_COUNTING:
            continue  # random: no two of its clouds can be compared
        yield f"detector {name}", kinds.DETECTOR, {"detector": name}
    factory = vtk_class("vtkHeliosRayCasterFactory")
    for index in range(factory.GetNumberOfBackends()):
        name = factory.GetBackendName(index)
        yield f"ray caster {name}", kinds.RAY_CASTER, {"ray_caster": name}


class _Run:
    """The measurement of one tradeoff."""

    def __init__(self, survey, pulses, parts, on_step, options, seconds=None):
        self._survey, self._has_parts = survey, parts
        self._ways, self._absent = list(list_ways(_noise(survey))), []
        self._start, self._seconds, self._skipped = time.process_time(), seconds, []
        self._latest = 0.0  # processor time of the latest step [s]
        names = vtk_class("vtkHeliosRunOptions").GetModelPartNames().split() if parts else []
        self._model_parts = sorted(
            names, key=lambda name: name != "partMotion"
        )  # first, if parts move
        self._step = _Steps(on_step, self._count_steps())
        self._step.begin("drawing pulses")
        self._source = survey.source_of(options)
        load_seconds = time.process_time() - self._start
        self._sampler = Sampler(survey, pulses, self._step.show, options)
        self._scene = self._source.GetScene()
        self._other_memory = self._find_other_memory()
        self._bins = self._sampler.pulse_length()
        self._narrowest = min([*TOLERANCES, *_tolerances(survey, options)])
        self._fine = {"bin_size": self._bins / BINS_PER_PULSE, "without": "voxels"}
        self._limit_time(load_seconds)

    def _limit_time(self, load_seconds):
        """Sets the processor time of all, and thins the sample if its settings alone would take much of that."""
        sampler = self._sampler
        per_pulse = sampler.time()
        threads = vtkSMPTools.GetEstimatedNumberOfThreads()
        run = load_seconds + per_pulse * sampler.share_fired * sampler.total / threads
        if self._seconds is None:
            self._seconds = max(MINIMUM_SECONDS, RUNS * run)
        start = time.process_time()
        self._make_reference(every=PILOT)
        reference = PILOT * (time.process_time() - start)
        settings = sum(kind in (kinds.SURVEY, kinds.TOLERANCE) for _, kind, _ in self._ways)
        needed = 2 * reference + settings * per_pulse * sampler.fired
        factor = math.ceil(needed / max(1e-6, SHARE_OF_SETTINGS * self._seconds))
        factor = min(factor, sampler.fired // MINIMUM_PULSES)
        if factor > 1:
            sampler.thin(factor)

    def _left(self):
        """Returns the processor time that is left [s]."""
        return self._seconds - (time.process_time() - self._start)

    def _affords(self, name, seconds):
        """Returns whether there is time for a step; else it is reported as not measured."""
        has_time = self._left() >= max(0.0, seconds)
        if not has_time:
            self._skipped.append(name)
        return has_time

    def _timed(self, work, *arguments):
        """Does a step, and sets its time as the latest one."""
        start = time.process_time()
        result = work(*arguments)
        self._latest = time.process_time() - start
        return result

    def make(self):
        sampler = self._sampler
        self._step.begin("reference")
        reference = self._make_reference()
        coarse, _ = sampler.run(**self._finely(COARSER, MAXIMUM_SUB_RAYS_COARSE))
        own = sampler.compare(coarse, reference)
        self._step.begin("check of the reference")
        self._own = _plain(confirm(own, *self._check_reference()))
        self._own[POSITION] = self._own["rangeP95_m"]
        rows = self._measure_ways(reference, lambda kind: kind in REQUIRED)
        whole, parts = self._leave_out_model() if self._has_parts else (None, [])
        rows |= self._measure_ways(
            reference, lambda kind: kind not in (*REQUIRED, kinds.RAY_CASTER)
        )
        simplified = self._simplify()
        simpler = [self._measure_mesh(*each, reference) for each in simplified.items()]
        if self._has_parts:
            parts += self._leave_out_scene(whole, simplified)
        rows |= self._measure_ways(reference, lambda kind: kind == kinds.RAY_CASTER)
        ways = [rows[name] for name, *_ in self._ways if rows.get(name)] + simpler
        if self._skipped:
            self._absent.append(
                f"{', '.join(self._skipped)}: they do not fit into {self._seconds:.0f} s of processor time "
                f"({RUNS:g} runs, or {MINIMUM_SECONDS:g} s); give more seconds (--seconds)"
            )
        return Tradeoff(
            survey=self._survey.name,
            pulses=sampler.fired,
            pulses_fired=sampler.share_fired * sampler.total,
            reference=_plain(self._own) | {"tolerance": FINER * self._narrowest},
            ways=ways,
            parts=parts,
            noise=_noise(self._survey),
            other_memory=self._other_memory,
            absent=tuple(self._absent),
        )

    def _count_steps(self):
        """Steps that take about the same time each; some turn out not to be there."""
        parts = len(self._model_parts) + 2 * MAXIMUM_GROUPS + 2 if self._has_parts else 0
        return 3 + len(self._ways) + 2 * len(DISTANCES) + parts

    def _make_reference(self, every=1, **choice):
        return self._sampler.run(every, **choice, **self._finely(FINER, MAXIMUM_SUB_RAYS))[0]

    def _finely(self, factor, most):
        """Options of adaptive sampling at a fraction of the narrowest tolerance."""
        tolerances = tolerance_options(factor * self._narrowest)
        return {**tolerances, "max_sub_rays": most, **self._fine}

    def _check_reference(self):
        """Measures of the reference against many sub-rays, and of these, of few pulses."""
        few = max(1, self._sampler.fired // CHECKED)
        check, half = (
            self._sampler.run(sub_rays=count, sub_ray_pattern="Vogel", every=few, **self._fine)[0]
            for count in (SUB_RAYS_OF_CHECK, SUB_RAYS_OF_CHECK // 2)
        )
        checked, _ = self._sampler.run(**self._finely(FINER, MAXIMUM_SUB_RAYS), every=few)
        return self._sampler.compare(checked, check), self._sampler.compare(half, check)

    def _measure_ways(self, reference, is_meant):
        """Returns the rows of the ways of some kinds, by their names."""
        return {
            name: self._measure_way((name, kind, choice), reference)
            for name, kind, choice in self._ways
            if is_meant(kind)
        }

    def _measure_way(self, way, reference):
        """Returns the row of a way; None if it would copy too many instances."""
        name, kind, choice = way
        self._step.begin(name)
        extra = (
            SECONDS_PER_TRIANGLE * count_triangles(self._scene) if kind == kinds.RAY_CASTER else 0.0
        )
        if kind not in REQUIRED and not self._affords(name, self._latest + extra):
            return None
        return self._timed(self._measure_listed, name, kind, choice, reference)

    def _measure_listed(self, name, kind, choice, reference):
        if kind == kinds.RAY_CASTER and choice["ray_caster"] != "beam" and self._is_huge():
            self._absent.append(
                f"{name}: it copies instances, and the scene has "
                f"{counted(count_triangles(self._scene), 'triangle')} with them; at most {MAXIMUM_COPIED:,} are copied here"
            )
            return None
        if kind == kinds.BINS:
            choice = {**choice, "bin_size": round(choice["bin_size"] * self._bins, 6)}
            name = f"{choice['sub_rays']} sub-rays, bins {choice['bin_size']:.3g} ns"
        elif kind == kinds.DETECTOR:  # each measures the range in its own way
            reference = self._make_reference(**choice)
        return self._measure(name, kind, choice, reference)

    def _is_huge(self):
        return has_instances(self._scene) and count_triangles(self._scene) > MAXIMUM_COPIED

    def _measure(self, name, kind, options, reference, detail="", **more):
        """Returns a way against the reference."""
        cloud, _ = self._sampler.run(**options, **more, without="voxels")
        errors = _only(self._sampler.compare(cloud, reference))
        return self._make_row(name, kind, options, errors, len(cloud), detail, **more)

    def _make_row(self, name, kind, options, errors, echoes, detail="", seconds=None, **more):
        unclear = tuple(
            each for each in errors if errors[each].value <= CLEAR * self._own[each].value
        )
        memory = self._sampler.memory(**options, **more)  # before others' runs drop the trees
        if seconds is None:
            seconds = self._sampler.time(**options, **more)
        return Row(name, kind, options, errors, seconds, echoes, memory, unclear, detail)

    # Meshes.

    def _simplify(self):
        """Returns the scene simplified within distances, and what was verified: by distance."""
        count, made = count_triangles(self._scene), {}
        if "vtkHeliosMeshSimplify" not in vtk_classes():
            self._absent.append("simplified meshes: this build has no CGAL")
        elif count > MAXIMUM_TRIANGLES:
            self._absent.append(
                f"simplified meshes: the scene has {counted(count, 'triangle')}, and at most "
                f"{MAXIMUM_TRIANGLES:,} are simplified here"
            )
        elif count > 0:
            self._scene = flatten(self._scene)
            for distance in DISTANCES:
                self._step.begin(f"simplifying the mesh within {1e3 * distance:g} mm")
                longest = min(LONGEST, SHARE_OF_MESH * self._left())
                if not self._affords(f"mesh within {1e3 * distance:g} mm", self._latest + longest):
                    continue
                mesh = meshes.simplify(self._scene, distance, longest, self._step.show)
                if mesh and mesh[0].GetNumberOfPolys() < count:
                    made[distance] = mesh
                else:
                    self._absent.append(
                        f"mesh within {1e3 * distance:g} mm: it has as many triangles"
                        if mesh
                        else f"mesh within {1e3 * distance:g} mm: it takes more than {longest:.2g} s"
                    )
        return made

    def _measure_mesh(self, distance, simplified, reference):
        mesh, verified = simplified
        name = f"mesh within {1e3 * distance:g} mm"
        self._step.begin(name)
        detail = (
            f"{mesh.GetNumberOfPolys():,} of {counted(self._scene.GetNumberOfPolys(), 'triangle')}, "
            f"verified {1e3 * verified:.3g} mm"
        )
        return self._measure(name, kinds.MESH, {}, reference, detail, mesh=mesh)

    # Parts of the model and of the scene.

    def _leave_out_model(self):
        """Returns the echoes of the survey as it is, and the rows of the survey without each part of the model; first
        itself."""
        self._step.begin("the whole model")
        whole, _ = self._sampler.run()
        rows = [self._compare_part("the whole model", kinds.PART, {}, whole, whole)]
        has_scattering = SCATTERED_AMPLITUDE in whole.names
        for part in self._model_parts:
            if part == "scattering" and not has_scattering:
                self._add_change(rows, "with scattering", {"scattering_orders": ORDERS}, whole)
                continue
            if reason := self._find_absence(part):
                self._absent.append(f"without {part}: {reason}")
                continue
            self._add_change(rows, f"without {part}", {"without": part}, whole)
        self._add_change(rows, "with noise", {"noise": True}, whole)
        return whole, rows

    def _add_change(self, rows, name, options, whole):
        if self._affords(name, self._latest):
            rows.append(self._timed(self._change_model, name, options, whole, rows[0]))

    def _change_model(self, name, options, whole, base):
        """Returns the model with an option, timed in turn with the whole model, the base."""
        self._step.begin(name)
        cloud, _ = self._sampler.run(**options)
        before, seconds = self._sampler.time_pair({}, options)
        seconds *= base.seconds / max(1e-12, before)
        row = self._compare_part(name, kinds.PART, options, cloud, whole, seconds=seconds)
        row.verdict = kinds.find_verdict(row, base)
        return row

    def _compare_part(self, name, kind, options, cloud, whole, detail="", **more):
        errors = _only(self._sampler.compare(cloud, whole))
        errors[POSITION] = self._sampler.displacement(cloud, whole)
        return self._make_row(name, kind, options, errors, len(cloud), detail, **more)

    def _find_absence(self, part):
        """Why this survey does not have a part of the model; empty: it has it."""
        grids = []
        while (grid := self._source.GetGrid(len(grids))) is not None:
            grids.append(grid)
        if part == "voxels" and not grids:
            return "the scene has no turbid voxels"
        if part == "specular" and not any(map(meshes.has_lobes, [self._scene, *grids])):
            return "no material is specular"
        if part == "spectra" and not any(map(meshes.has_spectra, [self._scene, *grids])):
            return "no material has a spectrum"
        if part == "partMotion" and not self._survey.moving_parts:
            return "no part of the scene moves"
        if part in ("motion", "attitude") and not _moves(self._survey):
            return "the platform does not move while it scans"
        return ""

    def _leave_out_scene(self, whole, simplified):
        """Returns the scene without each of its largest groups of parts, and with each
        simplified."""
        groups, rows = meshes.find_groups(self._scene), []
        if len(groups) < 2:
            self._absent.append("parts of the scene: there is one, or one kind")
            return rows
        if len(groups) > MAXIMUM_GROUPS:
            self._absent.append(
                f"{len(groups) - MAXIMUM_GROUPS} smaller parts, or kinds of parts, of the scene: only "
                f"the {MAXIMUM_GROUPS} with the most triangles are left out"
            )
        for group in groups[:MAXIMUM_GROUPS]:
            others = whole[~np.isin(whole[PART_IDS], group.ids)]
            self._step.begin(f"without {group.name}")
            if len(others) == 0:
                self._absent.append(f"without {group.name}: all echoes are on it")
                continue
            if not self._affords(f"without {group.name}", self._latest):
                continue
            rows.append(self._timed(self._leave_out_group, group, whole, others))
            if PART_DISTANCE in simplified:
                name = f"{group.name} simplified"
                self._step.begin(name)
                if self._affords(name, self._latest):
                    rows += self._simplify_group(group, whole, simplified[PART_DISTANCE][0])
        return rows

    def _leave_out_group(self, group, whole, others):
        """How the echoes on all else change without some parts."""
        mesh = meshes.without_parts(self._scene, group.ids)
        cloud, _ = self._sampler.run(mesh=mesh)
        share = 100 * (1 - len(others) / len(whole))
        detail = f"{counted(group.triangles, 'triangle')}, {share:.3g} % of the echoes"
        name = f"without {group.name}"
        return self._compare_part(name, kinds.SCENE_PART, {}, cloud, others, detail, mesh=mesh)

    def _simplify_group(self, group, whole, simplified):
        """How all echoes change with some parts simplified, if they have fewer triangles then."""
        mesh = meshes.with_parts(self._scene, simplified, group.ids)
        saved = self._scene.GetNumberOfPolys() - mesh.GetNumberOfPolys()
        if saved <= 0:
            return []
        cloud, _ = self._sampler.run(mesh=mesh)
        detail = f"{group.triangles - saved:,} of {counted(group.triangles, 'triangle')}"
        name = f"{group.name} within {1e3 * PART_DISTANCE:g} mm"
        row = self._compare_part(name, kinds.SCENE_PART, {}, cloud, whole, detail, mesh=mesh)
        return [row]

    def _find_other_memory(self):
        """Returns about how much memory a run of the survey needs besides scene and ray caster
        [bytes]."""
        cloud, fired = self._sampler.run()
        now = MEBIBYTE * vtk_class("vtkHeliosMemoryLimit").GetUsed() - self._sampler.memory()
        per_pulse = 1024 * cloud.data.GetActualMemorySize() / max(1, fired)
        total = self._sampler.share_fired * self._sampler.total
        return now + COPIES_OF_BLOCK * per_pulse * min(PULSES_PER_BLOCK, total)


def confirm(own, found, of_check):
    """Returns the errors of a reference: its own, or what a check found where no error explains
    that."""

    def is_explained(name):
        return found[name].lower <= 2.0 * of_check[name].upper + own[name].upper

    return {name: own[name] if is_explained(name) else found[name] for name in MEASURES}


def tolerance_options(tolerance):
    """Options for a tolerance of ranges [m], and ten times as many of the energy, as far as valid."""
    least, least_energy = MINIMUM_TOLERANCES
    return {
        "tolerance": max(least, tolerance),
        "energy_tolerance": max(least_energy, 10.0 * tolerance),
    }


def _tolerances(survey, options):
    """Yields the tolerances of ranges that the survey itself asks for, and a tenth of its noise [m]."""
    if noise := _noise(survey):
        yield 0.1 * noise
    if given := options.get("tolerance"):
        yield given
    with contextlib.suppress(ValueError):
        yield float(survey.vtk.GetScannerAttribute(0, "rangeTolerance_m"))


def _only(errors):
    return {name: errors[name] for name in MEASURES}


def _plain(errors):
    return {name: Estimate(*errors[name]) for name in MEASURES}


def _moves(survey):
    """Returns whether the platform of a leg moves while it scans."""
    for leg in range(len(survey.legs)):
        first, last = survey.leg_pulses(leg)
        if first < last and len(survey.trajectory(leg, 0.0)) > 1:
            return True
    return False


def _noise(survey):
    """Returns the standard deviation of a range of the first scanner [m]."""
    text = survey.vtk.GetScannerAttribute(0, "accuracy_m")
    try:
        return float(text)
    except ValueError:
        return 0.0


class _Steps:
    """Tells the name of the current step, and the fraction of all that is done."""

    def __init__(self, on_step, count):
        self._on_step, self._count = on_step, count
        self._done, self._name = -1, ""

    def begin(self, name):
        self._done, self._name = self._done + 1, name
        self.show(0.0)

    def show(self, _share):
        if self._on_step:
            self._on_step(self._name, min(1.0, max(0, self._done) / self._count))
