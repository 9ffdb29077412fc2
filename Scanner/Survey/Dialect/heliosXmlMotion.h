// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the motion of a part from its elements. Errors go to the messages of the document.

#ifndef heliosXmlMotion_h
#define heliosXmlMotion_h

#include "heliosMotionData.h"
#include "heliosXmlElement.h"

#include <vector>

namespace helios
{

struct PartData;

/// Reads the <dmotion> of a <part>, with its own steps and the steps of its <scene>.
MotionData ReadMotion(const XmlElement& part, const XmlElement& scene);

/// Checks that the parts that carry others exist, and that none carries itself.
void CheckMounts(const std::vector<PartData>& parts, Messages& log);

} // namespace helios

#endif
