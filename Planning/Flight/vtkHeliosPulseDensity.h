// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPulseDensity
 * @brief   the pulse density on the ground that flight lines are expected to give
 *
 * Port 0: places on the ground (vtkPolyData, its points), with the point array Normal if the ground
 * is not horizontal. Port 1: flight lines (vtkPolyData): polylines that are straight in x, y, from
 * vtkHeliosFlightLines or vtkHeliosTerrainFollow, with the point array Speed [m/s]. Output: the
 * places, with the point arrays
 * - PulseDensity [1/m2 of the horizontal plane]: pulses of all lines
 * - StripDensity [1/m2]: of the line that gives most
 * - NumberOfStrips: of lines whose swath reaches the place
 * - FlyingHeight [m]: above the place, of the line with the smallest distance in x, y
 *
 * vtkHeliosSwath gives the density, for the height of the line above the place and the slope there.
 * The platform is level, also on a climb; pulses outside the range gate of the scanner do not
 * count. Nothing hides a place but its own slope: below roofs and trees the density is that on top
 * of them.
 *
 * Errors: no Swath that was built, no Speed, a Speed that is not positive, places that are not
 * finite.
 *
 * @sa
 * vtkHeliosFlightLines vtkHeliosSwath
 */

#ifndef vtkHeliosPulseDensity_h
#define vtkHeliosPulseDensity_h

#include "vtkHeliosPlanningModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For the swath

class vtkHeliosSwath;

class VTKHELIOSPLANNING_EXPORT vtkHeliosPulseDensity : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosPulseDensity* New();
  vtkTypeMacro(vtkHeliosPulseDensity, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the distribution of the pulses, of all lines. Default: none.
   */
  void SetSwath(vtkHeliosSwath* swath);
  vtkHeliosSwath* GetSwath() const;
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkHeliosPulseDensity();
  ~vtkHeliosPulseDensity() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosPulseDensity(const vtkHeliosPulseDensity&) = delete;
  void operator=(const vtkHeliosPulseDensity&) = delete;

  vtkSmartPointer<vtkHeliosSwath> Swath;
};

#endif
