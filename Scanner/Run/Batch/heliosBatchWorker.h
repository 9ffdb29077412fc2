// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scanner that makes scans of a batch, one after the other.

#ifndef heliosBatchWorker_h
#define heliosBatchWorker_h

#include "heliosStatus.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <chrono>
#include <functional>
#include <string>
#include <utility>

class vtkCallbackCommand;
class vtkDoubleArray;
class vtkHeliosScanner;

namespace helios
{

class BatchWorker
{
public:
  /// Takes a scanner that nothing else uses; its mount becomes the pose of a scan.
  explicit BatchWorker(vtkSmartPointer<vtkHeliosScanner> scanner);
  ~BatchWorker();
  BatchWorker(const BatchWorker&) = delete;
  void operator=(const BatchWorker&) = delete;

  /// Returns the pulses of a scan.
  vtkIdType GetNumberOfPulses() const { return this->Pulses; }

  /// Sets what is called while a scan is made, at most ten times a second, with the fraction done;
  /// false stops the scan.
  void SetOnProgress(std::function<bool(double)> onProgress)
  {
    this->OnProgress = std::move(onProgress);
  }

  /// Runs a scan of a scene from a position [m] and orientation (unit quaternion w, x, y, z); its
  /// echoes are in GetEchoes(), until the next one.
  Status Run(vtkPolyData* scene, const double position[3], const double orientation[4],
    vtkIdType firstPulse);

  /// Returns whether the last scan was stopped.
  bool WasStopped() const { return this->IsStopped; }

  vtkPolyData* GetEchoes() const;

private:
  static void HandleProgress(vtkObject* caller, unsigned long event, void* self, void* data);
  static void StoreError(vtkObject* caller, unsigned long event, void* self, void* data);

  vtkSmartPointer<vtkHeliosScanner> Scanner;
  vtkNew<vtkPolyData> Place; ///< a trajectory of one sample
  vtkNew<vtkDoubleArray> Orientation;
  vtkNew<vtkCallbackCommand> Observer;
  vtkNew<vtkCallbackCommand> Watch;
  std::function<bool(double)> OnProgress;
  std::chrono::steady_clock::time_point LastProgress;
  bool IsStopped = false;
  vtkPolyData* Scene = nullptr; ///< scanned last
  vtkIdType Pulses = 0;
  std::string Error; ///< first message of the scan
};

} // namespace helios

#endif
