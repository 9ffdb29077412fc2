// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLFilter
 * @brief   what filters on PCL have in common
 *
 * Input 0: a vtkPolyData with points (double or float). Output 0: points of the input bit by bit,
 * in their order unless the class says otherwise, with all point arrays and the field data, and
 * what the class adds; vertices, one a point, where the input has vertices, no other cells. PCL
 * sees the points as float, relative to the middle of their bounds: its result selects points or
 * gives them numbers, it does not replace them.
 *
 * Points that are not finite are dropped, with a warning that counts them. Without points the output
 * is empty. Where a coordinate is so far from the middle (8 km) that float is 0.5 mm off or more,
 * there is a warning.
 *
 * Errors: a property out of range, a point array with another number of tuples than there are
 * points, more than 2^31 - 1 points, no memory, an abort. Progress is reported and AbortExecute looked
 * at some ten times a second: PCL works in chunks, or in a thread of its own that goes on alone where
 * it cannot be stopped.
 *
 * To add a filter: subclass and implement Process().
 */

#ifndef vtkHeliosPCLFilter_h
#define vtkHeliosPCLFilter_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

namespace helios
{
class PclInput;
}

class VTKHELIOSFILTERSPCL_EXPORT vtkHeliosPCLFilter : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkHeliosPCLFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Get how many points of the last input were not finite.
   */
  vtkGetMacro(NumberOfDroppedPoints, vtkIdType);

protected:
  vtkHeliosPCLFilter() = default;
  ~vtkHeliosPCLFilter() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// False after an error about a property.
  virtual bool CheckProperties() { return true; }

  /// The origin of the points is a whole multiple of this [m].
  virtual double GetStep() const { return 1.0; }

  /// Makes the output of at least one point; false after an error.
  virtual bool Process(helios::PclInput& input, vtkPolyData* output) = 0;

  /// Reports progress; false, after an error, where the work is to end.
  bool GoOn(double progress);

private:
  vtkHeliosPCLFilter(const vtkHeliosPCLFilter&) = delete;
  void operator=(const vtkHeliosPCLFilter&) = delete;

  bool Run(vtkPolyData* input, vtkPolyData* output);

  vtkIdType NumberOfDroppedPoints = 0;
};

#endif
