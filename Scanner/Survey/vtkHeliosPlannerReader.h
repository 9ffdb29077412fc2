// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPlannerReader
 * @brief   read a planning task from HELIOS XML or a mesh
 *
 * Output 0 is the scene: triangles with materials and CRS, which vtkHeliosSurveyPlayer scans.
 * Read() reads only the settings, with which vtkHeliosScanPlan sets up the filters. Input 0,
 * optional, is a scene in place of the file's; then FileName may be empty. The following is read
 * from a file:
 * - the first <surveyPlanner>: Docs/planning.md, Docs/dialect.md;
 * - else the first <survey>: its scene, and platform, scanner and scanner settings of its first leg
 *   that fires pulses; its changes to the scanner are ignored;
 * - else the first <scene>, scanned with DefaultPlatform and DefaultScanner;
 * - a file that ends in .obj, .tif or .tiff is itself the scene. If parts of the scene are swapped,
 *   the first epoch is used; turbid voxels are not in the output: with KeepGrids, GetGrid() returns
 *   them. Parts that move are left out, or, with UseMovingParts, where they are at time 0 of a
 *   survey; a warning names them.
 *
 * The platform must be static, and the scanner must rotate. Platform and Scanner override the
 * file's. The scanner rotates a full circle unless a <scannerSettings> says otherwise, at the
 * Resolution, or the finest that it supports.
 *
 * Errors give file:line, the value and the fix, like the errors of vtkHeliosSurveyReader, which
 * documents the search path; all errors are reported, not only the first.
 *
 * @sa
 * vtkHeliosScanPlan vtkHeliosSurveyWriter vtkHeliosSurveyReader
 */

#ifndef vtkHeliosPlannerReader_h
#define vtkHeliosPlannerReader_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the private data
#include <string> // For the names

class vtkImageData;

