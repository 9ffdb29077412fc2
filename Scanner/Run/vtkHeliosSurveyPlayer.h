// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveyPlayer
 * @brief   runs the legs of a survey and writes the records of the scanner
 *
 * The player is a vtkHeliosSurveySource with writers: Run() loads the source, runs the legs of its
 * survey block by block and passes each block to the writers, so that memory does not grow with the
 * number of pulses. A leg of a moving platform runs from its waypoint to the next, and the last leg
 * is an end point; on a static platform a leg is a scan position. GPS time and pulse ids continue
 * from leg to leg; an inactive leg takes its time and fires no pulses. MaximumDuration of a leg
 * ends its pulses, not its trajectory.
 *
 * Files, for every leg NNN that fires pulses, in OutputDirectory/<name of the survey>:
 * - legNNN_points.xyz (or .las, .pvtp): the echoes
 * - legNNN_trajectory.txt (or .pvtp): the platform every trajectoryTimeInterval_s, and at start and
 *   end of the leg
 * - legNNN_fullwave.txt (or .las, .pvtt), with WriteWaveforms: the waveforms; LAS has them with the
 *   points again, unless WaveformsInPoints puts them into legNNN_points.las
 * - legNNN_pulse.txt (or .pvtp), with WritePulses: the pulses
 * - legNNN_hits.pvtp, with WriteHits: the hits of the sub-rays of the beams Legs of the same strip
 *   S share files, stripS_points.xyz etc. The channels of a scanner fire at once, and their records
 *   go to one file in pulse order, or with SplitByChannel to legNNN_points_dev<channel>.xyz etc.
 *
 * If parts of the scene are swapped, the survey has several epochs
 * (vtkHeliosSurvey::GetNumberOfEpochs()): the same legs and other geometry. A run is one of them,
 * Epoch of the options, in a subfolder of the survey's folder, epoch000, epoch001 etc., with its own
 * journal and summary. GPS time, pulse ids and random numbers, keyed by seed and pulse, are the same in all
 * epochs: their points differ only by geometry.
 *
 * While a leg runs its files end in .part and are valid up to the last block; run.journal records
 * what is flushed to disk. Resume continues a run that ended early for any reason; its files are
 * byte-identical to the files of an uninterrupted run. When all legs are complete, run_summary.json
 * replaces the journal: versions, inputs with their SHA-256, options, counts and files of every
 * leg, and separately the timings, which depend on the host. With the option AccuracyReport some of
 * the pulses are computed again with a reference, and the summary has the "accuracy".
 *
 * Events: StartEvent, ProgressEvent (while loading and after every block; the data is the progress
 * as a double), EndEvent. The player forwards errors and warnings of all filters. vtkSMPTools sets
 * the number of threads; the output does not depend on it.
 *
 * @sa
 * vtkHeliosSurveySource vtkHeliosRunOptions vtkHeliosSurvey vtkHeliosSurveyReader
 */

#ifndef vtkHeliosSurveyPlayer_h
#define vtkHeliosSurveyPlayer_h

#include "vtkHeliosEchoAlgorithm.h"    // For the outputs
#include "vtkHeliosScannerRunModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For the source and the ranks

#include <atomic> // For Abort()
#include <memory> // For the counts
#include <string> // For the message
#include <vector> // For the parts

class vtkHeliosRanks;
class vtkHeliosRunOptions;
class vtkHeliosSurvey;
class vtkHeliosSurveySource;

namespace helios
{
class SurveyRun;
struct RunState;
}

