// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScenePreparation.h"

#include "heliosScanModel.h"

#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace helios
{
namespace
{

/// Builds a ray caster; returns an error message, or an empty string.
std::string Build(vtkHeliosRayCaster* caster, vtkPolyData* scene)
{
  std::string reason;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&reason);
  listener->SetCallback([](vtkObject*, unsigned long, void* into, void* text)
    { *static_cast<std::string*>(into) += static_cast<const char*>(text); });
  const unsigned long tag = caster->AddObserver(vtkCommand::ErrorEvent, listener);
  const bool built = caster->Build(scene);
  caster->RemoveObserver(tag);
  return built ? std::string() : "no ray caster can be built for the scene: " + reason;
}

} // namespace

//------------------------------------------------------------------------------
std::string PrepareScene(vtkPolyData* scene, const std::vector<vtkImageData*>& grids,
  vtkHeliosRayCaster* caster, ScanModel& model)
{
  const bool hasSurfaces = grids.empty() || scene->GetNumberOfCells() > 0;
  std::string fault = hasSurfaces ? Build(caster, scene) : std::string();
  model.Caster = hasSurfaces ? caster : nullptr;
  fault = fault.empty() ? model.Surfaces.Set(scene) : fault;
  for (std::size_t i = 0; fault.empty() && i < grids.size(); ++i)
  {
    vtkIdType firstCell = 0;
    fault = model.Surfaces.AddGrid(grids[i], firstCell);
    fault = fault.empty() ? model.Medium.Add(grids[i], firstCell) : fault;
  }
  return fault;
}

} // namespace helios
