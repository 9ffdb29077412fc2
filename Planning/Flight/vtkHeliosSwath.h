// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSwath
 * @brief   the distribution of the pulses of a scanner across its flight path
 *
 * A strategy, const once built. A pulse of direction (x, y, z) in the body frame (x right, y forward,
 * z up) has the tangents a = -x / z across and b = -y / z along; pulses that do not point down, or
 * are more than MaximumAngle off nadir across, are left out. Build() samples the pulses of all
 * channels of a leg, with the deflectors and poses that a run has. With the rate g(a) of pulses per
 * second and unit of a, a platform in straight level flight at speed v and height h above a plane of
 * slopes z_x across and z_y along leaves
 * - density(a) = g(a) / (v h) E(max(0, 1 + a z_x + b z_y)) pulses/m2 of the horizontal plane
 *
 * at the distance a h from its path; E is the mean over the pulses at a. It is computed for b of the
 * mean of these pulses plus and minus their standard deviation, which is exact for line scanners
 * (b = 0) and cones (b = +-sqrt(tan^2 - a^2)).
 *
 * The sampled scan frequency is changed by less than a pulse per line, so that the angles of
 * successive lines fill the gaps of each other; the distribution does not depend on it.
 *
 * @sa
 * vtkHeliosPulseDensity vtkHeliosBeamDeflector
 */

#ifndef vtkHeliosSwath_h
#define vtkHeliosSwath_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkObject.h"

#include <vector> // For the bins

class vtkHeliosSurvey;

class VTKHELIOSPLANNING_EXPORT vtkHeliosSwath : public vtkObject
{
public:
  static vtkHeliosSwath* New();
  vtkTypeMacro(vtkHeliosSwath, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the largest angle off nadir across the path [deg]. Valid range: [1, 85]. Default: 75.
   */
  vtkSetClampMacro(MaximumAngle, double, 1.0, 85.0);
  vtkGetMacro(MaximumAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of pulses that are sampled, of all channels. Valid range: [1000, 1e8].
   * Default: 400000.
   */
  vtkSetClampMacro(NumberOfSamples, vtkIdType, 1000, 100000000);
  vtkGetMacro(NumberOfSamples, vtkIdType);
  ///@}

  /**
   * Samples the pulses of a leg of a checked survey. Returns false after an error: no such leg, or
   * no pulse that points down.
   */
  bool Build(vtkHeliosSurvey* survey, int leg);

  ///@{
  /**
   * Returns the pulses per second that are emitted to the ground [Hz]; the tangents across of the
   * left and the right edge of the swath; the largest tangent along, without sign; the range gate
   * of the scanner [m].
   */
  double GetPulseRate() const { return this->PulseRate; }
  double GetLeftTangent() const { return this->LeftTangent; }
  double GetRightTangent() const { return this->RightTangent; }
  double GetLargestAlong() const { return this->LargestAlong; }
  double GetRangeMin() const { return this->RangeMin; }
  double GetRangeMax() const { return this->RangeMax; }
  ///@}

  /**
   * Returns the rate g at a tangent across [pulses/s]; 0 outside the swath.
   */
  double GetRate(double across) const;

  /**
   * Returns the smallest rate between two tangents across [pulses/s].
   */
  double GetSmallestRate(double low, double high) const;

  ///@{
  /**
   * Returns the mean of the tangent along of the pulses at a tangent across, and their standard
   * deviation.
   */
  double GetAlongMean(double across) const;
  double GetAlongDeviation(double across) const;
  ///@}

protected:
  vtkHeliosSwath() = default;
  ~vtkHeliosSwath() override = default;

private:
  vtkHeliosSwath(const vtkHeliosSwath&) = delete;
  void operator=(const vtkHeliosSwath&) = delete;

  class Sampler;

  int FindBin(double across) const;

  double MaximumAngle = 75.0;
  vtkIdType NumberOfSamples = 400000;
  double PulseRate = 0.0;
  double LeftTangent = 0.0;
  double RightTangent = 0.0;
  double LargestAlong = 0.0;
  double RangeMin = 0.0;
  double RangeMax = VTK_DOUBLE_MAX;
  std::vector<double> Rates; // rates of bins of equal width from left to right
  std::vector<double> Means;
  std::vector<double> Deviations;
};

#endif
