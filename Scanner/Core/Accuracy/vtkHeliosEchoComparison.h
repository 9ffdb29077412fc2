// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosEchoComparison
 * @brief   the errors of echoes against a reference of the same pulses
 *
 * Port 0: echoes; port 1: the reference; both from vtkHeliosScanner, with PulseIds, Range,
 * Amplitude and EchoWidth. Echoes of a pulse are matched in pairs, nearest first, within
 * MatchingDistance. Those count that have at least LeastShare of the amplitude of a full footprint
 * and LeastAmplitude; one of the reference without a partner is missed, one of port 0 without one
 * is invented. A partner may be weaker.
 *
 * The output is a vtkTable with a row per measure: its Name, its Value and the ends of its 95 %
 * confidence interval, Lower and Upper. Rows: rangeP50_m, rangeP95_m and rangeRms_m of the absolute
 * range errors; missed, invented and missedAndInvented as fractions of the echoes of the reference;
 * amplitudeRms, relative to a full footprint; widthRms_ns; and the counts echoes and matched.
 * Intervals follow order statistics for quantiles, of Wilson (1927) for fractions, and the normal
 * distribution for mean squares.
 *
 * @sa
 * vtkHeliosScanner
 */

#ifndef vtkHeliosEchoComparison_h
#define vtkHeliosEchoComparison_h

#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkTableAlgorithm.h"

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosEchoComparison : public vtkTableAlgorithm
{
public:
  static vtkHeliosEchoComparison* New();
  vtkTypeMacro(vtkHeliosEchoComparison, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the largest distance of two echoes that are the same [m]. Valid range: [0, infinity].
   * Default: 0.3.
   */
  vtkSetClampMacro(MatchingDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MatchingDistance, double);
  ///@}

  ///@{
  /**
   * Set/Get the amplitude of a full footprint at 1 m without extinction [W]; it falls with the
   * square of the range, and with Extinction [1/m], one way. With 0 amplitudes are relative to those
   * of the reference, and LeastShare has no effect. Valid range: [0, infinity]. Default: 0.
   */
  vtkSetClampMacro(FullAmplitude, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FullAmplitude, double);
  vtkSetClampMacro(Extinction, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Extinction, double);
  ///@}

  ///@{
  /**
   * Set/Get the least amplitude of echoes that count: relative to a full footprint, and in watts.
   * Valid range: [0, infinity]. Default: 0.02 and 0.
   */
  vtkSetClampMacro(LeastShare, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LeastShare, double);
  vtkSetClampMacro(LeastAmplitude, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LeastAmplitude, double);
  ///@}

protected:
  vtkHeliosEchoComparison();
  ~vtkHeliosEchoComparison() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosEchoComparison(const vtkHeliosEchoComparison&) = delete;
  void operator=(const vtkHeliosEchoComparison&) = delete;

  double MatchingDistance = 0.3;
  double FullAmplitude = 0.0;
  double Extinction = 0.0;
  double LeastShare = 0.02;
  double LeastAmplitude = 0.0;
};

#endif
