// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosClearance
 * @brief   distance from a trajectory to a scene
 *
 * Port 0: a trajectory or waypoints (vtkPolyData, the points in order). Port 1: the
 * scene (triangles). Output: the input with the point array Clearance [m]: the
 * minimum on the straight segment from a sample to the next (for the last sample,
 * and one that jumps to a sample at the same GpsTime: at the sample).
 *
 * With Direction ALL_AROUND it is the distance to the nearest surface, also exact
 * between samples, 0 where the segment intersects one; infinite without surfaces
 * within Radius. With DOWN it is the height above the first surface vertically
 * below, at samples and every Spacing between; negative where there is a surface
 * above and none below, as below a terrain; infinite where there is neither.
 *
 * Samples nearer than MinimumClearance are counted in a warning that names the first
 * and the nearest, or with FailBelowMinimum in an error.
 *
 * Distances are closed forms for a segment and a triangle, in a frame local to the
 * segment; triangles without area are skipped.
 *
 * @warning
 * Cubic trajectories (with Velocity) are treated as straight between samples.
 *
 * Instances and rasters of a vtkHeliosScene are copied for ALL_AROUND, not for DOWN.
 *
 * Errors: a scene that is empty or not of finite triangles, or too large for a copy;
 * samples that are not finite; abort.
 *
 * @sa
 * vtkHeliosTerrainFollow vtkHeliosPlatform
 */

#ifndef vtkHeliosClearance_h
#define vtkHeliosClearance_h

#include "vtkHeliosScannerRayCastingModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class vtkDoubleArray;

class VTKHELIOSSCANNERRAYCASTING_EXPORT vtkHeliosClearance : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosClearance* New();
  vtkTypeMacro(vtkHeliosClearance, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The search direction.
  enum Directions
  {
    DOWN = 0,
    ALL_AROUND = 1
  };

  ///@{
  /**
   * Set/Get the search direction. Default: ALL_AROUND.
   */
  vtkSetClampMacro(Direction, int, DOWN, ALL_AROUND);
  vtkGetMacro(Direction, int);
  void SetDirectionToDown() { this->SetDirection(DOWN); }
  void SetDirectionToAllAround() { this->SetDirection(ALL_AROUND); }
  ///@}

  ///@{
  /**
   * Set/Get the search radius of ALL_AROUND [m]. Valid range: [1e-3, 1e6].
   * Default: 100.
   */
  vtkSetClampMacro(Radius, double, 1e-3, 1e6);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum spacing of the samples of DOWN [m]. Valid range:
   * [1e-3, 1e6]. Default: 1.
   */
  vtkSetClampMacro(Spacing, double, 1e-3, 1e6);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Set/Get the clearance required [m], for ALL_AROUND at most Radius. Valid
   * range: [0, 1e6]. Default: 0, only samples below the terrain or, for
   * ALL_AROUND, none are reported.
   */
  vtkSetClampMacro(MinimumClearance, double, 0.0, 1e6);
  vtkGetMacro(MinimumClearance, double);
  ///@}

  ///@{
  /**
   * Set/Get whether a clearance below the minimum is an error, without output. Default:
   * off, a warning.
   */
  vtkSetMacro(FailBelowMinimum, bool);
  vtkGetMacro(FailBelowMinimum, bool);
  vtkBooleanMacro(FailBelowMinimum, bool);
  ///@}

  ///@{
  /**
   * Get, for the last update, the number of samples below MinimumClearance, the first
   * of them (-1: none), and the smallest clearance [m] (infinite: none).
   */
  vtkGetMacro(NumberBelowMinimum, vtkIdType);
  vtkGetMacro(FirstBelowMinimum, vtkIdType);
  vtkGetMacro(SmallestClearance, double);
  ///@}

protected:
  vtkHeliosClearance();
  ~vtkHeliosClearance() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosClearance(const vtkHeliosClearance&) = delete;
  void operator=(const vtkHeliosClearance&) = delete;

  bool Measure(vtkPolyData* path, vtkPolyData* scene, vtkDoubleArray* clearances);
  bool CheckClearances(vtkPolyData* path, vtkDoubleArray* clearances);

  int Direction = ALL_AROUND;
  double Radius = 100.0;
  double Spacing = 1.0;
  double MinimumClearance = 0.0;
  bool FailBelowMinimum = false;
  vtkIdType NumberBelowMinimum = 0;
  vtkIdType FirstBelowMinimum = -1;
  double SmallestClearance = VTK_DOUBLE_MAX;
};

#endif
