// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCropGround.h"
#include "heliosCropTesting.h"
#include "heliosErrorObserver.h"
#include "vtkHeliosObjSceneReader.h"
#include "vtkHeliosObjSceneWriter.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>

namespace
{
namespace names = vtkHeliosArrayNames;
namespace truth = helios::cropFieldNames;
using helios::FindMaterial;
using helios::GetTruth;
using helios::Make;
using helios::MakeExact;

double GetTruthValue(vtkHeliosCropFieldSource* field, const char* name)
{
  return GetTruth(field, name)->GetValue(0);
}

/// The material of a triangle.
std::string GetName(vtkHeliosCropFieldSource* field, vtkIdType triangle)
{
  static thread_local helios::MaterialTable table;
  table = helios::GetMaterials(field->GetOutput());
  return table[static_cast<std::size_t>(
                 helios::GetIds(field->GetOutput(), names::MaterialIds)->GetValue(triangle))]
    .Name;
}

struct Moments
{
  double Mean;
  double Deviation;
};

Moments GetMoments(vtkDoubleArray* values)
{
  const auto n = static_cast<double>(values->GetNumberOfValues());
  double sum = 0.0;
  double squares = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    sum += values->GetValue(i);
  }
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    squares += std::pow(values->GetValue(i) - sum / n, 2);
  }
  return { sum / n, std::sqrt(squares / n) };
}

/// The area of a strip of n trapezoids along an arc, computed independently.
double GetStripArea(double length, double width, double droop, double widest, int n)
{
  const double turn = vtkMath::RadiansFromDegrees(droop) / n;
  const double chord = turn > 0 ? 2.0 * (length / n / turn) * std::sin(turn / 2) : length / n;
  const auto w = [width, widest](double t)
  { return width * (1.0 - std::pow((t - widest) / (1.0 - widest), 2)); };
  double area = 0.0;
  for (int i = 0; i < n; ++i)
  {
    area += 0.5 * chord * (w(double(i) / n) + w((i + 1.0) / n));
  }
  return area;
}

} // namespace

TEST_CASE("CropFieldSource: plants are in rows at their spacing", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  MakeExact(field);
  field->SetNumberOfRows(4);
  field->SetRowSpacing(0.7);
  field->SetPlantSpacing(0.1); // 3 / 0.1 is less than 30 when rounded
  field->SetRowLength(0.3);
  field->SetOrigin(500000.5, 5500000.25, 100.125);
  CHECK(field->GetPlantsPerRow() == 4);
  const helios::TriangleMesh mesh = Make(field);
  vtkDoubleArray* places = GetTruth(field, truth::PlantPosition);
  REQUIRE(places->GetNumberOfTuples() == 16);
  for (int i = 0; i < 16; ++i)
  {
    CHECK(places->GetComponent(i, 0) == Approx(500000.5 + 0.7 * (i / 4 - 1.5)).epsilon(1e-14));
    CHECK(places->GetComponent(i, 1) == Approx(5500000.25 + 0.1 * (i % 4 - 1.5)).epsilon(1e-14));
    CHECK(places->GetComponent(i, 2) == 100.125);
  }
  // The stems are at these positions, and every plant is a part.
  vtkIntArray* parts = helios::GetIds(field->GetOutput(), names::PartIds);
  CHECK(parts->GetValueRange()[0] == 0);
  CHECK(parts->GetValueRange()[1] == 16);
  CHECK(GetName(field, 0) == "soil");
  const std::vector<bool> isStem = FindMaterial(field, "crop_stem");
  std::set<int> seen;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const int part = parts->GetValue(i);
    const double* corner = mesh.GetCorner(i, 0);
    REQUIRE((part == 0) == (i < 2));
    if (isStem[static_cast<std::size_t>(i)] && corner[2] < 100.2)
    {
      const double* place = places->GetPointer(3 * (part - 1));
      REQUIRE(std::hypot(corner[0] - place[0], corner[1] - place[1]) < 0.013);
      seen.insert(part);
    }
  }
  CHECK(seen.size() == 16);
}

