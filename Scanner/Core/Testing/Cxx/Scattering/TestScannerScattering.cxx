// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes and waveforms of light that is scattered more than once.
#include "heliosScatteringBench.h"
#include "vtkHeliosInstrument.h"

#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>

#include <algorithm>
#include <numeric>

using namespace helios::testing;
using helios::Vec3;
namespace names = vtkHeliosArrayNames;

namespace
{

/// A corner of floor and wall before a scanner that looks at its edge, with 20 pulses.
struct CornerBench : Bench
{
  explicit CornerBench(vtkPolyData* scene, int orders = 3)
    : Bench(scene)
  {
    this->Scanner->SetDuration(0.0002);
    this->Scanner->SetScatteringOrders(orders);
    this->Scanner->SetFieldOfView(0.2);
    this->Scanner->SetSeed(5);
  }
};

vtkSmartPointer<vtkPolyData> MakeCorner(double wall = 10.0, double reflectance = 0.6)
{
  auto scene = MakeScene({ Wall(wall), { { -50, -50, -0.1 }, { 100, 0, 0 }, { 0, 100, 0 } } });
  SetMaterial(scene, reflectance);
  return scene;
}

double Sum(vtkTable* waveforms)
{
  auto* samples = vtkFloatArray::SafeDownCast(waveforms->GetFieldData()->GetArray(names::Samples));
  const float* first = samples->GetPointer(0);
  return std::accumulate(first, first + samples->GetNumberOfValues(), 0.0);
}

} // namespace

TEST_CASE("ScannerScattering: one order is as before, and has no columns of scattered light")
{
  CornerBench before(MakeCorner(), 1);
  const std::string bytes = Bytes(before.Run());
  CornerBench bench(MakeCorner(), 1);
  bench.Scanner->SetScatteringPaths(8);
  bench.Scanner->SetScatteringPhaseToIsotropic();
  CHECK(Bytes(bench.Run()) == bytes);
  CHECK_FALSE(bench.Run()->GetPointData()->HasArray(names::ScatteredAmplitude));
  CHECK_FALSE(bench.Run()->GetPointData()->HasArray(names::ScatteredDeviation));
}

TEST_CASE("ScannerScattering: an echo tells how much of it was scattered more than once")
{
  const bool isFixed = GENERATE(true, false);
  const auto run = [isFixed](int orders)
  {
    auto bench = std::make_unique<CornerBench>(MakeCorner(), orders);
    bench->Scanner->SetSampling(isFixed ? vtkHeliosScanner::FIXED : vtkHeliosScanner::TOLERANCE);
    REQUIRE(bench->Run()->GetNumberOfPoints() == 20);
    return bench;
  };
  const auto once = run(1), more = run(3);
  double error = 0.0, mean = 0.0;
  for (vtkIdType i = 0; i < 20; ++i)
  {
    const double scattered = Value(more->Run(), names::ScatteredAmplitude, i);
    const double before = Value(once->Run(), names::Amplitude, i);
    // the peak of the sum is a little later than that of the first order
    CHECK(Value(more->Run(), names::Amplitude, i) == Approx(before + scattered).epsilon(0.01));
    CHECK(scattered > 0.01 * before);
    CHECK(Value(more->Run(), names::ScatteredDeviation, i) < 0.5 * scattered);
    error += std::pow(Value(more->Run(), names::ScatteredDeviation, i), 2) / 20.0;
    mean += scattered / 20.0;
  }
  double spread = 0.0;
  for (vtkIdType i = 0; i < 20; ++i)
  {
    spread += std::pow(Value(more->Run(), names::ScatteredAmplitude, i) - mean, 2) / 19.0;
  }
  CHECK(std::sqrt(error) == Approx(std::sqrt(spread)).epsilon(0.4));
}

TEST_CASE("ScannerScattering: the waveforms in a Lambertian sphere sum up to its closed form")
{
  const auto sphere = MakeSphere(5.0, 0.8);
  const auto run = [&](int orders)
  {
    Bench bench(sphere);
    bench.Scanner->SetAtmosphericExtinction(0.0);
    bench.Scanner->GenerateWaveformsOn();
    bench.Scanner->SetDuration(0.0003);
    bench.Scanner->SetFieldOfView(1.0);
    bench.Scanner->SetScatteringOrders(orders);
    bench.Run();
    return Sum(vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1)));
  };
  const double share = 0.5 * (1.0 - std::cos(0.5)); // share of the sphere in the field of view
  CHECK(run(64) / run(1) == Approx(1.0 + share * 0.8 / (1.0 - 0.8)).epsilon(0.02));
}

