# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios doctor, and the errors of packages that are missing or broken."""

import json
import sys

import pytest

from vtkhelios.cli import main
from vtkhelios.core import diagnosis, packages


def run_cli(capsys, *words):
    """Returns exit code, standard output and standard error."""
    code = main(list(words))
    return code, *capsys.readouterr()


def parts_of(report):
    return {part["name"]: part for part in diagnosis.all_parts(report)}


def fake(folder, monkeypatch, name, text):
    """A package that is found before any other of that name."""
    (folder / name).mkdir()
    (folder / name / "__init__.py").write_text(text)
    monkeypatch.syspath_prepend(folder)
    for module in [each for each in sys.modules if each.split(".")[0] == name]:
        monkeypatch.delitem(sys.modules, module)


def test_what_works_and_what_is_missing(capsys, tmp_path, monkeypatch):
    fake(tmp_path, monkeypatch, "open3d", "__version__ = '9.8.7'")
    monkeypatch.setitem(
        packages.PACKAGES, "no_such_package", packages.Package("nothing", "no-such-package", True)
    )
    code, out, err = run_cli(capsys, "doctor", "--json")
    parts = parts_of(json.loads(out))
    assert code == 0 and err == ""
    assert parts["open3d"]["state"] == "works" and parts["open3d"]["version"] == "9.8.7"
    assert parts["open3d"]["place"] == str(tmp_path / "open3d")
    assert (
        parts["numpy"]["state"] == parts["VTK"]["state"] == parts["vtkhelios"]["state"] == "works"
    )
    missing = parts["no_such_package"]
    assert missing["state"] == "missing" and missing["for"] == "nothing"
    assert missing["cure"] == f"pip install no-such-package {packages.numpy_limit()}"


def test_what_is_broken_is_an_error_with_its_reason(capsys, tmp_path, monkeypatch):
    only = {name: packages.PACKAGES[name] for name in ("matplotlib", "rich")}
    monkeypatch.setattr(packages, "PACKAGES", only)
    text = "raise ImportError('numpy.core.multiarray failed to import')"
    fake(tmp_path, monkeypatch, "matplotlib", text)
    code, out, err = run_cli(capsys, "doctor")
    assert code == 1 and "  broken   matplotlib" in out
    assert "error: matplotlib: the package matplotlib, which is installed but cannot be" in err
    assert (
        "numpy.core.multiarray failed to import; give it the numpy that it is built for: pip install "
        in err
    )


def test_advice_keeps_numpy():
    limit = packages.numpy_limit()
    assert limit in ("'numpy<2'", "'numpy<3'")
    for name in ("matplotlib", "pandas", "open3d", "mcap"):
        assert limit in packages.advise(name)
    for name in ("laspy", "pye57", "pyvista"):
        assert "--no-deps" in packages.advise(name)


@pytest.mark.parametrize(
    "text, message",
    [
        (
            "raise ImportError('numpy.core.multiarray failed to import')",
            "charts need the package matplotlib, which is installed but cannot be imported: "
            "numpy.core.multiarray failed to import; give it the numpy that it is built for: pip install",
        ),
        (
            "import no_such_module",
            "charts need the package matplotlib, which is installed but cannot be imported: No "
            "module named 'no_such_module'; install it again: apt-get install python3-matplotlib, or",
        ),
    ],
)
def test_the_error_of_an_import_is_the_real_one(text, message, tmp_path, monkeypatch):
    fake(tmp_path, monkeypatch, "matplotlib", text)
    with pytest.raises(ImportError) as caught:
        packages.load("matplotlib", "charts need")
    assert str(caught.value).startswith(message)


def test_a_missing_package_is_called_missing(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(
        ImportError, match="need the package matplotlib, which is not installed: apt-"
    ):
        packages.load("matplotlib", "charts need")


@pytest.mark.parametrize("pip", [True, False], ids=["pip", "without pip"])
def test_the_python_of_a_system_is_changed_as_it_allows(monkeypatch, tmp_path, pip):
    """PEP 668: pip refuses to install beside the packages of Debian, unless for a user who insists."""
    monkeypatch.setattr(packages.sysconfig, "get_path", lambda name: str(tmp_path))
    monkeypatch.setattr(packages.sys, "prefix", packages.sys.base_prefix)
    assert packages.advise("laspy") == "pip install --no-deps laspy"
    (tmp_path / "EXTERNALLY-MANAGED").touch()
    find_spec = packages.importlib.util.find_spec
    monkeypatch.setattr(
        packages.importlib.util, "find_spec", lambda name: pip if name == "pip" else find_spec(name)
    )
    first = "" if pip else "apt-get install python3-pip, then "
    told = f"{first}pip install --user --break-system-packages --no-deps laspy"
    assert packages.advise("laspy") == told
    monkeypatch.setattr(packages.sys, "prefix", str(tmp_path))
    assert packages.advise("laspy") == "pip install --no-deps laspy", "an environment is free"
