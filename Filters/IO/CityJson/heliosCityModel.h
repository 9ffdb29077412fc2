// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A city model in a CityJSON file.

#ifndef heliosCityModel_h
#define heliosCityModel_h

#include "heliosCityGeometry.h"
#include "heliosCityTemplates.h"
#include "heliosJsonFile.h"
#include "heliosSceneMesh.h"
#include "heliosStatus.h"
#include "heliosTextFile.h"

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/**
 * Adds the surfaces of a file, at one level of detail, to an empty mesh, each object as a part. Text
 * sequences (.jsonl: CityJSONSeq) have the metadata in their first line, and a feature in each other.
 */
class CityModel
{
public:
  CityModel(SceneMesh& mesh, TextReport& report);

  /// Level of detail as the file writes it, such as "2.2"; empty: the highest of each object.
  std::string LevelOfDetail;

  /// Runs with the fraction of the objects; false stops reading.
  std::function<bool(double)> OnBlock;

  /// Returns false after an error, which is in the report.
  bool Read(const std::string& path);

  /// Returns the system in the metadata: "EPSG:7415"; empty: none.
  const std::string& GetCrs() const { return this->Crs; }

private:
  Status ReadFile(const std::string& path);
  Status ReadLines(const std::string& path);
  Status ReadLine(const std::string& path, std::string_view text, std::int64_t line);
  Status ReadHeader();
  Status CheckVersion();
  Status ReadTransform();
  Status ReadVertices(const JsonFile& file);
  Status ReadObjects(const JsonFile& file);
  Status AddObject(const std::string& name, const Json::Value& object);
  Status AddGeometry(const Json::Value& geometry);
  std::string FindLevel(const Json::Value& geometry) const;
  std::string FindHighestLevel(const Json::Value& object) const;
  std::string ChooseLevel(const Json::Value& object) const;
  void ReadCrs();
  Status CheckLevels();

  SceneMesh& Mesh;
  TextReport& Report;
  JsonFile File;                        // with the metadata
  bool HasHeader = false;               // the sequence's first line was read
  const Json::Value* Objects = nullptr; // city objects of the current text
  double Scale[3] = { 1.0, 1.0, 1.0 };  // scale of the vertices
  double Translation[3] = { 0.0, 0.0, 0.0 };
  CityGeometry Geometry;
  CityTemplates Templates;
  std::string Crs;
  std::vector<vtkTypeInt32> Ids;    // points of the vertices of the current text
  std::set<std::string> Levels;     // all in the file
  std::int64_t NumberOfObjects = 0; // with surfaces
  std::int64_t NumberOfUsed = 0;    // at the level of detail
};

} // namespace helios

#endif
