// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveyPlayer
 * @brief   runs the legs of a survey and writes what the scanner records
 *
 * Run() builds the pipeline of a survey (scene readers, transforms, composer;
 * platform; scanner), runs its legs block by block and hands each block to the
 * writers, so that memory does not grow with the number of pulses. A leg of a
 * moving platform goes from its waypoint to the next one's, and the last is an
 * end point; on a platform that stands a leg is a scan position. GPS time and
 * pulse ids go on from leg to leg; a leg that is not active takes its time and
 * fires nothing. MaximumDuration of a leg ends its pulses, not its way.
 *
 * Files, for every leg NNN that fires pulses, in OutputDirectory/<name of the
 * survey>:
 * - legNNN_points.xyz (or .las, .pvtp): the echoes
 * - legNNN_trajectory.txt (or .pvtp): the platform every trajectoryTimeInterval_s, and at
 *   start and end of the leg
 * - legNNN_fullwave.txt (or .pvtt), with WriteWaveforms: the waveforms; those of
 *   legNNN_points.las are in legNNN_points.wdp
 * - legNNN_pulse.txt (or .pvtp), with WritePulses: the pulses
 * Legs of the same strip S write to one file each, stripS_points.xyz and so on.
 * The channels of a scanner fire at once, and their records go to one file in
 * the order of pulses, or with SplitByChannel to legNNN_points_dev<channel>.xyz
 * and so on.
 *
 * Where parts of the scene are swapped, the survey has several plays
 * (vtkHeliosSurvey::GetNumberOfPlays()): the same legs and other geometry. A run
 * is one of them, Play, in a folder of its own below that of the survey,
 * play000, play001 and so on, with its own journal and summary. GPS time, pulse
 * ids and random numbers, which are keyed by seed and pulse, are the same in all
 * plays: what differs between their points comes of the geometry.
 *
 * While a leg runs its files end in .part and are valid up to the last block;
 * run.journal says what is safe on the disk. A run that ended early for whatever
 * reason goes on with Resume, to the same bytes as an unbroken one. When all
 * legs are whole, run_summary.json takes the place of the journal: versions,
 * inputs with their SHA-256, options, counts and files of every leg, and apart
 * from these what the host adds, the timings.
 *
 * Events: StartEvent, ProgressEvent (while loading and after every block; the
 * data is the progress as a double), EndEvent. Errors and warnings of all
 * filters come as the player's own. The number of threads is that of
 * vtkSMPTools; it changes no byte of the output.
 *
 * @sa
 * vtkHeliosSurvey vtkHeliosSurveyReader vtkHeliosScanner
 */

#ifndef vtkHeliosSurveyPlayer_h
#define vtkHeliosSurveyPlayer_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For the survey

#include <atomic> // For Abort()
#include <string> // For the message

