# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kills runs, damages their output, and resumes them.

    PYTHONPATH=build/lib/python3/dist-packages build/venv/bin/python Testing/Fuzz/resume.py --kills
    100 --cases 2500

A small survey is run to the end as text, LAS and VTK XML, and repeatedly with SIGKILL at a random
time. The output of each killed run is resumed unchanged, and many times with damage to its journal
and its files. A resume has two valid results: byte-identical to the undisturbed run, or exit code 1
and an error. Anything else is printed with the seed of the case, and the exit code is 1.
"""

import argparse
import collections
import contextlib
import hashlib
import io
import json
import os
import pathlib
import random
import re
import select
import shutil
import signal
import sys
import tempfile
import time
import traceback

SURVEY = """\
<document>
<scannerSettings id="turn" pulseFreq_hz="100000" scanFreq_hz="100" headRotatePerSec_deg="30"
 headRotateStart_deg="0" headRotateStop_deg="2" trajectoryTimeInterval_s="0.01"/>
<survey name="yard" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls" scene="scene.xml#s">
<leg STRIP><platformSettings x="0" y="0" z="2"/><scannerSettings template="turn"/></leg>
<leg STRIP><platformSettings x="9" y="1" z="2"/><scannerSettings template="turn" headRotateStop_deg="1"/></leg>
<leg STRIP><platformSettings x="3" y="2" z="2"/><scannerSettings template="turn" headRotateStop_deg="1"/></leg>
</survey></document>
"""
SCENE = """\
<document><scene id="s"><part><filter type="objloader">
<param type="string" key="filepath" value="yard.obj"/></filter></part></scene></document>
"""
YARD = "v -60 -60 0\nv 60 -60 0\nv 60 60 0\nv -60 60 0\nf 1 2 3 4\n" + "".join(
    f"v {k} 9 0\nv {k + 0.5} 9 0\nv {k + 0.5} 9 9\nf {3 * k + 65} {3 * k + 66} {3 * k + 67}\n"
    for k in range(-20, 20)
)

# The survey and the options of a run. All legs of a strip write to the same files.
RUNS = {
    "text": ["legs.xml", "--format", "xyz", "--waveforms", "--pulses"],
    "las": ["legs.xml", "--format", "las", "--waveforms"],
    "vtp": ["legs.xml", "--format", "vtp", "--waveforms"],
    "strip": ["strip.xml", "--format", "las", "--waveforms"],
}
BLOCK = 500  # pulses
SLOWEST = 60.0  # [s] of a case
JOURNAL = "run.journal"
SUMMARY = "run_summary.json"


def write_survey(folder):
    (folder / "legs.xml").write_text(SURVEY.replace(" STRIP", ""))
    (folder / "strip.xml").write_text(SURVEY.replace(" STRIP", ' stripId="1"'))
    (folder / "scene.xml").write_text(SCENE)
    (folder / "yard.obj").write_text(YARD)


def run(name, output, *options):
    """Runs a survey through the command line; returns the exit code and messages."""
    from vtkhelios.cli import main

    said = io.StringIO()
    words = [
        "run",
        *RUNS[name],
        "--output",
        str(output),
        "--pulses-per-block",
        str(BLOCK),
        "--seed",
        "3",
    ]
    with contextlib.redirect_stderr(said):
        code = main([*words, "--threads", "1", "--quiet", *options])
    return code, said.getvalue()


def without_timings(summary):
    try:
        report = json.loads(summary)
    except ValueError:
        return summary
    report.pop("timings", None)
    return json.dumps(report, sort_keys=True).encode()


def contents(folder):
    """The digest of every file; of the summary without host-dependent and time values."""
    found = {}
    for path in folder.iterdir():
        data = path.read_bytes()
        if path.name == SUMMARY:
            data = without_timings(data)
        found[path.name] = hashlib.sha256(data).hexdigest()
    return found


# Damage to the bytes of any file


def change_bytes(data, chance):
    data = bytearray(data)
    for _ in range(chance.choice([1, 1, 1, 2, 8, 64]) if data else 0):
        data[chance.randrange(len(data))] ^= chance.randrange(1, 256)
    return bytes(data)


def zero_bytes(data, chance):
    begin = chance.randrange(len(data) + 1)
    end = min(len(data), begin + chance.choice([1, 16, 512, 4096]))
    return data[:begin] + bytes(end - begin) + data[end:]


def cut_end(data, chance):
    return data[: chance.randrange(len(data) + 1)]


def add_bytes(data, chance):
    return data + chance.choice([b"\0" * 100, b"1 2 3\n", data[-200:], b"{}\n", b"\n"])


def remove_bytes(data, chance):
    begin = chance.randrange(len(data) + 1)
    return data[:begin] + data[begin + chance.choice([1, 2, 30]) :]


ANY = [change_bytes, change_bytes, zero_bytes, cut_end, add_bytes, remove_bytes]


# Damage to the lines of a journal


def delete_line(data, chance):
    lines = data.splitlines(True)
    del lines[chance.randrange(len(lines))]
    return b"".join(lines)


def double_line(data, chance):
    lines = data.splitlines(True)
    at = chance.randrange(len(lines))
    lines.insert(chance.choice([at, len(lines)]), lines[at])
    return b"".join(lines)


def swap_lines(data, chance):
    lines = data.splitlines(True)
    a, b = chance.randrange(len(lines)), chance.randrange(len(lines))
    lines[a], lines[b] = lines[b], lines[a]
    return b"".join(lines)


def remove_key(data, chance):
    keys = list(re.finditer(rb'"\w+":(\d+|"[^"]*"|true|false),?', data))
    key = chance.choice(keys)
    return data[: key.start()] + data[key.end() :]


def change_number(data, chance):
    number = chance.choice(list(re.finditer(rb"(?<=:)\d+", data)))
    value = int(number[0])
    new = chance.choice(
        [0, -1, value + 1, max(0, value - 1), 10 * value, 2**31, 2**63, value / 2, '"x"']
    )
    return data[: number.start()] + str(new).encode() + data[number.end() :]


LINES = [delete_line, double_line, swap_lines, remove_key, change_number, cut_end]


def damage_journal(folder, chance, others):
    """Damages the journal; returns how."""
    path = folder / JOURNAL
    kind = chance.choice([*ANY, *LINES, *LINES, "other", "empty", "gone"])
    if kind == "other":
        path.write_bytes(chance.choice(others))
    elif kind == "empty":
        path.write_bytes(b"")
    elif kind == "gone":
        path.unlink()
    else:
        path.write_bytes(kind(path.read_bytes(), chance))
    return f"journal {kind if isinstance(kind, str) else kind.__name__}"


def damage_file(folder, chance):
    """Damages a file of points, waveforms, pulses or trajectories; returns how."""
    files = sorted(path for path in folder.iterdir() if path.name not in (JOURNAL, SUMMARY))
    if not files:
        return "no file"
    path = chance.choice(files)
    kind = chance.choice([*ANY, change_bytes, "gone", "swapped"])
    if kind == "gone":
        path.unlink()
    elif kind == "swapped":
        other = chance.choice(files)
        mine, its = path.read_bytes(), other.read_bytes()
        path.write_bytes(its)
        other.write_bytes(mine)
    else:
        path.write_bytes(kind(path.read_bytes(), chance))
    return f"{'part' if path.suffix == '.part' else 'whole'} {kind if isinstance(kind, str) else kind.__name__}"


def damage_finished(folder, chance):
    """Damages the summary of a finished run, or the size of one of its files; returns how."""
    if chance.random() < 0.7:
        path = folder / SUMMARY
        kind = chance.choice([*ANY, remove_key, change_number])
    else:
        path = chance.choice(sorted(path for path in folder.iterdir() if path.name != SUMMARY))
        kind = chance.choice([add_bytes, remove_bytes])
    path.write_bytes(
        kind(
            path.read_bytes().replace(b" : ", b":") if kind in LINES else path.read_bytes(), chance
        )
    )
    return f"finished {kind.__name__}"


def judge(code, said, folder, truth):
    """The error in how a resume ended; empty: none."""
    if "Traceback" in said:
        return "a traceback: " + said
    if code == 0:
        now = contents(folder)
        wrong = sorted(
            name for name in now.keys() | truth.keys() if now.get(name) != truth.get(name)
        )
        return f"exit code 0, but {', '.join(wrong)} differ" if wrong else ""
    if code != 1:
        return f"exit code {code}: {said}"
    lines = said.strip().splitlines()
    if not lines or not lines[0].startswith("error: ") or len(lines) > 3:
        return f"no clear error: {said!r}"
    return ""


def in_child(work, seconds=SLOWEST):
    """Calls work(tell) in a child; returns its messages, and how it ended. A child silent for too long is killed."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(read)
        code = 70
        try:
            with os.fdopen(write, "w") as pipe:
                work(lambda what: print(json.dumps(what), file=pipe, flush=True))
            code = 0
        except Exception:
            traceback.print_exc()
        finally:
            os._exit(code)
    os.close(write)
    told, text = [], b""
    while True:
        ready, _, _ = select.select([read], [], [], seconds)
        if not ready:
            os.kill(child, signal.SIGKILL)
            break
        part = os.read(read, 65536)
        if not part:
            break
        text += part
    os.close(read)
    status = os.waitpid(child, 0)[1]
    told = [json.loads(line) for line in text.decode().splitlines()]
    return told, os.waitstatus_to_exitcode(status)


