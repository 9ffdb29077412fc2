// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLFilter
 * @brief   base class of the PCL filters
 *
 * Input 0: a vtkPolyData with points (double or float). Output 0: points of the input bit by bit,
 * in their order unless the class states otherwise, with all point arrays and the field data, and
 * the additions of the class; vertices, one per point, if the input has vertices, no other cells.
 * PCL receives the points as float, relative to the centre of their bounds: its result selects or
 * labels points, it does not replace them.
 *
 * Points that are not finite are dropped, with a warning that counts them. Without points the
 * output is empty. There is a warning if a coordinate is so far from the centre (8 km) that the
 * float error is 0.5 mm or more.
 *
 * Errors: a property out of range, a point array whose number of tuples is not the number of
 * points, more than 2^31 - 1 points, no memory, an abort. Progress is reported and AbortExecute
 * polled about ten times per second: PCL works in chunks, or in its own thread, which continues
 * detached if it cannot be stopped.
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
   * Get the number of points of the last input that were not finite.
   */
  vtkGetMacro(NumberOfDroppedPoints, vtkIdType);

protected:
  vtkHeliosPCLFilter() = default;
  ~vtkHeliosPCLFilter() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Checks the properties; false after an error.
  virtual bool CheckProperties() { return true; }

  /// Returns the step of the origin of the points [m].
  virtual double GetStep() const { return 1.0; }

  /// Fills the output from at least one point; false after an error.
  virtual bool Process(helios::PclInput& input, vtkPolyData* output) = 0;

  /// Reports progress; false, after an error, if the work must stop.
  bool GoOn(double progress);

private:
  vtkHeliosPCLFilter(const vtkHeliosPCLFilter&) = delete;
  void operator=(const vtkHeliosPCLFilter&) = delete;

  bool Run(vtkPolyData* input, vtkPolyData* output);

  vtkIdType NumberOfDroppedPoints = 0;
};

#endif
