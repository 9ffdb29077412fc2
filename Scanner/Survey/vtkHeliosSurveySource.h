// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveySource
 * @brief   runs a survey in memory, all of it or any part of its pulses
 *
 * What vtkHeliosSurveyPlayer writes to files is here the output of a pipeline,
 * with the same legs, times, ids and random numbers, and so the same echoes.
 * PulseWindow asks for a part of the run: a viewer takes block after block, an
 * inspector a single pulse, a study one leg (GetLegPulses()). Scene, legs and the
 * ray caster's tree are made once and kept for as long as the survey and the
 * properties they depend on stay the same.
 *
 * Output 0: the echoes of all legs in the window, in the order of pulses, with the
 * arrays that vtkHeliosScanner gives them. Outputs 1, 2 and 3, with
 * GenerateWaveforms, GeneratePulses and GenerateSubRays: the waveforms (vtkTable),
 * the pulses and the hits of sub-rays, as vtkHeliosScanner makes them. Pieces are
 * contiguous ranges of the window; in order they are the whole of it.
 *
 * Channels of a scanner fire at once: a window holds whole shots, those whose
 * first pulse is in it.
 *
 * Events: ProgressEvent. Errors and warnings of all filters come as the source's
 * own.
 *
 * @sa
 * vtkHeliosSurvey vtkHeliosSurveyReader vtkHeliosSurveyPlayer
 */

#ifndef vtkHeliosSurveySource_h
#define vtkHeliosSurveySource_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For the survey

#include <atomic> // For Abort()
#include <memory> // For the private data
#include <string> // For what is said in words

