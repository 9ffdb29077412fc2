// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosObjSceneReader
 * @brief   read a Wavefront OBJ file as a scene
 *
 * Output 0 is a vtkPolyData of triangles:
 * - points: the vertices used by triangles, in file order, double and correctly rounded;
 * - polys: the faces in file order, in 32-bit storage;
 * - cell data MaterialIds (int): row index into the material columns;
 * - field data: the material columns (Material.Name, Material.Reflectance, ...), one row for each
 *   material of the libraries (mtllib), used or not, in file order.
 *
 * Keywords read: v, vn, vt, f, mtllib and usemtl; o, g, s, l, p and vertex colours are ignored. A
 * face with more than three corners becomes a triangle fan about its first corner if it is convex;
 * others are triangulated, also if they touch themselves. Negative indices count backwards. A backslash continues a line. mtllib names one file, blanks included, or
 * several, in the folder of the OBJ file. Material files have Kd, Ks, Ns and the keys
 * helios_reflectance [0..1], helios_isGround, helios_classification and helios_spectra; the
 * specularity of a material is sum Ks / (sum Kd + sum Ks). Material names may contain blanks; a
 * name that is not found as a whole is searched by its first word.
 *
 * Images cut triangles: map_d (its transparency, or its luminance if it has none; -imfchan m, l, r,
 * g, b and -clamp on are read), else the transparency of map_Kd, of PNG images. Where the image is
 * less than half opaque, nothing is left; what is left are triangles, after all others, whose outlines
 * are within a pixel of the image's and have its area. The file is read twice then. Field data Notes
 * (strings) say what was cut.
 *
 * The file is checked line by line. Errors, without output: a malformed number, a coordinate that
 * is NaN or infinite, an index of a vertex out of range, a face with fewer than three corners, a
 * reflectance outside [0, 100]. Warnings: indices of texture coordinates or normals out of range,
 * which are not used, faces whose sides cross, images that should cut triangles and cannot, which
 * are scanned as opaque, degenerate triangles (dropped), vertices 1e7 m away from the others, unknown keywords, a reflectance above 1
 * (interpreted as percent), a missing material file and unknown materials (both get default
 * properties), a file without faces. Messages start with file:line.
 *
 * A progress event is sent per MiB read; AbortExecute stops reading, and the update fails.
 *
 * @sa
 * vtkHeliosObjSceneWriter vtkHeliosSceneComposer
 */

#ifndef vtkHeliosObjSceneReader_h
#define vtkHeliosObjSceneReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosSceneReader.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosObjSceneReader : public vtkHeliosSceneReader
{
public:
  static vtkHeliosObjSceneReader* New();
  vtkTypeMacro(vtkHeliosObjSceneReader, vtkHeliosSceneReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get whether colours are read, for GenerateColors of vtkHeliosScanner: Kd and map_Kd of
   * materials (columns Material.Color and Material.Texture), and texture coordinates (cell data
   * TextureCoordinates, u v of each corner). An image that does not exist, or that
   * vtkHeliosImageReader does not read, is an error with the line of map_Kd; only its header is
   * read here. Default: off.
   */
  vtkSetMacro(ReadColors, bool);
  vtkGetMacro(ReadColors, bool);
  vtkBooleanMacro(ReadColors, bool);
  ///@}

protected:
  vtkHeliosObjSceneReader() = default;
  ~vtkHeliosObjSceneReader() override = default;

  const char* GetFormatName() const override { return "OBJ"; }
  const char* GetFaceExample() const override { return "faces: f 1 2 3"; }
  bool ReadScene(vtkPolyData* scene, helios::TextReport& report) override;

private:
  vtkHeliosObjSceneReader(const vtkHeliosObjSceneReader&) = delete;
  void operator=(const vtkHeliosObjSceneReader&) = delete;

  bool ReadOnce(vtkPolyData* scene, helios::TextReport& report, bool& hasTextures);

  bool ReadColors = false;
};

#endif
