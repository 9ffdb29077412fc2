// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosBeamSampler
 * @brief   the sub-rays of a Gaussian beam
 *
 * A strategy, const once set up; the sub-rays are computed when a property changes, and read by any
 * thread. The beam has the intensity exp(-2 g^2 / w^2) at angle g from its axis, with w =
 * BeamDivergence / 2; the cone sampled reaches K = Truncation times w and holds E = 1 - exp(-2 K^2)
 * of the energy. Pattern sets the sub-ray positions:
 * - GAUSS_LEGENDRE: q = NumberOfRings rings at w sqrt(-ln(1 - p_j E) / 2), p_j the Gauss-Legendre
 *   nodes of [0, 1], each with the energy of its node and 4 q sub-rays, odd rings rotated by half a
 *   step: 4 q^2 in all. Ranges on a plane converge exponentially: 64 sub-rays give the echo width
 *   to 1e-3 for K = 1
 * - CIRCLES: the evenly spaced circles of the paper (Bechtold and Hoefle 2016), q = NumberOfCircles
 *   at i K w / (q - 1/2), i = 0 ... q - 1, of floor(2 pi i) sub-rays, the first of one: 1, 7, 19,
 *   37, 62 ... in all. A circle has the exact energy between (i - 1/2) and (i + 1/2) spacings;
 *   second order in 1 / q
 * - VOGEL: a sunflower spiral of equal energies (Vogel 1979), NumberOfSubRays in all; point k of a
 *   quarter is at the energy quantile (k + 1/2) 4 / N, rotated by k golden sections of 90 degrees,
 *   and the quarters are identical, so that the mean direction is the axis. The best of the three
 *   for edges or thin objects in the beam
 *
 * The weights are multiples of 2^-53 and sum to 1 exactly, in any order. A BeamDivergence of 0 is
 * one ray along the axis, and so is one circle or a spiral of one sub-ray.
 *
 * With a BeamQualityFactor M2 the beam has a waist, w0 = M2 Wavelength / (pi w), and the sub-rays
 * are rulings of the hyperboloid of the widening beam: the one at r w and azimuth a starts r w0
 * beside the axis at azimuth a + 90 degrees with the slope r w towards a. At the plane R before the
 * scanner, the radius of the beam is then sqrt(w0^2 + (w R)^2) exactly, and every ray is straight.
 *
 * With a DivergenceRatio q below 1 the beam is elliptical: the circular one of BeamDivergence,
 * narrowed by q along the minor axis of its cross-section on the plane R before the scanner, and so
 * is its waist, at the same place. The weights, and with x and z along the axes the intensity
 * exp(-2 (x^2 + (z / q)^2) / (w R)^2), equal the circular beam's.
 *
 * @sa
 * vtkHeliosScanner
 */

#ifndef vtkHeliosBeamSampler_h
#define vtkHeliosBeamSampler_h

#include "vtkHeliosScannerOpticsModule.h" // For export macro
#include "vtkObject.h"

