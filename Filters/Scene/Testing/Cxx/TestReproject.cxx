// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosPose.h"
#include "heliosSceneCrs.h"
#include "heliosSceneTesting.h"
#include "vtkHeliosReproject.h"

#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkStructuredGrid.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <sstream>
#include <string>

namespace
{

namespace names = vtkHeliosArrayNames;

/// [degrees] of a UTM grid at 60 N, 3 degrees from its meridian.
constexpr double Convergence = 2.598672693802;

vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<std::array<double, 3>>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

/// A hilly mesh over a square [m] at a position, triangles counter-clockwise from above.
vtkSmartPointer<vtkPolyData> MakeHills(double x0, double y0, double size, int count)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (int j = 0; j <= count; ++j)
  {
    for (int i = 0; i <= count; ++i)
    {
      const double x = size * i / count;
      const double y = size * j / count;
      points->InsertNextPoint(x0 + x, y0 + y, 100.0 + 0.2 * size * std::sin(3.0 * x / size + y));
    }
  }
  for (int j = 0; j < count; ++j)
  {
    for (int i = 0; i < count; ++i)
    {
      const vtkIdType a = j * (count + 1) + i;
      const vtkIdType b = a + count + 1;
      polys->InsertNextCell({ a, a + 1, b + 1 });
      polys->InsertNextCell({ a, b + 1, b });
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, const std::vector<double>& tuple)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(tuple.size()));
  array->InsertNextTuple(tuple.data());
  return array;
}

vtkSmartPointer<vtkHeliosReproject> MakeFilter(
  vtkPointSet* input, const char* source, const char* target)
{
  auto reproject = vtkSmartPointer<vtkHeliosReproject>::New();
  reproject->SetInputData(input);
  reproject->SetSourceCRS(source);
  reproject->SetTargetCRS(target);
  return reproject;
}

vtkSmartPointer<helios::ErrorObserver> Watch(vtkObject* object)
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(object);
  return log;
}

std::string GetError(vtkPointSet* input, const char* source, const char* target)
{
  const auto reproject = MakeFilter(input, source, target);
  const auto log = Watch(reproject);
  reproject->Update();
  CHECK(reproject->GetOutput()->GetNumberOfPoints() == 0);
  return log->Errors;
}

/// The angle between two directions [degrees].
double GetAngle(vtkDataArray* array, vtkDataArray* other, vtkIdType i)
{
  const helios::Vec3 a(array->GetTuple3(i));
  const helios::Vec3 b(other->GetTuple3(i));
  return vtkMath::DegreesFromRadians(std::atan2(a.Cross(b).Norm(), a.Dot(b)));
}

/// The normals of a mesh by the right-hand rule.
vtkSmartPointer<vtkDoubleArray> GetNormals(vtkPolyData* mesh)
{
  auto normals = MakeArray("Normals", { 0.0, 0.0, 0.0 });
  normals->SetNumberOfTuples(mesh->GetNumberOfCells());
  helios::TriangleMesh triangles;
  REQUIRE(triangles.Set(mesh).IsOk());
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    normals->SetTuple(i, triangles.GetNormal(i).GetData());
  }
  return normals;
}

} // namespace

TEST_CASE("Reproject: points to UTM, to 5e-9 m", "[Reproject]")
{
  const auto reproject = MakeFilter(MakePoints({ { 8.7, 49.4, 12.5 } }), "EPSG:4326", "EPSG:32632");
  reproject->Update();
  const helios::Vec3 p(reproject->GetOutput()->GetPoint(0));
  CHECK(std::abs(p[0] - 478233.5100801130027) <= 5e-9);
  CHECK(std::abs(p[1] - 5471966.6981215651213) <= 5e-9);
  CHECK(p[2] == 12.5);
  CHECK(helios::GetCRS(reproject->GetOutput()) == "EPSG:32632");
}

