// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPlantAreaDensity
 * @brief   estimate the plant area density of the cells of a grid from a scan
 *
 * Inputs:
 * - 0: echoes, a vtkPolyData of points;
 * - 1, optional: the pulses that were fired, those without an echo too: points are their origins,
 *   point data Direction and PulseIds, as GeneratePulses of vtkHeliosScanner gives them;
 * - 2, optional: the hits of sub-rays, with PulseIds and Weight: the energy that each intercepts;
 * - 3, optional: a trajectory with GpsTime, for echoes without pulses;
 * - 4, optional: a vtkImageData, whose cells are used; if it is an output of this filter, the beams
 *   are added to those of earlier scans.
 *
 * Without input 1 the pulses are made from the echoes: those with one PulseIds, else with one
 * GpsTime, else each by itself. They begin at the array Origin, on the trajectory, or at
 * BeamOrigin. Pulses without an echo are then unknown, and densities too high wherever beams leave
 * the plants for the sky.
 *
 * Output 0 is a vtkImageData with cell data
 * - PAD (double) [m2/m3], NaN where no beam enters, and DensityError;
 * - CellState: 0 no beam is aimed at the cell, 1 seen, 2 shadowed: all beams end before it, or
 *   fewer than MinimumNumberOfBeams pass it, 3 saturated: no energy leaves it, which Beer and Lambert's law cannot
 *   invert;
 * - NumberOfBeams (int64), NumberOfShadowedBeams, PathLength [m], Transmittance, and the sums that
 *   input 4 continues (vtkHeliosFoliageArrayNames);
 * - field data LeafProjection, rows x y z G, unless G is 0.5: the turbid voxels of a scanner and
 *   this filter use the same G.
 *
 * A beam meets hits with shares of its energy, e is what is left where it enters a cell, d its
 * chord there, w what plants intercept in it after the path z. With g = G d and h = G min(z, d):
 *
 * - CONTACT_FREQUENCY (J. Warren Wilson 1960, New Phytologist 59, 1): sum w / sum e g. Too low by
 *   the factor (1 - exp(-u g)) / (u g): a beam has one contact at most.
 * - BEER_LAMBERT (attenuation by energy; M. Monsi and T. Saeki 1953, Japanese Journal of Botany 14,
 *   22; F. Hosoi and K. Omasa 2006, IEEE TGRS 44, 3610): -ln(1 - sum w / sum e) / mean g. Too high
 *   by 1 / (2 N) p / (1 - p) for few beams, too low for unequal chords, undefined if nothing
 *   passes.
 * - BEER_LAMBERT_CORRECTED (F. Pimont et al. 2018, Remote Sensing of Environment 215, 343): less
 *   the bias of few beams, ln(2 N + 2) / mean g if nothing passes, solved with the variance of the
 *   chords.
 * - MAXIMUM_LIKELIHOOD (M. Beland et al. 2011, Agricultural and Forest Meteorology 151, 1252: the
 *   modified contact frequency): u = sum w / sum h, of all free paths. Too high by sum w h / (sum
 *   h)^2, a share of up to 1 / hits.
 * - MAXIMUM_LIKELIHOOD_CORRECTED (Pimont et al. 2018): less that bias. The default.
 *
 * Hits of what is not counted, such as wood and ground, end the path and are no contacts. The
 * standard error is sqrt(D sum w^2) / sum h (of Beer and Lambert's law the binomial one), with the
 * w of each beam; a cell without contacts has the error of one. The error is that of the beams: leaves
 * of ElementArea A and random orientation, met by L / V beams a square metre, have D = 1 + 2/3 A L / V
 * times the variance of points. Clumps within a cell, wrong G, footprints that leaves fill in part,
 * and beams that are not known are not in it.
 *
 * G is that of LeafAngleDistribution, or with INCIDENCE_ANGLES each hit counts 1 / |cos| of its
 * IncidenceAngle, at most 50: the truth of a simulation of triangles (maximum likelihood only).
 *
 * The sums do not depend on threads. A cell uses 80 bytes a thread, and 120.
 *
 * @warning
 * Beams are lines along the axis of their pulse: cells are to be larger than footprints.
 *
 * @sa
 * vtkHeliosVoxelWriter vtkHeliosVoxelReader vtkHeliosScanner
 */

#ifndef vtkHeliosPlantAreaDensity_h
#define vtkHeliosPlantAreaDensity_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For the settings
#include <string> // For errors

namespace helios
{
class FoliageBeams;
class LeafProjection;
}

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosPlantAreaDensity : public vtkImageAlgorithm
{
public:
  static vtkHeliosPlantAreaDensity* New();
  vtkTypeMacro(vtkHeliosPlantAreaDensity, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Estimators
  {
    CONTACT_FREQUENCY = 0,
    BEER_LAMBERT = 1,
    BEER_LAMBERT_CORRECTED = 2,
    MAXIMUM_LIKELIHOOD = 3,
    MAXIMUM_LIKELIHOOD_CORRECTED = 4
  };

  ///@{
  /**
   * Set/Get the estimator. Default: MAXIMUM_LIKELIHOOD_CORRECTED.
   */
  vtkSetClampMacro(Estimator, int, CONTACT_FREQUENCY, MAXIMUM_LIKELIHOOD_CORRECTED);
  vtkGetMacro(Estimator, int);
  void SetEstimatorToContactFrequency() { this->SetEstimator(CONTACT_FREQUENCY); }
  void SetEstimatorToBeerLambert() { this->SetEstimator(BEER_LAMBERT); }
  void SetEstimatorToBeerLambertCorrected() { this->SetEstimator(BEER_LAMBERT_CORRECTED); }
  void SetEstimatorToMaximumLikelihood() { this->SetEstimator(MAXIMUM_LIKELIHOOD); }
  void SetEstimatorToMaximumLikelihoodCorrected()
  {
    this->SetEstimator(MAXIMUM_LIKELIHOOD_CORRECTED);
  }
  ///@}

  /// Distributions of the angles of leaf normals from the vertical; uniform in azimuth.
  enum LeafAngleDistributions
  {
    SPHERICAL = 0,
    UNIFORM = 1,
    PLANOPHILE = 2,
    ERECTOPHILE = 3,
    PLAGIOPHILE = 4,
    EXTREMOPHILE = 5,
    ELLIPSOIDAL = 6,
    HORIZONTAL = 7,
    VERTICAL = 8,
    TABLE = 9,
    INCIDENCE_ANGLES = 10
  };

  ///@{
  /**
   * Set/Get the leaf angles: distributions of N. Goel and D. Strebel (1984), the ellipsoidal one of G. Campbell
   * (1986), a TABLE, which is the field data LeafProjection of input 4, or INCIDENCE_ANGLES of the
   * hits. Default: SPHERICAL.
   */
  vtkSetClampMacro(LeafAngleDistribution, int, SPHERICAL, INCIDENCE_ANGLES);
  vtkGetMacro(LeafAngleDistribution, int);
  ///@}

  ///@{
  /**
   * Set/Get the ratio of the horizontal to the vertical axis of ELLIPSOIDAL. Valid range:
   * [0.01, 100]. Default: 1.
   */
  vtkSetClampMacro(EllipsoidRatio, double, 0.01, 100.0);
  vtkGetMacro(EllipsoidRatio, double);
  ///@}

  enum EchoSharesTypes
  {
    EQUAL = 0,      ///< the pulse in equal parts, by NumberOfReturns
    FIRST = 1,      ///< the first echo has all
    ENERGY = 2,     ///< by amplitude (or intensity), echo width and squared range
    REFLECTANCE = 3 ///< by the array Reflectance [dB] over that of an element that fills the beam
  };

  ///@{
  /**
   * Set/Get the shares of the echoes of a pulse in its energy; without amplitudes ENERGY is EQUAL.
   * Of all but REFLECTANCE the shares of a pulse add up to 1: a partial hit before the sky counts as
   * a whole one. Those of REFLECTANCE are the energy over that of a plant element that fills the
   * beam at a random angle, and leave the rest of a pulse to what is behind, also where an oblique
   * element fills the beam: densities are too low. An echo that is not counted has the rest. Not used with input 2. Default: ENERGY.
   */
  vtkSetClampMacro(EchoShares, int, EQUAL, REFLECTANCE);
  vtkGetMacro(EchoShares, int);
  ///@}

  ///@{
  /**
   * Set/Get the reflectance of plant elements at normal incidence, of REFLECTANCE. Valid range:
   * [0.001, 1]. Default: 0.5.
   */
  vtkSetClampMacro(ElementReflectance, double, 0.001, 1.0);
  vtkGetMacro(ElementReflectance, double);
  ///@}

  ///@{
  /**
   * Set/Get the edge of a cell without input 4 [m]. Valid range: [0.001, 10000]. Default: 0.5.
   */
  vtkSetClampMacro(VoxelSize, double, 0.001, 10000.0);
  vtkGetMacro(VoxelSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the bounds of the grid without input 4 [m]: x y z from their minimum up in whole cells.
   * Default: not valid (1, -1), then the bounds of the counted hits, in multiples of VoxelSize.
   */
  vtkSetVector6Macro(GridBounds, double);
  vtkGetVector6Macro(GridBounds, double);
  ///@}

  ///@{
  /**
   * Set/Get the place where all beams begin, of echoes without pulses [m]. Default: NaN, unknown.
   */
  vtkSetVector3Macro(BeamOrigin, double);
  vtkGetVector3Macro(BeamOrigin, double);
  ///@}

  ///@{
  /**
   * Set/Get the area of one side of a leaf [m2], for standard errors and effective paths (Pimont et
   * al. 2018). Valid range: [0, 100]. Default: 0, small.
   */
  vtkSetClampMacro(ElementArea, double, 0.0, 100.0);
  vtkGetMacro(ElementArea, double);
  ///@}

  ///@{
  /**
   * Set/Get the range beyond which nothing is detected [m]: beams end there. Valid range: [0,
   * 1e300]. Default: 1e300.
   */
  vtkSetClampMacro(MaximumRange, double, 0.0, 1e300);
  vtkGetMacro(MaximumRange, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of beams that a cell needs to be seen: the free path of all energy, over the
   * edge of the cell. Valid range: [1e-6, 1e6]. Default: 1.
   */
  vtkSetClampMacro(MinimumNumberOfBeams, double, 1e-6, 1e6);
  vtkGetMacro(MinimumNumberOfBeams, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of grid cells, a memory guard. Valid range: [1, 2e9]. Default:
   * 100000000.
   */
  vtkSetClampMacro(MaximumNumberOfCells, vtkIdType, 1, 2000000000);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  ///@}

  ///@{
  /**
   * Add/Remove classes and materials (ids) of echoes that are counted. With both, an echo needs
   * one of each. Default: none, then all classes but ground (2), water (9) and noise (7, 18). Noise
   * is dropped: it ends no beam.
   */
  void AddCountedClass(int id);
  void AddCountedMaterial(int id);
  void RemoveAllCounted();
  ///@}

  /**
   * Returns whether a class is counted if none are added.
   */
  static bool IsPlantClass(int id);

  /**
   * Returns the number of beams of the last update.
   */
  vtkGetMacro(NumberOfBeams, vtkIdType);

protected:
  vtkHeliosPlantAreaDensity();
  ~vtkHeliosPlantAreaDensity() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosPlantAreaDensity(const vtkHeliosPlantAreaDensity&) = delete;
  void operator=(const vtkHeliosPlantAreaDensity&) = delete;

  class Internals;

  std::string BuildBeams(vtkInformationVector** inputVector, helios::FoliageBeams& beams);
  std::string SetGrid(const helios::FoliageBeams& beams, vtkImageData* given, vtkImageData* grid);
  std::string SetLeaves(vtkImageData* given, helios::LeafProjection& leaves);
  std::string AddBeams(const helios::FoliageBeams& beams, const helios::LeafProjection& leaves,
    vtkImageData* given, vtkImageData* grid);

  std::unique_ptr<Internals> Counted;
  int Estimator = MAXIMUM_LIKELIHOOD_CORRECTED;
  int LeafAngleDistribution = SPHERICAL;
  double EllipsoidRatio = 1.0;
  int EchoShares = ENERGY;
  double VoxelSize = 0.5;
  double GridBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double BeamOrigin[3];
  double ElementArea = 0.0;
  double MaximumRange = 1e300;
  double ElementReflectance = 0.5;
  double MinimumNumberOfBeams = 1.0;
  vtkIdType MaximumNumberOfCells = 100000000;
  vtkIdType NumberOfBeams = 0;
};

#endif
