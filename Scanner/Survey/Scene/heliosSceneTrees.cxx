// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneTrees.h"

#include "heliosSceneReaders.h"
#include "heliosSurveyData.h"
#include "vtkHeliosFoliageArrayNames.h"

#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <string>

namespace helios
{

namespace
{

bool IsTree(const PartData* part)
{
  return part && (part->Tree >= 0 || !part->Species.empty());
}

Status CheckTrees(const std::vector<const PartData*>& parts)
{
  const PartData* numbered = nullptr;
  const PartData* other = nullptr;
  for (const PartData* part : parts)
  {
    if (IsTree(part) && HasObjects(*part))
    {
      return Status::Error(part->Where +
        ": species or tree is given to a part that consists of objects, which are parts of their "
        "own; remove it, or give trees by another loader");
    }
    if (IsTree(part))
    {
      (part->Tree < 0 ? other : numbered) = part;
    }
  }
  return numbered && other
    ? Status::Error(other->Where + ": the tree has species=\"" + other->Species +
        "\", but no number, and others have, as tree=\"" + std::to_string(numbered->Tree) + "\" (" +
        numbered->Where + "); give all trees of a scene a number, or none")
    : Status();
}

} // namespace

//------------------------------------------------------------------------------
Status AddTrees(const std::vector<const PartData*>& parts, vtkPolyData* scene)
{
  const Status status = CheckTrees(parts);
  if (!status.IsOk() || std::none_of(parts.begin(), parts.end(), IsTree))
  {
    return status;
  }
  vtkNew<vtkIntArray> trees;
  trees->SetName(vtkHeliosFoliageArrayNames::PartTree);
  vtkNew<vtkStringArray> species;
  species->SetName(vtkHeliosFoliageArrayNames::PartSpecies);
  int id = 0;
  for (const PartData* part : parts)
  {
    trees->InsertNextValue(!IsTree(part) ? -1 : part->Tree < 0 ? id : part->Tree);
    species->InsertNextValue(part ? part->Species : "");
    ++id;
  }
  scene->GetFieldData()->AddArray(trees);
  scene->GetFieldData()->AddArray(species);
  return {};
}

} // namespace helios
