// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPlannerReader
 * @brief   what is to be planned, and how, from HELIOS XML or a mesh
 *
 * Output 0 is the scene: triangles with materials and CRS, as vtkHeliosSurveyPlayer
 * would scan it. Read() reads the settings without it, and the getters below have
 * them. A file is looked at for
 * - the first <surveyPlanner>: Docs/planning.md, Docs/dialect.md;
 * - else the first <survey>: its scene, and platform, scanner and scanner settings
 *   of its first leg that fires pulses; what it changes in its scanner is left out;
 * - else the first <scene>, scanned with DefaultPlatform and DefaultScanner;
 * - a file that ends in .obj, .tif or .tiff is a scene by itself.
 * Where several parts of the scene are swapped, the first play counts; turbid voxels
 * are not in the output: with KeepGrids, GetGrid() has them.
 *
 * The platform must stand, and the scanner must turn. Platform and Scanner win over
 * those of the file. The scanner turns by a whole circle, unless a <scannerSettings>
 * says otherwise, and as finely as Resolution asks for and it can.
 *
 * Errors name file:line, the value and the cure, as those of vtkHeliosSurveyReader,
 * which says where files are looked for; all are reported, not only the first.
 *
 * @sa
 * vtkHeliosSurveyWriter vtkHeliosSurveyReader vtkHeliosScanPositionPlanner
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
}

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosPlannerReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPlannerReader* New();
  vtkTypeMacro(vtkHeliosPlannerReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Add a folder that files are looked for in, after those added before; remove
   * all. Default: none.
   */
  void AddAssetDirectory(const char* directory);
  void RemoveAllAssetDirectories();
  ///@}

  ///@{
  /**
   * Set/Get the platform and the scanner that win over those of the file,
   * file.xml#id. Default: none.
   */
  vtkSetStringMacro(Platform);
  vtkGetStringMacro(Platform);
  vtkSetStringMacro(Scanner);
  vtkGetStringMacro(Scanner);
  ///@}

  ///@{
  /**
   * Set/Get the platform and the scanner of a scene that is given as such, or as a
   * mesh, file.xml#id. Default: none.
   */
  vtkSetStringMacro(DefaultPlatform);
  vtkGetStringMacro(DefaultPlatform);
  vtkSetStringMacro(DefaultScanner);
  vtkGetStringMacro(DefaultScanner);
  ///@}

  ///@{
  /**
   * Set/Get whether limits of range and elevation that the file does not give are
   * those of the scanner, whatever the file says. Default: off, as the file says.
   */
  vtkSetMacro(UseScannerLimits, bool);
  vtkGetMacro(UseScannerLimits, bool);
  vtkBooleanMacro(UseScannerLimits, bool);
  ///@}

  ///@{
  /**
   * Set/Get the angle between pulses of a line and between lines [deg], which wins
   * over what the file says. Valid range: [0, 90]. Default: 0, as the file says,
   * else 0.1; as near as the scanner can.
   */
  vtkSetClampMacro(Resolution, double, 0.0, 90.0);
  vtkGetMacro(Resolution, double);
  ///@}

  ///@{
  /**
   * Set/Get the pulses a second [Hz], which win over what the file says. Valid
   * range: [0, 1e9]. Default: 0, as the file says, else the first that the scanner
   * offers.
   */
  vtkSetClampMacro(PulseFrequency, double, 0.0, 1e9);
  vtkGetMacro(PulseFrequency, double);
  ///@}

  /**
   * Reads the file with all that it refers to, but no geometry. Returns false after
   * an error.
   */
  bool Read();

  ///@{
  /**
   * What was read: "planner", "survey" or "scene"; a name that is fit for a folder;
   * where the scene, the platform and the scanner come from, file.xml#id. The scene's
   * is empty where the file is a mesh.
   */
  std::string GetKind() const;
  std::string GetPlanName() const;
  std::string GetSceneReference() const;
  std::string GetPlatformReference() const;
  std::string GetScannerReference() const;
  ///@}

  ///@{
  /**
   * How positions are chosen: the method (reduce, bestcoverage, greedy, best,
   * optimal; empty where no <surveyPlanner> was read), for reduce viewshedSize or
   * meanIncidenceAngle, and whether the largest go first; the coverage that is
   * wanted [%], of coverable or of all points; whether these count by their areas;
   * the overlap of scans [0..1]; how long a search may take [s].
   */
  std::string GetMethod() const;
  std::string GetRemoveOrder() const;
  bool GetRemoveLargestFirst() const;
  double GetMinimumCoverage() const;
  bool GetCoverageOfAll() const;
  bool GetUseAreas() const;
  double GetMinimumOverlap() const;
  double GetTimeLimit() const;
  ///@}

  ///@{
  /**
   * Where candidates and test points are: their distances along x and y [m], 0 where
   * they are not given; the lines that test points are on: all, vertical or
   * horizontal; the largest slope [deg]; whether enclosed places count; auto, true, false or open, of the
   * ground; how high the instrument is above the place [m].
   */
  double GetXStep() const;
  double GetYStep() const;
  double GetTestPointStep() const;
  std::string GetTestLines() const;
  double GetMaximumSlope() const;
  bool GetEnclosed() const;
  std::string GetGroundOnly() const;
  double GetScannerHeight() const;
  ///@}

  ///@{
  /**
   * What is seen: the hit tolerance [m], whether a ray that ends farther behind sees,
   * whether limits that are not given are those of the scanner, ranges [m], elevations
   * above the horizontal [deg], the largest incidence angle [deg], the points a square
   * metre that one position must give [1/m2].
   */
  double GetHitTolerance() const;
  bool GetHitBehind() const;
  bool GetScannerLimits() const;
  double GetRangeMin() const;
  double GetRangeMax() const;
  double GetElevationMin() const;
  double GetElevationMax() const;
  double GetMaximumIncidenceAngle() const;
  double GetMinimumPointDensity() const;
  ///@}

  ///@{
  /**
   * How a position is scanned: pulses and lines a second [Hz], half the angle that
   * the mirror sweeps, the window of a rotating one, and the head's angles [deg] and
   * speed [deg/s].
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
   * Whether the scanner has a rotating mirror, whose window counts; the larger of the
   * angles between its pulses along and across a line [deg], 0 where they are not
   * regular; from where the platform stands to where the beam leaves [m].
   */
  bool HasRotatingMirror() const;
  double GetLegAngularStep() const;
  void GetInstrument(double position[3]) const;
  ///@}

  ///@{
  /**
   * Set/Get whether the grids of turbid voxels beside the scene are kept. Default:
   * off.
   */
  vtkSetMacro(KeepGrids, bool);
  vtkGetMacro(KeepGrids, bool);
  vtkBooleanMacro(KeepGrids, bool);
  ///@}

  /**
   * These, from 0, after Update(), as vtkHeliosSurveySource has them. Null for a
   * number behind the last one.
   */
  vtkImageData* GetGrid(int grid) const;

protected:
  vtkHeliosPlannerReader();
  ~vtkHeliosPlannerReader() override;

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
  double Resolution = 0.0;
  double PulseFrequency = 0.0;
  bool KeepGrids = false;

  const helios::PlannerData& GetData() const;
};

#endif
