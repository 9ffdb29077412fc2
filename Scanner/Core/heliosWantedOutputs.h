// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a scan computes besides echoes: what nobody requests is not computed.

#ifndef heliosWantedOutputs_h
#define heliosWantedOutputs_h

namespace helios
{

struct WantedOutputs
{
  static constexpr int NumberOfPorts = 4; // echoes, waveforms, pulses, hits of sub-rays

  // output ports
  bool Waveforms = false;
  bool Pulses = false;
  bool SubRays = false; ///< their hits

  // arrays of the echoes
  bool Truth = false;
  bool ScanFlags = false;
  bool Columns = false; ///< of the pulses, too
  bool Decibels = false;
  bool Colors = false;

  /// Whether an output port of the scanner has data.
  bool HasPort(int port) const
  {
    const bool ports[NumberOfPorts] = { true, this->Waveforms, this->Pulses, this->SubRays };
    return ports[port];
  }
};

} // namespace helios

#endif
