// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLights.h"

#include "heliosPose.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace helios::viewer
{

namespace
{

constexpr double Ambient = 0.36; // share of light without direction

// Where the light comes from, and its strength.
const Vec3 Sun(-0.5, -0.62, 0.6);
const Vec3 Sky(0.62, 0.5, 0.6);
constexpr double SunShare = 0.62;
constexpr double SkyShare = 0.26;

void AddLight(vtkRenderer* renderer, const Vec3& from, double share)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetPosition(from[0], from[1], from[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(share);
  renderer->AddLight(light);
}

} // namespace

//------------------------------------------------------------------------------
void AddLights(vtkRenderer* renderer)
{
  renderer->RemoveAllLights();
  renderer->AutomaticLightCreationOff();
  AddLight(renderer, Sun, SunShare);
  AddLight(renderer, Sky, SkyShare);
  const double level = SunShare * Sun[2] / Sun.Norm() + SkyShare * Sky[2] / Sky.Norm();
  vtkNew<vtkLight> camera;
  camera->SetLightTypeToHeadlight();
  camera->SetIntensity(1.0 - level);
  renderer->AddLight(camera);
}

//------------------------------------------------------------------------------
void SetUpSurface(vtkProperty* surface)
{
  surface->SetAmbient(Ambient);
  surface->SetDiffuse(1.0 - Ambient);
}

} // namespace helios::viewer
