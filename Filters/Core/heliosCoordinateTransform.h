// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Points from one coordinate system to another.

#ifndef heliosCoordinateTransform_h
#define heliosCoordinateTransform_h

#include "heliosCoordinateSystem.h"

#include <vtkType.h>

#include <memory>
#include <string>

namespace helios
{

/**
 * Between systems on WGS 84 (geographic, geocentric, local, UTM, UPS and other maps of their kind)
 * GeographicLib computes, to 5e-9 m. Everything else is PROJ's: of the operations it has for a
 * place, the most accurate whose grids are installed, and never a "ballpark" one that ignores the
 * datum.
 *
 * Heights: where one of two systems says nothing of heights, they pass as they are, but for the
 * unit; above a geoid counts as said, and then needs the geoid's grid towards heights above the
 * ellipsoid. Where a system that says nothing meets a geocentric or local one, its heights are
 * above the ellipsoid of WGS 84.
 *
 * A copy has its own state of PROJ: one a thread.
 */
class VTKHELIOSFILTERSCORE_EXPORT CoordinateTransform
{
public:
  CoordinateTransform();
  ~CoordinateTransform();
  CoordinateTransform(const CoordinateTransform& other);
  CoordinateTransform(CoordinateTransform&& other) noexcept;
  CoordinateTransform& operator=(CoordinateTransform other) noexcept;

  /// From one system to another; says in words why there is no way, or returns an empty text.
  std::string Set(const CoordinateSystem& source, const CoordinateSystem& target);

  /// Whether both systems are the same: points stay as they are.
  bool IsIdentity() const;

  /**
   * Transforms count points, x y z after x y z; from may be to. Returns the first point that has no
   * image (it and all such are NaN), or -1.
   */
  vtkIdType Forward(const double* from, double* to, vtkIdType count);

  /**
   * How the coordinates at a point change with those in the source: jacobian[i][k] = d to_i / d from_k,
   * by central differences (to 1e-9 of their size). False where the point or its surroundings have
   * no image.
   */
  bool GetJacobian(const double point[3], double jacobian[3][3]);

  /**
   * The rotation that turns directions at a point: east, north, up of the source into those of the
   * target, metric in both (geographic ones too). It is that of the grids' convergences, and towards
   * geocentric or local systems the tilt.
   */
  bool GetRotation(const double point[3], double rotation[3][3]);

  /// How accurate the operation that PROJ chose last says it is [m]; -1: not known, 0: exact.
  double GetAccuracy() const;

  /**
   * What is worth a warning about transforming points: that a better operation exists for the first
   * of them whose grids are not installed; that PROJ takes different operations for them, which
   * tears surfaces. Empty: nothing.
   */
  std::string GetWarning(const double* points, vtkIdType count);

  /// Why a point has no image, in words.
  std::string DescribeFailure(vtkIdType index, const double point[3]) const;

private:
  std::string DescribeSeam(const double* points, vtkIdType count);
  std::string DescribeMissingGrids(const double point[3]);

  struct Internals;
  std::unique_ptr<Internals> State;
};

/**
 * What is wrong with a scene in this system, in which distances are to be metres: "EPSG:4326
 * (WGS 84) is in degrees; ..." with the UTM zone of a point of it as a cure. Empty: nothing.
 */
VTKHELIOSFILTERSCORE_EXPORT std::string GetMetricProblem(
  const CoordinateSystem& system, const double point[3]);

} // namespace helios

#endif
