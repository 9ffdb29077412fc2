// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosObjTestFiles.h"
#include "heliosTempFolder.h"
#include "vtkHeliosObjSceneWriter.h"

#include <vtkDoubleArray.h>
#include <vtkPoints.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <random>
#include <sstream>

using helios::MaterialTable;
using helios::ObjReading;
using helios::TestFolder;

namespace
{

struct ObjWriting
{
  vtkNew<vtkHeliosObjSceneWriter> Writer;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  ObjWriting(vtkPolyData* scene, const std::string& path)
  {
    this->Log->Watch(this->Writer);
    this->Writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Quiet);
    this->Writer->SetInputData(scene);
    this->Writer->SetFileName(path.c_str());
  }

private:
  vtkSmartPointer<helios::ErrorObserver> Quiet =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
};

// Random triangles with separate points and random materials.
vtkSmartPointer<vtkPolyData> MakeScene(vtkIdType triangleCount, const MaterialTable& materials)
{
  std::mt19937_64 random(99);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosArrayNames::MaterialIds);
  for (vtkIdType i = 0; i < triangleCount; ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const auto coordinate = [&random]
      { return std::ldexp(static_cast<double>(random() >> 11), -32) - 9e5; };
      points->InsertNextPoint(coordinate(), coordinate(), coordinate());
    }
    triangles->InsertNextCell({ 3 * i + 2, 3 * i, 3 * i + 1 });
    ids->InsertNextValue(static_cast<int>(random() % materials.size()));
  }
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->SetPoints(points);
  scene->SetPolys(triangles);
  scene->GetCellData()->AddArray(ids);
  helios::SetMaterials(scene, materials);
  return scene;
}

MaterialTable MakeMaterials()
{
  MaterialTable materials(200);
  std::mt19937_64 random(7);
  for (std::size_t i = 0; i < materials.size(); ++i)
  {
    const auto fraction = [&random]
    { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    helios::Material& m = materials[i];
    m.Name = "#m" + std::to_string(i);
    m.Reflectance = i % 3 ? fraction() : std::nan("");
    m.Specularity = i % 5 ? fraction() : static_cast<double>(i % 2);
    m.SpecularExponent = 1000.0 * fraction();
    m.Classification = static_cast<int>(i) - 50;
    m.IsGround = i % 2 == 0;
    m.Spectrum = i % 4 ? "" : "grass";
  }
  materials[3].Specularity = 1e-300;
  materials[4].Specularity = std::nextafter(1.0, 0.0);
  return materials;
}

} // namespace

TEST_CASE("ObjSceneWriter: files are read back bit for bit", "[ObjSceneWriter]")
{
  TestFolder folder;
  const MaterialTable materials = MakeMaterials();
  const vtkSmartPointer<vtkPolyData> scene = MakeScene(20000, materials);
  scene->GetPoints()->SetPoint(0, -0.0, 5500000.654321, 4.9e-324);

  ObjWriting writing(scene, folder.GetPath("my scene.obj"));
  REQUIRE(writing.Writer->Write() == 1);
  CHECK(writing.Log->Errors + writing.Log->Warnings == "");
  CHECK_FALSE(std::filesystem::exists(folder.GetPath("my scene.obj.part")));

  ObjReading reading(folder.GetPath("my scene.obj"));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  CHECK((helios::GetMaterials(reading.Scene()) == materials));

  REQUIRE(reading.Scene()->GetNumberOfPoints() == scene->GetNumberOfPoints());
  const auto bytes = sizeof(double) * 3 * static_cast<std::size_t>(scene->GetNumberOfPoints());
  CHECK(std::memcmp(reading.Scene()->GetPoints()->GetVoidPointer(0),
          scene->GetPoints()->GetVoidPointer(0), bytes) == 0);

  REQUIRE(reading.TriangleCount() == scene->GetNumberOfPolys());
  for (vtkIdType i = 0; i < scene->GetNumberOfPolys(); ++i)
  {
    REQUIRE(reading.Corners(i) == std::vector<vtkIdType>{ 3 * i + 2, 3 * i, 3 * i + 1 });
    REQUIRE(reading.Scene()->GetCellData()->GetScalars() == nullptr);
    REQUIRE(reading.Scene()
              ->GetCellData()
              ->GetArray(vtkHeliosArrayNames::MaterialIds)
              ->GetComponent(i, 0) ==
      scene->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds)->GetComponent(i, 0));
  }
}

TEST_CASE(
  "ObjSceneWriter: a scene without material arrays has the default material", "[ObjSceneWriter]")
{
  TestFolder folder;
  const auto scene = MakeScene(2, MaterialTable(1));
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(scene->GetPoints());
  bare->SetPolys(scene->GetPolys());
  ObjWriting writing(bare, folder.GetPath("a.obj"));
  REQUIRE(writing.Writer->Write() == 1);
  REQUIRE(writing.Writer->Write() == 1); // again, overwriting the first
  ObjReading reading(folder.GetPath("a.obj"));
  REQUIRE(reading.Read());
  CHECK((helios::GetMaterials(reading.Scene()) == MaterialTable(1)));
}

