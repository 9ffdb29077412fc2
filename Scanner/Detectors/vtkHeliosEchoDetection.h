// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosEchoDetection
 * @brief   the echoes of stored waveforms
 *
 * Port 0: waveforms (vtkTable, one row each, as output 1 of vtkHeliosScanner:
 * PulseIds, Origin, Direction, GpsTime, StartTime [ns], BinSize [ns], Offset,
 * Count, optionally LegIds and ChannelIds; Samples [W] and optionally PulseLength
 * [ns] in the field data).
 *
 * Output 0: the echoes, points with GpsTime, PulseIds, ReturnNumber,
 * NumberOfReturns, Range, Amplitude, EchoWidth, WaveformIds, LegIds and ChannelIds
 * where the input has them, and Deviation where the detector gives it. An echo at time t after the first
 * sample lies at Origin + Range Direction,
 * - Range = c / 2 (StartTime + t)
 *
 * With the detector of a scanner whose Sampling is Fixed and that adds no range
 * noise, these are the bytes of the scanner's echoes; by tolerance they agree
 * within its tolerances. Threads and pieces change no byte.
 *
 * @sa
 * vtkHeliosEchoDetector vtkHeliosScanner
 */

#ifndef vtkHeliosEchoDetection_h
#define vtkHeliosEchoDetection_h

#include "vtkHeliosInstrument.h"             // For ReturnSelections
#include "vtkHeliosScannerDetectorsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For the detector

class vtkHeliosEchoDetector;
class vtkTable;

class VTKHELIOSSCANNERDETECTORS_EXPORT vtkHeliosEchoDetection : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosEchoDetection* New();
  vtkTypeMacro(vtkHeliosEchoDetection, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get what makes echoes of waveforms. Default: a vtkHeliosPeakDetector.
   */
  void SetEchoDetector(vtkHeliosEchoDetector* detector);
  vtkHeliosEchoDetector* GetEchoDetector() const;
  ///@}

  ///@{
  /**
   * Set/Get the full width of the transmitted pulse at half its maximum [ns]; 0: as
   * the input's field data say. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(PulseLength, double, 0.0, 1e6);
  vtkGetMacro(PulseLength, double);
  ///@}

  ///@{
  /**
   * Set/Get which echoes of a pulse are kept, as vtkHeliosInstrument has them.
   * Default: ALL.
   */
  vtkSetClampMacro(
    ReturnSelection, int, vtkHeliosInstrument::ALL, vtkHeliosInstrument::FIRST_AND_LAST);
  vtkGetMacro(ReturnSelection, int);
  void SetReturnSelectionToAll() { this->SetReturnSelection(vtkHeliosInstrument::ALL); }
  void SetReturnSelectionToFirst() { this->SetReturnSelection(vtkHeliosInstrument::FIRST); }
  void SetReturnSelectionToLast() { this->SetReturnSelection(vtkHeliosInstrument::LAST); }
  void SetReturnSelectionToStrongest() { this->SetReturnSelection(vtkHeliosInstrument::STRONGEST); }
  void SetReturnSelectionToFirstAndLast()
  {
    this->SetReturnSelection(vtkHeliosInstrument::FIRST_AND_LAST);
  }
  ///@}

  ///@{
  /**
   * Set/Get how many of them are kept, in the order of range; 0: all. Valid
   * range: [0, 255]. Default: 0.
   */
  vtkSetClampMacro(MaximumNumberOfReturns, int, 0, 255);
  vtkGetMacro(MaximumNumberOfReturns, int);
  ///@}

  /// Later than any change of the detector.
  vtkMTimeType GetMTime() override;

protected:
  vtkHeliosEchoDetection();
  ~vtkHeliosEchoDetection() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosEchoDetection(const vtkHeliosEchoDetection&) = delete;
  void operator=(const vtkHeliosEchoDetection&) = delete;

  struct Run;
  bool Prepare(vtkTable* table, Run& run);

  vtkSmartPointer<vtkHeliosEchoDetector> EchoDetector;
  double PulseLength = 0.0;
  int ReturnSelection = vtkHeliosInstrument::ALL;
  int MaximumNumberOfReturns = 0;
};

#endif
