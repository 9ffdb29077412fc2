// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Zones of multiple-time-around ranges: echoes that arrive after later pulses were emitted.

#ifndef heliosRangeZones_h
#define heliosRangeZones_h

#include <vtkType.h>

class vtkHeliosBeamDeflector;

namespace helios
{

/**
 * Which pulse an instrument takes an echo for. Zone z holds the ranges from z - 1 to z times
 * c / 2 f, with the pulse frequency f of a channel; the pulses of a channel are equally far apart.
 */
struct RangeZones
{
  /// zone that echoes are assigned to, from 1; 0: the true pulses are known
  int Zone = 0;
  vtkIdType Stride = 1;         ///< from a pulse to the next one of the channel
  double Depth = 0.0;           ///< depth of a zone [m]
  vtkIdType NumberOfPulses = 0; ///< number of pulses of the scan, emitted or not

  /// Returns the number of pulses of the channel from the true one of an echo to the one it is
  /// assigned to.
  vtkIdType GetStep(double range) const;
};

/// Returns the zones of a scan by a deflector.
RangeZones MakeRangeZones(vtkHeliosBeamDeflector& deflector, int zone, vtkIdType numberOfPulses);

} // namespace helios

#endif
