# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Commands that are stopped by a signal at a moment of their life, and what must be true then.

The tests run them with small inputs; Testing/Benchmarks/stop_times.py measures the times with large ones.
"""

import contextlib
import dataclasses
import importlib.util
import json
import os
import pathlib
import re
import runpy
import shutil
import signal
import subprocess
import sys
import time
import uuid

import vtkhelios

MARK = "VTKHELIOS_STOPPING_TEST"  # a variable that all processes of a command inherit
PATIENCE = 10.0  # s, of the tests: other programs may be running
PACKAGE = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
LAUNCHER = PACKAGE.parents[2] / "bin/vtkhelios"
VIEWER = PACKAGE.parents[2] / "bin/vtkhelios-viewer"
PROGRESS = re.compile(r" *\d+ % |warning: |Note: |price  ")


@dataclasses.dataclass
class Case:
    """A command: its words, where {in} is the folder of inputs and {out} the folder of outputs."""

    name: str
    words: str
    needs: tuple = ()  # modules of Python and programs
    life: float = 0.0  # s, of a command that would last for minutes; 0: it is measured

    def missing(self):
        for need in self.needs:
            is_there = (
                VIEWER.is_file()
                if need == "viewer"
                else shutil.which(need) or importlib.util.find_spec(need)
            )
            if not is_there:
                return need
        return None


CASES = [
    Case("run", "run {in}/long.xml --output {out}", life=4),
    Case("run, slow pulses", "run {in}/long.xml --output {out} --sub-rays 4096 --format las", life=5),
    Case("run, vtp, waveforms", "run {in}/survey.xml --output {out} --format vtp --waveforms"),
    Case("run, reading a mesh", "run {in}/mesh.xml --output {out}"),
    Case("run --dry-run", "run {in}/long.xml --output {out} --dry-run"),
    Case("join", "join {in}/parts/fence --output {out}"),
    Case("detect", "detect {in}/run/fence/leg000_fullwave.pvtt --detector gaussian -o {out}/a.xyz"),
    Case("convert to LAS", "convert {in}/run/fence {out}/a.las"),
    Case("convert to LAZ", "convert {in}/cloud.las {out}/a.laz", ()),
    Case("convert to COPC", "convert {in}/cloud.las {out}/a.copc.laz"),
    Case("convert to PLY", "convert {in}/cloud.las {out}/a.ply"),
    Case("convert to VTK", "convert {in}/cloud.las {out}/a.vtp"),
    Case("convert to E57", "convert {in}/cloud.las {out}/a.e57", ("pye57",)),
    Case("convert a mesh", "convert {in}/mesh.obj {out}/a.obj"),
    Case("export", "export {in}/run/fence {out}/kitti --semantickitti"),
    Case("info, points", "info {in}/cloud.las"),
    Case("info, a mesh", "info {in}/mesh.obj"),
    Case("report", "report {in}/run/fence --output {out}/a.html", ("matplotlib", "jinja2")),
    Case("compare", "compare {in}/cloud.las {in}/run/fence --output {out}/a.html", ("matplotlib", "jinja2")),
    Case("fit", "fit {in}/flight.las --output {out}/fitted", life=6),
    Case("plan", "plan {in}/fence.obj --grid 4 --output {out}", life=6),
    Case("plan --check", "plan {in}/fence.obj --grid 10 --resolution 0.2 --no-picture --check --output {out}"),
    Case("plan --als", "plan {in}/fence.obj --als --flying-height 120 --output {out}"),
    Case("tradeoff", "tradeoff {in}/survey.xml --pulses 200 --output {out}", ("matplotlib",), life=8),
    Case("view --html", "view {in}/cloud.las --html {out}/a.html"),
    Case("view --html, a survey", "view {in}/survey.xml --html {out}/a.html"),
    Case("view --still", "view {in}/survey.xml --offscreen --still {out}/a.png --size 320x200", ("viewer", "Xvfb")),
    Case("view --record", "view {in}/survey.xml --offscreen --record {out}/a.ogv --size 320x200", ("viewer", "Xvfb"), life=8),
    Case("new", "new {out}/yard --kind tls"),
    Case("validate", "validate {in}/survey.xml"),
    Case("list", "list scanners"),
    Case("schema", "schema --output {out}"),
    Case("help", "--help"),
]  # fmt: skip


def write_mesh(path, side):
    """A hilly mesh of side x side squares, as OBJ."""
    import numpy as np

    x, y = np.meshgrid(np.linspace(-60, 60, side + 1), np.linspace(-60, 60, side + 1))
    z = np.sin(x / 7) * np.cos(y / 9) - 3
    corner = np.arange(1, (side + 1) * side + 1).reshape(side, side + 1)[:, :-1].ravel()
    with open(path, "w", encoding="ascii") as file:
        for row in zip(x, y, z):
            file.write("".join(f"v {a:.4f} {b:.4f} {c:.4f}\n" for a, b, c in zip(*row)))
        for first in range(0, len(corner), 100_000):
            file.write(
                "".join(
                    f"f {c} {c + 1} {c + side + 2}\nf {c} {c + side + 2} {c + side + 1}\n"
                    for c in corner[first : first + 100_000].tolist()
                )
            )


def make_inputs(folder, seconds=1.0, side=150):
    """Writes the inputs of all cases: scans of so many seconds, a mesh of 2 side^2 triangles."""
    from vtkhelios import cli

    small_run = runpy.run_path(pathlib.Path(__file__).parents[1] / "_small_run.py")
    survey = small_run["write_survey"](folder)
    text = survey.read_text().replace('PerSec_deg="60"', f'PerSec_deg="{60 / seconds:g}"')
    survey.write_text(text)
    long = text.replace(f'PerSec_deg="{60 / seconds:g}"', f'PerSec_deg="{0.05 / seconds:g}"')
    (folder / "long.xml").write_text(long)
    write_mesh(folder / "mesh.obj", side)
    scene = small_run["SCENE"].replace("fence.obj", "mesh.obj")
    (folder / "mesh_scene.xml").write_text(scene)
    (folder / "mesh.xml").write_text(text.replace("scene.xml#", "mesh_scene.xml#"))

    def run(*words):
        assert cli.main([*map(str, words), "--quiet"]) == 0, words

    run("run", survey, "--output", folder / "run", "--format", "vtp", "--waveforms")
    run("convert", folder / "run/fence", folder / "cloud.las")
    for part in ("1/2", "2/2"):
        run("run", survey, "--output", folder / "parts", "--part", part)
    shutil.copy(folder / "cloud.las", folder / "flight.las")


class Stop:
    """A command that got a signal: ``code``, ``errors``, ``seconds`` from the signal to the end.

    ``seconds`` is None if the command had ended before the signal.
    """

    def __init__(self, case, inputs, outputs, delay, number, program=None):
        shutil.rmtree(outputs, ignore_errors=True)
        outputs.mkdir(parents=True)
        mark = uuid.uuid4().hex
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), MARK: mark}
        environment.pop("DISPLAY", None)
        words = [
            word.replace("{in}", str(inputs)).replace("{out}", str(outputs))
            for word in case.words.split()
        ]
        with open(outputs.with_name("errors.txt"), "w+b") as errors:
            start = time.monotonic()
            process = subprocess.Popen(
                [*(program or [str(LAUNCHER)]), *words], env=environment, start_new_session=True,
                stdout=subprocess.DEVNULL, stderr=errors,
            )  # fmt: skip
            self.seconds = None
            try:
                if number:
                    try:
                        process.wait(timeout=delay)
                    except subprocess.TimeoutExpired:
                        signalled = time.monotonic()
                        process.send_signal(number)
                        with contextlib.suppress(subprocess.TimeoutExpired):
                            process.wait(timeout=60)
                        self.seconds = time.monotonic() - signalled
                else:
                    process.wait(timeout=600)
            finally:
                process.kill()
                process.wait()
            self.life = time.monotonic() - start
            self.code = process.returncode
            errors.seek(0)
            self.errors = errors.read().decode()
        self.left = wait_for_others(mark)
        self.number, self.delay, self.outputs = number, delay, outputs

    def find_fault(self):
        """Returns the fault of a stop, or None."""
        if self.left:
            return f"processes are left: {self.left}"
        lines = [line for line in self.errors.splitlines() if not PROGRESS.match(line)]
        if self.code == -self.number and not lines and self.delay < 0.05:
            return self.find_half_file()  # the launcher had not begun
        if self.code == 0:  # complete before the signal had an effect
            return f"a line of a complete command: {lines}" if lines else self.find_half_file()
        if self.code != 128 + self.number:
            return f"exit code {self.code}: {self.errors[-1000:]}"
        if len(lines) != 1 or not lines[0].startswith("error: interrupted"):
            return f"not one line: {self.errors[-2000:]}"
        if self.seconds > PATIENCE:
            return f"{self.seconds:.1f} s from the signal to the end"
        return self.find_half_file()

    def find_half_file(self):
        for path in sorted(self.outputs.rglob("*")):
            if path.is_file() and not is_whole(path):
                return f"half a file: {path.name}"
        return None


def is_whole(path):
    """Returns whether a file with a final name has its end."""
    data, ending = path.read_bytes(), path.suffix
    if ".part" in path.suffixes or any(".part" in each.suffixes for each in path.parents):
        return True
    if ending == ".html":
        return data.rstrip().endswith(b"</html>")
    if ending == ".png":
        return data.endswith(b"IEND\xaeB`\x82")
    if ending in (".json", ".geojson"):
        return json.loads(data) is not None
    if ending in (".xml", ".vtp", ".pvtp", ".pvtt", ".vtt"):
        return data.rstrip().endswith(b">")
    if ending in (".las", ".laz", ".ply", ".e57") and data:
        from vtkhelios import formats

        with formats.open_reader(path) as reader:
            return sum(len(chunk["points"]) for chunk in reader.chunks()) > 0
    return bool(data)


def wait_for_others(mark):
    """The processes of a command that are left after a second."""
    end = time.monotonic() + 2.0
    while (left := find_processes(mark)) and time.monotonic() < end:
        time.sleep(0.02)
    return left


def find_processes(mark):
    found = []
    for entry in os.scandir("/proc"):
        try:
            if (
                entry.name.isdigit()
                and mark.encode() in pathlib.Path(entry, "environ").read_bytes()
            ):
                state = pathlib.Path(entry, "stat").read_text().rpartition(")")[2].split()[0]
                name = pathlib.Path(entry, "comm").read_text().strip()
                found += [] if state == "Z" else [f"{entry.name} {name}"]
        except OSError:
            pass
    return found


SIGNALS = (signal.SIGINT, signal.SIGTERM)
