// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMulticopterPlatform
 * @brief   a multicopter or helicopter that tilts to accelerate
 *
 * Input: two or more waypoints with the point arrays
 * - Speed [m/s]: the maximum speed from that waypoint to the next (not used for the last one);
 * - StopAndTurn (optional, default 1): it comes to rest at the waypoint, hovers, turns to the next
 *   one at YawRate, and starts again;
 * - SmoothTurn (optional, default 0; overrides StopAndTurn): it cuts the corner by a banked turn
 *   between the legs before and after; the middle of the turn is nearest to the waypoint. With
 *   neither it passes the waypoint and turns to the next after that, swinging out;
 * - YawAtDeparture (optional, NaN: not given): the heading of its y axis from there on, clockwise
 *   from north (world y) [deg]; only at waypoints where it rests.
 *
 * Output: the trajectory of the mount's origin, from rest at the first waypoint to the last one (at
 * rest there if it stops and turns). It passes through every waypoint to rounding (1e-9 of its
 * coordinates), except where SmoothTurn cuts a corner: by less than R (1 / cos(turn / 2) - 1) and
 * the length of rolling in. In time it is accurate to 1e-9 m; between its samples position and
 * attitude are within 1e-7 m and 1e-7 rad. A leg starts where it leaves its waypoint, turn on the
 * spot included, or in the middle of a smooth turn.
 *
 * Model: m a = T - m g z - DragCoefficient |v| v, g = 9.80665 m/s^2, with thrust T
 * along the body's z axis: the body tilts to T, and the scanner with it. Along a
 * straight line the tilt changes at up to PitchRate, up to MaximumPitch, the
 * fastest flight with these limits: level, dv/dt = g tan(tilt) - (c / m) v^2,
 * terminal speed sqrt(m g tan(tilt) / c). Constant tilts are in closed form,
 * changing ones in RK4 steps of TimeStep. Speeds above 99 % of the terminal speed
 * at MaximumPitch are not reached. Turns are flown at constant speed, banked up to
 * MaximumRoll: R = v^2 / (g tan(bank)), or v / YawRate where that is more; the bank
 * changes at RollRate. Legs of any slope are flown: turns are in the plane of both
 * legs. The nose stays along the path, or at the offset from it given by
 * YawAtDeparture.
 *
 * A turn that does not fit between its waypoints is flown slower; one of more than 150 degrees,
 * onto a vertical leg or slower than 2 % of Speed is a stop, with a turn on the spot. With
 * SlowdownEnabled off a warning reports this. Legs of zero length take no time except the turn on
 * the spot.
 *
 * In HELIOS files: Speed is movePerSec_m, StopAndTurn and SmoothTurn come from the leg, YawAtDeparture is -yawAtDeparture_deg, YawRate, PitchRate and RollRate
 * are yaw_speed_deg, pitch_speed_deg and roll_speed_deg, MaximumPitch and
 * MaximumRoll are pitch_offset_deg and roll_offset_deg, and DragCoefficient = m g
 * tan|base_pitch_deg| / v^2 with the fastest leg's v: it cruises there at that
 * pitch. See Docs/platforms.md.
 *
 * Errors: fewer than two waypoints, no Speed, a speed that is not positive and finite, waypoints
 * more than 1e9 m apart, thrust that does not lift the mass, a drag of more than 1 kg/m per
 * kilogram, a point array with more than one component, a leg that takes over 1000 times as long as
 * at Speed, and the errors of vtkHeliosPlatform.
 *
 * @sa
 * vtkHeliosPlatform vtkHeliosLinearPathPlatform vtkHeliosGroundVehiclePlatform
 */

#ifndef vtkHeliosMulticopterPlatform_h
#define vtkHeliosMulticopterPlatform_h

#include "vtkHeliosPlatform.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

