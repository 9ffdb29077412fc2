// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveyReader
 * @brief   a survey from HELIOS XML
 *
 * Read() reads the first survey of a file with everything it refers to: the
 * scene (its OBJ files are only looked for), the scanner and the platform,
 * templates of settings. Names of files are looked for in the asset directories
 * (and the folder data of each) in their order, then in the folder of the file
 * that names them, then in the working directory; a reference is file.xml#id,
 * #id or id.
 *
 * The file is read strictly: every error names file:line, the value and the
 * cure, and all errors are reported, not only the first. Attributes and elements
 * that the dialect does not know, or that this version does not model, are
 * warned of once. Docs/dialect.md lists all of them.
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
   * Add a folder that files are looked for in, after those added before; remove
   * all. Default: none.
   */
  void AddAssetDirectory(const char* directory);
  void RemoveAllAssetDirectories();
  ///@}

  /**
   * Reads the file. Returns false after an error; GetSurvey() is then null.
   */
  bool Read();

  /**
   * Checks the whole file and all that it refers to, without a survey to run in
   * the end: surveys as Read() does, and every scene, scanner, platform and
   * template in it, used or not; whether scene files exist, and names of
   * coordinate systems and ray casters are known. Each fault is told on its own,
   * what only follows from another is not. Returns false after an error.
   */
  bool Check();

  /**
   * The survey of the last Read(), or null.
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
  vtkSmartPointer<vtkHeliosSurvey> Survey;
};

#endif
