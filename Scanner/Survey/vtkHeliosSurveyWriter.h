// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveyWriter
 * @brief   scan positions as a survey in HELIOS XML
 *
 * Input 0 is a vtkPolyData: a point a position, where the instrument is to be, in
 * the order of the legs. Write() makes a survey of a platform that stands: one leg
 * a position, with an explicit z that is not put onto the ground, and the scanner
 * settings below, once, as a template.
 *
 * The beam of every leg leaves where its position is: what the platform's mount and
 * the beam's origin in the head add is taken off, so that the z of a leg is that
 * of the platform's foot. (A beam that leaves beside the head's axis goes round the
 * position.) Numbers have the fewest digits that read back exactly.
 *
 * References are written as they are given, and are read as those of surveys are:
 * from the asset directories, the folder of FileName and the working directory. A
 * Scene that ends in .obj, .tif or .tiff is a mesh, and becomes a scene in the file.
 * Where the positions have a CRS in their field data that is not the crs of the
 * scene, legs carry it by a template.
 *
 * What is written has been read with vtkHeliosSurveyReader's code before: a survey
 * that would not be read is an error, and no file is made. The file has the name
 * .part until it is whole.
 *
 * @sa
 * vtkHeliosScanPositionPlanner vtkHeliosPlannerReader vtkHeliosSurveyReader
 */

#ifndef vtkHeliosSurveyWriter_h
#define vtkHeliosSurveyWriter_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <limits> // For what is not given
#include <string> // For the asset directories
#include <vector> // For the asset directories

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurveyWriter : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSurveyWriter* New();
  vtkTypeMacro(vtkHeliosSurveyWriter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to write, which replaces one of that name. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get the name of the survey, which names the folder of its output. Default:
   * none, that of the file.
   */
  vtkSetStringMacro(SurveyName);
  vtkGetStringMacro(SurveyName);
  ///@}

  ///@{
  /**
   * Set/Get what is scanned: file.xml#id, or a mesh. Default: none.
   */
  vtkSetStringMacro(Scene);
  vtkGetStringMacro(Scene);
  ///@}

  ///@{
  /**
   * Set/Get what carries the scanner, and the scanner: file.xml#id. The platform
   * must stand. Default: none.
   */
  vtkSetStringMacro(Platform);
  vtkGetStringMacro(Platform);
  vtkSetStringMacro(Scanner);
  vtkGetStringMacro(Scanner);
  ///@}

  ///@{
  /**
   * Add a folder that references are looked for in, after those added before;
   * remove all. Default: none.
   */
  void AddAssetDirectory(const char* directory);
  void RemoveAllAssetDirectories();
  ///@}

  ///@{
  /**
   * Set/Get the pulses a second and the lines, or revolutions, a second [Hz]. Valid
   * range: above 0, as the scanner can. Default: NaN, which is left to the scanner.
   */
  vtkSetMacro(PulseFrequency, double);
  vtkGetMacro(PulseFrequency, double);
  vtkSetMacro(ScanFrequency, double);
  vtkGetMacro(ScanFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get half the angle that is swept, and of a rotating mirror the window that
   * pulses leave through [deg]. Valid range: as the scanner can. Default: NaN, which
   * is left to the scanner.
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
   * Set/Get from where to where the head turns [deg], and how fast [deg/s]. Valid
   * range: [-1e6, 1e6]. Default: 0 to 360, with 10.
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
  bool IsWritten = false;
};

#endif
