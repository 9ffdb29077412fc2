// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneEdit.h"

#include "heliosMessages.h"
#include "heliosPartFile.h"
#include "heliosSceneBuilder.h"
#include "heliosSceneReaders.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlFilter.h"
#include "heliosXmlValue.h"

#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

constexpr const char* Offset = "translate/offset";
constexpr const char* Scale = "scale/scale";

std::string ToText(const Vec3& v)
{
  return ToXmlText(v[0]) + ";" + ToXmlText(v[1]) + ";" + ToXmlText(v[2]);
}

} // namespace

/// A survey of which only the scene is used.
class SceneEdit::Internals
{
public:
  explicit Internals(const std::vector<std::string>& assetDirectories)
    : Document(nullptr)
  {
    this->Document.SetAssetDirectories(assetDirectories);
  }

  std::string Get(int part, const char* path)
  {
    return this->Document.Get({ SurveyItem::Part, part }, path);
  }

  bool Set(int part, const char* path, const std::string& text)
  {
    return this->Document.Set({ SurveyItem::Part, part }, path, text);
  }

  bool HasPart(int part) const { return part >= 0 && part < this->GetNumberOfParts(); }
  int GetNumberOfParts() const { return this->Document.GetNumberOf(SurveyItem::Part); }

  Vec3 GetOffset(int part)
  {
    Messages silent(nullptr);
    Vec3 offset(0.0, 0.0, 0.0);
    ParseVector({ Offset, this->Get(part, Offset), "" }, silent, offset);
    return offset;
  }

  bool SetOffset(int part, const Vec3& offset)
  {
    return this->Set(part, Offset, ToText(RoundComputed(offset)));
  }

  SurveyDocument Document;
};

//------------------------------------------------------------------------------
SceneEdit::SceneEdit()
  : Inside(std::make_unique<Internals>(std::vector<std::string>()))
{
}

//------------------------------------------------------------------------------
SceneEdit::~SceneEdit() = default;
SceneEdit::SceneEdit(SceneEdit&&) noexcept = default;
SceneEdit& SceneEdit::operator=(SceneEdit&&) noexcept = default;

//------------------------------------------------------------------------------
bool SceneEdit::Load(
  const std::string& scene, const std::vector<std::string>& assetDirectories, Messages& log)
{
  this->Inside = std::make_unique<Internals>(assetDirectories);
  const std::optional<Loader> loader = FindLoader(scene);
  const bool isGood = loader
    ? this->Inside->Document.AddPart(GetLoaderName(*loader), fs::absolute(scene).string()) == 0 &&
      this->Inside->Set(0, "id", this->GetId())
    : this->Inside->Document.UseScene(scene);
  isGood ? void() : log.Error(this->Inside->Document.GetLastError());
  for (int part = 0; isGood && part < this->GetNumberOfParts(); ++part)
  {
    const std::string name = this->Inside->Get(part, "id"); // a number changes with others
    name.empty() ? void(this->Inside->Set(part, "id", std::to_string(part))) : void();
  }
  return isGood;
}

//------------------------------------------------------------------------------
bool SceneEdit::IsLoaded() const
{
  return !this->GetId().empty();
}

//------------------------------------------------------------------------------
int SceneEdit::GetNumberOfParts() const
{
  return this->Inside->GetNumberOfParts();
}

//------------------------------------------------------------------------------
std::string SceneEdit::GetPartName(int part) const
{
  return this->Inside->HasPart(part) ? this->Inside->Get(part, "id") : std::string();
}

//------------------------------------------------------------------------------
int SceneEdit::FindPart(const std::string& name) const
{
  for (int part = 0; part < this->GetNumberOfParts(); ++part)
  {
    if (this->GetPartName(part) == name)
    {
      return part;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
bool SceneEdit::MovePart(int part, const Vec3& way)
{
  return this->Inside->HasPart(part) &&
    this->Inside->SetOffset(part, this->Inside->GetOffset(part) + way);
}

//------------------------------------------------------------------------------
bool SceneEdit::TurnPart(int part, double angle, const Vec3& about)
{
  return this->Inside->HasPart(part) && this->Inside->Document.RotatePart(part, "z", angle) &&
    this->Inside->SetOffset(part,
      about + Rotate(AxisAngle({ 0.0, 0.0, 1.0 }, angle), this->Inside->GetOffset(part) - about));
}

//------------------------------------------------------------------------------
bool SceneEdit::ScalePart(int part, double factor, const Vec3& about)
{
  return this->Inside->HasPart(part) && factor > 0.0 &&
    this->Inside->Set(part, Scale, ToXmlText(factor * std::stod(this->Inside->Get(part, Scale)))) &&
    this->Inside->SetOffset(part, about + factor * (this->Inside->GetOffset(part) - about));
}

//------------------------------------------------------------------------------
bool SceneEdit::RemovePart(int part)
{
  return this->GetNumberOfParts() > 1 && this->Inside->HasPart(part) &&
    this->Inside->Document.RemovePart(part);
}

//------------------------------------------------------------------------------
int SceneEdit::AddPart(const std::string& fileName, const Vec3& place, Messages& log)
{
  PartData data;
  data.Type = FindLoader(fileName).value_or(Loader::Obj);
  const auto reader = MakeSceneReader(data, fileName);
  log.Listen(reader);
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPoints() == 0)
  {
    log.Error(
      fileName + ": has nothing to add to the scene; give a file with faces: " + GetMeshEndings());
    return -1;
  }
  double b[6];
  reader->GetOutput()->GetBounds(b);
  const std::string stem = fs::path(fileName).stem().string();
  std::string name = stem;
  for (int i = 2; this->FindPart(name) >= 0; ++i)
  {
    name = stem + "_" + std::to_string(i);
  }
  const int part = this->Inside->Document.AddPart(
    GetLoaderName(data.Type), fs::absolute(fileName).lexically_normal().string());
  this->Inside->Set(part, "id", name);
  this->Inside->SetOffset(part, place - Vec3(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), b[4]));
  return part;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SceneEdit::Build(Messages& log) const
{
  const int before = log.GetNumberOfErrors();
  const SceneData data = this->Inside->Document.ResolveScene(log);
  if (data.Parts.empty() || log.GetNumberOfErrors() != before)
  {
    return nullptr;
  }
  SceneBuilder builder(data, log);
  builder.SetInstances(true);
  return builder.Build([](const std::string&) { return true; });
}

//------------------------------------------------------------------------------
std::string SceneEdit::GetId() const
{
  return this->Inside->Document.Get({ SurveyItem::Scene }, "id");
}

//------------------------------------------------------------------------------
std::string SceneEdit::GetText() const
{
  return this->Inside->Document.GetSceneText();
}

//------------------------------------------------------------------------------
void SceneEdit::SetText(const std::string& text)
{
  this->Inside->Document.SetSceneText(text);
}

//------------------------------------------------------------------------------
Status SceneEdit::Save(const std::string& fileName) const
{
  const char* comment = " A scene changed by hand, written by vtkHelios. ";
  return WriteWhole(
    fileName, this->Inside->Document.MakeFileText({ SurveyItem::Scene }, comment, fileName));
}

} // namespace helios
