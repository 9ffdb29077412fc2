// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The keys of the viewer: one table, also the source of the help.

#ifndef heliosViewerKeys_h
#define heliosViewerKeys_h

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace helios::viewer
{

class Viewer;
class ViewerTool;

class ViewerKeys
{
public:
  ViewerKeys(Viewer& viewer, const std::vector<std::unique_ptr<ViewerTool>>& tools);

  /// Runs the action of a key, as named by X; tools come first. False: no action.
  bool Press(const std::string& key, bool control);

  /// All keys, one per line.
  std::string GetHelp() const;

private:
  struct Action
  {
    std::string Heading; ///< of the following keys; empty: continues
    std::vector<std::string> Keys;
    std::string Shown; ///< for the help
    std::string What;
    std::function<void()> Do;
  };

  void AddTime();
  void AddCameras();
  void AddLook();
  void AddFiles();

  Viewer& Owner;
  const std::vector<std::unique_ptr<ViewerTool>>& Tools;
  std::vector<Action> Actions;
};

} // namespace helios::viewer

#endif
