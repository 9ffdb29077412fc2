// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The records of channels that fire at once, as those of one scanner.

#ifndef heliosChannelMerge_h
#define heliosChannelMerge_h

#include <vtkSmartPointer.h>

#include <vector>

class vtkDataObject;

namespace helios
{

/**
 * The echoes, pulses or waveforms of all channels in the order of their pulses, so that it does not
 * depend on how many came at a time. Each channel's are in that order already. Field arrays are those
 * of the first; of waveforms, Samples is that of all.
 */
vtkSmartPointer<vtkDataObject> MergeChannels(const std::vector<vtkDataObject*>& channels);

} // namespace helios

#endif
