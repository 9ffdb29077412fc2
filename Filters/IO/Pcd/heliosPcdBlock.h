// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A block of echoes as rows of a PCD file.

#ifndef heliosPcdBlock_h
#define heliosPcdBlock_h

#include "heliosPcdHeader.h"
#include "heliosStatus.h"

#include <vtkType.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace helios
{

class PcdBlock
{
public:
  /// Reads the arrays to be written.
  Status Set(vtkPolyData* echoes, bool isFloat);

  const std::vector<PcdField>& GetFields() const { return this->Fields; }
  bool HasAmplitude() const { return this->Amplitude; }

  /// The centre of the finite points, rounded to multiples of 100 m.
  void GetMiddle(double origin[3]) const;

  /// Appends formatted points to text; non-finite points are counted, not added.
  void Append(vtkIdType begin, vtkIdType end, const PcdHeader& header, std::string& text);

  vtkIdType GetNumberOfWritten() const { return this->NumberOfWritten; }
  vtkIdType GetNumberOfDropped() const { return this->NumberOfDropped; }
  /// The largest rounding error of a coordinate [m].
  double GetLargestError() const { return this->LargestError; }

private:
  void AddField(
    const std::string& name, vtkDataArray* array, int component, int count, bool isFloat);
  double RoundCoordinate(double value, double origin);
  template <typename SinkT>
  void AppendRow(vtkIdType point, const double place[3], SinkT& sink) const;

  struct Source
  {
    vtkDataArray* Array = nullptr; // null: x y z
    int Component = 0;             // first component
  };

  vtkPolyData* Echoes = nullptr;
  std::vector<PcdField> Fields;
  std::vector<Source> Sources; // per field
  bool IsFloat = true;
  bool Amplitude = false;
  vtkIdType NumberOfWritten = 0;
  vtkIdType NumberOfDropped = 0;
  double LargestError = 0.0;
};

} // namespace helios

#endif
