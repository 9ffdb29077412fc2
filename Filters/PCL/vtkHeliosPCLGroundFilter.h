// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLGroundFilter
 * @brief   which points are ground
 *
 * Input 0: a vtkPolyData with points, z up. Output 0: the same, with the point array
 * ClassificationIds (int): 2 for ground; other points keep the class they had, or have 1 (not
 * classified) where they had 2 or none.
 *
 * 1. The lowest point of each CellSize x CellSize is taken (pcl::GridMinimum).
 * 2. Of these the progressive morphological filter keeps ground (pcl::ProgressiveMorphologicalFilter;
 *    K. Zhang et al. 2003, A progressive morphological filter for removing nonground measurements
 *    from airborne lidar data): windows of 3, 5, 9, 17 ... cells, until MaximumWindowSize is reached, are opened,
 *    and a point more than Slope * (growth of the window) + InitialDistance, or MaximumDistance
 *    where that is less, above the opened surface goes.
 * 3. A point is ground if it is within Tolerance of the plane through the 12 nearest of those that are
 *    left, weighted by 1 / (distance^2 + CellSize^2).
 *
 * So the time goes with the number of cells, whatever the density.
 *
 * @warning
 * Objects wider than MaximumWindowSize count as ground. Points below the ground by more than a few
 * centimetres spoil cells: take them out first (vtkHeliosPCLOutlierRemoval).
 *
 * @sa
 * vtkHeliosPCLFilter
 */

#ifndef vtkHeliosPCLGroundFilter_h
#define vtkHeliosPCLGroundFilter_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro
#include "vtkHeliosPCLFilter.h"

class VTKHELIOSFILTERSPCL_EXPORT vtkHeliosPCLGroundFilter : public vtkHeliosPCLFilter
{
public:
  static vtkHeliosPCLGroundFilter* New();
  vtkTypeMacro(vtkHeliosPCLGroundFilter, vtkHeliosPCLFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the edge of a cell of the grid [m]: about twice the distance of ground points. Valid
   * range: [0.01, 100]. Default: 1.
   */
  vtkSetClampMacro(CellSize, double, 0.01, 100.0);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the width of the largest window, more than that of the largest building [m]. Valid
   * range: [0.1, 1000]. Default: 33.
   */
  vtkSetClampMacro(MaximumWindowSize, double, 0.1, 1000.0);
  vtkGetMacro(MaximumWindowSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the steepest terrain, as rise over run. Valid range: [0, 10]. Default: 0.5.
   */
  vtkSetClampMacro(Slope, double, 0.0, 10.0);
  vtkGetMacro(Slope, double);
  ///@}

  ///@{
  /**
   * Set/Get how far above the opened surface ground may be for the first window, and for any [m].
   * Valid range: [0, 100]. Default: 0.25; 2.5.
   */
  vtkSetClampMacro(InitialDistance, double, 0.0, 100.0);
  vtkGetMacro(InitialDistance, double);
  vtkSetClampMacro(MaximumDistance, double, 0.0, 100.0);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Set/Get how far from the ground's surface a point of it may be, up or down [m]. Valid range:
   * [0, 100]. Default: 0.2.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, 100.0);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkHeliosPCLGroundFilter() = default;
  ~vtkHeliosPCLGroundFilter() override = default;

  bool Process(helios::PclInput& input, vtkPolyData* output) override;
  double GetStep() const override { return this->CellSize; }

private:
  vtkHeliosPCLGroundFilter(const vtkHeliosPCLGroundFilter&) = delete;
  void operator=(const vtkHeliosPCLGroundFilter&) = delete;

  bool CheckCells(const helios::PclInput& input);

  double CellSize = 1.0;
  double MaximumWindowSize = 33.0;
  double Slope = 0.5;
  double InitialDistance = 0.25;
  double MaximumDistance = 2.5;
  double Tolerance = 0.2;
};

#endif
