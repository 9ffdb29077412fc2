#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Separates the symbols of the libraries in a wheel from those of others, and adds their licenses.

build.sh runs it after auditwheel.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

from licenses import add_licenses
from symbols import make_unique_weak


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("wheel", type=pathlib.Path)
    parser.add_argument(
        "--sources", type=pathlib.Path, required=True, help="folder of the sources that were built"
    )
    parser.add_argument("--to", type=pathlib.Path, required=True, help="folder for the new wheel")
    return parser.parse_args()


def main():
    given = parse()
    given.to.mkdir(parents=True, exist_ok=True)
    wheel = [sys.executable, "-m", "wheel"]
    with tempfile.TemporaryDirectory() as scratch:
        subprocess.run([*wheel, "unpack", given.wheel, "--dest", scratch], check=True)
        tree = next(pathlib.Path(scratch).iterdir())
        count = sum(make_unique_weak(path) for path in tree.rglob("*.so*"))
        print(f"{count} unique symbols are weak now")
        add_licenses(tree, given.sources)
        subprocess.run([*wheel, "pack", tree, "--dest-dir", given.to], check=True)


if __name__ == "__main__":
    main()
