// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointVoxelizer
 * @brief   converts points to solid voxels
 *
 * Input 0 is a vtkPointSet: points, double or float; optional point data Normals (3) and RGB (3:
 * bytes, 16-bit, or real in [0..1]). Its cells are ignored.
 *
 * Output 0 is a scene, a vtkPolyData of triangles with double points:
 * - polys: the surface of the solid cells. Cells are cubes of VoxelSize on a grid that starts at
 *   the minimum of the points; a cell with enough points is a solid box. A face has two triangles,
 *   wound outward; there is none between two solid cells; boxes share corner points, so that the
 *   surface is closed;
 * - cell data MaterialIds (int): the cell id modulo NumberOfMaterials;
 * - cell data VoxelIds (int) with GenerateVoxelIds: the cell id, from 0, along x first, then y,
 *   then z;
 * - cell data Normals (float, 3) if cells have normals: normals of the input points, summed and
 *   normalised, or as set by EstimateNormals, SnapNeighborNormal and DefaultNormal. A cell without
 *   one has the normal of its faces;
 * - cell data RGB (float, 3, [0..1]) if points have colours: their root mean square;
 * - field data: the input's (CRS), and NumberOfMaterials default materials.
 *
 * A cell is half-open: a point x is in cell floor(q), q = (x - x0) / VoxelSize, except that a q
 * within rounding, 2 ulp(max(|x|, |x0|)) / VoxelSize + 4 eps max(1, q), below an integer is that
 * integer. Thus points on a decimal lattice are in the cell of their decimal value, also at UTM
 * coordinates.
 *
 * A source that answers UPDATE_PIECE_NUMBER is read piece by piece, twice: for the minimum, then
 * for the cells. Only cells stay in memory. The output does not depend on the number of pieces nor
 * on the order of the points: sums are integers.
 *
 * Errors: no points, a coordinate that is not finite, more cells than MaximumNumberOfCells, a
 * VoxelSize below the precision of the coordinates.
 *
 * @warning
 * A rotated scene has rotated boxes; to keep boxes along the axes, rotate the points instead.
 *
 * @sa
 * vtkHeliosXyzReader vtkHeliosSceneComposer
 */

#ifndef vtkHeliosPointVoxelizer_h
#define vtkHeliosPointVoxelizer_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <functional> // For the operation on each piece

namespace helios
{
class VoxelGrid;
class VoxelInput;
struct VoxelBounds;
}

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosPointVoxelizer : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPointVoxelizer* New();
  vtkTypeMacro(vtkHeliosPointVoxelizer, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the cell size [m]. Valid range: greater than 0. Default: 1.
   */
  vtkSetMacro(VoxelSize, double);
  vtkGetMacro(VoxelSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the minimum number of points of a solid cell; more than one removes isolated points,
   * which are often noise. Valid range: [1, 1000000]. Default: 1.
   */
  vtkSetClampMacro(MinimumNumberOfPoints, int, 1, 1000000);
  vtkGetMacro(MinimumNumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Set/Get whether the normal of a cell is the normal of the plane fitted to its points (least
   * squares of distances; upwards) instead of the points' own. Cells with fewer than three points,
   * or with collinear points, have none. Default: off.
   */
  vtkSetMacro(EstimateNormals, bool);
  vtkGetMacro(EstimateNormals, bool);
  vtkBooleanMacro(EstimateNormals, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether a cell has the normal of the point nearest to its centre, not the mean of all.
   * Ignored with EstimateNormals. Default: off.
   */
  vtkSetMacro(SnapNeighborNormal, bool);
  vtkGetMacro(SnapNeighborNormal, bool);
  vtkBooleanMacro(SnapNeighborNormal, bool);
  ///@}

  ///@{
  /**
   * Set/Get the normal of cells without one; of any length, 0 0 0: the normal of the faces. Valid
   * range: finite. Default: 0 0 0.
   */
  vtkSetVector3Macro(DefaultNormal, double);
  vtkGetVector3Macro(DefaultNormal, double);
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
   * Set/Get whether triangles carry the id of their cell. Default: off.
   */
  vtkSetMacro(GenerateVoxelIds, bool);
  vtkGetMacro(GenerateVoxelIds, bool);
  vtkBooleanMacro(GenerateVoxelIds, bool);
  ///@}

  ///@{
  /**
   * Set/Get the number of pieces requested from a source that supports pieces, or the approximate
   * number of points per piece if it is 0. Valid range: [0, 1000000]; [1000, 1e9]. Default: 0;
   * 1000000.
   */
  vtkSetClampMacro(NumberOfPieces, int, 0, 1000000);
  vtkGetMacro(NumberOfPieces, int);
  vtkSetClampMacro(PointsPerPiece, vtkIdType, 1000, 1000000000);
  vtkGetMacro(PointsPerPiece, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of cells, a memory limit: a cell takes about 250 bytes in a surface
   * and 500 alone. Valid range: [1, 4e9]. Default: 20000000.
   */
  vtkSetClampMacro(MaximumNumberOfCells, vtkIdType, 1, 4000000000);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  ///@}

  ///@{
  /**
   * Get the number of input points and of solid cells of the last update.
   */
  vtkGetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfVoxels, vtkIdType);
  ///@}

protected:
  vtkHeliosPointVoxelizer() = default;
  ~vtkHeliosPointVoxelizer() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosPointVoxelizer(const vtkHeliosPointVoxelizer&) = delete;
  void operator=(const vtkHeliosPointVoxelizer&) = delete;

  /// The operation on a piece; false stops the work.
  using PieceVisitor = std::function<bool(const helios::VoxelInput&)>;

  bool CheckProperties();
  bool FetchPiece(vtkInformation* inInfo, int piece, int count);
  int ChooseNumberOfPieces(vtkInformation* inInfo);
  bool IsAborted(double progress);
  bool ForEachPiece(vtkInformation* inInfo, int count, double progress, const PieceVisitor& visit);
  bool CheckBounds(const helios::VoxelBounds& bounds);
  bool CheckAttributes(const helios::VoxelBounds& bounds);
  bool Measure(vtkInformation* inInfo, int count, helios::VoxelBounds& bounds, vtkPolyData* scene);
  bool Gather(
    vtkInformation* inInfo, int count, const helios::VoxelBounds& bounds, helios::VoxelGrid& grid);
  bool MakeScene(helios::VoxelGrid& grid, const helios::VoxelBounds& bounds, vtkPolyData* scene);

  double VoxelSize = 1.0;
  int MinimumNumberOfPoints = 1;
  bool EstimateNormals = false;
  bool SnapNeighborNormal = false;
  double DefaultNormal[3] = { 0.0, 0.0, 0.0 };
  int NumberOfMaterials = 1;
  bool GenerateVoxelIds = false;
  int NumberOfPieces = 0;
  vtkIdType PointsPerPiece = 1000000;
  vtkIdType MaximumNumberOfCells = 20000000;
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfVoxels = 0;
};

#endif