class vtkHeliosSurvey;

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurveyPlayer : public vtkObject
{
public:
  static vtkHeliosSurveyPlayer* New();
  vtkTypeMacro(vtkHeliosSurveyPlayer, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the survey to run. Default: none.
   */
  void SetSurvey(vtkHeliosSurvey* survey);
  vtkHeliosSurvey* GetSurvey() const;
  ///@}

  ///@{
  /**
   * Set/Get the folder that the survey's own folder is made in. Default:
   * "output".
   */
  vtkSetFilePathMacro(OutputDirectory);
  vtkGetFilePathMacro(OutputDirectory);
  ///@}

  ///@{
  /**
   * Set/Get the play to run: which geometry the swapped parts of the scene have.
   * Valid range: [0, the survey's GetNumberOfPlays() - 1]. Default: 0.
   */
  vtkSetClampMacro(Play, int, 0, VTK_INT_MAX);
  vtkGetMacro(Play, int);
  ///@}

  /**
   * The folder that Run() writes to: OutputDirectory/<name of the survey>, and
   * below it playNNN where the survey has several plays. Empty without a survey.
   */
  std::string GetRunFolder();

  ///@{
  /**
   * Set/Get the form of the files: "xyz", text columns; "las", points as LAS 1.4
   * (vtkHeliosLASWriter) and the rest as text; or "vtp", VTK XML. Default: "xyz".
   */
  vtkSetStringMacro(Format);
  vtkGetStringMacro(Format);
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
   * Set/Get the number of sub-rays that every pulse has: 1, 7, 19, 37, 62 ... on
   * circles as beamSampleQuality has them, any other number (rounded up to a
   * multiple of 4) on a spiral. Valid range: [0, 65536]. Default: 0, as the
   * survey says.
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
   * Set/Get whether the waveforms are written. Default: off.
   */
  vtkSetMacro(WriteWaveforms, bool);
  vtkGetMacro(WriteWaveforms, bool);
  vtkBooleanMacro(WriteWaveforms, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the pulses are written, those that hit nothing, too. Default:
   * off.
   */
  vtkSetMacro(WritePulses, bool);
  vtkGetMacro(WritePulses, bool);
  vtkBooleanMacro(WritePulses, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether every channel of a scanner has files of its own. Default:
   * off.
   */
  vtkSetMacro(SplitByChannel, bool);
  vtkGetMacro(SplitByChannel, bool);
  vtkBooleanMacro(SplitByChannel, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the files of an earlier run are replaced; without it they
   * are kept, and the run is refused. Default: off.
   */
  vtkSetMacro(Overwrite, bool);
  vtkGetMacro(Overwrite, bool);
  vtkBooleanMacro(Overwrite, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the earlier run in the folder is gone on with after its last
   * block: with the inputs and settings that it had, else it is an error that
   * says what has changed. Where it was finished nothing is done; a Play above 0
   * that has not begun is begun. Excludes Overwrite. Default: off.
   */
  vtkSetMacro(Resume, bool);
  vtkGetMacro(Resume, bool);
  vtkBooleanMacro(Resume, bool);
  ///@}

  ///@{
  /**
   * Set/Get how many bytes of the earlier run's newest blocks Resume compares with
   * their checksums in the journal before it goes on; the sizes of all files are
   * always compared. Valid range: [0, VTK_ID_MAX], the latter: all. Default: 2^30.
   */
  vtkSetClampMacro(BytesToCheck, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(BytesToCheck, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the pulses between two writes. No byte of "xyz" and "las" depends on
   * it; of "vtp" each block is a file. Valid range: [1, 2^24]. Default: 262144.
   */
  vtkSetClampMacro(PulsesPerBlock, vtkIdType, 1, 16777216);
  vtkGetMacro(PulsesPerBlock, vtkIdType);
  ///@}

  /**
   * Runs the survey. Returns false after an error, after Abort(), and where it
   * ends without a point; GetMessage() says why, and what is kept.
   */
  bool Run();

  /**
   * Loads the survey, runs samples of all its legs and reckons from them what
   * Run() would take and give; GetReport() has it. Writes nothing. Returns false
   * after an error and after Abort().
   */
  bool Estimate();

  /**
   * Ends the run after the block at work; may be called from any thread and from
   * observers.
   */
  void Abort() { this->AbortRequested = true; }

  ///@{
  /**
   * How far the run is: the share of its pulses, in [0, 1]; the leg at work, and
   * how many legs the survey has; what it does, or how it ended, in words.
   */
  vtkGetMacro(Progress, double);
  vtkGetMacro(CurrentLeg, int);
  int GetNumberOfLegs() const;
  std::string GetMessage() const { return this->Message; }
  ///@}

  /**
   * What the last Run() wrote to run_summary.json, or what the last Estimate()
   * came to: JSON. Empty before, and after a failure.
   */
  std::string GetReport() const { return this->Report; }

  /**
   * Whether Run() has found a run that was finished already, and done nothing.
   */
  vtkGetMacro(WasFinished, bool);

  ///@{
  /**
   * The pulse indices of the run, known once the scene is loaded; how many of
   * them are done; the pulses among those that left the scanner; the points, and
   * the first returns among them, that are written.
   */
  vtkGetMacro(NumberOfPulses, vtkIdType);
  vtkGetMacro(NumberOfPulsesDone, vtkIdType);
  vtkGetMacro(NumberOfPulsesFired, vtkIdType);
  vtkGetMacro(NumberOfEchoes, vtkIdType);
  vtkGetMacro(NumberOfFirstReturns, vtkIdType);
  ///@}

  ///@{
  /**
   * Which way the pulses went that left the scanner: they met one plane, which is
   * written down in closed form; their maxima were found without bins; they were
   * binned; the rest met nothing. The sub-rays traced for all of them. What the
   * sampling came to, in words.
   */
  vtkGetMacro(NumberOfPulsesOnPlane, vtkIdType);
  vtkGetMacro(NumberOfPulsesWithoutBins, vtkIdType);
  vtkGetMacro(NumberOfPulsesBinned, vtkIdType);
  vtkGetMacro(NumberOfSubRaysTraced, vtkIdType);
  std::string GetSampling() const { return this->Sampling; }
  ///@}

protected:
  vtkHeliosSurveyPlayer();
  ~vtkHeliosSurveyPlayer() override;

private:
  vtkHeliosSurveyPlayer(const vtkHeliosSurveyPlayer&) = delete;
  void operator=(const vtkHeliosSurveyPlayer&) = delete;

  class Internals;
  friend class Internals;

  vtkSmartPointer<vtkHeliosSurvey> Survey;
  char* OutputDirectory = nullptr;
  int Play = 0;
  char* Format = nullptr;
  char* RayCaster = nullptr;
  char* EchoDetector = nullptr;
  double RangeTolerance = 0.0;
  double EnergyTolerance = 0.0;
  int NumberOfSubRays = 0;
  vtkIdType Seed = -1;
  bool Noise = true;
  bool WriteWaveforms = false;
  bool WritePulses = false;
  bool SplitByChannel = false;
  bool Overwrite = false;
  bool Resume = false;
  bool WasFinished = false;
  vtkIdType PulsesPerBlock = 262144;
  vtkIdType BytesToCheck = 1073741824;

  std::atomic<bool> AbortRequested{ false };
  double Progress = 0.0;
  int CurrentLeg = 0;
  vtkIdType NumberOfPulses = 0;
  vtkIdType NumberOfPulsesDone = 0;
  vtkIdType NumberOfPulsesFired = 0;
  vtkIdType NumberOfEchoes = 0;
  vtkIdType NumberOfFirstReturns = 0;
  vtkIdType NumberOfPulsesOnPlane = 0;
  vtkIdType NumberOfPulsesWithoutBins = 0;
  vtkIdType NumberOfPulsesBinned = 0;
  vtkIdType NumberOfSubRaysTraced = 0;
  std::string Sampling;
  std::string Message;
  std::string Report;

  void Reset();
  bool Attempt(bool (Internals::*work)());
};

#endif
