// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosBeamSampler
 * @brief   the sub-rays that stand for a Gaussian beam
 *
 * A strategy, const once set up; a scanner asks for the sub-rays once, not once
 * a pulse. The beam has the intensity exp(-2 g^2 / w^2) at angle g from its
 * axis, with w = BeamDivergence / 2; the cone sampled reaches K = Truncation
 * times w. NumberOfCircles q gives the paper's evenly spaced circles (Bechtold
 * and Hoefle 2016):
 * - circle i = 0 ... q - 1 lies at g = i K w / (q - 1/2)
 * - it has floor(2 pi i) sub-rays, the first one one: 1, 7, 19, 37, 62 ... in all
 * - they share evenly the energy between (i - 1/2) and (i + 1/2) spacings,
 *   exact: exp(-2 a^2 / w^2) - exp(-2 b^2 / w^2), over that of the whole cone
 *
 * All weights sum to 1. A BeamDivergence of 0 is one ray, and so is one circle.
 * The circles have the right energy and mean; the variance of the cone they
 * miss by -0.8 % (K = 1) to 6 % (K = 1.5) for three circles, falling with q^2.
 *
 * @sa
 * vtkHeliosScanner
 */

#ifndef vtkHeliosBeamSampler_h
#define vtkHeliosBeamSampler_h

#include "vtkHeliosScannerOpticsModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosBeamSampler : public vtkObject
{
public:
  static vtkHeliosBeamSampler* New();
  vtkTypeMacro(vtkHeliosBeamSampler, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the full angle of the beam at 1/e^2 of its intensity [rad], as data
   * sheets give it. Valid range: [0, 1]. Default: 0.0003.
   */
  vtkSetClampMacro(BeamDivergence, double, 0.0, 1.0);
  vtkGetMacro(BeamDivergence, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of circles, the centre included. Valid range: [1, 64].
   * Default: 3, which is 19 sub-rays.
   */
  vtkSetClampMacro(NumberOfCircles, int, 1, 64);
  vtkGetMacro(NumberOfCircles, int);
  ///@}

  ///@{
  /**
   * Set/Get the radius of the cone in units of w. Valid range: [0.1, 3].
   * Default: 1.5, which holds 98.9 % of the energy.
   */
  vtkSetClampMacro(Truncation, double, 0.1, 3.0);
  vtkGetMacro(Truncation, double);
  ///@}

  /**
   * The number of sub-rays of a pulse.
   */
  int GetNumberOfSubRays() const;

  /**
   * A sub-ray's direction in the frame of the beam, whose axis is y: a unit
   * vector. Sub-ray 0 is the axis.
   */
  void GetDirection(int subRay, double direction[3]) const;

  /**
   * A sub-ray's share of the pulse's energy, in (0, 1].
   */
  double GetWeight(int subRay) const;

protected:
  vtkHeliosBeamSampler() = default;
  ~vtkHeliosBeamSampler() override = default;

private:
  vtkHeliosBeamSampler(const vtkHeliosBeamSampler&) = delete;
  void operator=(const vtkHeliosBeamSampler&) = delete;

  double BeamDivergence = 0.0003;
  int NumberOfCircles = 3;
  double Truncation = 1.5;
};

#endif
