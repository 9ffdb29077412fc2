// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosAborts.h"
#include "heliosScannerBench.h"
#include "vtkHeliosErrorModel.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRayCasterFactory.h"
#include "vtkHeliosRotatingMirror.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
using namespace helios::testing;

namespace
{

/// One of its terms has no value for angles below a limit [rad], or ranges beyond one [m].
class FaultyErrors : public vtkHeliosErrorModel
{
public:
  static FaultyErrors* New() { VTK_STANDARD_NEW_BODY(FaultyErrors); }
  vtkTypeMacro(FaultyErrors, vtkHeliosErrorModel);
  double GetRangeError(double theta) const override
  {
    return this->Get(RANGE_ERROR, theta < -0.3, std::nan(""));
  }
  double GetDeflectionError(double theta) const override
  {
    return this->Get(DEFLECTION_ERROR, theta < -0.3, 1.0 / 0.0);
  }
  double GetHeadError(double theta) const override
  {
    return this->Get(HEAD_ERROR, theta < -0.3, -1e300);
  }
  double GetRangeNoiseFactor(double range) const override
  {
    return this->Get(RANGE_NOISE_FACTOR, range > 52, std::nan(""));
  }

  int Faulty = RANGE_ERROR;

private:
  double Get(int term, bool isFaulty, double value) const
  {
    return term == this->Faulty && isFaulty ? value : term == RANGE_NOISE_FACTOR ? 1.0 : 0.0;
  }
};

} // namespace

TEST_CASE("Scanner: error terms that are not finite end a run and are counted", "[Scanner]")
{
  // A window of 100 deg before a wall at 50 m: 1000 pulses of one ray, each a hit.
  Bench bench(MakeScene({ Wall(50, 1000) }));
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetVerticalAngleMin(-50);
  mirror->SetVerticalAngleMax(50);
  bench.Scanner->SetBeamDeflector(mirror);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  bench.Scanner->SetRangeAccuracy(1e-9);
  bench.Scanner->GenerateWaveformsOn();
  bench.Scanner->GeneratePulsesOn();
  std::vector<double> angles;
  for (vtkIdType i = 0; i < bench.Scanner->GetNumberOfPulses(); ++i)
  {
    double direction[3];
    angles.push_back(mirror->GetDirection(i, direction)
        ? vtkMath::RadiansFromDegrees(mirror->GetScanAngle(i))
        : std::nan(""));
  }
  vtkNew<FaultyErrors> errors;
  bench.Scanner->SetErrorModel(errors);
  const char* const names[] = { "GetRangeError()", "GetDeflectionError()", "GetHeadError()",
    "GetRangeNoiseFactor()" };
  for (int term = 0; term < vtkHeliosErrorModel::NUMBER_OF_TERMS; ++term)
  {
    const auto isFaulty = [term](double theta)
    {
      return term == vtkHeliosErrorModel::RANGE_NOISE_FACTOR ? 50 / std::cos(theta) > 52
                                                             : theta < -0.3;
    };
    const auto count = std::count_if(angles.begin(), angles.end(), isFaulty);
    const auto first = std::find_if(angles.begin(), angles.end(), isFaulty) - angles.begin();
    const auto fired = bench.Scanner->GetCount("pulsesFired");
    const std::string said = std::string(names[term]) +
      " of FaultyErrors is not finite, or beyond 1e9, for " + std::to_string(count) + " of ";
    const std::string place = " pulses, the first of them pulse " + std::to_string(first) + " at ";
    CAPTURE(said, place, fired);
    REQUIRE(count > 10);
    errors->Faulty = term;
    for (int threads : { 1, 2 })
    {
      vtkSMPTools::Initialize(threads);
      errors->Modified();
      bench.Run();
      CAPTURE(bench.Log->Errors);
      CHECK(bench.Log->HasError(said));
      CHECK(bench.Log->HasError(place));
      CHECK(bench.Scanner->GetOutput()->GetNumberOfPoints() == 0);
      CHECK(vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1))->GetNumberOfRows() == 0);
      bench.Log->Clear();
    }
    vtkSMPTools::Initialize(0);
  }
  errors->Faulty = vtkHeliosErrorModel::NUMBER_OF_TERMS;
  errors->Modified();
  CHECK(bench.Run()->GetNumberOfPoints() > 100);
  CHECK(bench.Log->Errors.empty());
}

