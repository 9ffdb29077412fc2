// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPlatformNoise
 * @brief   how a platform shakes about its trajectory
 *
 * A strategy, const and thread-safe once set up. Each of six components (the position
 * along the axes of the world, and turns about the axes of the body) has a
 * distribution of its own, or none:
 *
 *   p' = p + (x, y, z),   A' = A Rx(a) Ry(b) Rz(c),
 *
 * with the trajectory's position p and attitude A. Mount and beam origin turn with
 * A', and pulses leave from there.
 *
 * A value holds for Lifespan pulses: that of pulse i is number floor(i / Lifespan)
 * of its component (0: number 0 for ever), i the PulseIds over the run. Numbers
 * are counter-based, of a stream of their own per component: no threads, pieces
 * or other components change them.
 *
 * With Mode MOTION the platform really moves so, and the instrument knows it: points
 * lie on the surfaces that were met, elsewhere than without noise. With Mode NAVIGATION_ERROR
 * the noise is what navigation does not know: the beam goes from the true pose, and
 * origin, direction and points are reported from the trajectory's; TruePoint is
 * where the light came from.
 *
 * @warning
 * With a value a pulse (Lifespan 1) the platform has a new place every pulse. Errors
 * of navigation stay over seconds: give a Lifespan of PulseFrequency times that.
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

  /// What shakes: positions [m], turns about the body's axes [deg].
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
   * [minimum, maximum], or none. Valid range: finite, stdev >= 0, minimum <=
   * maximum. Default: none.
   */
  void SetNormal(int component, double mean, double stdev);
  void SetUniform(int component, double minimum, double maximum);
  void SetNone(int component);
  ///@}

  ///@{
  /**
   * Set the limits that values of a component are clamped to [m or deg]; or none.
   * Valid range: minimum <= maximum. Default: none.
   */
  void SetClip(int component, double minimum, double maximum);
  void SetNoClip(int component);
  ///@}

  ///@{
  /**
   * Set/Get for how many pulses a value of a component holds; 0: for ever. A
   * lifespan of n channels gives all channels of a shot one value. Valid range: [0, 1e15].
   * Default: 1.
   */
  void SetLifespan(int component, vtkIdType pulses);
  vtkIdType GetLifespan(int component) const;
  ///@}

  /// What the noise is.
  enum Modes
  {
    MOTION = 0,          ///< it is known: points lie on surfaces
    NAVIGATION_ERROR = 1 ///< it is not known: points are off
  };

  ///@{
  /**
   * Set/Get what the noise is. Default: MOTION, as in HELIOS.
   */
  vtkSetClampMacro(Mode, int, MOTION, NAVIGATION_ERROR);
  vtkGetMacro(Mode, int);
  void SetModeToMotion() { this->SetMode(MOTION); }
  void SetModeToNavigationError() { this->SetMode(NAVIGATION_ERROR); }
  ///@}

  /// Whether any component has a distribution.
  bool IsOn() const;

  /// Whether what is reported comes from the trajectory's pose.
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
