// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosTerrainFollow
 * @brief   waypoints at a height above the terrain, with more inserted where it is
 * uneven
 *
 * Port 0: waypoints (vtkPolyData, the points in order). Port 1: the scene. Output:
 * the waypoints, each Height above the highest surface at its x, y. With Spacing,
 * waypoints are inserted on the straight line in x, y from each to the next, evenly
 * and at most Spacing apart; they have the point arrays of the waypoint before.
 * LegIds are added: as in the input, else 0, 1, 2 ... of its waypoints, so that an
 * inserted waypoint belongs to the leg that it lies on. The output has no cells;
 * field data is passed through.
 *
 * With MaximumSlope waypoints are raised, never lowered, until no segment between
 * two is steeper: a climb starts before a cliff.
 *
 * Segments between waypoints are straight: terrain features between two are missed. Use
 * a Spacing finer than the terrain, and check with vtkHeliosClearance.
 *
 * Errors: no surface above or below a waypoint (the message gives its x, y), or one
 * that is not finite; an empty scene; a Spacing that makes more than 1e7 waypoints; a
 * trajectory (with GpsTime): only a platform makes one from these waypoints.
 *
 * @sa
 * vtkHeliosGroundSnap vtkHeliosClearance vtkHeliosPlatform
 */

#ifndef vtkHeliosTerrainFollow_h
#define vtkHeliosTerrainFollow_h

#include "vtkHeliosScannerRayCastingModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSSCANNERRAYCASTING_EXPORT vtkHeliosTerrainFollow : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosTerrainFollow* New();
  vtkTypeMacro(vtkHeliosTerrainFollow, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the height above the surface [m]. Valid range: [-1e6, 1e6].
   * Default: 50.
   */
  vtkSetClampMacro(Height, double, -1e6, 1e6);
  vtkGetMacro(Height, double);
  ///@}

  /// The surface to follow.
  enum Surfaces
  {
    GROUND = 0, ///< surfaces with a ground material; otherwise all
    TOP = 1     ///< all surfaces: also trees and roofs
  };

  ///@{
  /**
   * Set/Get the surface to follow. Default: GROUND.
   */
  vtkSetClampMacro(Surface, int, GROUND, TOP);
  vtkGetMacro(Surface, int);
  void SetSurfaceToGround() { this->SetSurface(GROUND); }
  void SetSurfaceToTop() { this->SetSurface(TOP); }
  ///@}

  ///@{
  /**
   * Set/Get the maximum spacing of waypoints in x, y [m]; 0: none are inserted.
   * Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(Spacing, double, 0.0, 1e6);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum slope between waypoints [deg]; 90: no limit. Valid
   * range: [0, 90]. Default: 90.
   */
  vtkSetClampMacro(MaximumSlope, double, 0.0, 90.0);
  vtkGetMacro(MaximumSlope, double);
  ///@}

protected:
  vtkHeliosTerrainFollow();
  ~vtkHeliosTerrainFollow() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosTerrainFollow(const vtkHeliosTerrainFollow&) = delete;
  void operator=(const vtkHeliosTerrainFollow&) = delete;

  bool Insert(vtkPolyData* waypoints, vtkPolyData* output);
  bool SetHeights(vtkPolyData* scene, vtkPolyData* output);

  double Height = 50.0;
  int Surface = GROUND;
  double Spacing = 0.0;
  double MaximumSlope = 90.0;
};

#endif
