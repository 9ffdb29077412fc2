// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSceneMotion
 * @brief   a scene whose parts move, at a step or at a time
 *
 * Input 0: a scene (vtkPolyData, triangles with the cell array PartIds), as vtkHeliosSceneComposer
 * makes it. Output 0: the same with the points of moving parts where they are after their number of
 * steps; active normals of their cells turn with them. Points are double. All else passes by reference,
 * points too where nothing has moved.
 *
 * A step of a part is all its motions, one after the other. Where a part is after k steps follows from k
 * alone: rotations about a turning axis, or a million steps of 0.1 m, do not add up their rounding
 * (they are powers of one step, in extended precision).
 *
 * With TimeStep > 0 the output answers UPDATE_TIME_STEP: at time t all parts have made the whole steps
 * of t / TimeStep. Without such a request the steps set by SetStep() count.
 *
 * @warning A part that is mirrored an odd number of times has its triangles wound the other way round.
 *
 * Errors: a motion of a part that the scene has no triangle of, an axis or normal without length,
 * numbers that are not finite, no PartIds, points that belong to a moving part and to another one.
 *
 * @sa
 * vtkHeliosSceneComposer vtkHeliosSceneTransform
 */

#ifndef vtkHeliosSceneMotion_h
#define vtkHeliosSceneMotion_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For what is known of the parts
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
   * Adds a shift [m] to every step of a part.
   */
  void AddTranslation(int part, const double shift[3]);

  /**
   * Adds a right-handed rotation by an angle [deg] to every step of a part, about an axis of any length
   * through a point: of the scene, or, with aboutCentroid, counted from the centroid of the part (that
   * of its area).
   */
  void AddRotation(int part, const double axis[3], double angle, const double center[3],
    bool aboutCentroid = false);

  /**
   * Forgets all motions and steps.
   */
  void RemoveAllMotions();

  ///@{
  /**
   * Set/Get how many steps a part has made. Valid range: not negative. Default: 0.
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
  /// Gives a part sequences of motions, in place of what it had.
  void SetMotion(int part, const std::vector<helios::MotionSequence>& sequences);
#endif

protected:
  vtkHeliosSceneMotion();
  ~vtkHeliosSceneMotion() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  struct Parts; // what moves, and which points and cells that is

  bool Prepare(vtkPolyData* scene);

  vtkHeliosSceneMotion(const vtkHeliosSceneMotion&) = delete;
  void operator=(const vtkHeliosSceneMotion&) = delete;

  std::unique_ptr<Parts> Moving;
  double TimeStep = 0.0;
};

#endif
