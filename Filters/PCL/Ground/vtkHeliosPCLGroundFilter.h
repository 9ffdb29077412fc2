// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLGroundFilter
 * @brief   classifies ground points
 *
 * Input 0: a vtkPolyData with points, z up. Output 0: the same, with the point array
 * ClassificationIds (int): 2 for ground; other points keep their class, or get 1 (not classified)
 * if it was 2 or missing.
 *
 * 1. The lowest point of each CellSize x CellSize is selected (pcl::GridMinimum).
 * 2. The progressive morphological filter finds ground among these
 *    (pcl::ProgressiveMorphologicalFilter; K. Zhang et al. 2003, A progressive morphological filter
 *    for removing nonground measurements from airborne lidar data): windows of 3, 5, 9, 17 ...
 *    cells, up to MaximumWindowSize, are opened, and a point more than Slope * (growth of the
 *    window) + InitialDistance, or MaximumDistance if that is less, above the opened surface is
 *    removed.
 * 3. A point is ground if it is within Tolerance of the plane through the 12 nearest of the
 *    remaining points, weighted by 1 / (distance^2 + CellSize^2).
 *
 * The time is proportional to the number of cells, not to the density.
 *
 * @warning
 * Objects wider than MaximumWindowSize count as ground. Points below the ground by more than a few
 * centimetres corrupt cells: remove them first (vtkHeliosPCLOutlierRemoval).
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
   * Set/Get the cell size of the grid [m]: about twice the spacing of ground points. Valid range:
   * [0.01, 100]. Default: 1.
   */
  vtkSetClampMacro(CellSize, double, 0.01, 100.0);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the width of the largest window, more than the width of the largest building [m]. Valid
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
   * Set/Get the maximum height of ground above the opened surface for the first window, and for any
   * [m]. Valid range: [0, 100]. Default: 0.25; 2.5.
   */
  vtkSetClampMacro(InitialDistance, double, 0.0, 100.0);
  vtkGetMacro(InitialDistance, double);
  vtkSetClampMacro(MaximumDistance, double, 0.0, 100.0);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum distance of a ground point from the ground surface, up or down [m]. Valid
   * range: [0, 100]. Default: 0.2.
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
