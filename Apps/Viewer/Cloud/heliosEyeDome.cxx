// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEyeDome.h"

#include <vtkCameraPass.h>
#include <vtkEDLShading.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkOverlayPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>

namespace helios::viewer
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderPass> MakeEyeDomePass()
{
  vtkNew<vtkRenderPassCollection> solid;
  solid->AddItem(vtkNew<vtkLightsPass>());
  solid->AddItem(vtkNew<vtkOpaquePass>());
  solid->AddItem(vtkNew<vtkTranslucentPass>());
  vtkNew<vtkSequencePass> steps;
  steps->SetPasses(solid);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(steps);
  vtkNew<vtkEDLShading> shading;
  shading->SetDelegatePass(camera);
  vtkNew<vtkRenderPassCollection> all;
  all->AddItem(shading);
  all->AddItem(vtkNew<vtkOverlayPass>());
  auto pass = vtkSmartPointer<vtkSequencePass>::New();
  pass->SetPasses(all);
  return pass;
}

} // namespace helios::viewer
