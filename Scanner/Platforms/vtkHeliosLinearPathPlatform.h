// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosLinearPathPlatform
 * @brief   a platform that goes straight from waypoint to waypoint
 *
 * Input: two or more waypoints with the point array Speed [m/s], the speed from
 * that waypoint to the next (the last one's is not used). The platform's y axis
 * points to the next waypoint in x, y; it turns at once, and stays level on a
 * climb. A vertical leg keeps the heading of the leg before (of the next leg
 * where it is the first). Legs of zero length take no time.
 *
 * Errors: fewer than two waypoints, a speed that is not positive and finite,
 * waypoints that are not finite.
 *
 * @sa
 * vtkHeliosPlatform
 */

#ifndef vtkHeliosLinearPathPlatform_h
#define vtkHeliosLinearPathPlatform_h

#include "vtkHeliosPlatform.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

class VTKHELIOSSCANNERPLATFORMS_EXPORT vtkHeliosLinearPathPlatform : public vtkHeliosPlatform
{
public:
  static vtkHeliosLinearPathPlatform* New();
  vtkTypeMacro(vtkHeliosLinearPathPlatform, vtkHeliosPlatform);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHeliosLinearPathPlatform() = default;
  ~vtkHeliosLinearPathPlatform() override = default;

  bool Move(vtkPolyData* waypoints, std::vector<State>& path) override;

private:
  vtkHeliosLinearPathPlatform(const vtkHeliosLinearPathPlatform&) = delete;
  void operator=(const vtkHeliosLinearPathPlatform&) = delete;
};

#endif
