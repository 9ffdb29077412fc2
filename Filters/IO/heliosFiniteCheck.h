// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Values that are not finite, which readers of points keep and warn of.

#ifndef heliosFiniteCheck_h
#define heliosFiniteCheck_h

#include <vtkType.h>

#include <string>
#include <utility>
#include <vector>

class vtkFieldData;

namespace helios
{

/// The names of arrays of real numbers that are not finite somewhere, and in how many tuples.
std::vector<std::pair<std::string, vtkIdType>> CountNotFinite(vtkFieldData* data);

} // namespace helios

#endif
