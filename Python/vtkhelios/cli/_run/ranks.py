# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ranks of MPI: processes that mpiexec or srun started together."""

import os

_SIZES = ("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE")
_LOCAL_SIZES = ("OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "MV2_COMM_WORLD_LOCAL_SIZE")


class NoMpi(RuntimeError):
    """Several processes were started together, but this build has no MPI."""


def _read(environment, names):
    texts = (environment.get(name, "") for name in names)
    return next((int(text) for text in texts if text.isdecimal()), 1)


def count_started(environment=os.environ):
    """How many processes were started together; 1: this one only, or not by MPI."""
    if "PMIX_RANK" in environment:  # srun
        return _read(environment, (*_SIZES, "SLURM_STEP_NUM_TASKS"))
    return _read(environment, _SIZES)


def count_threads(environment=os.environ):
    """Returns the processor cores of this process; an equal share if all cores of the node are
    allowed."""
    cores = len(os.sched_getaffinity(0))
    local = _read(environment, _LOCAL_SIZES)
    return max(1, cores // local) if cores == os.cpu_count() else cores


def start_ranks():
    """Returns the ranks that share a run, with MPI started; None: there is only this process."""
    if count_started() < 2:
        return None
    try:
        from ...vtkHeliosScannerMpi import vtkHeliosMPIRanks
    except ImportError as error:
        raise NoMpi(
            f"{count_started()} processes were started together, but this vtkHelios has no MPI "
            f"({error}): start one process, or build with VTKHELIOS_ENABLE_MPI"
        ) from None
    ranks = vtkHeliosMPIRanks()
    ranks.Initialize()
    return ranks
