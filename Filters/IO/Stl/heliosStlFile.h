// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads stereolithography files (STL), binary and text.

#ifndef heliosStlFile_h
#define heliosStlFile_h

#include "heliosSceneMesh.h"
#include "heliosTextFile.h"

#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_set>

namespace helios
{

/// Adds the triangles of files to a mesh; equal vertices become one.
class StlFile
{
public:
  StlFile(SceneMesh& mesh, TextReport& report);

  /// Runs after every block with the fraction of the file read; false stops reading.
  std::function<bool(double)> OnBlock;

  /// Returns false after an error, which is in the report.
  bool Read(const std::string& path);

private:
  struct PointHash
  {
    SceneMesh* Mesh;
    std::size_t operator()(vtkTypeInt32 id) const;
  };
  struct PointEqual
  {
    SceneMesh* Mesh;
    bool operator()(vtkTypeInt32 a, vtkTypeInt32 b) const;
  };

  bool ReadBinary(std::FILE* file, std::uint32_t count);
  bool AddBinary(const unsigned char* record);
  bool ReadText();
  bool ReadLine(std::string_view line);
  bool ReadVertex(TextWords& words);
  bool ReadEndLoop();
  void EndLoop();
  bool AddVertex(const double* point);
  bool FailHere(const std::string& message);
  bool FailSize(std::int64_t size, std::uint32_t count);

  SceneMesh& Mesh;
  TextReport& Report;
  std::string Path;
  std::unordered_set<vtkTypeInt32, PointHash, PointEqual> Known;
  vtkTypeInt32 Corners[3] = { 0, 0, 0 };
  int NumberOfCorners = 0; // corners of the current triangle so far
  bool IsInSolid = false;
  std::int64_t Triangle = 0; // triangle of a binary file, from 1; 0: text
  TextFile Text;
};

} // namespace helios

#endif
