// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosClearance
 * @brief   how near a trajectory comes to a scene
 *
 * Port 0: a trajectory or waypoints (vtkPolyData, the points in order). Port 1: the
 * scene (triangles). Output: the input with the point array Clearance [m]: the
 * smallest on the straight way from a sample to the next (of the last sample, and of
 * one that jumps to a sample at the same GpsTime: at the sample).
 *
 * With Direction ALL_AROUND it is the distance to the nearest surface, exact between
 * samples too, 0 where the way goes through one; infinite where there is none
 * within Radius. With DOWN it is the height above the first surface straight below,
 * at samples and every Spacing between; negative where there is a surface above and
 * none below, as below a terrain; infinite where there is neither.
 *
 * Samples nearer than MinimumClearance are counted in a warning that names the first
 * and the nearest, or with FailBelowMinimum in an error.
 *
 * Distances come from closed forms for a straight way and a triangle, in a frame local to
 * the way; triangles without area are left out.
 *
 * @warning
 * Cubic trajectories (with Velocity) are taken as straight between samples.
 *
 * Errors: an empty scene, or one that is not of finite triangles; samples that are not
 * finite; abortion.
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

  /// Where surfaces are looked for.
  enum Directions
  {
    DOWN = 0,
    ALL_AROUND = 1
  };

  ///@{
  /**
   * Set/Get where surfaces are looked for. Default: ALL_AROUND.
   */
  vtkSetClampMacro(Direction, int, DOWN, ALL_AROUND);
  vtkGetMacro(Direction, int);
  void SetDirectionToDown() { this->SetDirection(DOWN); }
  void SetDirectionToAllAround() { this->SetDirection(ALL_AROUND); }
  ///@}

  ///@{
  /**
   * Set/Get how far all around surfaces are looked for [m]. Valid range:
   * [1e-3, 1e6]. Default: 100.
   */
  vtkSetClampMacro(Radius, double, 1e-3, 1e6);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Set/Get how far apart places are at most that are looked down from [m]. Valid
   * range: [1e-3, 1e6]. Default: 1.
   */
  vtkSetClampMacro(Spacing, double, 1e-3, 1e6);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Set/Get the clearance that is to be kept [m]; all around it is at most Radius.
   * Valid range: [0, 1e6]. Default: 0, only what is below the terrain or, all
   * around, nothing is told.
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
   * Get, of the last update, the number of samples below MinimumClearance, the first of
   * them (-1: none), and the smallest clearance [m] (infinite: none).
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
  bool Judge(vtkPolyData* path, vtkDoubleArray* clearances);

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
