// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosEchoDetection
 * @brief   re-runs echo detection on stored waveforms
 *
 * Port 0: waveforms (vtkTable, one row each, as output 1 of vtkHeliosScanner:
 * PulseIds, Origin, Direction, GpsTime, StartTime [ns], BinSize [ns], Offset,
 * Count, optionally LegIds and ChannelIds; Samples [W] and optionally PulseLength
 * [ns] in the field data; also PulseSamples, times [ns] and powers of a pulse that
 * is not Gaussian, for which the times of the detector are calibrated).
 *
 * Output 0: the echoes, points with GpsTime, PulseIds, ReturnNumber, NumberOfReturns, Range,
 * Amplitude, EchoWidth, WaveformIds, LegIds and ChannelIds if the input has them, and Deviation if
 * the detector computes it. An echo at time t after the first sample lies at Origin + Range
 * Direction,
 * - Range = c / 2 (StartTime + t)
 *
 * With the detector of a scanner whose Sampling is Fixed, without range noise,
 * the echoes are byte-identical to the scanner's; with adaptive sampling they
 * agree within its tolerances. For pulses in closed form that are not Gaussian
 * ranges agree to 1e-6 m. Results do not depend on threads or pieces.
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

#include <string> // For names of detectors

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
   * Return the names of the echo detectors in surveys: "peak", the default, "gaussian", "cfd",
   * "leadingEdge" and "photonCounting". Null if the index is out of range.
   */
  static int GetNumberOfDetectors();
  static const char* GetDetectorName(int index);
  ///@}

  /**
   * Creates an echo detector by its name, or the default one if the name is null or empty. Null for
   * an unknown name.
   */
  VTK_NEWINSTANCE static vtkHeliosEchoDetector* MakeDetector(const char* name);

  ///@{
  /**
   * Adds an echo detector, so that surveys and runs find it by its name, as they find "peak": a
   * plug-in calls it before surveys are read. MakeDetector() makes new objects of the class of the
   * prototype, which scanners set up by vtkHeliosEchoDetector::SetInstrument(). Returns false if the
   * prototype is null, or the name is empty, has blanks, or is known. RemoveDetector() removes one
   * that was added, and returns false for any other.
   */
  static bool AddDetector(const std::string& name, vtkHeliosEchoDetector* prototype);
  static bool RemoveDetector(const std::string& name);
  ///@}

  /**
   * Loads a plug-in that is a shared library: a file (.so) with
   * `extern "C" bool vtkhelios_register_plugin()`, which returns whether AddDetector() did. Returns
   * the error as text; empty: none. After an error none of its detectors is known.
   */
  static std::string LoadPlugin(const std::string& file);

  ///@{
  /**
   * Set/Get the file of the plug-in that has added an echo detector: an input of the runs that use
   * it, with its digest. Default: empty, none.
   */
  static void SetDetectorFile(const std::string& name, const std::string& file);
  static std::string GetDetectorFile(const std::string& name);
  ///@}

  ///@{
  /**
   * Set/Get the echo detector. Default: a vtkHeliosPeakDetector.
   */
  void SetEchoDetector(vtkHeliosEchoDetector* detector);
  vtkHeliosEchoDetector* GetEchoDetector() const;
  ///@}

  ///@{
  /**
   * Set/Get the full width at half maximum of the transmitted pulse [ns]; 0: from
   * the input's field data. Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(PulseLength, double, 0.0, 1e6);
  vtkGetMacro(PulseLength, double);
  ///@}

  ///@{
  /**
   * Set/Get the key of the random numbers of detectors that draw some: the Seed of
   * the scanner. Valid range: [0, 2^62]. Default: 0.
   */
  vtkSetClampMacro(Seed, vtkIdType, 0, 4611686018427387904LL);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get which echoes of a pulse are kept, and their maximum number, as in vtkHeliosInstrument.
   * Valid range: [0, 255]. Default: ALL and 0.
   */
  vtkHeliosReturnsMacro();
  ///@}

  /// Includes changes of the detector.
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
  bool Calibrate(vtkTable* table, Run& run);

  vtkSmartPointer<vtkHeliosEchoDetector> EchoDetector;
  double PulseLength = 0.0;
  vtkIdType Seed = 0;
  int ReturnSelection = vtkHeliosInstrument::ALL;
  int MaximumNumberOfReturns = 0;
};

#endif
