// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGroundVehiclePlatform
 * @brief   a car with front-axle steering
 *
 * Input: two or more waypoints with the point array Speed [m/s], the maximum speed from that
 * waypoint to the next (not used for the last one).
 *
 * Output: the trajectory of the middle of the rear axle, through every waypoint to rounding (1e-9
 * of its coordinates), from rest at the first one, heading to the second, until it passes the last
 * one. It is exact in time; between its samples position and attitude are within 1e-7 m and 1e-7
 * rad.
 *
 * Model, a bicycle in x, y: at steering angle d the rear axle moves along a circle of radius
 * Wheelbase / tan(d) and the body turns by v / radius. At a waypoint the car turns towards the next
 * one until that is straight ahead, then drives straight. In a turn the curvature increases at a
 * constant rate along the path, is constant and decreases again, so that the steering never exceeds
 * SteeringRate; the radius is the widest that neither departs from the straight line between
 * waypoints by more than TurnDeviation nor is wider than Speed needs, or the tightest. Where no
 * turn of less than 270 degrees leads to the waypoint, the car makes a three-point turn: it stops,
 * reverses on the opposite lock, stops, and continues.
 *
 * Along the path m dv/dt = F - Drag v - m g sin(slope), g = 9.80665 m/s^2, with F = EngineForce to
 * accelerate, -BrakeForce to brake, and the balancing force at constant speed: the closed forms of
 * linear drag, without steps. The car drives as fast as it can while it stays below Speed and, in
 * turns of radius R, below sqrt(LateralAcceleration R). The terminal speed is EngineForce / Drag.
 *
 * z follows the straight line from waypoint to waypoint along the path driven forward (reversing is
 * level), and the body pitches to that slope, over the last Wheelbase before the slope changes. It
 * does not roll. Legs of zero length take no time.
 *
 * In HELIOS files: Speed is movePerSec_m. The attribute drag is a loss per pulse, without a mass,
 * and has no physical counterpart; the defaults below replace it. See Docs/platforms.md.
 *
 * Errors: fewer than two waypoints, no Speed, a speed that is not positive and finite, a waypoint
 * directly above or below the one before, a climb that needs more than EngineForce or a descent
 * more than BrakeForce, a leg that takes over 1000 times as long as at Speed, and the errors of
 * vtkHeliosPlatform.
 *
 * @sa
 * vtkHeliosPlatform vtkHeliosLinearPathPlatform vtkHeliosMulticopterPlatform
 */

#ifndef vtkHeliosGroundVehiclePlatform_h
#define vtkHeliosGroundVehiclePlatform_h

#include "vtkHeliosPlatform.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

class VTKHELIOSSCANNERPLATFORMS_EXPORT vtkHeliosGroundVehiclePlatform : public vtkHeliosPlatform
{
public:
  static vtkHeliosGroundVehiclePlatform* New();
  vtkTypeMacro(vtkHeliosGroundVehiclePlatform, vtkHeliosPlatform);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the mass [kg]. Valid range: [1, 1e6]. Default: 1500.
   */
  vtkSetClampMacro(Mass, double, 1.0, 1e6);
  vtkGetMacro(Mass, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum engine force, forward and backward [N]. Valid range:
   * [0, 1e7]. Default: 6000.
   */
  vtkSetClampMacro(EngineForce, double, 0.0, 1e7);
  vtkGetMacro(EngineForce, double);
  ///@}

  ///@{
  /**
   * Set/Get the braking force [N]. Valid range: [0, 1e7]. Default: 6000.
   */
  vtkSetClampMacro(BrakeForce, double, 0.0, 1e7);
  vtkGetMacro(BrakeForce, double);
  ///@}

  ///@{
  /**
   * Set/Get the drag, a force proportional to speed [kg/s]. Valid range:
   * [0, 1e6]. Default: 50.
   */
  vtkSetClampMacro(Drag, double, 0.0, 1e6);
  vtkGetMacro(Drag, double);
  ///@}

  ///@{
  /**
   * Set/Get the wheelbase [m]. Valid range: [0.1, 100]. Default: 2.5.
   */
  vtkSetClampMacro(Wheelbase, double, 0.1, 100.0);
  vtkGetMacro(Wheelbase, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum steering angle to either side [deg]. Valid range:
   * [1, 80]. Default: 30.
   */
  vtkSetClampMacro(MaximumSteeringAngle, double, 1.0, 80.0);
  vtkGetMacro(MaximumSteeringAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum steering rate [deg/s]. Valid range: [1, 1e4]. Default: 30.
   */
  vtkSetClampMacro(SteeringRate, double, 1.0, 1e4);
  vtkGetMacro(SteeringRate, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum lateral acceleration in a turn [m/s^2]. Valid range:
   * [0.01, 100]. Default: 2.
   */
  vtkSetClampMacro(LateralAcceleration, double, 0.01, 100.0);
  vtkGetMacro(LateralAcceleration, double);
  ///@}

  ///@{
  /**
   * Set/Get how far a turn may depart from the straight line between waypoints
   * for a higher speed [m]; the tightest turn may exceed it. Valid range:
   * [0, 1e4]. Default: 1.
   */
  vtkSetClampMacro(TurnDeviation, double, 0.0, 1e4);
  vtkGetMacro(TurnDeviation, double);
  ///@}

protected:
  vtkHeliosGroundVehiclePlatform() = default;
  ~vtkHeliosGroundVehiclePlatform() override = default;

  bool Move(vtkPolyData* waypoints, std::vector<State>& path) override;

private:
  vtkHeliosGroundVehiclePlatform(const vtkHeliosGroundVehiclePlatform&) = delete;
  void operator=(const vtkHeliosGroundVehiclePlatform&) = delete;

  bool CheckClimb(vtkIdType waypoint, double grade);
  bool CheckPath(vtkPolyData* waypoints);

  double Mass = 1500.0;
  double EngineForce = 6000.0;
  double BrakeForce = 6000.0;
  double Drag = 50.0;
  double Wheelbase = 2.5;
  double MaximumSteeringAngle = 30.0;
  double SteeringRate = 30.0;
  double LateralAcceleration = 2.0;
  double TurnDeviation = 1.0;
};

#endif
