// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs the legs of a survey, block by block, into files.

#ifndef heliosLegRunner_h
#define heliosLegRunner_h

#include "heliosBlockSource.h"
#include "heliosInputFile.h"
#include "heliosLegFiles.h"
#include "heliosLegOutput.h"
#include "heliosLegPlan.h"
#include "heliosLegScanner.h"
#include "heliosRunProgress.h"
#include "heliosRunSettings.h"
#include "heliosScanCounts.h"
#include "heliosScannerBlocks.h"
#include "heliosSurveyData.h"
#include "vtkHeliosScannerRunModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

class LegWriting;
class Messages;
class RunJournal;

/// Runs after every block, and while its pieces are computed; false ends the run.
using BlockCallback = std::function<bool(const ScanCounts&)>;

/// Runs legs, with the blocks of its own scanner or of another source.
class VTKHELIOSSCANNERRUN_EXPORT LegRunner
{
public:
  using Outputs = LegOutputs;

  LegRunner(
    const SurveyData& survey, vtkPolyData* scene, const RunSettings& settings, Messages& log);
  ~LegRunner();

  /// Plans the legs and counts their pulses; false after an error.
  bool Plan();

  /// Returns the legs, or the legs of the part that is run.
  const std::vector<LegPlan>& GetPlans() const { return this->Plans; }

  /// @{
  /// Returns the pulses of the survey, and of the part that is run.
  vtkIdType GetNumberOfPulses() const { return this->NumberOfPulses; }
  vtkIdType GetNumberOfPulsesToRun() const { return this->NumberOfPulsesToRun; }
  ///@}

  /// Sets where blocks are from in place of the scanner; null: the scanner.
  void SetSource(BlockSource* source) { this->Source = source ? source : &this->Own; }

  /// Returns the files that Plan() has opened: trajectories, spectra, emitted pulses.
  const InputFiles& GetInputs() const { return this->Inputs; }

  const ScanCounts& GetCounts() const { return this->Counts; }
  const SurveyData& GetSurvey() const { return this->Survey; }
  vtkPolyData* GetScene() const;

  /// Returns whether there was any error, including errors of the objects listened to.
  bool HasError() const;
  void Listen(vtkHeliosStreamWriter* writer);

  /// Sets a callback while the scanner computes a piece outside of Run(); false stops it.
  void SetOnProgress(const std::function<bool(double)>& onProgress)
  {
    this->OnProgress = onProgress;
    this->Scanner.SetOnProgress(onProgress);
  }

  /// Runs one leg, or its rest according to the journal, and writes its files and the journal.
  /// Returns false after an error or if the callback stops it. The files written so far are then
  /// valid and end in .part; the journal has them up to the last piece that is complete.
  bool Run(const LegPlan& plan, RunJournal& journal, const BlockCallback& onBlock);

  /// Returns the scanner, set up for a leg.
  LegScanner& Prepare(const LegPlan& plan);

  /// Prepares a leg, to run in another way (LegScanner::SetOptions).
  LegScanner& Prepare(const LegPlan& plan, const RunOptions& options);

  /// Makes the outputs of the leg that the scanner is set up for, with unopened writers.
  Outputs MakeOutputs(const LegPlan& plan) const;

  /// The blocks of the scanner, which is set up for their leg.
  ScannerBlocks& GetBlocks() { return this->Own; }

  /// Writes the output of the scanner; false after an error.
  bool Write(const Outputs& outputs);

  /// Returns the writer of the leg's trajectory, not open yet.
  vtkSmartPointer<vtkHeliosStreamWriter> MakeTrajectoryWriter(const LegPlan& plan) const;

  /// Returns the most pulses that are computed, then written at a time.
  vtkIdType GetPulsesPerPiece() const;

  /// Describes the numbers of sub-rays and bins as text.
  std::string DescribeSampling();

  std::string GetRayCasterName() const;

  /// Returns the size of scene and ray caster [bytes].
  double GetSceneSize() const { return this->Scanner.GetSceneSize(); }

  /// Returns the parts that move, with their speeds in the legs.
  std::vector<PartSpeeds> GetSpeeds() const { return this->Scanner.GetSpeeds(this->Plans); }

private:
  /// Pieces [First, Last) of the Count pieces of a leg.
  struct PieceRange
  {
    vtkIdType First;
    vtkIdType Last;
    vtkIdType Count;
  };

  /// A leg that is run.
  struct LegRun
  {
    const LegPlan& Plan;
    const Outputs& Files;
    LegWriting& Writing;
    const BlockCallback& OnBlock;
    double Start; ///< [s]
    LegProgress Progress;
  };

  void WarnWithoutNoise();
  void SelectPart();
  bool EndsFiles(const LegPlan& plan) const;
  bool Open(vtkHeliosStreamWriter* writer, const RunJournal& journal);
  bool OpenAll(const Outputs& outputs, const RunJournal& journal);
  bool WriteTrajectory(const LegPlan& plan, const RunJournal& journal, const BlockCallback& onBlock,
    FileProgress& written);
  bool RunBlocks(
    const LegPlan& plan, const Outputs& outputs, RunJournal& journal, const BlockCallback& onBlock);
  static vtkIdType CountJoined(vtkIdType piece, const PieceRange& pieces);
  bool RunPieces(const PieceRange& pieces, LegRun& run);
  void WatchPiece(const LegRun& run, vtkIdType piece, vtkIdType count);
  vtkIdType CountPulsesBefore(const LegPlan& plan, vtkIdType piece, vtkIdType count) const;

  const SurveyData& Survey;
  RunSettings Settings;
  Messages& Log;
  LegFiles Files;
  vtkSmartPointer<vtkPolyData> Scene;
  LegScanner Scanner;
  std::function<bool(double)> OnProgress;
  std::vector<LegPlan> Plans;
  InputFiles Inputs;
  ScannerBlocks Own;
  BlockSource* Source = &this->Own;
  vtkIdType NumberOfPulses = 0;
  vtkIdType NumberOfPulsesToRun = 0;
  vtkIdType FirstPulse = 0; // first pulse that is run
  ScanCounts Counts;
};

} // namespace helios

#endif
