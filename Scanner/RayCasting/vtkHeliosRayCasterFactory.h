// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRayCasterFactory
 * @brief   creates ray casters by the names of their backends
 *
 * Backends of other libraries register themselves when these are loaded.
 *
 * @sa
 * vtkHeliosRayCaster
 */

#ifndef vtkHeliosRayCasterFactory_h
#define vtkHeliosRayCasterFactory_h

#include "vtkHeliosScannerRayCastingModule.h" // For export macro
#include "vtkObject.h"

class vtkHeliosRayCaster;

class VTKHELIOSSCANNERRAYCASTING_EXPORT vtkHeliosRayCasterFactory : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosRayCasterFactory, vtkObject);

  /**
   * Creates a ray caster by the name of its backend, or the default one if the
   * name is null or empty. For an unknown name, null after an error that lists
   * the valid names.
   */
  VTK_NEWINSTANCE static vtkHeliosRayCaster* Create(const char* name);

  ///@{
  /**
   * Returns the names of the backends in this process, the default one first: "beam", "embree",
   * "bvh", "cgal", "obbtree" if all are built. Valid range of an index: [0, number - 1]; null
   * outside.
   */
  static int GetNumberOfBackends();
  static const char* GetBackendName(int index);
  ///@}

#ifndef __VTK_WRAP__
  using Creator = vtkHeliosRayCaster* (*)();

  /// Registers a backend; the one with the highest priority is the default. Returns true.
  static bool Register(const char* name, int priority, Creator create);
#endif

protected:
  vtkHeliosRayCasterFactory() = default;
  ~vtkHeliosRayCasterFactory() override = default;

private:
  vtkHeliosRayCasterFactory(const vtkHeliosRayCasterFactory&) = delete;
  void operator=(const vtkHeliosRayCasterFactory&) = delete;
};

#endif