class Campaign:
    def __init__(self, folder, seed):
        self.folder, self.seed = folder, seed
        self.chance = random.Random(seed)
        self.truths, self.left = {}, collections.defaultdict(list)
        self.counts, self.failures = collections.Counter(), []

    def fail(self, text):
        self.failures.append(text)
        print("WRONG", text, flush=True)

    def run_whole(self, name):
        """The undisturbed run, and the number of its journal lines."""
        (((code, said),), _) = in_child(lambda tell: tell(run(name, self.folder / "whole" / name)))
        assert code == 0, said
        folder = self.folder / "whole" / name / "yard"
        self.truths[name] = contents(folder)
        legs = json.loads((folder / SUMMARY).read_text())["legs"]
        return 1 + sum(1 - -leg["pulses"] // BLOCK for leg in legs)

    def kill(self, name, number, lines):
        """Keeps the output of a killed run if its journal has a line of progress."""
        output = self.folder / "killed" / name / str(number)
        child = os.fork()
        if child == 0:
            code = 70
            try:
                code = run(name, output)[0]
            finally:
                os._exit(code)
        folder = output / "yard"
        journal = folder / JOURNAL
        wanted, end = self.chance.randrange(2, lines + 1), time.monotonic() + SLOWEST
        while time.monotonic() < end and not (folder / SUMMARY).exists():
            if journal.exists() and journal.read_bytes().count(b"\n") >= wanted:
                break
            time.sleep(0.0005)
        time.sleep(self.chance.choice([0.0, 0.001, 0.003, 0.01]) * self.chance.random())
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        if (
            (folder / SUMMARY).exists()
            or not journal.exists()
            or journal.read_bytes().count(b"\n") < 2
        ):
            shutil.rmtree(output, ignore_errors=True)
        else:
            self.left[name].append(folder)

    def resume_all(self, name, cases):
        """Resumes the output: unchanged, then damaged."""
        folders = self.left[name]
        jobs = [(folder, None) for folder in folders]
        seeds = [self.chance.getrandbits(48) for _ in range(cases)]
        jobs += [(folders[i % len(folders)], seed) for i, seed in enumerate(seeds)]
        jobs += [(self.folder / "whole" / name / "yard", seed) for seed in seeds[: cases // 8]]
        others = [(folder / JOURNAL).read_bytes() for left in self.left.values() for folder in left]
        while jobs:
            told, status = in_child(
                lambda tell, jobs=jobs: self.resume_some(name, jobs, others, tell)
            )
            for what, result, problem in told:
                self.counts[
                    what if what == "undamaged" else what.split()[0] + " damaged", result
                ] += 1
                self.counts["kind", what, result] += 1
                if problem:
                    self.fail(problem)
            jobs = jobs[len(told) :]
            if status != 0:
                folder, seed = jobs.pop(0)
                self.fail(
                    f"{name} {folder} seed {seed}: ended with {status} (a signal, or no response)"
                )

    def resume_some(self, name, jobs, others, tell):
        for folder, seed in jobs:
            copy = self.folder / "copy" / name
            shutil.rmtree(copy, ignore_errors=True)
            shutil.copytree(folder, copy / "yard")
            what = "undamaged"
            if seed is not None:
                what = self.damage(copy / "yard", random.Random(seed), others)
            code, said = run(name, copy, "--resume")
            problem = judge(code, said, copy / "yard", self.truths[name])
            if what == "undamaged" and code != 0:
                problem = "is not resumed: " + said
            result = "right" if code == 0 else "error"
            tell(
                [
                    what,
                    result,
                    f"{name} {folder.parent.name} seed {seed}, {what}: {problem}"
                    if problem
                    else "",
                ]
            )

    @staticmethod
    def damage(folder, chance, others):
        if (folder / SUMMARY).exists() and not (folder / JOURNAL).exists():
            return damage_finished(folder, chance)
        where = chance.random()
        if where < 0.45:
            return damage_journal(folder, chance, others)
        if where < 0.9:
            return damage_file(folder, chance)
        return f"both {damage_journal(folder, chance, others)}, {damage_file(folder, chance)}"

    def go(self, kills, cases):
        import vtkhelios.cli  # noqa: F401 (once, not in every child)

        for index, name in enumerate(RUNS):
            lines = self.run_whole(name)
            wanted = kills * (index + 1) // len(RUNS) - kills * index // len(RUNS)
            number = 0
            while len(self.left[name]) < wanted and number < 20 * wanted + 20:
                self.kill(name, number, lines)
                number += 1
            self.counts["killed"] += number
        for index, name in enumerate(RUNS):
            if self.left[name]:
                self.resume_all(name, cases * (index + 1) // len(RUNS) - cases * index // len(RUNS))

    def report(self, verbose):
        kept = sum(map(len, self.left.values()))
        print(f"{self.counts.pop('killed')} runs killed, {kept} of them while writing")
        for key, count in sorted(self.counts.items(), key=str):
            if key[0] != "kind" or verbose:
                print(f"{count:6d}  {' '.join(key)}")
        print(f"{len(self.failures)} wrong outcomes (seed {self.seed})")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--kills", type=int, default=100, help="number of runs killed while writing"
    )
    parser.add_argument("--cases", type=int, default=2500, help="number of damaged folders")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--verbose", action="store_true", help="print the counts of every kind of damage"
    )
    arguments = parser.parse_args()
    fast = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # where fsync takes no time
    with tempfile.TemporaryDirectory(dir=fast) as folder:
        folder = pathlib.Path(folder)
        write_survey(folder)
        os.chdir(folder)
        campaign = Campaign(folder, arguments.seed)
        campaign.go(arguments.kills, arguments.cases)
        campaign.report(arguments.verbose)
        os.chdir("/")
    return 1 if campaign.failures else 0


if __name__ == "__main__":
    sys.exit(main())
