// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Solid voxels from points: cells and faces, for any order and pieces.
#include "heliosAborts.h"
#include "heliosVoxelGrid.h"
#include "heliosVoxelTesting.h"
#include "vtkHeliosMemoryLimit.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace names = vtkHeliosArrayNames;
using helios::MakeCloud;
using helios::Triples;
using helios::Voxelizing;

namespace
{

/// The centres of a block of cells of 1 m, and its lowest corner, so that the grid starts there.
Triples MakeBlock(int n, const std::array<double, 3>& low = { 0.0, 0.0, 0.0 })
{
  Triples points = { low };
  for (int i = 0; i < n * n * n; ++i)
  {
    points.push_back({ low[0] + i % n + 0.5, low[1] + i / n % n + 0.5, low[2] + i / n / n + 0.5 });
  }
  return points;
}

Triples MakeRandomPoints(int count, double size, unsigned seed = 7)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, size);
  Triples points(static_cast<std::size_t>(count));
  for (auto& point : points)
  {
    point = { 4.5e5 + uniform(random), 5.4e6 + uniform(random), 100.0 + uniform(random) };
  }
  return points;
}

/// The number of entries and exits of a line through a scene, and its length inside.
struct Chord
{
  int Crossings = 0;
  double Length = 0.0;
};

Chord Cut(vtkPolyData* scene, const helios::Vec3& origin, const helios::Vec3& direction)
{
  helios::TriangleMesh mesh;
  REQUIRE(mesh.Set(scene).IsOk());
  Chord chord;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const helios::Vec3 a(mesh.GetCorner(i, 0));
    const helios::Vec3 ab = helios::Vec3(mesh.GetCorner(i, 1)) - a;
    const helios::Vec3 ac = helios::Vec3(mesh.GetCorner(i, 2)) - a;
    const helios::Vec3 p = direction.Cross(ac);
    const double determinant = ab.Dot(p);
    const helios::Vec3 t = origin - a;
    const helios::Vec3 q = t.Cross(ab);
    const double u = t.Dot(p) / determinant;
    const double v = direction.Dot(q) / determinant;
    if (determinant != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0)
    {
      ++chord.Crossings;
      chord.Length += ac.Dot(q) / determinant * (determinant < 0.0 ? 1.0 : -1.0);
    }
  }
  return chord;
}

} // namespace

TEST_CASE(
  "PointVoxelizer: points on the lattice are in the voxel of their decimals", "[PointVoxelizer]")
{
  // x = (x0 + k step) / 1000 as integers: the quotient is the double nearest to the decimal.
  int wrong = 0;
  int wrongByFloor = 0;
  int wrongInside = 0;
  int count = 0;
  for (const std::int64_t step : { 10, 50, 100, 200, 250 })
  {
    for (const std::int64_t x0 : { 0LL, 500000000LL, 5500000000LL })
    {
      const double s = static_cast<double>(step) / 1000.0;
      const double low = static_cast<double>(x0) / 1000.0;
      for (std::int64_t k = 0; k <= 20000; ++k)
      {
        const double x = static_cast<double>(x0 + k * step) / 1000.0;
        const double inside = static_cast<double>(2 * (x0 + k * step) + step) / 2000.0;
        ++count;
        wrong += helios::GetVoxelIndex(x, low, s) != static_cast<double>(k);
        wrongInside += helios::GetVoxelIndex(inside, low, s) != static_cast<double>(k);
        wrongByFloor += std::floor((x - low) / s) != static_cast<double>(k);
      }
    }
  }
  CHECK(count == 300015);
  CHECK(wrong == 0);
  CHECK(wrongInside == 0);
  CHECK(wrongByFloor > 6457); // the errors that the rule avoids
}

TEST_CASE("PointVoxelizer: voxels are half-open intervals", "[PointVoxelizer]")
{
  const double s = 0.1;
  CHECK(helios::GetVoxelIndex(0.0, 0.0, s) == 0.0);
  CHECK(helios::GetVoxelIndex(std::nextafter(0.3, 0.0) - 1e-15, 0.0, s) == 2.0);
  CHECK(helios::GetVoxelIndex(0.3, 0.0, s) == 3.0);
  CHECK(helios::GetVoxelIndex(0.3999999, 0.0, s) == 3.0);
  // For float coordinates decimals end sooner.
  for (int k = 0; k < 2000; ++k)
  {
    const float x = static_cast<float>(1000.0 + k / 10.0);
    REQUIRE(helios::GetVoxelIndex(x, 1000.0, s, 0x1p-23) == k);
  }
}

