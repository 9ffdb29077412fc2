// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveySource
 * @brief   runs a survey, or part of its pulses, in memory
 *
 * This is the pipeline counterpart of vtkHeliosSurveyPlayer, with the same legs, times, ids and
 * random numbers, and so the same echoes. PulseWindow selects a part of the run: a viewer requests
 * block after block, an inspector a single pulse, a study one leg (GetLegPulses()). Scene, legs and
 * the ray caster's tree are built once and kept until the survey, the inputs or the options they
 * depend on change. Data that the next epoch shares with the one before are not read again.
 *
 * Input 0, optional: a scene in place of the survey's, with the arrays of vtkHeliosSceneComposer if
 * it has materials and parts. Any vtkPolyData, vtkDataSet or composite data set will do: polygons
 * and strips are triangulated, other cells are replaced by their surface. It has the coordinates of
 * the legs [m]. Input 1, optional and repeatable: turbid voxels (vtkImageData), as made by
 * vtkHeliosVoxelReader; with an input, the parts of the survey's scene are neither read nor moved.
 *
 * Input 2, optional and repeatable: the trajectory (vtkPolyData) of the platforms that follow one
 * (type interpolated), in place of their files: points [m] with the point arrays GpsTime [s], in
 * order, and Orientation (unit quaternion w, x, y, z), as made by vtkHeliosTrajectoryReader.
 * Several are concatenated by time. Only the legs' times are used: tStart, tEnd, teleportToStart
 * and syncGPSTime.
 *
 * Input 3, optional: a mesh (vtkPolyData) that beams hit in place of the scene, on which the legs
 * are still planned: GetScene() with fewer triangles or without some parts, with its arrays of
 * materials and parts. Its moving parts move like the scene's.
 *
 * Output 0: the echoes of all legs in the window, in pulse order, with the arrays of
 * vtkHeliosScanner. Outputs 1, 2 and 3, with GenerateWaveforms, GeneratePulses and GenerateSubRays:
 * the waveforms (vtkTable), the pulses and the sub-ray hits, as in vtkHeliosScanner. Pieces are
 * contiguous ranges of the window; in order they cover it.
 *
 * Channels of a scanner fire at once: a window holds whole shots, those whose first pulse is in it.
 *
 * Events: ProgressEvent. The source forwards errors and warnings of all filters.
 *
 * @sa
 * vtkHeliosSurvey vtkHeliosSurveyReader vtkHeliosSurveyPlayer
 */

#ifndef vtkHeliosSurveySource_h
#define vtkHeliosSurveySource_h

#include "vtkHeliosEchoAlgorithm.h"
#include "vtkHeliosScannerRunModule.h" // For export macro
#include "vtkSmartPointer.h"           // For the survey

#include <atomic>     // For Abort()
#include <functional> // For LoadScene()
#include <memory>     // For the private data
#include <string>     // For text

class vtkHeliosEchoComparison;
class vtkHeliosRunOptions;
class vtkHeliosScanner;
class vtkHeliosSurvey;
class vtkImageData;

namespace helios
{
class LegRunner;
class SurveyLoader;
struct RunSettings;
}

