// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes of the rasters of tests.

#ifndef heliosRasterScenes_h
#define heliosRasterScenes_h

#include "heliosRasterMesh.h"
#include "heliosTestRasters.h"

#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

namespace helios
{

/// The mesh that vtkHeliosGeoTiffSceneReader makes of a raster.
inline vtkSmartPointer<vtkPolyData> MakeMesh(const HeightRaster& raster)
{
  RasterMesh<vtkTypeInt32Array> mesh(raster.Columns, raster.Transform.data());
  for (int row = 0; row < raster.Rows; ++row)
  {
    mesh.AddRow(raster.Values.data() + static_cast<std::ptrdiff_t>(row) * raster.Columns);
  }
  mesh.Finish();
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  mesh.MoveTo(scene);
  return scene;
}

} // namespace helios

#endif
