// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Transforms the points and directions of a data set to another coordinate system, on all threads.

#ifndef heliosReprojection_h
#define heliosReprojection_h

#include "heliosCoordinateTransform.h"
#include "heliosStatus.h"

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
  /// The operation on a point: false if it has no image.
  using Work = std::function<bool(CoordinateTransform&, const double point[3], vtkIdType index)>;

  /// Receives the share of work done; returns whether to continue.
  using Watcher = std::function<bool(double)>;

  Reprojection(const CoordinateTransform& transform, Watcher watcher);

  /// @{
  /// Transforms the contents of a data set; its points stay in the source system until the last
  /// step.
  Status TransformCells(vtkPointSet* from, vtkPointSet* to);
  Status TransformPointData(vtkPointSet* from, vtkPointSet* to);
  Status TransformPoints(vtkPointSet* from, vtkPointSet* to);
  ///@}

  bool IsAborted() const { return this->Aborted; }

private:
  Status Run(vtkDataArray* places, const Work& work, const std::string& what);
  Status TurnNormals(vtkDataArray* places, vtkDataArray* normals, const std::string& what);
  Status TurnVectors(vtkDataArray* places, vtkDataArray* vectors);
  Status TurnFrames(vtkDataArray* places, vtkDataArray* quaternions);
  Status Move(vtkDataArray* places, vtkDataArray* images);

  CoordinateTransform Transform;
  vtkSMPThreadLocal<CoordinateTransform> Transforms;
  Watcher Watch;
  bool Aborted = false;
};

} // namespace helios

#endif
