// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The file of the names of parts and materials beside a file of points, see vtkHeliosPointNames.

#ifndef heliosPointNames_h
#define heliosPointNames_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <vtkType.h>

#include <string>

class vtkFieldData;

namespace helios
{

/// Returns the file of the names of a file of points.
std::string GetPointNamesFile(const std::string& pointFile);

/// Returns the number of names of parts and materials in field data.
vtkIdType CountPointNames(vtkFieldData* fields);

/// Adds the names of a file with this number of points to field data; without a file, none. Returns an
/// error for a file that is damaged or belongs to another number of points.
Status ReadPointNames(const std::string& pointFile, vtkIdType points, vtkFieldData* fields);

/// Checks that the file of names was not changed since vtkHelios wrote it. A missing file and one
/// without a checksum, as users write it, are not changed.
VTKHELIOSFILTERSIO_EXPORT Status CheckPointNamesUnchanged(const std::string& pointFile);

/// Checks that the file of names can be written: no file of another program has its name.
Status CheckPointNames(const std::string& pointFile);

/// Writes the names in field data, after CheckPointNames(); without names, removes the file of names
/// of an earlier file of points.
Status WritePointNames(const std::string& pointFile, vtkIdType points, vtkFieldData* fields);

} // namespace helios

#endif
