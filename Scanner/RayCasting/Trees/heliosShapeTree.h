// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The tree of a mesh that deforms.

#ifndef heliosShapeTree_h
#define heliosShapeTree_h

#include "heliosBeamTree.h"
#include "heliosBoxRefit.h"
#include "heliosMeshFrames.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosScannerRayCastingModule.h" // For export macro

#include <functional>
#include <memory>

namespace helios
{

/// The part of the trees over the same frames that all threads share, made once.
class VTKHELIOSSCANNERRAYCASTING_EXPORT ShapePlan
{
public:
  /// Builds a tree over the largest of the frames, which must outlive it.
  explicit ShapePlan(const MeshFrames& frames);

  TriangleMesh Mesh;
  BeamTree Tree;
  RefitOrder Order;
  double TriangleSize = 0.0; ///< mean diagonal of the boxes of triangles [m]
};

/**
 * The tree where a mesh is: the nodes are fitted, not built. Boxes contain the triangles over a part of
 * the way between two frames, and the corners of a triangle are interpolated when a ray meets its box. One
 * per thread.
 */
class VTKHELIOSSCANNERRAYCASTING_EXPORT ShapeTree : public ShapeFollower
{
public:
  using GetPlan = std::function<std::shared_ptr<const ShapePlan>()>;

  /// Calls for the plan when the shape is known for the first time; the shape must outlive it.
  ShapeTree(const MeshShape& shape, GetPlan getPlan);

  /// Fits the boxes, unless they contain the shape.
  void Follow() override;

  const BeamTree& GetTree() const { return this->Tree; }

private:
  bool HasShape() const;
  void ChooseParts();
  void Fit();
  double GetMeanWay() const;

  const MeshShape& Shape;
  GetPlan FindPlan;
  std::shared_ptr<const ShapePlan> Plan;
  BeamTree Tree;
  BoxRefit Refit;
  const double* From = nullptr; ///< the frame before, for which the tree is fitted
  double Low = 0.0;             ///< fractions for which it is fitted
  double High = 0.0;
  int Parts = 1;      ///< parts of the way between two frames
  vtkIdType Uses = 0; ///< pulses since the last fit
};

} // namespace helios

#endif
