// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosCityJSONReader
 * @brief   read a city model in CityJSON as a scene
 *
 * CityJSON 2.0 and 1.1, and text sequences of features (.jsonl: CityJSONSeq), whose first line has
 * the metadata. Output 0 is a scene, as from every vtkHeliosSceneReader:
 * - points: scale times integer plus translation of the file's transform, in double;
 * - triangles of the surfaces of MultiSurface, CompositeSurface, Solid, MultiSolid, CompositeSolid,
 *   and of templates (GeometryInstance), in the order of the objects' names. Surfaces may be
 *   concave and have holes. Points and lines are not read;
 * - cell data PartIds (int), the objects with triangles, and their ids in the field data Part.Name;
 * - one material for each kind of surface, named like its semantic type (RoofSurface, WallSurface,
 *   ...), else like its object (Road, PlantCover, ...). Classes are classes of LAS 1.4: Building*
 *   6, Bridge* 17, Road and TransportSquare 11, Railway 10, Water* 9, LandUse and TINRelief 2,
 *   PlantCover 4, SolitaryVegetationObject 5, others 0. Ground are LandUse, TINRelief, roads,
 *   squares and railways. ClosureSurface and WaterClosureSurface are not material, and left out;
 * - field data CRS: "EPSG:n" of metadata.referenceSystem.
 *
 * A file has objects at several levels of detail. LevelOfDetail selects one; without it, the
 * highest of each object is read, and an object with parts (BuildingPart, ...) of a higher level is
 * given by its parts alone.
 *
 * Errors, without output: text that is not JSON, another version, a vertex that is malformed, an
 * index out of range, a level of detail that no object has. Messages start with file:line and name
 * the object. Warnings: surfaces whose sides cross, objects without the LevelOfDetail, a
 * referenceSystem that is not understood, degenerate triangles (dropped).
 *
 * @warning
 * The file is in memory as a tree of values while it is read.
 *
 * @sa
 * vtkHeliosSceneReader vtkHeliosReproject
 */

#ifndef vtkHeliosCityJSONReader_h
#define vtkHeliosCityJSONReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosSceneReader.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosCityJSONReader : public vtkHeliosSceneReader
{
public:
  static vtkHeliosCityJSONReader* New();
  vtkTypeMacro(vtkHeliosCityJSONReader, vtkHeliosSceneReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the level of detail, as in the file, such as 2.2. Default: none, which is the highest of
   * each object.
   */
  vtkSetStringMacro(LevelOfDetail);
  vtkGetStringMacro(LevelOfDetail);
  ///@}

  ///@{
  /**
   * Set/Get an MTL file: materials with the name of one of the scene replace it (RoofSurface, Road,
   * ...). A class of 0 keeps the class of the scene. Default: none.
   */
  vtkSetFilePathMacro(MaterialFileName);
  vtkGetFilePathMacro(MaterialFileName);
  ///@}

protected:
  vtkHeliosCityJSONReader() = default;
  ~vtkHeliosCityJSONReader() override;

  const char* GetFormatName() const override { return "CityJSON"; }
  const char* GetFaceExample() const override { return "objects with surfaces"; }
  bool ReadScene(vtkPolyData* scene, helios::TextReport& report) override;

private:
  vtkHeliosCityJSONReader(const vtkHeliosCityJSONReader&) = delete;
  void operator=(const vtkHeliosCityJSONReader&) = delete;

  char* LevelOfDetail = nullptr;
  char* MaterialFileName = nullptr;
};

#endif