TEST_CASE("Reproject: passes the scene and does not change the input", "[Reproject]")
{
  const auto mesh = MakeHills(478000, 5471000, 1000, 20);
  helios::SetMaterials(mesh, { helios::MakeMaterial("grass", 0.4) });
  helios::SetCRS(mesh, "EPSG:32632");
  const auto ids = MakeArray("Anything", { 1.0 });
  mesh->GetFieldData()->AddArray(ids);
  const helios::Vec3 before(mesh->GetPoint(7));
  const auto reproject = MakeFilter(mesh, nullptr, "EPSG:25832");
  reproject->Update();
  vtkPolyData* output = reproject->GetPolyDataOutput();
  REQUIRE(output);
  CHECK(output->GetPolys() == mesh->GetPolys());
  CHECK_FALSE(output->GetPolys()->IsStorage64Bit());
  CHECK(output->GetPoints() != mesh->GetPoints());
  CHECK(output->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(output->GetFieldData()->GetArray("Anything") == ids);
  CHECK(helios::GetMaterials(output)[0].Name == "grass");
  CHECK(helios::GetCRS(output) == "EPSG:25832");
  CHECK(helios::GetCRS(mesh) == "EPSG:32632");
  CHECK(helios::Vec3(mesh->GetPoint(7)) == before);
}

TEST_CASE("Reproject: equal systems share all data", "[Reproject]")
{
  const auto mesh = MakeHills(478000, 5471000, 1000, 5);
  helios::SetCRS(mesh, "EPSG:32632");
  const auto reproject = MakeFilter(mesh, nullptr, "+proj=utm +zone=32 +datum=WGS84");
  reproject->Update();
  CHECK(reproject->GetOutput()->GetPoints() == mesh->GetPoints());
  CHECK(helios::GetCRS(reproject->GetOutput()) == "+proj=utm +zone=32 +datum=WGS84");
}

TEST_CASE("Reproject: round trip, on any number of threads", "[Reproject]")
{
  const auto mesh = MakeHills(400000, 5471000, 20000, 600); // several blocks
  const auto there = MakeFilter(mesh, "EPSG:32632", "EPSG:31467");
  const auto back = MakeFilter(mesh, nullptr, "EPSG:32632");
  back->SetInputConnection(there->GetOutputPort());
  back->Update();
  double largest = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const helios::Vec3 a(mesh->GetPoint(i));
    const helios::Vec3 b(back->GetOutput()->GetPoint(i));
    largest = std::max(largest, (a - b).Norm());
  }
  CHECK(largest <= 5e-9);

  const auto alone = MakeFilter(mesh, "EPSG:32632", "EPSG:31467");
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 }, [&] { alone->Update(); });
  const auto* a = vtkDoubleArray::FastDownCast(there->GetOutput()->GetPoints()->GetData());
  const auto* b = vtkDoubleArray::FastDownCast(alone->GetOutput()->GetPoints()->GetData());
  bool isSame = true;
  for (vtkIdType i = 0; i < 3 * mesh->GetNumberOfPoints(); ++i)
  {
    isSame = isSame && a->GetValue(i) == b->GetValue(i);
  }
  CHECK(isSame);
}

TEST_CASE("Reproject: normals are those of the new surface, winding is kept", "[Reproject]")
{
  const auto mesh = MakeHills(332705, 6655205, 2000, 12);
  mesh->GetCellData()->SetNormals(GetNormals(mesh));
  for (const char* target : { "EPSG:32633", "EPSG:31467", "EPSG:4978", "ENU 60 6 0", "EPSG:4326",
         "EPSG:3035", "EPSG:3857" })
  {
    CAPTURE(target);
    const auto reproject = MakeFilter(mesh, "EPSG:32632", target);
    reproject->Update();
    vtkDataArray* normals = reproject->GetOutput()->GetCellData()->GetNormals();
    REQUIRE(normals);
    const auto fresh = GetNormals(reproject->GetPolyDataOutput());
    double largest = 0.0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      largest = std::max(largest, GetAngle(normals, fresh, i));
    }
    CHECK(largest < 2e-3); // triangles of 170 m
    CHECK(mesh->GetCellData()->GetNormals() != normals);
  }
}

