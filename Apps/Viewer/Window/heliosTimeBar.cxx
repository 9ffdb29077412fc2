// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTimeBar.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextProperty.h>

#include <utility>

namespace helios::viewer
{

//------------------------------------------------------------------------------
TimeBar::TimeBar(vtkRenderWindowInteractor* interactor, std::function<void(double)> onSeek)
  : OnSeek(std::move(onSeek))
{
  this->Bar->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  this->Bar->GetPoint1Coordinate()->SetValue(Left, Height);
  this->Bar->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  this->Bar->GetPoint2Coordinate()->SetValue(Right, Height);
  this->Bar->SetTubeWidth(0.005);
  this->Bar->SetSliderLength(0.012);
  this->Bar->SetSliderWidth(0.02);
  this->Bar->SetEndCapLength(0.0);
  this->Bar->SetLabelFormat("%.2f s");
  this->Bar->SetLabelHeight(0.018);
  this->Bar->GetTubeProperty()->SetColor(0.45, 0.5, 0.58);
  this->Bar->GetSliderProperty()->SetColor(0.95, 0.75, 0.2);
  this->Bar->GetSelectedProperty()->SetColor(1.0, 0.9, 0.5);
  this->Bar->GetLabelProperty()->SetShadow(1);
  this->Bar->GetLabelProperty()->BoldOff();
  this->Bar->GetLabelProperty()->ItalicOff();
  this->Widget->SetInteractor(interactor);
  this->Widget->SetRepresentation(this->Bar);
  this->Widget->SetAnimationModeToJump();
  this->Widget->KeyPressActivationOff();
  this->Observer->SetClientData(this);
  this->Observer->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<TimeBar*>(self)->Seek(event == vtkCommand::InteractionEvent); });
  this->Widget->AddObserver(vtkCommand::InteractionEvent, this->Observer);
  this->Widget->AddObserver(vtkCommand::EndInteractionEvent, this->Observer);
}

//------------------------------------------------------------------------------
TimeBar::~TimeBar()
{
  this->Widget->RemoveObserver(this->Observer);
  this->Widget->SetInteractor(nullptr);
}

//------------------------------------------------------------------------------
void TimeBar::SetSpan(double start, double end)
{
  this->Bar->SetMinimumValue(start);
  this->Bar->SetMaximumValue(end > start ? end : start + 1e-9);
}

//------------------------------------------------------------------------------
void TimeBar::SetTime(double time)
{
  if (!this->IsHeld)
  {
    this->Bar->SetValue(time);
  }
}

//------------------------------------------------------------------------------
void TimeBar::SetVisible(bool visible)
{
  this->Widget->SetEnabled(visible);
}

//------------------------------------------------------------------------------
bool TimeBar::IsVisible() const
{
  return this->Widget->GetEnabled() != 0;
}

//------------------------------------------------------------------------------
void TimeBar::Seek(bool isHeld)
{
  this->IsHeld = isHeld;
  this->OnSeek(this->Bar->GetValue());
}

} // namespace helios::viewer
