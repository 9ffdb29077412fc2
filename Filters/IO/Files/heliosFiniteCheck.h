// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts non-finite values, which point readers keep and warn about.

#ifndef heliosFiniteCheck_h
#define heliosFiniteCheck_h

#include <vtkType.h>

#include <string>
#include <utility>
#include <vector>

class vtkFieldData;

namespace helios
{

/// Names of the real arrays with non-finite values, and the number of tuples affected.
std::vector<std::pair<std::string, vtkIdType>> CountNotFinite(vtkFieldData* data);

} // namespace helios

#endif
