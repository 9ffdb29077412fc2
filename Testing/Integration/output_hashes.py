# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""SHA-256 of all files that runs write, to compare two states of the tree.

    build/venv/bin/python Testing/Integration/output_hashes.py > before.txt
    build/venv/bin/python Testing/Integration/output_hashes.py --compare before.txt

The surveys are those of vtkhelios new, with fewer pulses, and those of the folder hashed: moving and swapped
parts, instances, channels, kinds of optics and errors. Each is run with 1, 2 and 3 threads for every variant;
files that differ between numbers of threads are printed, with exit code 1. The sorted lines are "sha256
survey/variant/file". Versions of vtkHelios in files are left out. Of run_summary.json, each member has
a line of its own (FILE#member). In it, and in run.journal, which a part of a run keeps, SKIPPED, the folders
of inputs and the command of a part are left out: they are not the same in two runs.
"""

import argparse
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "hashed"))
from make_inputs import write_inputs  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
HASHED = pathlib.Path(__file__).resolve().parent / "hashed"
SKIPPED = ("timings", "seconds", "versions", "checksum", "check")  # the last two are of the others
VARIANTS = {
    "xyz-pulses": "--format xyz --pulses",
    "las-waveforms": "--format las --waveforms --gps-start gps:1467000000",
    "vtp-waveforms": "--format vtp --waveforms --pulses",
    "hits": "--hits --scan-flags --decibels --split-by-channel",
    "truth": "--format vtp --truth --columns --scan-flags --decibels",
    "colors": "--format las --colors --decibels",
}
# By kind of vtkhelios new: the factor of fewer pulses.
KINDS = {"tls": 20, "als": 25, "uls": 80, "mls": 80, "forest": 20, "city": 40, "river": 60}
# By survey of the folder hashed: variants beside VARIANTS, which test one option each.
OWN = {
    "street": {"fixed": "--sub-rays 19 --format las --seed 9 --no-noise", "part": "--part 2/3",
               "motion": "--format vtp --velocities --motion"},
    "epochs": {"embree": "--ray-caster embree --format vtp", "copies": "--no-instances --no-accuracy-report"},
    "glass": {"scattered": "--scattering-orders 3 --scattering-paths 8 --format vtp --waveforms",
              "few": "--max-sub-rays 1024 --energy-tolerance 0.05",
              "fog": "--weather 'fog 0.1' --waveforms-in-points --format las --waveforms"},
    "flight": {"tolerance": "--range-tolerance 0.02 --energy-tolerance 0.1", "photons": "--detector photonCounting",
               "gaussian": "--detector gaussian --waveforms"},
    "zones": {},
}  # fmt: skip
WITHOUT_WAVEFORMS = {"zones"}


def make_survey(name, folder, command):
    """Makes the folder of a survey; returns its file."""
    if name in KINDS:
        subprocess.run(
            [*command, "new", folder, "--kind", name], check=True, stdout=subprocess.DEVNULL
        )
        path = folder / f"{folder.name}.xml"
        path.write_text(_thin_out(path.read_text(), KINDS[name]))
        return path
    folder.mkdir(parents=True)
    for path in HASHED.iterdir():
        if path.suffix in (".xml", ".mtl"):
            shutil.copy(path, folder)
    write_inputs(folder)
    return folder / f"{name}.xml"


def _thin_out(text, factor):
    """Fewer pulses per second; terrestrial scanners keep the time of a line and have fewer lines."""
    text, count = re.subn(
        r'pulseFreq_hz="(\d+)"', lambda match: f'pulseFreq_hz="{int(match[1]) // factor}"', text
    )
    assert count, "a survey of vtkhelios new has no pulseFreq_hz: change KINDS in output_hashes.py"
    return re.sub(
        r'(verticalResolution|horizontalResolution)_deg="([\d.]+)"',
        lambda match: f'{match[1]}_deg="{float(match[2]) * factor**0.5:.3f}"',
        text,
    )


def hash_file(path):
    """Lines of one file: pairs of what it is and its SHA-256."""
    if path.name == "run_summary.json":
        summary = _without_times(json.loads(path.read_text(encoding="utf-8")))
        for member in sorted(summary):
            yield f"#{member}", _digest(json.dumps(summary[member], sort_keys=True).encode())
        return
    data = re.sub(rb"vtkHelios \d+\.\d+\.\d+", b"vtkHelios", path.read_bytes())
    if path.name == "run.journal":
        lines = [_without_times(json.loads(line)) for line in data.splitlines()]
        data = json.dumps(lines, sort_keys=True).encode()
    yield "", _digest(data)


def _without_times(record):
    """A summary, or a line of a journal, without what is not the same in two runs."""
    for each in record.get("inputs", []):
        each["file"] = os.path.basename(each["file"])
    record.get("part", {}).pop("command", None)
    return {name: value for name, value in record.items() if name not in SKIPPED}


def _digest(data):
    return hashlib.sha256(data).hexdigest()


def hash_run(command, survey, options, threads, output):
    """Runs a survey; returns the digests of its files, by their names."""
    words = ["run", survey.name, "--quiet", "--output", output, "--threads", str(threads)]
    words += ["--pulses-per-block", "5000", *options]
    done = subprocess.run([*command, *words], cwd=survey.parent, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(
            f"{survey.name} with {shlex.join(options)}: exit code {done.returncode}\n{done.stderr}"
        )
    files = sorted(path for path in output.rglob("*") if path.is_file())
    assert files, f"{survey}: a run with {options} wrote nothing"
    digests = {
        f"{path.relative_to(output)}{part}": digest
        for path in files
        for part, digest in hash_file(path)
    }
    shutil.rmtree(output)
    return digests


def hash_all(command, folder, names, threads):
    """Digests of all surveys by survey/variant/file, and the files that depend on the threads."""
    digests, unlike = {}, []
    for name in names:
        survey = make_survey(name, folder / name, command)
        for path in sorted(survey.parent.rglob("*")):
            if path.is_file():
                digests[f"{name}/inputs/{path.relative_to(survey.parent)}"] = _digest(
                    path.read_bytes()
                )
        for variant, text in {**VARIANTS, **OWN.get(name, {})}.items():
            options = shlex.split(text)
            if name in WITHOUT_WAVEFORMS:
                options = [option for option in options if option != "--waveforms"]
            runs = [hash_run(command, survey, options, n, folder / "output") for n in threads]
            for file in sorted(set().union(*runs)):
                if len({run.get(file) for run in runs}) > 1:
                    unlike.append(f"{name}/{variant}/{file}")
                digests[f"{name}/{variant}/{file}"] = runs[0].get(file, "-")
            print(f"{name}/{variant}: {len(runs[0])} digests", file=sys.stderr)
    return digests, unlike


def compare(old, new):
    """Lines that tell what is not the same in two lists of digests by file."""
    gone = [f"gone     {file}" for file in sorted(old.keys() - new.keys())]
    added = [f"new      {file}" for file in sorted(new.keys() - old.keys())]
    return (
        gone
        + added
        + [f"differs  {file}" for file in sorted(old.keys() & new.keys()) if old[file] != new[file]]
    )


def read_list(path):
    pairs = (line.split(" ", 1) for line in path.read_text().splitlines())
    return {file: digest for digest, file in pairs}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--compare",
        type=pathlib.Path,
        metavar="OLD.txt",
        help="print what differs from this list instead",
    )
    parser.add_argument(
        "--write",
        type=pathlib.Path,
        metavar="NEW.txt",
        help="with --compare, also write the new list",
    )
    parser.add_argument(
        "--surveys",
        nargs="+",
        default=[*KINDS, *OWN],
        choices=[*KINDS, *OWN],
        metavar="NAME",
        help="only these",
    )
    parser.add_argument(
        "--threads",
        nargs="+",
        type=int,
        default=[1, 2, 3],
        metavar="N",
        help="numbers of threads (default: 1 2 3)",
    )
    parser.add_argument(
        "--vtkhelios", default=ROOT / "build/bin/vtkhelios", help="the command to run"
    )
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        digests, unlike = hash_all(
            [arguments.vtkhelios], pathlib.Path(folder), arguments.surveys, arguments.threads
        )
    lines = [f"{digest} {file}" for file, digest in sorted(digests.items())]
    if arguments.compare:
        old = read_list(arguments.compare)
        old = {file: old[file] for file in old if file.split("/")[0] in arguments.surveys}
        if arguments.write:
            arguments.write.write_text("\n".join(lines) + "\n")
        lines = compare(old, digests)
        print("\n".join(lines) or f"{len(digests)} digests are the same")
    else:
        print("\n".join(lines))
    for file in unlike:
        print(f"{file}: not the same bytes with {arguments.threads} threads", file=sys.stderr)
    return 1 if unlike or (arguments.compare and lines) else 0


if __name__ == "__main__":
    sys.exit(main())
