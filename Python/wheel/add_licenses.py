#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Adds the licenses of all that a wheel bundles, and a table of it. build.sh runs it.

vtkhelios-*.dist-info/licenses gets the copyright file of each package, and bundled.txt: each library
of the wheel with its version, license and the source that it was made from. A library that LICENSES
below does not name is an error.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# SPDX license of the libraries of a source package of Debian; scripts and tests have others.
LICENSES = {
    "double-conversion": "BSD-3-Clause",
    "eigen3": "MPL-2.0",
    "geographiclib": "MIT",
    "libjsoncpp": "MIT",
    "liblzf": "BSD-2-Clause",
    "lz4": "BSD-2-Clause",
    "onetbb": "Apache-2.0",
    "openssl": "Apache-2.0",
    "proj": "MIT",
    "pugixml": "MIT",
    "random123": "BSD-3-Clause",
    "re2": "BSD-3-Clause",
    "sqlite3": "blessing",
    "vtk9": "BSD-3-Clause",
    "xz-utils": "0BSD",
}
HEADERS = ("libeigen3-dev", "librandom123-dev")  # compiled in

_HASH = re.compile(r"-[0-9a-f]{8}(?=\.so)")  # by auditwheel


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("wheel", type=pathlib.Path)
    parser.add_argument("--sources", type=pathlib.Path, required=True, help="of vtk9 and proj")
    parser.add_argument("--to", type=pathlib.Path, required=True, help="folder for the new wheel")
    return parser.parse_args()


def query(*arguments):
    return subprocess.run(
        ["dpkg-query", *arguments], check=True, capture_output=True, text=True
    ).stdout


def find_package(library):
    """The source package of Debian that a library is from, its version and its copyright file."""
    owner = query("-S", f"*/{library}").split(":")[0]
    return describe(owner)


def describe(package):
    source, version = query("-W", "-f", "${source:Package} ${Version}\n", package).split()[:2]
    return source, version, pathlib.Path("/usr/share/doc", package, "copyright")


def describe_source(sources, name):
    """What find_package() returns, of a source package that build.sh has compiled."""
    changes = (sources / name / "debian/changelog").read_text(encoding="utf-8")
    return name, re.match(r"\S+ \((.*?)\)", changes)[1], sources / name / "debian/copyright"


def find_origin(library, sources):
    if library.startswith("libvtk"):
        return describe_source(sources, "vtk9")
    if library.startswith("libproj."):
        return describe_source(sources, "proj")
    return find_package(library)


def add_licenses(tree, sources):
    folder = next(tree.glob("*.dist-info")) / "licenses"
    folder.mkdir(exist_ok=True)
    rows = []
    libraries = {_HASH.sub("", path.name): path for path in (tree / "vtkhelios/lib").iterdir()}
    origins = [(path.name, *find_origin(name, sources)) for name, path in libraries.items()]
    origins += [(f"headers of {package}", *describe(package)) for package in HEADERS]
    for name, source, version, copyright_file in sorted(origins):
        if source not in LICENSES:
            sys.exit(f"{__file__}: {name} is from {source}, whose license LICENSES does not name")
        shutil.copyfile(copyright_file, folder / f"{source}.txt")
        rows.append(f"{name:48} {source} {version:32} {LICENSES[source]}")
    (folder / "bundled.txt").write_text(
        "What this wheel bundles: file, source package of Debian 12 and its version, license.\n"
        "SOURCE.txt has the copyright notices.\n\n" + "\n".join(rows) + "\n"
    )


def main():
    given = parse()
    given.to.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        wheel = [sys.executable, "-m", "wheel"]
        subprocess.run([*wheel, "unpack", given.wheel, "--dest", scratch], check=True)
        tree = next(pathlib.Path(scratch).iterdir())
        add_licenses(tree, given.sources)
        subprocess.run([*wheel, "pack", tree, "--dest-dir", given.to], check=True)


if __name__ == "__main__":
    main()
