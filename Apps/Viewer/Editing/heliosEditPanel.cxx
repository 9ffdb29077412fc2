// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEditPanel.h"

#include "heliosPainter.h"
#include "heliosSlider.h"
#include "heliosTheme.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>

#include <json/json.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace helios::viewer
{

namespace
{

constexpr int PanelWidth = 16; // in text heights: narrow, since it covers the scene

/// Returns the height of a slider with its label [pixels].
int GetRowHeight(int textSize)
{
  return GetLineHeight(textSize) + textSize;
}

/// Returns "scan angle  30 deg"; thousands of hertz are shortened.
std::string MakeLabel(const EditRange& range, double value)
{
  const bool isLarge = range.Unit == "Hz" && value >= 1e4;
  char text[32];
  const bool isWhole = range.Unit == "m" && value >= 100.0; // with room for the unit
  std::snprintf(text, sizeof(text), isWhole ? "%.0f" : "%.4g", isLarge ? 1e-3 * value : value);
  return range.Label + "  " + text + (isLarge ? " k" : " ") + range.Unit;
}

} // namespace

/// A single value.
class EditPanel::Slider
{
public:
  Slider(EditPanel& panel, const EditRange& range)
    : Panel(panel)
    , Range(range)
  {
    SetUpSlider(this->Bar);
    this->Bar->SetMinimumValue(range.Low);
    this->Bar->SetMaximumValue(std::max(range.High, range.Low + 1e-9));
    if (panel.Interactor)
    {
      this->SetUpWidget();
    }
  }

  ~Slider()
  {
    this->Widget->RemoveObserver(this->Observer);
    this->Widget->SetInteractor(nullptr);
  }

  Slider(const Slider&) = delete;
  void operator=(const Slider&) = delete;

  const EditRange& GetRange() const { return this->Range; }
  const Rect& GetTrack() const { return this->Track; }
  double GetValue() const { return this->Value; }
  std::string GetLabel() const { return MakeLabel(this->Range, this->Value); }

  /// Places the slider in a rectangle [pixels]; an empty one hides it.
  void Place(const Rect& track, const Theme& theme)
  {
    this->Track = track;
    PlaceSlider(this->Bar, track, theme);
    const int isShown = track.IsEmpty() ? 0 : 1;
    if (this->Panel.Interactor && this->Widget->GetEnabled() != isShown)
    {
      this->Widget->SetEnabled(isShown);
    }
  }

  void Show(double value)
  {
    this->Value = value;
    if (!this->IsHeld)
    {
      this->Bar->SetValue(value);
    }
  }

private:
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
  }

  void Move(bool isHeld)
  {
    this->IsHeld = isHeld;
    this->Panel.OnChange(this->Range.Name, this->Bar->GetValue(), !isHeld);
  }

  EditPanel& Panel;
  EditRange Range;
  Rect Track;
  double Value = 0.0;
  bool IsHeld = false; ///< by the user
  vtkNew<vtkSliderRepresentation2D> Bar;
  vtkNew<vtkSliderWidget> Widget;
  vtkNew<vtkCallbackCommand> Observer;
};

//------------------------------------------------------------------------------
EditPanel::EditPanel(vtkRenderWindowInteractor* interactor, Change onChange)
  : Interactor(interactor)
  , OnChange(std::move(onChange))
{
}

//------------------------------------------------------------------------------
EditPanel::~EditPanel() = default;

//------------------------------------------------------------------------------
void EditPanel::SetRanges(const std::vector<EditRange>& ranges)
{
  this->Sliders.clear();
  this->HasLists = !ranges.empty();
  for (const EditRange& range : ranges)
  {
    this->Sliders.push_back(std::make_unique<Slider>(*this, range));
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
  this->Heading.SetText(text);
}

//------------------------------------------------------------------------------
void EditPanel::SetVisible(bool visible)
{
  this->IsVisible = visible;
}

//------------------------------------------------------------------------------
PanelSize EditPanel::GetSize(int textSize) const
{
  if (!this->IsVisible)
  {
    return {};
  }
  const PanelSize heading = this->Heading.GetSize(textSize);
  const auto rows = static_cast<int>(this->Sliders.size());
  const int margin = rows > 0 ? GetTextMargin(textSize) : 0;
  return { PanelWidth * textSize, heading.Height + rows * GetRowHeight(textSize) + margin };
}

//------------------------------------------------------------------------------
void EditPanel::Paint(Painter& painter, const Rect& rect) const
{
  painter.DrawPanel(rect);
  const int size = painter.GetTextSize();
  const Rect inside = rect.Shrunk(GetTextMargin(size));
  const int step = painter.GetLineHeight();
  int y = inside.Top() - step / 2;
  int line = 0;
  for (const std::string& text : SplitLines(this->Heading.GetText()))
  {
    const bool isList = this->HasLists && line > 0 && line < 3;
    painter.DrawText(inside.X, y, Shorten(text, size, inside.Width - (isList ? 2 * size : 0)),
      line == 0 ? painter.GetTheme().Heading : painter.GetTheme().Ink);
    if (isList)
    {
      const double x = inside.Right() - size, half = 0.3 * size;
      painter.FillTriangle(
        { x - half, y + half, x + half, y + half, x, y - half }, painter.GetTheme().FaintInk);
    }
    y -= step;
    ++line;
  }
  for (const auto& slider : this->Sliders)
  {
    const Rect& track = slider->GetTrack();
    if (!track.IsEmpty())
    {
      painter.DrawText(inside.X, track.Top() + step / 2,
        Shorten(slider->GetLabel(), size, inside.Width), painter.GetTheme().Ink);
    }
  }
}

//------------------------------------------------------------------------------
void EditPanel::Place(const Rect& rect, const Theme& theme, int textSize)
{
  const Rect inside = rect.Shrunk(GetTextMargin(textSize));
  int top = rect.Top() - this->Heading.GetSize(textSize).Height;
  for (const auto& slider : this->Sliders)
  {
    const int y = top - GetRowHeight(textSize);
    const bool isInside = !rect.IsEmpty() && this->IsVisible && y >= rect.Y;
    slider->Place(isInside ? Rect{ inside.X, y, inside.Width, textSize } : Rect(), theme);
    top = y;
  }
}

//------------------------------------------------------------------------------
Json::Value EditPanel::Describe(const int window[2]) const
{
  Json::Value all(Json::objectValue);
  for (const auto& slider : this->Sliders)
  {
    Json::Value& one = all[slider->GetRange().Name];
    one["value"] = slider->GetValue();
    one["min"] = slider->GetRange().Low;
    one["max"] = slider->GetRange().High;
    const Rect& track = slider->GetTrack();
    one["x0"] = static_cast<double>(track.X) / window[0];
    one["x1"] = static_cast<double>(track.Right()) / window[0];
    one["y"] = (track.Y + 0.5 * track.Height) / window[1];
  }
  return all;
}

} // namespace helios::viewer
