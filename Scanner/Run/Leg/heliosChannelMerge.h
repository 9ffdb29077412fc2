// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Merges the records of simultaneous channels into the records of one scanner.

#ifndef heliosChannelMerge_h
#define heliosChannelMerge_h

#include <vtkSmartPointer.h>

#include <vector>

class vtkDataObject;

namespace helios
{

/**
 * Merges the echoes, pulses or waveforms of all channels in pulse order, whatever the block size.
 * Each channel is in that order already. Field arrays come from the first; Samples of waveforms are
 * concatenated.
 */
vtkSmartPointer<vtkDataObject> MergeChannels(const std::vector<vtkDataObject*>& channels);

} // namespace helios

#endif