class vtkHeliosSurvey;
class vtkImageData;

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurveySource : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSurveySource* New();
  vtkTypeMacro(vtkHeliosSurveySource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the survey to run. No default: an error without.
   */
  void SetSurvey(vtkHeliosSurvey* survey);
  vtkHeliosSurvey* GetSurvey() const;
  ///@}

  ///@{
  /**
   * Set/Get the play to run: which geometry the swapped parts of the scene have.
   * Valid range: [0, the survey's GetNumberOfPlays() - 1]. Default: 0.
   */
  vtkSetClampMacro(Play, int, 0, VTK_INT_MAX);
  vtkGetMacro(Play, int);
  ///@}

  ///@{
  /**
   * Set/Get the key of all random numbers. Valid range: [0, 2^62], or -1: that of
   * the survey, 0 where it has none. Default: -1.
   */
  vtkSetClampMacro(Seed, vtkIdType, -1, 4611686018427387904LL);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get whether ranges have the noise of the scanner. Default: on.
   */
  vtkSetMacro(Noise, bool);
  vtkGetMacro(Noise, bool);
  vtkBooleanMacro(Noise, bool);
  ///@}

  ///@{
  /**
   * Set/Get the errors that the sampling of the beam may make, in range [m] and
   * in amplitude (relative): as vtkHeliosScanner has them, instead of what the
   * survey says. Valid range: 0 or [1e-6, 1], 0 or [1e-4, 1]. Default: 0, as the
   * survey says.
   */
  vtkSetMacro(RangeTolerance, double);
  vtkGetMacro(RangeTolerance, double);
  vtkSetMacro(EnergyTolerance, double);
  vtkGetMacro(EnergyTolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of sub-rays that every pulse has, as vtkHeliosSurveyPlayer
   * has it. Valid range: [0, 65536]. Default: 0, as the survey says.
   */
  vtkSetClampMacro(NumberOfSubRays, int, 0, 65536);
  vtkGetMacro(NumberOfSubRays, int);
  ///@}

  ///@{
  /**
   * Set/Get what makes echoes of waveforms: "peak", "gaussian", "cfd" or
   * "leadingEdge". Default: none, as the survey says.
   */
  vtkSetStringMacro(EchoDetector);
  vtkGetStringMacro(EchoDetector);
  ///@}

  ///@{
  /**
   * Set/Get the ray caster by its name, vtkHeliosRayCaster::GetBackendName().
   * Default: none, which takes that of the survey, or else the default one.
   */
  vtkSetStringMacro(RayCaster);
  vtkGetStringMacro(RayCaster);
  ///@}

  ///@{
  /**
   * Set/Get which outputs are computed beside the echoes, and whether the echoes
   * carry TruePoint and Normal, as vtkHeliosScanner has them. Default: off.
   */
  vtkSetMacro(GenerateWaveforms, bool);
  vtkGetMacro(GenerateWaveforms, bool);
  vtkBooleanMacro(GenerateWaveforms, bool);
  vtkSetMacro(GeneratePulses, bool);
  vtkGetMacro(GeneratePulses, bool);
  vtkBooleanMacro(GeneratePulses, bool);
  vtkSetMacro(GenerateSubRays, bool);
  vtkGetMacro(GenerateSubRays, bool);
  vtkBooleanMacro(GenerateSubRays, bool);
  vtkSetMacro(GenerateTruth, bool);
  vtkGetMacro(GenerateTruth, bool);
  vtkBooleanMacro(GenerateTruth, bool);
  ///@}

  ///@{
  /**
   * Set/Get the part [i0, i1) of the run's pulse ids that is computed. Valid
   * range: 0 <= i0 <= i1. Default: all of them.
   */
  vtkSetVector2Macro(PulseWindow, vtkIdType);
  vtkGetVector2Macro(PulseWindow, vtkIdType);
  ///@}

  /**
   * Loads the scene and plans the legs, unless that is done; Update() does so by
   * itself. Returns false after an error, and after Abort().
   */
  bool Load();

  ///@{
  /**
   * What Load() has found; nothing before. The scene as one mesh, where parts
   * move as it is at the start; the pulses of all legs; the pulse ids [i0, i1) and
   * the time [t0, t1] of a leg [s], both empty ranges for a leg that fires
   * nothing; when a pulse leaves, and the first pulse that leaves at a time or
   * later [s].
   */
  vtkPolyData* GetScene() const;
  vtkIdType GetNumberOfPulses() const;
  void GetLegPulses(int leg, vtkIdType ids[2]) const;
  void GetLegTimes(int leg, double times[2]) const;
  double GetPulseTime(vtkIdType pulse) const;
  vtkIdType FindPulse(double time) const;
  ///@}

  /**
   * The grids of turbid voxels beside the scene, from 0, after Load(): cell data PAD
   * and field data of materials, as vtkHeliosVoxelReader and the filters of their
   * parts make them. Null for a number behind the last one.
   */
  vtkImageData* GetGrid(int grid) const;

  /**
   * The way of a leg: one polyline (one point where the platform stands) with
   * GpsTime and Orientation, sampled every interval [s], and at start and end; with
   * an interval of 0 at start and end only. Null for a leg that fires nothing.
   */
  vtkSmartPointer<vtkPolyData> GetTrajectory(int leg, double interval) const;

  /**
   * What the sampling of the beam comes to, in words, after Load().
   */
  std::string DescribeSampling();

  /**
   * Ends loading or the update at work soon; the outputs are then empty. May be
   * called from any thread and from observers.
   */
  void Abort() { this->AbortRequested = true; }

  vtkMTimeType GetMTime() override;

protected:
  vtkHeliosSurveySource();
  ~vtkHeliosSurveySource() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosSurveySource(const vtkHeliosSurveySource&) = delete;
  void operator=(const vtkHeliosSurveySource&) = delete;

  class Internals;

  bool Prepare();

  vtkSmartPointer<vtkHeliosSurvey> Survey;
  int Play = 0;
  vtkIdType Seed = -1;
  bool Noise = true;
  double RangeTolerance = 0.0;
  double EnergyTolerance = 0.0;
  int NumberOfSubRays = 0;
  char* EchoDetector = nullptr;
  char* RayCaster = nullptr;
  bool GenerateWaveforms = false;
  bool GeneratePulses = false;
  bool GenerateSubRays = false;
  bool GenerateTruth = false;
  vtkIdType PulseWindow[2] = { 0, VTK_ID_MAX };

  std::atomic<bool> AbortRequested{ false };
  std::unique_ptr<Internals> Loaded;
};

#endif
