// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The sub-rays that a beam is made of, or looked at with.

#ifndef heliosBeamPreparation_h
#define heliosBeamPreparation_h

#include <vtkType.h>

class vtkHeliosBeamSampler;

namespace helios
{

struct ScanModel;

/// A model's beam is the sub-rays of its sampler; one ideal ray without a divergence, which needs no bins.
void PrepareFixedBeam(vtkHeliosBeamSampler* sampler, ScanModel& model);

/// A model's beam is as many sub-rays as its plan says, and what looks whether they are needed.
/// Its source, caster, receiver and plan must be set. The divergence must be positive.
void PrepareBeamByTolerance(
  vtkHeliosBeamSampler* sampler, vtkIdType numberOfPulses, ScanModel& model);

} // namespace helios

#endif
