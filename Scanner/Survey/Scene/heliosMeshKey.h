// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Which parts of a scene have the same mesh.

#ifndef heliosMeshKey_h
#define heliosMeshKey_h

#include <string>

namespace helios
{

struct PartData;

/// Returns the values that the triangles and materials of a mesh depend on before it is placed;
/// empty for other parts.
std::string GetMeshKey(const PartData& part);

} // namespace helios

#endif
