// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A tool of the viewer: something that the user does with what is shown.

#ifndef heliosViewerTool_h
#define heliosViewerTool_h

#include <json/forwards.h>

#include <string>
#include <utility>
#include <vector>

namespace helios
{

/// A key and what it does, a line of the help.
using KeyHelp = std::pair<std::string, std::string>;

/// The viewer asks its tools in their order, until one says that it was meant.
class ViewerTool
{
public:
  virtual ~ViewerTool() = default;

  /// The heading of its keys in the help.
  virtual std::string GetName() const = 0;
  virtual std::vector<KeyHelp> GetKeys() const = 0;

  /// A key as X names it ("a", "plus", "Escape"); true: it was meant.
  virtual bool OnKey(const std::string& key, bool control) = 0;

  /// A click that moved nothing, at a pixel from the lower left; true: it was meant.
  virtual bool OnClick(int x, int y) = 0;

  /// Before every frame; true: there is something new to draw.
  virtual bool OnFrame() { return false; }

  /// Another survey is shown: forget what belonged to the last.
  virtual void OnNewSurvey() {}

  /// A line for the status; empty: nothing to say.
  virtual std::string GetStatus() const { return {}; }

  /// Adds what it shows to the state.
  virtual void Describe(Json::Value& state) const = 0;
};

} // namespace helios

#endif
