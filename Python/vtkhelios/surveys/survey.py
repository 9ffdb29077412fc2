# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys: read from a file or of a scene in memory, run in memory, in blocks, or to files.

>>> survey = vtkhelios.read_survey("survey.xml")
>>> cloud = survey.run(progress=True)
"""

import html
import json
import os
import pathlib
import threading
import typing

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .. import _native
from ..clouds.cloud import Cloud
from ..clouds.join import join_clouds, join_tables
from ..cluster._blocks import check_pulses, iterate_blocks, make_delayed, split_windows
from ..cluster._origin import Origin
from ..core.classes import vtk_class
from ..core.paths import from_vtk, text_from_vtk, to_vtk
from ..core.pipeline import SECONDS_BETWEEN_SIGNS, MessageLog, PipelineError, conclude
from ..core.properties import set_properties
from ..core.reading import make_reader, missing_folder
from ..core.views import data_of
from ..core.watching import Progress
from ..core.words import counted
from ..scenes.scene import add_parts
from .inputs import scene_data, trajectory_data
from .items import Leg, Legs, Parts, change
from .options import in_python
from .outputs import in_files, in_memory
from .tradeoff_run import make_tradeoff

if typing.TYPE_CHECKING:  # dictionaries of keywords, made by Python/make_stubs.py
    from .keywords import FileOptions, RunOptions

__all__ = ["Leg", "Survey", "read_survey"]

_OPTIONS = in_python()
# How a run stores the scene, and what it returns besides echoes: properties of vtkHeliosSurveySource.
_OUTPUTS = {"instances": "instances", **in_memory()}


def read_survey(path, assets=(), scene=None, trajectory=None) -> "Survey":
    """Reads a survey (HELIOS XML); raises PipelineError with every error, at file:line.

    scene replaces the survey's: a Scene, a VTK data set with a surface, or an algorithm that
    makes one. trajectory replaces the trajectory files of the platforms, see make_survey(). What is
    replaced is not read, and need not exist.

    Files are searched in the folders of assets, beside the survey, in the working directory, and in
    the data shipped with vtkHelios.
    """
    assets = [assets] if isinstance(assets, (str, os.PathLike)) else assets
    assets = [os.fspath(folder) for folder in assets]
    if problem := missing_folder(assets):
        raise FileNotFoundError(problem.replace("--assets", "assets:"))
    origin = Origin(path, assets, read_survey)
    reader = make_reader(os.fspath(path), assets)
    reader.SetSceneRequired(scene is None)
    reader.SetTrajectoriesRequired(trajectory is None)
    with MessageLog() as log:
        log.watch(reader)
        succeeded = reader.Read()
    conclude(log)
    if not succeeded:
        raise PipelineError([f"{path}: cannot be read"])
    origin.set_survey(reader.GetSurvey())
    survey = Survey(reader.GetSurvey(), os.fspath(path), scene, trajectory)
    survey.origin = origin if scene is None and trajectory is None else None
    return survey


class Survey:
    """A survey that can be run: ``survey.vtk`` is the vtkHeliosSurvey.

    The scene and its ray-tracing tree are built by the first run and reused later.
    """

    def __init__(self, vtk_survey, path=None, scene=None, trajectory=None):
        self.vtk, self.path = vtk_survey, path
        self._input = scene_data(scene)  # in place of the survey's scene
        self._flight = trajectory_data(trajectory)  # in place of files
        self._source = None
        self._lock = threading.RLock()
        self.origin = None  # only a survey that is read from files has one
        self.warn = None  # in place of warnings.warn

    @property
    def name(self) -> str:
        return text_from_vtk(self.vtk.GetName())

    @property
    def legs(self) -> Legs:
        """All legs, including inactive ones: a list that can be changed.

        >>> survey.legs[0].scan_frequency = 50
        >>> survey.legs.append((10, 0), head=(0, 360))
        >>> del survey.legs[2]
        """
        return Legs(self.vtk)

    @property
    def parts(self) -> Parts:
        """The parts of the scene that are not of tables: a list that can be changed.

        >>> motion = {"loop": 0, "motion": {"type": "translation", "vec": (0.1, 0, 0)}}
        >>> survey.parts.append("car.obj", dynTimeStep=0.01, dmotion=motion)
        """
        return Parts(self.vtk)

    @property
    def moving_parts(self) -> dict:
        """The parts of the scene that move, and how: {"car": "along car.csv", "wheel": "continuous, on car"}."""
        return {
            text_from_vtk(self.vtk.GetPartName(part)): text_from_vtk(motion)
            for part in range(self.vtk.GetNumberOfParts())
            if (motion := self.vtk.GetPartMotion(part))
        }

    def write(self, path) -> None:
        """Writes the survey to an XML file, or to YAML by its ending, however it was made.

        It reads back as the same survey with the same asset directories. What it refers to in other
        files stays there, unless it was changed. A scene or trajectory in memory is not written:
        read it with ``read_survey(path, scene=...)``.
        """
        change(self.vtk, "WriteFile", to_vtk(path))

    @property
    def scene(self):
        """The scene as one mesh (vtkPolyData); loads it."""
        return self._load().GetScene()

    @property
    def number_of_pulses(self) -> int:
        """The pulses of all legs; loads the scene."""
        return self._load().GetNumberOfPulses()

    def leg_pulses(self, leg: int) -> tuple:
        """Returns the pulse ids (first, last + 1) of a leg; loads the scene."""
        self._check_leg(leg)
        ids = [0, 0]
        self._load().GetLegPulses(leg, ids)
        return tuple(ids)

    def trajectory(self, leg: int, interval: float = 0.1) -> Cloud:
        """Returns the trajectory of a leg, a sample every interval [s] and at both ends; loads the
        scene.

        A Cloud of the platform's positions with GpsTime [s] and Orientation (quaternion w, x, y,
        z); of a static platform one point.
        """
        if not interval >= 0:
            raise ValueError(f"interval is {interval!r}; give seconds, 0 for both ends only")
        first, last = self.leg_pulses(leg)
        if first == last:
            raise ValueError(f"leg {leg} fires no pulses and has no trajectory of its own")
        return Cloud(_native.trajectory(self._load(), leg, interval))

    def source(self, **options: "typing.Unpack[RunOptions]"):
        """Returns the survey as a source of a pipeline (vtkHeliosSurveySource), with the options of
        run()."""
        source = vtk_class("vtkHeliosSurveySource")(survey=self.vtk)
        for port, data in ((0, self._input), (2, self._flight)):
            if isinstance(data, vtkAlgorithm):
                source.SetInputConnection(port, data.GetOutputPort())
            elif data is not None:
                source.SetInputDataObject(port, data)
        _set_options(source, options)
        return source

    def __rshift__(self, right):
        return self.source() >> right

    def run(self, progress=None, legs=None, **options: "typing.Unpack[RunOptions]") -> Cloud:
        """Runs the survey in memory and returns its echoes as a Cloud.

        progress
            True for a line on standard error, or a function of the fraction done (0 to 1).
            Exceptions of the function end the run, and so does Ctrl-C.
        legs
            the index of a leg, or several; None: all.
        waveforms, pulses, hits, truth, scan_flags, columns, decibels, colors
            True: also returned, as ``cloud.waveforms`` (vtkTable), ``cloud.pulses``,
            ``cloud.sub_rays``, as the arrays TruePoint and Normal, ScanDirectionFlag and
            EdgeOfFlightLine, as the array ColumnIds, of spinning optics: the column of a
            pulse in its revolution, from 0, as the arrays RelativeAmplitude, above the detection
            threshold, and Reflectance, above a white diffuse plane [dB], and
            as the array RGB, in [0, 1], the colour of the surface: Kd and map_Kd of OBJ files.
        seed
            the key of all random numbers: the survey's, else 0.
        noise
            False: exact ranges.
        tolerance, energy_tolerance
            of adaptive beam sampling: 95th percentile of the range error [m], and
            RMS of the amplitude error (fraction of a full footprint), also the
            fraction of missed and invented echoes: the survey's, else 0.001 and 0.01.
        accuracy
            "instrument": tolerances that are not given are a tenth of the noise of each scanner.
        max_sub_rays
            the most sub-rays of a beam with too many surfaces for visible areas, 1024 to 2^24: a
            limit of its time. ``pulsesUnresolved`` counts the pulses that need more. Default: 65536.
        sub_rays, sub_ray_pattern
            a fixed number instead; its pattern, "Circles" (1, 7, 19 ...), "GaussLegendre" (4, 16,
            36 ...) or "Vogel" (any multiple of 4). Default: circles if they have that number, else
            Vogel.
        scattering_orders, scattering_paths
            the most scatterings of light on its way back, 1 to 64, and the paths that are drawn of each pulse, 8 to
            65536: the survey's, else 1 and 128. With two or more echoes have ScatteredAmplitude [W], what of
            their Amplitude was scattered more than once, and its standard error ScatteredDeviation.
        detector
            "peak", "gaussian", "cfd", "leadingEdge" or "photonCounting".
        ray_caster
            by name: "beam", "embree", "bvh" ...
        weather
            "fog 0.2": fog, smoke or dust and the visibility [km], or rain, snow or sleet [mm/h]:
            light is lost and scattered back. Default: the survey's, else none.
        gps_start
            when the survey starts, "2026-07-01 12:00:00" of UTC, with a zone, Unix seconds or
            "gps:1467000000": the cloud then has the field array GpsEpoch. Default: the survey's
            gpsStartTime, else not known.
        epoch
            the epoch, of a survey whose scene swaps parts.
        bin_size
            of waveforms [ns].
        without
            parts of the model that are left out: "divergence", "waveform", "specular", "spectra",
            "atmosphere", "voxels", "motion", "attitude", "scattering" or "partMotion" (see
            vtkHeliosRunOptions), or several, separated by blanks.
        mesh
            that beams hit in place of the scene, which the legs are still planned on: a
            vtkPolyData made of ``survey.scene``, with fewer triangles or without some parts.
        pulse_step
            a sample: every n-th pulse.
        instances
            True: meshes that several parts have are stored once, height rasters stay rasters, and
            ``survey.scene`` is a vtkHeliosScene. Default: False.

        Raises PipelineError with the message of any filter.
        """
        with Progress(progress) as watched:
            clouds = []
            windows = self._windows(legs)
            for number, window in enumerate(windows):
                watched.begin, watched.end = number / len(windows), (number + 1) / len(windows)
                clouds.append(self._run_window(options, window, watched))
        return clouds[0] if len(clouds) == 1 else _join(clouds)

    def blocks(
        self,
        pulses: int = 1_000_000,
        progress=None,
        legs=None,
        client=None,
        **options: "typing.Unpack[RunOptions]",
    ) -> typing.Iterator[Cloud]:
        """The echoes as Clouds of this many pulses each, one after the other: memory holds one.

        Options: see run(); the blocks in order are what it returns. With a client
        (distributed.Client), its workers compute them, in advance: see Docs/cluster.md.
        """
        step = check_pulses(pulses)
        if client is not None:
            check_options(options)
            yield from iterate_blocks(self, client, step, progress, legs, options)
            return
        windows, total = self.pulse_windows(options, legs)
        with Progress(progress) as watched:
            for begin, end in split_windows(windows, step):
                watched.begin, watched.end = begin / total, end / total
                yield self._run_window(options, (begin, end), watched)

    def to_delayed(
        self, pulses: int = 1_000_000, legs=None, **options: "typing.Unpack[RunOptions]"
    ) -> list:
        """Returns the blocks of blocks() as a list of dask.delayed Clouds: see Docs/cluster.md."""
        check_options(options)
        return make_delayed(self, pulses, legs, options)

    def run_to(
        self, folder, format="xyz", progress=None, **options: "typing.Unpack[FileOptions]"
    ) -> dict:
        """Runs the survey and writes a folder with the survey's name below that folder; returns a
        report.

        format is "xyz", "las", "laz", "copc" or "vtp". The options equal run()'s except for legs, with the same
        outputs: hits are always VTK XML, colors need the format las or vtp, truth and columns
        vtp; instances is True by default, like in vtkhelios run. Of files only:

        waveforms_in_points, split_by_channel
            as --waveforms-in-points and --split-by-channel of vtkhelios run.
        overwrite, resume, bytes_to_check, pulses_per_block
            as in vtkHeliosSurveyPlayer.

        Memory holds a block of pulses at a time. The report (a dictionary) equals run_summary.json,
        and has the "folder".
        """
        known = {**in_files(), **{name: name for name in _FILES}}
        known_here = {**_OPTIONS, **known, "instances": "", MESH: ""}
        _translate(options, known_here)  # refuses any other
        options.setdefault("instances", True)
        written = {name: options.pop(name) for name in list(options) if name in known}
        player = vtk_class("vtkHeliosSurveyPlayer")(source=self.source(**options), format=format)
        player.SetOutputDirectory(to_vtk(folder))
        set_properties(player, _translate(written, known))
        with MessageLog() as log, Progress(progress) as watched:
            log.watch(player)
            succeeded, _ = _native.run(player, 0, [player], watched.callback, SECONDS_BETWEEN_SIGNS)
        conclude(log)
        if not succeeded:
            raise PipelineError([from_vtk(player.GetMessage())])
        report = json.loads(from_vtk(player.GetReport()))
        return {**report, "folder": pathlib.Path(from_vtk(player.GetRunFolder()))}

    def tradeoff(
        self,
        pulses=2000,
        parts=True,
        progress=None,
        seconds=None,
        **options: "typing.Unpack[RunOptions]",
    ):
        """Measures the cost of accuracy on this survey, and which parts of the model it requires.

        Runs a sample of its pulses (this many with an echo, of all legs) with fixed sub-rays in several patterns,
        tolerances, bins, detectors, ray casters and simplified meshes, and compares the echoes with a reference,
        adaptive at a tenth of the tolerances, whose own error is known; with parts, also without each part of the
        model and of the scene. Without noise and turbid voxels. ``seconds`` is the processor time, by default three
        times that of the run, at least 10: what does not fit is in ``absent``. Options are those of run(). Returns
        a vtkhelios.tradeoff.Tradeoff; see Docs/tradeoff.md.
        """
        if not (isinstance(pulses, int) and pulses >= 10):
            raise ValueError(f"pulses is {pulses!r}; give a whole number of 10 or more")
        check_options(options)
        with Progress(progress) as watched:
            tell = watched.callback or (lambda *_: None)
            return make_tradeoff(self, pulses, parts, tell, seconds, **options)

    def add_parts(self, table, models=None, seed=0, yaw=(0, 0), scale=(1, 1)):
        """Adds a part per row of a table to the scene; see vtkhelios.scene.add_parts()."""
        if self._input is not None:
            raise ValueError("the scene of this survey is an input; add parts to a survey without")
        with self._lock, MessageLog() as log:
            log.watch(self.vtk)
            succeeded = add_parts(self.vtk, table, models or {}, seed, yaw, scale)
        conclude(log)
        if not succeeded:
            raise PipelineError(["the parts cannot be added, for a reason that was not reported"])

    def source_of(self, options):
        """Returns the loaded source that run() uses, with these options."""
        return self._load(options)

    def run_window(self, options, window, progress=None):
        """Returns the echoes of a window of pulse ids, as a Cloud."""
        with Progress(progress) as watched:
            return self._run_window(options, window, watched)

    def _prepare(self, options):
        """Returns the cached source, with the options, and defaults for all others."""
        if self._source is None:
            self._source = self.source()
        _set_options(self._source, options)
        return self._source

    def _load(self, options=None):
        """Returns the source, loaded, with the options, or with its current ones."""
        with self._lock:
            keeps = options is None and self._source is not None
            source = self._source if keeps else self._prepare(options or {})
            self._run_source(source, LOAD, None)  # only what has changed
            return source

    def _check_leg(self, leg):
        count = self.vtk.GetNumberOfLegs()
        if not (isinstance(leg, int) and 0 <= leg < count):
            raise ValueError(f"there is no leg {leg!r}; legs are 0 to {count - 1}")

    def pulse_windows(self, options, legs=None):
        """Returns the ranges of pulse ids of legs, and the pulses of all legs; loads the scene."""
        total = self._load(options).GetNumberOfPulses()
        return [(first, min(last, total)) for first, last in self._windows(legs)], total

    def _windows(self, legs):
        """Returns the ranges of pulse ids of legs; consecutive ones are merged."""
        if legs is None:
            return [(0, _ALL)]
        windows = []
        for leg in [legs] if isinstance(legs, int) else sorted(set(legs)):
            first, last = self.leg_pulses(leg)
            if first == last:
                raise ValueError(f"leg {leg} fires no pulses; leave it out of legs")
            if windows and windows[-1][1] == first:
                windows[-1] = (windows[-1][0], last)
            else:
                windows.append((first, last))
        if not windows:
            raise ValueError("legs is empty; give the index of a leg, or None for all")
        return windows

    def _run_window(self, options, window, progress):
        with self._lock:  # threads running the same survey take turns
            source = self._prepare(options)
            source.SetPulseWindow(*window)
            self._run_source(source, 0, progress.callback)
            return _take(source)

    def _run_source(self, source, what, callback):
        with MessageLog() as log:
            log.watch(source)
            log.watch(source.GetExecutive())
            succeeded, _ = _native.run(source, what, [source], callback, SECONDS_BETWEEN_SIGNS)
        try:
            conclude(log, stacklevel=5, warn=self.warn)
            if not succeeded:
                raise PipelineError(
                    ["the survey cannot be run, for a reason that was not reported"]
                )
        except PipelineError:
            _set_options(source, {})  # an option may be the cause, and is not kept
            raise

    def __repr__(self):
        legs = self.legs
        active = sum(leg.active for leg in legs)
        scanner, platform, scene = map(
            text_from_vtk,
            (self.vtk.GetScannerName(), self.vtk.GetPlatformName(), self.vtk.GetSceneName()),
        )
        return (
            f"Survey({self.name!r}: {scanner} on {platform}, "
            f"{counted(len(legs), 'leg')}, {active} active, scene {scene!r})"
        )

    def _repr_html_(self):
        head = "<tr><th>leg</th><th>x, y, z [m]</th><th>pulses/s</th><th>lines/s</th></tr>"
        rows = [
            f"<tr><td>{leg.index}</td><td>{', '.join(f'{x:g}' for x in leg.position)}"
            f"{' on the ground' if leg.on_ground else ''}</td>"
            + (
                f"<td>{leg.pulse_frequency:,.0f}</td><td>{leg.scan_frequency:g}</td></tr>"
                if leg.active
                else "<td colspan=2>not active</td></tr>"
            )
            for leg in self.legs
        ]
        return f"{html.escape(repr(self))}<table>{head}{''.join(rows)}</table>"


LOAD = -1  # for _native.run(): only load a survey
MESH, _MESH_PORT = "mesh", 3  # the option, and its input of vtkHeliosSurveySource
_ALL = 2**62


def check_options(options, wrong="no option"):
    """Raises TypeError for an option unknown to Survey.run()."""
    _translate(options, {**_OPTIONS, **_OUTPUTS, MESH: "", "progress": "", "legs": ""}, wrong)


# Options of run_to() that are properties of vtkHeliosSurveyPlayer, of the same names.
_FILES = ("overwrite", "resume", "bytes_to_check", "pulses_per_block")


def _set_options(source, options):
    """Sets the options of a source; those not given have their defaults."""
    values = _translate(options, {**_OPTIONS, **_OUTPUTS, MESH: MESH})
    mesh = data_of(values.pop(MESH, None))
    if source.GetInputDataObject(_MESH_PORT, 0) is not mesh:
        source.SetInputDataObject(_MESH_PORT, mesh)
    outputs = {name: values.pop(name, False) for name in _OUTPUTS.values()}
    set_properties(source, {"options": vtk_class("vtkHeliosRunOptions")(**values), **outputs})


def _translate(options, known, wrong="no option"):
    """Options as properties; raises TypeError for an unknown one."""
    for name in options:
        if name not in known:
            raise TypeError(f"{name} is {wrong}; options are: {', '.join(known)}")
    given = {name: value for name, value in options.items() if value is not None}
    if given.get("sub_rays") and (given.get("tolerance") or given.get("energy_tolerance")):
        raise ValueError(
            "sub_rays is a fixed number, and a tolerance makes the number adaptive: give one of "
            "them"
        )
    return {known[name]: value for name, value in given.items()}


def _take(source):
    """Returns the outputs of a source as a Cloud; the source releases them."""
    taken = []
    for port in range(source.GetNumberOfOutputPorts()):
        output = source.GetOutputDataObject(port)
        copy = vtkTable() if output.IsA("vtkTable") else vtkPolyData()
        copy.ShallowCopy(output)
        output.ReleaseData()
        taken.append(copy)
    return Cloud(
        taken[0],
        taken[1] if source.GetGenerateWaveforms() else None,
        Cloud(taken[2]) if source.GetGeneratePulses() else None,
        Cloud(taken[3]) if source.GetGenerateSubRays() else None,
    )


def _join(clouds):
    """Merges clouds of non-consecutive legs."""
    joined = join_clouds(clouds)
    if clouds[0].waveforms is not None:
        joined.waveforms = join_tables([cloud.waveforms for cloud in clouds])
    for name in ("pulses", "sub_rays"):
        if getattr(clouds[0], name) is not None:
            setattr(joined, name, join_clouds([getattr(cloud, name) for cloud in clouds]))
    return joined
