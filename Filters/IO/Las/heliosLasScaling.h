// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The scale and the offset of coordinates in a LAS file.

#ifndef heliosLasScaling_h
#define heliosLasScaling_h

#include "heliosLasBlock.h"

class vtkPolyData;

namespace helios
{

class CoordinateSystem;

/// The step of metres.
constexpr double DefaultLasScale = 1e-4;

/**
 * Chooses both from the first block of a file. The offset is the first point in whole units, or
 * thousandths of degrees, which is independent of the block size. The scale:
 * - of points as a file had them (field data CoordinateScale with offsets): scale and offset of the
 *   file;
 * - DefaultLasScale: by the system and the axis, and no coarser than the scale of a file the points
 *   are from; of degrees as fine as eight times the extent of the block allows;
 * - 0: the finest power of ten, from 1e-6 up, that can hold eight times the extent of the block;
 * - else as given.
 */
void ChooseLasScaling(
  vtkPolyData* points, const CoordinateSystem& system, double scale, LasScaling& scaling);

} // namespace helios

#endif