class VTKHELIOSSCANNERPLATFORMS_EXPORT vtkHeliosMulticopterPlatform : public vtkHeliosPlatform
{
public:
  static vtkHeliosMulticopterPlatform* New();
  vtkTypeMacro(vtkHeliosMulticopterPlatform, vtkHeliosPlatform);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the mass [kg]. Valid range: [0.01, 1e5]. Default: 10.
   */
  vtkSetClampMacro(Mass, double, 0.01, 1e5);
  vtkGetMacro(Mass, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum thrust [N]; 0 is twice the weight. Valid range: [0, 1e7].
   * Default: 0.
   */
  vtkSetClampMacro(MaximumThrust, double, 0.0, 1e7);
  vtkGetMacro(MaximumThrust, double);
  ///@}

  ///@{
  /**
   * Set/Get the coefficient c of the drag c v^2 [kg/m]. Valid range: [0, 1e4].
   * Default: 0.01, a terminal speed of 83 m/s.
   */
  vtkSetClampMacro(DragCoefficient, double, 0.0, 1e4);
  vtkGetMacro(DragCoefficient, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum pitch, forward and back [deg]. Valid range: [0.1, 80].
   * Default: 35.
   */
  vtkSetClampMacro(MaximumPitch, double, 0.1, 80.0);
  vtkGetMacro(MaximumPitch, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum bank in turns [deg]. Valid range: [0.1, 80]. Default: 25.
   */
  vtkSetClampMacro(MaximumRoll, double, 0.1, 80.0);
  vtkGetMacro(MaximumRoll, double);
  ///@}

  ///@{
  /**
   * Set/Get the pitch rate [deg/s]. Valid range: [1, 1000]. Default: 85.94.
   */
  vtkSetClampMacro(PitchRate, double, 1.0, 1000.0);
  vtkGetMacro(PitchRate, double);
  ///@}

  ///@{
  /**
   * Set/Get the roll rate [deg/s]. Valid range: [1, 1000]. Default: 28.65.
   */
  vtkSetClampMacro(RollRate, double, 1.0, 1000.0);
  vtkGetMacro(RollRate, double);
  ///@}

  ///@{
  /**
   * Set/Get the yaw rate on the spot, and its maximum in turns [deg/s]. Valid
   * range: [0.1, 1000]. Default: 85.94.
   */
  vtkSetClampMacro(YawRate, double, 0.1, 1000.0);
  vtkGetMacro(YawRate, double);
  ///@}

  ///@{
  /**
   * Set/Get whether to slow down for turns that do not fit between the waypoints.
   * If off, it still slows down, with a warning. Default: on.
   */
  vtkSetMacro(SlowdownEnabled, bool);
  vtkGetMacro(SlowdownEnabled, bool);
  vtkBooleanMacro(SlowdownEnabled, bool);
  ///@}

  ///@{
  /**
   * Set/Get the distance before a stop or a slower turn at which it begins to slow
   * down [m], at most half the leg and at least the distance that MaximumPitch
   * needs. Valid range: [0, 1e6]. Default: 0, as late as possible.
   */
  vtkSetClampMacro(SlowdownDistance, double, 0.0, 1e6);
  vtkGetMacro(SlowdownDistance, double);
  ///@}

  ///@{
  /**
   * Set/Get the integration step while the tilt changes [s]; a change takes 4000
   * steps at most. Valid range: [1e-4, 0.1]. Default: 0.01, with an error below
   * 1e-9 m.
   */
  vtkSetClampMacro(TimeStep, double, 1e-4, 0.1);
  vtkGetMacro(TimeStep, double);
  ///@}

protected:
  vtkHeliosMulticopterPlatform() = default;
  ~vtkHeliosMulticopterPlatform() override = default;

  bool Move(vtkPolyData* waypoints, std::vector<State>& path) override;

private:
  vtkHeliosMulticopterPlatform(const vtkHeliosMulticopterPlatform&) = delete;
  void operator=(const vtkHeliosMulticopterPlatform&) = delete;

  bool CheckWaypointArrays(vtkPolyData* waypoints);
  bool CheckPath(vtkPolyData* waypoints);

  double Mass = 10.0;
  double MaximumThrust = 0.0;
  double DragCoefficient = 0.01;
  double MaximumPitch = 35.0;
  double MaximumRoll = 25.0;
  double PitchRate = 85.94;
  double RollRate = 28.65;
  double YawRate = 85.94;
  bool SlowdownEnabled = true;
  double SlowdownDistance = 0.0;
  double TimeStep = 0.01;
};

#endif
