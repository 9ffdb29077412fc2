// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The orientation that cameras store beside the pixels.

#ifndef heliosExif_h
#define heliosExif_h

#include <string_view>

namespace helios
{

/// Finds the orientation, 1 to 8, in an APP1 segment of JPEG; 0: it has none.
int FindExifOrientation(std::string_view segment);

} // namespace helios

#endif
