// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Many scans by one sensor: floors at known heights, the same scans one by one, and faults.
#include "vtkHeliosScanBatch.h"

#include "heliosSurveyFiles.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBatchArrayNames.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveySource.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
namespace batch = vtkHeliosBatchArrayNames;
using namespace helios::test;

namespace
{

constexpr const char* Leg = R"(<leg><platformSettings x="0" y="0" z="0"/>
<scannerSettings pulseFreq_hz="100000" scanFreq_hz="50" headRotatePerSec_deg="60"
 headRotateStop_deg="3"/></leg>)"; // 5,000 pulses

/// A square floor of 200 m at a height.
vtkSmartPointer<vtkPolyData> MakeFloor(double height)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& corner : { std::make_pair(-100, -100), std::make_pair(100, -100),
         std::make_pair(100, 100), std::make_pair(-100, 100) })
  {
    points->InsertNextPoint(corner.first, corner.second, height);
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 0, 2, 3 });
  auto floor = vtkSmartPointer<vtkPolyData>::New();
  floor->SetPoints(points);
  floor->SetPolys(polys);
  return floor;
}

/// A batch of the terrestrial scanner.
struct Batch
{
  const Files Folder;
  const Reading Survey;
  vtkNew<vtkHeliosSurveySource> Source;
  vtkNew<vtkHeliosScanBatch> Scans;
  vtkNew<vtkPolyData> Poses;
  vtkNew<vtkDoubleArray> Turns;
  vtkSmartPointer<helios::ErrorObserver> Log = Observe(Scans);

  Batch()
    : Survey(Folder, Tripod, Leg)
  {
    REQUIRE(this->Survey.Good);
    this->Source->SetSurvey(this->Survey.Reader->GetSurvey());
    this->Source->GetOptions()->SetNumberOfSubRays(1);
    this->Source->GetOptions()->SetNoise(false);
    this->Scans->SetSource(this->Source);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    this->Poses->SetPoints(points);
    this->Turns->SetName(names::Orientation);
    this->Turns->SetNumberOfComponents(4);
    this->Poses->GetPointData()->AddArray(this->Turns);
    this->Scans->SetInputDataObject(1, this->Poses);
  }

  void AddPose(double x, double y, double z, double w = 1.0, double turn = 0.0)
  {
    this->Poses->GetPoints()->InsertNextPoint(x, y, z);
    this->Turns->InsertNextTuple4(w, 0.0, 0.0, turn);
  }

  vtkIdType GetOffset(vtkIdType scan)
  {
    return vtkIdTypeArray::SafeDownCast(
      this->Scans->GetOutput()->GetFieldData()->GetArray(batch::Offsets))
      ->GetValue(scan);
  }

  bool HasScans() { return this->Scans->GetOutput()->GetFieldData()->HasArray(batch::Offsets); }
};

} // namespace

TEST_CASE("ScanBatch: scans of many scenes are on their floors", "[ScanBatch]")
{
  Batch scans;
  constexpr int count = 40; // each thread has several
  for (int i = 0; i < count; ++i)
  {
    scans.Scans->AddInputDataObject(0, MakeFloor(-1.0 - 0.05 * i));
    scans.AddPose(0.1 * i, 0.0, 0.0);
  }
  scans.Scans->Update();
  INFO(scans.Log->Errors);
  REQUIRE(scans.HasScans());
  CHECK(scans.Scans->GetPulsesPerScan() == 5000);
  vtkPolyData* echoes = scans.Scans->GetOutput();
  CHECK(scans.GetOffset(0) == 0);
  CHECK(scans.GetOffset(count) == echoes->GetNumberOfPoints());
  vtkDataArray* ids = echoes->GetPointData()->GetArray(names::PulseIds);
  vtkDataArray* ranges = echoes->GetPointData()->GetArray(names::Range);
  for (int i = 0; i < count; ++i)
  {
    REQUIRE(scans.GetOffset(i + 1) - scans.GetOffset(i) > 500);
    for (vtkIdType k = scans.GetOffset(i); k < scans.GetOffset(i + 1); ++k)
    {
      const double* p = echoes->GetPoint(k); // beams start 0.2 m above the scanner
      REQUIRE(std::abs(p[2] + 1.0 + 0.05 * i) < 1e-6);
      REQUIRE(std::hypot(p[0] - 0.1 * i, p[1], p[2] - 0.2) == Approx(ranges->GetComponent(k, 0)));
      REQUIRE(static_cast<int>(ids->GetComponent(k, 0)) / 5000 == i);
    }
  }
}

