// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRotatingMirror
 * @brief   a polygon mirror: lines in one direction
 *
 * The beam rotates about the x axis: at mirror angle beta it points to (0, cos beta, sin beta).
 * Each facet sweeps from -MirrorAngle to +MirrorAngle, with ScanFrequency, and pulse 0 is at beta =
 * 0. Pulse i at PulseFrequency f has the phase p = frac(i ScanFrequency / f), exact after any
 * number of pulses, and
 * - beta = 2 MirrorAngle p where p <= 1/2, else 2 MirrorAngle (p - 1)
 *
 * so that beta is in (-MirrorAngle, MirrorAngle]. Pulses are emitted only where VerticalAngleMin <
 * beta <= VerticalAngleMax: a window as wide as the sweep emits all of them.
 *
 * The facets need not be alike: line l is swept by facet l mod NumberOfFacets, with pulse 0 in the
 * middle of facet 0. The beam of a facet with FacetPitch p and FacetRoll r points to
 * - (sin p, cos p cos(beta + r), cos p sin(beta + r))
 *
 * a cone about the shaft: the direction of a beam along x that a facet reflects whose normal is 45
 * degrees + p / 2 from -x. The window is one of beta.
 *
 * @sa
 * vtkHeliosBeamDeflector vtkHeliosScanner
 */

#ifndef vtkHeliosRotatingMirror_h
#define vtkHeliosRotatingMirror_h

#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosScannerOpticsModule.h" // For export macro

#include <vector> // For the facets

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosRotatingMirror : public vtkHeliosBeamDeflector
{
public:
  static vtkHeliosRotatingMirror* New();
  vtkTypeMacro(vtkHeliosRotatingMirror, vtkHeliosBeamDeflector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the number of lines per second [Hz]. Valid range: [0, 1e6].
   * Default: 100.
   */
  vtkSetClampMacro(ScanFrequency, double, 0.0, 1e6);
  vtkGetMacro(ScanFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get half the angle swept by a facet [deg]: 180 for one facet at 45
   * degrees to the shaft. Valid range: (0, 360]. Default: 180.
   */
  vtkSetClampMacro(MirrorAngle, double, 1e-9, 360.0);
  vtkGetMacro(MirrorAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the window in which pulses are emitted [deg]. Valid range:
   * [-360, 360]. Default: -180 and 180.
   */
  vtkSetClampMacro(VerticalAngleMin, double, -360.0, 360.0);
  vtkGetMacro(VerticalAngleMin, double);
  vtkSetClampMacro(VerticalAngleMax, double, -360.0, 360.0);
  vtkGetMacro(VerticalAngleMax, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of facets that differ; new ones have pitch and roll 0. Valid
   * range: [1, 1000]. Default: 1.
   */
  void SetNumberOfFacets(int facets);
  int GetNumberOfFacets() const;
  ///@}

  ///@{
  /**
   * Set/Get the angle between the beam of a facet and the plane of the mirror [deg],
   * positive towards x. Valid range: [-89, 89]. Default: 0.
   */
  void SetFacetPitch(int facet, double pitch);
  double GetFacetPitch(int facet) const;
  ///@}

  ///@{
  /**
   * Set/Get the angle that a facet adds to the mirror angle [deg]. Valid range: [-180, 180].
   * Default: 0.
   */
  void SetFacetRoll(int facet, double roll);
  double GetFacetRoll(int facet) const;
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;

  /**
   * Returns the facet of a pulse, from 0.
   */
  int GetFacet(vtkIdType pulse) const;

  /**
   * Returns the mirror angle beta + r [deg], whether or not a pulse is emitted there.
   */
  double GetScanAngle(vtkIdType pulse) const override;

  ///@{
  /**
   * Returns 1 for every pulse; the edge is the last pulse in the window of each facet. A mirror
   * without ScanFrequency has neither.
   */
  int GetScanDirectionFlag(vtkIdType pulse) const override;
  bool IsEdgeOfFlightLine(vtkIdType pulse) const override;
  ///@}

protected:
  vtkHeliosRotatingMirror();
  ~vtkHeliosRotatingMirror() override = default;

private:
  vtkHeliosRotatingMirror(const vtkHeliosRotatingMirror&) = delete;
  void operator=(const vtkHeliosRotatingMirror&) = delete;

  struct Facet
  {
    double Pitch = 0.0;
    double Roll = 0.0;
    double SinPitch = 0.0; // saves a sine and cosine per pulse
    double CosPitch = 1.0;
  };

  Facet* Find(int facet);
  Facet GetOne(int facet) const;
  double ComputeBeta(vtkIdType pulse) const;
  bool IsInWindow(double beta) const;

  double ScanFrequency = 100.0;
  double MirrorAngle = 180.0;
  double VerticalAngleMin = -180.0;
  double VerticalAngleMax = 180.0;
  std::vector<Facet> Facets;
};

#endif
