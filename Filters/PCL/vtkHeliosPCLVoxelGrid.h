// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLVoxelGrid
 * @brief   one point per cell of a grid
 *
 * Input 0: a vtkPolyData with points. Output 0: one point for each cubic cell with points
 * (pcl::VoxelGrid), in the order of cells along x, then y, then z: the one nearest to the mean of
 * the cell's points, bit by bit with its arrays; or with UseMeanPoints that mean (double points,
 * rounded as float at the distance from the centre of the cloud) with the arrays of that nearest
 * point. Cell borders are at multiples of VoxelSize: neighbouring tiles share the grid. Point array
 * NumberOfPoints (int): the number of points in the cell.
 *
 * Errors: a VoxelSize that makes more cells than PCL can count (2^31 in the box of the cloud), and
 * the errors of vtkHeliosPCLFilter.
 *
 * @sa
 * vtkHeliosPCLFilter
 */

#ifndef vtkHeliosPCLVoxelGrid_h
#define vtkHeliosPCLVoxelGrid_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro
#include "vtkHeliosPCLFilter.h"

class VTKHELIOSFILTERSPCL_EXPORT vtkHeliosPCLVoxelGrid : public vtkHeliosPCLFilter
{
public:
  static vtkHeliosPCLVoxelGrid* New();
  vtkTypeMacro(vtkHeliosPCLVoxelGrid, vtkHeliosPCLFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the cell size [m]. Valid range: [1e-4, 1e6]. Default: 0.1.
   */
  vtkSetClampMacro(VoxelSize, double, 1e-4, 1e6);
  vtkGetMacro(VoxelSize, double);
  ///@}

  ///@{
  /**
   * Set/Get whether a cell gives the mean of its points instead of one of them. Default: off.
   */
  vtkSetMacro(UseMeanPoints, bool);
  vtkGetMacro(UseMeanPoints, bool);
  vtkBooleanMacro(UseMeanPoints, bool);
  ///@}

protected:
  vtkHeliosPCLVoxelGrid() = default;
  ~vtkHeliosPCLVoxelGrid() override = default;

  bool Process(helios::PclInput& input, vtkPolyData* output) override;
  double GetStep() const override { return this->VoxelSize; }

private:
  vtkHeliosPCLVoxelGrid(const vtkHeliosPCLVoxelGrid&) = delete;
  void operator=(const vtkHeliosPCLVoxelGrid&) = delete;

  bool CheckSize(const helios::PclInput& input);

  double VoxelSize = 0.1;
  bool UseMeanPoints = false;
};

#endif
