// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGeoTiffSceneReader
 * @brief   a height raster as a mesh of triangles
 */

#ifndef vtkHeliosGeoTiffSceneReader_h
#define vtkHeliosGeoTiffSceneReader_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosGeoTiffSceneReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosGeoTiffSceneReader* New();
  vtkTypeMacro(vtkHeliosGeoTiffSceneReader, vtkPolyDataAlgorithm);

protected:
  vtkHeliosGeoTiffSceneReader() = default;
  ~vtkHeliosGeoTiffSceneReader() override = default;

private:
  vtkHeliosGeoTiffSceneReader(const vtkHeliosGeoTiffSceneReader&) = delete;
  void operator=(const vtkHeliosGeoTiffSceneReader&) = delete;
};

#endif
