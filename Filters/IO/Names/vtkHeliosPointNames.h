// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointNames
 * @brief   the names of parts and materials beside a LAS, LAZ or COPC file
 *
 * Points of LAS have the numbers of their part and material (PartIds, MaterialIds in the Extra
 * Bytes); their names are in a JSON file beside it, a.names.json of a.las, a.laz and a.copc.laz:
 *
 *   { "format": "vtkHelios names of points", "version": 1, "points": 1000,
 *     "parts": ["ground", "house"], "materials": ["grass", "brick"] }
 *
 * "species" and "organs" are the names of SpeciesIds and OrganIds, of scenes with trees.
 *
 * A name is at the place of its number, from 0. "points" is the number of points of the file: names
 * of another number are not read, since the file may have been replaced. vtkHeliosLASWriter writes
 * the file if the field data of its blocks have names (Part.Name, Material.Name), and removes the one
 * of an earlier file if they have none; vtkHeliosLASReader reads it.
 *
 * @sa
 * vtkHeliosLASReader vtkHeliosLASWriter
 */

#ifndef vtkHeliosPointNames_h
#define vtkHeliosPointNames_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For names and messages

class vtkFieldData;

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPointNames : public vtkObject
{
public:
  static vtkHeliosPointNames* New();
  vtkTypeMacro(vtkHeliosPointNames, vtkObject);

  /**
   * Returns the file of the names of a file of points.
   */
  static std::string GetFileName(const std::string& pointFile);

  /**
   * Returns the number of names of parts and materials in field data.
   */
  static vtkIdType CountNames(vtkFieldData* fields);

  /**
   * Adds the names of a file with this number of points to field data; without a file, none. Returns
   * false for a file that is damaged or belongs to another number of points; GetMessage() says why.
   */
  bool Read(const std::string& pointFile, vtkIdType points, vtkFieldData* fields);

  /**
   * Checks that the file of the names of a point file can be written. Returns false if another
   * program's file has its name; GetMessage() says so.
   */
  bool Check(const std::string& pointFile);

  /**
   * Writes the names in field data, after Check(); without names, removes the file of names of an
   * earlier file of points. Returns false after an error, which GetMessage() returns.
   */
  bool Write(const std::string& pointFile, vtkIdType points, vtkFieldData* fields);

  /**
   * Returns the error of the last call of Read(), Check() or Write() that returned false.
   */
  std::string GetMessage() const;

protected:
  vtkHeliosPointNames() = default;
  ~vtkHeliosPointNames() override = default;

private:
  vtkHeliosPointNames(const vtkHeliosPointNames&) = delete;
  void operator=(const vtkHeliosPointNames&) = delete;

  std::string Message;
};

#endif
