// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosScanPositionCandidates
 * @brief   places of a scene where a scanner could stand
 *
 * Port 0: the scene (triangles). Port 1, optional: areas to keep away from, polygons or closed lines
 * of which only x and y count; a place on their border is in them.
 *
 * Output: a point a candidate, where the instrument is, ScannerHeight above the surface, in rows of x
 * from the smallest y on; point arrays Slope [deg], CellIds (of the scene) and Normal (of the surface,
 * unit, upwards). Field data CRS passes.
 *
 * Vertical rays go down on a grid that starts half a step inside the scene. What counts is the
 * highest surface (Bechtold and Hoefle 2016, section 10), or the highest with a ground material.
 * A surface steeper than MaximumSlope is none to stand on. A place from which none of 128 lines, spread
 * evenly over the sky, gets out of the scene is inside of something, e.g. of a closed house; such places
 * count only where there are no others, as in a hall, or without SkipEnclosed.
 *
 * Errors: an empty scene or one that is not of finite triangles; GROUND without a ground material; a
 * grid beyond MemoryLimit; no candidate left, with how many places each limit took; abortion.
 *
 * @sa
 * vtkHeliosVisibilityTestPoints vtkHeliosViewsheds vtkHeliosScanPositionPlanner
 */

#ifndef vtkHeliosScanPositionCandidates_h
#define vtkHeliosScanPositionCandidates_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <limits> // For what is not given

class VTKHELIOSPLANNING_EXPORT vtkHeliosScanPositionCandidates : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosScanPositionCandidates* New();
  vtkTypeMacro(vtkHeliosScanPositionCandidates, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What a scanner may stand on.
  enum Surfaces
  {
    HIGHEST = 0,     ///< the highest surface, whatever it is
    GROUND = 1,      ///< the highest surface with a ground material, whatever is above it
    OPEN_GROUND = 2, ///< the highest surface, where it has a ground material
    AUTOMATIC = 3    ///< GROUND where the scene has a ground material, else HIGHEST
  };

  ///@{
  /**
   * Set/Get the distance of candidates along x and y [m]. Valid range: [0, 1e6].
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
   * Set/Get where candidates may be: x from, x to, y from, y to [m]. The grid starts half a step
   * inside. Default: NaN for each, the scene's bounds.
   */
  vtkSetVector4Macro(Region, double);
  vtkGetVector4Macro(Region, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest angle of the surface from the horizontal [deg], which still counts. Valid
   * range: [0, 90]. Default: 15.
   */
  vtkSetClampMacro(MaximumSlope, double, 0.0, 90.0);
  vtkGetMacro(MaximumSlope, double);
  ///@}

  ///@{
  /**
   * Set/Get what a scanner may stand on. Default: AUTOMATIC.
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
   * Set/Get whether places that are closed all around are left out where there are open ones.
   * Default: on.
   */
  vtkSetMacro(SkipEnclosed, bool);
  vtkGetMacro(SkipEnclosed, bool);
  vtkBooleanMacro(SkipEnclosed, bool);
  ///@}

  /**
   * Get how many places the last update left out because they are closed all around.
   */
  vtkGetMacro(NumberOfEnclosed, vtkIdType);

  ///@{
  /**
   * Set/Get how high the instrument stands above the surface [m]. Valid range: [1e-6, 1e4].
   * Default: 1.5.
   */
  vtkSetClampMacro(ScannerHeight, double, 1e-6, 1e4);
  vtkGetMacro(ScannerHeight, double);
  ///@}

  ///@{
  /**
   * Set/Get the memory that the places of the grid may take [MiB]. Valid range: [1, 1e9].
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
  double ScannerHeight = 1.5;
  double MemoryLimit = 2048.0;
};

#endif