TEST_CASE("ObjSceneWriter: names are written as single words", "[ObjSceneWriter]")
{
  TestFolder folder;
  MaterialTable materials(4);
  materials[0].Name = "dry grass";
  materials[1].Name = "dry_grass";
  materials[2].Name = "";
  materials[3].Name = "wall";
  ObjWriting writing(MakeScene(5, materials), folder.GetPath("a.obj"));
  REQUIRE(writing.Writer->Write() == 1);
  CHECK(writing.Log->HasWarning(
    folder.GetPath("a.obj") + ": 3 materials were renamed: \"dry grass\" became \"dry_grass\""));
  ObjReading reading(folder.GetPath("a.obj"));
  REQUIRE(reading.Read());
  const MaterialTable read = helios::GetMaterials(reading.Scene());
  REQUIRE(read.size() == 4);
  CHECK(read[0].Name == "dry_grass");
  CHECK(read[1].Name == "dry_grass_2");
  CHECK(read[2].Name == "material");
  CHECK(read[3].Name == "wall");
}

TEST_CASE("ObjSceneWriter: errors name what cannot be written", "[ObjSceneWriter]")
{
  TestFolder folder;
  const std::string path = folder.GetPath("a.obj");
  const auto check = [&path](
                       vtkPolyData* scene, const std::string& name, const std::string& message)
  {
    ObjWriting writing(scene, name);
    CHECK(writing.Writer->Write() == 0);
    INFO("expected: " << message << "\nsaid: " << writing.Log->Errors);
    CHECK(writing.Log->HasError(message));
    CHECK_FALSE(std::filesystem::exists(path));
    CHECK_FALSE(std::filesystem::exists(path + ".part"));
  };
  const auto checkMaterial = [&check, &path](helios::Material material, const std::string& message)
  {
    material.Name = "m";
    check(
      MakeScene(2, { material }), path, path + ": not written: material \"m\" has the " + message);
  };

  const auto scene = MakeScene(2, MaterialTable(1));
  const std::string below = folder.Write("plain.txt", "") + "/a.obj";
  check(scene, below,
    folder.GetPath("plain.txt") +
      "/a.mtl: cannot be written: Not a directory; choose another folder, or make this one "
      "writable with space left");
  check(scene, "", "FileName is not set; give the OBJ file with SetFileName");
  check(scene, folder.GetPath("a.mtl"), "a.mtl: not written: .mtl is for the materials; use .obj");
  check(vtkNew<vtkPolyData>(), path, path + ": not written: the scene is empty");

  vtkNew<vtkPolyData> wrong;
  wrong->DeepCopy(scene);
  wrong->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds)->SetComponent(1, 0, 3);
  check(wrong, path,
    "cell 1 of the scene has MaterialIds 3, but there are 1 materials; correct the array or add "
    "the material");

  helios::Material m;
  m.Reflectance = 50;
  checkMaterial(m, "reflectance 50, outside [0, 1]; correct it");
  m = {};
  m.Specularity = -0.5;
  checkMaterial(m, "specularity -0.5, outside [0, 1]; correct it");
  m = {};
  m.SpecularExponent = std::nan("");
  checkMaterial(m, "specular exponent nan, not a finite number >= 0; correct it");
  m = {};
  m.Spectrum = "dry grass";
  checkMaterial(m, "spectrum \"dry grass\", which has a blank that MTL cannot store; correct it");

  vtkNew<vtkHeliosObjSceneWriter> writer;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(writer);
  writer->SetFileName(path.c_str());
  CHECK(writer->Write() == 0);
  CHECK(log->HasError("no scene to write; give it with SetInputData or SetInputConnection"));
}

#ifdef __linux__
TEST_CASE(
  "ObjSceneWriter: a full disk is reported, and the previous file is kept", "[ObjSceneWriter]")
{
  const helios::TempFolder folder;
  const helios::SmallDisk disk(folder / "disk", 64);
  if (!disk.IsMounted())
  {
    WARN("no disk can be mounted here");
    return;
  }
  const std::string path = folder / "disk/a.obj";
  std::ofstream(path) << "the old one";
  ObjWriting writing(MakeScene(50000, MaterialTable(1)), path);
  CHECK(writing.Writer->Write() == 0);
  CHECK(writing.Log->HasError(
    path + ": cannot be written: No space left on device; choose another folder"));
  CHECK_FALSE(std::filesystem::exists(path + ".part"));
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  CHECK(text.str() == "the old one");
}
#endif

TEST_CASE("ObjSceneWriter: prints its file name", "[ObjSceneWriter]")
{
  vtkNew<vtkHeliosObjSceneWriter> writer;
  writer->SetFileName("a.obj");
  std::ostringstream text;
  writer->Print(text);
  CHECK(text.str().find("FileName: a.obj") != std::string::npos);
}
