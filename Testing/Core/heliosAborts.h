// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How the executive of this VTK treats aborted algorithms.

#ifndef heliosAborts_h
#define heliosAborts_h

#include <vtkVersionMacros.h>

namespace helios
{

/// Reports of a progress of 1 after an algorithm was aborted: since VTK 9.3 one, by the executive. An
/// aborted algorithm also stays so since then, until SetAbortExecute(0).
inline constexpr int ReportsAfterAbort = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0) ? 1 : 0;

} // namespace helios

#endif
