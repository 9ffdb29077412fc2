// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosCoordinateSystem
 * @brief   what a coordinate system is: identity, units, resolution
 *
 * A system is given by a text: "EPSG:25832", "EPSG:25832+7837" with heights, WKT, PROJJSON, a PROJ
 * string, the full name of an EPSG system, or "ENU latitude longitude height" for local axes at an
 * origin on WGS 84 [degrees, m]. PROJ knows them. Coordinates are in the order east, north, up.
 *
 * Heights of a system without a vertical part have the unit of x and y, or are metres if these are
 * degrees; HasHeightUnit() tells whether the system states it.
 *
 * @sa
 * vtkHeliosReproject
 */

#ifndef vtkHeliosCoordinateSystem_h
#define vtkHeliosCoordinateSystem_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For the system
#include <string> // For names

namespace helios
{
class CoordinateSystem;
}

class VTKHELIOSFILTERSCORE_EXPORT vtkHeliosCoordinateSystem : public vtkObject
{
public:
  static vtkHeliosCoordinateSystem* New();
  vtkTypeMacro(vtkHeliosCoordinateSystem, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Sets the text of the system. Returns false if PROJ does not know it; GetProblem() says why, and
   * the properties below have their defaults: empty texts, metres, steps of 0.1 mm.
   */
  bool SetText(const std::string& text);

  /**
   * Returns the text as given; empty if it is not known.
   */
  std::string GetText() const;

  /**
   * Returns what is wrong with the text, with the forms that are known; empty if nothing is.
   */
  std::string GetProblem() const { return this->Problem; }

  /**
   * Returns the code, "EPSG:25832" or "EPSG:25832+7837"; empty if a part of the system has none.
   */
  std::string GetCode() const;

  /**
   * Returns the label in messages: the code, or the begin of the name.
   */
  std::string GetLabel() const;

  /**
   * Returns code and name, "EPSG:32632 (WGS 84 / UTM zone 32N)".
   */
  std::string GetName() const;

  /**
   * Returns WKT 1, or WKT 2 of 2019 if WKT 1 cannot express the system; empty for a local system.
   */
  std::string GetWkt() const;

  /**
   * Returns whether x and y are longitude and latitude [degrees].
   */
  bool IsGeographic() const;

  /**
   * Returns the metres per unit of x and y; 0 for degrees.
   */
  double GetUnit() const;

  /**
   * Returns the metres per unit of z.
   */
  double GetHeightUnit() const;

  /**
   * Returns whether the system states the unit of z.
   */
  bool HasHeightUnit() const;

  /**
   * Returns the units as text: "degrees", "US survey foot", "metre, with heights in foot".
   */
  std::string GetUnitName() const;

  /**
   * Replaces the vertical part by one that only states its unit [m], above 0. Returns false, and
   * changes nothing, for a local system and an unknown one.
   */
  bool SetHeightUnit(double metres);

  /**
   * Returns the largest step for stored coordinates of an axis (0, 1, 2), in its unit: 1e-9
   * degrees, or the power of ten next to 0.1 mm or below.
   */
  double GetResolution(int axis) const;

  /**
   * Returns whether another text defines the same system, whatever its form; compound systems by
   * both parts. An unknown system is the same as none.
   */
  bool IsSame(const std::string& text) const;

  /**
   * Returns the code of the UTM or UPS zone of a point, "EPSG:32632"; empty if it is not on the
   * Earth, or the system is not known.
   */
  std::string FindMetric(double x, double y, double z) const;

protected:
  vtkHeliosCoordinateSystem();
  ~vtkHeliosCoordinateSystem() override;

private:
  vtkHeliosCoordinateSystem(const vtkHeliosCoordinateSystem&) = delete;
  void operator=(const vtkHeliosCoordinateSystem&) = delete;

  std::unique_ptr<helios::CoordinateSystem> System;
  std::string Problem;
};

#endif
