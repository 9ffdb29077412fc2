// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMemoryLimit
 * @brief   memory limit of the process for scenes
 *
 * Readers and filters that create scenes estimate their memory before they allocate it. If the
 * estimate exceeds the available memory, they fail with an error that gives both numbers. The limit
 * holds for the whole process, like vtkSMPTools::Initialize. All functions are thread-safe.
 */

#ifndef vtkHeliosMemoryLimit_h
#define vtkHeliosMemoryLimit_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSFILTERSCORE_EXPORT vtkHeliosMemoryLimit : public vtkObject
{
public:
  static vtkHeliosMemoryLimit* New();
  vtkTypeMacro(vtkHeliosMemoryLimit, vtkObject);

  ///@{
  /**
   * Total memory limit of this process [MiB], 0 or more. 0: the memory available on the machine or
   * in the control group of this process. Default: 0.
   */
  static void SetLimit(double mebibytes);
  static double GetLimit();
  ///@}

  /**
   * Returns the memory still available [MiB]: the limit minus the current use of the process.
   * Without a limit: the available memory of the machine (MemAvailable of /proc/meminfo), or that
   * of a control group if it is less. Infinite if the system does not report it.
   */
  static double GetAvailable();

  /**
   * Returns the memory used by this process [MiB], without pages of files, which the system may
   * drop; 0 if the system does not report it.
   */
  static double GetUsed();

protected:
  vtkHeliosMemoryLimit() = default;
  ~vtkHeliosMemoryLimit() override = default;

private:
  vtkHeliosMemoryLimit(const vtkHeliosMemoryLimit&) = delete;
  void operator=(const vtkHeliosMemoryLimit&) = delete;
};

#endif
