// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene whose parts are moved, turned, scaled, removed and added by hand.

#ifndef heliosSceneEdit_h
#define heliosSceneEdit_h

#include "heliosPose.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

class Messages;

/**
 * The <scene> itself is changed, so that what nobody touches (materials, motions, swaps, systems)
 * stays as it is. Files are referred to as a scene in the folder of a new file does.
 */
class VTKHELIOSSCANNERSURVEY_EXPORT SceneEdit
{
public:
  SceneEdit();
  ~SceneEdit();
  SceneEdit(SceneEdit&&) noexcept;
  SceneEdit& operator=(SceneEdit&&) noexcept;

  /// Takes a scene, file.xml#id (or the first of file.xml), or a mesh. False after an error.
  bool Load(const std::string& scene, const std::string& folder,
    const std::vector<std::string>& assetDirectories, Messages& log);

  bool IsLoaded() const;
  int GetNumberOfParts() const;
  std::string GetPartName(int part) const;

  /// The part of a name; -1: none.
  int FindPart(const std::string& name) const;

  ///@{
  /// Moves a part [m], turns it about the upright through a place [deg], makes it a factor > 0 larger
  /// about a place, takes it out. False, and nothing is done, where there is no such part, or no
  /// other: a scene has one at least.
  bool MovePart(int part, const Vec3& way);
  bool TurnPart(int part, double angle, const Vec3& about);
  bool ScalePart(int part, double factor, const Vec3& about);
  bool RemovePart(int part);
  ///@}

  /// Adds a part from an OBJ file, the middle of its underside at a place [m]; its number, or -1
  /// after an error.
  int AddPart(const std::string& fileName, const Vec3& place, Messages& log);

  /// The mesh of the scene, for a file in its folder; null after an error.
  vtkSmartPointer<vtkPolyData> Build(Messages& log) const;

  /// The id that a survey refers to the scene by.
  std::string GetId() const;

  ///@{
  /// The <scene>; a scene is as it was when its text was got.
  std::string GetText() const;
  void SetText(const std::string& text);
  ///@}

  /// Writes the scene to a file of its own; says what is wrong. Empty: written.
  std::string Save(const std::string& fileName) const;

private:
  std::string MakeFile() const;

  class Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace helios

#endif