TEST_CASE("Scanner: bad input is an error", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  const auto expect = [&bench](const char* message)
  {
    bench.Scanner->Update();
    CHECK(bench.Log->HasError(message));
    bench.Log->Clear();
  };
  SECTION("no deflector")
  {
    bench.Scanner->SetBeamDeflector(nullptr);
    expect("BeamDeflector is not set");
    CHECK(bench.Scanner->GetNumberOfPulses() == -1);
  }
  SECTION("no ray caster")
  {
    bench.Scanner->SetRayCaster(nullptr);
    expect("RayCaster, BeamSampler or EchoDetector is not set");
  }
  SECTION("minimum above maximum")
  {
    bench.Scanner->SetRangeMin(10);
    bench.Scanner->SetRangeMax(5);
    expect("is not greater than RangeMin");
  }
  SECTION("a head axis without direction")
  {
    bench.Scanner->SetHeadRotateAxis(0, 0, 0);
    expect("HeadRotateAxis has no direction");
  }
  SECTION("a scan without end")
  {
    bench.Scanner->SetDuration(-1);
    expect("the scan never ends");
  }
  SECTION("a head that turns away")
  {
    bench.Scanner->SetDuration(-1);
    bench.Scanner->SetHeadRotateStop(90);
    bench.Scanner->SetHeadRotateSpeed(-10);
    expect("the head never reaches its stop");
  }
  SECTION("an empty scene")
  {
    vtkNew<vtkPolyData> empty;
    bench.Scanner->SetInputData(0, empty);
    expect("the scene is empty");
  }
  SECTION("material ids without materials")
  {
    vtkNew<vtkIntArray> ids;
    ids->SetName(names::MaterialIds);
    ids->SetNumberOfValues(2);
    ids->FillValue(3);
    scene->GetCellData()->AddArray(ids);
    expect("has 1 materials");
  }
  SECTION("fewer normals than triangles")
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName(names::Normals);
    normals->SetNumberOfComponents(3);
    normals->InsertNextTuple3(0, 0, 1);
    scene->GetCellData()->AddArray(normals);
    expect("cell array Normals of the scene has 1 tuples of 3 for 2 triangles; expected one tuple "
           "of 3 each");
  }
  SECTION("a trajectory without points")
  {
    vtkNew<vtkPolyData> empty;
    bench.Scanner->SetInputData(1, empty);
    expect("the trajectory has no points");
  }
  SECTION("a trajectory with decreasing times")
  {
    vtkNew<vtkPolyData> path;
    path->DeepCopy(MakeWaypoints({ { 0, 0, 0 }, { 1, 0, 0 } }));
    vtkNew<vtkDoubleArray> times;
    times->SetName(names::GpsTime);
    times->InsertNextValue(5);
    times->InsertNextValue(4);
    path->GetPointData()->AddArray(times);
    bench.Scanner->SetInputData(1, path);
    expect("decrease at sample 1");
  }
}

