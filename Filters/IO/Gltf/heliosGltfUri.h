// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The bytes that a URI of a glTF document names.

#ifndef heliosGltfUri_h
#define heliosGltfUri_h

#include "heliosStatus.h"

#include <string>

namespace helios
{

/// Reads a data URI in base64, or a file whose percent-encoded name is relative to a document.
Status ReadUri(const std::string& uri, const std::string& document, std::string& bytes);

} // namespace helios

#endif
