// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGLTFSceneReader
 * @brief   read a glTF 2.0 document as a scene
 *
 * JSON (.gltf) with buffers in it or beside it, and binary containers (.glb). Output 0 is a scene,
 * as from every vtkHeliosSceneReader:
 * - points: the vertices of all meshes of the default scene, moved by their nodes in double
 *   precision, and by EXT_mesh_gpu_instancing. glTF is y up, and UpAxis is UP_AXIS_Y by default;
 * - triangles, strips and fans, with indices or without. Points and lines are skipped;
 * - one material for each of the document, with its name. A baseColorFactor without a texture gives
 *   the reflectance, as luminance 0.2126 R + 0.7152 G + 0.0722 B: a colour of the visible, and so
 *   only a start for the wavelength of a laser. Others have the default reflectance.
 *
 * The opacity of the base colour, times that of its factor, cuts triangles with the alphaMode MASK;
 * of BLEND, each eighth of opacity becomes a leaf that transmits the rest. Textures are PNG, beside
 * the document or in it. What is left are triangles, after all others, with outlines within a
 * pixel of the texture's that have its area. Field data Notes (strings) say what was cut.
 *
 * Positions may be integers (KHR_mesh_quantization), accessors sparse. Nodes that share a mesh are
 * copies. Nodes hidden by KHR_node_visibility are left out; morph targets have the default weights
 * of the node or mesh. With an Animation, nodes, morph targets and skins have the pose of a time: vertices of
 * a skin are the sum of weight times joint times inverse bind matrix. Without one, skins are not
 * applied.
 *
 * Errors, without output: text that is not JSON, another version, an extension that is required and
 * may change the geometry (compression), an index out of range, bytes that do not fit into their
 * buffer, a vertex or node that is not finite, a node with two parents, an animation
 * that does not exist, a mesh of a skin without weights. Messages name the file and
 * the JSON path of the value: "a.glb: meshes[0].primitives[1].indices: ...". Warnings: skins,
 * textures that should cut triangles and cannot, which are scanned as opaque.
 *
 * @sa
 * vtkHeliosSceneReader vtkHeliosMaterialReader
 */

#ifndef vtkHeliosGLTFSceneReader_h
#define vtkHeliosGLTFSceneReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosSceneReader.h"

#include <memory> // For the document

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosGLTFSceneReader : public vtkHeliosSceneReader
{
public:
  static vtkHeliosGLTFSceneReader* New();
  vtkTypeMacro(vtkHeliosGLTFSceneReader, vtkHeliosSceneReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get an MTL file: materials with the name of one of the document replace it. Default: none.
   */
  vtkSetFilePathMacro(MaterialFileName);
  vtkGetFilePathMacro(MaterialFileName);
  ///@}

  ///@{
  /**
   * Set/Get the animation that poses the scene, by name, or by number from 0; "0" is the first. Null:
   * none. Default: null.
   */
  vtkSetStringMacro(Animation);
  vtkGetStringMacro(Animation);
  ///@}

  ///@{
  /**
   * Set/Get the time of the animation [s]; later than its end is as at its end. Valid range: [0, inf). Default: 0.
   */
  vtkSetClampMacro(AnimationTime, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(AnimationTime, double);
  ///@}

  /**
   * Get the time of the last key of the animation [s], after Update().
   */
  vtkGetMacro(AnimationDuration, double);

protected:
  vtkHeliosGLTFSceneReader();
  ~vtkHeliosGLTFSceneReader() override;

  const char* GetFormatName() const override { return "glTF"; }
  const char* GetFaceExample() const override { return "meshes of triangles"; }
  bool ReadScene(vtkPolyData* scene, helios::TextReport& report) override;

private:
  vtkHeliosGLTFSceneReader(const vtkHeliosGLTFSceneReader&) = delete;
  void operator=(const vtkHeliosGLTFSceneReader&) = delete;

  bool ReadDocument(helios::TextReport& report);

  char* MaterialFileName = nullptr;
  char* Animation = nullptr;
  double AnimationTime = 0.0;
  double AnimationDuration = 0.0;
  struct Internals;
  std::unique_ptr<Internals> Known;
};

#endif
