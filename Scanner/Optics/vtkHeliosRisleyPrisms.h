// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRisleyPrisms
 * @brief   rotating wedge prisms in series: rosettes
 *
 * The IncidentBeam passes up to three prisms on the y axis, prism 0 first, each
 * with an index of refraction in air of AirRefractiveIndex. Prism k rotates about
 * y with RotorFrequency (negative: reversed); at pulse i its angle is psi =
 * RotorPhase + 2 pi frac(i RotorFrequency / PulseFrequency), each fraction exact.
 * One face is perpendicular to y; the other is inclined by the WedgeAngle a, the first where
 * a > 0, the second where a < 0, with the normal
 * - N = (sin psi sin a, -cos a, cos psi sin a)
 *
 * A prism with a = 0 is absent. At every face, from index n1 to n2, the beam d
 * follows Snell's law in vectors (Born and Wolf, Principles of Optics, 1.5):
 * - c1 = -d . N, c2 = sqrt(1 - (n1 / n2)^2 (1 - c1^2))
 * - d' = (n1 / n2) d + (n1 / n2 c1 - c2) N
 *
 * A beam that is totally reflected, or misses a face, emits no pulse.
 *
 * @sa
 * vtkHeliosBeamDeflector vtkHeliosScanner
 */

#ifndef vtkHeliosRisleyPrisms_h
#define vtkHeliosRisleyPrisms_h

#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosScannerOpticsModule.h" // For export macro

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosRisleyPrisms : public vtkHeliosBeamDeflector
{
public:
  static vtkHeliosRisleyPrisms* New();
  vtkTypeMacro(vtkHeliosRisleyPrisms, vtkHeliosBeamDeflector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The maximum number of prisms.
  static constexpr int MaximumNumberOfPrisms = 3;

  ///@{
  /**
   * Set/Get the angle between the faces of prism 0, 1 or 2 [deg]; its sign
   * selects the inclined face. Valid range: [-89, 89]. Default: 0, no prism.
   */
  void SetWedgeAngle(int prism, double angle);
  double GetWedgeAngle(int prism) const;
  ///@}

  ///@{
  /**
   * Set/Get the index of refraction of prism 0, 1 or 2. Valid range: [1, 10].
   * Default: 1.5.
   */
  void SetRefractiveIndex(int prism, double index);
  double GetRefractiveIndex(int prism) const;
  ///@}

  ///@{
  /**
   * Set/Get the rotation frequency of prism 0, 1 or 2 [Hz]. Valid range:
   * [-1e6, 1e6]. Default: 0.
   */
  void SetRotorFrequency(int prism, double frequency);
  double GetRotorFrequency(int prism) const;
  ///@}

  ///@{
  /**
   * Set/Get the angle of prism 0, 1 or 2 at pulse 0 [deg]: a prism bends the beam
   * to -z at 0, to -x at 90. Valid range: [-360, 360]. Default: 0.
   */
  void SetRotorPhase(int prism, double phase);
  double GetRotorPhase(int prism) const;
  ///@}

  ///@{
  /**
   * Set/Get the index of refraction around the prisms. Valid range: [1, 10].
   * Default: 1.
   */
  void SetAirRefractiveIndex(double index);
  vtkGetMacro(AirRefractiveIndex, double);
  ///@}

  ///@{
  /**
   * Set/Get the beam direction before the first prism; normalised. A direction
   * that does not point forward (y > 0) is an error. Default: 0, 1, 0.
   */
  void SetIncidentBeam(double x, double y, double z);
  void SetIncidentBeam(const double beam[3]) { this->SetIncidentBeam(beam[0], beam[1], beam[2]); }
  vtkGetVector3Macro(IncidentBeam, double);
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;

protected:
  vtkHeliosRisleyPrisms() = default;
  ~vtkHeliosRisleyPrisms() override = default;

private:
  vtkHeliosRisleyPrisms(const vtkHeliosRisleyPrisms&) = delete;
  void operator=(const vtkHeliosRisleyPrisms&) = delete;

  struct Prism
  {
    double WedgeAngle = 0.0;
    double RefractiveIndex = 1.5;
    double RotorFrequency = 0.0;
    double RotorPhase = 0.0;
    double SinWedge = 0.0; // sine of WedgeAngle, saves a sine and cosine per pulse
    double CosWedge = 1.0;
  };

  bool HasPrism(int prism);
  bool Pass(const Prism& prism, double phase, double direction[3]) const;

  Prism Prisms[MaximumNumberOfPrisms];
  double AirRefractiveIndex = 1.0;
  double IncidentBeam[3] = { 0.0, 1.0, 0.0 };
};

#endif
