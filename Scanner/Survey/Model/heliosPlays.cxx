// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlays.h"

#include <algorithm>

namespace helios
{

//------------------------------------------------------------------------------
int CountPlays(const SceneData& scene)
{
  int longest = 0;
  for (const PartData& part : scene.Parts)
  {
    int plays = 0;
    for (const SwapData& swap : part.Swaps)
    {
      plays += swap.Plays;
    }
    longest = std::max(longest, plays);
  }
  return 1 + longest;
}

//------------------------------------------------------------------------------
const PartData* FindPart(const PartData& part, int play)
{
  if (play < 1 || part.Swaps.empty())
  {
    return &part;
  }
  std::size_t now = 0;
  for (int end = part.Swaps[0].Plays; end < play && now + 1 < part.Swaps.size();)
  {
    ++now;
    end += part.Swaps[now].Plays;
  }
  return part.Swaps[now].IsRemoved ? nullptr : &part.Swaps[now].Part;
}

//------------------------------------------------------------------------------
SurveyData MakePlay(const SurveyData& survey, int play)
{
  SurveyData made = survey;
  made.Scene.Parts.clear();
  for (const PartData& part : survey.Scene.Parts)
  {
    if (const PartData* found = FindPart(part, play))
    {
      made.Scene.Parts.push_back(*found);
      made.Scene.Parts.back().Name = part.Name;
      made.Scene.Parts.back().Swaps.clear();
    }
  }
  return made;
}

} // namespace helios