TEST_CASE("CropFieldSource: only the soil is ground", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  field->SetSpeciesToCereal();
  field->SetRowLength(1.0);
  Make(field);
  std::set<std::string> materials;
  for (const helios::Material& material : helios::GetMaterials(field->GetOutput()))
  {
    CHECK(material.IsGround == (material.Name == "soil"));
    CHECK(material.Classification == (material.Name == "soil" ? 2 : 3));
    CHECK(material.Reflectance > 0.0);
    materials.insert(material.Name);
  }
  CHECK(materials == std::set<std::string>({ "soil", "crop_stem", "crop_leaf", "crop_ear" }));
}

TEST_CASE(
  "CropFieldSource: random variation has the given standard deviations", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  field->SetNumberOfRows(100);
  field->SetRowLength(39.9);
  field->SetPlantSpacing(0.1);
  field->SetEmergence(0.8);
  field->SetPositionJitter(0.02);
  field->SetPlantHeight(1.5);
  field->SetPlantHeightDeviation(0.1);
  field->SetLeavesPerPlant(0);
  field->SetGroundRoughness(0.0);
  const helios::TriangleMesh mesh = Make(field);
  const auto n = static_cast<double>(GetTruth(field, truth::PlantHeight)->GetNumberOfValues());
  CHECK(n == Approx(32000).margin(4 * std::sqrt(40000 * 0.8 * 0.2)));
  const Moments heights = GetMoments(GetTruth(field, truth::PlantHeight));
  CHECK(heights.Mean == Approx(1.5).margin(4 * 0.1 / std::sqrt(n)));
  CHECK(heights.Deviation == Approx(0.1).epsilon(0.02));

  vtkNew<vtkDoubleArray> offsets;
  vtkDoubleArray* places = GetTruth(field, truth::PlantPosition);
  for (vtkIdType i = 0; i < places->GetNumberOfTuples(); ++i)
  {
    const double row = places->GetComponent(i, 0) / 0.75 + 49.5;
    offsets->InsertNextValue(0.75 * (row - std::round(row)));
  }
  CHECK(GetMoments(offsets).Mean == Approx(0.0).margin(4 * 0.02 / std::sqrt(n)));
  CHECK(GetMoments(offsets).Deviation == Approx(0.02).epsilon(0.02));

  // Checks that the reported height is the height of the stem.
  std::vector<double> tops(static_cast<std::size_t>(n), 0.0);
  vtkIntArray* parts = helios::GetIds(field->GetOutput(), names::PartIds);
  for (vtkIdType i = 2; i < mesh.GetNumberOfTriangles(); ++i)
  {
    double& top = tops[static_cast<std::size_t>(parts->GetValue(i) - 1)];
    top = std::max(top, mesh.GetCorner(i, 2)[2]);
  }
  double worst = 0.0;
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(n); ++i)
  {
    worst = std::max(worst,
      std::abs(
        tops[static_cast<std::size_t>(i)] - GetTruth(field, truth::PlantHeight)->GetValue(i)));
  }
  CHECK(worst < 1e-12);
}

TEST_CASE("CropFieldSource: leaf area equals that of the strips", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  MakeExact(field);
  field->SetNumberOfRows(2);
  field->SetRowLength(0.5);
  field->SetPlantSpacing(0.5);
  field->SetLeafLength(0.4);
  field->SetLeafWidth(0.05);
  field->SetLeafAngle(20.0);
  field->SetPlantHeight(3.0);
  field->SetRowSpacing(1.0);
  struct
  {
    int Species;
    double Widest;
    int Stems;
  } const all[] = { { vtkHeliosCropFieldSource::MAIZE, 0.4, 1 },
    { vtkHeliosCropFieldSource::CEREAL, 0.2, 4 }, { vtkHeliosCropFieldSource::BROADLEAF, 0.5, 1 } };
  for (const auto& species : all)
  {
    for (const double droop : { 0.0, 100.0 })
    {
      for (const int segments : { 2, 7 })
      {
        field->SetSpecies(species.Species);
        field->SetLeafDroop(droop);
        field->SetLeafSegments(segments);
        field->SetLeavesPerPlant(8);
        const int ranks = 8 / species.Stems;
        double plant = 0.0;
        for (int leaf = 0; leaf < 8; ++leaf)
        {
          const double level = (leaf / species.Stems + 0.5) / ranks;
          // A cereal's lower tillers are equally high: leaves scale with the plant.
          const double size = 1.0 - 0.45 * std::pow(2.0 * level - 1.0, 2);
          plant += GetStripArea(0.4 * size, 0.05 * size, droop, species.Widest, segments);
        }
        Make(field);
        CHECK(GetTruthValue(field, truth::LeafArea) == Approx(4 * plant).epsilon(1e-12));
        CHECK(GetTruth(field, truth::PlantLeafArea)->GetValue(3) == Approx(plant).epsilon(1e-12));
        CHECK(GetTruthValue(field, truth::GroundArea) == 2.0);
        CHECK(GetTruthValue(field, truth::LeafAreaIndex) == Approx(2 * plant));
      }
    }
  }
  // Many segments approach the parabola: (1 - (0.6^3 + 0.4^3) / 3 / 0.6^2) L W.
  field->SetSpeciesToMaize();
  field->SetLeavesPerPlant(1);
  field->SetLeafSegments(100);
  Make(field);
  CHECK(GetTruth(field, truth::PlantLeafArea)->GetValue(0) ==
    Approx(0.4 * 0.05 * (1.0 - 0.28 / 1.08)).epsilon(2e-4));
}

