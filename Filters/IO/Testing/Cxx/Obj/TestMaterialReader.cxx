// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosMaterialTable.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosMaterialReader.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace fs = std::filesystem;
namespace names = vtkHeliosArrayNames;

namespace
{

/// A reader of an MTL file with a given text, applied to a scene of two triangles.
class Reading
{
public:
  explicit Reading(const std::string& text)
  {
    std::string name = (fs::temp_directory_path() / "vtkHeliosMaterialXXXXXX").string();
    this->Folder = ::mkdtemp(name.data());
    std::ofstream(this->Folder / "m.mtl") << text;
    this->Log->Watch(this->Reader);
    this->Reader->SetInputData(MakeScene());
    this->Reader->SetFileName((this->Folder / "m.mtl").c_str());
  }
  ~Reading() { fs::remove_all(this->Folder); }

  helios::MaterialTable Update()
  {
    this->Reader->Update();
    return helios::GetMaterials(this->Reader->GetOutput());
  }

  vtkNew<vtkHeliosMaterialReader> Reader;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

private:
  static vtkSmartPointer<vtkPolyData> MakeScene()
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> triangles;
    triangles->InsertNextCell({ 0, 1, 2 });
    triangles->InsertNextCell({ 0, 2, 3 });
    for (const auto& p : { std::pair(0, 0), { 1, 0 }, { 1, 1 }, { 0, 1 } })
    {
      points->InsertNextPoint(p.first, p.second, 0);
    }
    auto scene = vtkSmartPointer<vtkPolyData>::New();
    scene->SetPoints(points);
    scene->SetPolys(triangles);
    return scene;
  }

  fs::path Folder;
};

const char* TwoMaterials = "newmtl rock\nhelios_reflectance 0.3\n"
                           "newmtl grass\nhelios_classification 2\nhelios_isGround true\n";

} // namespace

TEST_CASE("MaterialReader: the alphabetically first material, or the named one", "[MaterialReader]")
{
  Reading reading(TwoMaterials);
  helios::MaterialTable table = reading.Update();
  REQUIRE(table.size() == 1);
  CHECK(table[0].Name == "grass");
  CHECK(table[0].IsGround);
  CHECK(table[0].Classification == 2);

  reading.Reader->SetMaterialName("rock");
  table = reading.Update();
  REQUIRE(table.size() == 1);
  CHECK(table[0].Name == "rock");
  CHECK(table[0].Reflectance == 0.3);
  auto* ids = vtkIntArray::SafeDownCast(
    reading.Reader->GetOutput()->GetCellData()->GetArray(names::MaterialIds));
  REQUIRE(ids);
  REQUIRE(ids->GetNumberOfValues() == 2);
  CHECK(ids->GetValue(1) == 0);
  CHECK(reading.Log->Errors.empty());
}

TEST_CASE("MaterialReader: random variations of a material", "[MaterialReader]")
{
  Reading reading("newmtl leaf\nhelios_reflectance 0.3\nhelios_classification 4\n");
  reading.Reader->SetNumberOfMaterials(1001);
  reading.Reader->SetRandomRange(0.2);
  helios::MaterialTable table = reading.Update();
  REQUIRE(table.size() == 1001);
  CHECK(table[0].Name == "leaf");
  CHECK(table[0].Reflectance == 0.3);
  CHECK(table[7].Name == "leaf.7");
  CHECK(table[7].Classification == 4);
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 1; i < table.size(); ++i)
  {
    const double x = table[i].Reflectance - 0.3;
    REQUIRE(std::abs(x) <= 0.2);
    sum += x;
    squares += x * x;
  }
  // standard deviation of a uniform distribution in +-0.2
  const double deviation = 0.2 / std::sqrt(3.0);
  CHECK(std::abs(sum / 1000) < 4.0 * deviation / std::sqrt(1000.0));
  CHECK(squares / 1000 == Approx(deviation * deviation).epsilon(0.1));
  reading.Reader->Modified();
  CHECK(reading.Update() == table);
  reading.Reader->SetSeed(1);
  CHECK_FALSE(reading.Update() == table);
  reading.Reader->SetRandomRange(1.0);
  int atEnds = 0;
  for (const helios::Material& material : reading.Update())
  {
    REQUIRE((material.Reflectance >= 0.0 && material.Reflectance <= 1.0));
    atEnds += material.Reflectance == 0.0 || material.Reflectance == 1.0 ? 1 : 0;
  }
  CHECK(atEnds > 300); // 0.3 +- 1 is clamped to [0, 1]
  CHECK(reading.Log->Warnings.empty());
}

TEST_CASE("MaterialReader: spectra are not varied, and ids repeat", "[MaterialReader]")
{
  Reading reading("newmtl leaf\nhelios_spectra oak\n");
  reading.Reader->SetNumberOfMaterials(2);
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  ids->InsertNextValue(3);
  ids->InsertNextValue(4);
  vtkPolyData::SafeDownCast(reading.Reader->GetInputDataObject(0, 0))->GetCellData()->AddArray(ids);
  const helios::MaterialTable table = reading.Update();
  REQUIRE(table.size() == 2);
  CHECK(std::isnan(table[1].Reflectance));
  CHECK(table[1].Spectrum == "oak");
  CHECK(reading.Log->HasWarning("material leaf has its reflectance from a spectrum"));
  vtkDataArray* out = reading.Reader->GetOutput()->GetCellData()->GetArray(names::MaterialIds);
  CHECK(out->GetTuple1(0) == 1);
  CHECK(out->GetTuple1(1) == 0);
}

TEST_CASE("MaterialReader: errors", "[MaterialReader]")
{
  SECTION("unknown name")
  {
    Reading reading(TwoMaterials);
    reading.Reader->SetMaterialName("stone");
    reading.Update();
    CHECK(reading.Log->HasError("m.mtl: has no material stone; it has rock, grass"));
  }
  SECTION("no materials")
  {
    Reading reading("# nothing\n");
    reading.Update();
    CHECK(reading.Log->HasError("m.mtl: has no material; begin one with newmtl NAME"));
  }
  SECTION("malformed")
  {
    Reading reading("newmtl a\nhelios_reflectance high\n");
    reading.Update();
    CHECK(reading.Log->HasError("m.mtl:2: helios_reflectance \"high\" is not a number"));
  }
  SECTION("no file")
  {
    Reading reading("");
    reading.Reader->SetFileName(nullptr);
    reading.Update();
    CHECK(reading.Log->HasError("FileName is not set; give the MTL file with SetFileName"));
    reading.Reader->SetFileName("/nowhere.mtl");
    reading.Update();
    CHECK(reading.Log->HasError("/nowhere.mtl"));
  }
}

TEST_CASE("MaterialReader: names with blanks, of which the first word is sufficient if unique",
  "[MaterialReader]")
{
  Reading reading("newmtl oak leaf\nhelios_reflectance 0.25\nnewmtl oak bark\nnewmtl elm tree\n");
  reading.Reader->SetMaterialName("oak leaf");
  CHECK(reading.Update().at(0).Reflectance == 0.25);
  reading.Reader->SetMaterialName("elm");
  CHECK(reading.Update().at(0).Name == "elm tree");
  CHECK(reading.Log->Errors.empty());
  reading.Reader->SetMaterialName("oak");
  reading.Update();
  CHECK(reading.Log->HasError("m.mtl: has no material oak; it has oak leaf, oak bark, elm tree"));
}
