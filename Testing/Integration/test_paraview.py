# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The proxies of the ParaView plugin follow the classes. Apps/ParaView/build.sh tries the plugin itself."""

import pathlib
import re
import runpy
import subprocess
import xml.etree.ElementTree as ET

PARAVIEW = pathlib.Path(__file__).resolve().parents[2] / "Apps/ParaView"
MAKER = runpy.run_path(str(PARAVIEW / "make_proxies.py"))


def read_proxies():
    """Every proxy with the name of its group, of the files as they are."""
    for path in MAKER["make_files"]():
        for group in ET.parse(path).getroot():
            for proxy in group:
                yield group.get("name"), proxy


def test_proxies_are_current():
    for path, text in MAKER["make_files"]().items():
        assert path.read_text() == text, "run build/venv/bin/python Apps/ParaView/make_proxies.py"


def test_files_are_those_that_are_built():
    listed = (PARAVIEW / "Plugin/CMakeLists.txt").read_text()
    names = re.search(r"SERVER_MANAGER_XML (.*)", listed)[1].split()
    assert sorted(names) == sorted(path.name for path in (PARAVIEW / "Plugin").glob("*.xml"))


def test_all_proxies_are_tried():
    tried = (PARAVIEW / "try_plugin.py").read_text()
    found = {proxy.get("name"): proxy.get("label").replace(" ", "") for _, proxy in read_proxies()}
    assert len(set(found.values())) == len(found) >= 12
    missing = {name for name, label in found.items() if name not in tried and label not in tried}
    assert missing == {"HeliosRunOptions", "HeliosRotatingMirror"}  # defaults of others


def test_every_property_has_help_and_a_class():
    for group, proxy in read_proxies():
        assert proxy.find("Documentation").text.strip(), proxy.get("name")
        for element in proxy:
            if element.tag.endswith("Property"):
                text = element.find("Documentation").text
                assert text and text[0].isupper(), (proxy.get("name"), element.get("name"))
                assert "nan" not in (element.get("default_values") or "")
        assert group in ("sources", "filters", "lidar_strategies")


def find(proxy_name, property_name):
    return next(
        element
        for _, proxy in read_proxies()
        for element in proxy
        if proxy.get("name") == proxy_name and element.get("name") == property_name
    )


def test_values_of_a_property():
    length = find("HeliosScanner", "PulseLength")
    assert length.get("label") == "Pulse Length" and length.get("default_values") == "4"
    assert "[ns]; " in length.find("Documentation").text
    assert "Valid range: [1e-3, 1e6]" in length.find("Documentation").text
    up = find("HeliosObjSceneReader", "UpAxis")
    assert [(e.get("text"), e.get("value")) for e in up.iter("Entry")] == [("y", "1"), ("z", "2")]
    assert find("HeliosRunOptions", "Seed").tag == "IdTypeVectorProperty"


def test_paraview_reads_defaults_as_32_bits():
    for _, proxy in read_proxies():
        for element in proxy:
            if element.tag in ("IntVectorProperty", "IdTypeVectorProperty"):
                values = [int(value) for value in element.get("default_values").split()]
                assert max(map(abs, values)) < 2**31, (proxy.get("name"), element.get("name"))


def test_script_is_valid():
    script = PARAVIEW / "build.sh"
    assert subprocess.run(["bash", "-n", script], check=False).returncode == 0
