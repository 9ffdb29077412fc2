// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosVoxelCubes
 * @brief   a grid of vegetation as opaque cubes
 *
 * Input 0 is a vtkImageData with the cell data PAD (one number a cell), as vtkHeliosVoxelReader makes
 * it; cell data Transmittance and field data MaximumPAD where there are any.
 *
 * Output 0 is a scene, a vtkPolyData of triangles with double points, wound outward:
 * - with FIXED every opaque cell is a cube; between two of them there is no face, cubes share the
 *   points of their corners;
 * - with SCALED a cube has the edges of its cell times (PAD / MaximumPAD)^Exponent, at most 1, about
 *   the centre of the cell or, with RandomShift, anywhere in the cell;
 * - cell data MaterialIds (int): the number of the cell modulo NumberOfMaterials;
 * - field data: the input's, and NumberOfMaterials default materials.
 *
 * A cell is opaque unless its Transmittance is 1 or NaN; without Transmittance if its PAD is more
 * than 0. SCALED leaves out cells whose PAD is 0 or NaN. MaximumPAD is the field data's, or the
 * largest of the cells. Random numbers are keyed by Seed and the number of the cell.
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

#include <vector> // For the numbers of cells

class vtkImageData;

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosVoxelCubes : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosVoxelCubes* New();
  vtkTypeMacro(vtkHeliosVoxelCubes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How large cubes are.
  enum Modes
  {
    FIXED = 0, ///< as their cells
    SCALED = 1 ///< the denser, the larger
  };

  ///@{
  /**
   * Set/Get how large cubes are. Default: FIXED.
   */
  vtkSetClampMacro(Mode, int, FIXED, SCALED);
  vtkGetMacro(Mode, int);
  void SetModeToFixed() { this->SetMode(FIXED); }
  void SetModeToScaled() { this->SetMode(SCALED); }
  ///@}

  ///@{
  /**
   * Set/Get the exponent of SCALED; 1/3 makes the volume of a cube go with its PAD. Valid range:
   * [0, 100]. Default: 0.5.
   */
  vtkSetClampMacro(Exponent, double, 0.0, 100.0);
  vtkGetMacro(Exponent, double);
  ///@}

  ///@{
  /**
   * Set/Get whether cubes of SCALED lie anywhere in their cells. Default: off.
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
   * Set/Get the number of materials that cells take in turn. Valid range: [1, 1000000]. Default: 1.
   */
  vtkSetClampMacro(NumberOfMaterials, int, 1, 1000000);
  vtkGetMacro(NumberOfMaterials, int);
  ///@}

  ///@{
  /**
   * Set/Get how many cubes there may be: a guard of memory, of which a cube takes up to 500 bytes.
   * Valid range: [1, 5e7]. Default: 20000000.
   */
  vtkSetClampMacro(MaximumNumberOfCubes, vtkIdType, 1, 50000000);
  vtkGetMacro(MaximumNumberOfCubes, vtkIdType);
  ///@}

  /**
   * Get how many cubes the last update made.
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