TEST_CASE("ScanBatch: a scan of many is that of one, and turns with its pose", "[ScanBatch]")
{
  Batch many;
  Batch one;
  many.Scans->AddInputDataObject(0, MakeFloor(-2.0));
  one.Scans->AddInputDataObject(0, MakeFloor(-2.0));
  many.Scans->SetArrays(std::string(names::Range) + " " + names::Amplitude);
  one.Scans->SetArrays(std::string(names::Range) + " " + names::Amplitude);
  const double half = std::sqrt(0.5);
  one.AddPose(3.0, 4.0, 0.0);
  for (int i = 0; i < 64; ++i)
  {
    many.AddPose(3.0, 4.0, 0.0, i == 0 ? 1.0 : half, i == 0 ? 0.0 : half); // a quarter turn
  }
  many.Scans->Update();
  one.Scans->Update();
  vtkPolyData* a = many.Scans->GetOutput();
  vtkPolyData* b = one.Scans->GetOutput();
  CHECK(a->GetPointData()->GetNumberOfArrays() == 2);
  const vtkIdType count = b->GetNumberOfPoints();
  REQUIRE(count > 500);
  REQUIRE(many.GetOffset(1) == count);
  REQUIRE(many.GetOffset(64) == 64 * count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    double q[3];
    b->GetPoint(i, q);
    a->GetPoint(i, p);
    REQUIRE(std::equal(p, p + 3, q));
    a->GetPoint(63 * count + i, p);
    REQUIRE(std::abs(p[0] - 3.0 + (q[1] - 4.0)) < 1e-9);
    REQUIRE(std::abs(p[1] - 4.0 - (q[0] - 3.0)) < 1e-9);
  }
}

TEST_CASE("ScanBatch: no poses, and scenes without an echo or a triangle", "[ScanBatch]")
{
  Batch scans;
  scans.Scans->AddInputDataObject(0, MakeFloor(-2.0));
  SECTION("no poses")
  {
    scans.Scans->Update();
    REQUIRE(scans.HasScans());
    CHECK(scans.GetOffset(0) == 0);
    CHECK(scans.Scans->GetOutput()->GetNumberOfPoints() == 0);
  }
  SECTION("out of range")
  {
    scans.Scans->RemoveAllInputConnections(0);
    scans.Scans->AddInputDataObject(0, MakeFloor(2000.0));
    scans.AddPose(0.0, 0.0, 0.0);
    scans.AddPose(0.0, 0.0, 1.0);
    scans.Scans->Update();
    INFO(scans.Log->Errors);
    REQUIRE(scans.HasScans());
    CHECK(scans.GetOffset(2) == 0);
  }
  SECTION("no triangle")
  {
    vtkNew<vtkPolyData> empty;
    scans.Scans->AddInputDataObject(0, empty);
    scans.AddPose(0.0, 0.0, 0.0);
    scans.AddPose(1.0, 2.0, 3.0);
    scans.Scans->Update();
    CHECK_FALSE(scans.HasScans());
    CHECK(scans.Log->HasError("scan 1 (scene 1, pose 1 2 3, 1 0 0 0): "));
  }
}

TEST_CASE("ScanBatch: faults name the scan, its scene and its pose", "[ScanBatch]")
{
  Batch scans;
  scans.Scans->AddInputDataObject(0, MakeFloor(-1.0));
  scans.AddPose(0.0, 0.0, 0.0);
  std::string message;
  SECTION("position")
  {
    scans.AddPose(4.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
    message = "scan 1 (scene 0, pose 4 nan 0, 1 0 0 0): its position is not finite";
  }
  SECTION("orientation")
  {
    scans.AddPose(0.0, 0.0, 0.0, 2.0);
    message = "scan 1 (scene 0, pose 0 0 0, 2 0 0 0): its orientation is not a unit quaternion";
  }
  SECTION("number of poses")
  {
    scans.Scans->AddInputDataObject(0, MakeFloor(-2.0));
    message = "there are 1 poses for 2 scenes; give one each, or the array SceneIds";
  }
  SECTION("number of a scene")
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(batch::SceneIds);
    ids->InsertNextValue(7);
    scans.Poses->GetPointData()->AddArray(ids);
    message = "scan 0 (scene 7, pose 0 0 0, 1 0 0 0): there are only 1 scenes";
  }
  SECTION("no orientations")
  {
    scans.Poses->GetPointData()->RemoveArray(names::Orientation);
    message = "the poses have no point array Orientation with 4 components: w, x, y, z";
  }
  SECTION("no sensor")
  {
    scans.Scans->SetSource(nullptr);
    message = "the batch has no sensor; set a Source that can be loaded";
  }
  SECTION("no such array")
  {
    scans.Scans->SetArrays("Colour");
    message = "scan 0 (scene 0, pose 0 0 0, 1 0 0 0): the echoes have no array Colour";
  }
  scans.Scans->Update();
  INFO(scans.Log->Errors);
  CHECK(scans.Log->HasError(message));
  CHECK_FALSE(scans.HasScans());
}

TEST_CASE("ScanBatch: a batch, and a scan in it, is stopped on request", "[ScanBatch]")
{
  Batch scans;
  const int count = GENERATE(1, 64);
  scans.Source->GetOptions()->SetNumberOfSubRays(count == 1 ? 953 : 1);
  scans.Scans->AddInputDataObject(0, MakeFloor(-1.0));
  for (int i = 0; i < count; ++i)
  {
    scans.AddPose(0.0, 0.0, 0.0);
  }
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      *static_cast<double*>(data) = algorithm->GetProgress();
      algorithm->SetAbortExecute(1);
    });
  double progress = -1.0;
  stop->SetClientData(&progress);
  scans.Scans->AddObserver(vtkCommand::ProgressEvent, stop);
  scans.Scans->Update();
  CHECK(scans.Log->Errors.empty());
  CHECK(progress >= 0.0);
  CHECK(progress < 1.0);
  CHECK_FALSE(scans.HasScans());
}
