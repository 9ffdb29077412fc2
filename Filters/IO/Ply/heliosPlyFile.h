// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the vertices and faces of polygon files (PLY).

#ifndef heliosPlyFile_h
#define heliosPlyFile_h

#include "heliosPlyHeader.h"
#include "heliosPlySource.h"
#include "heliosSceneMesh.h"
#include "heliosScenePolygons.h"
#include "heliosTextFile.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace helios
{

/// Adds the triangles of a file to an empty mesh, with material 0.
class PlyFile
{
public:
  PlyFile(SceneMesh& mesh, TextReport& report)
    : Mesh(mesh)
    , Report(report)
    , Polygons(mesh)
  {
  }

  /// Runs after every 65,536 rows with the fraction of all; false stops reading.
  std::function<bool(double)> OnBlock;

  /// Returns false after an error, which is in the report.
  bool Read(const std::string& path);

private:
  bool CheckSize();
  bool ReadElement(const PlyElement& element);
  bool ReadVertex(const PlyElement& element);
  bool ReadFace(const PlyElement& element);
  bool SkipRow(const PlyElement& element);
  bool ReadProperty(const PlyProperty& property);
  bool AddVertex(const double* point);
  bool ReadRing();
  bool AddFace();
  bool ReportRow();
  std::string GetPlace() const;
  bool Fail(const std::string& message);
  void WarnOfRest();

  SceneMesh& Mesh;
  TextReport& Report;
  std::string Path;
  PlyHeader Header;
  std::unique_ptr<PlySource> Source;
  std::string Element;        // the current one
  std::int64_t Row = 0;       // row of the element, from 0
  double DoneRows = 0.0;      // rows of all elements so far
  std::vector<double> Values; // values of the last property: one, or a list
  PolygonRings Rings{ {} };
  ScenePolygons Polygons;
};

} // namespace helios

#endif
