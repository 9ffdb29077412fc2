// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Materials of a parsed OBJ file, and the lines of its vertices.

#ifndef heliosObjScene_h
#define heliosObjScene_h

#include "heliosObjParser.h"

#include <vtkType.h>

#include <string>

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

  /// Returns "path:line: " of a vertex.
  std::string FindVertexPlace(vtkIdType vertex) const;

private:
  bool ReadLibrary(const ObjParser::Statement& library, class MtlFile& reader);

  ObjParser& Parser;
  TextReport& Report;
};

} // namespace helios

#endif
