// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosLinearPathPlatform
 * @brief   a platform that moves in straight lines between waypoints
 *
 * Input: two or more waypoints with the point array Speed [m/s], the speed from that waypoint to
 * the next (not used for the last one). The platform's y axis points to the next waypoint in x, y;
 * it turns instantly, and stays level on a climb. A vertical leg keeps the heading of the leg
 * before (of the next leg if it is the first). Legs of zero length take no time.
 *
 * Output: two samples per leg, both with its LegIds: its start and its end, which is when the next
 * one starts. The duration of a leg is its length over its speed; the times are the compensated sum
 * of those (Neumaier 1974, Z. angew. Math. Mech. 54, 39-51), correct to an ulp after any number of
 * legs, plus StartTime.
 *
 * Errors: fewer than two waypoints, no Speed, a speed that is not positive and finite, a leg that
 * never ends, and the errors of vtkHeliosPlatform.
 *
 * @sa
 * vtkHeliosPlatform vtkHeliosStaticPlatform
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
