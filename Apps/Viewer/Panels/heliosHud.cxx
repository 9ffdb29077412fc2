// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosHud.h"

#include "heliosPainter.h"

#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace helios::viewer
{

namespace
{

/// The panels as an item of VTK's 2D scene.
class HudItem : public vtkContextItem
{
public:
  static HudItem* New();
  vtkTypeMacro(HudItem, vtkContextItem);

  bool Paint(vtkContext2D* context) override
  {
    this->Owner->Paint(context);
    return true;
  }

  const Hud* Owner = nullptr;
};
vtkStandardNewMacro(HudItem);

} // namespace

//------------------------------------------------------------------------------
Hud::Hud(vtkRenderer* renderer)
  : Renderer(renderer)
  , Colors(&FindTheme(""))
  , Scale(renderer)
  , Axes(renderer)
{
  this->Scale.SetVisible(true);
  this->Axes.SetVisible(true);
  auto item = vtkSmartPointer<HudItem>::New();
  item->Owner = this;
  this->Actor->GetScene()->AddItem(item);
  this->Actor->PickableOff();
  renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
Hud::~Hud()
{
  this->Renderer->RemoveActor(this->Actor);
}

//------------------------------------------------------------------------------
void Hud::SetMenus(const std::vector<Menu>& menus)
{
  this->OpenMenu(-1);
  this->Menus = menus;
}

//------------------------------------------------------------------------------
void Hud::SetHelpVisible(bool visible)
{
  this->Help.SetVisible(visible);
  this->OpenMenu(-1);
}

//------------------------------------------------------------------------------
void Hud::SetVisible(bool visible)
{
  this->Visible = visible;
  this->OpenMenu(-1);
}

//------------------------------------------------------------------------------
void Hud::Resize(int width, int height)
{
  this->Window[0] = width;
  this->Window[1] = height;
  this->TextSize = viewer::GetTextSize(width, height);
}

//------------------------------------------------------------------------------
std::array<std::pair<PanelId, const Panel*>, 14> Hud::GetPanels() const
{
  return { { { PanelId::MenuBar, &this->Bar }, { PanelId::Help, &this->Help },
    { PanelId::Menu, &this->List }, { PanelId::Legend, &this->Colours },
    { PanelId::Message, &this->Message }, { PanelId::Status, &this->Status },
    { PanelId::Axes, &this->Axes }, { PanelId::ScaleBar, &this->Scale },
    { PanelId::Legs, &this->Legs }, { PanelId::Cursor, &this->Cursor },
    { PanelId::Editor, this->Editor }, { PanelId::ToolBar, &this->Tools },
    { PanelId::Dialog, &this->Files }, { PanelId::Tip, &this->Tip } } };
}

//------------------------------------------------------------------------------
/// Returns whether a panel may be drawn now.
bool Hud::IsShown(PanelId id) const
{
  const bool isPicture =
    id == PanelId::Legend || id == PanelId::ScaleBar || id == PanelId::Axes || id == PanelId::Chart;
  const bool isHelp = id == PanelId::Help || id == PanelId::Dialog;
  return (this->Visible && (isPicture || !this->IsStill)) || (isHelp && !this->IsStill);
}

//------------------------------------------------------------------------------
void Hud::Place()
{
  this->Places.SetWindow(this->Window[0], this->Window[1], this->TextSize);
  for (const auto& panel : this->GetPanels())
  {
    this->Places.SetSize(panel.first,
      panel.second && this->IsShown(panel.first) ? panel.second->GetSize(this->TextSize)
                                                 : PanelSize());
  }
  const bool hasBar = this->HasTimeBar && this->IsShown(PanelId::TimeBar);
  this->Places.SetSize(PanelId::TimeBar, hasBar ? PanelSize{ 1, 2 * this->TextSize } : PanelSize());
  this->Places.Place();
}

//------------------------------------------------------------------------------
void Hud::SetSize(PanelId id, const PanelSize& size)
{
  const PanelSize before = this->Places.GetSize(id);
  if (size.Width != before.Width || size.Height != before.Height)
  {
    this->Places.SetSize(id, size);
    this->Place();
  }
}

//------------------------------------------------------------------------------
Rect Hud::GetTimeTrack() const
{
  Rect track = this->GetRect(PanelId::TimeBar);
  const int button = 3 * this->TextSize;
  track.X += button;
  track.Width = std::max(0, track.Width - button - this->TextSize);
  return track;
}

//------------------------------------------------------------------------------
void Hud::Paint(vtkContext2D* context) const
{
  Painter painter(context, *this->Colors, this->TextSize);
  for (const auto& panel : this->GetPanels())
  {
    const Rect& rect = this->GetRect(panel.first);
    if (!rect.IsEmpty() && panel.second && panel.first != PanelId::Tip)
    {
      panel.second->Paint(painter, rect);
    }
  }
  if (!this->GetRect(PanelId::TimeBar).IsEmpty())
  {
    this->PaintPlayButton(painter);
  }
  const Rect& tip = this->GetRect(PanelId::Tip); // over others
  tip.IsEmpty() ? void() : this->Tip.Paint(painter, tip);
}

//------------------------------------------------------------------------------
/// Paints the background of the time bar, and a triangle or two bars.
void Hud::PaintPlayButton(Painter& painter) const
{
  const Rect& bar = this->GetRect(PanelId::TimeBar);
  const Rgb& ink = this->Colors->Ink;
  painter.Fill(bar, this->Colors->Panel);
  painter.DrawLine(bar.X, bar.Top() - 1, bar.Right(), bar.Top() - 1, this->Colors->Border);
  const int side = this->TextSize;
  const int x = bar.X + side, y = bar.Y + (bar.Height - side) / 2;
  if (this->IsPlaying)
  {
    painter.Fill({ x, y, side / 3, side }, ink);
    painter.Fill({ x + 2 * side / 3, y, side / 3, side }, ink);
    return;
  }
  painter.FillTriangle(
    { double(x), double(y), double(x), double(y + side), double(x + side), y + 0.5 * side }, ink);
}

//------------------------------------------------------------------------------
void Hud::OpenMenu(int menu)
{
  this->Bar.SetOpen(menu);
  this->List.SetMenu(menu < 0 ? nullptr : &this->Menus[static_cast<std::size_t>(menu)]);
  this->Places.SetMenuPosition(menu < 0 ? 0 : this->Bar.GetTitlePosition(menu, this->TextSize));
}

//------------------------------------------------------------------------------
void Hud::OpenMenu(const std::string& title)
{
  for (std::size_t i = 0; i < this->Menus.size(); ++i)
  {
    this->Menus[i].Title == title ? this->OpenMenu(static_cast<int>(i)) : void();
  }
}

//------------------------------------------------------------------------------
bool Hud::ShowTip(int x, int y)
{
  const Rect& bar = this->GetRect(PanelId::ToolBar);
  const int button = bar.IsEmpty() ? -1 : this->Tools.Find(bar, x, y, this->TextSize);
  if (button == this->Tools.GetHovered())
  {
    return false;
  }
  this->Tools.SetHovered(button);
  this->Tip.SetText(
    button < 0 ? "" : this->Tools.GetButtons()[static_cast<std::size_t>(button)].Tip);
  this->Places.SetTipPosition(button < 0 ? 0 : this->Tools.GetPlace(bar, button, this->TextSize).X);
  return true;
}

//------------------------------------------------------------------------------
bool Hud::OnWheel(int x, int y, int rows)
{
  if (this->Files.IsOpen())
  {
    this->Files.OnWheel(rows);
    return true;
  }
  const Rect& menu = this->GetRect(PanelId::Menu);
  menu.Contains(x, y) ? this->List.Scroll(rows, menu, this->TextSize) : void();
  return menu.Contains(x, y);
}

//------------------------------------------------------------------------------
bool Hud::CloseMenu()
{
  const bool wasOpen = this->Bar.GetOpen() >= 0 || this->IsHelpVisible();
  this->SetHelpVisible(false);
  return wasOpen;
}

//------------------------------------------------------------------------------
bool Hud::OnPress(int x, int y, double time)
{
  if (this->Files.IsOpen())
  {
    this->Files.OnPress(this->GetRect(PanelId::Dialog), x, y, this->TextSize, time);
    return true;
  }
  if (!this->Visible && y >= this->Window[1] - this->TextSize)
  {
    this->SetVisible(true); // the mouse has no key to get the menus back
    return true;
  }
  PanelId id = PanelId::Status;
  return (this->Places.Find(x, y, id) && this->PressPanel(id, x, y)) || this->CloseMenu();
}

//------------------------------------------------------------------------------
/// Handles a press on a panel; false: it does nothing.
bool Hud::PressPanel(PanelId id, int x, int y)
{
  if (id == PanelId::MenuBar)
  {
    const int menu = this->Bar.FindMenu(x, this->TextSize);
    this->Help.SetVisible(false);
    this->OpenMenu(menu == this->Bar.GetOpen() ? -1 : menu);
    return true;
  }
  if (id == PanelId::Menu)
  {
    const MenuItem* item = this->List.FindItem(this->GetRect(id).Top() - 1 - y, this->TextSize);
    const std::function<void()> action = item ? item->Do : nullptr;
    this->OpenMenu(-1);
    action ? action() : void();
    return true;
  }
  if (id == PanelId::ToolBar)
  {
    const int button = this->Tools.Find(this->GetRect(id), x, y, this->TextSize);
    this->CloseMenu();
    button < 0 ? void() : this->Tools.GetButtons()[static_cast<std::size_t>(button)].Do();
    return true;
  }
  if (id == PanelId::Editor && this->OnEditorLine)
  {
    const int top = this->GetRect(id).Top() - GetTextMargin(this->TextSize);
    this->CloseMenu();
    return this->OnEditorLine((top - y) / GetLineHeight(this->TextSize));
  }
  if (id == PanelId::TimeBar && x < this->GetTimeTrack().X && this->OnPlay)
  {
    this->OnPlay();
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
std::string Hud::GetText() const
{
  const auto get = [this](PanelId id, const TextPanel& panel)
  { return this->IsShown(id) ? panel.GetText() : std::string(); };
  return get(PanelId::Status, this->Status) + "\n" + get(PanelId::Legs, this->Legs) + "\n" +
    get(PanelId::Message, this->Message);
}

} // namespace helios::viewer
