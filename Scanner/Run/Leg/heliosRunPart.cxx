// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunPart.h"

#include "heliosLegPlan.h"
#include "heliosPulseCount.h"

#include <algorithm>

namespace helios
{

//------------------------------------------------------------------------------
void DivideIntoBlocks(std::vector<LegPlan>& plans, vtkIdType pulsesPerBlock)
{
  for (LegPlan& plan : plans)
  {
    plan.NumberOfBlocks = std::max<vtkIdType>(1, (plan.NumberOfPulses - 1) / pulsesPerBlock + 1);
    plan.FirstBlock = 0;
    plan.EndBlock = plan.NumberOfBlocks;
  }
}

//------------------------------------------------------------------------------
vtkIdType CountBlocks(const std::vector<LegPlan>& plans)
{
  vtkIdType blocks = 0;
  for (const LegPlan& plan : plans)
  {
    blocks += plan.EndBlock - plan.FirstBlock;
  }
  return blocks;
}

//------------------------------------------------------------------------------
std::vector<LegPlan> SelectPart(const std::vector<LegPlan>& plans, const RunPart& part)
{
  const vtkIdType blocks = CountBlocks(plans);
  const vtkIdType begin = SplitPulses(blocks, part.Number - 1, part.Count);
  const vtkIdType end = SplitPulses(blocks, part.Number, part.Count);
  std::vector<LegPlan> selected;
  vtkIdType before = 0;
  for (const LegPlan& plan : plans)
  {
    LegPlan some = plan;
    some.FirstBlock = std::clamp<vtkIdType>(begin - before, 0, plan.NumberOfBlocks);
    some.EndBlock = std::clamp<vtkIdType>(end - before, 0, plan.NumberOfBlocks);
    before += plan.NumberOfBlocks;
    if (some.FirstBlock < some.EndBlock)
    {
      selected.push_back(some);
    }
  }
  return selected;
}

} // namespace helios
