// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformPolylines
 * @brief   waveforms as curves along their beams, for viewing
 *
 * Input: waveforms as vtkHeliosScanner gives them (output port 1) and readers
 * read them. Output: one polyline a waveform. Sample i of value a, received t =
 * StartTime + i BinSize after the emission, becomes the point
 * - Origin + (c t / 2) Direction + Scale a u
 *
 * with u the unit vector across the beam that is nearest to
 * DisplacementDirection. So the curve starts and ends on the beam, and its peaks
 * stand beside the surfaces that the echoes lie on.
 *
 * Point data: Amplitude (float, W), Range (double, m). Cell data: the columns of
 * the table (PulseIds, GpsTime ...) but Origin, Direction, Offset, Count.
 *
 * For beams from above choose a DisplacementDirection along the way of the
 * platform: the curves then stand side by side.
 *
 * @sa
 * vtkHeliosWaveformTextReader vtkHeliosWaveformXMLReader
 */

#ifndef vtkHeliosWaveformPolylines_h
#define vtkHeliosWaveformPolylines_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <set> // For the selection

class vtkTable;

namespace helios
{
struct WaveformTable;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosWaveformPolylines : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosWaveformPolylines* New();
  vtkTypeMacro(vtkHeliosWaveformPolylines, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how far an amplitude of 1 W is displaced [m/W]; 0: such that the
   * largest one of the input is displaced by Height. Valid range: [0, 1e30].
   * Default: 0.
   */
  vtkSetClampMacro(Scale, double, 0.0, 1e30);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Set/Get how far the largest amplitude is displaced where Scale is 0 [m].
   * Valid range: [0, 1e6]. Default: 1.
   */
  vtkSetClampMacro(Height, double, 0.0, 1e6);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Set/Get where amplitudes are displaced to; across a beam that has this
   * direction itself, to x, or to y for one along x. Valid range: not zero.
   * Default: 0, 0, 1, up.
   */
  vtkSetVector3Macro(DisplacementDirection, double);
  vtkGetVector3Macro(DisplacementDirection, double);
  ///@}

  ///@{
  /**
   * Set/Get which waveforms are shown: the first and every EveryNth after it.
   * Valid range: [1, 2^31 - 1]. Default: 1, all.
   */
  vtkSetClampMacro(EveryNth, int, 1, VTK_INT_MAX);
  vtkGetMacro(EveryNth, int);
  ///@}

  ///@{
  /**
   * Shows the waveforms of some pulses only, before EveryNth. Default: none
   * added, which shows all.
   */
  void AddPulseId(vtkIdType id);
  void RemoveAllPulseIds();
  vtkIdType GetNumberOfPulseIds() const { return static_cast<vtkIdType>(this->PulseIds.size()); }
  ///@}

protected:
  vtkHeliosWaveformPolylines() = default;
  ~vtkHeliosWaveformPolylines() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosWaveformPolylines(const vtkHeliosWaveformPolylines&) = delete;
  void operator=(const vtkHeliosWaveformPolylines&) = delete;

  bool CheckDirection();
  double FindScale(const helios::WaveformTable& waveforms) const;

  double Scale = 0.0;
  double Height = 1.0;
  double DisplacementDirection[3] = { 0.0, 0.0, 1.0 };
  int EveryNth = 1;
  std::set<vtkIdType> PulseIds;
};

#endif
