// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The box of a triangle in few bytes, while a tree is built. For sources only, as heliosBoxSplit.h.

#ifndef heliosCoarseBox_h
#define heliosCoarseBox_h

#include "heliosBoxSplit.h"

#include <vtkType.h>

#include <cstring>

namespace helios
{

/// The box of a triangle, in 65535 steps along each side of the box of the tree.
struct CoarseBox
{
  vtkTypeUInt16 Values[8]; ///< low along the axes, high along the axes, the triangle

  vtkTypeInt32 GetTriangle() const
  {
    vtkTypeInt32 triangle;
    std::memcpy(&triangle, this->Values + 6, sizeof(triangle));
    return triangle;
  }

  HELIOS_INLINE Floats GetLow() const { return Get(this->Values); }
  HELIOS_INLINE Floats GetHigh() const { return Get(this->Values + 3); }

private:
  static HELIOS_INLINE Floats Get(const vtkTypeUInt16* from)
  {
    typedef vtkTypeUInt16 Shorts __attribute__((vector_size(8)));
    return __builtin_convertvector(__builtin_convertvector(Load<Shorts>(from), ShortMasks), Floats);
  }
};

} // namespace helios

#endif
