// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGLTFSceneReader.h"

#include "heliosGltfAnimation.h"
#include "heliosGltfDocument.h"
#include "heliosGltfModel.h"
#include "heliosMtlFile.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <string>

vtkStandardNewMacro(vtkHeliosGLTFSceneReader);

/// A document that was read; one with an animation is kept for its other times.
struct vtkHeliosGLTFSceneReader::Internals
{
  std::string Name; ///< file and animation
  helios::GltfDocument Document;
  helios::GltfAnimation Animation;
};

//------------------------------------------------------------------------------
vtkHeliosGLTFSceneReader::vtkHeliosGLTFSceneReader()
{
  this->SetUpAxisToY();
}

//------------------------------------------------------------------------------
vtkHeliosGLTFSceneReader::~vtkHeliosGLTFSceneReader()
{
  this->SetMaterialFileName(nullptr);
  this->SetAnimation(nullptr);
}

//------------------------------------------------------------------------------
/// Reads file and animation, unless they are those of the last time. False after an error.
bool vtkHeliosGLTFSceneReader::ReadDocument(helios::TextReport& report)
{
  const std::string name =
    std::string(this->GetFileName()) + '\n' + (this->Animation ? this->Animation : "");
  if (!this->Animation || !this->Known || this->Known->Name != name)
  {
    this->Known = std::make_unique<Internals>();
    helios::Status status = this->Known->Document.Read(this->GetFileName());
    if (status.IsOk() && this->Animation)
    {
      status = this->Known->Animation.Read(this->Known->Document, this->Animation);
    }
    if (!status.IsOk())
    {
      this->Known.reset();
      return report.Fail(status.Message());
    }
    this->Known->Name = name;
  }
  this->Known->Animation.SetTime(this->AnimationTime);
  this->AnimationDuration = this->Known->Animation.GetDuration();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosGLTFSceneReader::ReadScene(vtkPolyData* scene, helios::TextReport& report)
{
  helios::SceneMesh mesh;
  mesh.KeepsAll = this->GetKeepAll();
  if (!this->ReadDocument(report))
  {
    return false;
  }
  helios::GltfModel model(
    this->Known->Document, this->Animation ? &this->Known->Animation : nullptr, mesh, report);
  model.OnBlock = [this](double progress) { return this->ReportBlock(progress); };
  const std::string materials = this->MaterialFileName ? this->MaterialFileName : "";
  if (!model.Read() ||
    (!materials.empty() && !helios::ReplaceMaterials(materials, mesh.Materials, report)) ||
    !(mesh.KeepsAll || model.ApplyCutouts()))
  {
    return false;
  }
  if (!this->Animation)
  {
    this->Known.reset();
  }
  mesh.TextureCoordinates.Truncate(0);
  mesh.Faces.Count = mesh.GetNumberOfTriangles();
  this->Finish(mesh, scene, report);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosGLTFSceneReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "MaterialFileName: " << (this->MaterialFileName ? this->MaterialFileName : "(none)")
     << "\n";
  os << indent << "Animation: " << (this->Animation ? this->Animation : "(none)") << "\n";
  os << indent << "AnimationTime: " << this->AnimationTime << "\n";
  os << indent << "AnimationDuration: " << this->AnimationDuration << "\n";
}
