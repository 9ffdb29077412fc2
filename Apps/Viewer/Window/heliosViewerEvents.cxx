// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// User input: keys, clicks, drags.
#include "heliosViewer.h"

#include "heliosDisplay.h"
#include "heliosHud.h"
#include "heliosViewerKeys.h"
#include "heliosViewerTool.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace helios::viewer
{

namespace
{

constexpr int ClickPixels = 4; // maximum motion of a click
constexpr int WheelRows = 3;   // rows of a list

/// Returns the key of the last event as X names it; empty: none.
std::string GetPressedKey(vtkRenderWindowInteractor& interactor)
{
  const char* key = interactor.GetKeySym();
  const std::string name = key ? key : "";
  return interactor.GetShiftKey()
    ? FindShiftedKey(interactor.GetRenderWindow()->GetGenericDisplayId(), name)
    : name;
}

} // namespace

//------------------------------------------------------------------------------
void Viewer::SetUpEvents()
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(OnEvent);
  for (const unsigned long event : { vtkCommand::KeyPressEvent, vtkCommand::LeftButtonPressEvent,
         vtkCommand::MiddleButtonPressEvent, vtkCommand::RightButtonPressEvent,
         vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent,
         vtkCommand::TimerEvent, vtkCommand::ConfigureEvent, vtkCommand::ExitEvent,
         vtkCommand::MouseMoveEvent })
  {
    this->Interactor->AddObserver(event, this->Observer, 10.0F);
  }
  // VTK's styles and widgets grab all events from press to release, except for passive observers.
  this->Releases->SetClientData(this);
  this->Releases->SetCallback(OnReleaseEvent);
  this->Releases->PassiveObserverOn();
  for (const unsigned long event : { vtkCommand::LeftButtonReleaseEvent,
         vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonReleaseEvent })
  {
    this->Interactor->AddObserver(event, this->Releases);
  }
}

//------------------------------------------------------------------------------
void Viewer::OnEvent(vtkObject*, unsigned long event, void* self, void*)
{
  auto* viewer = static_cast<Viewer*>(self);
  if (event == vtkCommand::TimerEvent)
  {
    viewer->OnTimer();
    return;
  }
  const bool isMove = event == vtkCommand::MouseMoveEvent;
  if (!isMove || viewer->IsDragging)
  {
    viewer->Budget.RecordInput(viewer->Now());
    viewer->Redraw();
  }
  switch (event)
  {
    case vtkCommand::KeyPressEvent:
      viewer->OnKey();
      break;
    case vtkCommand::LeftButtonPressEvent:
      viewer->IsDragging = !viewer->OnPress();
      viewer->Observer->SetAbortFlag(!viewer->IsDragging); // not for VTK's style
      break;
    case vtkCommand::MouseMoveEvent:
      viewer->MovedAt = viewer->Now();
      viewer->HasMoved = true;
      break;
    case vtkCommand::MouseWheelForwardEvent:
    case vtkCommand::MouseWheelBackwardEvent:
      viewer->Observer->SetAbortFlag(
        viewer->OnWheel(event == vtkCommand::MouseWheelForwardEvent ? -WheelRows : WheelRows));
      break;
    case vtkCommand::MiddleButtonPressEvent:
    case vtkCommand::RightButtonPressEvent:
      viewer->IsDragging = true;
      break;
    case vtkCommand::ConfigureEvent:
      viewer->OnResize();
      break;
    case vtkCommand::ExitEvent:
      viewer->Close();
      break;
    default:
      break;
  }
}

//------------------------------------------------------------------------------
void Viewer::OnKey()
{
  const std::string key = GetPressedKey(*this->Interactor);
  const bool isControl = this->Interactor->GetControlKey() != 0;
  if (this->Words->GetDialog().IsOpen())
  {
    this->Words->GetDialog().OnKey(key, isControl ? '\0' : this->Interactor->GetKeyCode());
    return;
  }
  const bool isClosing = key == "Escape" && this->Words->CloseMenu();
  if (!key.empty() && !isClosing)
  {
    this->Keys->Press(key, isControl);
  }
}

//------------------------------------------------------------------------------
/// Handles a press of the left button; true: a panel has handled it.
bool Viewer::OnPress()
{
  this->Interactor->GetEventPosition(this->PressedAt[0], this->PressedAt[1]);
  PanelId id = PanelId::Status;
  this->IsPressOnPanel = this->Words->GetLayout().Find(this->PressedAt[0], this->PressedAt[1], id);
  const bool isHandled = this->Words->OnPress(this->PressedAt[0], this->PressedAt[1], this->Now());
  this->IsPressOnPanel = this->IsPressOnPanel || isHandled;
  return isHandled;
}

//------------------------------------------------------------------------------
void Viewer::OnReleaseEvent(vtkObject*, unsigned long event, void* self, void*)
{
  auto* viewer = static_cast<Viewer*>(self);
  viewer->Budget.RecordInput(viewer->Now());
  viewer->Redraw();
  viewer->IsDragging = false;
  if (event == vtkCommand::LeftButtonReleaseEvent)
  {
    viewer->OnRelease();
  }
}

//------------------------------------------------------------------------------
/// Records a click if there was no drag: a passive observer may not add others, as tools do.
void Viewer::OnRelease()
{
  int at[2];
  this->Interactor->GetEventPosition(at[0], at[1]);
  const int moved =
    std::max(std::abs(at[0] - this->PressedAt[0]), std::abs(at[1] - this->PressedAt[1]));
  this->HasClick = moved <= ClickPixels && !this->IsPressOnPanel;
  std::copy_n(at, 2, this->ClickAt);
  this->ClickKeys[0] = this->Interactor->GetShiftKey();
  this->ClickKeys[1] = this->Interactor->GetControlKey();
}

//------------------------------------------------------------------------------
/// Passes a click to the tools, with the modifier keys held at the time.
void Viewer::HandleClick()
{
  if (!this->HasClick)
  {
    return;
  }
  this->HasClick = false;
  this->Interactor->SetShiftKey(this->ClickKeys[0]);
  this->Interactor->SetControlKey(this->ClickKeys[1]);
  for (const auto& tool : this->Tools)
  {
    if (tool->OnClick(this->ClickAt[0], this->ClickAt[1]))
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
/// Scrolls lists; true: the wheel is not for the camera.
bool Viewer::OnWheel(int rows)
{
  int at[2];
  this->Interactor->GetEventPosition(at[0], at[1]);
  return this->Words->OnWheel(at[0], at[1], rows);
}

//------------------------------------------------------------------------------
void Viewer::OnResize()
{
  const int* size = this->Window->GetSize();
  if (size[0] != this->Size[0] || size[1] != this->Size[1])
  {
    std::copy_n(size, 2, this->Size);
    this->Words->Resize(size[0], size[1]);
  }
}

} // namespace helios::viewer
