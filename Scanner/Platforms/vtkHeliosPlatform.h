// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPlatform
 * @brief   platform motion: waypoints in, trajectory out
 *
 * Input: waypoints (vtkPolyData), the points in order. Point arrays: LegIds (optional, default 0,
 * 1, 2 ...; the leg that starts at the waypoint), and the arrays of the platform, e.g. Speed.
 *
 * Output: the trajectory (vtkPolyData), one polyline with the point arrays GpsTime [s] from
 * StartTime, never decreasing; Orientation (unit quaternion w, x, y, z, body to world; body x
 * right, y forward, z up), Velocity [m/s], LegIds. Between two samples the position is the cubic
 * polynomial of time through both positions with both velocities (linear without Velocity), and the
 * orientation rotates at a constant rate; two samples at the same time are an instant turn. A
 * single sample is a vertex and holds at all times. The field data of the waypoints (CRS, GpsEpoch)
 * is passed through.
 *
 * Errors: no waypoints, waypoints that are not finite, LegIds with more than one component.
 *
 * To add one: subclass, implement Move().
 *
 * @sa
 * vtkHeliosStaticPlatform vtkHeliosLinearPathPlatform vtkHeliosGroundVehiclePlatform
 * vtkHeliosMulticopterPlatform
 */

#ifndef vtkHeliosPlatform_h
#define vtkHeliosPlatform_h

#include "vtkHeliosScannerPlatformsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // For the samples of a path

class vtkDataArray;

namespace helios
{
struct MotionPiece;
}

class VTKHELIOSSCANNERPLATFORMS_EXPORT vtkHeliosPlatform : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkHeliosPlatform, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the time of the first waypoint [s]. Valid range: [0, 1e12].
   * Default: 0.
   */
  vtkSetClampMacro(StartTime, double, 0.0, 1e12);
  vtkGetMacro(StartTime, double);
  ///@}

protected:
  vtkHeliosPlatform() = default;
  ~vtkHeliosPlatform() override = default;

  /// A sample of the trajectory.
  struct State
  {
    double Time;
    double Position[3];
    double Orientation[4]; // w, x, y, z
    double Velocity[3];
    int LegId;
  };

  /// Appends the samples of the whole path; false after an error. There is at least one waypoint,
  /// and all are finite.
  virtual bool Move(vtkPolyData* waypoints, std::vector<State>& path) = 0;

  /// Returns whether there are two or more waypoints with valid speeds; error messages name the
  /// kind of path.
  bool CheckSpeeds(vtkPolyData* waypoints, const char* kind);

  /// Appends the samples of a motion that starts at StartTime, piece after piece; within a leg the
  /// pieces share their ends. A leg without a piece takes no time.
  void AppendMotion(vtkPolyData* waypoints, const std::vector<helios::MotionPiece>& motion,
    std::vector<State>& path) const;

  /// Returns whether no leg of a motion takes longer than an hour and 1000 times its length at
  /// Speed.
  bool CheckDurations(
    vtkPolyData* waypoints, const std::vector<helios::MotionPiece>& motion, const char* cure);

  /// Returns a point array with one component, null if missing.
  static vtkDataArray* FindValues(vtkPolyData* waypoints, const char* name);

  /// Returns the leg that starts at a waypoint.
  static int GetLegId(vtkPolyData* waypoints, vtkIdType waypoint);

  /// Computes the orientation of a level body whose y axis points along (x, y) of the world.
  static void HeadingToOrientation(double x, double y, double orientation[4]);

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double StartTime = 0.0;

private:
  vtkHeliosPlatform(const vtkHeliosPlatform&) = delete;
  void operator=(const vtkHeliosPlatform&) = delete;

  bool CheckWaypoints(vtkPolyData* waypoints);
  static void BuildTrajectory(const std::vector<State>& path, vtkPolyData* output);
};

#endif
