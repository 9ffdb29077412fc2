# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A simulation that runs in a thread, with the names of pyhelios.Simulation."""

import os
import pathlib
import re
import time
import warnings

from vtkmodules.vtkCommonCore import vtkSMPTools

from ...array_names import GPS_TIME
from ...cluster._blocks import split_windows
from ...surveys.items import change
from ._changes import check_survey, find_part, move_part, remove_noise, rotate_part, scale_part
from ._coordinates import find_rotations
from ._errors import not_covered
from ._files import write_files
from ._logging import say_step, say_warning
from ._output import make_output
from ._reading import copy, read
from ._survey import Leg, Platform, Scanner, ScanningStrip
from ._templates import Templates
from ._worker import Worker

BLOCK = 100_000  # pulses that are computed at a time, at least

# Values of a simulation, and their defaults. Those after finalOutput have no effect: they are
# about the speed of HELIOS++.
OPTIONS = {
    "numThreads": 0,
    "lasOutput": False,
    "las10": False,
    "zipOutput": False,
    "splitByChannel": False,
    "fixedGpsTimeStart": "",
    "legacyEnergyModel": False,
    "exportToFile": True,
    "callbackFrequency": 0,
    "finalOutput": True,
    "lasScale": 0.0001,
    "kdtFactory": 4,
    "kdtJobs": 0,
    "kdtSAHLossNodes": 32,
    "parallelizationStrategy": 1,
    "chunkSize": 32,
    "warehouseFactor": 4,
}
_SPELLINGS = {"simulationFrequency": "callbackFrequency", "simFrequency": "callbackFrequency"}
_seed = ""


def setDefaultRandomnessGeneratorSeed(seed):
    """Sets the seed of simulations that are loaded from now on: an integer, or a date, as text."""
    global _seed
    _seed = str(seed)


def _to_camel(name):
    """Returns a name of version 2.1 in the form of version 1."""
    camel = re.sub(r"_(\w)", lambda found: found[1].upper(), name)
    return _SPELLINGS.get(camel, camel)


