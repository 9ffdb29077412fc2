// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRayCasterBackends.h"

#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRayCasterFactory.h"

#include <vtkNew.h>

#if VTK_MODULE_ENABLE_vtkHelios_ScannerRayCastingCgal
#include "vtkHeliosCgalRayCaster.h"
#endif
#if VTK_MODULE_ENABLE_vtkHelios_ScannerRayCastingEmbree
#include "vtkHeliosEmbreeRayCaster.h"
#endif
#if VTK_MODULE_ENABLE_vtkHelios_ScannerRayCastingObbTree
#include "vtkHeliosObbTreeRayCaster.h"
#endif

namespace helios
{

namespace
{

/// Links the backends. A backend registers itself when its library is loaded; naming it here keeps
/// the library linked.
void LinkBackends()
{
#if VTK_MODULE_ENABLE_vtkHelios_ScannerRayCastingCgal
  vtkNew<vtkHeliosCgalRayCaster> cgal;
#endif
#if VTK_MODULE_ENABLE_vtkHelios_ScannerRayCastingEmbree
  vtkNew<vtkHeliosEmbreeRayCaster> embree;
#endif
#if VTK_MODULE_ENABLE_vtkHelios_ScannerRayCastingObbTree
  vtkNew<vtkHeliosObbTreeRayCaster> obbTree;
#endif
}

} // namespace

vtkSmartPointer<vtkHeliosRayCaster> MakeDefaultRayCaster()
{
  LinkBackends();
  return vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create(nullptr));
}

} // namespace helios