TEST_CASE("PointVoxelizer: a filled block has its outer faces only", "[PointVoxelizer]")
{
  for (const int n : { 1, 2, 5, 12 })
  {
    Voxelizing block(MakeCloud(MakeBlock(n, { -3.0, 0.0, 1e6 })), 1.0);
    REQUIRE(block.Run());
    CHECK(block.Filter->GetNumberOfVoxels() == n * n * n);
    CHECK(block.FaceCount() == 6 * n * n);
    CHECK(block.Scene()->GetNumberOfPoints() == 6 * n * n + 2); // corners on the hull, shared
    CHECK(helios::CountUnbalancedEdges(block.Scene()) == 0);
    double bounds[6];
    block.Scene()->GetBounds(bounds);
    CHECK(bounds[0] == -3.0);
    CHECK(bounds[1] == -3.0 + n);
    CHECK(bounds[4] == 1e6);
    CHECK(bounds[5] == 1e6 + n);
  }
  Voxelizing block(MakeCloud(MakeBlock(5)), 1.0);
  REQUIRE(block.Run());
  CHECK(helios::GetVolume(block.Scene()) == Approx(125.0).epsilon(1e-14)); // outward
}

TEST_CASE("PointVoxelizer: no faces between solid voxels", "[PointVoxelizer]")
{
  Voxelizing faceSharing(MakeCloud({ { 0, 0, 0 }, { 1, 0, 0 } }), 1.0);
  REQUIRE(faceSharing.Run());
  CHECK(faceSharing.FaceCount() == 10);
  CHECK(faceSharing.Scene()->GetNumberOfPoints() == 12);

  Voxelizing edgeTouching(MakeCloud({ { 0, 0, 0 }, { 1, 1, 0 } }), 1.0);
  REQUIRE(edgeTouching.Run());
  CHECK(edgeTouching.FaceCount() == 12);
  CHECK(edgeTouching.Scene()->GetNumberOfPoints() == 14);
  CHECK(helios::CountUnbalancedEdges(edgeTouching.Scene()) == 0);

  Voxelizing cornerTouching(MakeCloud({ { 0, 0, 0 }, { 1, 1, 1 } }), 1.0);
  REQUIRE(cornerTouching.Run());
  CHECK(cornerTouching.FaceCount() == 12);
  CHECK(cornerTouching.Scene()->GetNumberOfPoints() == 15);

  Triples hollow = MakeBlock(3);
  hollow.erase(hollow.begin() + 1 + 13);
  Voxelizing shell(MakeCloud(hollow), 1.0);
  REQUIRE(shell.Run());
  CHECK(shell.Filter->GetNumberOfVoxels() == 26);
  CHECK(shell.FaceCount() == 60);
  CHECK(helios::GetVolume(shell.Scene()) == Approx(26.0).epsilon(1e-14));
  CHECK(helios::CountUnbalancedEdges(shell.Scene()) == 0);

  // Layers with a gap share no corners.
  Voxelizing layers(MakeCloud({ { 0, 0, 0 }, { 0, 0, 2 }, { 0, 0, 7 }, { 0, 0, 8 } }), 1.0);
  REQUIRE(layers.Run());
  CHECK(layers.FaceCount() == 22);
  CHECK(layers.Scene()->GetNumberOfPoints() == 8 + 8 + 12);
}