class VTKHELIOSSCANNERRUN_EXPORT vtkHeliosSurveySource : public vtkHeliosEchoAlgorithm
{
public:
  static vtkHeliosSurveySource* New();
  vtkTypeMacro(vtkHeliosSurveySource, vtkHeliosEchoAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the survey to run. Required; no default.
   */
  void SetSurvey(vtkHeliosSurvey* survey);
  vtkHeliosSurvey* GetSurvey() const;
  ///@}

  ///@{
  /**
   * Set/Get the options of the run: epoch, seed, sampling of the beam, ray caster. Default: a new
   * vtkHeliosRunOptions. Null is ignored.
   */
  void SetOptions(vtkHeliosRunOptions* options);
  vtkHeliosRunOptions* GetOptions() const;
  ///@}

  ///@{
  /**
   * Set/Get the range [i0, i1) of pulse ids to compute. Valid range: 0 <= i0 <= i1. Default: all.
   */
  vtkSetVector2Macro(PulseWindow, vtkIdType);
  vtkGetVector2Macro(PulseWindow, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get whether meshes that several parts of the survey have are stored once, and rasters of
   * heights stay rasters, but not of parts that move: the scene is then a vtkHeliosScene. Default:
   * off.
   */
  vtkSetMacro(Instances, bool);
  vtkGetMacro(Instances, bool);
  vtkBooleanMacro(Instances, bool);
  ///@}

  /**
   * Loads the scene and plans the legs, unless that is done; Update() calls it. Returns false after
   * an error, and after Abort().
   */
  bool Load();

  ///@{
  /**
   * Returns the results of Load(); empty before. The scene as one mesh (with Instances: with its
   * instances), moving parts at their start; the number of pulses of all legs; the pulse ids [i0,
   * i1) and the time [t0, t1] of a leg [s], both empty ranges for a leg that fires no pulses; the
   * length of its pulses, the full width at half maximum, or 0 [ns]; the time of a pulse, and the
   * first pulse at a time or later [s].
   */
  vtkPolyData* GetScene() const;
  vtkIdType GetNumberOfPulses() const;
  void GetLegPulses(int leg, vtkIdType ids[2]) const;
  void GetLegTimes(int leg, double times[2]) const;
  double GetLegPulseLength(int leg) const;
  double GetPulseTime(vtkIdType pulse) const;
  vtkIdType FindPulse(double time) const;
  ///@}

  /**
   * Returns the grids of turbid voxels of the scene, from 0, after Load(): cell data PAD and field
   * data of materials, as made by vtkHeliosVoxelReader and the filters of their parts. Null if out
   * of range.
   */
  vtkImageData* GetGrid(int grid) const;

  /**
   * Returns the trajectory of a leg: one polyline (one point on a static platform) with GpsTime and
   * Orientation, sampled every interval [s], and at start and end; with an interval of 0 at start
   * and end only. Null for a leg that fires no pulses.
   */
  vtkSmartPointer<vtkPolyData> GetTrajectory(int leg, double interval) const;

  /**
   * Sets which echoes of a leg a comparison matches, from its scanner (the first channel): echoes
   * of 2 % of a full footprint, a plane of reflectance 0.5, and of twice the detection threshold,
   * nearer than 0.6 c sigma of the pulse. After Load(); does nothing for a leg that fires no
   * pulses.
   */
  void SetUpComparison(vtkHeliosEchoComparison* comparison, int leg) const;

  /**
   * Returns the size of the scene and of what its ray caster has built, after an update [bytes]; 0
   * before. Turbid voxels and outputs are not counted.
   */
  double GetSceneSize() const;

  /**
   * Describes the sampling of the beam as text, after Load().
   */
  std::string DescribeSampling();

  ///@{
  /**
   * Returns the versions, the options, and the files that the survey names with their SHA-256, as
   * JSON; reads these files, and does not load the scene. Empty after an error. Compare it with the
   * fingerprint of a source in another process: the differences as text, such as "plane.obj has
   * changed"; empty if both have the same results. ComputeLoadedFingerprint() loads the scene and
   * plans the legs, and adds the files that other files name, and the digest of the scene; compared
   * with such a one, another source loads its own.
   */
  std::string GetFingerprint();
  std::string ComputeLoadedFingerprint();
  std::string CompareFingerprint(const std::string& other);
  ///@}

#ifndef __VTK_WRAP__
  /**
   * Checks the options and sets the options of the settings; LoadScene() loads the scene, unless
   * that is done, and sets ray caster and grids. Both return false after an error; a step that
   * returns false stops the loading.
   */
  bool CheckOptions(helios::RunSettings& settings);
  bool LoadScene(
    const std::function<bool(const std::string& step)>& onStep, helios::RunSettings& settings);
  const helios::SurveyLoader& GetLoader() const;

  /// Returns a new scanner, set up as for leg 0 but for scene and trajectory, with a ray caster of
  /// its own; null if the leg fires no pulses or has several channels. After Load().
  vtkSmartPointer<vtkHeliosScanner> MakeScanner() const;
#endif

  /**
   * Ends the current loading or update soon; the outputs are then empty. May be called from any
   * thread and from observers.
   */
  void Abort()
  {
    this->AbortRequested = true;
  }

  vtkMTimeType GetMTime() override;

protected:
  vtkHeliosSurveySource();
  ~vtkHeliosSurveySource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosSurveySource(const vtkHeliosSurveySource&) = delete;
  void operator=(const vtkHeliosSurveySource&) = delete;

  class Internals;

  Internals& GetInternals();
  helios::LegRunner* GetLegs() const;
  void UpdateInputs();
  bool Prepare();

  vtkSmartPointer<vtkHeliosSurvey> Survey;
  vtkSmartPointer<vtkHeliosRunOptions> Options;
  bool Instances = false;
  vtkIdType PulseWindow[2] = { 0, VTK_ID_MAX };

  std::atomic<bool> AbortRequested{ false };
  std::unique_ptr<Internals> Loaded;
};

#endif
