// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosDialect
 * @brief   the HELIOS XML dialect as vtkHelios reads it, in XML and YAML
 *
 * Lists elements, attributes and filter parameters with their kind, unit, range, default and use.
 * The list is generated from the table that vtkHeliosSurveyReader reads files with: as an XML
 * schema for editors and validators, and as Markdown (Data/Schemas, Docs/dialect.md).
 *
 * @sa
 * vtkHeliosSurveyReader
 */

#ifndef vtkHeliosDialect_h
#define vtkHeliosDialect_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For return values

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosDialect : public vtkObject
{
public:
  static vtkHeliosDialect* New();
  vtkTypeMacro(vtkHeliosDialect, vtkObject);

  /**
   * Returns an XML schema (XSD 1.0) for all files: surveys, scenes, scanners and platforms. It is
   * as strict as the reader, and rejects unknown names, for which the reader only warns. References
   * are not followed, and filter parameters, whose kind depends on their key, are not checked.
   */
  static std::string GetSchema();

  /**
   * Returns all elements and their attributes as Markdown: one heading and table per element.
   */
  static std::string GetTables();

  /**
   * Returns the names without a description; empty if every name has one.
   */
  static std::string FindUndescribed();

  /**
   * Returns the loader of a mesh by the extension of its file, as in objloader for a.obj; empty if it
   * is none. Returns all these extensions: ".obj, .tif, ...".
   */
  static std::string FindLoader(const std::string& fileName);
  static std::string GetMeshEndings();

  ///@{
  /**
   * Returns the extensions of documents: ".xml, .yaml, .yml"; whether a file has one of them.
   */
  static std::string GetDocumentEndings();
  static bool IsDocument(const std::string& fileName);
  ///@}

  ///@{
  /**
   * Read a document, XML or YAML, and return it as XML; empty after an error. Write XML to a file, as
   * YAML by its extension. Convert one file into another: in another folder, names of files are changed
   * so that they are found from there. Write and Convert return false after an error.
   */
  std::string ReadXml(const std::string& fileName);
  bool WriteXml(const std::string& fileName, const std::string& xml);
  bool Convert(const std::string& from, const std::string& to);
  ///@}

  /**
   * Returns whether a document has a <survey>, or cannot be read: then its reader reports why.
   */
  static bool MayHaveSurvey(const std::string& fileName);

  /**
   * Returns whether a file is a mesh by its extension; a .ply is one if its header has faces, and else
   * a cloud.
   */
  static bool IsMesh(const std::string& fileName);

protected:
  vtkHeliosDialect() = default;
  ~vtkHeliosDialect() override = default;

private:
  vtkHeliosDialect(const vtkHeliosDialect&) = delete;
  void operator=(const vtkHeliosDialect&) = delete;
};

#endif
