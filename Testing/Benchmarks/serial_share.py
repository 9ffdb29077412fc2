# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The share of a run that one thread does alone, and what that leaves of many cores (Linux).

    build/venv/bin/python Testing/Benchmarks/serial_share.py SURVEY [--threads N] [-- OPTIONS OF RUN]

Runs the survey with many threads and samples which of them have work (state R of /proc/PID/task/*/stat: a thread
that waits for a core has work, too) and their processor time (schedstat). Processor time while one thread had
work is serial; with k at work, n cores take 1 / min(k, n) of it. So two cores, also shared ones, tell how far the
run would divide; they do not tell what caches, memory and locks of more cores would cost.

With --synthetic the samples are of a process that computes alone for a quarter of its time: a check of the script.
"""

import argparse
import collections
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
INTERVAL = 0.002  # s
CORES = (1, 2, 8, 16, 64)
# TBB starts no more threads than the machine has cores.
MANY_CORES = """
#define _GNU_SOURCE
#include <dlfcn.h>
#include <sched.h>
#include <unistd.h>
long sysconf(int name)
{
  long (*next)(int) = dlsym(RTLD_NEXT, "sysconf");
  return name == _SC_NPROCESSORS_ONLN || name == _SC_NPROCESSORS_CONF ? COUNT : next(name);
}
int sched_getaffinity(pid_t pid, size_t size, cpu_set_t* set)
{
  CPU_ZERO_S(size, set);
  for (int i = 0; i < COUNT; ++i) { CPU_SET_S(i, size, set); }
  return 0;
}
"""
SYNTHETIC = """
import hashlib, threading
data = bytes(1 << 20)
def work(count):
    for _ in range(count): hashlib.sha256(data).digest()
work(300)
threads = [threading.Thread(target=work, args=(300,)) for _ in range(3)]
for thread in threads: thread.start()
for thread in threads: thread.join()
"""


def pretend_cores(folder, count):
    """Returns the environment of a process that finds so many cores."""
    source, library = folder / "cores.c", folder / "cores.so"
    source.write_text(MANY_CORES)
    command = ["cc", "-shared", "-fPIC", f"-DCOUNT={count}", source, "-o", library]
    subprocess.run(command, check=True)
    return {**os.environ, "LD_PRELOAD": str(library)}


def read_threads(pid):
    """Returns processor time [ns] and whether it has work, by thread."""
    threads = {}
    for task in pathlib.Path(f"/proc/{pid}/task").iterdir():
        try:
            state = (task / "stat").read_text().rpartition(")")[2].split()[0]
            threads[task.name] = int((task / "schedstat").read_text().split()[0]), state == "R"
        except (OSError, IndexError):  # it has ended
            continue
    return threads


def sample(process, find_phase):
    """Returns processor time [s] by phase and number of threads that have work."""
    spent = collections.Counter()
    before = {}
    while process.poll() is None:
        try:
            threads = read_threads(process.pid)
        except OSError:
            break
        used = sum(
            max(0, now - before.get(name, (0, False))[0]) for name, (now, _) in threads.items()
        )
        spent[find_phase(), max(1, sum(works for _, works in threads.values()))] += 1e-9 * used
        before = threads
        time.sleep(INTERVAL)
    return spent


def print_table(spent):
    total = sum(spent.values())
    for phase in dict.fromkeys(name for name, _ in spent):
        own = {count: s for (name, count), s in spent.items() if name == phase}
        alone = own.get(1, 0.0)
        print(
            f"{phase:24} {sum(own.values()):8.2f} s, alone {alone:6.2f} s, {100 * alone / total:5.2f} % of all"
        )
    alone = sum(s for (_, count), s in spent.items() if count == 1)
    print(f"{'all':24} {total:8.2f} s, alone {alone:6.2f} s, {100 * alone / total:5.2f} %")
    for cores in CORES:
        wall = sum(s / min(count, cores) for (_, count), s in spent.items())
        print(f"{cores:3d} cores: {total / wall:6.2f} times as fast as one")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("survey", nargs="?")
    parser.add_argument("--threads", metavar="N", default="64")
    parser.add_argument("--synthetic", action="store_true", help="check the script")
    own = sys.argv[1:]
    options = own[own.index("--") + 1 :] if "--" in own else []
    arguments = parser.parse_args(own[: own.index("--")] if "--" in own else own)
    if arguments.synthetic:
        with subprocess.Popen([sys.executable, "-c", SYNTHETIC]) as process:
            print_table(sample(process, lambda: "synthetic"))
        return process.returncode
    if not arguments.survey:
        parser.error("give a survey, or --synthetic")
    with tempfile.TemporaryDirectory(dir="/dev/shm") as folder:
        output = pathlib.Path(folder, "out")
        environment = pretend_cores(pathlib.Path(folder), arguments.threads)
        seen = []

        def find_phase():
            if any(output.glob("*/run.journal")):
                seen[:] = ["legs"]
                return "legs"
            return "accuracy and end" if seen else "start and scene"

        command = [
            ROOT / "build/bin/vtkhelios",
            "run",
            arguments.survey,
            "--output",
            output,
            "--quiet",
        ]
        command += ["--threads", arguments.threads, *options]
        with subprocess.Popen(command, env=environment) as process:
            print_table(sample(process, find_phase))
    return process.returncode


if __name__ == "__main__":
    sys.exit(main())
