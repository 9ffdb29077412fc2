// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosVersion
 * @brief   the version of vtkHelios
 */

#ifndef vtkHeliosVersion_h
#define vtkHeliosVersion_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSFILTERSCORE_EXPORT vtkHeliosVersion : public vtkObject
{
public:
  static vtkHeliosVersion* New();
  vtkTypeMacro(vtkHeliosVersion, vtkObject);

  /**
   * Returns the version as "major.minor.patch".
   */
  static const char* GetVersion();

protected:
  vtkHeliosVersion() = default;
  ~vtkHeliosVersion() override = default;

private:
  vtkHeliosVersion(const vtkHeliosVersion&) = delete;
  void operator=(const vtkHeliosVersion&) = delete;
};

#endif