TEST_CASE("Reproject: directions rotate by the convergences of both grids", "[Reproject]")
{
  // 12 E lies 3 degrees from the meridians of zones 32 and 33.
  const auto places = MakePoints({ { 12.0, 60.0, 0.0 } });
  const auto utm = MakeFilter(places, "EPSG:4326", "EPSG:32632");
  utm->Update();
  vtkPolyData* data = utm->GetPolyDataOutput();
  data->GetPointData()->AddArray(MakeArray(names::Velocity, { 0.0, 5.0, 1.0 }));
  data->GetPointData()->AddArray(
    MakeArray(names::Orientation, { std::sqrt(0.75), 0.5, 0.0, 0.0 })); // nose 60 degrees up
  data->GetPointData()->AddArray(MakeArray(names::TruePoint, { 500000.0, 6650000.0, 3.0 }));
  data->GetPointData()->SetNormals(MakeArray("Normals", { 0.0, 1.0, 0.0 }));
  const auto reproject = MakeFilter(data, nullptr, "EPSG:32633");
  reproject->Update();
  vtkPointData* turned = reproject->GetOutput()->GetPointData();

  // Grid north of zone 32 is Convergence east of north here, grid north of zone 33 equally far
  // west.
  const double angle = vtkMath::RadiansFromDegrees(2.0 * Convergence);
  const helios::Vec3 velocity(turned->GetArray(names::Velocity)->GetTuple3(0));
  CHECK(velocity[0] == Approx(5.0 * std::sin(angle)).margin(1e-8));
  CHECK(velocity[1] == Approx(5.0 * std::cos(angle)).margin(1e-8));
  CHECK(velocity[2] == Approx(1.0).margin(1e-8));
  const double* q = turned->GetArray(names::Orientation)->GetTuple4(0);
  const helios::Vec3 nose =
    helios::Rotate(helios::Quaternion(q[0], q[1], q[2], q[3]), helios::Vec3(0, 1, 0));
  CHECK(nose[0] == Approx(0.5 * std::sin(angle)).margin(1e-9));
  CHECK(nose[1] == Approx(0.5 * std::cos(angle)).margin(1e-9));
  CHECK(nose[2] == Approx(std::sqrt(0.75)).margin(1e-9));
  CHECK(turned->GetNormals()->GetComponent(0, 0) == Approx(std::sin(angle)).margin(1e-8));
  CHECK(turned->GetArray(names::TruePoint)->GetComponent(0, 1) == Approx(6659546).margin(20000.0));
  CHECK(turned->GetArray(names::TruePoint)->GetComponent(0, 2) == 3.0);
  CHECK(data->GetPointData()->GetArray(names::Velocity)->GetComponent(0, 1) == 5.0);
}

TEST_CASE("Reproject: directions rotate to geocentric axes", "[Reproject]")
{
  const auto place = MakePoints({ { 8.7, 49.4, 110.0 } });
  const std::array<const char*, 3> arrays = { names::Velocity, names::Direction, names::Normal };
  for (int k = 0; k < 3; ++k)
  {
    std::vector<double> axis(3, 0.0);
    axis[k] = 2.0;
    place->GetPointData()->AddArray(MakeArray(arrays[k], axis));
  }
  const auto reproject = MakeFilter(place, "EPSG:4326", "EPSG:4978");
  reproject->Update();
  vtkPointData* turned = reproject->GetOutput()->GetPointData();
  const double lat = vtkMath::RadiansFromDegrees(49.4);
  const double lon = vtkMath::RadiansFromDegrees(8.7);
  const double truth[3][3] = { { -std::sin(lon), std::cos(lon), 0.0 },
    { -std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon), std::cos(lat) },
    { std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat) } };
  for (int k = 0; k < 3; ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      CHECK(
        turned->GetArray(arrays[k])->GetComponent(0, i) == Approx(2.0 * truth[k][i]).margin(1e-8));
    }
  }
  const auto back = MakeFilter(reproject->GetOutput(), nullptr, "EPSG:4326");
  back->Update();
  for (int k = 0; k < 3; ++k)
  {
    CHECK(back->GetOutput()->GetPointData()->GetArray(arrays[k])->GetComponent(0, k) ==
      Approx(2.0).margin(1e-8));
  }
}

TEST_CASE("Reproject: any point set, also of float points", "[Reproject]")
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->InsertNextPoint(8.5, 49.5, 10.0);
  points->InsertNextPoint(8.75, 49.5, 10.0);
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(2, 1, 1);
  grid->SetPoints(points);
  const auto reproject = MakeFilter(grid, "EPSG:4326", "EPSG:32632");
  reproject->Update();
  REQUIRE(reproject->GetStructuredGridOutput());
  CHECK(reproject->GetOutput()->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(reproject->GetOutput()->GetPoint(1)[0] == Approx(481895.0).margin(200.0));

  vtkNew<vtkPolyData> empty;
  const auto nothing = MakeFilter(empty, "EPSG:4326", "EPSG:32632");
  const auto log = Watch(nothing);
  nothing->Update();
  CHECK(log->Errors.empty());
  CHECK(helios::GetCRS(nothing->GetOutput()) == "EPSG:32632");
}

