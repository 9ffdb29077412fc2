// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The pipelines that the parts of a scene come out of: reader, material, reprojection, mesh care, transform.

#ifndef heliosPartPipelines_h
#define heliosPartPipelines_h

#include "heliosSurveyData.h"

#include <vtkSmartPointer.h>

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkHeliosSceneTransform;
class vtkImageData;
class vtkObject;

namespace helios
{

class Messages;

/// Called before each step of something long with what it does; false stops it.
using StepCallback = std::function<bool(const std::string& step)>;

/// A mesh that several parts have is read once.
class PartPipelines
{
public:
  explicit PartPipelines(Messages& log, vtkIdType seed = 0)
    : Log(log)
    , Seed(seed)
  {
  }

  /// The last filter of a part.
  vtkSmartPointer<vtkHeliosSceneTransform> Make(const PartData& part);

  /// The grids of a turbid part after its files were read, of its materials and where a filter puts it.
  std::vector<vtkSmartPointer<vtkImageData>> GetGrids(
    const PartData& part, vtkHeliosSceneTransform* place);

  /// Reads all files; false after an error or where it was stopped.
  bool ReadFiles(const StepCallback& onStep);

  /// Those that the readers before a filter have, a mesh that comes in twice counted twice.
  static double CountTriangles(vtkAlgorithm* filter);

  /// Called with the step at hand whenever a filter makes progress; where it returns false the filter
  /// is stopped, and what it says of that is not reported. Null: nothing is called.
  void SetOnProgress(const StepCallback* onProgress);
  bool WasStopped() const { return this->IsStopped; }

private:
  using Filter = vtkSmartPointer<vtkAlgorithm>;

  Filter MakeMesh(const PartData& part);
  Filter MakeVoxels(const PartData& part);
  Filter GetReader(const PartData& part, const std::string& file);
  Filter MakeCubes(const PartData& part, const std::string& file);
  Filter AddMaterial(const MaterialData& material, Filter before);
  Filter AddCrs(const PartData& part, Filter before);
  Filter AddMeshCare(const PartData& part, Filter before);
  Filter Connect(Filter filter, const Filter& before);
  void Listen(vtkAlgorithm* filter, const std::string& where);
  void HandleProgress(vtkObject* caller, unsigned long, void*);

  Messages& Log;
  vtkIdType Seed;
  std::map<const PartData*, std::vector<Filter>> GridReaders; // of turbid parts
  std::string Where;                                          // the part at hand
  std::string Step;                                           // what is done
  const StepCallback* OnProgress = nullptr;
  bool IsStopped = false;
  std::chrono::steady_clock::time_point LastProgress{};
  std::map<std::pair<std::string, bool>, Filter> MeshReaders; // by file and whether y is up
  std::vector<std::pair<std::string, Filter>> Readers;        // all, with what they read
};

} // namespace helios

#endif
