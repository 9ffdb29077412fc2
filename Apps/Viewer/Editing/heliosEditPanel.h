// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The panel at the left of an edited survey: the selection, and sliders for its values.

#ifndef heliosEditPanel_h
#define heliosEditPanel_h

#include "heliosSurveyEdit.h"

#include <vtkNew.h>

#include <json/forwards.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkTextActor;

namespace helios::viewer
{

class EditPanel
{
public:
  /// A slider was moved; isOver: and released.
  using Change = std::function<void(const std::string& name, double value, bool isOver)>;

  /// Without an interactor only text is shown.
  EditPanel(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, Change onChange);
  ~EditPanel();
  EditPanel(const EditPanel&) = delete;
  void operator=(const EditPanel&) = delete;

  /// Replaces the sliders. Not allowed in onChange.
  void SetRanges(const std::vector<EditRange>& ranges);

  /// Shows a survey's values on the sliders not in use.
  void ShowValues(const SurveyEdit& edit);

  void SetHeading(const std::string& text);
  void SetVisible(bool visible);

  /// Fits the font size to the window [pixels].
  void Resize(int width, int height);

  /// Whether a window position, in fractions of its size, belongs to the sliders.
  bool Contains(double x, double y) const;

  /// Values and positions of the sliders.
  Json::Value Describe() const;

private:
  class Slider;

  vtkRenderer* Renderer;
  vtkRenderWindowInteractor* Interactor;
  Change OnChange;
  vtkNew<vtkTextActor> Heading;
  std::vector<std::unique_ptr<Slider>> Sliders;
  int LetterSize = 0; ///< [points]; 0: not set yet
  bool IsVisible = false;
};

} // namespace helios::viewer

#endif
