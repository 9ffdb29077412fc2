// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosVoxelCubes
 * @brief   converts a grid of vegetation to opaque cubes
 *
 * Input 0 is a vtkImageData with the cell data PAD (one number per cell), as from
 * vtkHeliosVoxelReader; optional cell data Transmittance and field data MaximumPAD.
 *
 * Output 0 is a scene, a vtkPolyData of triangles with double points, wound outward:
 * - with FIXED every opaque cell is a cube; there is no face between two of them, and cubes share
 *   corner points;
 * - with SCALED a cube has the edges of its cell times (PAD / MaximumPAD)^Exponent, at most 1, about
 *   the centre of the cell or, with RandomShift, anywhere in the cell;
 * - cell data MaterialIds (int): the cell id modulo NumberOfMaterials;
 * - field data: the input's, and NumberOfMaterials default materials.
 *
 * A cell is opaque unless its Transmittance is 1 or NaN; without Transmittance if its PAD is more
 * than 0. SCALED leaves out cells whose PAD is 0 or NaN. MaximumPAD is from the field data, else
 * the largest of the cells. Random numbers are keyed by Seed and the cell id.
 *
 * Errors: no PAD, more cubes than MaximumNumberOfCubes.
 *
 * @sa
 * vtkHeliosVoxelReader vtkHeliosPointVoxelizer
 */

#ifndef vtkHeliosVoxelCubes_h
#define vtkHeliosVoxelCubes_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // For the cell ids

class vtkImageData;

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosVoxelCubes : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosVoxelCubes* New();
  vtkTypeMacro(vtkHeliosVoxelCubes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sizes of cubes.
  enum Modes
  {
    FIXED = 0, ///< the cell size
    SCALED = 1 ///< increasing with density
  };

  ///@{
  /**
   * Set/Get the size of cubes. Default: FIXED.
   */
  vtkSetClampMacro(Mode, int, FIXED, SCALED);
  vtkGetMacro(Mode, int);
  void SetModeToFixed() { this->SetMode(FIXED); }
  void SetModeToScaled() { this->SetMode(SCALED); }
  ///@}

  ///@{
  /**
   * Set/Get the exponent of SCALED; 1/3 makes the volume of a cube proportional to its PAD. Valid
   * range: [0, 100]. Default: 0.5.
   */
  vtkSetClampMacro(Exponent, double, 0.0, 100.0);
  vtkGetMacro(Exponent, double);
  ///@}

  ///@{
  /**
   * Set/Get whether cubes of SCALED are placed randomly in their cells. Default: off.
   */
  vtkSetMacro(RandomShift, bool);
  vtkGetMacro(RandomShift, bool);
  vtkBooleanMacro(RandomShift, bool);
  ///@}

  ///@{
  /**
   * Set/Get the key of the random numbers. Valid range: [0, 2^62]. Default: 0.
   */
  vtkSetClampMacro(Seed, vtkIdType, 0, 4611686018427387904LL);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the number of materials, assigned to cells in turn. Valid range: [1, 1000000].
   * Default: 1.
   */
  vtkSetClampMacro(NumberOfMaterials, int, 1, 1000000);
  vtkGetMacro(NumberOfMaterials, int);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of cubes, a memory limit: a cube takes up to 500 bytes. Valid range:
   * [1, 5e7]. Default: 20000000.
   */
  vtkSetClampMacro(MaximumNumberOfCubes, vtkIdType, 1, 50000000);
  vtkGetMacro(MaximumNumberOfCubes, vtkIdType);
  ///@}

  /**
   * Get the number of cubes of the last update.
   */
  vtkGetMacro(NumberOfCubes, vtkIdType);

protected:
  vtkHeliosVoxelCubes() = default;
  ~vtkHeliosVoxelCubes() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosVoxelCubes(const vtkHeliosVoxelCubes&) = delete;
  void operator=(const vtkHeliosVoxelCubes&) = delete;

  void WriteFixed(vtkImageData* grid, const std::vector<vtkIdType>& cells, vtkPolyData* scene);
  void WriteScaled(vtkImageData* grid, const std::vector<vtkIdType>& cells, vtkPolyData* scene);

  int Mode = FIXED;
  double Exponent = 0.5;
  bool RandomShift = false;
  vtkIdType Seed = 0;
  int NumberOfMaterials = 1;
  vtkIdType MaximumNumberOfCubes = 20000000;
  vtkIdType NumberOfCubes = 0;
};

#endif
