// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The fields of PCD files as arrays, filled point by point.

#ifndef heliosPcdArrays_h
#define heliosPcdArrays_h

#include "heliosPcdHeader.h"
#include "heliosPcdNames.h"
#include "heliosStatus.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <string_view>
#include <vector>

class vtkDataArray;
class vtkDoubleArray;
class vtkPolyData;

namespace helios
{

class PcdArrays
{
public:
  /// Allocates arrays for all points of a file.
  explicit PcdArrays(const PcdHeader& header);
  ~PcdArrays();

  ///@{
  /// Adds a point from the bytes of its row, or from a line; for a line returns an error.
  /// Non-finite points are counted, not added. x y z of a line are double whatever the header
  /// states.
  void AddRow(const char* row);
  Status AddLine(std::string_view line);
  ///@}

  vtkIdType GetNumberOfRows() const { return this->Row + this->NumberOfDropped; }
  vtkIdType GetNumberOfDropped() const { return this->NumberOfDropped; }
  /// Returns the number of points whose colour has an alpha other than 0 and 255.
  vtkIdType GetNumberOfTransparent() const { return this->NumberOfTransparent; }

  void MoveTo(vtkPolyData* output);

private:
  /// Destination of a field: an array and a byte offset in its tuple.
  struct Column
  {
    vtkDataArray* Array = nullptr; // null: one of x y z, or not read
    PcdMeaning Meaning = PcdMeaning::Array;
    int Axis = -1;        // 0 to 2: x, y, z
    std::size_t From = 0; // offset in the row
    std::size_t To = 0;   // offset in the tuple
    std::size_t TupleSize = 0;
  };

  Column MakeColumn(const PcdField& field);
  vtkDataArray* AddArray(int type, const std::string& name, int components);
  std::string GetArrayName(const PcdField& field, PcdMeaning meaning) const;
  void Append(const char* row, const double point[3]);
  void StoreColor(const Column& column, const char* from);
  void StoreWhole(const Column& column, const char* from, int size) const;

  const PcdHeader& Header;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  std::vector<Column> Columns; // per field
  vtkDataArray* Normals = nullptr;
  vtkSmartPointer<vtkDoubleArray> Points;
  vtkIdType Row = 0;
  vtkIdType NumberOfDropped = 0;
  vtkIdType NumberOfTransparent = 0;
  bool HasNoColor = false; // the line's colour is nan
  std::vector<char> Bytes; // bytes of a line
};

} // namespace helios

#endif