#include <vector> // For the sub-rays

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosBeamSampler : public vtkObject
{
public:
  static vtkHeliosBeamSampler* New();
  vtkTypeMacro(vtkHeliosBeamSampler, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The positions of the sub-rays.
  enum Patterns
  {
    GAUSS_LEGENDRE = 0,
    CIRCLES = 1,
    VOGEL = 2
  };

  ///@{
  /**
   * Set/Get the positions of the sub-rays. Default: GAUSS_LEGENDRE.
   */
  vtkSetClampMacro(Pattern, int, GAUSS_LEGENDRE, VOGEL);
  vtkGetMacro(Pattern, int);
  void SetPatternToGaussLegendre() { this->SetPattern(GAUSS_LEGENDRE); }
  void SetPatternToCircles() { this->SetPattern(CIRCLES); }
  void SetPatternToVogel() { this->SetPattern(VOGEL); }
  const char* GetPatternAsString() const;
  ///@}

  /**
   * Returns the name of a pattern: Circles, for instance. Null if there is none of that number.
   */
  static const char* GetPatternName(int pattern);

  /**
   * Returns the number of sub-rays of a pattern with a number of rings, circles, or points of the
   * spiral.
   */
  static int CountSubRays(int pattern, int size);

  /**
   * Returns the smallest number of rings, circles, or points of the spiral that gives at least this
   * many sub-rays; at most 64 rings or circles, or 65536 points.
   */
  static int FindPatternSize(int pattern, int subRays);

  ///@{
  /**
   * Set/Get the full angle of the beam at 1/e^2 of its intensity [rad], which data sheets state.
   * Valid range: [0, 1], else rejected; scanners need 0 or at least 1e-9. Default: 0.0003.
   */
  void SetBeamDivergence(double angle);
  vtkGetMacro(BeamDivergence, double);
  ///@}

  ///@{
  /**
   * Set/Get the divergence along the minor axis of an elliptical beam, as a fraction of
   * BeamDivergence, which is then the divergence along the major axis; 1: a circular beam. The
   * product must be at least 1e-9 rad for scanners. Valid range: [0.01, 1], else rejected. Default:
   * 1.
   */
  void SetDivergenceRatio(double ratio);
  vtkGetMacro(DivergenceRatio, double);
  ///@}

  ///@{
  /**
   * Set/Get how far the major axis of an elliptical beam is rotated about the beam, clockwise as
   * the scanner sees it, from vtkHeliosBeamDeflector::GetCrossAxis() [deg]: 0 is across the scan
   * lines, 90 along them. Only scanners use it. Valid range: [-360, 360], else rejected.
   * Default: 0.
   */
  void SetMajorAxisAngle(double angle);
  vtkGetMacro(MajorAxisAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of rings of GAUSS_LEGENDRE. Valid range: [1, 64].
   * Default: 2, which is 16 sub-rays.
   */
  vtkSetClampMacro(NumberOfRings, int, 1, 64);
  vtkGetMacro(NumberOfRings, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of CIRCLES, the centre included. Valid range: [1, 64].
   * Default: 3, which is 19 sub-rays.
   */
  vtkSetClampMacro(NumberOfCircles, int, 1, 64);
  vtkGetMacro(NumberOfCircles, int);
  ///@}

  ///@{
  /**
   * Set/Get whether CIRCLES follow the paper exactly, for comparison: circles at
   * i K w / q, and sub-rays weighted with their intensity times an equal share of
   * the area. These weights are not normalised: their sum is 1 + C / q,
   * C = 0.6259 for K = 1, 31 % too much for 19 sub-rays. Default: off.
   */
  vtkSetMacro(LegacyWeights, bool);
  vtkGetMacro(LegacyWeights, bool);
  vtkBooleanMacro(LegacyWeights, bool);
  ///@}

  ///@{
  /**
   * Sets the number of sub-rays of VOGEL; above 1, it is rounded up to a multiple of 4. Valid
   * range: [1, 65536]. Default: 64. Get the number of sub-rays of a pulse, for any Pattern.
   */
  void SetNumberOfSubRays(int number);
  int GetNumberOfSubRays() const { return static_cast<int>(this->SubRays.size()); }
  ///@}

  ///@{
  /**
   * Set/Get the radius of the cone in units of w. Valid range: [0.1, 3].
   * Default: 1.5, which holds 98.9 % of the energy.
   */
  vtkSetClampMacro(Truncation, double, 0.1, 3.0);
  vtkGetMacro(Truncation, double);
  ///@}

  ///@{
  /**
   * Set/Get M2, the ratio of the beam width to the diffraction limit; 0: no
   * waist, all sub-rays start at one point. Valid range: 0 or [1, 1e4], else
   * rejected. Default: 0.
   */
  void SetBeamQualityFactor(double factor);
  vtkGetMacro(BeamQualityFactor, double);
  ///@}

  ///@{
  /**
   * Set/Get the wavelength [nm]; the waist is proportional to it. Valid range:
   * [1, 1e6], else rejected. Default: 1064.
   */
  void SetWavelength(double wavelength);
  vtkGetMacro(Wavelength, double);
  ///@}

  /**
   * Returns the radius of the beam at 1/e^2 of its intensity at a distance from the waist [m], the
   * beam origin; of an elliptical beam along its major axis.
   */
  double GetFootprintRadius(double distance) const;

  /**
   * Computes the direction of a sub-ray in the frame of the beam, whose axis is y and whose major
   * axis is x: a unit vector.
   */
  void GetDirection(int subRay, double direction[3]) const
    VTK_EXPECTS(0 <= subRay && subRay < GetNumberOfSubRays());

  /**
   * Computes the start of a sub-ray relative to the origin of the beam, across its axis [m]: zero
   * without a waist.
   */
  void GetOffset(int subRay, double offset[3]) const
    VTK_EXPECTS(0 <= subRay && subRay < GetNumberOfSubRays());

  /**
   * Returns the fraction of the pulse's energy in a sub-ray, in (0, 1].
   */
  double GetWeight(int subRay) const VTK_EXPECTS(0 <= subRay && subRay < GetNumberOfSubRays());

  /**
   * Recomputes the sub-rays.
   */
  void Modified() override;

protected:
  vtkHeliosBeamSampler();
  ~vtkHeliosBeamSampler() override = default;

private:
  struct SubRay
  {
    double Direction[3];
    double Offset[3];
    double Weight;
  };

  void Refuse(const char* property, double value, const char* cure);
  void SetProperty(double& property, double value);
  double GetWaist() const;
  SubRay Narrow(const SubRay& circular) const;
  void Build();

  vtkHeliosBeamSampler(const vtkHeliosBeamSampler&) = delete;
  void operator=(const vtkHeliosBeamSampler&) = delete;

  int Pattern = GAUSS_LEGENDRE;
  double BeamDivergence = 0.0003;
  double DivergenceRatio = 1.0;
  double MajorAxisAngle = 0.0;
  int NumberOfRings = 2;
  int NumberOfCircles = 3;
  bool LegacyWeights = false;
  int SpiralSize = 64;
  double Truncation = 1.5;
  double BeamQualityFactor = 0.0;
  double Wavelength = 1064.0;
  std::vector<SubRay> SubRays;
};

#endif
