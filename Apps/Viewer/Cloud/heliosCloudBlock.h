// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rows of points as they are appended to a cloud.

#ifndef heliosCloudBlock_h
#define heliosCloudBlock_h

#include "heliosCloudColumn.h"

#include <vtkType.h>

#include <cmath>
#include <cstdint>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace helios::viewer
{

/// The columns of some rows of a block as doubles; empty: missing.
struct CloudBlock
{
  vtkIdType Begin;
  vtkIdType End;
  std::vector<double> Xyz;
  std::vector<double> Columns[NumberOfCloudColumns];

  CloudBlock(vtkPolyData* echoes, vtkIdType begin, vtkIdType end);

  /// Reads a column of an array with that many rows; null, or another size: none.
  void Read(CloudColumn column, vtkDataArray* array, vtkIdType rows);

  bool Has(CloudColumn column) const { return !this->Columns[static_cast<int>(column)].empty(); }

  double Get(CloudColumn column, vtkIdType row, double missing) const
  {
    const std::vector<double>& values = this->Columns[static_cast<int>(column)];
    return values.empty() ? missing : values[static_cast<std::size_t>(row)];
  }

  int GetId(CloudColumn column, vtkIdType row) const
  {
    return static_cast<int>(this->Get(column, row, -1.0));
  }

  bool IsFinite(vtkIdType row) const
  {
    const double* p = this->Xyz.data() + 3 * row;
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  }

  vtkIdType GetSize() const { return static_cast<vtkIdType>(this->Xyz.size()) / 3; }

  /// Returns whether a row's pulse can be stored as an offset from a base.
  bool IsNear(vtkIdType row, std::int64_t base) const
  {
    const double pulse = this->Get(CloudColumn::Pulse, row, -1.0);
    return pulse < 0.0 || std::abs(pulse - static_cast<double>(base)) < 2147483647.0;
  }

private:
  void ReadColors(vtkDataArray* array, vtkIdType rows);
};

} // namespace helios::viewer

#endif
