// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEditPanel.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <json/json.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace helios::viewer
{

namespace
{

// Fractions of the window's width and height, from the lower left.
constexpr double Left = 0.015;
constexpr double Right = 0.2;
constexpr double HeadingTop = 0.88;
constexpr double FirstSlider = 0.66;
constexpr double SliderStep = 0.058;
constexpr double LabelAbove = 0.014;
constexpr double Margin = 0.02; // clickable margin around a slider

void SetUpText(vtkTextActor* actor, double y, bool isTop)
{
  vtkTextProperty* letters = actor->GetTextProperty();
  letters->SetFontFamilyToCourier();
  letters->SetColor(0.95, 0.96, 0.98);
  letters->SetShadow(1);
  isTop ? letters->SetVerticalJustificationToTop() : letters->SetVerticalJustificationToBottom();
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->GetPositionCoordinate()->SetValue(Left, y);
  actor->SetInput("");
  actor->PickableOff();
}

/// "scan angle  30 deg"; thousands of hertz are shortened.
std::string MakeLabel(const EditRange& range, double value)
{
  const bool isLarge = range.Unit == "Hz" && value >= 1e4;
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", isLarge ? 1e-3 * value : value);
  return range.Label + "  " + text + (isLarge ? " k" : " ") + range.Unit;
}

} // namespace

/// A single value.
class EditPanel::Slider
{
public:
  Slider(EditPanel& panel, const EditRange& range, double y)
    : Panel(panel)
    , Range(range)
    , Y(y)
  {
    this->SetUpBar();
    SetUpText(this->Label, y + LabelAbove, false);
    this->Label->SetVisibility(panel.IsVisible);
    panel.Renderer->AddActor2D(this->Label);
    if (panel.Interactor)
    {
      this->SetUpWidget();
    }
  }

  ~Slider()
  {
    this->Panel.Renderer->RemoveActor2D(this->Label);
    this->Widget->RemoveObserver(this->Observer);
    this->Widget->SetInteractor(nullptr);
  }

  Slider(const Slider&) = delete;
  void operator=(const Slider&) = delete;

  const EditRange& GetRange() const { return this->Range; }
  double GetY() const { return this->Y; }
  double GetValue() const { return this->Value; }
  void SetLetterSize(int size) { this->Label->GetTextProperty()->SetFontSize(size); }

  void SetVisible(bool visible)
  {
    this->Label->SetVisibility(visible);
    if (this->Panel.Interactor)
    {
      this->Widget->SetEnabled(visible);
    }
  }

  void Show(double value)
  {
    this->Value = value;
    this->Label->SetInput(MakeLabel(this->Range, value).c_str());
    if (!this->IsHeld)
    {
      this->Bar->SetValue(value);
    }
  }

private:
  void SetUpBar()
  {
    this->Bar->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    this->Bar->GetPoint1Coordinate()->SetValue(Left, this->Y);
    this->Bar->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    this->Bar->GetPoint2Coordinate()->SetValue(Right, this->Y);
    this->Bar->SetMinimumValue(this->Range.Low);
    this->Bar->SetMaximumValue(std::max(this->Range.High, this->Range.Low + 1e-9));
    this->Bar->SetTubeWidth(0.005);
    this->Bar->SetSliderLength(0.012);
    this->Bar->SetSliderWidth(0.02);
    this->Bar->SetEndCapLength(0.0);
    this->Bar->ShowSliderLabelOff();
    this->Bar->GetTubeProperty()->SetColor(0.45, 0.5, 0.58);
    this->Bar->GetSliderProperty()->SetColor(0.35, 0.75, 0.95);
    this->Bar->GetSelectedProperty()->SetColor(0.7, 0.9, 1.0);
  }

  void SetUpWidget()
  {
    this->Widget->SetInteractor(this->Panel.Interactor);
    this->Widget->SetRepresentation(this->Bar);
    this->Widget->SetAnimationModeToJump();
    this->Widget->KeyPressActivationOff();
    this->Observer->SetClientData(this);
    this->Observer->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
      { static_cast<Slider*>(self)->Move(event == vtkCommand::InteractionEvent); });
    this->Widget->AddObserver(vtkCommand::InteractionEvent, this->Observer);
    this->Widget->AddObserver(vtkCommand::EndInteractionEvent, this->Observer);
    this->Widget->SetEnabled(this->Panel.IsVisible);
  }

  void Move(bool isHeld)
  {
    this->IsHeld = isHeld;
    this->Panel.OnChange(this->Range.Name, this->Bar->GetValue(), !isHeld);
  }

  EditPanel& Panel;
  EditRange Range;
  double Y;
  double Value = 0.0;
  bool IsHeld = false; ///< by the user
  vtkNew<vtkTextActor> Label;
  vtkNew<vtkSliderRepresentation2D> Bar;
  vtkNew<vtkSliderWidget> Widget;
  vtkNew<vtkCallbackCommand> Observer;
};

