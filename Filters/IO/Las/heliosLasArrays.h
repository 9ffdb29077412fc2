// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a LAS file as arrays of a point cloud.

#ifndef heliosLasArrays_h
#define heliosLasArrays_h

#include "heliosLasColors.h"
#include "heliosLasFormat.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace helios
{

class LasArrays
{
public:
  /// Allocates arrays for the points of a file.
  LasArrays(const LasHeader& header, const std::vector<LasExtra>& extras,
    const LasColorBits& colors, vtkIdType count);

  /// Decodes points from their bytes; first is the destination index.
  void Decode(const char* records, vtkIdType first, vtkIdType count);

  /// Moves the points and arrays to a cloud.
  void MoveTo(vtkPolyData* cloud);

  /// Returns notes on values that are not read, or read as another number: "its points have ...".
  const std::vector<std::string>& GetNotes() const { return this->Notes; }

private:
  /// Fills a range of array values from the bytes of points.
  using Fill = std::function<void(const char* records, vtkIdType first, vtkIdType count)>;

  template <typename ArrayT>
  typename ArrayT::ValueType* Add(const char* name, int components = 1);
  template <typename ArrayT, typename GetT>
  void AddField(const char* name, GetT get);
  void AddFields();
  void AddLongFields();
  void AddShortFields();
  void AddPoints();
  void AddColors(int place);
  void AddExtras(const std::vector<LasExtra>& extras);
  void AddExtra(const LasExtra& extra, int place);
  void AddNumbers(const LasExtra& extra, int place, double* values);
  void AddBytes(const LasExtra& extra, int place, vtkDataArray* array);

  LasHeader Header;
  LasPointForm Form;
  LasColorBits Colors;
  vtkIdType Count;
  vtkSmartPointer<vtkDataArray> Points;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  std::vector<Fill> Fills;
  std::vector<std::string> Notes;
};

} // namespace helios

#endif
