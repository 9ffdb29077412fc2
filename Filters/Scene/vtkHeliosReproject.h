// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosReproject
 * @brief   reprojects points to another coordinate system
 *
 * Input 0: a vtkPointSet: a scene, a cloud, a trajectory, waypoints. Output 0: the same, of the same
 * type, with
 * - points: those of the input in TargetCRS, double, always in the order east, north, up, angles in
 *   degrees;
 * - field data CRS: TargetCRS as given;
 * - active normals of points and cells: those of the surface in the new coordinates;
 * - point data TruePoint: transformed like points;
 * - point data Orientation, Velocity, Direction and Normal: rotated by the angle between the axes
 *   of both systems at their position (grid convergence; tilt towards geocentric or local axes);
 * - cells and everything else by reference.
 *
 * Systems are "EPSG:n", WKT, PROJ strings, or "ENU latitude longitude height" for local axes at an
 * origin on WGS 84 [degrees, m]. GeographicLib computes systems on WGS 84 (UTM, UPS, geocentric,
 * local), to 5e-9 m; PROJ the rest. If one of the systems has no heights, heights pass unchanged,
 * except for the unit. If both systems are the same in any spelling, the output is the input. Works
 * on all threads; the output does not depend on their number.
 *
 * Warnings: a source that contradicts the input; an operation less accurate than another whose
 * grids PROJ does not find; several operations over the extent of the data, which tears surfaces.
 * Errors: no source, no target, a system unknown to PROJ, no transformation between them, a point
 * outside their domain.
 *
 * @warning
 * Straight edges stay straight: a triangle of a kilometre deviates from the true surface by its
 * sagitta, about 2 cm towards local or geocentric axes.
 *
 * @sa
 * vtkHeliosSceneTransform vtkHeliosSceneComposer vtkHeliosGeoTiffSceneReader
 */

#ifndef vtkHeliosReproject_h
#define vtkHeliosReproject_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPointSetAlgorithm.h"

#include <string> // For error messages

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

  /**
   * Code and name of a coordinate system, "EPSG:32632 (WGS 84 / UTM zone 32N)", whatever its form;
   * empty if it is not known to PROJ.
   */
  static std::string DescribeCRS(const char* text);

  /**
   * Whether x and y in a coordinate system are longitude and latitude [deg]; false if it is not
   * known to PROJ.
   */
  static bool IsGeographicCRS(const char* text);

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
  void Warn(vtkPointSet* input, helios::CoordinateTransform& transform);
  helios::Status Transform(
    vtkPointSet* input, vtkPointSet* output, const helios::CoordinateTransform& transform);

  vtkTimeStamp Warned; // once for all pieces
  char* SourceCRS = nullptr;
  char* TargetCRS = nullptr;
};

#endif
