// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Interactive editing of a scanner: scan positions, trajectories, flight lines, parts of the scene.

#ifndef heliosEditTool_h
#define heliosEditTool_h

#include "heliosCatalogue.h"
#include "heliosEditPanel.h"
#include "heliosPlatformView.h"
#include "heliosSceneEdit.h"
#include "heliosSurveyEdit.h"
#include "heliosViewerTool.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace helios::viewer
{

class Viewer;
struct ScenePick;

class EditTool : public ViewerTool
{
public:
  explicit EditTool(Viewer& viewer);
  ~EditTool() override;

  std::string GetName() const override { return "Direct control"; }
  std::vector<KeyHelp> GetKeys() const override;
  std::vector<Menu> GetMenus() override;
  bool IsActive() const override { return this->IsOn; }
  bool OnKey(const std::string& key, bool control) override;
  bool OnClick(int x, int y) override;
  void Place() override;
  bool OnFrame() override;
  void OnNewSurvey() override;
  Status Save() override;
  void Describe(Json::Value& state) const override;

private:
  enum class Mode
  {
    Scanner, ///< clicks set positions, waypoints
    Area,    ///< clicks set the corners of a flight area
    Parts    ///< clicks select parts of the scene
  };

  /// State restored by an undo.
  struct Before
  {
    SurveyEdit Edit;
    std::string Scene; ///< empty: unchanged
  };

  void MakeActions();
  bool Toggle();
  bool Begin();
  bool BeginWithSurvey();
  bool BeginWithScene();
  void FindGround();
  void FollowPlatform();
  void Remember();
  void Undo();
  void Scan();
  void SetMode(Mode mode);
  void ChangePlatform(int step);
  void SetPlatform(const std::pair<std::string, PlatformData>& platform);
  void SetScanner(const std::pair<std::string, ScannerData>& scanner);
  void ChangeScanner(int step, bool isRemembered = false);
  void ChangeSetting(const std::string& name, double value, bool isOver);
  void Remove();
  void ClickAt(int x, int y, bool isMore);
  void SetScanPosition(const ScenePick& pick, bool isMore);
  void SetCorner(const ScenePick& pick);
  void Select(const ScenePick& pick, bool isMore);
  bool LoadScene();
  void ChangeParts(bool isGood);
  void ShowScene();
  void AddPart(const ScenePick& pick);
  void MovePart(double x, double y);
  void TurnPart(double angle);
  void ScalePart(double factor);
  bool FindMeshPart(int& part, double bounds[6]) const;
  void FindFiles();
  void ShowPanel();
  void ShowGhost();
  void PlaceGhost();
  std::string MakeHeading() const;
  std::vector<std::string> GetDocuments() const;

  Viewer& Owner;
  std::map<std::string, void (*)(EditTool&)> Actions;
  std::map<std::string, void (*)(EditTool&)> PartActions;
  bool IsOn = false;
  bool HasBegun = false;
  bool IsEditedSurvey = false; ///< the survey being shown
  Mode Doing = Mode::Scanner;
  Catalogue Choice;
  SurveyEdit Edit;
  SceneEdit Scene;
  std::string FirstScene;   ///< before parts changed
  bool HasNewScene = false; ///< parts have changed
  bool HasChanges = false;  ///< since the last scan
  bool IsSliding = false;   ///< a slider is dragged
  bool HasCorner = false;
  Vec3 Corner;
  std::string Part;               ///< selected; empty: none
  std::vector<std::string> Files; ///< sources of new parts
  std::size_t File = 0;
  std::vector<Before> UndoStack;
  std::unique_ptr<EditPanel> Panel;
  std::unique_ptr<PlatformView> Ghost;
  std::shared_ptr<ModelFiles> Models; // platform models
  std::string Saved;
  int Scans = 0; ///< started
};

} // namespace helios::viewer

#endif
