// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays in a temporary file, for data that are larger than the memory.

#ifndef heliosScratchArray_h
#define heliosScratchArray_h

#include "heliosStatus.h"

#include <cstddef>

class vtkDataArray;

namespace helios
{

/**
 * Sets the values of an array to a mapping of a new file without a name, zeros, which is gone with
 * the array. The system reads its pages when they are used, and drops those used least recently when
 * memory is short. The file is in the folder TMPDIR, default /var/tmp. Errors: no such folder, or
 * not enough room in it.
 */
Status MapScratchFile(vtkDataArray* array, std::size_t count);

} // namespace helios

#endif
