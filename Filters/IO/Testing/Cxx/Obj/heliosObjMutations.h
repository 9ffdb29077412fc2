// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Valid OBJ and MTL files to damage, and checks of the scenes read from them.

#ifndef heliosObjMutations_h
#define heliosObjMutations_h

#include "heliosMutation.h"
#include "heliosObjTestFiles.h"
#include "heliosTriangleMesh.h"

#include <cmath>
#include <random>
#include <string>

namespace helios
{

inline const std::string GoodObj =
  "# a house\nmtllib a.mtl\no house\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\n"
  "v 0 0 2.5 0.1 0.2 0.3\nv 4 0 2.5\nv 4 3 2.5\nv 0 3 2.5\nvt 0 0\nvt 1 0\nvt 1 1\n"
  "vn 0 0 1\nvn 0 -1 0\ns off\nusemtl wall\nf 1//2 2//2 6//2 5//2\n"
  "f 2/1 3/2 7/3\nf -8/-3/-1 -5/-2/-1 -1/-1/-1\nusemtl roof\nf 5 6 7 \\\n 8\nl 1 2\n";

inline const std::string GoodMtl =
  "newmtl wall\nNs 96.078\nKa 1 1 1\nKd 0.64 0.64 0.64\nKs 0.5 0.5 0.5\nillum 2\n"
  "helios_reflectance 0.5\nhelios_classification 6\nnewmtl roof tiles # red\nKs 0.7\n"
  "helios_spectra shingle_red\nhelios_isGround false\nmap_Kd a b.png\n"
  "newmtl roof\nhelios_reflectance 40\nhelios_isGround 1\n";

/// Damages a file with Mutator; every second time also inserts a keyword at a wrong position.
inline std::string MutateText(std::string text, unsigned seed)
{
  static const char* const phrases[] = { "f 1 2 3\n", "f ", "v ", "v 1 2\n", "1e30", "vn 0 0\n",
    "usemtl ", "usemtl roof\n", "mtllib .\n", "mtllib a.mtl b.mtl\n", "newmtl ", "newmtl wall\n",
    "Kd 1 x\n", "Ks 0.5\n", "helios_reflectance 2\n", "helios_reflectance -1\n", "%s%n" };
  if (seed % 2 == 1)
  {
    std::mt19937 random(seed);
    text.insert(random() % text.size(), phrases[random() % std::size(phrases)]);
  }
  return Mutator(seed)(std::move(text));
}

/// Why a scene is not valid; empty if it is.
inline std::string FindFault(ObjReading& reading)
{
  vtkPolyData* scene = reading.Scene();
  const vtkIdType count = scene->GetNumberOfCells();
  const MaterialTable materials = GetMaterials(scene);
  auto* ids = scene->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds);
  if (!ids || ids->GetNumberOfTuples() != count || scene->GetPoints()->GetDataType() != VTK_DOUBLE)
  {
    return "not a scene";
  }
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const double row = ids->GetComponent(cell, 0);
    if (!(row >= 0.0 && row < static_cast<double>(materials.size())))
    {
      return "MaterialIds are not in the table";
    }
  }
  for (const Material& m : materials)
  {
    const bool isGood = !(m.Reflectance < 0.0 || m.Reflectance > 1.0) && m.Specularity >= 0.0 &&
      m.Specularity <= 1.0 && m.SpecularExponent >= 0.0 && std::isfinite(m.SpecularExponent);
    if (!isGood)
    {
      return "material " + m.Name + " is out of range";
    }
  }
  TriangleMesh mesh;
  return count > 0 ? mesh.Set(scene).Message() : std::string(); // corners are valid and finite
}

/// Reads an OBJ file. Returns why the result is not valid, and whether it is a scene.
inline std::string ReadMutation(const std::string& path, bool& isScene)
{
  ObjReading reading(path);
  isScene = reading.Read();
  if (isScene)
  {
    return FindFault(reading);
  }
  return reading.TriangleCount() > 0 || reading.Scene()->GetNumberOfPoints() > 0
    ? "an error, but output"
    : reading.Log->HasError(": ") ? ""
                                  : "an error without place";
}

} // namespace helios

#endif