TEST_CASE("ScannerScattering: light over a far wall is an echo of its own, at half its path")
{
  // The beam meets the floor below; the wall 6 m behind is in the field of view.
  auto scene = MakeScene({ { { -1, -1, -10 }, { 2, 0, 0 }, { 0, 2, 0 } }, // small: no orders beyond
    { { -1, 7, -11 }, { 2, 0, 0 }, { 0, 0, 2 } } });
  SetMaterial(scene, 0.9);
  LightBench light;
  light.SetScene(scene);
  light.Settings.HalfFieldOfView = 1.0;
  light.Settings.Paths = 1024;
  const auto result = light.Run({ 0, 0, 0 }, { 0, 0, -1 }, 20);
  // to the floor, to the wall between its upper edge and the height of the floor, and back
  CHECK(result.Power > 0.0);
  CHECK(result.Range > 0.5 * (10.0 + std::hypot(7.0, 1.0) + std::hypot(7.0, 9.0)));
  CHECK(result.Range < 0.5 * (10.0 + 7.0 + std::hypot(7.0, 10.0)));
}

TEST_CASE("ScannerScattering: leaves pass light on its way to a corner and back")
{
  const auto run = [](bool hasLeaf)
  {
    std::vector<Rectangle> rectangles = { Wall(10.0),
      { { -50, -50, -0.3 }, { 100, 0, 0 }, { 0, 100, 0 } } };
    if (hasLeaf)
    {
      rectangles.push_back(Wall(1.0));
    }
    auto scene = MakeScene(rectangles);
    helios::Material ground, leaf;
    ground.Reflectance = 0.6;
    leaf.Reflectance = 0.0;
    leaf.Optics.Kind = helios::OpticsKind::Leaf;
    leaf.Optics.Transmittance = 0.7;
    helios::SetMaterials(scene, { ground, leaf });
    vtkNew<vtkIntArray> ids;
    ids->SetName(names::MaterialIds);
    for (vtkIdType i = 0; i < scene->GetNumberOfCells(); ++i)
    {
      ids->InsertNextValue(i < 4 ? 0 : 1);
    }
    scene->GetCellData()->AddArray(ids);
    LightBench bench;
    bench.SetScene(scene);
    bench.Settings.HalfFieldOfView = 0.05; // the floor is behind the leaf, too
    return bench.Run({ 0, 0, 0 }, { 0, 1, 0 }, 2000);
  };
  const auto open = run(false), behind = run(true);
  CHECK(behind.Power / open.Power == Approx(0.49).epsilon(0.05));
  CHECK(behind.Error / behind.Power < 0.02);
}

TEST_CASE("ScannerScattering: results depend on the seed, not on threads, pieces or the detector")
{
  const auto scene = MakeCorner();
  const auto run = [&scene](int threads, int seed)
  {
    vtkSMPTools::Initialize(threads);
    CornerBench bench(scene);
    bench.Scanner->SetDuration(0.005);
    bench.Scanner->SetSeed(seed);
    const std::string bytes = Bytes(bench.Run());
    vtkSMPTools::Initialize();
    return bytes;
  };
  const std::string many = run(4, 5); // before a call limits the threads
  CHECK(run(1, 5) == many);
  CHECK(run(1, 5) != run(1, 6));
  CornerBench whole(scene);
  whole.Run();
  CornerBench last(scene);
  last.Scanner->SetPulseWindow(19, 20);
  REQUIRE(last.Run()->GetNumberOfPoints() == 1);
  CHECK(Value(last.Run(), names::ScatteredAmplitude, 0) ==
    Value(whole.Run(), names::ScatteredAmplitude, 19));
}

TEST_CASE("ScannerScattering: values outside their range are rejected with the range")
{
  CornerBench bench(MakeCorner());
  SECTION("orders")
  {
    bench.Scanner->SetScatteringOrders(GENERATE(0, 65));
    bench.Run();
    CHECK(bench.Log->HasError("ScatteringOrders is "));
    CHECK(bench.Log->HasError(", 64]; 1 for light that is scattered once"));
  }
  SECTION("paths")
  {
    bench.Scanner->SetScatteringPaths(GENERATE(7, 65537));
    bench.Run();
    CHECK(bench.Log->HasError("ScatteringPaths is "));
    CHECK(bench.Log->HasError("more have a smaller standard error"));
  }
  SECTION("isotropic voxels")
  {
    const int cells[3] = { 2, 2, 2 };
    bench.Scanner->AddInputDataObject(2, MakeBox({ 0, 5, 0 }, 1.0, cells, 1.0, 0.3));
    bench.Scanner->SetScatteringPhaseToIsotropic();
    bench.Run();
    CHECK(
      bench.Log->HasError("4 times the reflectance, and that of turbid voxels is 0.3; give them "
                          "at most 0.25, or take the phase of leaves"));
  }
}
