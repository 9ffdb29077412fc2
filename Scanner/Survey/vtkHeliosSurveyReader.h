// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveyReader
 * @brief   read a survey from HELIOS XML
 *
 * Read() reads the first survey of a file with all its references: the scene (its OBJ files are
 * only located), the scanner and the platform, templates of settings. Files are searched in the
 * asset directories (and the folder data of each) in order, then in the folder of the referring
 * file, then in the working directory; a reference is file.xml#id, #id or id.
 *
 * The file is read strictly: every error gives file:line, the value and the fix, and all errors are
 * reported, not only the first. Attributes and elements that are unknown to the dialect, or not
 * modelled by this version, cause one warning each. Docs/dialect.md lists all of them.
 *
 * @sa
 * vtkHeliosSurvey vtkHeliosSurveyPlayer
 */

#ifndef vtkHeliosSurveyReader_h
#define vtkHeliosSurveyReader_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For the survey

#include <string> // For the asset directories
#include <vector> // For the asset directories

class vtkHeliosSurvey;

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurveyReader : public vtkObject
{
public:
  static vtkHeliosSurveyReader* New();
  vtkTypeMacro(vtkHeliosSurveyReader, vtkObject);
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
   * Adds an asset directory to search, after those added before; remove all. Default: none.
   */
  void AddAssetDirectory(const char* directory);
  void RemoveAllAssetDirectories();
  ///@}

  ///@{
  /**
   * Set/Get whether the scene of the survey, and the trajectory files of its legs, are required. If
   * not, Read() does not read that scene, and trajectory files may be missing: inputs of a
   * vtkHeliosSurveySource replace them. Default: true.
   */
  vtkSetMacro(SceneRequired, bool);
  vtkGetMacro(SceneRequired, bool);
  vtkBooleanMacro(SceneRequired, bool);
  vtkSetMacro(TrajectoriesRequired, bool);
  vtkGetMacro(TrajectoriesRequired, bool);
  vtkBooleanMacro(TrajectoriesRequired, bool);
  ///@}

  /**
   * Reads the file. Returns false after an error; GetSurvey() is then null.
   */
  bool Read();

  /**
   * Checks the whole file with all its references, without making a survey: surveys as Read() does,
   * and every scene, scanner, platform and template in it, used or not; whether scene files exist,
   * and whether names of coordinate systems and ray casters are known. Each error is reported once,
   * without consequential errors. Returns false after an error.
   */
  bool Check();

  /**
   * Returns the survey of the last Read(), or null.
   */
  vtkHeliosSurvey* GetSurvey() const;

protected:
  vtkHeliosSurveyReader();
  ~vtkHeliosSurveyReader() override;

private:
  template <typename TaskT>
  bool Try(TaskT task);

  vtkHeliosSurveyReader(const vtkHeliosSurveyReader&) = delete;
  void operator=(const vtkHeliosSurveyReader&) = delete;

  char* FileName = nullptr;
  std::vector<std::string> AssetDirectories;
  bool SceneRequired = true;
  bool TrajectoriesRequired = true;
  vtkSmartPointer<vtkHeliosSurvey> Survey;
};

#endif
