// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The sub-rays of a beam.

#ifndef heliosBeamPreparation_h
#define heliosBeamPreparation_h

#include <vtkType.h>

class vtkHeliosBeamSampler;
struct vtkHeliosInstrumentData;

namespace helios
{

class Status;
struct BeamWidth;
struct ScanModel;

/// Checks that the divergence and the waist of a beam are possible.
Status CheckBeam(vtkHeliosBeamSampler* sampler);

/// Sets a model's beam to the sub-rays of its sampler; without a divergence to one ideal ray.
void PrepareFixedBeam(vtkHeliosBeamSampler* sampler, ScanModel& model);

/// Sets a model's beam to the visible parts and the sub-rays of its plan. Its receiver and plan must
/// be set. The divergence must be positive.
void PrepareAdaptiveBeam(vtkHeliosBeamSampler* sampler, ScanModel& model);

/**
 * Returns whether cone probes of a model's adaptive beams are worth their time: they find one
 * plane, or nothing, often enough. Tested with pulses spread over the whole scan, so that all its
 * pieces get the same result.
 */
bool FindsPlanes(const ScanModel& model, vtkIdType numberOfPulses);

/// Whether most beams that cone probes leave unresolved, of a sample, meet many triangles.
bool FindsCrowds(const ScanModel& model, vtkIdType numberOfPulses);

/// Returns the width of a beam, for its volume.
BeamWidth GetBeamWidth(vtkHeliosBeamSampler* sampler);

/// Prepares the light that is scattered more than once; the beam is prepared.
void PrepareScattering(
  const vtkHeliosInstrumentData& instrument, vtkHeliosBeamSampler* sampler, ScanModel& model);

} // namespace helios

#endif
