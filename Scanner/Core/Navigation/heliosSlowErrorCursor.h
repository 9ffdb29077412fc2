// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Slow errors of a platform, kept from pulse to pulse.

#ifndef heliosSlowErrorCursor_h
#define heliosSlowErrorCursor_h

#include "heliosGaussMarkov.h"

namespace helios
{

/// Of the components of vtkHeliosPlatformNoise.
struct SlowErrorCursor
{
  GaussMarkov::Cursor Components[6];
};

} // namespace helios

#endif
