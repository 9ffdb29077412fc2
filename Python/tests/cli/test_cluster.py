# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts in Docs/cluster.md, with an srun that runs its command here."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

import vtkhelios

PAGE = pathlib.Path(__file__).parents[3] / "Docs/cluster.md"
SCRIPTS = re.findall(r"```bash\n(#!/bin/bash\n.*?)```", PAGE.read_text(), re.DOTALL)

# Drops its options, and starts as many tasks as given.
SRUN = """\
tasks=1
while [ "${1#--}" != "$1" ]; do
  case $1 in --ntasks=*) tasks=${1#--ntasks=} ;; esac
  shift
done
[ "$tasks" = 1 ] && exec "$@"
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 exec mpiexec --oversubscribe -n "$tasks" "$@"
"""


@pytest.fixture
def run_script(tmp_path):
    """Runs a script in the folder of the survey."""
    programs = tmp_path / "programs"
    programs.mkdir()
    package = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
    command = f'PYTHONPATH="{package}" exec "{sys.executable}" -P -m vtkhelios "$@"'
    for name, text in (("srun", SRUN), ("vtkhelios", command)):
        (programs / name).write_text(f"#!/bin/sh\n{text}\n")
        (programs / name).chmod(0o755)

    def run(script, **variables):
        path = f"{programs}:{os.environ['PATH']}"
        return subprocess.run(
            ["bash", "-eu", "-c", script],
            cwd=tmp_path,
            env={**os.environ, **variables, "PATH": path},
            capture_output=True,
            text=True,
            timeout=300,
        )

    return run


def test_job_array(run_script, make_survey, command_line, tmp_path):
    make_survey()
    (array,) = (script for script in SCRIPTS if "--array" in script)
    for task in ("2", "1", "1"):  # submitted again: nothing is left to do
        done = run_script(
            array, SLURM_ARRAY_TASK_ID=task, SLURM_ARRAY_TASK_COUNT="2", SLURM_CPUS_PER_TASK="1"
        )
        assert done.returncode == 0, done
    assert command_line("join", tmp_path / "output/plane").returncode == 0
    assert (tmp_path / "output/plane/leg000_points.las").stat().st_size > 100_000


@pytest.mark.skipif(
    not shutil.which("mpiexec") or not importlib.util.find_spec("vtkhelios.vtkHeliosScannerMpi"),
    reason="no MPI",
)
def test_ranks(run_script, make_survey, tmp_path):
    make_survey()
    (ranks,) = (script for script in SCRIPTS if "--mpi" in script)
    done = run_script(
        ranks.replace("NAME", "plane"), SLURM_JOB_NUM_NODES="2", SLURM_CPUS_ON_NODE="1"
    )
    assert done.returncode == 0, done
    assert (tmp_path / "output/plane/leg000_points.las").stat().st_size > 100_000
    assert (tmp_path / "output/plane/run_summary.json").exists()
