// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEpochs.h"

#include <algorithm>

namespace helios
{

//------------------------------------------------------------------------------
int CountEpochs(const SceneData& scene)
{
  int longest = 0;
  for (const PartData& part : scene.Parts)
  {
    int epochs = 0;
    for (const SwapData& swap : part.Swaps)
    {
      epochs += swap.Epochs;
    }
    longest = std::max(longest, epochs);
  }
  return 1 + longest;
}

//------------------------------------------------------------------------------
const PartData* FindPart(const PartData& part, int epoch)
{
  if (epoch < 1 || part.Swaps.empty())
  {
    return &part;
  }
  std::size_t now = 0;
  for (int end = part.Swaps[0].Epochs; end < epoch && now + 1 < part.Swaps.size();)
  {
    ++now;
    end += part.Swaps[now].Epochs;
  }
  return part.Swaps[now].IsRemoved ? nullptr : &part.Swaps[now].Part;
}

//------------------------------------------------------------------------------
SurveyData MakeEpoch(const SurveyData& survey, int epoch)
{
  SurveyData made = survey;
  if (CountEpochs(survey.Scene) == 1)
  {
    return made;
  }
  made.Scene.Parts.clear();
  for (const PartData& part : survey.Scene.Parts)
  {
    if (const PartData* found = FindPart(part, epoch))
    {
      made.Scene.Parts.push_back(*found);
      made.Scene.Parts.back().Name = part.Name;
      made.Scene.Parts.back().Swaps.clear();
    }
  }
  return made;
}

} // namespace helios
