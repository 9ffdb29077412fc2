// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The sub-rays and the probe rays of a beam.

#ifndef heliosBeamPreparation_h
#define heliosBeamPreparation_h

#include <vtkType.h>

class vtkHeliosBeamSampler;

namespace helios
{

struct ScanModel;

/// Sets a model's beam to the sub-rays of its sampler; without a divergence to one ideal ray, which
/// needs no bins.
void PrepareFixedBeam(vtkHeliosBeamSampler* sampler, ScanModel& model);

/// Sets a model's beam to the sub-rays of its plan, and its probe rays. Its source, caster,
/// receiver and plan must be set. The divergence must be positive.
void PrepareBeamByTolerance(
  vtkHeliosBeamSampler* sampler, vtkIdType numberOfPulses, ScanModel& model);

} // namespace helios

#endif
