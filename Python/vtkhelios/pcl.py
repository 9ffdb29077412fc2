# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds of the Point Cloud Library (PCL) as numpy arrays without a copy.

>>> from vtkhelios import pcl
>>> cloud = pcl.CloudEcho.from_polydata(echoes)     # float, relative to cloud.origin
>>> cloud.points[:, 2].max(), cloud["GpsTime"][0]   # views of PCL's memory
>>> again = cloud.to_polydata()                     # double, the origin added

Views keep their memory alive: the cloud may be deleted first. The PCL filters are VTK algorithms:
vtkHeliosPCLOutlierRemoval, vtkHeliosPCLVoxelGrid, vtkHeliosPCLNormals, vtkHeliosPCLGroundFilter,
vtkHeliosPCLClusters, vtkHeliosPCLPlanes, vtkHeliosPCLRegistration.
"""

try:
    from ._pcl import CloudEcho, CloudXYZ, CloudXYZI, CloudXYZINormal
except ImportError as error:
    raise ImportError(
        f"vtkhelios was built without PCL or pybind11 ({error}); install libpcl-dev and "
        "pybind11-dev, and build again with VTKHELIOS_ENABLE_PCL=ON"
    ) from error

__all__ = ["CloudEcho", "CloudXYZ", "CloudXYZI", "CloudXYZINormal"]
