// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosCropFieldSource
 * @brief   a field of crops with individual leaves, and its ground truth
 *
 * Output 0 is a scene: a vtkPolyData of triangles, double points, 32-bit cells, cell data MaterialIds
 * and PartIds (int; 0 the soil, from 1 on the plants), the material columns in the field data: soil
 * (ground, LAS class 2), crop_stem, crop_leaf and crop_ear (low vegetation, 3).
 *
 * Rows go along y, adjacent along x, the centre of the field is at Origin, z up. A plant is one or
 * more stems, closed tapered tubes that lean by up to 4 % of their height (cereal 18 %, broadleaf
 * 8 %) and extend 2 cm into the soil, and leaves assigned to the stems in turn. A leaf is a strip
 * of LeafSegments plane quads along an arc of a circle that starts LeafAngle from the vertical and
 * bends by LeafDroop; its width at a share t of its length is the parabola LeafWidth (1 - ((t - m)
 * / (1 - m))^2). Leaves at the share h of the stem are 1 - 0.45 (2 h - 1)^2 of LeafLength and
 * LeafWidth, largest in the middle; a taller plant is larger in all its parts. A leaf that would
 * reach into the soil is raised until it does not. The species, and their defaults for properties
 * of 0 (below 0 for LeavesPerPlant and LeafDroop):
 * - Maize: alternate leaves in one plane, m = 0.4; rows at 0.75 m, plants at 0.16 m, height 2.2 m, stem
 *   radius 12 mm, 12 leaves of 0.8 x 0.09 m, angle 28, droop 95 deg, 8 segments;
 * - Cereal: 4 tillers of 3 leaves, m = 0.2, each with an ear at its top; rows at 0.125 m, plants at
 *   0.05 m, height 0.9 m, radius 1.8 mm, leaves of 0.22 x 0.014 m, angle 25, droop 85 deg, 5 segments;
 * - Broadleaf: oval leaves, m = 0.5, on stalks that are 0.6 of their length, around the stem by the
 *   golden angle; rows at 0.5 m, plants at 0.2 m, height 0.6 m, radius 5 mm, 24 leaves of 0.14 x 0.1 m,
 *   angle 50, droop 50 deg, 6 segments.
 *
 * The ground truth, in the field data: Field.LeafArea [m2], one side of all leaves, the sum of the
 * areas of the triangles of crop_leaf; Field.GroundArea [m2], rows x RowSpacing x plants per row x
 * PlantSpacing; Field.LeafAreaIndex, their ratio; one row per plant: Plant.Position (x y z, at the
 * soil), Plant.Height [m] and Plant.LeafArea [m2].
 *
 * Random numbers are keyed by Seed, row and position in the row: the same properties give
 * byte-identical output, and more rows do not change existing plants. Normal deviations are cut at
 * 3 sigma.
 *
 * Errors: properties that are not finite, a PlantHeightDeviation of a quarter of the height or more,
 * more than 500 million triangles.
 *
 * @warning
 * Leaves are flat across, and plants may intersect. No species is fitted to measured plants.
 *
 * @sa
 * vtkHeliosSyntheticScene vtkHeliosObjSceneWriter
 */

