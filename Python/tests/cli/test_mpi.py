# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: runs by the ranks of MPI."""

import hashlib
import importlib.util
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

import pytest

import vtkhelios
from vtkhelios.cli._run.ranks import count_started, count_threads

MPI = ["mpiexec", "--oversubscribe", "--bind-to", "none"]
OPTIONS = ["--waveforms", "--pulses", "--seed", "7", "--threads", "1"]
PACKAGE = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
ENVIRONMENT = {
    **os.environ,
    "PYTHONPATH": str(PACKAGE),
    "OMPI_ALLOW_RUN_AS_ROOT": "1",  # in containers
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "PMIX_MCA_gds": "hash",  # needs no shared memory
}

needs_mpi = pytest.mark.skipif(
    not shutil.which("mpiexec") or not importlib.util.find_spec("vtkhelios.vtkHeliosScannerMpi"),
    reason="no MPI",
)


def digests(folder):
    """The SHA-256 of every file of a run; the summary's without its timings."""
    found = {}
    for path in sorted(path for path in folder.iterdir() if path.is_file()):
        data = path.read_bytes()
        if path.name == "run_summary.json":
            summary = json.loads(data)
            del summary["timings"]
            data = json.dumps(summary).encode()
        found[path.name] = hashlib.sha256(data).hexdigest()
    return found


def command(ranks, survey, output, more):
    run = [sys.executable, "-P", "-m", "vtkhelios", "run", survey, "--output", output, *OPTIONS]
    return [*MPI, "-n", str(ranks), *map(str, run), *more]


def run_ranks(ranks, survey, output, *more):
    return subprocess.run(
        command(ranks, survey, output, more),
        env=ENVIRONMENT,
        capture_output=True,
        text=True,
        timeout=300,
    )


@needs_mpi
@pytest.mark.parametrize("kind", ["xyz", "las", "vtp"])
def test_ranks_write_the_files_of_one_process(kind, make_survey, command_line, tmp_path):
    survey, more = make_survey(), ["--format", kind, "--pulses-per-block", "3000"]
    done = command_line("run", survey, "--output", tmp_path / "whole", *OPTIONS, *more)
    assert done.returncode == 0, done
    whole = digests(tmp_path / "whole/plane")
    assert len(whole) > 4
    for ranks in (1, 2, 3, 4):
        done = run_ranks(ranks, survey, tmp_path / f"out{ranks}", *more)
        assert done.returncode == 0, done
        assert digests(tmp_path / f"out{ranks}/plane") == whole
        assert done.stdout.count("survey   ") == 1
        assert ("bytes per pulse" in done.stdout) == (ranks > 1)


def count_blocks(journal):
    return journal.read_bytes().count(b"\n") if journal.exists() else 0


