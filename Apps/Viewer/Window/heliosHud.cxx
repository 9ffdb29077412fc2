// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosHud.h"

#include <vtkCoordinate.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>

namespace helios::viewer
{

namespace
{

void SetUp(vtkTextActor* actor, double x, double y, bool isRight, bool isTop)
{
  vtkTextProperty* letters = actor->GetTextProperty();
  letters->SetFontFamilyToCourier();
  letters->SetColor(0.95, 0.96, 0.98);
  letters->SetShadow(1);
  isRight ? letters->SetJustificationToRight() : letters->SetJustificationToLeft();
  isTop ? letters->SetVerticalJustificationToTop() : letters->SetVerticalJustificationToBottom();
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->GetPositionCoordinate()->SetValue(x, y);
  actor->SetInput("");
  actor->PickableOff();
}

/// The same text is not redrawn.
void SetText(vtkTextActor* actor, const std::string& text)
{
  if (text != (actor->GetInput() ? actor->GetInput() : ""))
  {
    actor->SetInput(text.c_str());
  }
}

std::string GetShown(vtkTextActor* actor)
{
  return actor->GetVisibility() && actor->GetInput() ? actor->GetInput() : "";
}

} // namespace

//------------------------------------------------------------------------------
Hud::Hud(vtkRenderer* renderer)
  : Renderer(renderer)
{
  SetUp(this->Status, 0.012, 0.985, false, true);
  SetUp(this->Legs, 0.988, 0.985, true, true);
  SetUp(this->Message, 0.012, 0.075, false, false);
  SetUp(this->Help, 0.5, 0.5, false, true);
  this->Message->GetTextProperty()->SetColor(1.0, 0.85, 0.4);
  vtkTextProperty* letters = this->Help->GetTextProperty();
  letters->SetJustificationToCentered();
  letters->SetVerticalJustificationToCentered();
  letters->SetBackgroundColor(0.05, 0.06, 0.09);
  letters->SetBackgroundOpacity(0.88);
  this->Help->VisibilityOff();
  for (vtkTextActor* actor :
    { this->Status.Get(), this->Legs.Get(), this->Message.Get(), this->Help.Get() })
  {
    renderer->AddActor2D(actor);
  }
}

//------------------------------------------------------------------------------
Hud::~Hud()
{
  for (vtkTextActor* actor :
    { this->Status.Get(), this->Legs.Get(), this->Message.Get(), this->Help.Get() })
  {
    this->Renderer->RemoveActor2D(actor);
  }
}

//------------------------------------------------------------------------------
void Hud::SetStatus(const std::string& text)
{
  SetText(this->Status, text);
}

//------------------------------------------------------------------------------
void Hud::SetLegs(const std::string& text)
{
  SetText(this->Legs, text);
}

//------------------------------------------------------------------------------
void Hud::SetMessage(const std::string& text)
{
  SetText(this->Message, text);
}

//------------------------------------------------------------------------------
void Hud::SetHelp(const std::string& text)
{
  SetText(this->Help, text);
}

//------------------------------------------------------------------------------
void Hud::SetHelpVisible(bool visible)
{
  this->Help->SetVisibility(visible);
}

//------------------------------------------------------------------------------
bool Hud::IsHelpVisible() const
{
  return this->Help->GetVisibility() != 0;
}

//------------------------------------------------------------------------------
void Hud::SetVisible(bool visible)
{
  for (vtkTextActor* actor : { this->Status.Get(), this->Legs.Get(), this->Message.Get() })
  {
    actor->SetVisibility(visible);
  }
}

//------------------------------------------------------------------------------
bool Hud::IsVisible() const
{
  return this->Status->GetVisibility() != 0;
}

//------------------------------------------------------------------------------
void Hud::Resize(int width, int height)
{
  const int size = std::clamp(std::min(width / 75, height / 48), 12, 28);
  for (vtkTextActor* actor : { this->Status.Get(), this->Legs.Get(), this->Message.Get() })
  {
    actor->GetTextProperty()->SetFontSize(size);
  }
  const int helpSize = std::clamp(std::min(width / 82, height / 46), 7, 24);
  this->Help->GetTextProperty()->SetFontSize(helpSize);
}

//------------------------------------------------------------------------------
std::string Hud::GetText() const
{
  return GetShown(this->Status) + "\n" + GetShown(this->Legs) + "\n" + GetShown(this->Message);
}

} // namespace helios::viewer
