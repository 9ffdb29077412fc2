// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMemoryLimit
 * @brief   how much memory this process may take for scenes
 *
 * Readers and filters that make scenes estimate what they will take before they allocate it, and
 * refuse what goes beyond what is available, with the numbers. It holds for the whole process, as
 * vtkSMPTools::Initialize does. Functions may be called from any thread.
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
   * What this process may take in all [MiB], 0 or more. 0: what the machine, or the control group
   * this process is in, has available. Default 0.
   */
  static void SetLimit(double mebibytes);
  static double GetLimit();
  ///@}

  /**
   * What can still be taken [MiB]: the limit without what this process has; without a limit what the
   * machine has available (MemAvailable of /proc/meminfo), or less where a control group allows less.
   * Infinite where the system does not say.
   */
  static double GetAvailable();

protected:
  vtkHeliosMemoryLimit() = default;
  ~vtkHeliosMemoryLimit() override = default;

private:
  vtkHeliosMemoryLimit(const vtkHeliosMemoryLimit&) = delete;
  void operator=(const vtkHeliosMemoryLimit&) = delete;
};

#endif