#ifndef vtkHeliosCropFieldSource_h
#define vtkHeliosCropFieldSource_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosCropFieldSource : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosCropFieldSource* New();
  vtkTypeMacro(vtkHeliosCropFieldSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SpeciesType
  {
    MAIZE = 0,
    CEREAL,
    BROADLEAF
  };

  ///@{
  /**
   * Set/Get the species. Valid range: MAIZE to BROADLEAF. Default: MAIZE.
   */
  vtkSetClampMacro(Species, int, MAIZE, BROADLEAF);
  vtkGetMacro(Species, int);
  void SetSpeciesToMaize() { this->SetSpecies(MAIZE); }
  void SetSpeciesToCereal() { this->SetSpecies(CEREAL); }
  void SetSpeciesToBroadleaf() { this->SetSpecies(BROADLEAF); }
  ///@}

  /**
   * Returns the species as text: "Maize" to "Broadleaf".
   */
  const char* GetSpeciesAsString();

  ///@{
  /**
   * Set/Get the number of rows. Valid range: [1, 1e6]. Default: 10.
   */
  vtkSetClampMacro(NumberOfRows, int, 1, 1000000);
  vtkGetMacro(NumberOfRows, int);
  ///@}

  ///@{
  /**
   * Set/Get the distance from row to row [m]. Valid range: [0, 1000]; 0: the species' own. Default: 0.
   */
  vtkSetClampMacro(RowSpacing, double, 0.0, 1000.0);
  vtkGetMacro(RowSpacing, double);
  ///@}

  ///@{
  /**
   * Set/Get the distance from plant to plant in a row [m]. Valid range: [0, 1000]; 0: the species' own.
   * Default: 0.
   */
  vtkSetClampMacro(PlantSpacing, double, 0.0, 1000.0);
  vtkGetMacro(PlantSpacing, double);
  ///@}

  ///@{
  /**
   * Set/Get the length of a row [m], from its first plant to its last; 0: one plant. Valid range: [0, 1e5].
   * Default: 10.
   */
  vtkSetClampMacro(RowLength, double, 0.0, 1e5);
  vtkGetMacro(RowLength, double);
  ///@}

  ///@{
  /**
   * Set/Get the emergence probability of plants. Valid range: [0, 1]. Default: 0.95.
   */
  vtkSetClampMacro(Emergence, double, 0.0, 1.0);
  vtkGetMacro(Emergence, double);
  ///@}

  ///@{
  /**
   * Set/Get the standard deviation of plant positions [m], in x and in y. Valid range: [0, 100].
   * Default: 0.01.
   */
  vtkSetClampMacro(PositionJitter, double, 0.0, 100.0);
  vtkGetMacro(PositionJitter, double);
  ///@}

  ///@{
  /**
   * Set/Get the mean height of plants [m], from the soil to the top of the first stem. Valid range: [0, 100];
   * 0: the species' own. Default: 0.
   */
  vtkSetClampMacro(PlantHeight, double, 0.0, 100.0);
  vtkGetMacro(PlantHeight, double);
  ///@}

  ///@{
  /**
   * Set/Get the standard deviation of heights [m]. Valid range: [0, 25], below a quarter of the height.
   * Default: 0.05.
   */
  vtkSetClampMacro(PlantHeightDeviation, double, 0.0, 25.0);
  vtkGetMacro(PlantHeightDeviation, double);
  ///@}

  ///@{
  /**
   * Set/Get the radius of stems at the soil [m]. Valid range: [0, 1]; 0: the species' own. Default: 0.
   */
  vtkSetClampMacro(StemRadius, double, 0.0, 1.0);
  vtkGetMacro(StemRadius, double);
  ///@}

  ///@{
  /**
   * Set/Get the stems per plant; a cereal's are its tillers. Valid range: [0, 100]; 0: the species'
   * own. Default: 0.
   */
  vtkSetClampMacro(StemsPerPlant, int, 0, 100);
  vtkGetMacro(StemsPerPlant, int);
  ///@}

  ///@{
  /**
   * Set/Get the leaves per plant, on all its stems together. Valid range: [-1, 1e6]; -1: the
   * species' own. Default: -1.
   */
  vtkSetClampMacro(LeavesPerPlant, int, -1, 1000000);
  vtkGetMacro(LeavesPerPlant, int);
  ///@}

  ///@{
  /**
   * Set/Get the length along the largest leaves [m]. Valid range: [0, 100]; 0: the species' own. Default: 0.
   */
  vtkSetClampMacro(LeafLength, double, 0.0, 100.0);
  vtkGetMacro(LeafLength, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum width of the largest leaves [m]. Valid range: [0, 10]; 0: the species' own.
   * Default: 0.
   */
  vtkSetClampMacro(LeafWidth, double, 0.0, 10.0);
  vtkGetMacro(LeafWidth, double);
  ///@}

  ///@{
  /**
   * Set/Get the angle of leaves at their base from the vertical [deg]. Valid range: [0, 90]; 0: the species'
   * own. Default: 0.
   */
  vtkSetClampMacro(LeafAngle, double, 0.0, 90.0);
  vtkGetMacro(LeafAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the bend of leaves from base to tip [deg]. Valid range: [-1, 180]; -1: the species'
   * own. A tip points straight down at most. Default: -1.
   */
  vtkSetClampMacro(LeafDroop, double, -1.0, 180.0);
  vtkGetMacro(LeafDroop, double);
  ///@}

  ///@{
  /**
   * Set/Get the relative variation of length, width, angle and droop of leaves, uniform. Valid
   * range: [0, 0.9]. Default: 0.15.
   */
  vtkSetClampMacro(LeafVariation, double, 0.0, 0.9);
  vtkGetMacro(LeafVariation, double);
  ///@}

  ///@{
  /**
   * Set/Get the segments of a leaf along its length; 1 counts as 2. Valid range: [0, 100]; 0: the
   * species' own. Default: 0.
   */
  vtkSetClampMacro(LeafSegments, int, 0, 100);
  vtkGetMacro(LeafSegments, int);
  ///@}

  ///@{
  /**
   * Set/Get the margin of soil beyond the outer plants [m]. Valid range: [0.01, 1e5]. Default: 1.
   */
  vtkSetClampMacro(GroundMargin, double, 0.01, 1e5);
  vtkGetMacro(GroundMargin, double);
  ///@}

  ///@{
  /**
   * Set/Get the bound on the height range of the soil [m]; 0: flat, two triangles. Valid range:
   * [0, 10]. Default: 0.04.
   */
  vtkSetClampMacro(GroundRoughness, double, 0.0, 10.0);
  vtkGetMacro(GroundRoughness, double);
  ///@}

  ///@{
  /**
   * Set/Get the maximum cell size of rough soil [m]. Valid range: [0.001, 1e5]. Default: 0.1.
   */
  vtkSetClampMacro(GroundSpacing, double, 0.001, 1e5);
  vtkGetMacro(GroundSpacing, double);
  ///@}

  ///@{
  /**
   * Set/Get the centre of the field [m], added to every point at the end. Default: 0, 0, 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Set/Get the key of the random numbers. Valid range: any. Default: 0.
   */
  vtkSetMacro(Seed, vtkIdType);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  /**
   * Returns the number of plant positions in a row: RowLength / PlantSpacing, plus one.
   */
  vtkIdType GetPlantsPerRow();

protected:
  vtkHeliosCropFieldSource();
  ~vtkHeliosCropFieldSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosCropFieldSource(const vtkHeliosCropFieldSource&) = delete;
  void operator=(const vtkHeliosCropFieldSource&) = delete;

  bool CheckProperties();

  int Species = MAIZE;
  int NumberOfRows = 10;
  double RowSpacing = 0.0;
  double PlantSpacing = 0.0;
  double RowLength = 10.0;
  double Emergence = 0.95;
  double PositionJitter = 0.01;
  double PlantHeight = 0.0;
  double PlantHeightDeviation = 0.05;
  double StemRadius = 0.0;
  int StemsPerPlant = 0;
  int LeavesPerPlant = -1;
  double LeafLength = 0.0;
  double LeafWidth = 0.0;
  double LeafAngle = 0.0;
  double LeafDroop = -1.0;
  double LeafVariation = 0.15;
  int LeafSegments = 0;
  double GroundMargin = 1.0;
  double GroundRoughness = 0.04;
  double GroundSpacing = 0.1;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  vtkIdType Seed = 0;
};

#endif
