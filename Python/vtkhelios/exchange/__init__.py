# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds and meshes of other Python libraries.

Cloud.to_pandas(), Cloud.to_pyvista(), Cloud.to_open3d(), Scene.to_pyvista()
    objects of pandas, PyVista and Open3D that share the arrays where these libraries can.
Scene(mesh)
    meshes of PyVista, trimesh, Open3D, meshio, and of another VTK.

All pass numpy arrays, never pointers to VTK objects: the other library may have a VTK of its own.
"""

import importlib

__all__ = ["load"]


def load(name, packages=None):
    """Imports an optional library; ImportError with the command that installs it."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(
            f"{name} cannot be imported: {error}; pip install {packages or name}", name=name
        ) from error
