// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlScene.h"

#include "heliosEpochs.h"
#include "heliosMessages.h"
#include "heliosXmlPart.h"

#include <algorithm>
#include <filesystem>

namespace helios
{

namespace
{

/// Adds a part; as one part per file if it has several files and no id.
void AddPart(PartData part, std::vector<PartData>& parts)
{
  if (!part.Name.empty())
  {
    parts.push_back(part);
    return;
  }
  const std::vector<std::string> files = std::move(part.Files);
  for (const std::string& file : files)
  {
    part.Name = std::to_string(parts.size());
    part.Files = { file };
    parts.push_back(part);
  }
}

} // namespace

//------------------------------------------------------------------------------
SceneData ReadScene(const XmlElement& element, Assets& assets)
{
  SceneData scene;
  scene.Where = element.Where();
  element.ReadStored(scene);
  scene.Name = element.Has("name") ? scene.Name : scene.Id;
  scene.SpectraFolders = FindSpectraFolders(element.GetDocument(), assets);
  element.CheckNames();
  const std::vector<XmlElement> parts = element.GetChildren("part");
  for (const XmlElement& part : parts)
  {
    AddPart(ReadPart(part, element, assets), scene.Parts);
  }
  if (parts.empty())
  {
    element.GetMessages().Error(scene.Where + ": scene " + scene.Id +
      " has no <part>; add one with an objloader, geotiffloader or xyzloader");
  }
  CheckEpochs(scene, element.GetMessages());
  return scene;
}

//------------------------------------------------------------------------------
void CheckEpochs(const SceneData& scene, Messages& log)
{
  for (int epoch = 1; epoch < CountEpochs(scene); ++epoch)
  {
    const auto isThere = [epoch](const PartData& part) { return FindPart(part, epoch) != nullptr; };
    if (std::none_of(scene.Parts.begin(), scene.Parts.end(), isThere))
    {
      const std::string place = scene.Where.empty() ? "" : scene.Where + ": ";
      const std::string name = scene.Id.empty() ? "the scene" : "scene " + scene.Id;
      log.Error(place + name + " has no part in epoch " + std::to_string(epoch) +
        " (the first is 0): each <swap> has force_null; keep one part");
      return;
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> FindSpectraFolders(const XmlDocument& document, const Assets& assets)
{
  std::vector<std::string> spectra;
  for (const std::string& folder : assets.GetFolders(document))
  {
    spectra.push_back((std::filesystem::path(folder) / "spectra").lexically_normal().string());
  }
  return spectra;
}

} // namespace helios
