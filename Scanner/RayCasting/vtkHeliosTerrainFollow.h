// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosTerrainFollow
 * @brief   waypoints at a height above the terrain, with more between where it is uneven
 *
 * Port 0: waypoints (vtkPolyData, the points in order). Port 1: the scene. Output:
 * the waypoints, each Height above the highest surface at its x, y. With
 * Spacing, waypoints are inserted on the straight way in x, y from each to the
 * next, evenly and at most Spacing apart; they have the point arrays of the
 * waypoint before. LegIds are there, too: as the input has them, else 0, 1, 2 ... of
 * its waypoints, so that an inserted waypoint belongs to the leg that it lies on.
 * The output has no cells; field data passes.
 *
 * With MaximumSlope waypoints are raised, never lowered, until no way between two
 * is steeper: what climbs a cliff starts to climb before it.
 *
 * Between waypoints the way is straight: what sticks out of the terrain between two
 * is not seen. Take a Spacing finer than the terrain, and let vtkHeliosClearance check.
 *
 * Errors: no surface above or below a waypoint (it is named with its x, y), or one
 * that is not finite; an empty scene; a Spacing that makes more than 1e7 waypoints; a
 * trajectory (with GpsTime): a platform makes one of these waypoints.
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

  /// What is flown over.
  enum Surfaces
  {
    GROUND = 0, ///< surfaces with a ground material; all where there is none
    TOP = 1     ///< all surfaces: also trees and roofs
  };

  ///@{
  /**
   * Set/Get what is flown over. Default: GROUND.
   */
  vtkSetClampMacro(Surface, int, GROUND, TOP);
  vtkGetMacro(Surface, int);
  void SetSurfaceToGround() { this->SetSurface(GROUND); }
  void SetSurfaceToTop() { this->SetSurface(TOP); }
  ///@}

  ///@{
  /**
   * Set/Get how far apart waypoints are at most in x, y [m]; 0: none are inserted.
   * Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(Spacing, double, 0.0, 1e6);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Set/Get how steep the way between waypoints is at most [deg]; 90: no limit.
   * Valid range: [0, 90]. Default: 90.
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