class Simulation:
    """A survey that runs in a thread; the names of OPTIONS are attributes.

    Raises PipelineError with the errors of the survey, at file:line.
    """

    def __init__(
        self,
        surveyPath="",
        assetsPath=(),
        outputPath="output/",
        numThreads=0,
        lasOutput=False,
        las10=False,
        zipOutput=False,
        splitByChannel=False,
        *speed,
        **more,
    ):
        assets = [assetsPath] if isinstance(assetsPath, (str, os.PathLike)) else list(assetsPath)
        set_here = object.__setattr__
        set_here(self, "_options", dict(OPTIONS))
        set_here(self, "_paths", (surveyPath, assets, outputPath))
        set_here(self, "_filters", [])
        set_here(self, "_state", Worker())
        given = dict(numThreads=numThreads, lasOutput=lasOutput, las10=las10)
        given.update(zipOutput=zipOutput, splitByChannel=splitByChannel)
        given.update(zip(list(OPTIONS)[11:], speed))
        for name, value in {**given, **more}.items():
            setattr(self, name, value)

    def __getattr__(self, name):
        camel = _to_camel(name)
        if name.startswith("_") or camel not in self._options:
            raise not_covered("Simulation", name)
        return self._options[camel]

    def __setattr__(self, name, value):
        camel = _to_camel(name)
        if camel not in self._options:
            raise not_covered("Simulation", name)
        self._options[camel] = value

    # The survey.

    def getSurveyPath(self):
        return os.fspath(self._paths[0])

    def getAssetsPath(self):
        return [os.fspath(folder) for folder in self._paths[1]]

    survey_path, assets_path = property(getSurveyPath), property(getAssetsPath)

    def addRotateFilter(self, q0, q1, q2, q3, partId):
        """Rotates a part, after its own rotations, by the quaternion q0 + q1 i + q2 j + q3 k."""
        self._filters.append((rotate_part, partId, find_rotations(q0, q1, q2, q3)))

    def addScaleFilter(self, scaleFactor, partId):
        """Scales a part, in place of its own scale."""
        self._filters.append((scale_part, partId, scaleFactor))

    def addTranslateFilter(self, x, y, z, partId):
        """Moves a part [m], in place of its own translation."""
        self._filters.append((move_part, partId, (x, y, z)))

    add_rotate_filter, add_scale_filter = addRotateFilter, addScaleFilter
    add_translate_filter = addTranslateFilter

    def loadSurvey(
        self,
        legNoiseDisabled=False,
        rebuildScene=False,
        writeWaveform=False,
        calcEchowidth=False,
        fullWaveNoise=False,
        platformNoiseDisabled=False,
        writePulse=False,
    ):
        """Reads the survey; rebuildScene and calcEchowidth have no effect: widths always are output."""
        self._check_options(fullWaveNoise)
        path, assets = self._paths[0], self._folders()
        with warnings.catch_warnings(record=True) as found:
            survey = read(path, assets)
        for each in found:
            say_warning(each.message)
        survey.warn = say_warning
        if _seed:
            change(survey.vtk, "SetSurveyAttribute", "seed", _seed)
        if self.fixedGpsTimeStart:
            start = str(self.fixedGpsTimeStart)
            change(survey.vtk, "SetSurveyAttribute", "gpsStartTime", start)
        if legNoiseDisabled:
            change(survey.vtk, "SetSurveyAttribute", "legRandomOffset", "")
        if platformNoiseDisabled:
            remove_noise(survey.vtk)
        for apply, part, value in self._filters:
            apply(survey.vtk, find_part(survey.vtk, part), value)
        outputs = {"waveforms": bool(writeWaveform), "pulses": bool(writePulse)}
        self._load(survey, outputs, Templates(path))

    load_survey = loadSurvey

    def _folders(self):
        return [each for each in self._paths[1] if pathlib.Path(each).is_dir()]

    def _load(self, survey, outputs, templates):
        beside = pathlib.Path(self._paths[0]).resolve().parent
        self._state.load(survey, outputs, templates, [*self._folders(), beside, pathlib.Path.cwd()])

    def copy(self):
        """Returns a simulation that was not started, with the same survey as it is now."""
        self.getSurvey()  # raises unless it is loaded
        state, made = self._state, Simulation(*self._paths)
        made._options.update(self._options)
        made._filters.extend(self._filters)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # they were printed when it was read
            survey = copy(state.survey, self._folders())
        made._load(survey, dict(state.outputs), state.templates)
        made._state.callback = state.callback
        return made

    def _check_options(self, waveform_noise):
        refused = {
            "setZipOutput": self.zipOutput and not self.lasOutput,
            "setLegacyEnergyModel": self.legacyEnergyModel,
            "setFullwaveNoise": waveform_noise,
        }
        for name in filter(refused.get, refused):
            raise not_covered("SimulationBuilder", name)

    def getSurvey(self):
        return self._state.view

    def getScene(self):
        return self._state.scene

    def getScanner(self):
        return Scanner(self._state.vtk)

    def getPlatform(self):
        return Platform(self._state.vtk)

    def getNumLegs(self):
        return self._state.vtk.GetNumberOfLegs()

    survey, scene, scanner = property(getSurvey), property(getScene), property(getScanner)
    platform, num_legs = property(getPlatform), property(getNumLegs)

    def getLeg(self, index):
        if not 0 <= index < self.getNumLegs():
            raise IndexError(f"there is no leg {index}; there are {self.getNumLegs()}")
        return Leg(self._state.vtk, index, self._state.templates)

    def newLeg(self, index):
        """Adds a leg at the end; index is the number of legs."""
        if index != self.getNumLegs():
            raise IndexError(
                f"newLeg({index}): legs are added at the end; give {self.getNumLegs()}"
            )
        return Leg(self._state.vtk, change(self._state.vtk, "AddLeg"), self._state.templates)

    def removeLeg(self, index):
        self.getLeg(index)
        self._state.vtk.RemoveLeg(index)
        self._state.templates.remove_leg(index)

    def newScanningStrip(self, stripId):
        return ScanningStrip(stripId)

    def assocLegWithScanningStrip(self, leg, strip):
        leg.strip = strip

    get_leg, new_leg, remove_leg = getLeg, newLeg, removeLeg
    new_scanning_strip = newScanningStrip
    assoc_leg_with_scanning_strip = assocLegWithScanningStrip

    # The run.

    def setCallback(self, callback):
        """A function of an Output with the measurements since the last call, or None."""
        self._state.callback = callback

    def clearCallback(self):
        self._state.callback = None

    callback, clear_callback = setCallback, clearCallback

    def start(self):
        """Starts the thread."""
        check_survey(self._state.vtk)
        vtkSMPTools.Initialize(int(self.numThreads))
        self._state.start(self._run)

    def pause(self):
        self._state.pause()

    def resume(self):
        self._state.resume()

    def stop(self):
        """Ends the run soon; there are no files then."""
        self._state.stop()

    def join(self):
        """Waits for the end, and returns the Output. Raises the error of the run or of the callback."""
        return self._state.join()

    def isStarted(self):
        return self._state.started

    def isPaused(self):
        return self._state.paused

    def isStopped(self):
        return self._state.stopped

    def isFinished(self):
        return self._state.finished

    def isRunning(self):
        state = self._state
        return state.started and not (state.paused or state.stopped or state.finished)

    is_started, is_paused, is_stopped = property(isStarted), property(isPaused), property(isStopped)
    is_finished, is_running = property(isFinished), property(isRunning)

    def _run(self, state):
        """Computes the output, calls the callback and writes the files; returns the Output."""
        begin = time.perf_counter()
        calls = state.callback is not None and self.callbackFrequency > 0
        blocks, paths = [], _read_trajectories(state.survey)
        if calls or self.finalOutput or not self.exportToFile:
            size = max(BLOCK, int(self.callbackFrequency))
            for block in _compute_blocks(state, size):
                state.check()
                if calls:
                    state.callback(make_output([block], _cut(paths, block), [], False))
                if self.finalOutput:
                    blocks.append(block)
        files = self._write(state) if self.exportToFile else []
        say_step(
            f"simulation of {time.perf_counter() - begin:.3f} s, files: {', '.join(files) or 'none'}"
        )
        return make_output(blocks, paths if self.finalOutput else [], files, True)

    def _write(self, state):
        kind = ("laz" if self.zipOutput else "las") if self.lasOutput else "xyz"
        options = {**state.outputs, "split_by_channel": bool(self.splitByChannel)}
        version = "1.0" if self.las10 else "1.4"
        return write_files(
            state.survey, self._paths[2], kind, version, progress=state.check, **options
        )


def _compute_blocks(state, size):
    """Yields the echoes of this many pulses each, as Clouds with the pulses."""
    options = {"pulses": True}
    windows, _ = state.survey.pulse_windows(options)
    for window in split_windows(windows, size):
        yield state.survey.run_window(options, window, state.check)


def _read_trajectories(survey):
    """Returns the trajectories of all legs that fire pulses (Clouds), as their files have them."""
    found = []
    for leg in survey.legs:
        first, last = survey.leg_pulses(leg.index)
        if first < last:
            interval = survey.vtk.GetLegAttribute(leg.index, "trajectoryTimeInterval_s")
            found.append(survey.trajectory(leg.index, float(interval or 0)))
    return found


def _cut(paths, block):
    """Returns the samples of trajectories in the time of the pulses of a block."""
    times = block.pulses[GPS_TIME]
    if not len(times):
        return []
    return [path[(path[GPS_TIME] >= times[0]) & (path[GPS_TIME] <= times[-1])] for path in paths]
