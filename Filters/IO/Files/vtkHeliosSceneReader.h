// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSceneReader
 * @brief   read a file as a scene: what all formats share
 *
 * Output 0 is a vtkPolyData of triangles:
 * - points: the vertices used by triangles, in file order, double;
 * - polys: the triangles in file order, in 32-bit storage;
 * - cell data MaterialIds (int): row index into the material columns;
 * - cell data PartIds (int), of files with objects: row index into the field data Part.Name;
 * - field data: the material columns (Material.Name, Material.Reflectance, ...), and CRS if the file
 *   has one.
 *
 * Degenerate triangles are dropped with one warning; so is a vertex more than 1e7 m away from the
 * others reported, and a file without triangles.
 *
 * A progress event is sent per MiB read; AbortExecute stops reading, and the update fails.
 *
 * @sa
 * vtkHeliosObjSceneReader vtkHeliosPLYSceneReader vtkHeliosSTLSceneReader vtkHeliosCityJSONReader
 * vtkHeliosGLTFSceneReader
 */

#ifndef vtkHeliosSceneReader_h
#define vtkHeliosSceneReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <functional> // For the places of vertices
#include <string>     // For the places of vertices

namespace helios
{
class SceneMesh;
struct TextReport;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosSceneReader : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkHeliosSceneReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum UpAxisType
  {
    UP_AXIS_Y = 1,
    UP_AXIS_Z = 2
  };

  ///@{
  /**
   * Set/Get the file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get the up axis of the file. With y the scene points are (x, -z, y). Valid range:
   * UP_AXIS_Y, UP_AXIS_Z. Default: UP_AXIS_Z, of glTF UP_AXIS_Y.
   */
  vtkSetClampMacro(UpAxis, int, UP_AXIS_Y, UP_AXIS_Z);
  vtkGetMacro(UpAxis, int);
  void SetUpAxisToY() { this->SetUpAxis(UP_AXIS_Y); }
  void SetUpAxisToZ() { this->SetUpAxis(UP_AXIS_Z); }
  ///@}

  ///@{
  /**
   * Set/Get whether all triangles and vertices of the file are kept, without area, or not used: frames of
   * a mesh that deforms have the same ones. Images cut nothing then. Default: false.
   */
  vtkSetMacro(KeepAll, bool);
  vtkGetMacro(KeepAll, bool);
  vtkBooleanMacro(KeepAll, bool);
  ///@}

  ///@{
  /**
   * Get the number of faces of the file of the last read with KeepAll, and a hash of their vertices.
   */
  vtkGetMacro(NumberOfFaces, vtkIdType);
  vtkGetMacro(FaceHash, vtkTypeUInt64);
  ///@}

  /**
   * Get the number of degenerate triangles dropped by the last read.
   */
  vtkGetMacro(NumberOfDroppedTriangles, vtkIdType);

protected:
  vtkHeliosSceneReader();
  ~vtkHeliosSceneReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /**
   * Describe a format: its name, what a file without triangles lacks, and how a file is read into a
   * scene. False after an error, which is in the report.
   */
  virtual const char* GetFormatName() const = 0;
  virtual const char* GetFaceExample() const { return "faces"; }
  virtual bool ReadScene(vtkPolyData* scene, helios::TextReport& report) = 0;
  ///@}

  /**
   * Checks what was read, drops triangles without area and unused vertices, turns the up axis, and
   * moves all to the scene. findPlace gives "path:line: " of a vertex; default: the path.
   */
  void Finish(helios::SceneMesh& mesh, vtkPolyData* scene, helios::TextReport& report,
    const std::function<std::string(vtkIdType)>& findPlace = {});

  /**
   * Reports the share of the file that was read; false if reading was aborted.
   */
  bool ReportBlock(double progress);

private:
  vtkHeliosSceneReader(const vtkHeliosSceneReader&) = delete;
  void operator=(const vtkHeliosSceneReader&) = delete;

  bool ReadFile(vtkPolyData* scene, helios::TextReport& report);

  char* FileName = nullptr;
  int UpAxis = UP_AXIS_Z;
  bool KeepAll = false;
  vtkIdType NumberOfDroppedTriangles = 0;
  vtkIdType NumberOfFaces = 0;
  vtkTypeUInt64 FaceHash = 0;
};

#endif