TEST_CASE("CropFieldSource: leaf area equals the sum of its triangles", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  field->SetNumberOfRows(5);
  field->SetRowLength(3.0);
  for (const int species : { vtkHeliosCropFieldSource::MAIZE, vtkHeliosCropFieldSource::CEREAL,
         vtkHeliosCropFieldSource::BROADLEAF })
  {
    field->SetSpecies(species);
    const helios::TriangleMesh mesh = Make(field);
    const std::vector<bool> isLeaf = FindMaterial(field, "crop_leaf");
    vtkIntArray* parts = helios::GetIds(field->GetOutput(), names::PartIds);
    vtkDoubleArray* areas = GetTruth(field, truth::PlantLeafArea);
    std::vector<double> sums(static_cast<std::size_t>(areas->GetNumberOfValues()), 0.0);
    for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
    {
      if (isLeaf[static_cast<std::size_t>(i)])
      {
        sums[static_cast<std::size_t>(parts->GetValue(i) - 1)] += helios::GetArea(mesh, i);
      }
    }
    double total = 0.0;
    double worst = 0.0;
    for (vtkIdType i = 0; i < areas->GetNumberOfValues(); ++i)
    {
      const double sum = sums[static_cast<std::size_t>(i)];
      worst = std::max(worst, std::abs(sum / areas->GetValue(i) - 1.0));
      total += sum;
    }
    CHECK(worst < 1e-9);
    CHECK(GetTruthValue(field, truth::LeafArea) == Approx(total).epsilon(1e-9));
  }
}

TEST_CASE("CropFieldSource: leaves stay above the soil, stems are closed", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  field->SetNumberOfRows(4);
  field->SetRowLength(3.0);
  field->SetLeafAngle(85.0); // these would reach into it
  field->SetLeafDroop(90.0);
  for (const double roughness : { 0.0, 0.2, 1.5 })
  {
    for (const int species : { vtkHeliosCropFieldSource::MAIZE, vtkHeliosCropFieldSource::CEREAL,
           vtkHeliosCropFieldSource::BROADLEAF })
    {
      field->SetSpecies(species);
      field->SetGroundRoughness(roughness);
      const helios::TriangleMesh mesh = Make(field);
      // The soil of the field: rows, margin and jitter.
      double bounds[6];
      mesh.GetBounds(bounds);
      double soil[2] = { 0.0, 0.0 };
      const std::vector<bool> isSoil = FindMaterial(field, "soil");
      const std::vector<bool> isLeaf = FindMaterial(field, "crop_leaf");
      for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
      {
        for (int k = 0; k < 2 && isSoil[static_cast<std::size_t>(i)]; ++k)
        {
          soil[k] = std::max(soil[k], 2.0 * mesh.GetCorner(i, 2)[k]);
        }
      }
      const helios::CropGround ground(soil[0], soil[1], 0.1, roughness, 0);
      CHECK(ground.GetHighest() <= 0.5 * roughness);
      CHECK((roughness == 0.0 || ground.GetHighest() > 0.1 * roughness));
      double lowest = 1.0;
      for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          const double* p = mesh.GetCorner(i, k);
          const double above = p[2] - ground.GetHeight(p[0], p[1]);
          if (isSoil[static_cast<std::size_t>(i)])
          {
            REQUIRE(std::abs(above) < 1e-12);
          }
          lowest = isLeaf[static_cast<std::size_t>(i)] ? std::min(lowest, above) : lowest;
        }
      }
      CHECK(lowest > 0.9e-3);
    }
  }
  field->SetLeavesPerPlant(0);
  field->SetGroundRoughness(0.0);
  const helios::TriangleMesh mesh = Make(field);
  CHECK(helios::CountOpenEdges(mesh) == 4); // triangles of the soil
}

