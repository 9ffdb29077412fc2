// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLClusters
 * @brief   clusters of points separated by gaps
 *
 * Input 0: a vtkPolyData with points. Output 0: the same, with the point array ClusterIds (int):
 * points connected by steps shorter than Tolerance share an id, from 0 for the largest cluster on;
 * -1 in clusters below MinimumClusterSize or above MaximumClusterSize. The clusters equal the
 * result of pcl::EuclideanClusterExtraction, whose time is quadratic in the density; here it is O(n
 * log n).
 *
 * @sa
 * vtkHeliosPCLFilter vtkHeliosPCLGroundFilter
 */

#ifndef vtkHeliosPCLClusters_h
#define vtkHeliosPCLClusters_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro
#include "vtkHeliosPCLFilter.h"

class VTKHELIOSFILTERSPCL_EXPORT vtkHeliosPCLClusters : public vtkHeliosPCLFilter
{
public:
  static vtkHeliosPCLClusters* New();
  vtkTypeMacro(vtkHeliosPCLClusters, vtkHeliosPCLFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the maximum step within a cluster (exclusive) [m]. Valid range: [1e-4, 1000].
   * Default: 0.5.
   */
  vtkSetClampMacro(Tolerance, double, 1e-4, 1000.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get the minimum and maximum number of points of a cluster. Valid range: [1, 2147483647].
   * Default: 10; 2147483647.
   */
  vtkSetClampMacro(MinimumClusterSize, int, 1, VTK_INT_MAX);
  vtkGetMacro(MinimumClusterSize, int);
  vtkSetClampMacro(MaximumClusterSize, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumClusterSize, int);
  ///@}

  /**
   * Get the number of clusters found in the last update.
   */
  vtkGetMacro(NumberOfClusters, int);

protected:
  vtkHeliosPCLClusters() = default;
  ~vtkHeliosPCLClusters() override = default;

  bool Process(helios::PclInput& input, vtkPolyData* output) override;
  bool CheckProperties() override;

private:
  vtkHeliosPCLClusters(const vtkHeliosPCLClusters&) = delete;
  void operator=(const vtkHeliosPCLClusters&) = delete;

  double Tolerance = 0.5;
  int MinimumClusterSize = 10;
  int MaximumClusterSize = VTK_INT_MAX;
  int NumberOfClusters = 0;
};

#endif
