// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPlatformNoise
 * @brief   position and attitude noise of a platform about its trajectory
 *
 * A strategy, const and thread-safe once set up. Each of six components (the position
 * along the world axes, and rotations about the body axes) may have its own
 * distribution:
 *
 *   p' = p + (x, y, z),   A' = A Rx(a) Ry(b) Rz(c),
 *
 * with the trajectory's position p and attitude A. Mount and beam origin rotate
 * with A', and pulses are emitted from there.
 *
 * A value holds for Lifespan pulses: pulse i has value number floor(i / Lifespan)
 * of its component (0: always number 0), with i the PulseIds over the run. Values
 * are counter-based, with a separate stream per component: they do not depend on
 * threads, pieces or other components.
 *
 * With Mode MOTION the platform moves, and the instrument knows it: points lie on the
 * surfaces hit, elsewhere than without noise. With Mode NAVIGATION_ERROR the noise is the
 * error of navigation: the pulse is emitted from the true pose; origin, direction and points
 * are reported from the trajectory's; TruePoint is where the echo came from.
 *
 * Navigation errors that are unknown to the instrument, whatever the Mode, are
 * - slow errors (SetSlowError): a first-order Gauss-Markov process per component, added to the
 *   noise above; a function of GPS time, the same for all channels and legs;
 * - Boresight b and LeverArmError l, constant, of the mount m, M on the body: the true origin is
 *   p' + A' (m + l + B M r) and the true direction A' B M d, where B = Rx(b_x) Ry(b_y) Rz(b_z), and
 *   r, d are beam origin and direction in the frame of the mount;
 * - ClockOffset c: a pulse with GPS time t was emitted from the pose at t + c.
 *
 * All errors are true minus reported.
 *
 * @warning
 * With one value per pulse (Lifespan 1) the platform has a new position every pulse.
 * Errors of navigation persist for seconds: use slow errors, or set a Lifespan of
 * PulseFrequency times that.
 *
 * @sa
 * vtkHeliosScanner vtkHeliosErrorModel
 */

#ifndef vtkHeliosPlatformNoise_h
#define vtkHeliosPlatformNoise_h

#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For the names of grades