TEST_CASE("PointVoxelizer: a line through a block enters and leaves it once", "[PointVoxelizer]")
{
  Triples points = { { 0.0, 0.0, 0.0 } };
  for (int i = 0; i < 1000; ++i)
  {
    points.push_back({ (i % 10 + 0.5) / 10, (i / 10 % 10 + 0.5) / 10, (i / 100 + 0.5) / 10 });
  }
  Voxelizing block(MakeCloud(points), 0.1);
  REQUIRE(block.Run());
  CHECK(block.Filter->GetNumberOfVoxels() == 1000);
  // So close to the diagonal that the chord is the same, but off the edges.
  const helios::Vec3 origin(-1.0 + 1e-9, -1.0 + 3e-9, -1.0);
  const double third = 1.0 / std::sqrt(3.0);
  const Chord chord = Cut(block.Scene(), origin, { third, third, third });
  CHECK(chord.Crossings == 2);
  CHECK(chord.Length == Approx(1.732050807568877).epsilon(1e-8));
}

TEST_CASE("PointVoxelizer: the fraction of solid voxels follows Poisson's law", "[PointVoxelizer]")
{
  const int n = 40; // cells along an axis
  for (const double lambda : { 1.0, 3.0 })
  {
    const int count = static_cast<int>(lambda * n * n * n);
    Triples points = MakeRandomPoints(count, n);
    points.push_back({ 4.5e5, 5.4e6, 100.0 });
    Voxelizing cloud(MakeCloud(points), 1.0);
    REQUIRE(cloud.Run());
    const double cells = n * n * n;
    const double expected = 1.0 - std::exp(-lambda);
    const double sigma = std::sqrt(expected * (1.0 - expected) / cells);
    const double fraction = static_cast<double>(cloud.Filter->GetNumberOfVoxels()) / cells;
    CHECK(std::abs(fraction - expected) < 4.0 * sigma);
    CHECK(helios::GetVolume(cloud.Scene()) ==
      Approx(static_cast<double>(cloud.Filter->GetNumberOfVoxels())).epsilon(1e-6));
    CHECK(helios::CountUnbalancedEdges(cloud.Scene()) == 0);
  }
}

TEST_CASE("PointVoxelizer: a cloud at UTM coordinates gives the same voxels, translated",
  "[PointVoxelizer]")
{
  const std::int64_t offset[3] = { 476123, 5473456, 110 };
  Triples here, there;
  std::mt19937 random(4);
  for (int i = 0; i < 3000; ++i)
  {
    here.emplace_back();
    there.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t units = i == 0 ? 0 : random() % 1000; // 0.01 m, so many are on cell faces
      here.back()[axis] = static_cast<double>(units) / 100.0;
      there.back()[axis] = static_cast<double>(units + 100 * offset[axis]) / 100.0;
    }
  }
  Voxelizing a(MakeCloud(here), 0.1);
  Voxelizing b(MakeCloud(there), 0.1);
  REQUIRE(a.Run());
  REQUIRE(b.Run());
  CHECK(helios::HaveSameBytes(
    a.Scene()->GetPolys()->GetConnectivityArray(), b.Scene()->GetPolys()->GetConnectivityArray()));
  REQUIRE(a.Scene()->GetNumberOfPoints() == b.Scene()->GetNumberOfPoints());
  double worst = 0.0;
  for (vtkIdType i = 0; i < a.Scene()->GetNumberOfPoints(); ++i)
  {
    const helios::Vec3 p(a.Scene()->GetPoint(i));
    const helios::Vec3 q(b.Scene()->GetPoint(i));
    for (int axis = 0; axis < 3; ++axis)
    {
      worst = std::max(worst, std::abs(q[axis] - p[axis] - static_cast<double>(offset[axis])));
    }
  }
  CHECK(worst < 1e-8);
}

TEST_CASE("PointVoxelizer: voxels with few points are dropped", "[PointVoxelizer]")
{
  Triples points = { { 0, 0, 0 }, { 0.1, 0, 0 }, { 0.2, 0, 0 }, { 5, 0, 0 }, { 5.5, 0, 0 } };
  Voxelizing cloud(MakeCloud(points), 1.0);
  for (const auto& [least, voxels] : { std::pair(1, 2), { 2, 2 }, { 3, 1 } })
  {
    cloud.Filter->SetMinimumNumberOfPoints(least);
    REQUIRE(cloud.Run());
    CHECK(cloud.Filter->GetNumberOfVoxels() == voxels);
    CHECK(cloud.FaceCount() == 6 * voxels);
  }
  CHECK(cloud.Filter->GetNumberOfPoints() == 5);
  cloud.Filter->SetMinimumNumberOfPoints(4);
  CHECK(cloud.FailsWith("4 points; lower MinimumNumberOfPoints"));
}

