// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSceneMotion
 * @brief   a scene with moving parts, at a step or at a time
 *
 * Input 0: a scene (vtkPolyData, triangles with the cell array PartIds), as from
 * vtkHeliosSceneComposer. Output 0: the same with the points of moving parts after their number of
 * steps; active normals of their cells rotate with them. Points are double. All else passes by
 * reference, points too if nothing has moved.
 *
 * A step of a part is all its motions, one after the other. The position after k steps depends on k
 * only: rounding does not accumulate over rotations about a rotating axis, or a million steps of
 * 0.1 m (they are powers of one step, in extended precision).
 *
 * With TimeStep > 0 the output supports UPDATE_TIME_STEP: at time t all parts have made the whole
 * steps of t / TimeStep. Without such a request the steps set by SetStep() are used.
 *
 * @warning A part mirrored an odd number of times has triangles of opposite winding.
 *
 * Errors: a motion of a part without triangles in the scene, an axis or normal of zero length,
 * numbers that are not finite, no PartIds, points shared by a moving part and another one.
 *
 * @sa
 * vtkHeliosSceneComposer vtkHeliosSceneTransform
 */

#ifndef vtkHeliosSceneMotion_h
#define vtkHeliosSceneMotion_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the prepared parts
#include <vector> // For sequences of motions

namespace helios
{
struct MotionSequence;
}

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosSceneMotion : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSceneMotion* New();
  vtkTypeMacro(vtkHeliosSceneMotion, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds a translation [m] to every step of a part.
   */
  void AddTranslation(int part, const double shift[3]);

  /**
   * Adds a right-handed rotation by an angle [deg] to every step of a part, about an axis of any
   * length through a point: of the scene, or, with aboutCentroid, relative to the area centroid of
   * the part.
   */
  void AddRotation(int part, const double axis[3], double angle, const double center[3],
    bool aboutCentroid = false);

  /**
   * Removes all motions and steps.
   */
  void RemoveAllMotions();

  ///@{
  /**
   * Set/Get the number of steps of a part. Valid range: not negative. Default: 0.
   */
  void SetStep(int part, vtkIdType step);
  vtkIdType GetStep(int part) const;
  ///@}

  ///@{
  /**
   * Set/Get the time between two steps [s]; 0: the output does not depend on time. Valid range: [0, 1e9].
   * Default: 0.
   */
  vtkSetClampMacro(TimeStep, double, 0.0, 1e9);
  vtkGetMacro(TimeStep, double);
  ///@}

#ifndef __VTK_WRAP__
  /// Replaces the motion of a part by sequences.
  void SetMotion(int part, const std::vector<helios::MotionSequence>& sequences);
#endif

protected:
  vtkHeliosSceneMotion();
  ~vtkHeliosSceneMotion() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  struct Parts; // the moving parts, with their points and cells

  bool Prepare(vtkPolyData* scene);

  vtkHeliosSceneMotion(const vtkHeliosSceneMotion&) = delete;
  void operator=(const vtkHeliosSceneMotion&) = delete;

  std::unique_ptr<Parts> Moving;
  double TimeStep = 0.0;
};

#endif
