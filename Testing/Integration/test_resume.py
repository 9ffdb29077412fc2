# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed, out of resources or lose their folder, and resume."""

import hashlib
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time

import pytest

import vtkhelios

PACKAGE_DIR = pathlib.Path(vtkhelios.__file__).absolute().parents[1]

SURVEY = """\
<document>
<scannerSettings id="turn" pulseFreq_hz="100000" scanFreq_hz="100" headRotatePerSec_deg="30"
 headRotateStart_deg="0" headRotateStop_deg="16" trajectoryTimeInterval_s="0.05"/>
<survey name="yard" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls" scene="scene.xml#s">
<leg><platformSettings x="0" y="0" z="2"/><scannerSettings template="turn"/></leg>
<leg><platformSettings x="5" y="0" z="2"/><scannerSettings template="turn" active="false"/></leg>
<leg><platformSettings x="9" y="1" z="2"/><scannerSettings template="turn" headRotateStop_deg="8"/></leg>
</survey></document>
"""
SCENE = """\
<document><scene id="s"><part><filter type="objloader">
<param type="string" key="filepath" value="yard.obj"/></filter></part></scene></document>
"""
YARD = (
    "mtllib yard.mtl\nusemtl paving\nv -60 -60 0\nv 60 -60 0\nv 60 60 0\nv -60 60 0\nf 1 2 3 4\n"
    + "".join(
        f"v {k} {15 + k % 3} 0\nv {k + 0.5} {15 + k % 3} 0\nv {k + 0.5} {15 + k % 3} 9\n"
        f"f {3 * k + 5} {3 * k + 6} {3 * k + 7}\n"
        for k in range(30)
    )
)

FORMATS = {
    "text": ["--format", "xyz", "--waveforms", "--seed", "3"],
    "xml": ["--format", "vtp", "--waveforms", "--seed", "3"],
    "las": ["--format", "las", "--waveforms", "--seed", "3"],
}
KILLS = 12  # kills of each format
BLOCK = ["--pulses-per-block", "1000"]

# The folder, the seed, number of kills, a command line. Runs it to the end; then repeatedly in
# child processes, each killed at a random time and resumed by the next; the last one may end. A run
# killed before it has a journal starts again, as the message states.
KILLER = """\
import json, os, pathlib, random, shutil, signal, sys, time
from vtkhelios.cli import main
folder, seed, kills, *arguments = sys.argv[1:]
folder, chance = pathlib.Path(folder), random.Random(int(seed))
report = {"killed": 0, "resumed": 0}
def wait(child):
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
def start():
    words = [*arguments, "--quiet"]
    if (folder / "run.journal").exists():
        words.append("--resume")
        report["resumed"] += len((folder / "run.journal").read_bytes().splitlines()) > 1
    elif folder.exists() and any(folder.iterdir()):
        words.append("--overwrite")
    child = os.fork()
    if child == 0:
        os._exit(main(words))
    return child
begun = time.monotonic()
assert wait(start()) == 0
longest = 0.6 * (time.monotonic() - begun)
shutil.rmtree(folder)
while report["killed"] < int(kills):
    child = start()
    time.sleep(chance.uniform(0.0, longest))
    os.kill(child, signal.SIGKILL)
    if wait(child) == -signal.SIGKILL:
        report["killed"] += 1
    else:
        shutil.rmtree(folder)  # it was done: from the start
report["code"] = wait(start())
print(json.dumps(report))
"""

ENVIRONMENT = {**os.environ, "PYTHONPATH": str(PACKAGE_DIR)}


@pytest.fixture
def survey(tmp_path):
    (tmp_path / "survey.xml").write_text(SURVEY)
    (tmp_path / "scene.xml").write_text(SCENE)
    (tmp_path / "yard.obj").write_text(YARD)
    (tmp_path / "yard.mtl").write_text("newmtl paving\nhelios_reflectance 0.4\n")
    return tmp_path


