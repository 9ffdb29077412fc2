// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The panels over the picture: menus, status, legs, messages, legend, scale bar, axes, help.

#ifndef heliosHud_h
#define heliosHud_h

#include "heliosFileDialog.h"
#include "heliosLayout.h"
#include "heliosLegend.h"
#include "heliosMenu.h"
#include "heliosScaleBar.h"
#include "heliosTextPanel.h"
#include "heliosTheme.h"
#include "heliosToolBar.h"

#include <vtkNew.h>

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkContext2D;
class vtkContextActor;
class vtkRenderer;

namespace helios::viewer
{

/// Draws all panels but sliders and the chart, whose places it gives.
class Hud
{
public:
  explicit Hud(vtkRenderer* renderer);
  ~Hud();
  Hud(const Hud&) = delete;
  void operator=(const Hud&) = delete;

  void SetTheme(const Theme& theme) { this->Colors = &theme; }
  const Theme& GetTheme() const { return *this->Colors; }

  /// Sets texts of several lines each; empty: none.
  void SetStatus(const std::string& text) { this->Status.SetText(text); }
  void SetLegs(const std::string& text) { this->Legs.SetText(text); }
  void SetMessage(const std::string& text) { this->Message.SetText(text); }
  void SetCursor(const std::string& text) { this->Cursor.SetText(text); }

  const std::string& GetCursor() const { return this->Cursor.GetText(); }

  void SetLegend(const Legend& legend) { this->Colours.SetLegend(legend); }
  const Legend& GetLegend() const { return this->Colours.GetLegend(); }

  void SetMenus(const std::vector<Menu>& menus);
  const std::vector<Menu>& GetMenus() const { return this->Menus; }

  /// Sets whether there is a mouse, for the menu bar.
  void SetInteractive(bool isInteractive)
  {
    this->Bar.SetVisible(isInteractive);
    this->Tools.SetVisible(isInteractive);
  }

  /// @{
  /// Returns the buttons, and the dialog.
  ToolBar& GetToolBar() { return this->Tools; }
  const ToolBar& GetToolBar() const { return this->Tools; }
  FileDialog& GetDialog() { return this->Files; }
  const FileDialog& GetDialog() const { return this->Files; }
  ///@}

  /// Opens the menu of a title, if there is one.
  void OpenMenu(const std::string& title);

  /// Sets what a press on a line of the editor does, from 0; true: something.
  void SetOnEditorLine(std::function<bool(int)> onLine) { this->OnEditorLine = std::move(onLine); }

  /// Shows what the button below the mouse does; true: changed.
  bool ShowTip(int x, int y);
  const std::string& GetTip() const { return this->Tip.GetText(); }

  /// Handles a turn of the wheel by rows, downwards; true: on a list.
  bool OnWheel(int x, int y, int rows);

  /// Sets whether there is a time bar.
  void SetTimeBar(bool isShown) { this->HasTimeBar = isShown; }
  void SetPlaying(bool isPlaying) { this->IsPlaying = isPlaying; }
  void SetOnPlay(std::function<void()> onPlay) { this->OnPlay = std::move(onPlay); }

  void SetHelpVisible(bool visible);
  bool IsHelpVisible() const { return this->Help.GetVisible(); }

  /// Shows or hides all but the help.
  void SetVisible(bool visible);
  bool IsVisible() const { return this->Visible; }

  /// Sets whether only the parts of a picture are drawn: legend, scale bar, axes.
  void SetStill(bool isStill) { this->IsStill = isStill; }

  /// Sets the panel of the editor; null: none.
  void SetEditor(const Panel* panel) { this->Editor = panel; }

  /// Sets the wanted size of the chart, which draws itself.
  void SetSize(PanelId id, const PanelSize& size);

  /// Places all panels in a window [pixels].
  void Resize(int width, int height);
  void Place();

  const Rect& GetRect(PanelId id) const { return this->Places.Get(id); }
  const Layout& GetLayout() const { return this->Places; }
  int GetTextSize() const { return this->TextSize; }

  /// Returns the part of the time bar that its handle moves in.
  Rect GetTimeTrack() const;

  /// Handles a press of the left button at a time [s]; true: on a panel.
  bool OnPress(int x, int y, double time = 0.0);

  /// Closes menu and help; true: one was open.
  bool CloseMenu();

  /// Returns the current text: status, legs and message.
  std::string GetText() const;

  const MenuBar& GetMenuBar() const { return this->Bar; }
  const ScaleBar& GetScaleBar() const { return this->Scale; }
  const AxesPanel& GetAxes() const { return this->Axes; }

  /// Draws all panels.
  void Paint(vtkContext2D* context) const;

private:
  std::array<std::pair<PanelId, const Panel*>, 14> GetPanels() const;
  bool IsShown(PanelId id) const;
  void OpenMenu(int menu);
  bool PressPanel(PanelId id, int x, int y);
  void PaintPlayButton(Painter& painter) const;

  vtkRenderer* Renderer;
  vtkNew<vtkContextActor> Actor;
  const Theme* Colors;
  std::vector<Menu> Menus;
  Layout Places;
  TextPanel Status, Legs, Cursor, Tip;
  ToolBar Tools;
  FileDialog Files;
  TextPanel Message{ true };
  LegendPanel Colours;
  MenuBar Bar{ this->Menus };
  MenuList List;
  HelpPage Help{ this->Menus };
  ScaleBar Scale;
  AxesPanel Axes;
  const Panel* Editor = nullptr;
  std::function<void()> OnPlay;
  std::function<bool(int)> OnEditorLine;
  bool IsPlaying = false;
  bool HasTimeBar = false;
  bool Visible = true;
  bool IsStill = false;
  int Window[2] = { 0, 0 };
  int TextSize = 12;
};

} // namespace helios::viewer

#endif
