// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLOutlierRemoval
 * @brief   removes outliers
 *
 * Input 0: a vtkPolyData with points. Output 0: those whose mean distance to their
 * NumberOfNeighbors nearest points is at most the mean over all points plus StandardDeviations
 * times its standard deviation (pcl::StatisticalOutlierRemoval; R. B. Rusu et al. 2008, Towards 3D
 * point cloud based object maps). Points, point arrays and field data as in vtkHeliosPCLFilter.
 *
 * @warning
 * The threshold is global: if the density varies much, as in a scan from a tripod, the sparse part
 * counts as outliers first. Use more StandardDeviations there.
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
   * Set/Get the number of nearest points of the mean distance; all others if there are fewer. Valid
   * range: [1, 1000]. Default: 16.
   */
  vtkSetClampMacro(NumberOfNeighbors, int, 1, 1000);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Set/Get the threshold in standard deviations above the mean. Valid range: [0, 1000].
   * Default: 2.
   */
  vtkSetClampMacro(StandardDeviations, double, 0.0, 1000.0);
  vtkGetMacro(StandardDeviations, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the output is the outliers instead of the inliers. Default: off.
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
