// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLOutlierRemoval
 * @brief   takes out points that lie apart
 *
 * Input 0: a vtkPolyData with points. Output 0: those whose mean distance from their
 * NumberOfNeighbors nearest points is at most the mean of all points' plus
 * StandardDeviations times its standard deviation (pcl::StatisticalOutlierRemoval; R. B.
 * Rusu et al. 2008, Towards 3D point cloud based object maps). Points, point arrays and
 * field data as vtkHeliosPCLFilter says.
 *
 * @warning
 * The threshold is one for all: where the density varies much, as in a scan from a tripod,
 * the sparse part counts as outliers first. Use more StandardDeviations there.
 *
 * @sa
 * vtkHeliosPCLFilter
 */

#ifndef vtkHeliosPCLOutlierRemoval_h
#define vtkHeliosPCLOutlierRemoval_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro
#include "vtkHeliosPCLFilter.h"

class VTKHELIOSFILTERSPCL_EXPORT vtkHeliosPCLOutlierRemoval : public vtkHeliosPCLFilter
{
public:
  static vtkHeliosPCLOutlierRemoval* New();
  vtkTypeMacro(vtkHeliosPCLOutlierRemoval, vtkHeliosPCLFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how many nearest points the distance is the mean of; all others where there are fewer.
   * Valid range: [1, 1000]. Default: 16.
   */
  vtkSetClampMacro(NumberOfNeighbors, int, 1, 1000);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Set/Get the standard deviations above the mean from which on a point is an outlier. Valid
   * range: [0, 1000]. Default: 2.
   */
  vtkSetClampMacro(StandardDeviations, double, 0.0, 1000.0);
  vtkGetMacro(StandardDeviations, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the outliers come out, and not the others. Default: off.
   */
  vtkSetMacro(SelectOutliers, bool);
  vtkGetMacro(SelectOutliers, bool);
  vtkBooleanMacro(SelectOutliers, bool);
  ///@}

protected:
  vtkHeliosPCLOutlierRemoval() = default;
  ~vtkHeliosPCLOutlierRemoval() override = default;

  bool Process(helios::PclInput& input, vtkPolyData* output) override;

private:
  vtkHeliosPCLOutlierRemoval(const vtkHeliosPCLOutlierRemoval&) = delete;
  void operator=(const vtkHeliosPCLOutlierRemoval&) = delete;

  int NumberOfNeighbors = 16;
  double StandardDeviations = 2.0;
  bool SelectOutliers = false;
};

#endif
