// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosViewsheds
 * @brief   which scan position sees which test point
 *
 * Port 0: the scene (triangles). Port 1: candidates, points where the instrument would be. Port 2:
 * test points; point array Normal (3 components), if there is one, gives incidence angles.
 *
 * Output: the candidates, with the point arrays Visibility (unsigned 64-bit words, test point v is
 * bit v % 64 of component v / 64), ViewshedSize (int64, how many are seen) and, where there are
 * normals, MeanIncidenceAngle [deg] of the lines of sight, from the normal whichever way it looks, in
 * [0, 90]; NaN where nothing is seen.
 *
 * A test point is seen if nothing is nearer than HitTolerance before it. With BothSides the first
 * surface must also be no further behind it (Bechtold and Hoefle 2016, section 10: the first hit lies
 * within the tolerance of the point). Points out of range, out of the field of view, at too flat an
 * incidence or too thinly scanned are not seen; no such limit is set by default. Where there are
 * normals, lines are aimed a thousandth of HitTolerance behind the surface: a point on an edge would be hit
 * or missed by rounding.
 *
 * Output can be asked for in pieces, contiguous ranges of the candidates: a matrix larger than
 * memory is made piece by piece. The same bytes for any number of threads.
 *
 * @warning
 * Turbid voxels are seen through.
 *
 * Errors: an empty scene or one that is not of finite triangles; no candidates or test points, or
 * ones that are not finite; a limit that asks for normals where there are none; a matrix beyond
 * MemoryLimit; abortion.
 *
 * @sa
 * vtkHeliosScanPositionCandidates vtkHeliosVisibilityTestPoints vtkHeliosScanPositionPlanner
 */

#ifndef vtkHeliosViewsheds_h
#define vtkHeliosViewsheds_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For the ray caster

#include <string> // For what is wrong

class vtkHeliosRayCaster;

class VTKHELIOSPLANNING_EXPORT vtkHeliosViewsheds : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosViewsheds* New();
  vtkTypeMacro(vtkHeliosViewsheds, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get what casts the rays. Default: the default backend.
   */
  void SetRayCaster(vtkHeliosRayCaster* caster);
  vtkHeliosRayCaster* GetRayCaster() const;
  ///@}

  ///@{
  /**
   * Set/Get how far before a test point, along the line of sight, a surface may be that does not
   * hide it [m]. Valid range: [1e-6, 1e3]. Default: 0.05.
   */
  vtkSetClampMacro(HitTolerance, double, 1e-6, 1e3);
  vtkGetMacro(HitTolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get whether there must be a surface within HitTolerance of the test point. Default: off, a
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
   * Set/Get the field of view of the instrument, upright, as angles above the horizon [deg].
   * Valid range: [-90, 90]. Default: -90 and 90.
   */
  vtkSetClampMacro(MinimumElevation, double, -90.0, 90.0);
  vtkGetMacro(MinimumElevation, double);
  vtkSetClampMacro(MaximumElevation, double, -90.0, 90.0);
  vtkGetMacro(MaximumElevation, double);
  ///@}

  ///@{
  /**
   * Set/Get how many points a square metre of surface shall have at least from a single position
   * [1/m2], given the angle between neighbouring pulses [deg]: at range R and incidence i
   * that is cos(i) / (R AngularStep)^2. Valid range: [0, 1e12] and [0, 90]. Default: 0,
   * any, and 0.
   */
  vtkSetClampMacro(MinimumPointDensity, double, 0.0, 1e12);
  vtkGetMacro(MinimumPointDensity, double);
  vtkSetClampMacro(AngularStep, double, 0.0, 90.0);
  vtkGetMacro(AngularStep, double);
  ///@}

  ///@{
  /**
   * Set/Get the memory that the matrix, or a piece of it, may take [MiB]. Valid range: [1, 1e9].
   * Default: 2048.
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
  std::string FindFault(vtkPolyData* scene, vtkPolyData* candidates, vtkPolyData* testPoints) const;
  std::string FindExcess(vtkIdType candidates, vtkIdType testPoints) const;

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
