# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The document that a plan is made of: a file, or a scene in memory."""

import os
import pathlib

from ..core.classes import vtk_class
from ..core.folders import data_directory
from ..core.paths import from_vtk, to_vtk
from ..core.reading import look_up
from ..scenes.scene import Scene
from .kinds import SettingError

PLATFORM, SCANNER = "platforms.xml#tripod", "scanners.xml#vz400_class_tls"


def check_assets(assets):
    """Returns the folders as a list; raises SettingError for a missing one."""
    assets = [assets] if isinstance(assets, (str, os.PathLike)) else assets
    assets = [os.fspath(folder) for folder in assets]
    for folder in assets:
        if not pathlib.Path(folder).is_dir():
            raise SettingError("{0} {folder}: no such folder", "assets", folder=folder)
    return assets


def make_document(scene, assets):
    """Returns the file of a plan, None for a scene in memory, and its reader."""
    if hasattr(scene, "IsA") and scene.IsA("vtkHeliosPlannerReader"):
        return from_vtk(scene.GetFileName()) or None, scene
    document = vtk_class("vtkHeliosPlannerReader")()
    document.SetDefaultPlatform(to_vtk(data_directory() / "Assets" / PLATFORM))
    document.SetDefaultScanner(to_vtk(data_directory() / "Assets" / SCANNER))
    document.InstancesOn()
    if isinstance(scene, (str, os.PathLike)):
        look_up(document, os.fspath(scene), assets)
        return os.fspath(scene), document
    shipped = data_directory()
    for folder in (*assets, shipped, shipped / "Assets"):
        document.AddAssetDirectory(to_vtk(folder))
    document.SetInputDataObject(0, Scene(scene).polydata)
    return None, document
