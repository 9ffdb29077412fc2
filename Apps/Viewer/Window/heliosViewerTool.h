// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A tool of the viewer: a user interaction with the view.

#ifndef heliosViewerTool_h
#define heliosViewerTool_h

#include "heliosLegend.h"
#include "heliosMenu.h"
#include "heliosStatus.h"

#include <json/forwards.h>

#include <string>
#include <vector>

namespace helios::viewer
{

/// A key and its action: a line of the help, and of the tool's menu.
struct KeyHelp
{
  std::string Shown;
  std::string What;
  std::string Press; ///< the key that the menu presses, as X names it; empty: mouse only
};

/// The viewer calls its tools in order, until one handles the event.
class ViewerTool
{
public:
  virtual ~ViewerTool() = default;

  /// Returns the heading of its keys in the help.
  virtual std::string GetName() const = 0;
  virtual std::vector<KeyHelp> GetKeys() const = 0;

  /// Returns menus of its own, as they are now.
  virtual std::vector<Menu> GetMenus() { return {}; }

  /// Handles a key by its X name ("a", "plus", "Escape"); true: handled.
  virtual bool OnKey(const std::string& key, bool control) = 0;

  /// Handles a click without a drag, at a pixel from the lower left; true: handled.
  virtual bool OnClick(int x, int y) = 0;

  /// Returns whether it waits for clicks.
  virtual bool IsActive() const { return false; }

  /// Runs before every frame; true: a redraw is needed.
  virtual bool OnFrame() { return false; }

  /// Places the tool's drawings after the panels of the window have been placed.
  virtual void Place() {}

  /// Discards what it has of the last inputs: others are shown.
  virtual void OnNewInputs() { this->OnNewSurvey(); }

  /// Discards the data of the last survey: another one is shown.
  virtual void OnNewSurvey() {}

  /// Saves what it has edited.
  virtual Status Save() { return {}; }

  /// Returns a line for the status; empty: none.
  virtual std::string GetStatus() const { return {}; }

  /// Returns a legend of its colours; empty: none.
  virtual Legend GetLegend() const { return {}; }

  /// Adds its contents to the state.
  virtual void Describe(Json::Value& state) const = 0;
};

} // namespace helios::viewer

#endif
