// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The pipelines of the parts of a scene: reader, material, reprojection, mesh repair, transform.

#ifndef heliosPartPipelines_h
#define heliosPartPipelines_h

#include "heliosFilterWatch.h"
#include "heliosFrameList.h"
#include "heliosSceneReaders.h"
#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkHeliosSceneTransform;
class vtkImageData;

namespace helios
{

class Messages;

/// A mesh used by several parts is read once. The pipelines are kept, so that a part that stays is
/// not read again.
class VTKHELIOSSCANNERSURVEY_EXPORT PartPipelines
{
public:
  explicit PartPipelines(Messages& log, vtkIdType seed = 0)
    : Log(log)
    , Watch(log)
    , Seed(seed)
  {
  }

  /// Returns the last filter of a part before it is placed; a part that is there already has a kept
  /// one.
  vtkAlgorithm* GetSource(const PartData& part);

  /// Returns the filter that places a part, likewise.
  vtkSmartPointer<vtkHeliosSceneTransform> Make(const PartData& part);

  /// Sets whether parts that differ only in place, name and motion share their filters but the
  /// last, and rasters of heights stay ones; before GetSource(). Default: false.
  void SetSharing(bool isOn) { this->IsSharing = isOn; }

  /// Sets whether meshes are read with their colours; before GetSource(). Default: false.
  void SetColors(bool areRead) { this->HasColors = areRead; }

  /// Returns whether a part is a raster of heights that stays one.
  bool IsRaster(const PartData& part) const;

  /// Returns, after ReadFiles(), whether all rasters can stay rasters. The parts of other rasters
  /// are made of meshes from then on, by GetSource().
  bool CheckRasters();

  /// Returns the frames of parts after their files were read, in the coordinates of GetSource().
  const FrameSets& GetFrames() const { return this->Frames; }

  /// Releases the pipelines of all other parts.
  void RemoveOthers(const std::vector<const PartData*>& parts);

  /// Returns the grids of a turbid part after its files were read, with its materials and filters
  /// applied.
  std::vector<vtkSmartPointer<vtkImageData>> GetGrids(
    const PartData& part, const std::string& name, vtkHeliosSceneTransform* place);

  /// Reads all files; false after an error or if stopped.
  bool ReadFiles(const StepCallback& onStep);

  /// Returns the files that the filters of all parts have opened.
  InputFiles GetInputs() const { return this->Watch.GetInputs(); }

  /// See FilterWatch.
  void SetOnProgress(const StepCallback* onProgress) { this->Watch.SetOnProgress(onProgress); }
  bool WasStopped() const { return this->Watch.WasStopped(); }

private:
  using Filter = vtkSmartPointer<vtkAlgorithm>;

  Filter GetPipeline(const PartData& part);
  Filter MakePipeline(const PartData& part);
  Filter MakeRasterReader(const PartData& part);
  Filter MakeMesh(const PartData& part);
  Filter MakeVoxels(const PartData& part);
  Filter MakeLasReaders(const PartData& part);
  Filter GetReader(const PartData& part, const std::string& file);
  Filter MakeCubes(const PartData& part, const std::string& file);
  Filter AddMaterial(const MaterialData& material, Filter before);
  Filter AddClass(const PartData& part, Filter before);
  Filter AddCrs(const PartData& part, Filter before);
  Filter AddMeshCare(const PartData& part, Filter before);
  Filter Connect(Filter filter, const Filter& before);

  Messages& Log;
  FilterWatch Watch;
  vtkIdType Seed;
  std::map<const PartData*, Filter> Sources;
  std::map<const PartData*, vtkSmartPointer<vtkHeliosSceneTransform>> Places;
  std::map<const PartData*, std::vector<Filter>> GridReaders; // readers of turbid parts
  bool IsSharing = false;
  bool HasColors = false;
  std::map<std::string, Filter> Shared; // the filters before the place, by what they depend on
  std::map<std::string, Filter> RasterReaders; // by file
  std::set<std::string> NoRasters;             // files that can only be meshes
  std::set<const PartData*> RasterParts;       // parts whose places are over rasters
  std::string Where;                           // the current part
  std::map<SceneReaderKey, Filter> MeshReaders;
  FrameSets Frames{ this->Watch, this->Log };
  std::vector<std::pair<std::string, Filter>> Readers; // all, with the files they read
};

} // namespace helios

#endif
