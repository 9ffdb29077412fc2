// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The frames of a part that deforms, and their readers.

#ifndef heliosFrameList_h
#define heliosFrameList_h

#include "heliosFilterWatch.h"
#include "heliosMeshFrames.h"
#include "heliosStatus.h"
#include "heliosSurveyData.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkPolyData;
class vtkPolyDataAlgorithm;

namespace helios
{

/// Frames in their order: numbered files, or an animation of glTF at equal steps from its start to its end,
/// no longer than those of the rate. The part must outlive it.
class FrameList
{
public:
  explicit FrameList(const PartData& part);

  /// Returns the number of frames; of an animation, once the first is added.
  std::size_t GetCount() const { return this->Count; }

  /// Returns the frames per second, likewise.
  double GetRate() const { return this->Rate; }

  /// Returns the file and time of a frame.
  std::string GetName(std::size_t frame) const;

  /// Returns the reader of a frame, which may be that of the frame before.
  vtkSmartPointer<vtkPolyDataAlgorithm> GetReader(std::size_t frame);

  /// Adds the next frame, as its reader and filters made it; an error if its faces are not those of the
  /// first.
  Status Add(vtkAlgorithm* reader, vtkPolyData* mesh, MeshFrames& frames);

private:
  /// The faces of a file.
  struct Faces
  {
    vtkIdType Points = 0;
    vtkIdType Count = 0;
    vtkTypeUInt64 Hash = 0;
  };

  void CountFrames();

  const PartData& Part;
  std::size_t Count;
  double Rate;
  vtkSmartPointer<vtkPolyDataAlgorithm> Reader; ///< reader of all frames; null: each has its own
  Faces First;
};

/// The frames of the parts of a scene. Parts with the same files share them.
class FrameSets
{
public:
  using Filter = vtkSmartPointer<vtkAlgorithm>;

  FrameSets(FilterWatch& watch, Messages& log)
    : Watch(watch)
    , Log(log)
  {
  }

  /// Reads the frames of a part, unless they are there; addFilters() returns the last filter of a frame
  /// by its reader. False after an error, or if stopped.
  bool Read(const PartData& part, const StepCallback& onStep,
    const std::function<Filter(const Filter& reader)>& addFilters);

  /// Returns the frames of a part, and their rate [1/s]; null: it does not deform.
  std::shared_ptr<const MeshFrames> Get(const PartData& part, double& rate) const;

  /// Releases the frames of other meshes than these, by GetMeshKey(); adds the readers of the others.
  void RemoveOthers(const std::set<std::string>& meshes, std::set<vtkAlgorithm*>& used);

private:
  struct Set
  {
    std::shared_ptr<MeshFrames> Frames;
    double Rate = 0.0;           ///< frames per second
    std::vector<Filter> Readers; ///< with their inputs
  };

  bool Add(
    const PartData& part, FrameList& list, const Filter& reader, const Filter& last, Set& set);

  FilterWatch& Watch;
  Messages& Log;
  std::map<std::string, Set> Sets; // by mesh key
};

} // namespace helios

#endif
