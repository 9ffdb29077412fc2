// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBatchWorker.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScanner.h"

#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr std::chrono::milliseconds ProgressInterval(100);

} // namespace

//------------------------------------------------------------------------------
BatchWorker::BatchWorker(vtkSmartPointer<vtkHeliosScanner> scanner)
  : Scanner(std::move(scanner))
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  this->Place->SetPoints(points);
  this->Orientation->SetName(names::Orientation);
  this->Orientation->SetNumberOfComponents(4);
  const double upright[4] = { 1.0, 0.0, 0.0, 0.0 };
  this->Orientation->InsertNextTuple(upright);
  this->Place->GetPointData()->AddArray(this->Orientation);
  this->Scanner->SetMountPosition(0.0, 0.0, 0.0);
  this->Scanner->SetMountOrientation(1.0, 0.0, 0.0, 0.0);
  this->Scanner->SetPlatformNoise(nullptr);
  this->Scanner->SetInputDataObject(1, this->Place);
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(&BatchWorker::StoreError);
  this->Scanner->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  this->Scanner->AddObserver(vtkCommand::WarningEvent, this->Observer);
  this->Scanner->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  this->Watch->SetClientData(this);
  this->Watch->SetCallback(&BatchWorker::HandleProgress);
  this->Scanner->AddObserver(vtkCommand::ProgressEvent, this->Watch);
  this->Pulses = std::max<vtkIdType>(0, this->Scanner->GetNumberOfPulses());
}

//------------------------------------------------------------------------------
BatchWorker::~BatchWorker()
{
  this->Scanner->RemoveObserver(this->Observer);
  this->Scanner->RemoveObserver(this->Watch);
  this->Scanner->GetExecutive()->RemoveObserver(this->Observer);
}

//------------------------------------------------------------------------------
void BatchWorker::StoreError(vtkObject*, unsigned long event, void* self, void* data)
{
  auto* worker = static_cast<BatchWorker*>(self);
  if (event == vtkCommand::ErrorEvent && worker->Error.empty())
  {
    worker->Error = data ? static_cast<const char*>(data) : "it cannot be run";
  }
}

//------------------------------------------------------------------------------
void BatchWorker::HandleProgress(vtkObject* caller, unsigned long, void* self, void*)
{
  auto* worker = static_cast<BatchWorker*>(self);
  auto* scanner = static_cast<vtkAlgorithm*>(caller);
  const auto now = std::chrono::steady_clock::now();
  if (worker->OnProgress && now - worker->LastProgress > ProgressInterval)
  {
    worker->LastProgress = now;
    worker->IsStopped = !worker->OnProgress(scanner->GetProgress());
    scanner->SetAbortExecute(worker->IsStopped ? 1 : 0);
  }
}

//------------------------------------------------------------------------------
Status BatchWorker::Run(
  vtkPolyData* scene, const double position[3], const double orientation[4], vtkIdType firstPulse)
{
  this->Error.clear();
  this->IsStopped = false;
  this->Scanner->SetAbortExecute(0);
  if (scene != this->Scene)
  {
    this->Scanner->SetInputDataObject(0, scene);
    this->Scene = scene;
  }
  this->Place->GetPoints()->SetPoint(0, position);
  this->Place->GetPoints()->Modified();
  this->Orientation->SetTuple(0, orientation);
  this->Orientation->Modified();
  this->Place->Modified();
  this->Scanner->SetFirstPulseId(firstPulse);
  this->Scanner->Update();
  return this->Error.empty() ? Status() : Status::Error(this->Error);
}

//------------------------------------------------------------------------------
vtkPolyData* BatchWorker::GetEchoes() const
{
  return this->Scanner->GetOutput();
}

} // namespace helios