TEST_CASE("PointVoxelizer: materials in turn, and counts of voxels", "[PointVoxelizer]")
{
  Voxelizing row(MakeCloud({ { 6, 0, 0 }, { 4, 0, 0 }, { 2, 0, 0 }, { 0, 0, 0 } }), 1.0);
  REQUIRE(row.Run());
  CHECK(helios::GetMaterials(row.Scene()).size() == 1);
  CHECK(row.Scene()->GetCellData()->GetNumberOfArrays() == 1); // no optional arrays
  row.Filter->SetNumberOfMaterials(3);
  row.Filter->GenerateVoxelIdsOn();
  REQUIRE(row.Run());
  CHECK(helios::GetMaterials(row.Scene()).size() == 3);
  vtkIntArray* materials = helios::GetIds(row.Scene(), names::MaterialIds);
  vtkIntArray* voxels = helios::GetIds(row.Scene(), names::VoxelIds);
  REQUIRE(materials->GetNumberOfValues() == 48);
  REQUIRE(voxels->GetNumberOfValues() == 48);
  for (int i = 0; i < 48; ++i)
  {
    CHECK(voxels->GetValue(i) == i / 12);
    CHECK(materials->GetValue(i) == i / 12 % 3);
  }
}

TEST_CASE("PointVoxelizer: independent of pieces and order", "[PointVoxelizer]")
{
  Triples points = MakeRandomPoints(3000, 12.0);
  Triples normals = MakeRandomPoints(3000, 1.0, 8);
  Triples colors = MakeRandomPoints(3000, 1.0, 9);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    normals[i] = { normals[i][0] - 4.5e5 - 0.5, normals[i][1] - 5.4e6 - 0.5,
      normals[i][2] - 100.4 };
    colors[i] = { colors[i][0] - 4.5e5, colors[i][1] - 5.4e6, colors[i][2] - 100.0 };
  }
  Triples shuffled[3];
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  for (const std::size_t i : order)
  {
    shuffled[0].push_back(points[i]);
    shuffled[1].push_back(normals[i]);
    shuffled[2].push_back(colors[i]);
  }
  for (const int mode : { 0, 1, 2 }) // the mean, the nearest, the plane
  {
    Voxelizing whole(MakeCloud(points, normals, colors), 1.0);
    whole.Filter->SetSnapNeighborNormal(mode == 1);
    whole.Filter->SetEstimateNormals(mode == 2);
    whole.Filter->GenerateVoxelIdsOn();
    REQUIRE(whole.Run());
    CHECK(whole.Scene()->GetCellData()->GetNumberOfArrays() == 4);
    vtkNew<helios::PieceSource> source;
    source->Cloud = MakeCloud(shuffled[0], shuffled[1], shuffled[2]);
    for (const int pieces : { 0, 1, 2, 7, 1000 })
    {
      Voxelizing parts(1.0);
      parts.Filter->SetInputConnection(source->GetOutputPort());
      parts.Filter->SetSnapNeighborNormal(mode == 1);
      parts.Filter->SetEstimateNormals(mode == 2);
      parts.Filter->GenerateVoxelIdsOn();
      parts.Filter->SetNumberOfPieces(pieces);
      source->Asked.clear();
      source->Modified();
      REQUIRE(parts.Run());
      CHECK(parts.Filter->GetNumberOfPoints() == 3000);
      CHECK(helios::HaveSameBytes(whole.Scene(), parts.Scene()));
      CHECK(source->Asked.count(std::max(pieces, 1)) == 1);
    }
  }
}

