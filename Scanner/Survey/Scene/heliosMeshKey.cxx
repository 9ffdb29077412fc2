// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMeshKey.h"

#include "heliosSceneReaders.h"
#include "heliosSurveyData.h"

#include <ios>
#include <sstream>
#include <vector>

namespace helios
{

std::string GetMeshKey(const PartData& part)
{
  const bool hasPoints =
    part.Type == Loader::Xyz || part.Type == Loader::Las || part.Type == Loader::Vegetation;
  if (hasPoints || HasObjects(part)) // objects are parts, instances are one each
  {
    return {};
  }
  std::ostringstream key;
  key << std::hexfloat << static_cast<int>(part.Type) << part.UpIsY << part.Repair << ' '
      << part.SimplifyDistance << ' ' << part.Material.Count << ' ' << part.Material.RandomRange
      << ' ' << part.Classification << ' ' << part.Frames.IsGiven();
  std::vector<std::string> texts = part.Files;
  texts.insert(texts.end(), { part.LevelOfDetail, part.Material.File, part.Material.Name });
  if (part.Type == Loader::Gltf && part.Frames.IsGiven()) // frames are made at the rate
  {
    key << ' ' << part.Frames.Rate;
    texts.push_back(part.Frames.Animation);
  }
  for (const CrsData& crs : part.Crs)
  {
    key << ' ' << crs.Epoch << ' ' << crs.HeightUnit;
    texts.insert(texts.end(), { crs.Source, crs.Target });
  }
  for (const std::string& text : texts)
  {
    key << '\0' << text;
  }
  return key.str();
}

} // namespace helios
