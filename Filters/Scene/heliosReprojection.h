// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The points and directions of a data set through a coordinate transformation, on all threads.

#ifndef heliosReprojection_h
#define heliosReprojection_h

#include "heliosCoordinateTransform.h"

#include <vtkSMPThreadLocal.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>

class vtkDataArray;
class vtkPointSet;
class vtkPoints;

namespace helios
{

class Reprojection
{
public:
  /// What is done with a point: false, where it has no image.
  using Work = std::function<bool(CoordinateTransform&, const double point[3], vtkIdType index)>;

  /// Told the share that is done of a piece of work; returns whether to go on.
  using Watcher = std::function<bool(double)>;

  Reprojection(const CoordinateTransform& transform, Watcher watcher);

  ///@{
  /// Transforms what a data set carries; its points are those of the source until the last step.
  /// Says in words what is wrong, or returns an empty text.
  std::string TransformCells(vtkPointSet* from, vtkPointSet* to);
  std::string TransformPointData(vtkPointSet* from, vtkPointSet* to);
  std::string TransformPoints(vtkPointSet* from, vtkPointSet* to);
  ///@}

  bool IsAborted() const { return this->Aborted; }

private:
  std::string Run(vtkDataArray* places, const Work& work, const std::string& what);
  std::string TurnNormals(vtkDataArray* places, vtkDataArray* normals, const std::string& what);
  std::string TurnVectors(vtkDataArray* places, vtkDataArray* vectors);
  std::string TurnFrames(vtkDataArray* places, vtkDataArray* quaternions);
  std::string Move(vtkDataArray* places, vtkDataArray* images);

  CoordinateTransform Transform;
  vtkSMPThreadLocal<CoordinateTransform> Transforms;
  Watcher Watch;
  bool Aborted = false;
};

} // namespace helios

#endif
