// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The fields of PCD files as arrays, point by point.

#ifndef heliosPcdArrays_h
#define heliosPcdArrays_h

#include "heliosPcdHeader.h"

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
  /// Room for all points of a file.
  explicit PcdArrays(const PcdHeader& header);
  ~PcdArrays();

  ///@{
  /// Adds a point, of the bytes of its row or of a line; of a line what is wrong, or an empty text.
  /// Points that are not finite are counted, not added. A line's x y z are double whatever the
  /// header says.
  void AddRow(const char* row);
  std::string AddLine(std::string_view line);
  ///@}

  vtkIdType GetNumberOfRows() const { return this->Row + this->NumberOfDropped; }
  vtkIdType GetNumberOfDropped() const { return this->NumberOfDropped; }

  void MoveTo(vtkPolyData* output);

private:
  /// Where the bytes of a field go: into an array, from a byte of its tuple on.
  struct Column
  {
    vtkDataArray* Array = nullptr; // null: one of x y z, or padding
    int Axis = -1;                 // of x y z
    std::size_t From = 0;          // in the row
    std::size_t To = 0;            // in the tuple
    std::size_t TupleSize = 0;
  };

  Column MakeColumn(const PcdField& field);
  vtkDataArray* AddArray(const PcdField& field, const std::string& name, int components);
  std::string FindName(const std::string& field) const;
  bool HasNormals() const;
  void Append(const char* row, const double point[3]);

  const PcdHeader& Header;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  std::vector<Column> Columns; // by field
  vtkDataArray* Normals = nullptr;
  vtkSmartPointer<vtkDoubleArray> Points;
  vtkIdType Row = 0;
  vtkIdType NumberOfDropped = 0;
  std::vector<char> Bytes; // of a line
};

} // namespace helios

#endif
