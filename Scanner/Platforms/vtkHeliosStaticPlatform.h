// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosStaticPlatform
 * @brief   a static platform: a tripod
 *
 * Input: one waypoint. Output: one sample at that point, valid at all times: level, its y axis at
 * Heading, at rest.
 *
 * Errors: more than one waypoint (a survey has one scan position per leg), and the errors of
 * vtkHeliosPlatform.
 *
 * @sa
 * vtkHeliosPlatform
 */

#ifndef vtkHeliosStaticPlatform_h
#define vtkHeliosStaticPlatform_h

#include "vtkHeliosPlatform.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

class VTKHELIOSSCANNERPLATFORMS_EXPORT vtkHeliosStaticPlatform : public vtkHeliosPlatform
{
public:
  static vtkHeliosStaticPlatform* New();
  vtkTypeMacro(vtkHeliosStaticPlatform, vtkHeliosPlatform);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the heading of the platform's y axis, clockwise from north (world
   * y) [deg]. Valid range: [-360, 360]. Default: 0.
   */
  vtkSetClampMacro(Heading, double, -360.0, 360.0);
  vtkGetMacro(Heading, double);
  ///@}

protected:
  vtkHeliosStaticPlatform() = default;
  ~vtkHeliosStaticPlatform() override = default;

  bool Move(vtkPolyData* waypoints, std::vector<State>& path) override;

private:
  vtkHeliosStaticPlatform(const vtkHeliosStaticPlatform&) = delete;
  void operator=(const vtkHeliosStaticPlatform&) = delete;

  double Heading = 0.0;
};

#endif
