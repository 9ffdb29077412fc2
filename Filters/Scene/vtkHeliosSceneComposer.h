// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSceneComposer
 * @brief   composes parts into one scene
 *
 * Input 0, repeatable: the parts, each a vtkPolyData of triangles or a raster of heights
 * (vtkImageData, as from vtkHeliosGeoTiffHeightReader), one connection per part. Output 0: one
 * vtkPolyData with
 * - points: the points of all parts, double;
 * - polys: the triangles of all parts, in the order of the connections, in 32-bit storage;
 * - cell data MaterialIds (int): rows of the material columns in the field data, where equal
 *   materials of the parts share one row; a part without MaterialIds has the first row of its own
 *   materials;
 * - cell data PartIds (int): the connection of a triangle;
 * - cell data Normals (float), if parts have them; (0, 0, 0), meaning no normal, for those without;
 * - field data Part.Name (string), one per connection, and CRS, if parts have one: the system of
 *   the first part with one, assumed for parts without.
 *
 * Input 1, optional: instances (vtkPolyData), with the arrays of vtkHeliosScene; PrototypeIds are
 * connections of input 0, which are then no parts themselves, but the meshes of instances. PartIds
 * and FirstCellIds are set: instances are parts after all others, with the names of the point data
 * Part.Name (string), if there is one, unless SetPartId() gives the others ids between them. The
 * output is then a vtkHeliosScene, whose cell ids are in the order of the part ids. So it is with
 * rasters, which are prototypes always: without an instance of its own, one is at its own place.
 *
 * Other arrays are left out. Unchanged data pass by reference: of a single part its points, cells
 * and material ids.
 *
 * Warnings: meshes without triangles (skipped; they keep their id). Errors: no triangles at all,
 * cells that are not triangles, rasters that are not valid, material ids without a material, parts
 * of different CRS (but not different spellings of one), more than 2^31 points or corners, part ids
 * that are given twice, instances of connections that do not exist.
 *
 * @sa
 * vtkHeliosSceneTransform vtkHeliosObjSceneReader
 */

#ifndef vtkHeliosSceneComposer_h
#define vtkHeliosSceneComposer_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include "vtkSmartPointer.h" // For material ids
#include <string>            // For the names of parts
#include <vector>            // For the names of parts

class vtkHeliosScene;
class vtkIntArray;

namespace helios
{
struct Connection;
class InstanceParts;
}

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosSceneComposer : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosSceneComposer* New();
  vtkTypeMacro(vtkHeliosSceneComposer, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the name of a part, by connection index (from 0). An empty name is the default: the
   * index itself.
   */
  void SetPartName(int part, const char* name);
  std::string GetPartName(int part) const;
  ///@}

  ///@{
  /**
   * Set/Get the id of a part, by connection index (from 0), with instances on input 1. Default: the
   * number of connections before it that are parts.
   */
  void SetPartId(int part, int id);
  int GetPartId(int part) const;
  ///@}

  ///@{
  /**
   * Set/Get whether a part, by connection index (from 0), consists of objects that become parts of
   * the scene: its own PartIds, with the names of its own Part.Name. Their ids come after all
   * others; the part's own id then has no triangles. Default: off.
   */
  void SetPartIsSplit(int part, bool isSplit);
  bool GetPartIsSplit(int part) const;
  ///@}

  ///@{
  /**
   * Set/Get whether colours are passed: cell data TextureCoordinates and RGB, NaN for parts
   * without, for GenerateColors of vtkHeliosScanner. Default: off.
   */
  vtkSetMacro(PassColors, bool);
  vtkGetMacro(PassColors, bool);
  vtkBooleanMacro(PassColors, bool);
  ///@}

protected:
  vtkHeliosSceneComposer();
  ~vtkHeliosSceneComposer() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosSceneComposer(const vtkHeliosSceneComposer&) = delete;
  void operator=(const vtkHeliosSceneComposer&) = delete;

  void MakeOutput(vtkInformationVector* inputs, vtkInformationVector* outputVector);
  bool Compose(const std::vector<helios::Connection>& connections, vtkPolyData* output);
  void AddSurfaceArrays(const std::vector<vtkPolyData*>& parts, vtkPolyData* output);
  bool ComposeInstances(
    const std::vector<helios::Connection>& all, vtkPolyData* instances, vtkHeliosScene* output);
  bool FindParts(vtkInformationVector* inputs, std::vector<helios::Connection>& parts);
  std::string DescribePart(int part) const;
  void ReportMaterial(int part, vtkIdType triangle, std::size_t count);
  void AddPartNames(vtkPolyData* scene, int count) const;
  void AddPartNames(
    vtkPolyData* scene, const helios::InstanceParts& split, vtkPolyData* instances) const;
  bool AddCRS(vtkPolyData* scene, const std::vector<helios::Connection>& parts);
  static void AddNotes(vtkPolyData* scene, const std::vector<helios::Connection>& parts);
  bool AddMaterialIds(vtkPolyData* scene, const std::vector<helios::Connection>& connections);
  bool MapMaterials(const std::vector<helios::Connection>& parts,
    const std::vector<std::size_t>& order, vtkPolyData* scene,
    std::vector<vtkSmartPointer<vtkIntArray>>& ids, std::vector<int>& firstRows);

  std::vector<std::string> PartNames;
  std::vector<int> PartIds; // -1: the default
  std::vector<bool> AreSplit;
  bool PassColors = false;
};

#endif
