// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Sub-rays of a beam that one continuous surface fills.

#ifndef heliosLayerSampler_h
#define heliosLayerSampler_h

#include "heliosConeLayer.h"
#include "heliosPose.h"
#include "vtkHeliosRay.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <cstddef>
#include <vector>

namespace helios
{

/**
 * Meets the few triangles of a layer with sub-rays, without a tree. One per thread: it owns scratch
 * memory.
 */
class VTKHELIOSSCANNERCORE_EXPORT LayerSampler
{
public:
  /// Sets the directions of sub-rays in the frame of a beam whose axis is y.
  explicit LayerSampler(const std::vector<Vec3>& directions);

  /// Turns the directions from the x and z of the frame of the beam, given in the world, to the
  /// frame of layers that follow. Without it they begin anywhere about the axis.
  void Align(const double frame[3][3], const Vec3& x, const Vec3& z);

  /// Sets the rays from an origin, and their hits.
  void Trace(
    const ConeLayer& layer, const double origin[3], vtkHeliosRay* rays, vtkHeliosHit* hits);

private:
  void Meet(const ConeLayer& layer);

  std::size_t Size; ///< number of the directions; they are padded to whole vectors
  // The directions (x, y, 1) about the axis z, and their lengths.
  std::vector<double> X, Y, Length;
  std::vector<double> BeamX, BeamY; ///< in the frame of the beam
  // Arrays of the current layer.
  std::vector<double> Inside;  ///< edge function of the nearest edge; negative: outside
  std::vector<double> Inverse; ///< inverse of the depth
  std::vector<double> Piece;   ///< its index
};

} // namespace helios

#endif