namespace helios
{
struct DriftState;
}

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosPlatformNoise : public vtkObject
{
public:
  static vtkHeliosPlatformNoise* New();
  vtkTypeMacro(vtkHeliosPlatformNoise, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The noise components: positions [m], rotations about the body axes [deg].
  enum Components
  {
    POSITION_X = 0,
    POSITION_Y = 1,
    POSITION_Z = 2,
    ATTITUDE_X = 3, ///< nose up
    ATTITUDE_Y = 4, ///< right side down
    ATTITUDE_Z = 5  ///< to the left
  };

  ///@{
  /**
   * Sets the distribution of a component [m or deg]: normal, uniform within [minimum, maximum], or
   * no noise. Valid range: finite, stdev >= 0, minimum <= maximum. Default: no noise.
   */
  void SetNormal(int component, double mean, double stdev);
  void SetUniform(int component, double minimum, double maximum);
  void SetNone(int component);
  ///@}

  ///@{
  /**
   * Sets the limits that values of a component are clamped to [m or deg], or no limits. Valid
   * range: minimum <= maximum. Default: no limits.
   */
  void SetClip(int component, double minimum, double maximum);
  void SetNoClip(int component);
  ///@}

  ///@{
  /**
   * Set/Get the number of pulses a value of a component holds for; 0: the whole run. With
   * n channels, a lifespan of n gives all channels of a shot the same value. Valid range:
   * [0, 1e15]. Default: 1.
   */
  void SetLifespan(int component, vtkIdType pulses);
  vtkIdType GetLifespan(int component) const;
  ///@}

  /// The meaning of the noise.
  enum Modes
  {
    MOTION = 0,          ///< known to the instrument: points lie on surfaces
    NAVIGATION_ERROR = 1 ///< unknown to the instrument: points are displaced
  };

  ///@{
  /**
   * Set/Get the meaning of the noise. Default: MOTION, as in HELIOS.
   */
  vtkSetClampMacro(Mode, int, MOTION, NAVIGATION_ERROR);
  vtkGetMacro(Mode, int);
  void SetModeToMotion() { this->SetMode(MOTION); }
  void SetModeToNavigationError() { this->SetMode(NAVIGATION_ERROR); }
  ///@}

  ///@{
  /**
   * Set/Get the slow error of a component: its RMS [m or deg], 0: none, and the correlation time T
   * [s], so that E[e(t) e(t + s)] = rms^2 exp(-|s| / T). Valid range: rms 0 or more, T [1e-3, 1e9].
   * Default: no error, T 60 s.
   */
  void SetSlowError(int component, double rms, double correlationTime);
  double GetSlowErrorRMS(int component) const;
  double GetSlowErrorTime(int component) const;
  ///@}

  /**
   * Sets the RMS of the slow errors of all components to the values of a class of GNSS/IMU
   * solutions, by a name of GetGradeNames(), and keeps the correlation times. Returns false, with
   * an error, for another name.
   */
  bool SetGrade(const std::string& name);

  /**
   * Returns the names of SetGrade(), separated by blanks: "consumer", "tactical", "survey",
   * "navigation". Docs/trajectories.md has their numbers and sources.
   */
  static std::string GetGradeNames();

  ///@{
  /**
   * Set/Get the boresight misalignment: rotations of the mount about the x, y and z axes of the body
   * [deg]. Valid range: [-180, 180]. Default: 0, 0, 0.
   */
  void SetBoresight(double x, double y, double z);
  void SetBoresight(const double angles[3]) { this->SetBoresight(angles[0], angles[1], angles[2]); }
  const double* GetBoresight() const VTK_SIZEHINT(3) { return this->Boresight; }
  ///@}

  ///@{
  /**
   * Set/Get the error of the lever arm, along the axes of the body [m]. Valid range: finite.
   * Default: 0, 0, 0.
   */
  void SetLeverArmError(double x, double y, double z);
  void SetLeverArmError(const double error[3])
  {
    this->SetLeverArmError(error[0], error[1], error[2]);
  }
  const double* GetLeverArmError() const VTK_SIZEHINT(3) { return this->LeverArmError; }
  ///@}

  ///@{
  /**
   * Set/Get how late the time stamps of pulses are behind the clock of the trajectory, the true time
   * of emission less the GPS time [s]. Valid range: [-1e6, 1e6]. Default: 0.
   */
  vtkSetClampMacro(ClockOffset, double, -1e6, 1e6);
  double GetClockOffset() const { return this->ClockOffset; }
  ///@}

  /// Returns whether any component has a distribution or an error.
  bool IsOn() const;

  /// Returns whether any component has a distribution.
  bool HasNoise() const;

  /// Returns whether there are slow errors, boresight, lever arm error or clock offset.
  bool HasErrors() const;

  /// Returns whether the noise is not in the reported origin, direction and points.
  bool IsUnknown() const { return this->Mode == NAVIGATION_ERROR; }

  /**
   * Computes the values of all components for a pulse [m, deg], in the order of Components; seed is
   * the scanner's.
   */
  void GetValues(vtkIdType seed, vtkIdType pulse, double values[6]) const;

  /**
   * Computes the slow errors of all components at a GPS time [s], in m and deg, in the order of
   * Components; seed is the scanner's.
   */
  void GetSlowErrors(vtkIdType seed, double time, double values[6]) const;

#ifndef __VTK_WRAP__
  /// Computes the slow errors faster at successive times; one cursor per thread and seed.
  void GetSlowErrors(
    vtkIdType seed, double time, helios::DriftState& cursor, double values[6]) const;
#endif

protected:
  vtkHeliosPlatformNoise() = default;
  ~vtkHeliosPlatformNoise() override = default;

private:
  vtkHeliosPlatformNoise(const vtkHeliosPlatformNoise&) = delete;
  void operator=(const vtkHeliosPlatformNoise&) = delete;

  enum Distributions
  {
    NONE,
    NORMAL,
    UNIFORM
  };

  /// A distribution: a + b n, n standard normal, or uniform within [a, b].
  struct Component
  {
    int Distribution = NONE;
    double A = 0.0;
    double B = 0.0;
    double ClipMinimum = -VTK_DOUBLE_MAX;
    double ClipMaximum = VTK_DOUBLE_MAX;
    vtkIdType Lifespan = 1;
    double SlowRMS = 0.0;
    double SlowTime = 60.0;
  };

  bool CheckComponent(int component);
  void SetDistribution(int component, int distribution, double a, double b);

  Component All[6];
  int Mode = MOTION;
  double Boresight[3] = { 0.0, 0.0, 0.0 };
  double LeverArmError[3] = { 0.0, 0.0, 0.0 };
  double ClockOffset = 0.0;
};

#endif
