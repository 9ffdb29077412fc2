// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosMeshSimplify.h"

#include "heliosMeshPatches.h"
#include "heliosPatchSimplifier.h"
#include "heliosSceneSubset.h"
#include "heliosStatus.h"
#include "heliosStopCheck.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosMeshRepair.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <OpenMesh/Core/System/omstream.hh>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeliosMeshSimplify);

namespace names = vtkHeliosArrayNames;

namespace
{

/// Silences OpenMesh's reports of non-manifold faces on stderr during its lifetime.
class Silence
{
public:
  Silence()
    : WasEnabled(omerr().is_enabled())
  {
    omerr().disable();
  }
  ~Silence()
  {
    if (this->WasEnabled)
    {
      omerr().enable();
    }
  }
  Silence(const Silence&) = delete;
  void operator=(const Silence&) = delete;

private:
  bool WasEnabled;
};

std::vector<int> GetIds(vtkPolyData* scene, const char* name)
{
  vtkDataArray* ids = scene->GetCellData()->GetArray(name);
  std::vector<int> values(static_cast<std::size_t>(scene->GetNumberOfCells()), 0);
  for (std::size_t i = 0; ids && i < values.size(); ++i)
  {
    values[i] = static_cast<int>(ids->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return values;
}

helios::PatchSource MakeSource(vtkPolyData* scene, const helios::TriangleMesh& mesh)
{
  return { mesh.GetPoints(), mesh.GetNumberOfPoints(),
    { mesh.GetCorners(), mesh.GetCorners() + 3 * mesh.GetNumberOfTriangles() },
    GetIds(scene, names::PartIds), GetIds(scene, names::MaterialIds) };
}

} // namespace

//------------------------------------------------------------------------------
/// Simplifies the patches of a scene in batches.
class vtkHeliosMeshSimplify::Run
{
public:
  Run(vtkHeliosMeshSimplify* self, helios::PatchSource& source)
    : Self(self)
    , Source(source)
    , Check([this]() { return this->Report(); })
    , Patches(source, this->Check)
    , IsKept(source.Parts.size(), 0)
    , Results(this->Patches.GetNumberOfPatches())
  {
    for (const vtkIdType triangle : this->Patches.GetFixedTriangles())
    {
      this->IsKept[static_cast<std::size_t>(triangle)] = 1;
    }
    this->Corners = source.Corners;
  }

  /// Throws helios::Stopped if the stop check returns true.
  void Execute()
  {
    const std::size_t count = this->Results.size();
    std::size_t begin = 0;
    for (; begin < count && this->Patches.GetNumberOfTriangles(begin) >= Large; ++begin)
    {
      this->Simplify(begin, this->Check);
    }
    while (begin < count)
    {
      this->Check.Poll();
      std::size_t end = begin; // a batch of about one large patch
      for (vtkIdType size = 0; end < count && size < 4 * Large; ++end)
      {
        size += this->Patches.GetNumberOfTriangles(end);
      }
      vtkSMPTools::For(static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end), 1,
        [this](vtkIdType first, vtkIdType last)
        {
          helios::StopCheck never([]() { return false; });
          for (; first < last; ++first)
          {
            this->Simplify(static_cast<std::size_t>(first), never);
          }
        });
      begin = end;
    }
    this->Check.Poll();
  }

  void Finish(vtkPolyData* scene, vtkPolyData* output)
  {
    this->Self->NumberOfRejectedTriangles = this->Patches.GetNumberOfNonManifoldTriangles();
    this->Self->NumberOfPatches = static_cast<vtkIdType>(this->Results.size());
    for (const Summary& result : this->Results)
    {
      this->Self->VerifiedDistance = std::max(this->Self->VerifiedDistance, result.Distance);
      this->Self->NumberOfUntouchedPatches += result.IsUntouched;
      this->Self->NumberOfRejectedTriangles += result.Rejected;
    }
    std::vector<vtkIdType> cells;
    std::vector<vtkTypeInt32> corners;
    for (std::size_t i = 0; i < this->IsKept.size(); ++i)
    {
      if (this->IsKept[i])
      {
        cells.push_back(static_cast<vtkIdType>(i));
        corners.insert(corners.end(), &this->Corners[3 * i], &this->Corners[3 * i] + 3);
      }
    }
    helios::ExtractTriangles(scene, cells, corners, output);
    if (cells.size() < this->IsKept.size())
    {
      output->GetCellData()->RemoveArray(names::Normals);
    }
  }

private:
  static constexpr vtkIdType Large = 50000; ///< triangles of a patch that uses all threads

  struct Summary
  {
    double Distance = 0.0;
    bool IsUntouched = false;
    vtkIdType Rejected = 0;
  };

  /// Reports progress; returns whether to stop.
  bool Report()
  {
    this->Self->UpdateProgress(
      0.2 + 0.7 * static_cast<double>(this->Done) / static_cast<double>(this->Source.Parts.size()));
    return this->Self->GetAbortExecute() != 0;
  }

  void Simplify(std::size_t index, helios::StopCheck& check)
  {
    const helios::Patch patch = this->Patches.MakePatch(index, check);
    const helios::SimplifiedPatch result =
      helios::Simplify(patch, this->Self->MaximumDistance, check);
    this->Results[index] = { result.Distance, result.IsUntouched, result.Mesh.Rejected };
    for (std::size_t i = 0; i < result.Mesh.Triangles.size(); ++i)
    {
      const vtkIdType cell = patch.Cells[static_cast<std::size_t>(result.Mesh.Triangles[i])];
      this->IsKept[static_cast<std::size_t>(cell)] = 1;
      std::transform(&result.Mesh.Corners[3 * i], &result.Mesh.Corners[3 * i] + 3,
        &this->Corners[3 * static_cast<std::size_t>(cell)],
        [&patch](vtkTypeInt32 corner) { return patch.PointIds[corner]; });
    }
    this->Done += static_cast<vtkIdType>(patch.Cells.size());
  }

  vtkHeliosMeshSimplify* Self;
  const helios::PatchSource& Source;
  std::atomic<vtkIdType> Done{ 0 }; ///< triangles
  helios::StopCheck Check;
  helios::MeshPatches Patches;
  std::vector<unsigned char> IsKept;
  std::vector<vtkTypeInt32> Corners;
  std::vector<Summary> Results;
};

//------------------------------------------------------------------------------
bool vtkHeliosMeshSimplify::Check(vtkPolyData* input)
{
  if (!std::isfinite(this->MaximumDistance))
  {
    vtkErrorMacro(<< "MaximumDistance is " << this->MaximumDistance
                  << "; set a finite length of at least 0 m");
    return false;
  }
  helios::TriangleMesh mesh;
  helios::Status text = input->GetNumberOfCells() > 0 ? mesh.Set(input) : helios::Status();
  text = text.IsOk() ? helios::FindShortArray(input) : text;
  if (!text.IsOk())
  {
    vtkErrorMacro(<< text.Message());
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosMeshSimplify::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->VerifiedDistance = 0.0;
  this->NumberOfDroppedTriangles = 0;
  this->NumberOfRejectedTriangles = 0;
  this->NumberOfPatches = 0;
  this->NumberOfUntouchedPatches = 0;
  if (!this->Check(input))
  {
    return 0;
  }
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(input);
  repair->MergePointsOn();
  repair->AddObserver(vtkCommand::ProgressEvent, this, &vtkHeliosMeshSimplify::Follow);
  repair->AddObserver(vtkCommand::ErrorEvent, this, &vtkHeliosMeshSimplify::Follow);
  repair->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &vtkHeliosMeshSimplify::Follow);
  repair->Update();
  if (this->GetAbortExecute())
  {
    return this->Abort();
  }
  vtkPolyData* scene = repair->GetOutput();
  this->NumberOfDroppedTriangles = input->GetNumberOfCells() - scene->GetNumberOfCells();
  this->UpdateProgress(0.1);
  if (scene->GetNumberOfCells() == 0)
  {
    output->ShallowCopy(scene);
    return 1;
  }
  helios::TriangleMesh mesh;
  if (const helios::Status status = mesh.Set(scene); !status.IsOk())
  {
    vtkErrorMacro(<< "Input: " << status.Message());
    return 0;
  }
  helios::PatchSource source = MakeSource(scene, mesh);
  const Silence silence;
  try
  {
    Run run(this, source);
    run.Execute();
    run.Finish(scene, output);
  }
  catch (const helios::Stopped&)
  {
    return this->Abort();
  }
  return 1;
}

//------------------------------------------------------------------------------
/// Progress and abort of the repair; its errors have been checked for. Since VTK 9.3 aborted
/// filters report a progress of 1 at last.
void vtkHeliosMeshSimplify::Follow(vtkObject* repair, unsigned long event, void*)
{
  if (event == vtkCommand::ProgressEvent && !this->GetAbortExecute())
  {
    auto* algorithm = static_cast<vtkAlgorithm*>(repair);
    this->UpdateProgress(0.1 * algorithm->GetProgress());
    algorithm->SetAbortExecute(this->GetAbortExecute());
  }
}

//------------------------------------------------------------------------------
int vtkHeliosMeshSimplify::Abort()
{
  vtkErrorMacro(<< "The work was aborted at " << 100.0 * this->GetProgress()
                << " %; update again to complete it");
  return 0;
}

//------------------------------------------------------------------------------
void vtkHeliosMeshSimplify::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "VerifiedDistance: " << this->VerifiedDistance << "\n";
  os << indent << "NumberOfDroppedTriangles: " << this->NumberOfDroppedTriangles << "\n";
  os << indent << "NumberOfRejectedTriangles: " << this->NumberOfRejectedTriangles << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "NumberOfUntouchedPatches: " << this->NumberOfUntouchedPatches << "\n";
}
