// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Slow errors of a platform, kept from pulse to pulse.

#ifndef heliosDriftState_h
#define heliosDriftState_h

#include "heliosGaussMarkov.h"

namespace helios
{

/// State of the drift of the components of vtkHeliosPlatformNoise.
struct DriftState
{
  GaussMarkov::Cursor Components[6];
};

} // namespace helios

#endif
