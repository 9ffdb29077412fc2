# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Optional packages of Python: what each is for, how it is installed, and why one cannot be imported.

The advice keeps the numpy that is there: packages of the system are built for it.
"""

import importlib
import importlib.metadata
import importlib.util
import pathlib
import sys
import sysconfig
import typing


class Package(typing.NamedTuple):
    """A package that something needs; a wheel does not depend on it."""

    use: str  # its use
    pip: str  # arguments of pip install
    needs_numpy: bool = False  # whether pip may bring another numpy
    apt: str = ""  # package of Debian

    @property
    def command(self):
        """The command, or two, that install it."""
        keep = f" {numpy_limit()}" if self.needs_numpy else ""
        command = f"{pip_install()} {self.pip}{keep}"
        return f"apt-get install {self.apt}, or {command}" if self.apt else command


PYVISTA = "--no-deps pyvista==0.36.1 'scooby<1' 'appdirs<2'"  # without a VTK of its own
PACKAGES = {
    "laspy": Package("records of LAS and LAZ files that are copied", "--no-deps laspy"),
    "pye57": Package("E57 files", "--no-deps pye57 pyquaternion"),
    "matplotlib": Package(
        "pages and pictures of reports", "matplotlib", True, "python3-matplotlib"
    ),
    "jinja2": Package("pages of reports", "jinja2", False, "python3-jinja2"),
    "rich": Package("the line of progress", "rich", False, "python3-rich"),
    "pandas": Package("Cloud.to_pandas()", "pandas", True, "python3-pandas"),
    "pyvista": Package("Cloud.to_pyvista()", PYVISTA),
    "open3d": Package("Cloud.to_open3d()", "open3d", True),
    "dask": Package("surveys on a cluster", "dask distributed"),
    "distributed": Package("surveys on a cluster", "dask distributed"),
    "mcap": Package("vtkhelios export --mcap and --rosbag", "mcap rosbags", True),
    "rosbags": Package("vtkhelios export --mcap and --rosbag", "mcap rosbags", True),
    "torch": Package("data sets of PyTorch of vtkhelios.learning", "torch", True),
}


def pip_install():
    """The command without its packages; of the system's Python one that the system allows.

    pip refuses to change a Python that packages of the system belong to, unless it is told twice:
    to leave that alone (--user), and to do it (PEP 668).
    """
    is_system = sys.prefix == sys.base_prefix
    marker = pathlib.Path(sysconfig.get_path("stdlib"), "EXTERNALLY-MANAGED")
    if not (is_system and marker.is_file()):
        return "pip install"
    first = "" if importlib.util.find_spec("pip") else "apt-get install python3-pip, then "
    return f"{first}pip install --user --break-system-packages"


def numpy_limit():
    """Returns the requirement that keeps the major version of the numpy that is installed."""
    try:
        major = int(importlib.metadata.version("numpy").split(".")[0])
    except importlib.metadata.PackageNotFoundError:
        major = 1
    return f"'numpy<{major + 1}'"


def advise(name):
    """Returns the command that installs a package."""
    return PACKAGES[name].command


def explain(name, error):
    """Why a package cannot be imported, and the cure: it is missing, or the error of its import."""
    missing = isinstance(error, ModuleNotFoundError) and (error.name or "").split(".")[0] == name
    if missing or importlib.util.find_spec(name) is None:
        return f"the package {name}, which is not installed: {advise(name)}"
    reason = " ".join(str(error).split())[:300]
    cure = f"install it again: {advise(name)}"
    if "numpy" in reason.lower():
        cure = f"give it the numpy that it is built for: {pip_install()} {numpy_limit()}"
    return f"the package {name}, which is installed but cannot be imported: {reason}; {cure}"


def load(name, what, module=None):
    """Imports an optional package, or a module of it; ImportError says what needs it and the cure."""
    try:
        return importlib.import_module(module or name)
    except ImportError as error:
        raise ImportError(f"{what} {explain(name, error)}", name=name) from error