@needs_mpi
def test_a_killed_rank_leaves_a_run_to_resume(make_survey, command_line, tmp_path):
    survey = make_survey(speed=2, stop=30)  # 1.5 M pulse times
    more = ["--pulses-per-block", "5000"]
    process = subprocess.Popen(
        command(3, survey, tmp_path / "out", more),
        env=ENVIRONMENT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    until = time.monotonic() + 120
    journal = tmp_path / "out/plane/run.journal"
    while count_blocks(journal) < 10 and time.monotonic() < until:
        time.sleep(0.01)
    victim = find_rank(process.pid, 2)
    os.kill(victim, signal.SIGKILL)
    _, errors = process.communicate(timeout=120)
    assert process.returncode != 0
    assert "signal 9" in errors, errors  # message of mpiexec
    assert "points so far are kept in" in errors and "--resume continues the run" in errors
    assert journal.exists()
    resumed = run_ranks(2, survey, tmp_path / "out", *more, "--resume")
    assert resumed.returncode == 0, resumed
    done = command_line("run", survey, "--output", tmp_path / "whole", *OPTIONS, *more)
    assert done.returncode == 0, done
    assert digests(tmp_path / "out/plane") == digests(tmp_path / "whole/plane")


def find_rank(parent, rank):
    """The process of a rank, started by an mpiexec."""
    for path in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            status, environment = (path / "status").read_text(), (path / "environ").read_bytes()
        except OSError:
            continue
        is_child = re.search(rf"^PPid:\s{parent}$", status, re.M)
        if is_child and f"OMPI_COMM_WORLD_RANK={rank}\0".encode() in environment:
            return int(path.name)
    raise AssertionError(f"no rank {rank}")


@needs_mpi
def test_errors_end_all_ranks(make_survey, tmp_path):
    survey = make_survey()
    missing = run_ranks(2, tmp_path / "nowhere.xml", tmp_path / "out")
    assert missing.returncode == 1
    assert missing.stderr.count("error: ") == 1 and "nowhere.xml" in missing.stderr, missing
    assert run_ranks(2, survey, tmp_path / "out").returncode == 0
    again = run_ranks(2, survey, tmp_path / "out")
    assert again.returncode == 1 and "holds the files of an earlier run" in again.stderr, again


@needs_mpi
def test_epochs_and_parts(make_survey, command_line, tmp_path):
    survey = make_survey()
    scene = (tmp_path / "scene.xml").read_text()
    swap = '<swap><filter type="translate"><param type="vec3" key="offset" value="0;0;1"/></filter></swap>'
    (tmp_path / "scene.xml").write_text(scene.replace("</part>", f"{swap}</part>"))
    done = command_line("run", survey, "--output", tmp_path / "whole", *OPTIONS)
    assert done.returncode == 0, done
    assert run_ranks(3, survey, tmp_path / "out").returncode == 0
    for part in ("1/2", "2/2"):
        done = run_ranks(2, survey, tmp_path / "parts", "--part", part)
        assert done.returncode == 0, done
    done = command_line("join", tmp_path / "parts/plane")
    assert done.returncode == 0, done
    for epoch in ("epoch000", "epoch001"):
        whole = digests(tmp_path / "whole/plane" / epoch)
        assert digests(tmp_path / "out/plane" / epoch) == whole
        assert digests(tmp_path / "parts/plane" / epoch) == whole


@needs_mpi
def test_estimates_and_wrong_usage(make_survey, tmp_path):
    survey = make_survey()
    done = run_ranks(2, survey, tmp_path / "out", "--dry-run")
    assert done.returncode == 0 and done.stdout.count("estimated from") == 1, done
    assert run_ranks(2, survey, tmp_path / "out", "--check-all").returncode == 2


def test_one_process_does_not_load_mpi():
    code = "import vtkhelios, vtkhelios.cli.run; vtkhelios.__all__; print(open('/proc/self/maps').read())"
    done = subprocess.run(
        [sys.executable, "-P", "-c", code], env=ENVIRONMENT, capture_output=True, text=True
    )
    assert done.returncode == 0, done
    assert "libvtkHeliosScannerRun" in done.stdout and "ScannerMpi" not in done.stdout


def test_number_of_processes():
    assert count_started({}) == 1
    assert count_started({"OMPI_COMM_WORLD_SIZE": "4"}) == 4
    assert count_started({"PMI_SIZE": "3"}) == 3
    assert count_started({"PMIX_RANK": "0", "SLURM_STEP_NUM_TASKS": "5"}) == 5
    assert count_started({"SLURM_STEP_NUM_TASKS": "5"}) == 1  # not of MPI
    assert count_started({"PMI_SIZE": "x"}) == 1


def test_number_of_threads():
    cores = len(os.sched_getaffinity(0))
    assert count_threads({}) == cores
    if cores == os.cpu_count():
        assert count_threads({"OMPI_COMM_WORLD_LOCAL_SIZE": str(cores)}) == 1
        assert count_threads({"MPI_LOCALNRANKS": str(cores + 1)}) == 1


def test_a_build_without_mpi(make_survey, command_line, monkeypatch, tmp_path):
    broken = tmp_path / "sitecustomize.py"  # acts like a missing module
    broken.write_text("import sys\nsys.modules['vtkhelios.vtkHeliosScannerMpi'] = None\n")
    monkeypatch.setenv("OMPI_COMM_WORLD_SIZE", "2")
    environment = {**os.environ, "PYTHONPATH": f"{tmp_path}:{PACKAGE}"}
    done = subprocess.run(
        [sys.executable, "-P", "-m", "vtkhelios", "run", str(make_survey())],
        env=environment,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 1, done
    assert "2 processes were started together, but this vtkHelios has no MPI" in done.stderr
    assert "start one process, or build with VTKHELIOS_ENABLE_MPI" in done.stderr