namespace helios
{
struct PlannerData;
struct PlannerSettings;
}

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosPlannerReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPlannerReader* New();
  vtkTypeMacro(vtkHeliosPlannerReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. Default: none, the scene on port 0.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Adds an asset directory to search, after those added before; remove all. Default: none.
   */
  void AddAssetDirectory(const char* directory);
  void RemoveAllAssetDirectories();
  ///@}

  ///@{
  /**
   * Set/Get the platform and the scanner that override the file's, file.xml#id. Default: none.
   */
  vtkSetStringMacro(Platform);
  vtkGetStringMacro(Platform);
  vtkSetStringMacro(Scanner);
  vtkGetStringMacro(Scanner);
  ///@}

  ///@{
  /**
   * Set/Get the platform and the scanner for a scene or mesh given as input, file.xml#id. Default:
   * none.
   */
  vtkSetStringMacro(DefaultPlatform);
  vtkGetStringMacro(DefaultPlatform);
  vtkSetStringMacro(DefaultScanner);
  vtkGetStringMacro(DefaultScanner);
  ///@}

  ///@{
  /**
   * Set/Get whether range and elevation limits that the file does not give come from the scanner,
   * whatever the file says. Default: off, the file decides.
   */
  vtkSetMacro(UseScannerLimits, bool);
  vtkGetMacro(UseScannerLimits, bool);
  vtkBooleanMacro(UseScannerLimits, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the scene has its moving parts, where they are at the start of a survey, whatever
   * the file says. Default: off, the file decides.
   */
  vtkSetMacro(UseMovingParts, bool);
  vtkGetMacro(UseMovingParts, bool);
  vtkBooleanMacro(UseMovingParts, bool);
  ///@}

  ///@{
  /**
   * Set/Get the angle between pulses of a line and between lines [deg], which overrides the file.
   * The nearest supported by the scanner is used. Valid range: [0, 90]. Default: 0, as in the file,
   * else 0.1.
   */
  vtkSetClampMacro(Resolution, double, 0.0, 90.0);
  vtkGetMacro(Resolution, double);
  ///@}

  ///@{
  /**
   * Set/Get the pulse frequency [Hz], which overrides the file. Valid range: [0, 1e9]. Default: 0,
   * as in the file, else the first of the scanner.
   */
  vtkSetClampMacro(PulseFrequency, double, 0.0, 1e9);
  vtkGetMacro(PulseFrequency, double);
  ///@}

  /**
   * Reads the file with all its references, but no geometry. Returns false after an error.
   */
  bool Read();

  ///@{
  /**
   * Returns the type of file: "planner", "survey" or "scene"; a name valid for a folder; the
   * sources of scene, platform and scanner, file.xml#id. That of the scene is empty if the file is
   * a mesh, or the scene is on port 0.
   */
  std::string GetKind() const;
  std::string GetPlanName() const;
  std::string GetSceneReference() const;
  std::string GetPlatformReference() const;
  std::string GetScannerReference() const;
  ///@}

  ///@{
  /**
   * Returns the method: reduce, bestcoverage, greedy, best or optimal, empty without a
   * <surveyPlanner>; the removal criterion of reduce: viewshedSize or meanIncidenceAngle; whether
   * limits that are not given come from the scanner; whether the scene has its moving parts.
   */
  std::string GetMethod() const;
  std::string GetRemoveOrder() const;
  bool GetScannerLimits() const;
  bool GetMovingParts() const;
  ///@}

  /**
   * Returns all settings of the plan, which vtkHeliosScanPlan sets on the filters.
   */
  const helios::PlannerSettings& GetSettings() const;

  ///@{
  /**
   * Returns how a position is scanned: the pulse and the scan frequency [Hz], half the scan angle
   * of the mirror, the window of a rotating one, and the angles [deg] and the speed [deg/s] of the
   * head rotation.
   */
  double GetLegPulseFrequency() const;
  double GetLegScanFrequency() const;
  double GetLegScanAngle() const;
  double GetLegVerticalAngleMin() const;
  double GetLegVerticalAngleMax() const;
  double GetLegHeadRotateStart() const;
  double GetLegHeadRotateStop() const;
  double GetLegHeadRotatePerSecond() const;
  ///@}

  ///@{
  /**
   * Returns whether the scanner has a rotating mirror, which uses the window; the larger of the
   * angles between its pulses along and across a line [deg], 0 if they are irregular; the offset
   * from the platform to the beam origin [m].
   */
  bool HasRotatingMirror() const;
  double GetLegAngularStep() const;
  void GetInstrument(double position[3]) const;
  ///@}

  ///@{
  /**
   * Set/Get whether the grids of turbid voxels of the scene are kept. Default: off.
   */
  vtkSetMacro(KeepGrids, bool);
  vtkGetMacro(KeepGrids, bool);
  vtkBooleanMacro(KeepGrids, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the output may be a vtkHeliosScene with instances, as in vtkHeliosSurveySource;
   * the filters of vtkHeliosScanPlan take it. Default: off.
   */
  vtkSetMacro(Instances, bool);
  vtkGetMacro(Instances, bool);
  vtkBooleanMacro(Instances, bool);
  ///@}

  /**
   * Returns a grid, from 0, after Update(), as in vtkHeliosSurveySource. Null if out of range.
   */
  vtkImageData* GetGrid(int grid) const;

protected:
  vtkHeliosPlannerReader();
  ~vtkHeliosPlannerReader() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosPlannerReader(const vtkHeliosPlannerReader&) = delete;
  void operator=(const vtkHeliosPlannerReader&) = delete;

  class Internals;
  std::unique_ptr<Internals> Reader;

  char* FileName = nullptr;
  char* Platform = nullptr;
  char* Scanner = nullptr;
  char* DefaultPlatform = nullptr;
  char* DefaultScanner = nullptr;
  bool UseScannerLimits = false;
  bool UseMovingParts = false;
  double Resolution = 0.0;
  double PulseFrequency = 0.0;
  bool KeepGrids = false;
  bool Instances = false;

  const helios::PlannerData& GetData() const;
};

#endif
