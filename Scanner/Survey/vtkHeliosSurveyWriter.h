// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveyWriter
 * @brief   write scan positions or waypoints as a survey in HELIOS XML
 *
 * Input 0 is a vtkPolyData with one point per instrument position, in leg order. Write() makes a
 * survey of a static platform: one leg per position, with an explicit z that is not moved to the
 * ground, and the scanner settings below, once, as a template.
 *
 * The beam origin of every leg is at its position: the offsets of the platform's mount and of the
 * beam origin in the head are subtracted, so that the z of a leg is the foot of the platform. (A
 * beam origin off the head axis rotates about the position.) Coordinates are rounded to 1e-9; other
 * numbers have the fewest digits that read back exactly.
 *
 * Points with the array Speed [m/s] are the waypoints of a moving platform instead: legs without
 * head rotation, at that speed to the next point, and active unless the point array Active is 0.
 * Those with the same number in the point array LegIds are a strip, which writes one file. The
 * vertical offset of mount and beam origin is subtracted, the horizontal one is not.
 *
 * References are written as given, and resolved like references in surveys: in the asset
 * directories, the folder of FileName and the working directory. A Scene that ends in .obj, .tif or
 * .tiff is a mesh, and becomes a scene in the file. If the positions have a CRS in their field data
 * that differs from the crs of the scene, a template adds it to the legs.
 *
 * The output is first read with the code of vtkHeliosSurveyReader: a survey that cannot be read is
 * an error, and no file is made. The file name ends in .part until the file is complete.
 *
 * @sa
 * vtkHeliosScanPositionPlanner vtkHeliosPlannerReader vtkHeliosSurveyReader
 */

#ifndef vtkHeliosSurveyWriter_h
#define vtkHeliosSurveyWriter_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <limits> // For NaN
#include <string> // For the asset directories
#include <vector> // For the asset directories

class vtkHeliosSurvey;

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurveyWriter : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSurveyWriter* New();
  vtkTypeMacro(vtkHeliosSurveyWriter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to write; an existing file is replaced. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get the name of the survey, and so of its output folder. Default: none, the name of the
   * file.
   */
  vtkSetStringMacro(SurveyName);
  vtkGetStringMacro(SurveyName);
  ///@}

  ///@{
  /**
   * Set/Get the scene: file.xml#id, or a mesh. Default: none.
   */
  vtkSetStringMacro(Scene);
  vtkGetStringMacro(Scene);
  ///@}

  ///@{
  /**
   * Set/Get the platform and the scanner: file.xml#id. The platform must be static, the platform of
   * waypoints must move. Default: none.
   */
  vtkSetStringMacro(Platform);
  vtkGetStringMacro(Platform);
  vtkSetStringMacro(Scanner);
  vtkGetStringMacro(Scanner);
  ///@}

  ///@{
  /**
   * Adds an asset directory to search for references, after those added before; remove all.
   * Default: none.
   */
  void AddAssetDirectory(const char* directory);
  void RemoveAllAssetDirectories();
  ///@}

  ///@{
  /**
   * Set/Get the pulse frequency and the scan frequency (lines or revolutions per second) [Hz].
   * Valid range: above 0, within the limits of the scanner. Default: NaN, the scanner's default.
   */
  vtkSetMacro(PulseFrequency, double);
  vtkGetMacro(PulseFrequency, double);
  vtkSetMacro(ScanFrequency, double);
  vtkGetMacro(ScanFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get half the scan angle and, for a rotating mirror, the window in which pulses are emitted
   * [deg]. Valid range: the limits of the scanner. Default: NaN, the scanner's default.
   */
  vtkSetMacro(ScanAngle, double);
  vtkGetMacro(ScanAngle, double);
  vtkSetMacro(VerticalAngleMin, double);
  vtkGetMacro(VerticalAngleMin, double);
  vtkSetMacro(VerticalAngleMax, double);
  vtkGetMacro(VerticalAngleMax, double);
  ///@}

  ///@{
  /**
   * Set/Get start and stop of the head rotation [deg], and its speed [deg/s]. Valid range: [-1e6,
   * 1e6]. Default: 0 to 360, with 10.
   */
  vtkSetClampMacro(HeadRotateStart, double, -1e6, 1e6);
  vtkGetMacro(HeadRotateStart, double);
  vtkSetClampMacro(HeadRotateStop, double, -1e6, 1e6);
  vtkGetMacro(HeadRotateStop, double);
  vtkSetClampMacro(HeadRotatePerSecond, double, -1e6, 1e6);
  vtkGetMacro(HeadRotatePerSecond, double);
  ///@}

  /**
   * Writes the file; updates the input first. Returns false after an error.
   */
  bool Write();

  /**
   * Makes the survey that Write() writes, in place of another one, without a file. Without a Scene it
   * scans the input of its vtkHeliosSurveySource. Returns false after an error.
   */
  bool BuildSurvey(vtkHeliosSurvey* survey);

protected:
  vtkHeliosSurveyWriter();
  ~vtkHeliosSurveyWriter() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosSurveyWriter(const vtkHeliosSurveyWriter&) = delete;
  void operator=(const vtkHeliosSurveyWriter&) = delete;

  class Internals;
  friend class Internals;

  static constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

  char* FileName = nullptr;
  char* SurveyName = nullptr;
  char* Scene = nullptr;
  char* Platform = nullptr;
  char* Scanner = nullptr;
  double PulseFrequency = NotGiven;
  double ScanFrequency = NotGiven;
  double ScanAngle = NotGiven;
  double VerticalAngleMin = NotGiven;
  double VerticalAngleMax = NotGiven;
  double HeadRotateStart = 0.0;
  double HeadRotateStop = 360.0;
  double HeadRotatePerSecond = 10.0;
  std::vector<std::string> AssetDirectories;
  vtkHeliosSurvey* Survey = nullptr; ///< being made; null: a file is written
  bool IsWritten = false;
};

#endif
