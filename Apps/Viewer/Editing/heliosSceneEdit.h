// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Edits a scene: moves, rotates, scales, removes and adds parts.

#ifndef heliosSceneEdit_h
#define heliosSceneEdit_h

#include "heliosPose.h"
#include "heliosStatus.h"

#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

class Messages;

/**
 * Edits the <scene> itself, so that everything else (materials, motions, swaps, systems) is
 * unchanged.
 */
class SceneEdit
{
public:
  SceneEdit();
  ~SceneEdit();
  SceneEdit(SceneEdit&&) noexcept;
  SceneEdit& operator=(SceneEdit&&) noexcept;

  /// Loads a scene, file.xml#id (or the first of file.xml), or a mesh. False after an error.
  bool Load(
    const std::string& scene, const std::vector<std::string>& assetDirectories, Messages& log);

  bool IsLoaded() const;
  int GetNumberOfParts() const;
  std::string GetPartName(int part) const;

  /// The part with this name; -1: none.
  int FindPart(const std::string& name) const;

  ///@{
  /// Moves a part [m], rotates it about the vertical through a point [deg], scales it by a factor >
  /// 0 about a point, removes it. Returns false, and does nothing, if the part does not exist or,
  /// for removal, is the only one.
  bool MovePart(int part, const Vec3& way);
  bool TurnPart(int part, double angle, const Vec3& about);
  bool ScalePart(int part, double factor, const Vec3& about);
  bool RemovePart(int part);
  ///@}

  /// Adds a part from an OBJ file, with the center of its base at a point [m]; returns its number,
  /// or -1 after an error.
  int AddPart(const std::string& fileName, const Vec3& place, Messages& log);

  /// Returns the mesh of the scene, for a file in its folder; null after an error.
  vtkSmartPointer<vtkPolyData> Build(Messages& log) const;

  /// Returns the id of the scene in references of surveys.
  std::string GetId() const;

  /// @{
  /// Returns the text of the <scene>; restore a scene from such a text.
  std::string GetText() const;
  void SetText(const std::string& text);
  ///@}

  /// Writes the scene to its own file.
  Status Save(const std::string& fileName) const;

private:
  class Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace helios

#endif
