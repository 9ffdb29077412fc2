// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The panel at the left of a survey made by hand: what is chosen, and sliders of its numbers.

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

namespace helios
{

class EditPanel
{
public:
  /// A slider was moved; isOver: and let go.
  using Change = std::function<void(const std::string& name, double value, bool isOver)>;

  /// Without an interactor there are words only.
  EditPanel(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, Change onChange);
  ~EditPanel();
  EditPanel(const EditPanel&) = delete;
  void operator=(const EditPanel&) = delete;

  /// Other sliders. Not to be called from onChange.
  void SetRanges(const std::vector<EditRange>& ranges);

  /// The values of a survey on the sliders that nobody holds.
  void ShowValues(const SurveyEdit& edit);

  void SetHeading(const std::string& text);
  void SetVisible(bool visible);

  /// Letters as large as the window asks for [pixels].
  void Resize(int width, int height);

  /// Whether a place of the window, in shares of its size, belongs to the sliders.
  bool Contains(double x, double y) const;

  /// What the sliders show, and where they are.
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

} // namespace helios

#endif
