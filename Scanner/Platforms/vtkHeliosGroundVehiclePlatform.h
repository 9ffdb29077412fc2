// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGroundVehiclePlatform
 * @brief   a car, steered by its front axle
 *
 * Input: two or more waypoints with the point array Speed [m/s], the speed that
 * is not exceeded from that waypoint to the next (the last one's is not used).
 *
 * Output: the trajectory of the middle of the rear axle, through every waypoint
 * to rounding (1e-9 of its coordinates), from rest at the first one, where the
 * car looks at the second, until it passes the last one. It is exact in time;
 * between its samples position and attitude are within 1e-7 m and 1e-7 rad.
 *
 * Model, a bicycle in x, y: at steering angle d the rear axle runs along a circle
 * of radius Wheelbase / tan(d) and the body turns by v / radius. At a waypoint the
 * car turns towards the next one until that lies straight ahead, then drives
 * straight. In a turn the curvature grows at a constant rate along the way, stays
 * and falls again, so that the front wheels never turn faster than SteeringRate;
 * the radius is the widest that neither leaves the straight way from waypoint to
 * waypoint by more than TurnDeviation nor is wider than Speed needs, or the
 * tightest. Where no turn of less than 270 degrees leads to the waypoint, the car
 * does a three-point manoeuvre: it stops, backs up on the other lock, stops, and
 * goes on.
 *
 * Along the way m dv/dt = F - Drag v - m g sin(slope), g = 9.80665 m/s^2, with F
 * = EngineForce to go faster, -BrakeForce to go slower, and what it takes to keep
 * a speed: the closed forms of linear drag, without steps. The speed is that of
 * the fastest drive that stays below Speed and, in turns of radius R, below
 * sqrt(LateralAcceleration R). The terminal speed is EngineForce / Drag.
 *
 * z follows the straight line from waypoint to waypoint along the way driven
 * forward (backing up is level), and the body pitches to that slope, over the
 * last Wheelbase before the slope changes. It does not roll. Legs of zero length
 * take no time.
 *
 * In HELIOS files: Speed is movePerSec_m. The attribute drag is a loss a pulse,
 * without a mass, and has no physical counterpart; the defaults below stand for
 * it. See Docs/platforms.md.
 *
 * Errors: fewer than two waypoints, no Speed, a speed that is not positive and
 * finite, a waypoint straight above or below the one before, a climb that takes
 * more than EngineForce or a descent more than BrakeForce, a leg that takes over
 * 1000 times as long as at Speed, and those of vtkHeliosPlatform.
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
   * Set/Get the largest force of the engine, forward and backward [N]. Valid
   * range: [0, 1e7]. Default: 6000.
   */
  vtkSetClampMacro(EngineForce, double, 0.0, 1e7);
  vtkGetMacro(EngineForce, double);
  ///@}

  ///@{
  /**
   * Set/Get the force that the brakes slow down with [N]. Valid range: [0, 1e7].
   * Default: 6000.
   */
  vtkSetClampMacro(BrakeForce, double, 0.0, 1e7);
  vtkGetMacro(BrakeForce, double);
  ///@}

  ///@{
  /**
   * Set/Get the drag, a force that grows linearly with speed [kg/s]. Valid
   * range: [0, 1e6]. Default: 50.
   */
  vtkSetClampMacro(Drag, double, 0.0, 1e6);
  vtkGetMacro(Drag, double);
  ///@}

  ///@{
  /**
   * Set/Get the distance of the axles [m]. Valid range: [0.1, 100]. Default: 2.5.
   */
  vtkSetClampMacro(Wheelbase, double, 0.1, 100.0);
  vtkGetMacro(Wheelbase, double);
  ///@}

  ///@{
  /**
   * Set/Get how far the front wheels turn to either side [deg]. Valid range:
   * [1, 80]. Default: 30.
   */
  vtkSetClampMacro(MaximumSteeringAngle, double, 1.0, 80.0);
  vtkGetMacro(MaximumSteeringAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get how fast the front wheels turn at most [deg/s]. Valid range: [1, 1e4].
   * Default: 30.
   */
  vtkSetClampMacro(SteeringRate, double, 1.0, 1e4);
  vtkGetMacro(SteeringRate, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest centripetal acceleration in a turn [m/s^2]. Valid range:
   * [0.01, 100]. Default: 2.
   */
  vtkSetClampMacro(LateralAcceleration, double, 0.01, 100.0);
  vtkGetMacro(LateralAcceleration, double);
  ///@}

  ///@{
  /**
   * Set/Get how far a turn may leave the straight way between waypoints to be
   * taken faster [m]; the tightest turn may leave it by more. Valid range: [0,
   * 1e4]. Default: 1.
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
  bool CheckWay(vtkPolyData* waypoints);

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
