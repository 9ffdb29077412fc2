// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLPlanes
 * @brief   planes in a cloud, the largest first
 *
 * Input 0: a vtkPolyData with points. Output 0: the same, with
 * - the point array PlaneIds (int): from 0 in the order found; -1: no plane;
 * - field data, one row per plane: Plane.Coefficients (double, 4), a unit normal and d with a x + b
 *   y + c z + d = 0 in the coordinates of the points, c not negative; Plane.Centre (double, 3), the
 *   mean of its points; Plane.Deviation (double), the root mean square of their distances [m].
 *
 * Planes are found one after the other among the points not yet on one by random sample consensus
 * (pcl::SACSegmentation; M. A. Fischler, R. C. Bolles 1981), always with the same random numbers,
 * testing samples on 20,000 evenly taken points if there are more, until there are
 * MaximumNumberOfPlanes or the next one has fewer than MinimumNumberOfPoints. The coefficients then
 * describe the least squares plane of its points, in double: for n points with noise s along the
 * normal, spread by u across it, the standard deviation of the angle is s / (u sqrt(n)). Far from
 * 0, use Plane.Centre with the normal: d has the rounding of large numbers.
 *
 * @sa
 * vtkHeliosPCLFilter
 */

#ifndef vtkHeliosPCLPlanes_h
#define vtkHeliosPCLPlanes_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro
#include "vtkHeliosPCLFilter.h"

class VTKHELIOSFILTERSPCL_EXPORT vtkHeliosPCLPlanes : public vtkHeliosPCLFilter
{
public:
  static vtkHeliosPCLPlanes* New();
  vtkTypeMacro(vtkHeliosPCLPlanes, vtkHeliosPCLFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the maximum distance of points from their plane: three standard deviations of the noise
   * [m]. Valid range: [1e-6, 1000]. Default: 0.05.
   */
  vtkSetClampMacro(DistanceThreshold, double, 1e-6, 1000.0);
  vtkGetMacro(DistanceThreshold, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of planes. Valid range: [1, 10000]. Default: 8.
   */
  vtkSetClampMacro(MaximumNumberOfPlanes, int, 1, 10000);
  vtkGetMacro(MaximumNumberOfPlanes, int);
  ///@}

  ///@{
  /**
   * Set/Get the minimum number of points of a plane. Valid range: [3, 2147483647]. Default: 100.
   */
  vtkSetClampMacro(MinimumNumberOfPoints, int, 3, VTK_INT_MAX);
  vtkGetMacro(MinimumNumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of samples per plane, and the probability at which fewer are enough.
   * Valid range: [1, 10000000]; [0.5, 0.999999]. Default: 1000; 0.999.
   */
  vtkSetClampMacro(MaximumNumberOfIterations, int, 1, 10000000);
  vtkGetMacro(MaximumNumberOfIterations, int);
  vtkSetClampMacro(Probability, double, 0.5, 0.999999);
  vtkGetMacro(Probability, double);
  ///@}

  /**
   * Get the number of planes found in the last update.
   */
  vtkGetMacro(NumberOfPlanes, int);

protected:
  vtkHeliosPCLPlanes() = default;
  ~vtkHeliosPCLPlanes() override = default;

  bool CheckProperties() override;
  bool Process(helios::PclInput& input, vtkPolyData* output) override;

private:
  vtkHeliosPCLPlanes(const vtkHeliosPCLPlanes&) = delete;
  void operator=(const vtkHeliosPCLPlanes&) = delete;

  class Search;

  double DistanceThreshold = 0.05;
  int MaximumNumberOfPlanes = 8;
  int MinimumNumberOfPoints = 100;
  int MaximumNumberOfIterations = 1000;
  double Probability = 0.999;
  int NumberOfPlanes = 0;
};

#endif
