// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformPolylines
 * @brief   waveforms as curves along their beams, for display
 *
 * Input: waveforms in the layout of vtkHeliosScanner (output port 1) and of the
 * readers. Output: one polyline per waveform. Sample i of value a, received at
 * t = StartTime + i BinSize after the emission, becomes the point
 * - Origin + (c t / 2) Direction + Scale a u
 *
 * with u the unit vector perpendicular to the beam that is nearest to
 * DisplacementDirection. The curve starts and ends on the beam, and its peaks
 * are beside the surfaces of the echoes.
 *
 * Point data: Amplitude (float, W), Range (double, m). Cell data: the columns
 * of the table (PulseIds, GpsTime ...) except Origin, Direction, Offset, Count.
 *
 * For airborne beams set DisplacementDirection along the platform trajectory:
 * the curves are then side by side.
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
   * Set/Get the displacement of an amplitude of 1 W [m/W]; 0: the largest
   * amplitude of the input is displaced by Height. Valid range: [0, 1e30].
   * Default: 0.
   */
  vtkSetClampMacro(Scale, double, 0.0, 1e30);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Set/Get the displacement of the largest amplitude if Scale is 0 [m]. Valid
   * range: [0, 1e6]. Default: 1.
   */
  vtkSetClampMacro(Height, double, 0.0, 1e6);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Set/Get the displacement direction of amplitudes; for a beam along this
   * direction x is used, or y for one along x. Valid range: not zero. Default: 0, 0, 1, up.
   */
  vtkSetVector3Macro(DisplacementDirection, double);
  vtkGetVector3Macro(DisplacementDirection, double);
  ///@}

  ///@{
  /**
   * Set/Get the stride of waveforms shown: the first and every EveryNth after
   * it. Valid range: [1, 2^31 - 1]. Default: 1, all.
   */
  vtkSetClampMacro(EveryNth, int, 1, VTK_INT_MAX);
  vtkGetMacro(EveryNth, int);
  ///@}

  ///@{
  /**
   * Shows the waveforms of selected pulses only, applied before EveryNth. Default: none added,
   * which shows all.
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
