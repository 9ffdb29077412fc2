// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScenePreparation.h"

#include "heliosScanModel.h"
#include "heliosStatus.h"
#include "vtkHeliosScene.h"

#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <sstream>

namespace helios
{
namespace
{

/// Builds a ray caster.
Status Build(vtkHeliosRayCaster* caster, vtkPolyData* scene)
{
  std::string reason;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&reason);
  listener->SetCallback([](vtkObject*, unsigned long, void* into, void* text)
    { *static_cast<std::string*>(into) += static_cast<const char*>(text); });
  const unsigned long tag = caster->AddObserver(vtkCommand::ErrorEvent, listener);
  const bool built = caster->Build(scene);
  caster->RemoveObserver(tag);
  return built ? Status() : Status::Error("no ray caster can be built for the scene: " + reason);
}

/// Checks that isotropic voxels scatter no more light than they receive.
Status CheckIsotropic(const SceneSurfaces& surfaces, vtkIdType firstCell, vtkIdType count)
{
  constexpr double largest = 0.25;
  for (vtkIdType cell = firstCell; cell < firstCell + count; ++cell)
  {
    const double reflectance = surfaces.GetReflection(surfaces.GetMaterialId(cell)).Reflectance;
    if (reflectance > largest)
    {
      std::ostringstream text;
      text << "ScatteringPhase is ISOTROPIC (scatteringPhase=\"isotropic\"), whose albedo is 4 "
              "times the reflectance, and that of turbid voxels is "
           << reflectance << "; give them at most " << largest << ", or take the phase of leaves";
      return Status::Error(text.str());
    }
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
Status PrepareScene(vtkPolyData* scene, const std::vector<vtkImageData*>& grids,
  vtkHeliosRayCaster* caster, bool isIsotropic, ScanModel& model)
{
  const bool hasSurfaces =
    grids.empty() || scene->GetNumberOfCells() > 0 || vtkHeliosScene::HasInstances(scene);
  Status status = hasSurfaces ? Build(caster, scene) : Status();
  model.Caster = hasSurfaces ? caster : nullptr;
  status = status.IsOk() ? model.Surfaces.Set(scene, hasSurfaces ? &caster->GetGeometry() : nullptr)
                         : status;
  for (std::size_t i = 0; status.IsOk() && i < grids.size(); ++i)
  {
    vtkIdType firstCell = 0;
    status = model.Surfaces.AddGrid(grids[i], firstCell);
    status = status.IsOk() ? model.Medium.Add(grids[i], firstCell) : status;
    status = status.IsOk() && isIsotropic
      ? CheckIsotropic(model.Surfaces, firstCell, grids[i]->GetNumberOfCells())
      : status;
  }
  return status;
}

} // namespace helios
