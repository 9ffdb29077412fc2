// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A table of keys and their actions, also the source of the menus and the help.

#ifndef heliosViewerKeys_h
#define heliosViewerKeys_h

#include "heliosMenu.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace helios::viewer
{

class ViewerTool;

class ViewerKeys
{
public:
  struct Action
  {
    std::string Heading; ///< heading of the following keys; empty: continues
    std::vector<std::string> Keys;
    std::string Shown; ///< for the help
    std::string What;
    std::function<void()> Do;
    std::function<bool()> IsOn = nullptr; ///< whether its item has a tick
  };

  explicit ViewerKeys(const std::vector<std::unique_ptr<ViewerTool>>& tools)
    : Tools(tools)
  {
  }

  void Add(const Action& action) { this->Actions.push_back(action); }

  /// Runs the action of a key, as named by X ("Control-o" with control); tools come first. False: no
  /// action.
  bool Press(const std::string& key, bool control);

  /// Returns all actions, by heading and by tool.
  std::vector<Menu> GetMenus();

private:
  const std::vector<std::unique_ptr<ViewerTool>>& Tools;
  std::vector<Action> Actions;
};

} // namespace helios::viewer

#endif
