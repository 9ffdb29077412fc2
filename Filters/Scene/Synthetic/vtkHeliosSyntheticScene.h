// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSyntheticScene
 * @brief   procedural scenes: closed-form shapes, terrain, trees, a house
 *
 * Output 0 is a vtkPolyData of triangles: double points, 32-bit cells, cell data MaterialIds (int)
 * and the material columns in the field data, with reflectances and LAS classes (ground 2, low
 * vegetation 3, high vegetation 5, building 6). Closed shapes are watertight, with outward normals;
 * no triangle has zero area. The same properties give byte-identical output for any number of
 * threads.
 *
 * All kinds are placed about Origin, z up. Meaning of Size, Height and Resolution n, with the
 * defaults used for 0:
 * - Plane: a square of side Size (100), n x n squares (1), at z = 0;
 * - Step: a square of side Size (100), z = 0 for x < 0, z = Height (10) for x > 0 and the riser at
 *   x = 0; half planes and riser of n x n rectangles (1);
 * - Sphere: diameter Size (10) about Origin; an icosahedron whose edges are cut into n (32), 20 n^2
 *   triangles, all corners on the sphere;
 * - Pyramid: a square base of side Size (10) at z = 0, Height (10), edges cut into n (1);
 * - Terrain: the hills of GetTerrainHeight over a square of side Size (1000), n x n squares (1000);
 *   Height (20) bounds the height range;
 * - Canopy: hills over a square of side Size (100), n x n squares (200), and on them NumberOfTrees
 *   broadleaf trees and conifers of up to Height (15), each with NumberOfLeaves (0: 2500); together
 *   about a million triangles;
 * - Blocks: boxes of up to Height (10), of any heading, on a square ground of side Size (100) of n
 *   x n squares (7), one on each except at the centre;
 * - House: Size is the length (12) along y, Height the height of the ridge (8); gabled roof with
 *   eaves, chimney, recessed windows and door (n is not used);
 * - Tree: Height (12; a shrub 1.5), Size the diameter of the crown (0.6 of the height; a conifer
 *   0.38 times that, a shrub as much), NumberOfLeaves (0: 5000; a shrub 1500).
 *
 * Errors: properties that are not finite, more than 500 million triangles.
 *
 * @sa
 * vtkHeliosSceneTransform vtkHeliosSceneComposer vtkHeliosObjSceneWriter
 */

#ifndef vtkHeliosSyntheticScene_h
#define vtkHeliosSyntheticScene_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosSyntheticScene : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSyntheticScene* New();
  vtkTypeMacro(vtkHeliosSyntheticScene, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum KindType
  {
    PLANE = 0,
    STEP,
    SPHERE,
    PYRAMID,
    TERRAIN,
    CANOPY,
    BLOCKS,
    HOUSE,
    TREE
  };

  enum SpeciesType
  {
    BROADLEAF = 0,
    CONIFER,
    SHRUB
  };

  ///@{
  /**
   * Set/Get the kind of scene. Valid range: PLANE to TREE. Default: PLANE.
   */
  vtkSetClampMacro(Kind, int, PLANE, TREE);
  vtkGetMacro(Kind, int);
  void SetKindToPlane() { this->SetKind(PLANE); }
  void SetKindToStep() { this->SetKind(STEP); }
  void SetKindToSphere() { this->SetKind(SPHERE); }
  void SetKindToPyramid() { this->SetKind(PYRAMID); }
  void SetKindToTerrain() { this->SetKind(TERRAIN); }
  void SetKindToCanopy() { this->SetKind(CANOPY); }
  void SetKindToBlocks() { this->SetKind(BLOCKS); }
  void SetKindToHouse() { this->SetKind(HOUSE); }
  void SetKindToTree() { this->SetKind(TREE); }
  ///@}

  /**
   * Returns the kind as text: "Plane" to "Tree".
   */
  const char* GetKindAsString();

  ///@{
  /**
   * Set/Get the extent [m], see above. Valid range: [0, 1e7]; 0: the kind's own. Default: 0.
   */
  vtkSetClampMacro(Size, double, 0.0, 1e7);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /**
   * Set/Get the height [m], see above. Valid range: [0, 1e5]; 0: the kind's own. Default: 0.
   */
  vtkSetClampMacro(Height, double, 0.0, 1e5);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of segments of an edge, see above. Valid range: [0, 10000]; 0: the kind's
   * own. Default: 0.
   */
  vtkSetClampMacro(Resolution, int, 0, 10000);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Set/Get the position of the scene [m], added to every point at the end. Default: 0, 0, 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Set/Get the key of the random numbers, for Terrain, Canopy, Blocks and Tree. Valid range: any.
   * Default: 0.
   */
  vtkSetMacro(Seed, vtkIdType);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/Get the species of a Tree. Valid range: BROADLEAF to SHRUB. Default: BROADLEAF.
   */
  vtkSetClampMacro(Species, int, BROADLEAF, SHRUB);
  vtkGetMacro(Species, int);
  void SetSpeciesToBroadleaf() { this->SetSpecies(BROADLEAF); }
  void SetSpeciesToConifer() { this->SetSpecies(CONIFER); }
  void SetSpeciesToShrub() { this->SetSpecies(SHRUB); }
  ///@}

  ///@{
  /**
   * Set/Get the number of trees of a Canopy. Valid range: [0, 1e6]. Default: 150.
   */
  vtkSetClampMacro(NumberOfTrees, int, 0, 1000000);
  vtkGetMacro(NumberOfTrees, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of leaves of a Tree, or of each tree of a Canopy; more leaves are smaller.
   * Valid range: [0, 1e7]; 0: the kind's own. Default: 0.
   */
  vtkSetClampMacro(NumberOfLeaves, int, 0, 10000000);
  vtkGetMacro(NumberOfLeaves, int);
  ///@}

  /**
   * Returns the z of the hills of Terrain and Canopy at x, y of the scene [m], in closed form: a
   * sum of sine waves with lengths from 0.8 Size down to Size / 240. The mesh is exact at its
   * points.
   */
  double GetTerrainHeight(double x, double y);

protected:
  vtkHeliosSyntheticScene();
  ~vtkHeliosSyntheticScene() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosSyntheticScene(const vtkHeliosSyntheticScene&) = delete;
  void operator=(const vtkHeliosSyntheticScene&) = delete;

  int Kind = PLANE;
  double Size = 0.0;
  double Height = 0.0;
  int Resolution = 0;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  vtkIdType Seed = 0;
  int Species = BROADLEAF;
  int NumberOfTrees = 150;
  int NumberOfLeaves = 0;
};

#endif
