# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""SimulationBuilder, and the SimulationBuild that it makes."""

import datetime
import math
import threading
import time

from ._errors import PyHeliosToolsException, not_covered
from ._logging import say_step, say_warning
from ._simulation import OPTIONS, Simulation

# Scripts hold it in their callbacks; join() does not need it.
PYHELIOS_SIMULATION_BUILD_CONDITION_VARIABLE = threading.Condition()

# Setters of a value of Simulation, and the type of the value.
_OPTIONS = {
    "setNumThreads": ("numThreads", int),
    "setLasOutput": ("lasOutput", bool),
    "setLas10": ("las10", bool),
    "setZipOutput": ("zipOutput", bool),
    "setSplitByChannel": ("splitByChannel", bool),
    "setKDTFactory": ("kdtFactory", int),
    "setKDTJobs": ("kdtJobs", int),
    "setKDTSAHLossNodes": ("kdtSAHLossNodes", int),
    "setParallelizationStrategy": ("parallelizationStrategy", int),
    "setChunkSize": ("chunkSize", int),
    "setWarehouseFactor": ("warehouseFactor", int),
    "setCallbackFrequency": ("callbackFrequency", int),
    "setSimFrequency": ("callbackFrequency", int),
    "setFinalOutput": ("finalOutput", bool),
    "setLegacyEnergyModel": ("legacyEnergyModel", bool),
    "setExportToFile": ("exportToFile", bool),
    "setLasScale": ("lasScale", float),
}
# Setters of an argument of loadSurvey(), and its default.
_LOADING = {
    "setLegNoiseDisabled": ("legNoiseDisabled", True),
    "setRebuildScene": ("rebuildScene", False),
    "setWriteWaveform": ("writeWaveform", False),
    "setWritePulse": ("writePulse", False),
    "setCalcEchowidth": ("calcEchowidth", False),
    "setFullwaveNoise": ("fullWaveNoise", False),
    "setPlatformNoiseDisabled": ("platformNoiseDisabled", True),
}
_FILTERS = ("addRotateFilter", "addScaleFilter", "addTranslateFilter")


class SimulationBuilder:
    """Makes a SimulationBuild.

    surveyPath
        the survey file.
    assetsDir
        a folder to search, or several.
    outputDir
        where the files go: <outputDir>/<name of the survey>/<date>.

    Setters have the names of pyhelios: setNumThreads(0: all cores), setLasOutput, setZipOutput (LAZ),
    setSplitByChannel, setFinalOutput (whether join() returns measurements), setExportToFile (whether
    files are written), setCallback, setCallbackFrequency (0: no calls), setWriteWaveform, setWritePulse,
    setLegNoiseDisabled (default True), setPlatformNoiseDisabled (default True), setRebuildScene,
    setCalcEchowidth; options of KD trees and chunks have no effect.
    """

    def __init__(self, surveyPath, assetsDir=(), outputDir="output/"):
        self.surveyPath, self.assetsDir, self.outputDir = surveyPath, assetsDir, outputDir
        self.makeDefault()

    def makeDefault(self):
        """Sets the defaults."""
        self._options = dict(OPTIONS)
        self._loading = dict(_LOADING.values())
        self._callback, self._filters = None, []

    def __getattr__(self, name):
        if name in _OPTIONS:
            option, kind = _OPTIONS[name]
            return lambda value: self._options.update({option: _check(name, kind, value)})
        if name in _LOADING:
            option, _ = _LOADING[name]
            return lambda value: self._loading.update({option: _check(name, bool, value)})
        if name in _FILTERS:
            return lambda *arguments: self._filters.append((name, arguments))
        raise not_covered("SimulationBuilder", name)

    def setSurveyPath(self, surveyPath):
        self.surveyPath = surveyPath

    def setAssetsDir(self, assetsDir):
        self.assetsDir = assetsDir

    def setOutputDir(self, outputDir):
        self.outputDir = outputDir

    def setCallback(self, callback):
        """A function of an Output, or an object that can be called, or None."""
        if callback is not None and not callable(callback):
            raise PyHeliosToolsException(
                f"setCallback({callback!r}): expected a function of the output, or None"
            )
        self._callback = callback

    def setFixedGpsTimeStart(self, start):
        """Sets when the survey starts, of which LAS files have the GPS times."""
        if start and not str(start).isdigit():
            try:
                datetime.datetime.strptime(start, "%Y-%m-%d %H:%M:%S")
            except ValueError:
                raise PyHeliosToolsException(
                    f"setFixedGpsTimeStart({start!r}): expected a POSIX time or YYYY-MM-DD hh:mm:ss"
                ) from None
        if start:
            say_warning(
                "setFixedGpsTimeStart: GPS times count from the start of the survey; LAS files have it"
            )
        self._options["fixedGpsTimeStart"] = start

    def build(self):
        """Reads the survey; returns a SimulationBuild."""
        begin = time.perf_counter()
        simulation = Simulation(self.surveyPath, self.assetsDir, self.outputDir, **self._options)
        simulation.setCallback(self._callback)
        for name, arguments in self._filters:
            getattr(simulation, name)(*arguments)
        simulation.loadSurvey(**self._loading)
        say_step(f"built in {time.perf_counter() - begin:.3f} s")
        return SimulationBuild(simulation)


def _check(name, kind, value):
    """Returns the value of a setter; raises PyHeliosToolsException if it is not valid."""
    valid = isinstance(value, bool) == (kind is bool) and isinstance(value, (int, float))
    if kind is float and valid and 0 < value < math.inf:
        return float(value)
    if not valid or not (0 <= value < math.inf and value == int(value)):
        expected = {bool: "True or False", float: "a number above 0"}
        expected = expected.get(kind, "a whole number, 0 or more")
        raise PyHeliosToolsException(f"{name}({value!r}): expected {expected}")
    return kind(value)


class SimulationBuild:
    """A simulation that can be started; ``sim`` is the Simulation."""

    def __init__(self, sim):
        self.sim = sim

    def copy(self):
        """Returns another build that was not started, with the same survey as it is now."""
        return SimulationBuild(self.sim.copy())

    def __getattr__(self, name):
        if name not in _CONTROLS:
            raise not_covered("SimulationBuild", name)
        return getattr(self.sim, name)


_CONTROLS = (
    "start", "pause", "stop", "resume", "join", "isStarted", "isPaused", "isStopped", "isFinished",
    "isRunning", "getScanner",
)  # fmt: skip
