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
 * @warning
 * With one value per pulse (Lifespan 1) the platform has a new position every pulse.
 * Navigation errors persist for seconds: set a Lifespan of PulseFrequency times
 * that.
 *
 * @sa
 * vtkHeliosScanner vtkHeliosErrorModel
 */

#ifndef vtkHeliosPlatformNoise_h
#define vtkHeliosPlatformNoise_h

#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkObject.h"

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
   * Set the distribution of a component [m or deg]: normal, uniform within
   * [minimum, maximum], or no noise. Valid range: finite, stdev >= 0,
   * minimum <= maximum. Default: no noise.
   */
  void SetNormal(int component, double mean, double stdev);
  void SetUniform(int component, double minimum, double maximum);
  void SetNone(int component);
  ///@}

  ///@{
  /**
   * Set the limits that values of a component are clamped to [m or deg], or no
   * limits. Valid range: minimum <= maximum. Default: no limits.
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

  /// Whether any component has a distribution.
  bool IsOn() const;

  /// Whether origin, direction and points are reported from the trajectory's pose.
  bool IsUnknown() const { return this->Mode == NAVIGATION_ERROR; }

  /**
   * The values of all components for a pulse [m, deg], in the order of Components; seed as
   * the scanner's.
   */
  void GetValues(vtkIdType seed, vtkIdType pulse, double values[6]) const;

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
  };

  bool CheckComponent(int component);
  void SetDistribution(int component, int distribution, double a, double b);

  Component All[6];
  int Mode = MOTION;
};

#endif