class VTKHELIOSSCANNERRUN_EXPORT vtkHeliosSurveyPlayer : public vtkObject
{
public:
  static vtkHeliosSurveyPlayer* New();
  vtkTypeMacro(vtkHeliosSurveyPlayer, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get what is run: a survey, its options and, from a pipeline, its scene. Several players and
   * other users of a source share the loaded scene and its ray-tracing tree. Default: a source of
   * its own. Null is ignored.
   */
  void SetSource(vtkHeliosSurveySource* source);
  vtkHeliosSurveySource* GetSource() const;
  ///@}

  ///@{
  /**
   * Set/Get the survey of the source, and its options. Default: no survey, and a new
   * vtkHeliosRunOptions.
   */
  void SetSurvey(vtkHeliosSurvey* survey);
  vtkHeliosSurvey* GetSurvey() const;
  void SetOptions(vtkHeliosRunOptions* options);
  vtkHeliosRunOptions* GetOptions() const;
  ///@}

  ///@{
  /**
   * Set/Get the parent of the survey's output folder. Default: "output".
   */
  vtkSetFilePathMacro(OutputDirectory);
  vtkGetFilePathMacro(OutputDirectory);
  ///@}

  /**
   * Returns the output folder of Run(): OutputDirectory/<name of the survey>, with the subfolder epochNNN if
   * the survey has several epochs, and partNNNofNNN of a part. Empty without a survey.
   */
  std::string GetRunFolder();

  ///@{
  /**
   * Set/Get the file format: "xyz", text columns; "las", points as LAS 1.4 (vtkHeliosLASWriter) and
   * the rest as text; or "vtp", VTK XML. Default: "xyz".
   */
  vtkSetStringMacro(Format);
  vtkGetStringMacro(Format);
  ///@}

  ///@{
  /**
   * Set/Get what is written besides the echoes: the properties of the table of outputs of
   * vtkHeliosEchoAlgorithm, with the same arrays. Default: off.
   *
   * WaveformsInPoints says where the waveforms of Format "las" are. Off: legNNN_points.las has point
   * format 6 or 7, which all programs read, and legNNN_fullwave.las the same points with waveforms,
   * point format 9 or 10, whose packets are in legNNN_fullwave.wdp. On: only legNNN_points.las, of
   * format 9 or 10, and legNNN_points.wdp.
   *
   * WriteScanFlags adds two columns to text; points in LAS always have the flags. With WriteDecibels
   * text has these two columns and two more; in LAS they are Extra Bytes with the names of RIEGL.
   * WriteColors needs "las" or "vtp", WriteTruth and WriteColumns "vtp". The hits of WriteHits,
   * points with PulseIds, Weight (share of the energy of the pulse, (0, 1]), Range [m], CellIds and
   * IncidenceAngle [deg], are VTK XML in any Format. With SplitByChannel every channel of a scanner
   * has its own files.
   */
  vtkHeliosFileOutputsMacro();
  ///@}

  ///@{
  /**
   * Set/Get whether the files of an earlier run are replaced; if off, they are kept and Run()
   * fails. Default: off.
   */
  vtkSetMacro(Overwrite, bool);
  vtkGetMacro(Overwrite, bool);
  vtkBooleanMacro(Overwrite, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the earlier run in the folder is continued after its last block. If inputs or
   * settings have changed, it is an error that lists the changes. A finished run is left as it is;
   * an Epoch above 0 that has not started is started. Excludes Overwrite. Default: off.
   */
  vtkSetMacro(Resume, bool);
  vtkGetMacro(Resume, bool);
  vtkBooleanMacro(Resume, bool);
  ///@}

  ///@{
  /**
   * Set/Get how many bytes of the earlier run's newest blocks Resume compares with their checksums
   * in the journal; the sizes of all files are always compared. Valid range: [0, VTK_ID_MAX], the
   * latter: all. Default: 2^30.
   */
  vtkSetClampMacro(BytesToCheck, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(BytesToCheck, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the number of pulses per block. The content of "xyz" and "las" files does not depend on
   * it; with "vtp" each block is a file. Valid range: [1, 2^24]. Default: 262144.
   */
  vtkSetClampMacro(PulsesPerBlock, vtkIdType, 1, 16777216);
  vtkGetMacro(PulsesPerBlock, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get which part of the run is run, of a number of parts: consecutive blocks of pulses, so
   * that several computers share a run. A part has its own folder, partNNNofNNN in the folder of
   * the run, and its own journal, which stays; --resume continues it as any run, and starts one
   * that was not started. Its files of points and waveforms have the format of the run if Format is
   * "xyz", else VTK XML; it has no trajectories and no accuracy. Valid range: [1, NumberOfParts];
   * 0: the whole run. Default: 1 and 0.
   */
  vtkSetClampMacro(Part, int, 1, VTK_INT_MAX);
  vtkGetMacro(Part, int);
  vtkSetClampMacro(NumberOfParts, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfParts, int);
  ///@}

  ///@{
  /**
   * Set/Get a text that the journal of a part has for the program that joins the parts, such as the
   * command that runs the part. Default: empty.
   */
  vtkSetMacro(PartCommand, std::string);
  vtkGetMacro(PartCommand, std::string);
  ///@}

  ///@{
  /**
   * Adds the folder of a part, or removes all of them. With folders Run() computes no pulses: it
   * reads their blocks from the parts and writes the files of the run, byte-identical to the files
   * of one process. All parts of one run are required, with the same inputs and options; their
   * folders may be anywhere. Default: none.
   */
  void AddPartFolder(const std::string& folder);
  void ClearPartFolders();
  int GetNumberOfPartFolders() const { return static_cast<int>(this->PartFolders.size()); }
  ///@}

  ///@{
  /**
   * Set/Get the processes that share the run: rank 0 calls Run(), which gives blocks of pulses to the
   * other ranks and writes them in order, and Dismiss() of the ranks when no run follows; the others
   * call Serve(). All have the same survey and options. Files are byte-identical for any number of
   * ranks, which may change with Resume. Default: null, one process.
   */
  void SetRanks(vtkHeliosRanks* ranks);
  vtkHeliosRanks* GetRanks() const;
  ///@}

  ///@{
  /**
   * Set/Get whether a run first computes some hundred of its pulses in several ways: at tolerances of 1, 3 and 10
   * mm, with 19 fixed sub-rays, and by a reference; in at most 2 % of its time, and one second. GetForecastReport() has
   * time and errors. Runs of less than some 3 s, parts, and runs of several ranks have none. Changes no echo.
   * Default: off.
   */
  vtkSetMacro(Forecast, bool);
  vtkGetMacro(Forecast, bool);
  vtkBooleanMacro(Forecast, bool);
  ///@}

  /**
   * Returns the forecast of the current or last Run(), as JSON: "ways", each with run_s and its errors, or the "reason"
   * why there is none. Empty before, and without it.
   */
  std::string GetForecastReport() const;

  /**
   * Computes blocks for the runs of rank 0 until it dismisses its ranks. Returns false after an error
   * and after Abort(). Errors of the survey are reported by rank 0.
   */
  bool Serve();

  /**
   * Runs the survey. Returns false after an error, after Abort(), and if the run has no points;
   * GetMessage() gives the reason, and what is kept.
   */
  bool Run();

  /**
   * Loads the survey, runs samples of all its legs and estimates from them time and output of
   * Run(); GetReport() returns it. Writes nothing. Returns false after an error and after Abort().
   */
  bool Estimate();

  /**
   * Ends the run after the current block; may be called from any thread and from observers.
   */
  void Abort() { this->AbortRequested = true; }

  ///@{
  /**
   * Get the fraction of pulses done, in [0, 1]; the current leg and the number of legs; the current
   * step, or the result of the run, as text.
   */
  double GetProgress() const;
  int GetCurrentLeg() const;
  int GetNumberOfLegs() const;
  std::string GetMessage() const;
  ///@}

  /**
   * Returns the run_summary.json of the last Run(), or the result of the last Estimate(), as JSON.
   * Empty before, and after a failure.
   */
  std::string GetReport() const;

  /**
   * Whether Run() found a run that was already finished, and did nothing.
   */
  bool GetWasFinished() const;

  /**
   * The number of pulse indices of the run, known once the scene is loaded.
   */
  vtkIdType GetNumberOfPulses() const;

  /**
   * Returns a count of the blocks done, by its name: "pulses", pulse indices, whether emitted or
   * not; "points" and "firstReturns", written; and the names of vtkHeliosScanner::GetCount(). -1
   * for any other name.
   */
  vtkIdType GetCount(const std::string& name) const;

  /**
   * Describes the sampling of the beam as text.
   */
  std::string GetSampling() const;

protected:
  vtkHeliosSurveyPlayer();
  ~vtkHeliosSurveyPlayer() override;

private:
  vtkHeliosSurveyPlayer(const vtkHeliosSurveyPlayer&) = delete;
  void operator=(const vtkHeliosSurveyPlayer&) = delete;

  vtkSmartPointer<vtkHeliosSurveySource> Source;
  vtkSmartPointer<vtkHeliosRanks> Ranks;
  char* OutputDirectory = nullptr;
  char* Format = nullptr;
  vtkHeliosEchoAlgorithm::Outputs Wanted;
  bool Overwrite = false;
  bool Resume = false;
  int Part = 1;
  int NumberOfParts = 0;
  std::string PartCommand;
  std::vector<std::string> PartFolders;
  bool Forecast = false;
  vtkIdType PulsesPerBlock = 262144;
  vtkIdType BytesToCheck = 1073741824;

  std::atomic<bool> AbortRequested{ false };
  std::unique_ptr<helios::RunState> State;

  bool Attempt(bool (helios::SurveyRun::*work)());
};

#endif
