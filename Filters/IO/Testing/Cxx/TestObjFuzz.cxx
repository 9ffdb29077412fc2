// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged OBJ and MTL files give an error or a sound scene, never anything else.
#include "heliosObjTestFiles.h"
#include "heliosTriangleMesh.h"

#include <catch2/catch.hpp>

#include <random>

using helios::ObjReading;
using helios::TestFolder;

namespace
{

const std::string GoodObj =
  "# a house\nmtllib a.mtl\no house\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\n"
  "v 0 0 2.5 0.1 0.2 0.3\nv 4 0 2.5\nv 4 3 2.5\nv 0 3 2.5\nvt 0 0\nvt 1 0\nvt 1 1\n"
  "vn 0 0 1\nvn 0 -1 0\ns off\nusemtl wall\nf 1//2 2//2 6//2 5//2\n"
  "f 2/1 3/2 7/3\nf -8/-3/-1 -5/-2/-1 -1/-1/-1\nusemtl roof\nf 5 6 7 \\\n 8\nl 1 2\n";
const std::string GoodMtl = "newmtl wall\nNs 96.078\nKd 0.64 0.64 0.64\nKs 0.5 0.5 0.5\nillum 2\n"
                            "helios_reflectance 0.5\nhelios_classification 6\nnewmtl roof\n"
                            "helios_spectra shingle_red\nhelios_isGround false\n";

const std::string Pieces[] = { "nan",
  "-inf",
  "1e999",
  "1e30",
  "0",
  "-1",
  "99999999999999999999",
  "/",
  "//",
  "#",
  "\\\n",
  "\n",
  "\r",
  " ",
  std::string(1, '\0'),
  "\xff\xfe",
  "f 1 2 3\n",
  "f ",
  "v ",
  "v 1 2\n",
  "usemtl ",
  "mtllib .\n",
  "mtllib a.mtl b.mtl\n",
  "newmtl ",
  "helios_reflectance 2\n",
  "\"",
  "%s%n",
  "," };

std::string Mutate(std::string text, std::mt19937& random)
{
  const auto below = [&random](std::size_t end)
  { return random() % std::max<std::size_t>(end, 1); };
  for (std::size_t count = 1 + below(4); count > 0; --count)
  {
    const std::size_t at = below(text.size());
    switch (below(6))
    {
      case 0: // a byte becomes another
        if (!text.empty())
        {
          text[at] = static_cast<char>(random() % 256);
        }
        break;
      case 1: // some bytes vanish
        text.erase(at, 1 + below(12));
        break;
      case 2:
        text.insert(at, Pieces[below(std::size(Pieces))]);
        break;
      case 3: // the end is lost
        text.resize(at);
        break;
      case 4: // a stretch comes twice
        text.insert(at, text.substr(below(text.size()), below(80)));
        break;
      default: // a bit flips
        if (!text.empty())
        {
          text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        }
    }
  }
  return text;
}

} // namespace

TEST_CASE("ObjFuzz: damaged files give an error or a scene", "[ObjFuzz]")
{
  TestFolder folder;
  std::mt19937 random(4711);
  int errorCount = 0;
  int sceneCount = 0;
  for (int i = 0; i < 400; ++i)
  {
    const bool damageObj = i % 4 != 0;
    const std::string obj = damageObj ? Mutate(GoodObj, random) : GoodObj;
    const std::string mtl = damageObj ? GoodMtl : Mutate(GoodMtl, random);
    folder.Write("a.mtl", mtl);
    ObjReading reading(folder.Write("a.obj", obj));
    INFO("file " << i << "\n" << obj << "\n" << mtl);
    if (!reading.Read())
    {
      ++errorCount;
      REQUIRE(reading.TriangleCount() == 0);
      REQUIRE(reading.Log->HasError(": "));
      continue;
    }
    ++sceneCount;
    vtkPolyData* scene = reading.Scene();
    const auto materialCount = static_cast<int>(helios::GetMaterials(scene).size());
    helios::TriangleMesh mesh;
    REQUIRE((scene->GetNumberOfPolys() == 0 || mesh.Set(scene).empty()));
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfTriangles(); ++cell)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        REQUIRE(mesh.GetCorners()[3 * cell + corner] < scene->GetNumberOfPoints());
      }
      const double row =
        scene->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds)->GetComponent(cell, 0);
      REQUIRE((row >= 0 && row < materialCount));
    }
  }
  CHECK(errorCount > 40); // both happen
  CHECK(sceneCount > 40);
}
