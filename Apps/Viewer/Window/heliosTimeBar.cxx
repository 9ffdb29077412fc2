// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTimeBar.h"

#include "heliosSlider.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>

#include <utility>

namespace helios::viewer
{

//------------------------------------------------------------------------------
TimeBar::TimeBar(vtkRenderWindowInteractor* interactor, std::function<void(double)> onSeek)
  : OnSeek(std::move(onSeek))
{
  SetUpSlider(this->Bar);
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
void TimeBar::Place(const Rect& track, const Theme& theme)
{
  this->Track = track;
  PlaceSlider(this->Bar, track, theme);
  const int isVisible = track.IsEmpty() ? 0 : 1;
  if (this->Widget->GetEnabled() != isVisible)
  {
    this->Widget->SetEnabled(isVisible);
  }
}

//------------------------------------------------------------------------------
void TimeBar::Seek(bool isHeld)
{
  this->IsHeld = isHeld;
  this->OnSeek(this->Bar->GetValue());
}

} // namespace helios::viewer
