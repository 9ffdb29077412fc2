# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs scripts written for pyhelios, the Python interface of HELIOS++ 1 and 2.

>>> from vtkhelios.compat import pyhelios
>>> builder = pyhelios.SimulationBuilder("survey.xml", "assets/", "output/")
>>> simulation = builder.build()
>>> simulation.start()
>>> measurements, trajectories = pyhelios.outputToNumpy(simulation.join())

Names are accepted as in version 1 and 2.0 (movePerSec) and as in 2.1 (speed_m_s). Docs/from-helios.md
lists what is covered. Anything else raises NotCoveredError, which names it and what to use instead.
"""

from ... import vtkHeliosFiltersCore as _core
from ._build import PYHELIOS_SIMULATION_BUILD_CONDITION_VARIABLE, SimulationBuild, SimulationBuilder
from ._coordinates import cartesianToSpherical, sphericalToCartesian
from ._errors import NotCoveredError, PyHeliosToolsException, not_covered

from ._logging import (
    loggingDefault, loggingQuiet, loggingSilent, loggingTime, loggingVerbose, loggingVerbose2,
)  # fmt: skip
from ._output import Measurement, Output, Trajectory, outputToList, outputToNumpy
from ._simulation import Simulation, setDefaultRandomnessGeneratorSeed

# The names of version 2.1.
logging_default, logging_quiet, logging_silent = loggingDefault, loggingQuiet, loggingSilent
logging_time, logging_verbose, logging_verbose2 = loggingTime, loggingVerbose, loggingVerbose2
default_rand_generator_seed = setDefaultRandomnessGeneratorSeed

__version__ = _core.vtkHeliosVersion.GetVersion()

__all__ = [
    "PYHELIOS_SIMULATION_BUILD_CONDITION_VARIABLE", "Measurement", "NotCoveredError", "Output",
    "PyHeliosToolsException", "Simulation", "SimulationBuild", "SimulationBuilder", "Trajectory",
    "cartesianToSpherical", "default_rand_generator_seed", "getVersion", "loggingDefault",
    "loggingQuiet", "loggingSilent", "loggingTime", "loggingVerbose", "loggingVerbose2",
    "logging_default", "logging_quiet", "logging_silent", "logging_time", "logging_verbose",
    "logging_verbose2", "outputToList", "outputToNumpy", "setDefaultRandomnessGeneratorSeed",
    "sphericalToCartesian",
]  # fmt: skip


def getVersion():
    """Returns the version of vtkHelios, as a text."""
    return f"vtkHelios {__version__}"


def __getattr__(name):
    raise not_covered("pyhelios", name)