TEST_CASE(
  "CropFieldSource: soil heights between points are those of the triangles", "[CropFieldSource]")
{
  const helios::CropGround ground(3.0, 2.0, 0.5, 0.3, 7);
  // At the midpoint of an edge or a diagonal it is the mean of the ends.
  const double a = ground.GetHeight(0.5, 0.0);
  const double b = ground.GetHeight(1.0, 0.0);
  const double c = ground.GetHeight(1.0, 0.5);
  CHECK(ground.GetHeight(0.75, 0.0) == Approx(0.5 * (a + b)));
  CHECK(ground.GetHeight(0.75, 0.25) == Approx(0.5 * (a + c)));
  CHECK(ground.GetHeight(1.0, 0.25) == Approx(0.5 * (b + c)));
  CHECK(ground.GetHeight(9.0, 0.0) == ground.GetHeight(1.5, 0.0));
  CHECK(ground.GetNumberOfTriangles() == 2 * 6 * 4);
  CHECK(ground.GetNumberOfPoints() == 7 * 5);
}

TEST_CASE("CropFieldSource: the same seed gives the same field", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> a;
  vtkNew<vtkHeliosCropFieldSource> b;
  for (vtkHeliosCropFieldSource* field : { a.Get(), b.Get() })
  {
    field->SetSpeciesToCereal();
    field->SetNumberOfRows(3);
    field->SetRowLength(1.0);
    field->SetEmergence(1.0);
    field->SetGroundRoughness(0.0);
    field->SetSeed(42);
  }
  const helios::TriangleMesh first = Make(a);
  const helios::TriangleMesh second = Make(b);
  REQUIRE(first.GetNumberOfPoints() == second.GetNumberOfPoints());
  const std::size_t bytes =
    3 * sizeof(double) * static_cast<std::size_t>(first.GetNumberOfPoints());
  CHECK(std::memcmp(first.GetPoints(), second.GetPoints(), bytes) == 0);
  // Another row does not change the plants of the first rows.
  b->SetNumberOfRows(4);
  Make(b);
  for (vtkIdType i = 0; i < GetTruth(a, truth::PlantHeight)->GetNumberOfValues(); ++i)
  {
    REQUIRE(
      GetTruth(a, truth::PlantHeight)->GetValue(i) == GetTruth(b, truth::PlantHeight)->GetValue(i));
    REQUIRE(GetTruth(a, truth::PlantLeafArea)->GetValue(i) ==
      GetTruth(b, truth::PlantLeafArea)->GetValue(i));
  }
  b->SetNumberOfRows(3);
  b->SetSeed(43);
  CHECK(std::memcmp(first.GetPoints(), Make(b).GetPoints(), bytes) != 0);
}

