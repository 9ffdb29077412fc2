// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveyFileSource
 * @brief   runs the survey of a HELIOS XML file
 *
 * A vtkHeliosSurveySource with the survey of FileName, for ParaView, whose properties are texts and
 * numbers. The file is read again when its name or the asset directories change, and by Reload().
 * vtkHeliosSurveyReader lists the errors of the file. Points have a vertex each, which ParaView
 * draws.
 *
 * @sa
 * vtkHeliosSurveySource vtkHeliosSurveyReader
 */

#ifndef vtkHeliosSurveyFileSource_h
#define vtkHeliosSurveyFileSource_h

#include "vtkHeliosParaViewSurveyModule.h" // For export macro
#include "vtkHeliosSurveySource.h"

#include <string> // For the asset directories
#include <vector> // For the asset directories

class VTKHELIOSPARAVIEWSURVEY_EXPORT vtkHeliosSurveyFileSource : public vtkHeliosSurveySource
{
public:
  static vtkHeliosSurveyFileSource* New();
  vtkTypeMacro(vtkHeliosSurveyFileSource, vtkHeliosSurveySource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the survey, a HELIOS XML file. Required; default: none.
   */
  void SetFileName(const char* name);
  const char* GetFileName() const;
  ///@}

  ///@{
  /**
   * Adds a folder to search for scenes, scanners and platforms, before the folder of the survey,
   * the working directory and the data of vtkHelios; remove all. Default: none.
   */
  void AddAssetDirectory(const char* directory);
  void RemoveAllAssetDirectories();
  ///@}

  /**
   * Reads the file again, at the next update.
   */
  void Reload();

protected:
  vtkHeliosSurveyFileSource();
  ~vtkHeliosSurveyFileSource() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosSurveyFileSource(const vtkHeliosSurveyFileSource&) = delete;
  void operator=(const vtkHeliosSurveyFileSource&) = delete;

  bool Read();

  std::string FileName;
  std::vector<std::string> AssetDirectories;
  std::vector<std::string> LastRead; // names; empty: not read
};

#endif