TEST_CASE(
  "PointVoxelizer: a large source is requested in pieces of bounded size", "[PointVoxelizer]")
{
  vtkNew<helios::PieceSource> source;
  source->Cloud = MakeCloud(MakeRandomPoints(100000, 100.0));
  Voxelizing voxels(10.0);
  voxels.Filter->SetInputConnection(source->GetOutputPort());
  voxels.Filter->SetPointsPerPiece(2000);
  REQUIRE(voxels.Run());
  CHECK(voxels.Filter->GetNumberOfPoints() == 100000);
  CHECK(voxels.Filter->GetNumberOfVoxels() == 1000);
  CHECK(source->Largest <= 4 * 2000);
  // Without changes nothing is requested again.
  source->Asked.clear();
  voxels.Run();
  CHECK(source->Asked.empty());
  vtkInformation* output = voxels.Filter->GetOutputInformation(0);
  CHECK(!output->Has(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST())); // the output is complete
}

TEST_CASE("PointVoxelizer: field data are passed", "[PointVoxelizer]")
{
  vtkNew<helios::PieceSource> source;
  source->Cloud = MakeCloud(MakeRandomPoints(100, 9.0));
  vtkNew<vtkIntArray> extra; // represents any array, e.g. the coordinate system
  extra->SetName(names::CRS);
  extra->InsertNextValue(32632);
  source->Cloud->GetFieldData()->AddArray(extra);
  Voxelizing voxels(1.0);
  voxels.Filter->SetInputConnection(source->GetOutputPort());
  voxels.Filter->SetNumberOfPieces(4);
  REQUIRE(voxels.Run());
  REQUIRE(voxels.Scene()->GetFieldData()->GetArray(names::CRS));
  CHECK(voxels.Scene()->GetFieldData()->GetArray(names::CRS)->GetTuple1(0) == 32632.0);
}

