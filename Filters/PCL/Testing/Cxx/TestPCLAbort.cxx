// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Long work reports repeatedly, and each report may stop it. By counts of reports, not by time.
#include "heliosAborts.h"
#include "heliosPclTesting.h"
#include "vtkHeliosPCLClusters.h"
#include "vtkHeliosPCLGroundFilter.h"
#include "vtkHeliosPCLNormals.h"
#include "vtkHeliosPCLOutlierRemoval.h"
#include "vtkHeliosPCLPlanes.h"
#include "vtkHeliosPCLRegistration.h"
#include "vtkHeliosPCLVoxelGrid.h"

#include <vtkCallbackCommand.h>

#include <catch2/catch.hpp>

namespace
{

/// Counts reports, and aborts at one of them.
struct Aborter
{
  int Reports = 0;
  int Last = -1;
  bool IsGrowing = true;
  double Progress = 0.0;
  vtkNew<vtkCallbackCommand> Command;

  explicit Aborter(vtkAlgorithm* filter)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(&Aborter::Hear);
    filter->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }
  static void Hear(vtkObject* caller, unsigned long, void* data, void*)
  {
    auto* self = static_cast<Aborter*>(data);
    auto* filter = vtkAlgorithm::SafeDownCast(caller);
    self->IsGrowing = self->IsGrowing && filter->GetProgress() >= self->Progress;
    self->Progress = filter->GetProgress();
    if (++self->Reports == self->Last)
    {
      filter->SetAbortExecute(1);
    }
  }
};

/// Makes rough ground of 300 x 300 m, partly dense.
helios::Triples MakeGround(int count)
{
  helios::Uniform uniform(6);
  helios::Triples points;
  for (int i = 0; i < count; ++i)
  {
    const double reach = i % 2 ? 150.0 : 2.0;
    points.push_back(helios::Utm +
      helios::Triple{ uniform(-reach, reach), uniform(-reach, reach), 0.2 * uniform.Normal() });
  }
  return points;
}

template <typename FilterT>
void CheckAborts(helios::Filtering<FilterT>& run, int least)
{
  Aborter whole(run.Filter);
  REQUIRE(run.Run());
  CHECK(whole.Reports >= least); // the first and the last are not from the library part
  CHECK(whole.IsGrowing);
  CHECK(run.Count() > 0);
  run.Filter->RemoveObserver(whole.Command);
  for (const int last : { 1, 2, least / 2, least - 2 })
  {
    INFO("report " << last << " of " << whole.Reports);
    Aborter aborter(run.Filter);
    aborter.Last = last;
    CHECK(run.FailsWith("The work was aborted at "));
    CHECK(run.Log->HasError(" %; update again to complete it"));
    CHECK(aborter.Reports <= last + 1 + helios::ReportsAfterAbort); // one by the executive
    CHECK(run.Output()->GetPointData()->GetNumberOfArrays() == 0);
    run.Filter->RemoveObserver(aborter.Command);
    run.Filter->SetAbortExecute(0);
  }
  REQUIRE(run.Run()); // an abort leaves no state
}

} // namespace

TEST_CASE("PCLClusters: stops at every progress report", "[PCLClusters]")
{
  helios::Filtering<vtkHeliosPCLClusters> run(MakeGround(200000));
  run.Filter->SetTolerance(0.2);
  CheckAborts(run, 8);
}

TEST_CASE("PCLNormals: stops at every progress report", "[PCLNormals]")
{
  helios::Filtering<vtkHeliosPCLNormals> run(MakeGround(60000));
  CheckAborts(run, 16);
}

TEST_CASE("PCLOutlierRemoval: stops at every progress report", "[PCLOutlierRemoval]")
{
  helios::Filtering<vtkHeliosPCLOutlierRemoval> run(MakeGround(60000));
  CheckAborts(run, 16);
}

TEST_CASE("PCLGroundFilter: stops at every progress report", "[PCLGroundFilter]")
{
  helios::Filtering<vtkHeliosPCLGroundFilter> run(MakeGround(60000));
  CheckAborts(run, 40);
}

TEST_CASE("PCLRegistration: stops at every progress report", "[PCLRegistration]")
{
  helios::Triples moving = MakeGround(30000);
  for (std::size_t i = 0; i < moving.size(); ++i) // three directions
  {
    moving[i] = moving[i] + helios::Triple{ -helios::Utm[0], -helios::Utm[1], -helios::Utm[2] };
    std::swap(moving[i][2], moving[i][i / 2 % 3]);
  }
  helios::Triples fixed = moving;
  for (helios::Triple& point : moving)
  {
    point = point + helios::Triple{ 0.01, -0.02, 0.01 };
  }
  helios::Filtering<vtkHeliosPCLRegistration> run(fixed);
  run.Filter->SetInputDataObject(1, helios::MakeCloud(moving));
  CheckAborts(run, 24);
}

TEST_CASE("PCLPlanes: stops at every progress report", "[PCLPlanes]")
{
  helios::Triples points;
  helios::Uniform uniform(8);
  for (int i = 0; i < 60000; ++i) // ten storeys
  {
    points.push_back(helios::Utm + helios::Triple{ uniform(0, 9), uniform(0, 9), 3.0 * (i % 10) });
  }
  helios::Filtering<vtkHeliosPCLPlanes> run(points);
  CheckAborts(run, 10);
}

TEST_CASE("PCLVoxelGrid: stops at every progress report", "[PCLVoxelGrid]")
{
  helios::Filtering<vtkHeliosPCLVoxelGrid> run(MakeGround(60000));
  run.Filter->SetVoxelSize(1.0);
  CheckAborts(run, 4);
}
