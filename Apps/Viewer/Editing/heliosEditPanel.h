// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The panel at the left of an edited survey: the selection, and sliders for its values.

#ifndef heliosEditPanel_h
#define heliosEditPanel_h

#include "heliosPanel.h"
#include "heliosSurveyEdit.h"
#include "heliosTextPanel.h"

#include <json/forwards.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkRenderWindowInteractor;

namespace helios::viewer
{

struct Theme;

class EditPanel : public Panel
{
public:
  /// A slider was moved; isOver: and released.
  using Change = std::function<void(const std::string& name, double value, bool isOver)>;

  /// Without an interactor only text is shown.
  EditPanel(vtkRenderWindowInteractor* interactor, Change onChange);
  ~EditPanel() override;

  /// Replaces the sliders. Not allowed in onChange.
  void SetRanges(const std::vector<EditRange>& ranges);

  /// Shows a survey's values on the sliders not in use.
  void ShowValues(const SurveyEdit& edit);

  void SetHeading(const std::string& text);
  void SetVisible(bool visible);

  PanelSize GetSize(int textSize) const override;
  void Paint(Painter& painter, const Rect& rect) const override;

  /// Places the sliders in the rectangle of the panel [pixels]; those that do not fit are hidden.
  void Place(const Rect& rect, const Theme& theme, int textSize);

  /// Values and positions of the sliders, for a window size [pixels].
  Json::Value Describe(const int window[2]) const;

private:
  class Slider;

  vtkRenderWindowInteractor* Interactor;
  Change OnChange;
  TextPanel Heading;
  std::vector<std::unique_ptr<Slider>> Sliders;
  bool IsVisible = false;
  bool HasLists = false; // lines 1 and 2 open lists
};

} // namespace helios::viewer

#endif
