// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C and SIGTERM end the viewer at once, with one line.

#ifndef heliosSignals_h
#define heliosSignals_h

#include <string>

namespace helios::viewer
{

/// Makes SIGINT and SIGTERM end the process with exit code 130 or 143.
void EndOnSignals();

/// Sets whether a file is being written, which a signal then removes.
void SetUnfinished(const std::string& file, bool isUnfinished);

} // namespace helios::viewer

#endif
