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
  /// Types of the numbers of a file.
  struct Types
  {
    bool HasFloatPoints = true; ///< x y z
    bool HasFloats = true;      ///< the other fields that are float in PCL
    bool IsText = false;
    bool HasFullColors = false; ///< also RGB as it is, which PCL ignores
  };

  /// Reads the arrays to be written.
  Status Set(vtkPolyData* echoes, const Types& types);

  const std::vector<PcdField>& GetFields() const { return this->Fields; }
  bool HasAmplitude() const { return this->Amplitude; }
  bool HasWholeIntensity() const { return this->WholeIntensity; }
  bool HasFineColors() const { return this->FineColors; }

  /// Returns whether an array has colours that 8 bits cannot store.
  static bool IsFiner(vtkDataArray* colors);

  /// Computes the centre of the finite points, rounded to multiples of 100 m.
  void GetMiddle(double origin[3]) const;

  /// Returns the largest rounding error of a coordinate as float relative to an origin.
  double FindLargestError(const double origin[3]) const;

  /// Appends formatted points to text; non-finite points are counted, not added.
  void Append(vtkIdType begin, vtkIdType end, const PcdHeader& header, std::string& text);

  vtkIdType GetNumberOfWritten() const { return this->NumberOfWritten; }
  vtkIdType GetNumberOfDropped() const { return this->NumberOfDropped; }
  /// Returns the largest rounding error of a coordinate so far.
  double GetLargestError() const { return this->LargestError; }

private:
  /// How the values of an array are stored.
  enum class Encoding
  {
    Plain,
    Float, ///< stored as float
    Color, ///< packed as PCL does
    Label  ///< the bits of an int
  };

  void AddField(const std::string& name, vtkDataArray* array, int component, int count);
  void AddPclField(
    const std::string& name, vtkDataArray* array, int component, Encoding encoding, char type);
  void AddArray(vtkDataArray* array, const Types& types);
  void AddColors(vtkDataArray* array, const Types& types);
  Status CheckNames() const;
  double RoundCoordinate(double value, double origin);
  template <typename SinkT>
  void AppendRow(vtkIdType point, const double place[3], SinkT& sink) const;

  struct Source
  {
    vtkDataArray* Array = nullptr; // null: x y z
    int Component = 0;             // first component
    Encoding Stored = Encoding::Plain;
  };

  vtkPolyData* Echoes = nullptr;
  std::vector<PcdField> Fields;
  std::vector<Source> Sources; // per field
  bool HasFloatPoints = true;
  bool HasFloats = true;
  bool Amplitude = false;
  bool WholeIntensity = false;
  bool FineColors = false;
  vtkIdType NumberOfWritten = 0;
  vtkIdType NumberOfDropped = 0;
  double LargestError = 0.0;
};

} // namespace helios

#endif
