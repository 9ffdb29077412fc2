// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The echoes of many scans, joined to one array a quantity.

#ifndef heliosBatchEchoes_h
#define heliosBatchEchoes_h

#include "heliosStatus.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace helios
{

class BatchEchoes
{
public:
  /// Stores scans by number, with the arrays of these names; none: all arrays.
  BatchEchoes(vtkIdType scans, std::vector<std::string> names);

  /// Adds the echoes of a scan, without a copy; threads may add different scans. An error names an
  /// array that they do not have.
  Status Add(vtkIdType scan, vtkPolyData* echoes);

  /// Moves all echoes, in the order of the scans, to an output with the field array Offsets: where
  /// each scan begins, and the end.
  void Join(vtkPolyData* output);

private:
  using Arrays = std::vector<vtkSmartPointer<vtkDataArray>>; ///< the first one has the points

  std::vector<Arrays> Scans; ///< empty: no echoes
  std::vector<std::string> Names;
};

} // namespace helios

#endif
