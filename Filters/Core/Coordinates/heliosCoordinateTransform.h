// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Transforms points between coordinate systems.

#ifndef heliosCoordinateTransform_h
#define heliosCoordinateTransform_h

#include "heliosCoordinateSystem.h"
#include "heliosStatus.h"

#include <vtkType.h>

#include <memory>
#include <string>

namespace helios
{

/**
 * Systems on WGS 84 (geographic, geocentric, local, UTM, UPS and similar maps) are computed by
 * GeographicLib, to 5e-9 m. All others use PROJ: the most accurate operation for a location whose
 * grids are installed, never a "ballpark" one that ignores the datum.
 *
 * Heights: if one of the systems has no vertical part, heights are unchanged except for the unit
 * (CoordinateSystem says which).
 * Heights above a geoid are a vertical part; converting them to ellipsoidal heights needs the geoid
 * grid. Between a system without vertical part and a geocentric or local one, heights are above the
 * ellipsoid of WGS 84.
 *
 * A copy has its own PROJ state: use one per thread.
 */
class VTKHELIOSFILTERSCORE_EXPORT CoordinateTransform
{
public:
  CoordinateTransform();
  ~CoordinateTransform();
  CoordinateTransform(const CoordinateTransform& other);
  CoordinateTransform(CoordinateTransform&& other) noexcept;
  CoordinateTransform& operator=(CoordinateTransform other) noexcept;

  /// Sets both systems. Returns an error if no transformation exists.
  Status Set(const CoordinateSystem& source, const CoordinateSystem& target);

  /// Returns whether both systems are the same: points are unchanged.
  bool IsIdentity() const;

  /// Sets the epoch of the coordinates, a decimal year, for transformations that depend on time; 0,
  /// as after Set(): not known, and PROJ takes the reference epoch of the transformation.
  void SetEpoch(double year);

  /// Returns the speed at which the image of a point moves with the epoch [m per year]; 0: none.
  double GetYearlyMotion(const double point[3]);

  /**
   * Transforms count points, x y z interleaved; from and to may be the same. Returns the first
   * point without an image (all such points become NaN), or -1.
   */
  vtkIdType Forward(const double* from, double* to, vtkIdType count);

  /**
   * Computes the Jacobian at a point, jacobian[i][k] = d to_i / d from_k, by central differences
   * (to 1e-9 of their size). Returns false if the point or its neighbourhood has no image.
   */
  bool GetJacobian(const double point[3], double jacobian[3][3]);

  /**
   * Computes the rotation of directions at a point: from east, north, up of the source to east,
   * north, up of the target, metric in both (also for geographic systems). It contains the grid
   * convergences, and for geocentric or local targets the tilt.
   */
  bool GetRotation(const double point[3], double rotation[3][3]);

  /// Returns the accuracy that PROJ states for the operation it chose last [m]; -1: unknown, 0:
  /// exact.
  double GetAccuracy() const;

  /**
   * Returns warnings about transforming points, empty without any: a better operation exists for
   * the first point, but its grids are not installed; PROJ uses different operations for the
   * points, which tears surfaces; the image of the first point depends on an epoch that is not set.
   */
  std::string GetWarning(const double* points, vtkIdType count);

  /// Returns the part of GetWarning() about the epoch.
  std::string GetEpochWarning(const double point[3]);

  /// Describes why a point has no image.
  std::string DescribeFailure(vtkIdType index, const double point[3]) const;

private:
  std::string DescribeSeam(const double* points, vtkIdType count);
  std::string DescribeMissingGrids(const double point[3]);

  struct Internals;
  std::unique_ptr<Internals> State;
};

/// Returns the code of the UTM or UPS zone of a point, "EPSG:32632"; empty if it is not on the
/// Earth.
VTKHELIOSFILTERSCORE_EXPORT std::string FindMetric(
  const CoordinateSystem& system, const double point[3]);

/**
 * Returns an error if distances in the system are not in metres: "EPSG:4326 (WGS 84) is in degrees;
 * ..." with the UTM zone of a scene point as a remedy.
 */
VTKHELIOSFILTERSCORE_EXPORT Status CheckMetric(
  const CoordinateSystem& system, const double point[3]);

} // namespace helios

#endif
