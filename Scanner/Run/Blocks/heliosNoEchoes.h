// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Explains why a run has no echo.

#ifndef heliosNoEchoes_h
#define heliosNoEchoes_h

#include <string>

namespace helios
{

class LegRunner;

/// Explains why a run has no echo, and how to fix it.
std::string ExplainNoEchoes(const LegRunner& runner);

} // namespace helios

#endif
