// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scanner that makes scans of a batch, one after the other.

#ifndef heliosBatchWorker_h
#define heliosBatchWorker_h

#include "heliosStatus.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

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

  /// Runs a scan of a scene from a position [m] and orientation (unit quaternion w, x, y, z); its
  /// echoes are in GetEchoes(), until the next one.
  Status Run(vtkPolyData* scene, const double position[3], const double orientation[4],
    vtkIdType firstPulse);

  vtkPolyData* GetEchoes() const;

private:
  static void StoreError(vtkObject* caller, unsigned long event, void* self, void* data);

  vtkSmartPointer<vtkHeliosScanner> Scanner;
  vtkNew<vtkPolyData> Place; ///< a trajectory of one sample
  vtkNew<vtkDoubleArray> Orientation;
  vtkNew<vtkCallbackCommand> Observer;
  vtkPolyData* Scene = nullptr; ///< scanned last
  vtkIdType Pulses = 0;
  std::string Error; ///< first message of the scan
};

} // namespace helios

#endif
