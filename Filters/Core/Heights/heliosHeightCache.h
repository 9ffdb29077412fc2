// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Height fields that are made once for all users of a raster.

#ifndef heliosHeightCache_h
#define heliosHeightCache_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <memory>

class vtkImageData;

namespace helios
{

class HeightField;

/**
 * Gets the height field of a raster, which must outlive it. It is kept with the array of the
 * heights, and made again if these or the geotransform have changed. Errors: see
 * HeightField::Set(). Thread-safe.
 */
VTKHELIOSFILTERSCORE_EXPORT Status GetHeightField(
  vtkImageData* raster, std::shared_ptr<const HeightField>& field);

} // namespace helios

#endif
