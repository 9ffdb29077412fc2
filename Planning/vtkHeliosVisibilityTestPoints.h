// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosVisibilityTestPoints
 * @brief   points that sample the surfaces of a scene
 *
 * Port 0: the scene (triangles). Output: one point at each intersection of a grid line with a
 * surface; point arrays Normal (unit), CellIds (of the scene) and, with GenerateAreas, Area [m2].
 * Field data CRS passes.
 *
 * Vertical and horizontal lines, the latter along x and along y, cross the whole scene, and every
 * surface they intersect counts (Bechtold and Hoefle 2016, section 10: rays from above and from
 * four sides, all hits). A point nearer than MergeTolerance to an earlier one is left out, and its
 * area is added to that one. Vertical lines come first, in rows of x from the smallest y on, then
 * lines along x, then lines along y; along a line points go down or up the axis.
 *
 * Lines along an axis a of a grid of cell area G intersect a surface with the unit normal n once
 * per area G / |n_a|. The area of a point is that, times n_a^2 over the sum of squares for the axes
 * in use, so that the expected sum of all areas is the surface's area.
 *
 * Errors: an empty scene or one that is not of finite triangles; no direction of lines; a grid
 * beyond MemoryLimit; no line that intersects a surface; an abort request.
 *
 * @sa
 * vtkHeliosScanPositionCandidates vtkHeliosViewsheds vtkHeliosScanPositionPlanner
 */

#ifndef vtkHeliosVisibilityTestPoints_h
#define vtkHeliosVisibilityTestPoints_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <limits> // For limits that are not set

class VTKHELIOSPLANNING_EXPORT vtkHeliosVisibilityTestPoints : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosVisibilityTestPoints* New();
  vtkTypeMacro(vtkHeliosVisibilityTestPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the spacing of lines along x, y and z [m]. Valid range: [0, 1e6].
   * Default: 0, a twentieth of the scene's diagonal.
   */
  vtkSetClampMacro(XStep, double, 0.0, 1e6);
  vtkGetMacro(XStep, double);
  vtkSetClampMacro(YStep, double, 0.0, 1e6);
  vtkGetMacro(YStep, double);
  vtkSetClampMacro(ZStep, double, 0.0, 1e6);
  vtkGetMacro(ZStep, double);
  void SetStep(double step);
  ///@}

  ///@{
  /**
   * Set/Get the region of points: x min, x max, y min, y max, z min, z max [m]. The grid starts
   * half a step inside. Default: NaN for each, the scene's bounds.
   */
  vtkSetVector6Macro(Region, double);
  vtkGetVector6Macro(Region, double);
  ///@}

  ///@{
  /**
   * Set/Get whether vertical and horizontal lines are used. Default: both.
   */
  vtkSetMacro(Vertical, bool);
  vtkGetMacro(Vertical, bool);
  vtkBooleanMacro(Vertical, bool);
  vtkSetMacro(Horizontal, bool);
  vtkGetMacro(Horizontal, bool);
  vtkBooleanMacro(Horizontal, bool);
  ///@}

  ///@{
  /**
   * Set/Get the distance up to which points are merged [m]; at most a thousandth of the smallest
   * step. Valid range: [0, 1e3]. Default: 1e-4.
   */
  vtkSetClampMacro(MergeTolerance, double, 0.0, 1e3);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the output has the point array Area. Default: off.
   */
  vtkSetMacro(GenerateAreas, bool);
  vtkGetMacro(GenerateAreas, bool);
  vtkBooleanMacro(GenerateAreas, bool);
  ///@}

  ///@{
  /**
   * Set/Get the limit for the memory of points, at one hit per line [MiB]. Valid range: [1, 1e9].
   * Default: 2048.
   */
  vtkSetClampMacro(MemoryLimit, double, 1.0, 1e9);
  vtkGetMacro(MemoryLimit, double);
  ///@}

protected:
  vtkHeliosVisibilityTestPoints() = default;
  ~vtkHeliosVisibilityTestPoints() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosVisibilityTestPoints(const vtkHeliosVisibilityTestPoints&) = delete;
  void operator=(const vtkHeliosVisibilityTestPoints&) = delete;

  class Search;

  static constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

  double XStep = 0.0;
  double YStep = 0.0;
  double ZStep = 0.0;
  double Region[6] = { NotGiven, NotGiven, NotGiven, NotGiven, NotGiven, NotGiven };
  bool Vertical = true;
  bool Horizontal = true;
  double MergeTolerance = 1e-4;
  bool GenerateAreas = false;
  double MemoryLimit = 2048.0;
};

#endif
