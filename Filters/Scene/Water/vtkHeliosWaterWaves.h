// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaterWaves
 * @brief   raises the waves of a wind on a surface of water
 *
 * Input 0: a vtkPolyData of triangles, the surface at rest. Output 0: the same, with the heights of
 * its points changed by waves at a time. The energy of the waves by frequency follows JONSWAP
 * (Hasselmann et al. 1973), which depends on the wind's speed and fetch; they spread by cos^2 about
 * its direction, and move as waves on deep water do, w^2 = g k. The output depends on nothing but
 * the input and the properties.
 *
 * Waves shorter than ShortestWave are no part of the mesh: give the surface edges of a quarter of
 * that. Materials whose optics are water have their slopes as MeanSquareSlope then: the slopes of
 * the wind (Cox and Munk 1954: 0.003 + 0.00512 U) minus the slopes of the mesh.
 *
 * Errors: a wind that is not finite, or has a speed and no fetch.
 *
 * @sa
 * vtkHeliosScanner vtkHeliosRefractionCorrection
 */

#ifndef vtkHeliosWaterWaves_h
#define vtkHeliosWaterWaves_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosWaterWaves : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosWaterWaves* New();
  vtkTypeMacro(vtkHeliosWaterWaves, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the speed of the wind 10 m above the water [m/s]. Valid range: [0, 50]. Default: 5.
   */
  vtkSetClampMacro(WindSpeed, double, 0.0, 50.0);
  vtkGetMacro(WindSpeed, double);
  ///@}

  ///@{
  /**
   * Set/Get to where the wind blows, anticlockwise from x [deg]. Default: 0.
   */
  vtkSetMacro(WindDirection, double);
  vtkGetMacro(WindDirection, double);
  ///@}

  ///@{
  /**
   * Set/Get the length of water that the wind has blown over [m]. Valid range: [1, 1e6]. Default:
   * 1000.
   */
  vtkSetClampMacro(Fetch, double, 1.0, 1e6);
  vtkGetMacro(Fetch, double);
  ///@}

  ///@{
  /**
   * Set/Get the length of the shortest waves [m]. Valid range: [0.1, 1000]. Default: 0.5.
   */
  vtkSetClampMacro(ShortestWave, double, 0.1, 1000.0);
  vtkGetMacro(ShortestWave, double);
  ///@}

  ///@{
  /**
   * Set/Get the time [s]. Default: 0.
   */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /**
   * Set/Get the key of the random phases. Default: 0.
   */
  vtkSetMacro(Seed, vtkIdType);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  /**
   * Returns the height of the waves at a place and the Time [m].
   */
  double GetHeight(double x, double y);

  /**
   * Returns the significant height of the waves: four times the standard deviation of their height
   * [m].
   */
  double GetSignificantHeight();

protected:
  vtkHeliosWaterWaves() = default;
  ~vtkHeliosWaterWaves() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosWaterWaves(const vtkHeliosWaterWaves&) = delete;
  void operator=(const vtkHeliosWaterWaves&) = delete;

  double WindSpeed = 5.0;
  double WindDirection = 0.0;
  double Fetch = 1000.0;
  double ShortestWave = 0.5;
  double Time = 0.0;
  vtkIdType Seed = 0;
};

#endif