def run(folder, *options, **more):
    return subprocess.run(
        [sys.executable, "-P", "-m", "vtkhelios", "run", "survey.xml", *options],
        capture_output=True,
        text=True,
        cwd=folder,
        env=ENVIRONMENT,
        timeout=300,
        **more,
    )


def digests(folder):
    """The SHA-256 of every file of a run except its summary, which has timings."""
    return {
        path.name: hashlib.sha256(path.read_bytes()).hexdigest()
        for path in folder.iterdir()
        if path.name != "run_summary.json"
    }


def summary(folder):
    """The host-independent part of a summary."""
    report = json.loads((folder / "run_summary.json").read_text())
    assert report.pop("timings").keys() == {"load_s", "run_s", "legs_s", "accuracy_s", "threads"}
    return report


def break_off(survey, *options, size=200_000):
    """A run that ends early, due to a file size limit."""

    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    done = run(survey, *BLOCK, *options, preexec_fn=limit)
    assert done.returncode == 1, done
    return done


@pytest.mark.parametrize("name, seed", [("text", 1), ("xml", 2), ("las", 3)])
def test_killed_at_any_moment(name, seed, survey):
    done = run(survey, *BLOCK, *FORMATS[name], "--output", "whole")
    assert done.returncode == 0, done.stderr
    killed = subprocess.run(
        [sys.executable, "-P", "-c", KILLER, "broken/yard", str(seed), str(KILLS)]
        + ["run", "survey.xml", *BLOCK, *FORMATS[name], "--output", "broken"],
        capture_output=True,
        text=True,
        cwd=survey,
        env=ENVIRONMENT,
        timeout=300,
    )
    assert killed.returncode == 0, killed.stderr
    report = json.loads(killed.stdout)
    assert report["code"] == 0, killed.stderr
    assert report["killed"] == KILLS and report["resumed"] > 0
    whole, broken = survey / "whole/yard", survey / "broken/yard"
    assert digests(broken) == digests(whole)
    assert summary(broken) == summary(whole)
    assert not list(broken.glob("*.part")) and not (broken / "run.journal").exists()


@pytest.mark.parametrize("name", FORMATS)
def test_file_size_limit(name, survey):
    done = break_off(
        survey, *FORMATS[name], size={"text": 3_000_000, "xml": 100_000, "las": 3_000_000}[name]
    )
    assert "File too large" in done.stderr or "No space left" in done.stderr
    assert "are safe in" in done.stderr and "Resume" in done.stderr
    folder = survey / "output/yard"
    assert not (folder / "run_summary.json").exists() and (folder / "run.journal").exists()
    # neither restarted nor with other settings
    done = run(survey, *BLOCK, *FORMATS[name])
    assert (
        done.returncode == 1 and "not finished: set Resume (--resume) to continue it" in done.stderr
    )
    done = run(survey, *BLOCK, *FORMATS[name], "--seed", "4", "--resume")
    assert done.returncode == 1 and "seed was 3 and is 4" in done.stderr
    done = run(survey, *BLOCK, *FORMATS[name], "--resume")
    assert done.returncode == 0, done.stderr
    assert run(survey, *FORMATS[name], *BLOCK, "--output", "whole").returncode == 0
    assert digests(folder) == digests(survey / "whole/yard")


def test_changed_input(survey):
    break_off(survey)
    (survey / "yard.mtl").write_text("newmtl paving\nhelios_reflectance 0.5\n")
    done = run(survey, *BLOCK, "--resume")
    assert done.returncode == 1 and "yard.mtl has changed; use the same inputs" in done.stderr
    (survey / "yard.obj").write_text(YARD.replace("-60", "-61"))
    done = run(survey, *BLOCK, "--resume")
    assert done.returncode == 1
    assert "yard.obj has changed" in done.stderr and "--overwrite" in done.stderr
    assert run(survey, *BLOCK, "--overwrite").returncode == 0
    assert not (survey / "output/yard/run.journal").exists()