TEST_CASE("PointVoxelizer: errors", "[PointVoxelizer]")
{
  Voxelizing cloud(MakeCloud({ { 0, 0, 0 }, { 3, 0, 0 }, { 5, 0, 0 } }), 1.0);
  SECTION("no points")
  {
    cloud.Filter->SetInputData(MakeCloud({}));
    CHECK(cloud.FailsWith("Input has no points"));
    vtkNew<vtkPolyData> nothing;
    cloud.Filter->SetInputData(nothing);
    CHECK(cloud.FailsWith("Input has no points"));
  }
  SECTION("the size of cells")
  {
    for (const double size : { 0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
    {
      cloud.Filter->SetVoxelSize(size);
      CHECK(cloud.FailsWith("VoxelSize is "));
    }
    cloud.Filter->SetVoxelSize(1e-6);
    CHECK(cloud.FailsWith("5e+06 cells along x; the maximum is 2097149"));
    cloud.Filter->SetInputData(MakeCloud({ { 0, 0, 5.4e6 }, { 1e-8, 0, 5.4e6 } }));
    cloud.Filter->SetVoxelSize(1e-9);
    CHECK(cloud.FailsWith("below the resolution of coordinates of this size"));
    cloud.Filter->SetInputData(MakeCloud({ { -1e308, 0, 0 }, { 1e308, 0, 0 } }));
    cloud.Filter->SetVoxelSize(1e300);
    CHECK(cloud.FailsWith("cells along x"));
  }
  SECTION("too many cells")
  {
    cloud.Filter->SetMaximumNumberOfCells(2);
    CHECK(cloud.FailsWith("more cells than MaximumNumberOfCells, 2; set a larger one"));
    cloud.Filter->SetMaximumNumberOfCells(3);
    cloud.Log->Clear();
    CHECK(cloud.Run());
  }
  SECTION("above the memory limit")
  {
    vtkHeliosMemoryLimit::SetLimit(0.001);
    const bool fails = cloud.FailsWith("m: 1 cells or more need about 0.0005 MB of memory");
    vtkHeliosMemoryLimit::SetLimit(0.0);
    CHECK(fails);
  }
  SECTION("points that are not finite")
  {
    cloud.Filter->SetInputData(MakeCloud({ { 0, 0, 0 }, { 0, std::nan(""), 1 } }));
    CHECK(cloud.FailsWith("Input point 1 is (0, nan, 1), which is not finite"));
    cloud.Filter->SetInputData(MakeCloud({ { 0, 0, -std::numeric_limits<double>::infinity() } }));
    CHECK(cloud.FailsWith("Input point 0 is (0, 0, -inf), which is not finite"));
  }
  SECTION("attributes")
  {
    cloud.Filter->SnapNeighborNormalOn();
    CHECK(cloud.FailsWith("SnapNeighborNormal is on, but the points have no Normals"));
    cloud.Filter->SnapNeighborNormalOff();
    cloud.Filter->SetDefaultNormal(0.0, std::nan(""), 0.0);
    CHECK(cloud.FailsWith("DefaultNormal is (0, nan, 0)"));
    cloud.Filter->SetDefaultNormal(0.0, 0.0, 0.0);
    cloud.Filter->SetInputData(MakeCloud({ { 0, 0, 0 } }, {}, { { 0.5, 2.0, 0.0 } }));
    CHECK(cloud.FailsWith("RGB has 2.000000 of the full colour value at point 0"));
    auto bare = MakeCloud({ { 0, 0, 0 } });
    bare->GetPointData()->AddArray(helios::MakeTriples(names::RGB, { { 0, 0, 0 }, { 0, 0, 0 } }));
    cloud.Filter->SetInputData(bare);
    CHECK(cloud.FailsWith("RGB has 2 tuples of 3; expected one of 3 for each of 1 points"));
  }
  SECTION("a source that changes between requests")
  {
    using Change = std::function<void(int, vtkPolyData*)>;
    const Change moved = [](int request, vtkPolyData* piece)
    { piece->GetPoints()->SetPoint(0, request >= 2 ? -1e9 : 0.0, 0.0, 0.0); };
    const Change bare = [](int request, vtkPolyData* piece)
    { request >= 2 ? piece->GetPointData()->Initialize() : void(); };
    const Change fewer = [](int request, vtkPolyData* piece)
    { request >= 3 ? piece->Initialize() : void(); };
    const Change bad = [](int request, vtkPolyData* piece)
    { piece->GetPoints()->SetPoint(0, request >= 3 ? std::nan("") : 0.0, 0.0, 0.0); };
    for (const Change& change : { moved, bare, fewer, bad })
    {
      vtkNew<helios::PieceSource> source;
      source->Cloud = MakeCloud({ { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 0, 1 }, { 0, 0, 1 } });
      source->OnRequest = change;
      cloud.Filter->SetInputConnection(source->GetOutputPort());
      cloud.Filter->SetNumberOfPieces(2);
      CHECK(cloud.FailsWith("Input changed while it was read"));
    }
  }
  SECTION("pieces")
  {
    vtkNew<helios::PieceSource> source;
    source->Cloud = MakeCloud({ { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 0, 1 }, { 0, 0, 1 } });
    cloud.Quiet->Watch(source);
    cloud.Quiet->Watch(source->GetExecutive());
    cloud.Filter->SetInputConnection(source->GetOutputPort());
    cloud.Filter->SetNumberOfPieces(2);
    source->BarePiece = 1;
    CHECK(cloud.FailsWith("1 of 2 points have Normals; give them for all points or for none"));
    source->BarePiece = -1;
    source->FailingPiece = 1;
    source->Modified();
    cloud.Log->Clear();
    cloud.Run();
    CHECK(cloud.Quiet->HasError("piece 1 is lost"));
    CHECK(cloud.FaceCount() == 0);
    source->FailingPiece = -1;
    source->Modified();
    cloud.Log->Clear();
    CHECK(cloud.Run());
    CHECK(cloud.FaceCount() == 10);
  }
}

TEST_CASE("PointVoxelizer: can be aborted within a piece", "[PointVoxelizer]")
{
  struct Stop
  {
    int Steps;
    void Count(vtkObject* caller, unsigned long, void*)
    {
      if (--this->Steps == 0)
      {
        static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
      }
    }
  };
  // The start, then twice four steps of at most 65536 points.
  const auto stop = GENERATE(std::make_pair(2, "14 %"), std::make_pair(6, "59 %"));
  Stop watch = { stop.first };
  Voxelizing cloud(MakeCloud(MakeRandomPoints(200000, 20.0)), 1.0);
  cloud.Filter->AddObserver(vtkCommand::ProgressEvent, &watch, &Stop::Count);
  CHECK(cloud.FailsWith("Voxelizing was aborted at " + std::string(stop.second)));
  CHECK(watch.Steps == -helios::ReportsAfterAbort); // no step afterwards
}
