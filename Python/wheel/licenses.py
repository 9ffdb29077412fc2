# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The licenses of all that a wheel bundles, and a table of it."""

import pathlib
import re
import shutil
import subprocess
import sys

# License (SPDX) of the libraries of a source package of Debian; scripts and tests have others.
LICENSES = {
    "double-conversion": "BSD-3-Clause",
    "eigen3": "MPL-2.0",
    "geographiclib": "MIT",
    "libjpeg-turbo": "IJG AND BSD-3-Clause AND Zlib",
    "libjsoncpp": "MIT",
    "liblzf": "BSD-2-Clause",
    "libpng1.6": "libpng-2.0",
    "libyaml": "MIT",
    "lz4": "BSD-2-Clause",
    "onetbb": "Apache-2.0",
    "openssl": "Apache-2.0",
    "proj": "MIT",
    "pugixml": "MIT",
    "librandom123": "BSD-3-Clause",
    "re2": "BSD-3-Clause",
    "sqlite3": "public domain",
    "tiff": "libtiff",
    "vtk9": "BSD-3-Clause",
    "xz-utils": "public domain",
}
BUILT = {"libproj": "proj", "libtiff": "tiff"}  # by build.sh, from these source packages
# So is this for other versions of Python, from the source of Debian's VTK.
DEBIAN_NAME = (re.compile(r"^libvtkWrappingPythonCore3\.\d+-"), "libvtkWrappingPythonCore3.11-")
HEADERS = ("libeigen3-dev", "librandom123-dev")  # compiled in

_HASH = re.compile(r"-[0-9a-f]{8}(?=\.)")  # by auditwheel


def query(*arguments):
    return subprocess.run(
        ["dpkg-query", *arguments], check=True, capture_output=True, text=True
    ).stdout


def find_package(library):
    """The source package of Debian that a library is from, its version and its copyright file."""
    owner = query("-S", f"*/{DEBIAN_NAME[0].sub(DEBIAN_NAME[1], library)}").split(":")[0]
    return describe(owner)


def describe(package):
    source, version = query("-W", "-f", "${source:Package} ${Version}\n", package).split()[:2]
    return source, version, pathlib.Path("/usr/share/doc", package, "copyright")


def describe_built(source):
    """Describes the result of find_package() for a source package that build.sh has compiled."""
    changes = (source / "debian/changelog").read_text(encoding="utf-8")
    return source.name, re.match(r"\S+ \((.*?)\)", changes)[1], source / "debian/copyright"


def find_origin(library, sources):
    """Source package, version and copyright file of a library, without its checksum."""
    built = BUILT.get(library.split(".")[0])
    return describe_built(sources / built) if built else find_package(library)


def add_licenses(tree, sources):
    """Fills the folder licenses of the .dist-info folder of an unpacked wheel.

    It gets the copyright file of each source package, and bundled.txt: each library with its source
    package, version and license. Exits if LICENSES does not name a package.
    """
    folder = next(tree.glob("*.dist-info")) / "licenses"
    folder.mkdir(exist_ok=True)
    origins = [(f"headers of {package}", *describe(package)) for package in HEADERS]
    for path in (tree / "vtkhelios/lib").iterdir():
        origins.append((path.name, *find_origin(_HASH.sub("", path.name), sources)))
    root = pathlib.Path(__file__).resolve().parents[2]
    shutil.copyfile(root / "Filters/IO/LASzip/COPYING.txt", folder / "laszip.txt")
    rows = [f"{'sources of LASzip':48} {'laszip':18} {'3.5.1, of PyPI':36} Apache-2.0"]
    for name, source, version, copyright_file in sorted(origins):
        if source not in LICENSES:
            sys.exit(f"{__file__}: {name} is from {source}, which LICENSES does not name; add it")
        shutil.copyfile(copyright_file, folder / f"{source}.txt")
        rows.append(f"{name:48} {source:18} {version:36} {LICENSES[source]}")
    (folder / "bundled.txt").write_text(
        "What this wheel bundles: file, source package of Debian 12 and its version, license.\n"
        "SOURCE.txt has the copyright notices.\n\n" + "\n".join(rows) + "\n"
    )
