// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Materials of a parsed OBJ file, and the lines of its vertices.

#ifndef heliosObjScene_h
#define heliosObjScene_h

#include "heliosCutouts.h"
#include "heliosObjParser.h"

#include <vtkType.h>

#include <string>
#include <vector>

namespace helios
{

/// Resolves what an OBJ file refers to by name, after parsing.
class ObjScene
{
public:
  ObjScene(ObjParser& parser, TextReport& report);

  /// Reads the material libraries, with colours or not, and resolves the materials used. False
  /// after an error.
  bool ReadMaterials(bool withColors);

  /// Returns whether images cut triangles: ApplyCutouts() needs texture coordinates then.
  bool HasCutouts() { return helios::HasCutouts(this->Parser.Mesh, this->Cutouts); }

  /// Replaces the triangles that images cut. False after an error.
  bool ApplyCutouts()
  {
    return helios::ApplyCutouts(this->Parser.Mesh, this->Cutouts, this->Report);
  }

  /// Returns "path:line: " of a vertex.
  std::string FindVertexPlace(vtkIdType vertex) const;

private:
  bool ReadLibrary(const ObjParser::Statement& library, class MtlFile& reader);

  ObjParser& Parser;
  TextReport& Report;
  std::vector<Cutout> Cutouts;
};

} // namespace helios

#endif