//------------------------------------------------------------------------------
EditPanel::EditPanel(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, Change onChange)
  : Renderer(renderer)
  , Interactor(interactor)
  , OnChange(std::move(onChange))
{
  SetUpText(this->Heading, HeadingTop, true);
  this->Heading->GetTextProperty()->SetColor(0.6, 0.87, 1.0);
  this->Heading->VisibilityOff();
  renderer->AddActor2D(this->Heading);
}

//------------------------------------------------------------------------------
EditPanel::~EditPanel()
{
  this->Sliders.clear();
  this->Renderer->RemoveActor2D(this->Heading);
}

//------------------------------------------------------------------------------
void EditPanel::SetRanges(const std::vector<EditRange>& ranges)
{
  this->Sliders.clear();
  for (const EditRange& range : ranges)
  {
    const double y = FirstSlider - SliderStep * static_cast<double>(this->Sliders.size());
    this->Sliders.push_back(std::make_unique<Slider>(*this, range, y));
    this->Sliders.back()->SetLetterSize(std::max(8, this->LetterSize));
  }
}

//------------------------------------------------------------------------------
void EditPanel::ShowValues(const SurveyEdit& edit)
{
  for (const auto& slider : this->Sliders)
  {
    const double value = GetSetting(edit, slider->GetRange().Name);
    slider->Show(std::isnan(value) ? slider->GetRange().Low : value);
  }
}

//------------------------------------------------------------------------------
void EditPanel::SetHeading(const std::string& text)
{
  this->Heading->SetInput(text.c_str());
}

//------------------------------------------------------------------------------
void EditPanel::SetVisible(bool visible)
{
  this->IsVisible = visible;
  this->Heading->SetVisibility(visible);
  for (const auto& slider : this->Sliders)
  {
    slider->SetVisible(visible);
  }
}

//------------------------------------------------------------------------------
void EditPanel::Resize(int width, int height)
{
  const int size = std::clamp(std::min(width / 85, height / 54), 8, 24);
  if (size == this->LetterSize)
  {
    return;
  }
  this->LetterSize = size;
  this->Heading->GetTextProperty()->SetFontSize(size);
  for (const auto& slider : this->Sliders)
  {
    slider->SetLetterSize(size);
  }
}

//------------------------------------------------------------------------------
bool EditPanel::Contains(double x, double y) const
{
  if (!this->IsVisible || this->Sliders.empty())
  {
    return false;
  }
  return x <= Right + Margin && y >= this->Sliders.back()->GetY() - Margin &&
    y <= FirstSlider + 2.0 * Margin;
}

//------------------------------------------------------------------------------
Json::Value EditPanel::Describe() const
{
  Json::Value all(Json::objectValue);
  for (const auto& slider : this->Sliders)
  {
    Json::Value& one = all[slider->GetRange().Name];
    one["value"] = slider->GetValue();
    one["min"] = slider->GetRange().Low;
    one["max"] = slider->GetRange().High;
    one["x0"] = Left;
    one["x1"] = Right;
    one["y"] = slider->GetY();
  }
  return all;
}

} // namespace helios::viewer
