// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosDialect
 * @brief   the HELIOS XML dialect as vtkHelios reads it
 *
 * Elements, attributes and parameters of filters with their kinds, units,
 * ranges, defaults and what becomes of them, made from the table that
 * vtkHeliosSurveyReader reads files by: as an XML schema for editors and
 * validators, and as Markdown for people (Data/Schemas, Docs/dialect.md).
 *
 * @sa
 * vtkHeliosSurveyReader
 */

#ifndef vtkHeliosDialect_h
#define vtkHeliosDialect_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For what it returns

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosDialect : public vtkObject
{
public:
  static vtkHeliosDialect* New();
  vtkTypeMacro(vtkHeliosDialect, vtkObject);

  /**
   * An XML schema (XSD 1.0) of every file: surveys, scenes, scanners and
   * platforms. It is as strict as the reader, and refuses unknown names, which
   * the reader warns of. It does not look into references, nor into the
   * parameters of filters, whose kind depends on their key.
   */
  static std::string GetSchema();

  /**
   * Every element with its attributes as Markdown: a heading and a table an
   * element.
   */
  static std::string GetTables();

  /**
   * The names that have no description; empty where every name has one.
   */
  static std::string FindUndescribed();

protected:
  vtkHeliosDialect() = default;
  ~vtkHeliosDialect() override = default;

private:
  vtkHeliosDialect(const vtkHeliosDialect&) = delete;
  void operator=(const vtkHeliosDialect&) = delete;
};

#endif