TEST_CASE("CropFieldSource: one plant, no plants, no leaves, a hundred thousand plants",
  "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  MakeExact(field);
  field->SetNumberOfRows(1);
  field->SetRowLength(0.0);
  field->SetLeavesPerPlant(0);
  CHECK(Make(field).GetNumberOfTriangles() == 2 + 4 + 2 * 2 * 6 + 6);
  CHECK(GetTruth(field, truth::PlantHeight)->GetNumberOfValues() == 1);
  CHECK(GetTruthValue(field, truth::LeafArea) == 0.0);

  field->SetEmergence(0.0);
  CHECK(Make(field).GetNumberOfTriangles() == 2);
  CHECK(GetTruth(field, truth::PlantHeight)->GetNumberOfValues() == 0);
  CHECK(GetTruthValue(field, truth::LeafAreaIndex) == 0.0);

  field->SetEmergence(1.0);
  field->SetNumberOfRows(250);
  field->SetRowLength(399 * 0.16);
  field->SetLeavesPerPlant(3);
  field->SetLeafSegments(4);
  const helios::TriangleMesh mesh = Make(field);
  CHECK(GetTruth(field, truth::PlantHeight)->GetNumberOfValues() == 100000);
  CHECK(mesh.GetNumberOfTriangles() == 2 + 100000 * (34 + 3 * 7));
  CHECK(GetTruthValue(field, truth::LeafAreaIndex) ==
    Approx(GetTruth(field, truth::PlantLeafArea)->GetValue(0) / 0.75 / 0.16));
}

TEST_CASE("CropFieldSource: an OBJ file restores the triangles", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  field->SetSpeciesToBroadleaf();
  field->SetNumberOfRows(3);
  field->SetRowLength(1.0);
  field->SetOrigin(500000.5, 5500000.25, 100.125);
  const helios::TriangleMesh mesh = Make(field);
  const auto folder = std::filesystem::temp_directory_path() / "helios_crop_field";
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "field.obj").string();
  vtkNew<vtkHeliosObjSceneWriter> writer;
  writer->SetInputConnection(field->GetOutputPort());
  writer->SetFileName(path.c_str());
  REQUIRE(writer->Write() == 1);
  vtkNew<vtkHeliosObjSceneReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetUpAxisToZ();
  reader->Update();
  helios::TriangleMesh back;
  REQUIRE(back.Set(reader->GetOutput()).IsOk());
  REQUIRE(back.GetNumberOfTriangles() == mesh.GetNumberOfTriangles());
  bool isSame = true;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      isSame =
        isSame && std::memcmp(mesh.GetCorner(i, k), back.GetCorner(i, k), 3 * sizeof(double)) == 0;
    }
  }
  CHECK(isSame);
  CHECK(helios::GetMaterials(reader->GetOutput()).size() ==
    helios::GetMaterials(field->GetOutput()).size());
  std::filesystem::remove_all(folder);
}

TEST_CASE("CropFieldSource: bad properties are errors", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(field);
  field->SetLeafLength(std::nan(""));
  field->Update();
  CHECK(log->HasError("LeafLength is nan; set a finite number"));

  log->Clear();
  field->SetLeafLength(0.0);
  field->SetOrigin(0, HUGE_VAL, 0);
  field->Update();
  CHECK(log->HasError("Origin is inf; set a finite number"));

  log->Clear();
  field->SetOrigin(0, 0, 0);
  field->SetPlantHeight(0.2);
  field->Update();
  CHECK(log->HasError("PlantHeightDeviation 0.05 m is a quarter of PlantHeight 0.2 m or more"));

  log->Clear();
  field->SetPlantHeight(0.0);
  field->SetNumberOfRows(1000000);
  field->SetRowLength(1e5);
  field->Update();
  CHECK(log->HasError("1000000 rows of 625001 plants with 12 leaves, and soil every 0.1 m"));
  CHECK(log->HasError("more than 5e+08; lower NumberOfRows, RowLength, LeavesPerPlant or"));
  CHECK(field->GetOutput()->GetNumberOfCells() == 0);

  log->Clear();
  field->SetNumberOfRows(1); // the soil alone is too large
  field->SetRowLength(1e3);
  field->SetGroundSpacing(0.001);
  field->Update();
  CHECK(log->HasError("or raise GroundSpacing"));
}

TEST_CASE("CropFieldSource: prints its species", "[CropFieldSource]")
{
  vtkNew<vtkHeliosCropFieldSource> field;
  CHECK(std::string(field->GetSpeciesAsString()) == "Maize");
  field->SetSpeciesToBroadleaf();
  std::ostringstream text;
  field->Print(text);
  CHECK_THAT(text.str(), Catch::Contains("Species: Broadleaf"));
  CHECK_THAT(text.str(), Catch::Contains("LeafDroop: -1"));
}
