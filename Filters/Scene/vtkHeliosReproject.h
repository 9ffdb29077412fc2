// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosReproject
 * @brief   reprojects points to another coordinate system
 *
 * Input 0: a vtkPointSet: a scene, a cloud, a trajectory, waypoints. Output 0: the same, of the
 * same type, with
 * - points: the input's points in TargetCRS, double, always in the order east, north, up, angles in
 *   degrees;
 * - field data CRS: TargetCRS as given;
 * - active normals of points and cells: normals of the surface in the new coordinates;
 * - point data TruePoint: transformed like points;
 * - point data Orientation, Velocity, Direction and Normal: rotated by the angle between the axes
 *   of both systems at their position (grid convergence; tilt towards geocentric or local axes);
 * - cells and everything else by reference.
 *
 * Systems are "EPSG:n", WKT, PROJ strings, or "ENU latitude longitude height" for local axes at an
 * origin on WGS 84 [degrees, m]. GeographicLib computes systems on WGS 84 (UTM, UPS, geocentric,
 * local), to 5e-9 m; PROJ the rest. If one of the systems has no heights, heights pass unchanged,
 * except for the unit, which is the unit of x and y (metres beside degrees) where the system does
 * not state it. If both systems are the same in any spelling, the output is the input. Works on all
 * threads; the output does not depend on their number.
 *
 * Transformations between plates depend on the epoch of the coordinates: Epoch, else the mean of
 * point data GpsTime after field data GpsEpoch, else the reference epoch of the transformation.
 *
 * Warnings: a source that contradicts the input; an operation less accurate than another whose
 * grids PROJ does not find; several operations over the extent of the data, which tears surfaces;
 * an epoch that is needed and not known; heights in feet because x and y are. Errors: no source, no
 * target, a system unknown to PROJ, no transformation between them, a point outside their domain.
 *
 * @warning
 * Straight edges stay straight: a triangle of a kilometre deviates from the true surface by its
 * sagitta, about 2 cm towards local or geocentric axes.
 *
 * @sa
 * vtkHeliosCoordinateSystem vtkHeliosSceneTransform vtkHeliosSceneComposer
 * vtkHeliosGeoTiffSceneReader
 */

#ifndef vtkHeliosReproject_h
#define vtkHeliosReproject_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPointSetAlgorithm.h"

class vtkPointSet;

namespace helios
{
class CoordinateSystem;
class CoordinateTransform;
class Status;
}

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosReproject : public vtkPointSetAlgorithm
{
public:
  static vtkHeliosReproject* New();
  vtkTypeMacro(vtkHeliosReproject, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the coordinate system of the input. Default: not set, which uses the CRS of the input's
   * field data.
   */
  vtkSetStringMacro(SourceCRS);
  vtkGetStringMacro(SourceCRS);
  ///@}

  ///@{
  /**
   * Set/Get the coordinate system of the output. Default: not set, which is an error.
   */
  vtkSetStringMacro(TargetCRS);
  vtkGetStringMacro(TargetCRS);
  ///@}

  ///@{
  /**
   * Set/Get the epoch of the input's coordinates, a decimal year, such as 2026.5, for systems that
   * move with a plate. Valid range: [0, 3000]. Default: 0, which takes the times of the input.
   */
  vtkSetClampMacro(Epoch, double, 0.0, 3000.0);
  vtkGetMacro(Epoch, double);
  ///@}

  ///@{
  /**
   * Set/Get the metres per unit of the input's heights, in place of what its system states. Valid
   * range: [0, 1000]. Default: 0, as the system states, else the unit of x and y.
   */
  vtkSetClampMacro(SourceHeightUnit, double, 0.0, 1000.0);
  vtkGetMacro(SourceHeightUnit, double);
  ///@}

protected:
  vtkHeliosReproject() = default;
  ~vtkHeliosReproject() override;

  int ExecuteInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosReproject(const vtkHeliosReproject&) = delete;
  void operator=(const vtkHeliosReproject&) = delete;

  bool FindSystems(
    vtkPointSet* input, helios::CoordinateSystem& source, helios::CoordinateSystem& target);
  bool SetHeightUnit(helios::CoordinateSystem& source);
  void Warn(vtkPointSet* input, helios::CoordinateTransform& transform);
  helios::Status Transform(
    vtkPointSet* input, vtkPointSet* output, const helios::CoordinateTransform& transform);

  vtkTimeStamp Warned; // once for all pieces
  double Epoch = 0.0;
  double SourceHeightUnit = 0.0;
  char* SourceCRS = nullptr;
  char* TargetCRS = nullptr;
};

#endif
