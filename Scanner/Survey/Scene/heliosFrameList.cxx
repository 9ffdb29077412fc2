// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFrameList.h"

#include "heliosMeshKey.h"
#include "heliosMessages.h"
#include "heliosSceneReaders.h"
#include "vtkHeliosGLTFSceneReader.h"
#include "vtkHeliosSceneReader.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace helios
{

namespace
{

std::string FormatBoth(vtkIdType a, vtkIdType b, const char* what)
{
  return std::to_string(a) + (a == b ? "" : " and " + std::to_string(b)) + " " + what;
}

std::string GetFileName(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}

/// Drops the warnings of a filter from now on.
void IgnoreWarnings(vtkAlgorithm* filter)
{
  vtkNew<vtkCallbackCommand> nothing;
  filter->RemoveObservers(vtkCommand::WarningEvent);
  filter->AddObserver(vtkCommand::WarningEvent, nothing);
}

} // namespace

//------------------------------------------------------------------------------
FrameList::FrameList(const PartData& part)
  : Part(part)
  , Count(part.Type == Loader::Gltf ? 1 : part.Files.size())
  , Rate(part.Frames.Rate)
  , Reader(part.Type == Loader::Gltf ? MakeSceneReader(part, part.Files.front()) : nullptr)
{
}

//------------------------------------------------------------------------------
std::string FrameList::GetName(std::size_t frame) const
{
  MessageBuilder name;
  name << this->Part.Files[this->Reader ? 0 : frame];
  if (this->Reader)
  {
    name << " at " << static_cast<double>(frame) / this->Rate << " s";
  }
  return name.str();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyDataAlgorithm> FrameList::GetReader(std::size_t frame)
{
  if (auto* animated = vtkHeliosGLTFSceneReader::SafeDownCast(this->Reader))
  {
    const double time = static_cast<double>(frame) / this->Rate;
    animated->SetAnimationTime(
      frame + 1 == this->Count ? std::max(time, animated->GetAnimationDuration()) : time);
    return this->Reader;
  }
  return MakeSceneReader(this->Part, this->Part.Files[frame]);
}

//------------------------------------------------------------------------------
/// Divides an animation into equal steps.
void FrameList::CountFrames()
{
  auto* animated = vtkHeliosGLTFSceneReader::SafeDownCast(this->Reader);
  const double duration = animated ? animated->GetAnimationDuration() : 0.0;
  if (duration > 0.0)
  {
    const double steps = std::max(1.0, std::ceil(duration * this->Rate - 1e-9));
    this->Count = static_cast<std::size_t>(steps) + 1;
    this->Rate = steps / duration;
  }
}

//------------------------------------------------------------------------------
Status FrameList::Add(vtkAlgorithm* reader, vtkPolyData* mesh, MeshFrames& frames)
{
  auto* file = vtkHeliosSceneReader::SafeDownCast(reader);
  const Faces faces{ mesh->GetNumberOfPoints(), file->GetNumberOfFaces(), file->GetFaceHash() };
  const std::string name = this->GetName(frames.GetCount());
  if (mesh->GetNumberOfPolys() == 0)
  {
    return Status::Error(name + " has no triangles; give frames with faces");
  }
  if (frames.GetCount() == 0)
  {
    this->First = faces;
    this->CountFrames();
  }
  if (faces.Points != this->First.Points || faces.Count != this->First.Count ||
    faces.Hash != this->First.Hash)
  {
    const bool areOther = faces.Count == this->First.Count && faces.Points == this->First.Points;
    return Status::Error("frames " + GetFileName(this->Part.Files.front()) + " and " +
      GetFileName(name) + " are no frames of one mesh: they have " +
      FormatBoth(this->First.Points, faces.Points, "vertices") + ", " +
      FormatBoth(this->First.Count, faces.Count, "faces") +
      (areOther ? " with other vertices" : "") +
      "; write all frames with the same vertices and faces, in the same order");
  }
  vtkNew<vtkPolyData> frame;
  frame->SetPoints(mesh->GetPoints());
  frame->SetPolys(frames.GetCount() == 0 ? mesh->GetPolys() : frames.GetFrame(0)->GetPolys());
  frames.Add(frame);
  return {};
}

//------------------------------------------------------------------------------
bool FrameSets::Read(const PartData& part, const StepCallback& onStep,
  const std::function<Filter(const Filter& reader)>& addFilters)
{
  Set& known = this->Sets[GetMeshKey(part)];
  if (known.Frames)
  {
    return true;
  }
  Set set;
  set.Frames = std::make_shared<MeshFrames>();
  FrameList list(part);
  for (std::size_t i = 0; i < list.GetCount(); ++i)
  {
    this->Watch.BeginStep("reading " + list.GetName(i));
    if (this->Watch.WasStopped() || !onStep(this->Watch.GetStep()))
    {
      return false;
    }
    const Filter reader = list.GetReader(i);
    if (set.Readers.empty() || reader != set.Readers.back())
    {
      this->Watch.Add(reader, part.Where);
      IgnoreWarnings(reader); // the reader of the part has those of the first frame
      set.Readers.push_back(reader);
    }
    if (!this->Add(part, list, reader, addFilters(reader), set))
    {
      return false;
    }
  }
  set.Rate = list.GetRate();
  known = set;
  return true;
}

//------------------------------------------------------------------------------
/// Adds the next frame; false after an error.
bool FrameSets::Add(
  const PartData& part, FrameList& list, const Filter& reader, const Filter& last, Set& set)
{
  last->Update();
  auto* mesh = vtkPolyData::SafeDownCast(last->GetOutputDataObject(0));
  const Status status = this->Log.HasError() ? Status() : list.Add(reader, mesh, *set.Frames);
  if (!status.IsOk())
  {
    this->Log.Error(part.Frames.Where + ": part " + part.Name + ": " + status.Message());
  }
  mesh->ReleaseData();
  reader->GetOutputDataObject(0)->ReleaseData();
  return !this->Log.HasError();
}

//------------------------------------------------------------------------------
std::shared_ptr<const MeshFrames> FrameSets::Get(const PartData& part, double& rate) const
{
  const auto set = part.Frames.IsGiven() ? this->Sets.find(GetMeshKey(part)) : this->Sets.end();
  if (set == this->Sets.end())
  {
    return nullptr;
  }
  rate = set->second.Rate;
  return set->second.Frames;
}

//------------------------------------------------------------------------------
void FrameSets::RemoveOthers(const std::set<std::string>& meshes, std::set<vtkAlgorithm*>& used)
{
  for (auto set = this->Sets.begin(); set != this->Sets.end();)
  {
    if (meshes.count(set->first) == 0)
    {
      set = this->Sets.erase(set);
      continue;
    }
    used.insert(set->second.Readers.begin(), set->second.Readers.end());
    ++set;
  }
}

} // namespace helios
