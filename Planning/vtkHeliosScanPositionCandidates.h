// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosScanPositionCandidates
 * @brief   candidate scan positions on the surfaces of a scene
 *
 * Port 0: the scene (triangles). Port 1, optional: areas to exclude, polygons or closed lines of
 * which only x and y count; their border belongs to them. Port 2, optional: places to use instead of
 * a grid; with a height (z) the highest surface that is not more than 1 m above it, with NaN that of
 * a grid.
 *
 * Output: one point per candidate, the instrument position, ScannerHeight above the surface, in
 * rows of x from the smallest y on; point arrays Slope [deg], CellIds (of the scene) and Normal (of
 * the surface, unit, upwards). Field data CRS passes.
 *
 * Vertical rays are cast downwards on a grid that starts half a step inside the scene. They find
 * the highest surface (Bechtold and Hoefle 2016, section 10), or the highest with a ground
 * material. Without a ground material, AUTOMATIC leaves out surfaces that are 1.8 m or more above
 * another one, as roofs are, unless there are no others, which is a warning.
 * Surfaces steeper than MaximumSlope are excluded. A position from which none of 128
 * lines, spread evenly over the sky, leaves the scene is enclosed, e.g. in a closed house; such
 * positions are used only if there are no others, as in a hall, if they are given, or without
 * SkipEnclosed.
 *
 * Errors: an empty scene or one that is not of finite triangles; GROUND without a ground material;
 * a grid beyond MemoryLimit; no place on port 2; no candidate left, with the number removed by each limit; an abort
 * request.
 *
 * @sa
 * vtkHeliosVisibilityTestPoints vtkHeliosViewsheds vtkHeliosScanPositionPlanner
 */

#ifndef vtkHeliosScanPositionCandidates_h
#define vtkHeliosScanPositionCandidates_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <limits> // For limits that are not set

class VTKHELIOSPLANNING_EXPORT vtkHeliosScanPositionCandidates : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosScanPositionCandidates* New();
  vtkTypeMacro(vtkHeliosScanPositionCandidates, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Surfaces for scan positions.
  enum Surfaces
  {
    HIGHEST = 0,     ///< the highest surface, of any material
    GROUND = 1,      ///< the highest surface with a ground material, whatever is above it
    OPEN_GROUND = 2, ///< the highest surface, if it has a ground material
    AUTOMATIC = 3    ///< GROUND if the scene has a ground material, else HIGHEST without roofs
  };

  ///@{
  /**
   * Set/Get the spacing of candidates along x and y [m]. Valid range: [0, 1e6].
   * Default: 0, a twentieth of the scene's diagonal.
   */
  vtkSetClampMacro(XStep, double, 0.0, 1e6);
  vtkGetMacro(XStep, double);
  vtkSetClampMacro(YStep, double, 0.0, 1e6);
  vtkGetMacro(YStep, double);
  void SetStep(double step);
  ///@}

  ///@{
  /**
   * Set/Get the region of candidates: x min, x max, y min, y max [m]. The grid starts half a step
   * inside. Default: NaN for each, the scene's bounds.
   */
  vtkSetVector4Macro(Region, double);
  vtkGetVector4Macro(Region, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest allowed angle of the surface from the horizontal [deg]. Valid range:
   * [0, 90]. Default: 15.
   */
  vtkSetClampMacro(MaximumSlope, double, 0.0, 90.0);
  vtkGetMacro(MaximumSlope, double);
  ///@}

  ///@{
  /**
   * Set/Get the surfaces for scan positions. Default: AUTOMATIC.
   */
  vtkSetClampMacro(Surface, int, HIGHEST, AUTOMATIC);
  vtkGetMacro(Surface, int);
  void SetSurfaceToHighest() { this->SetSurface(HIGHEST); }
  void SetSurfaceToGround() { this->SetSurface(GROUND); }
  void SetSurfaceToOpenGround() { this->SetSurface(OPEN_GROUND); }
  void SetSurfaceToAutomatic() { this->SetSurface(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * Set/Get whether enclosed positions are left out if there are open ones. Default: on.
   */
  vtkSetMacro(SkipEnclosed, bool);
  vtkGetMacro(SkipEnclosed, bool);
  vtkBooleanMacro(SkipEnclosed, bool);
  ///@}

  /**
   * Get the number of enclosed positions left out in the last update.
   */
  vtkGetMacro(NumberOfEnclosed, vtkIdType);

  /**
   * Get the number of places on roofs left out in the last update.
   */
  vtkGetMacro(NumberOnRoofs, vtkIdType);

  ///@{
  /**
   * Set/Get the height of the instrument above the surface [m]. Valid range: [1e-6, 1e4].
   * Default: 1.5.
   */
  vtkSetClampMacro(ScannerHeight, double, 1e-6, 1e4);
  vtkGetMacro(ScannerHeight, double);
  ///@}

  ///@{
  /**
   * Set/Get the limit for the memory of the grid positions [MiB]. Valid range: [1, 1e9].
   * Default: 2048.
   */
  vtkSetClampMacro(MemoryLimit, double, 1.0, 1e9);
  vtkGetMacro(MemoryLimit, double);
  ///@}

protected:
  vtkHeliosScanPositionCandidates();
  ~vtkHeliosScanPositionCandidates() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosScanPositionCandidates(const vtkHeliosScanPositionCandidates&) = delete;
  void operator=(const vtkHeliosScanPositionCandidates&) = delete;

  class Search;
  bool Report(const Search& search);

  static constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

  double XStep = 0.0;
  double YStep = 0.0;
  double Region[4] = { NotGiven, NotGiven, NotGiven, NotGiven };
  double MaximumSlope = 15.0;
  int Surface = AUTOMATIC;
  bool SkipEnclosed = true;
  vtkIdType NumberOfEnclosed = 0;
  vtkIdType NumberOnRoofs = 0;
  double ScannerHeight = 1.5;
  double MemoryLimit = 2048.0;
};

#endif
