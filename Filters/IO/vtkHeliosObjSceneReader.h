// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosObjSceneReader
 * @brief   a Wavefront OBJ file as a scene
 *
 * Output 0 is a vtkPolyData of triangles:
 * - points: the vertices that triangles use, in file order, double and correctly rounded;
 * - polys: the faces in file order, in 32-bit storage;
 * - cell data MaterialIds (int): a triangle's row of the material columns;
 * - field data: the material columns (Material.Name, Material.Reflectance, ...), one row for each
 *   material of the libraries (mtllib), used or not, in file order.
 *
 * Read are v, vn, vt, f, mtllib and usemtl; o, g, s, l, p and colours behind a vertex are left out.
 * A face with more than three corners becomes a fan of triangles about its first corner. Negative
 * indices count backwards. A long line may go on behind a backslash. mtllib names one file, blanks
 * included, or several, in the folder of the OBJ file. Material files have Kd, Ks, Ns and the keys
 * helios_reflectance [0..1], helios_isGround, helios_classification and helios_spectra; the
 * specularity of a material is sum Ks / (sum Kd + sum Ks). Names of materials may have blanks; one
 * that is not found whole is looked for by its first word.
 *
 * The file is checked line by line. Errors end the reading without output: a malformed number, a
 * coordinate that is NaN or infinite, an index out of range (of vertices, texture coordinates or
 * normals), a face with fewer than three corners, a reflectance outside [0, 100]. Warned of are
 * triangles without area (dropped), vertices 1e7 m away from the others, unknown keywords, a
 * reflectance above 1 (taken for percent), a missing material file and unknown materials (both give
 * default properties), a file without faces.
 * Messages start with file:line.
 *
 * Progress events come for every MiB read; AbortExecute ends the reading, and the update fails.
 *
 * @warning
 * The fan is right for convex faces, and for concave ones that their first corner sees whole. Other
 * concave faces are to be made triangles by the program that wrote them.
 *
 * @sa
 * vtkHeliosObjSceneWriter vtkHeliosSceneComposer
 */

#ifndef vtkHeliosObjSceneReader_h
#define vtkHeliosObjSceneReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosObjSceneReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosObjSceneReader* New();
  vtkTypeMacro(vtkHeliosObjSceneReader, vtkPolyDataAlgorithm);
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
   * Set/Get the axis of the file that points up. With y the scene's points are (x, -z, y). Valid
   * range: UP_AXIS_Y, UP_AXIS_Z. Default: UP_AXIS_Z.
   */
  vtkSetClampMacro(UpAxis, int, UP_AXIS_Y, UP_AXIS_Z);
  vtkGetMacro(UpAxis, int);
  void SetUpAxisToY() { this->SetUpAxis(UP_AXIS_Y); }
  void SetUpAxisToZ() { this->SetUpAxis(UP_AXIS_Z); }
  ///@}

  /**
   * The number of triangles without area that the last reading left out.
   */
  vtkGetMacro(NumberOfDroppedTriangles, vtkIdType);

protected:
  vtkHeliosObjSceneReader();
  ~vtkHeliosObjSceneReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosObjSceneReader(const vtkHeliosObjSceneReader&) = delete;
  void operator=(const vtkHeliosObjSceneReader&) = delete;

  bool ReportBlock(double progress);

  char* FileName = nullptr;
  int UpAxis = UP_AXIS_Z;
  vtkIdType NumberOfDroppedTriangles = 0;
};

#endif
