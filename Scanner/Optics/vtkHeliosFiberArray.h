// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosFiberArray
 * @brief   a row of fibres: lines of fixed directions, one fibre after the other
 *
 * The ends of N fibres are spaced evenly over the scan angle; fibre k points to
 * - a = -ScanAngle + 2 ScanAngle k / (N - 1)
 *
 * so that the first and the last reach both ends, and the row is symmetric; a
 * single fibre points straight ahead. Pulse i is emitted from fibre i mod N to
 * (0, cos a, sin a): PulseFrequency / N lines/s, regardless of the scan
 * frequency of the survey.
 *
 * @sa
 * vtkHeliosBeamDeflector vtkHeliosScanner
 */

#ifndef vtkHeliosFiberArray_h
#define vtkHeliosFiberArray_h

#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosScannerOpticsModule.h" // For export macro

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosFiberArray : public vtkHeliosBeamDeflector
{
public:
  static vtkHeliosFiberArray* New();
  vtkTypeMacro(vtkHeliosFiberArray, vtkHeliosBeamDeflector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the number of fibres N. Valid range: [1, 1000000]. Default: 128.
   */
  vtkSetClampMacro(NumberOfFibers, int, 1, 1000000);
  vtkGetMacro(NumberOfFibers, int);
  ///@}

  ///@{
  /**
   * Set/Get half the angle from the first fibre to the last [deg]. Valid range:
   * [0, 180]. Default: 10.
   */
  void SetScanAngle(double angle);
  vtkGetMacro(ScanAngle, double);
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;

  /**
   * Returns the angle a of the pulse's fibre [deg].
   */
  double GetScanAngle(vtkIdType pulse) const override;

  ///@{
  /**
   * Returns 1 for every pulse; the edge is the last fibre. A single fibre has neither.
   */
  int GetScanDirectionFlag(vtkIdType pulse) const override;
  bool IsEdgeOfFlightLine(vtkIdType pulse) const override;
  ///@}

protected:
  vtkHeliosFiberArray() = default;
  ~vtkHeliosFiberArray() override = default;

private:
  vtkHeliosFiberArray(const vtkHeliosFiberArray&) = delete;
  void operator=(const vtkHeliosFiberArray&) = delete;

  int NumberOfFibers = 128;
  double ScanAngle = 10.0;
};

#endif