TEST_CASE("Reproject: bad input is an error", "[Reproject]")
{
  const auto place = MakePoints({ { 8.7, 49.4, 110.0 }, { 8.7, 95.0, 1.0 }, { 8.7, 96.0, 1.0 } });
  const auto has = [&](const char* source, const char* target, const std::string& part)
  {
    const std::string error = GetError(place, source, target);
    CAPTURE(error, part);
    CHECK(error.find(part) != std::string::npos);
  };
  has("EPSG:4326", nullptr, "TargetCRS is not set; give the target system, e.g. EPSG:32632");
  has("EPSG:4326", "", "TargetCRS is not set");
  has(nullptr, "EPSG:32632",
    "The input has no CRS in its field data; set SourceCRS, the system it is in");
  has("EPSG:1", "EPSG:32632", "SourceCRS: \"EPSG:1\" is not a coordinate system");
  has("EPSG:4326", "EPSG:1", "TargetCRS: \"EPSG:1\" is not a coordinate system");
  has("EPSG:4326", "IAU_2015:30100", "There is no transformation from EPSG:4326 (WGS 84) to IAU");
  has("EPSG:4326", "EPSG:32632", "Point 1 (8.7, 95, 1) cannot be transformed from EPSG:4326");
  has("EPSG:4258", "EPSG:25832", "Point 1 (8.7, 95, 1) cannot be transformed");
  has("EPSG:4258", "EPSG:25832", "(utm: Invalid latitude)");

  place->GetPointData()->AddArray(MakeArray(names::Velocity, { 1, 0, 0 }));
  place->GetPointData()->GetArray(names::Velocity)->SetNumberOfTuples(3);
  has("EPSG:4326", "EPSG:32632", "Velocity cannot be rotated: Point 1 (8.7, 95, 1) cannot be");
  place->GetPointData()->RemoveArray(names::Velocity);
  place->GetPointData()->AddArray(MakeArray(names::Orientation, { 1, 0, 0, 0 }));
  place->GetPointData()->GetArray(names::Orientation)->SetNumberOfTuples(3);
  has("EPSG:4326", "EPSG:32632", "Orientation cannot be rotated: Point 1");
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(3);
  normals->Fill(1.0);
  place->GetPointData()->SetNormals(normals);
  has("EPSG:4326", "EPSG:32632", "Normals of points: Point 1 (8.7, 95, 1) cannot be");

  helios::SetCRS(place, "nonsense");
  has(nullptr, "EPSG:32632", "CRS of the input: \"nonsense\" is not a coordinate system");
}

TEST_CASE("Reproject: warns once if the source is not that of the input", "[Reproject]")
{
  const auto place = MakePoints({ { 478000, 5473000, 110 } });
  helios::SetCRS(place, "EPSG:25833");
  const auto reproject = MakeFilter(place, "EPSG:25832", "EPSG:32632");
  const auto log = Watch(reproject);
  reproject->Update();
  CHECK(log->HasWarning("SourceCRS is EPSG:25832 (ETRS89 / UTM zone 32N), but the input has "
                        "EPSG:25833; SourceCRS is used"));
  CHECK(reproject->GetOutput()->GetPoint(0)[0] == Approx(478000).margin(0.01));
  log->Clear();
  place->Modified();
  reproject->Update();
  CHECK(log->Warnings.empty());

  const auto denver = MakeFilter(MakePoints({ { -105, 39.7, 1600 } }), "EPSG:4267", "EPSG:32613");
  const auto denverLog = Watch(denver);
  denver->Update();
  CHECK(denverLog->HasWarning("it needs the grid"));
}

TEST_CASE("Reproject: reports progress and can be aborted", "[Reproject]")
{
  const auto mesh = MakeHills(400000, 5471000, 20000, 600);
  const auto reproject = MakeFilter(mesh, "EPSG:32632", "EPSG:32633");
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(true); });
  reproject->AddObserver(vtkCommand::ProgressEvent, stop);
  reproject->Update();
  CHECK(reproject->GetOutput()->GetNumberOfPoints() == 0);
}

