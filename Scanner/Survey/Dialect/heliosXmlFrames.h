// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads how the mesh of a part deforms.

#ifndef heliosXmlFrames_h
#define heliosXmlFrames_h

namespace helios
{

class Assets;
class Messages;
struct PartData;
class XmlFilter;

/// Reads a filter frames of a part.
void ReadFrames(const XmlFilter& filter, Assets& files, PartData& part);

/// Checks the frames of a part whose filters were read, and sorts its files by their numbers.
void CheckFrames(PartData& part, Messages& log);

} // namespace helios

#endif