def test_interrupt_and_resume(survey):
    path = survey / "survey.xml"  # long enough to be met before its end
    path.write_text(SURVEY.replace('headRotatePerSec_deg="30"', 'headRotatePerSec_deg="5"'))
    command = [sys.executable, "-P", "-m", "vtkhelios", "run", "survey.xml", *BLOCK]
    broken = subprocess.Popen(
        command,
        cwd=survey,
        env=ENVIRONMENT,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    journal = survey / "output/yard/run.journal"
    while not journal.exists() and broken.poll() is None:
        time.sleep(0.01)
    broken.send_signal(signal.SIGINT)
    _, errors = broken.communicate(timeout=60)
    assert broken.returncode == 130, errors
    assert run(survey, *BLOCK, "--resume").returncode == 0
    assert run(survey, *BLOCK, "--output", "whole").returncode == 0
    assert digests(survey / "output/yard") == digests(survey / "whole/yard")


def test_nothing_to_resume(survey):
    done = run(survey, "--resume")
    assert done.returncode == 1
    assert "run.journal, so there is nothing to resume; run it without Resume" in done.stderr
    assert run(survey).returncode == 0
    before = digests(survey / "output/yard")
    done = run(survey, "--resume")
    assert done.returncode == 0, done.stderr
    assert "Nothing is left to do" in done.stdout and "is finished" in done.stdout
    assert digests(survey / "output/yard") == before
    done = run(survey, "--resume", "--seed", "5")
    assert done.returncode == 1 and "seed was 0 and is 5" in done.stderr
    (survey / "output/yard/run_summary.json").unlink()
    done = run(survey, "--resume")
    assert done.returncode == 1 and "its contents cannot be resumed" in done.stderr
    done = run(survey, "--resume", "--overwrite")
    assert done.returncode == 2 and "not allowed with argument" in done.stderr


def test_removed_folder(survey):
    command = [
        sys.executable,
        "-P",
        "-m",
        "vtkhelios",
        "run",
        "survey.xml",
        "--pulses-per-block",
        "50",
    ]
    broken = subprocess.Popen(
        command, cwd=survey, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True
    )
    journal = survey / "output/yard/run.journal"
    while broken.poll() is None and not (journal.exists() and journal.stat().st_size > 3000):
        time.sleep(0.01)
    shutil.rmtree(survey / "output")
    _, errors = broken.communicate(timeout=60)
    assert broken.returncode == 1, errors
    assert "was removed while it was written" in errors or "No such file or directory" in errors
    assert not (survey / "output").exists()


def mount(folder, options):
    return (
        subprocess.run(
            ["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder], check=False
        ).returncode
        == 0
    )


def test_read_only_folder(survey):
    disk = survey / "disk"
    disk.mkdir()
    if not mount(disk, "size=64k,ro"):
        pytest.skip("no disk can be mounted here")
    try:
        done = run(survey, "--output", "disk")
        assert done.returncode == 1
        assert "cannot be created: Read-only file system" in done.stderr
        assert "give another OutputDirectory" in done.stderr
    finally:
        subprocess.run(["umount", disk], check=True)


def test_full_disk_and_resume(survey):
    disk = survey / "disk"
    disk.mkdir()
    if not mount(disk, "size=256k"):
        pytest.skip("no disk can be mounted here")
    try:
        done = run(survey, *BLOCK, "--output", "disk")
        assert done.returncode == 1 and "No space left on device" in done.stderr
        subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
        done = run(survey, *BLOCK, "--output", "disk", "--resume")
        assert done.returncode == 0, done.stderr
        assert run(survey, *BLOCK, "--output", "whole").returncode == 0
        assert digests(disk / "yard") == digests(survey / "whole/yard")
    finally:
        subprocess.run(["umount", disk], check=True)