TEST_CASE("Reproject: prints its properties", "[Reproject]")
{
  const auto reproject = MakeFilter(MakePoints({}), nullptr, "EPSG:32632");
  std::ostringstream text;
  reproject->Print(text);
  CHECK(text.str().find("SourceCRS: (the input's)") != std::string::npos);
  CHECK(text.str().find("TargetCRS: EPSG:32632") != std::string::npos);
}

TEST_CASE("Reproject: heights in feet become metres with x and y", "[Reproject]")
{
  constexpr double foot = 1200.0 / 3937.0;
  const auto input = MakePoints({ { 984000.0, 200000.0, 100.0 } });
  const auto reproject = MakeFilter(input, "EPSG:2263", "EPSG:32618");
  const auto log = Watch(reproject);
  const auto getHeight = [&]
  {
    log->Clear();
    reproject->Update();
    CHECK(log->Errors == "");
    return reproject->GetOutput()->GetPoint(0)[2];
  };
  CHECK(getHeight() == Approx(100.0 * foot).epsilon(1e-12));
  CHECK(
    log->HasWarning("EPSG:2263 (NAD83 / New York Long Island (ftUS)) does not state the unit of "
                    "heights, which are read as US survey foot, like x and y; if they are not, "
                    "give the system with a vertical part, or SourceHeightUnit (metres: 1)"));
  reproject->SetSourceHeightUnit(1.0);
  CHECK(getHeight() == Approx(100.0).epsilon(1e-12));
  CHECK_FALSE(log->HasWarning("the unit of heights"));
  reproject->SetSourceHeightUnit(0.0);
  reproject->SetSourceCRS("EPSG:2263+6360");
  CHECK(getHeight() == Approx(100.0 * foot).epsilon(1e-12));
  CHECK_FALSE(log->HasWarning("the unit of heights"));
  reproject->SetSourceCRS("ENU 40 -74 0");
  reproject->SetSourceHeightUnit(0.3048);
  reproject->Update();
  CHECK(log->HasError("SourceHeightUnit is 0.3048, but heights of ENU 40 -74 0 are in metres"));
}

TEST_CASE("Reproject: the epoch is given, or that of the points", "[Reproject]")
{
  const auto input = MakePoints({ { 8.44, 49.32, 150.0 } });
  const auto reproject = MakeFilter(input, "EPSG:7912", "EPSG:25832"); // ITRF2014, ETRS89
  const auto log = Watch(reproject);
  const auto getEast = [&]
  {
    log->Clear();
    reproject->Modified();
    reproject->Update();
    CHECK(log->Errors == "");
    return reproject->GetOutput()->GetPoint(0)[0];
  };
  const double unknown = getEast();
  CHECK(log->HasWarning("coordinates move by 2.5 cm a year, and their epoch is not known"));
  reproject->SetEpoch(2026.0);
  const double given = getEast();
  CHECK(log->Warnings == "");
  CHECK(std::abs(given - unknown) > 0.2);
  reproject->SetEpoch(0.0);
  input->GetPointData()->AddArray(MakeArray(names::GpsTime, { 4.5199e8 })); // begin of 2026
  CHECK(getEast() == unknown); // seconds of an unknown week
  input->GetFieldData()->AddArray(MakeArray(names::GpsEpoch, { 1e9 }));
  CHECK(getEast() == Approx(given).margin(1e-3));
  CHECK(log->Warnings == "");
}

TEST_CASE("Reproject: steps of a file are as fine in the other system", "[Reproject]")
{
  const auto input = MakePoints({ { 478000.0, 5473000.0, 110.0 } });
  helios::CoordinateSteps steps;
  steps.Scale = { 0.01, 0.001, 1e-5 };
  steps.HasOffset = true;
  helios::SetCoordinateSteps(input, steps);
  const auto reproject = MakeFilter(input, "EPSG:25832", "EPSG:4258");
  reproject->Update();
  const helios::CoordinateSteps moved = helios::GetCoordinateSteps(reproject->GetOutput());
  CHECK_FALSE(moved.HasOffset);
  CHECK(moved.Scale[0] == Approx(0.01 / 111195.0));
  CHECK(moved.Scale[2] == 1e-5);
  reproject->SetTargetCRS("EPSG:25832");
  reproject->Update();
  CHECK(helios::GetCoordinateSteps(reproject->GetOutput()).HasOffset); // unchanged points
}