TEST_CASE(
  "Scanner: an abort is reported without output, and the next update is complete", "[Scanner]")
{
  Bench bench(MakeScene({ Wall(50, 1000) }));
  bench.Scanner->SetDuration(1.0); // several batches of pulses
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  bench.Scanner->GenerateWaveformsOn();
  bench.Scanner->GeneratePulsesOn();
  int count = 0;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&count);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* counter, void*)
    {
      auto* scanner = static_cast<vtkAlgorithm*>(caller);
      scanner->SetAbortExecute(scanner->GetProgress() > 0.0);
      *static_cast<int*>(counter) += scanner->GetAbortExecute();
    });
  const unsigned long tag = bench.Scanner->AddObserver(vtkCommand::ProgressEvent, stop);
  CHECK(bench.Run()->GetNumberOfPoints() == 0);
  CHECK(count == 1 + helios::ReportsAfterAbort); // no batch after that
  CHECK(bench.Log->HasError("The scan was aborted at "));
  CHECK(bench.Log->HasError(" %; update again to complete it"));
  for (int port = 0; port < bench.Scanner->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = bench.Scanner->GetOutputDataObject(port);
    CHECK(output->GetNumberOfElements(vtkDataObject::POINT) == 0);
    CHECK(output->GetNumberOfElements(vtkDataObject::ROW) == 0);
  }

  bench.Log->Clear();
  bench.Scanner->RemoveObserver(tag);
  bench.Scanner->SetAbortExecute(0);
  bench.Scanner->Modified();
  CHECK(bench.Run()->GetNumberOfPoints() == 100000);
  CHECK(bench.Log->Errors.empty());
}

namespace
{

/// Aborts at one of a scanner's progress events; counts them before its first pulse.
struct EventsBeforePulses
{
  int Count = 0;
  int Last = VTK_INT_MAX;

  static void OnProgress(vtkObject* caller, unsigned long, void* self, void*)
  {
    auto* scanner = static_cast<vtkAlgorithm*>(caller);
    auto* events = static_cast<EventsBeforePulses*>(self);
    events->Count += scanner->GetProgress() == 0.0;
    scanner->SetAbortExecute(events->Count >= events->Last);
  }
};

/// A wave of n squares per side, above and below a height of 50 m.
vtkSmartPointer<vtkPolyData> MakeWave(int squares)
{
  auto scene = MakeScene({});
  for (int i = 0; i <= squares; ++i)
  {
    for (int j = 0; j <= squares; ++j)
    {
      scene->GetPoints()->InsertNextPoint(i - squares / 2.0, 50 + (i % 7) * 0.1, j - squares / 2.0);
    }
  }
  for (int i = 0; i < squares; ++i)
  {
    for (int j = 0; j < squares; ++j)
    {
      const vtkIdType a = i * (squares + 1) + j;
      scene->GetPolys()->InsertNextCell({ a, a + 1, a + squares + 1 });
      scene->GetPolys()->InsertNextCell({ a + 1, a + squares + 2, a + squares + 1 });
    }
  }
  return scene;
}

} // namespace

TEST_CASE("Scanner: can be aborted while the scene is prepared", "[Scanner]")
{
  for (int i = 0; i < vtkHeliosRayCasterFactory::GetNumberOfBackends(); ++i)
  {
    const std::string name = vtkHeliosRayCasterFactory::GetBackendName(i);
    Bench bench(MakeWave(200)); // 80,000 triangles
    const auto caster =
      vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create(name.c_str()));
    bench.Scanner->SetRayCaster(caster);
    bench.Scanner->SetSamplingToTolerance();
    EventsBeforePulses events;
    vtkNew<vtkCallbackCommand> stop;
    stop->SetClientData(&events);
    stop->SetCallback(EventsBeforePulses::OnProgress);
    bench.Scanner->AddObserver(vtkCommand::ProgressEvent, stop);
    REQUIRE(bench.Run()->GetNumberOfPoints() == 1000);
    const int all = events.Count;
    REQUIRE(all > 5);
    // The number of polls of Embree in this thread, not in others, differs from run to run.
    const int most = name == "embree" ? all / 4 : all;
    for (int last = 2; last < most; ++last)
    {
      CAPTURE(name, last, all);
      bench.Scanner->GetInputDataObject(0, 0)->Modified(); // to be rebuilt
      events = { 0, last };
      bench.Log->Clear();
      CHECK(bench.Run()->GetNumberOfPoints() == 0);
      CHECK(bench.Log->HasError("The scan was aborted at 0 %; update again to complete it"));
    }
    events = { 0, VTK_INT_MAX };
    bench.Log->Clear();
    bench.Scanner->Modified(); // the scene is unchanged
    CHECK(bench.Run()->GetNumberOfPoints() == 1000);
    CHECK(bench.Log->Errors.empty());
  }
}
