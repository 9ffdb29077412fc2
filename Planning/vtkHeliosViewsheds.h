// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosViewsheds
 * @brief   visibility of test points from scan positions
 *
 * Port 0: the scene (triangles). Port 1: candidates, the instrument positions. Port 2: test points;
 * the optional point array Normal (3 components) gives incidence angles.
 *
 * Output: the candidates, with the point arrays Visibility (unsigned 64-bit words, test point v is
 * bit v % 64 of component v / 64), ViewshedSize (int64, the number seen) and, with normals,
 * MeanIncidenceAngle [deg] of the lines of sight, from the normal on either side, in [0, 90]; NaN
 * if nothing is seen.
 *
 * A test point is seen if no surface is more than HitTolerance in front. With BothSides the first
 * surface must also be no further behind it (Bechtold and Hoefle 2016, section 10: the first hit
 * lies within the tolerance of the point). Points out of range, out of the field of view, beyond
 * the incidence limit or below the point density are not seen; no such limit is set by default.
 * With normals, lines are aimed a thousandth of HitTolerance behind the surface: rounding would
 * decide whether a point on an edge is hit.
 *
 * The output supports pieces, contiguous ranges of the candidates: a matrix larger than memory is
 * computed piece by piece. It is byte-identical for any number of threads.
 *
 * @warning
 * Turbid voxels are transparent.
 *
 * Errors: an empty scene or one that is not of finite triangles; missing or non-finite candidates
 * or test points; a limit that needs normals without normals; a matrix beyond MemoryLimit; an abort
 * request.
 *
 * @sa
 * vtkHeliosScanPositionCandidates vtkHeliosVisibilityTestPoints vtkHeliosScanPositionPlanner
 */

#ifndef vtkHeliosViewsheds_h
#define vtkHeliosViewsheds_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For the ray caster

#include <string> // For error messages

class vtkHeliosRayCaster;

namespace helios
{
class Status;
}

class VTKHELIOSPLANNING_EXPORT vtkHeliosViewsheds : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosViewsheds* New();
  vtkTypeMacro(vtkHeliosViewsheds, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the ray caster. Default: the default backend.
   */
  void SetRayCaster(vtkHeliosRayCaster* caster);
  vtkHeliosRayCaster* GetRayCaster() const;
  ///@}

  ///@{
  /**
   * Set/Get how far in front of a test point, along the line of sight, a surface may be without
   * hiding it [m]. Valid range: [1e-6, 1e3]. Default: 0.05.
   */
  vtkSetClampMacro(HitTolerance, double, 1e-6, 1e3);
  vtkGetMacro(HitTolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get whether a surface is required within HitTolerance of the test point. Default: off, a
   * line of sight that just misses an edge still sees it.
   */
  vtkSetMacro(BothSides, bool);
  vtkGetMacro(BothSides, bool);
  vtkBooleanMacro(BothSides, bool);
  ///@}

  ///@{
  /**
   * Set/Get the smallest and largest range of the instrument [m]. Valid range: [0, 1e9].
   * Default: 0 and 1e9.
   */
  vtkSetClampMacro(MinimumRange, double, 0.0, 1e9);
  vtkGetMacro(MinimumRange, double);
  vtkSetClampMacro(MaximumRange, double, 0.0, 1e9);
  vtkGetMacro(MaximumRange, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest angle between line of sight and normal [deg]. Valid range: [0, 90].
   * Default: 90.
   */
  vtkSetClampMacro(MaximumIncidenceAngle, double, 0.0, 90.0);
  vtkGetMacro(MaximumIncidenceAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the field of view of the vertical instrument, as angles above the horizon [deg]. Valid
   * range: [-90, 90]. Default: -90 and 90.
   */
  vtkSetClampMacro(MinimumElevation, double, -90.0, 90.0);
  vtkGetMacro(MinimumElevation, double);
  vtkSetClampMacro(MaximumElevation, double, -90.0, 90.0);
  vtkGetMacro(MaximumElevation, double);
  ///@}

  ///@{
  /**
   * Set/Get the minimum point density on a surface from a single position [1/m2], and the angle
   * between neighbouring pulses [deg]: at range R and incidence i the density is cos(i) / (R
   * AngularStep)^2. Valid range: [0, 1e12] and [0, 90]. Default: 0, any, and 0.
   */
  vtkSetClampMacro(MinimumPointDensity, double, 0.0, 1e12);
  vtkGetMacro(MinimumPointDensity, double);
  vtkSetClampMacro(AngularStep, double, 0.0, 90.0);
  vtkGetMacro(AngularStep, double);
  ///@}

  ///@{
  /**
   * Set/Get the limit for the memory of the matrix, or of one of its pieces [MiB]. Valid range: [1,
   * 1e9]. Default: 2048.
   */
  vtkSetClampMacro(MemoryLimit, double, 1.0, 1e9);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  /**
   * Get the number of rays cast in the last update.
   */
  vtkGetMacro(NumberOfRays, vtkIdType);

protected:
  vtkHeliosViewsheds();
  ~vtkHeliosViewsheds() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkHeliosViewsheds(const vtkHeliosViewsheds&) = delete;
  void operator=(const vtkHeliosViewsheds&) = delete;

  class Observers;
  helios::Status FindFault(
    vtkPolyData* scene, vtkPolyData* candidates, vtkPolyData* testPoints) const;
  helios::Status FindExcess(vtkIdType candidates, vtkIdType testPoints) const;

  vtkSmartPointer<vtkHeliosRayCaster> RayCaster;
  double HitTolerance = 0.05;
  bool BothSides = false;
  double MinimumRange = 0.0;
  double MaximumRange = 1e9;
  double MaximumIncidenceAngle = 90.0;
  double MinimumElevation = -90.0;
  double MaximumElevation = 90.0;
  double MinimumPointDensity = 0.0;
  double AngularStep = 0.0;
  double MemoryLimit = 2048.0;
  vtkIdType NumberOfRays = 0;
};

#endif
