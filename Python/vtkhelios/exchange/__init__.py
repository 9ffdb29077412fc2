# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds and meshes of other Python libraries.

Cloud.to_pandas(), Cloud.to_pyvista(), Cloud.to_open3d(), Scene.to_pyvista()
    objects of pandas, PyVista and Open3D that share the arrays where these libraries can.
Scene(mesh)
    meshes of PyVista, trimesh, Open3D, meshio, and of another VTK.

All pass numpy arrays, never pointers to VTK objects: the other library may have a VTK of its own.
"""

from ..core import packages

__all__ = ["load"]


def load(name, what):
    """Imports an optional library; ImportError says what needs it, and the command that installs it."""
    return packages.load(name.split(".")[0], what, name)
