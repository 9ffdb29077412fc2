// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parses the lines of a Wavefront OBJ file.

#ifndef heliosObjParser_h
#define heliosObjParser_h

#include "heliosObjFaces.h"
#include "heliosSceneMesh.h"
#include "heliosTextFile.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <vtkType.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace helios
{

/**
 * Reads v, vn, vt, f, mtllib and usemtl; recognizes and ignores o, g, s, l, p and similar. Faces
 * may be concave. Every line is checked, and every index against the whole file: an unknown vertex
 * is an error; one warning names unknown texture coordinates and normals, which are not used.
 */
class VTKHELIOSFILTERSIO_EXPORT ObjParser
{
public:
  struct Statement
  {
    std::string Text;
    std::int64_t Line = 0; ///< 0: no line
  };

  explicit ObjParser(TextReport& report);

  /// Maximum number of corners (and vertices) of 32-bit cells.
  std::int64_t MaximumNumberOfCorners = MaximumCorners;

  /// Sets whether texture coordinates are read: u v of every corner, NaN without. Default: false.
  void SetReadsTextures(bool reads) { this->ReadsTextures = reads; }

  /// Returns false after an error, which is in the report, and if OnBlock stopped reading.
  bool Read(const std::string& path);

  TextFile File;
  SceneMesh Mesh;                   ///< with the index into Uses in place of MaterialIds
  std::vector<Statement> Uses;      ///< usemtl: unique names
  std::vector<Statement> Libraries; ///< mtllib: unique lines

private:
  /// An element type that faces refer to by index.
  struct Element
  {
    const char* Name;
    std::int64_t Count = 0;
    int Largest = 0; ///< largest index beyond the elements read at that point
    std::int64_t LargestLine = 0;
    int Absent = 0; ///< first index below 1; its line is 0 if there is none
    std::int64_t AbsentLine = 0;
  };

  bool ReadLine(std::string_view line);
  bool ReadStatement(std::string_view keyword, TextWords& words);
  bool ReadVertex(TextWords& words);
  bool ReadNumbers(std::string_view keyword, TextWords& words, int minimum);
  bool ReadFace(TextWords& words);
  bool ReadCorner(TextWords& words);
  bool Resolve(Element& element, int& index);
  bool ReadTexturePoint(TextWords& words);
  bool AddFace();
  void PlaceTextures();
  int AddUse(std::string_view name, std::int64_t line);
  void AddLibrary(std::string_view names);
  void Use(std::string_view name);
  void CountUnknown(std::string_view keyword);
  bool CheckIndices();
  void WarnOfAbsent();
  bool Fail(const std::string& message);
  bool FailNumber(std::string_view keyword, TextWords::Number status, TextWords& words);

  TextReport& Report;
  Element Elements[3] = { { "vertex" }, { "texture coordinate" }, { "normal" } };
  ObjFaces Faces{ this->Mesh };
  ObjFaces::Face Face;
  bool ReadsTextures = false;
  std::vector<std::array<float, 2>> TexturePoints; // vt
  std::unordered_map<std::string, int> UseRows;
  int CurrentUse = -1;
  std::int64_t UnknownCount = 0;
  std::string FirstUnknown;
};

} // namespace helios

#endif
