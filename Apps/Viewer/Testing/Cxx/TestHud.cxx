// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Panels over the picture: what the mouse does on them, and what is drawn.
#include "heliosHud.h"
#include "heliosPainter.h"

#include <catch2/catch.hpp>

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace helios::viewer;

namespace
{

/// A window of 800 x 600 with all panels of a run.
struct HudWindow
{
  HudWindow()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(800, 600);
    this->Window->AddRenderer(this->Renderer);
    this->Panels.Resize(800, 600);
    this->Panels.SetInteractive(true);
    this->Panels.SetTimeBar(true);
    this->Panels.SetOnPlay([this] { ++this->Plays; });
    this->Panels.SetMenus({ { "Time", { { "play", "space", [this] { ++this->Plays; }, nullptr } } },
      { "Camera",
        { { "free", "c", nullptr, nullptr },
          { "from above", "t", [this] { ++this->Views; },
            [this] { return this->Views > 0; } } } } });
    this->Panels.GetToolBar().SetButtons(
      { { "Open", "open a file (Ctrl-O)", [this] { ++this->Opens; }, nullptr },
        { "Top", "from above (t)", [this] { ++this->Views; },
          [this] { return this->Views % 2 == 1; } } });
    this->Panels.SetStatus("finished, 1.500 s\n50 k pulses");
    this->Panels.SetLegs("1 of 1 legs\n> leg 0");
    this->Panels.SetLegend({ "Height [m]", false, { { 1, 2, 3 }, { 250, 0, 250 } },
      { { 0.5, "0.5" } }, { { { 0, 250, 0 }, "none" } } });
    this->Place();
  }

  void Place()
  {
    this->Panels.Place();
    this->Window->Render();
    this->Window->GetPixelData(0, 0, 799, 599, 0, this->Pixels.Get(), 0);
  }

  Rgb GetPixel(int x, int y) const
  {
    const unsigned char* p = this->Pixels->GetPointer(3 * (800 * y + x));
    return { p[0], p[1], p[2] };
  }

  /// Whether a rectangle has a pixel of about a colour.
  bool Has(const Rect& rect, const Rgb& color) const
  {
    for (int y = rect.Y; y < rect.Top(); ++y)
    {
      for (int x = rect.X; x < rect.Right(); ++x)
      {
        const Rgb pixel = this->GetPixel(x, y);
        const int off = std::max({ std::abs(pixel[0] - color[0]), std::abs(pixel[1] - color[1]),
          std::abs(pixel[2] - color[2]) });
        if (off <= 12)
        {
          return true;
        }
      }
    }
    return false;
  }

  /// The middle of an item of the open menu.
  void PressItem(int row)
  {
    const Rect& menu = this->Panels.GetRect(PanelId::Menu);
    const int size = this->Panels.GetTextSize();
    const int y = menu.Top() - size / 2 - row * GetLineHeight(size) - GetLineHeight(size) / 2;
    CHECK(this->Panels.OnPress(menu.X + 10, y));
    this->Place();
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkUnsignedCharArray> Pixels;
  Hud Panels{ this->Renderer };
  int Plays = 0;
  int Views = 0;
  int Opens = 0;
};

} // namespace

TEST_CASE("Hud: panels are drawn in their places, in the colours of the theme")
{
  HudWindow window;
  for (const std::string& name : GetThemeNames())
  {
    const Theme& theme = FindTheme(name);
    window.Panels.SetTheme(theme);
    window.Place();
    for (const PanelId id : { PanelId::MenuBar, PanelId::TimeBar, PanelId::Status, PanelId::Legs,
           PanelId::Legend, PanelId::ScaleBar, PanelId::Axes })
    {
      CAPTURE(name, GetPanelName(id));
      CHECK_FALSE(window.Panels.GetRect(id).IsEmpty());
      CHECK(window.Has(window.Panels.GetRect(id), theme.Ink));
    }
  }
  const Rect& legend = window.Panels.GetRect(PanelId::Legend);
  CHECK(window.Has(legend, { 1, 2, 3 }));
  CHECK(window.Has(legend, { 250, 0, 250 }));
  CHECK(window.Has(legend, { 0, 250, 0 })); // beside the scale
}

TEST_CASE("Hud: a press on a title opens its menu, one on an item does it and closes the menu")
{
  HudWindow window;
  const int size = window.Panels.GetTextSize();
  const int x = window.Panels.GetMenuBar().GetTitlePosition(1, size) + size + 2;
  const int y = window.Panels.GetRect(PanelId::MenuBar).Y + 5;
  CHECK(window.Panels.OnPress(x, y));
  window.Place();
  CHECK(window.Panels.GetMenuBar().GetOpen() == 1);
  CHECK_FALSE(window.Panels.GetRect(PanelId::Menu).IsEmpty());
  window.PressItem(1);
  CHECK(window.Views == 1);
  CHECK(window.Panels.GetMenuBar().GetOpen() == -1);
  CHECK(window.Panels.GetRect(PanelId::Menu).IsEmpty());

  CHECK(window.Panels.OnPress(x, y));
  window.Place();
  window.PressItem(0); // for information only
  CHECK(window.Views == 1);

  CHECK(window.Panels.OnPress(x, y));
  CHECK(window.Panels.OnPress(x, y)); // a second press closes
  CHECK(window.Panels.GetMenuBar().GetOpen() == -1);
  CHECK(window.Panels.OnPress(x, y));
  CHECK(window.Panels.OnPress(400, 300)); // equal to one beside it
  CHECK_FALSE(window.Panels.OnPress(400, 300));
}

TEST_CASE("Hud: an item that is on has a tick")
{
  HudWindow window;
  const int size = window.Panels.GetTextSize();
  const auto open = [&window, size]
  {
    const int x = window.Panels.GetMenuBar().GetTitlePosition(1, size) + size + 2;
    CHECK(window.Panels.OnPress(x, window.Panels.GetRect(PanelId::MenuBar).Y + 5));
    window.Place();
    const Rect menu = window.Panels.GetRect(PanelId::Menu);
    const int line = GetLineHeight(size);
    const Rect tick{ menu.X + size, menu.Top() - size / 2 - 2 * line, size, line };
    return window.Has(tick, FindTheme("dark").Heading);
  };
  CHECK_FALSE(open());
  window.PressItem(1);
  CHECK(open());
}

TEST_CASE("Hud: a menu that is longer than the window scrolls")
{
  HudWindow window;
  int chosen = -1;
  Menu menu{ "Many", {} };
  for (int i = 0; i < 100; ++i)
  {
    menu.Items.push_back({ std::to_string(i), "", [&chosen, i] { chosen = i; }, nullptr });
  }
  window.Panels.SetMenus({ menu });
  window.Panels.OpenMenu("Many");
  window.Place();
  const Rect& rect = window.Panels.GetRect(PanelId::Menu);
  CHECK(rect.Height > 400);
  CHECK(window.Panels.OnWheel(rect.X + 5, rect.Y + 5, 7));
  CHECK_FALSE(window.Panels.OnWheel(790, 300, 7)); // for the camera
  window.PressItem(2);
  CHECK(chosen == 9);
  window.Panels.OpenMenu("Many");
  window.Place();
  CHECK(window.Panels.OnWheel(rect.X + 5, rect.Y + 5, 1000));
  window.PressItem(0);
  CHECK(chosen > 50);
  CHECK(chosen < 99);
}

TEST_CASE("Hud: buttons do what they say, and tell it to a mouse that rests on them")
{
  HudWindow window;
  const Rect bar = window.Panels.GetRect(PanelId::ToolBar);
  const int size = window.Panels.GetTextSize();
  REQUIRE_FALSE(bar.IsEmpty());
  CHECK(bar.Top() == window.Panels.GetRect(PanelId::MenuBar).Y);
  const Rect open = window.Panels.GetToolBar().GetPlace(bar, 0, size);
  const Rect top = window.Panels.GetToolBar().GetPlace(bar, 1, size);
  CHECK_FALSE(open.Intersects(top));
  CHECK(window.Panels.ShowTip(open.X + 3, open.Y + 3));
  CHECK_FALSE(window.Panels.ShowTip(open.X + 4, open.Y + 3)); // the same
  window.Place();
  CHECK(window.Panels.GetTip() == "open a file (Ctrl-O)");
  CHECK(window.Panels.GetRect(PanelId::Tip).Top() == bar.Y);
  CHECK(window.Panels.ShowTip(400, 300));
  window.Place();
  CHECK(window.Panels.GetRect(PanelId::Tip).IsEmpty());
  CHECK(window.Panels.OnPress(open.X + 3, open.Y + 3));
  CHECK(window.Opens == 1);
  const Rgb before = window.GetPixel(top.X + 2, top.Y + 2);
  CHECK(window.Panels.OnPress(top.X + 3, top.Y + 3));
  CHECK(window.Views == 1);
  window.Place();
  CHECK(window.GetPixel(top.X + 2, top.Y + 2) != before); // pressed in
  CHECK(window.Panels.OnPress(790, bar.Y + 5));           // between buttons: nothing
  window.Panels.Resize(open.Width + 2 * size, 600);
  window.Place();
  CHECK(window.Panels.GetToolBar()
          .GetPlace(window.Panels.GetRect(PanelId::ToolBar), 1, window.Panels.GetTextSize())
          .IsEmpty()); // no room
}

TEST_CASE("Hud: an open dialog takes the presses, and hides the panels")
{
  HudWindow window;
  window.Panels.GetDialog().Open(
    "/none", [](const std::string&) { return ""; },
    [](const std::string&) { return helios::Status(); });
  window.Place();
  CHECK_FALSE(window.Panels.GetRect(PanelId::Dialog).IsEmpty());
  CHECK(window.Panels.GetRect(PanelId::Legend).IsEmpty());
  CHECK(window.Panels.OnPress(10, 10)); // the play button
  CHECK(window.Plays == 0);
  CHECK(window.Panels.OnWheel(10, 10, 1));
  window.Panels.GetDialog().Close();
  window.Place();
  CHECK_FALSE(window.Panels.GetRect(PanelId::Legend).IsEmpty());
}

TEST_CASE("Hud: the play button plays, the rest of the time bar is the slider's")
{
  HudWindow window;
  CHECK(window.Panels.OnPress(10, 10));
  CHECK(window.Plays == 1);
  CHECK_FALSE(window.Panels.OnPress(window.Panels.GetTimeTrack().X + 50, 10));
  CHECK(window.Plays == 1);
}

TEST_CASE("Hud: hidden panels come back by a press on the upper edge")
{
  HudWindow window;
  window.Panels.SetVisible(false);
  window.Place();
  CHECK(window.Panels.GetRect(PanelId::Status).IsEmpty());
  CHECK(window.Panels.GetText() == "\n\n");
  CHECK_FALSE(window.Panels.OnPress(400, 300));
  CHECK(window.Panels.OnPress(400, 598));
  window.Place();
  CHECK_FALSE(window.Panels.GetRect(PanelId::Status).IsEmpty());
}

TEST_CASE("Hud: a still has legend, scale bar and axes only")
{
  HudWindow window;
  window.Panels.SetStill(true);
  window.Place();
  for (std::size_t i = 0; i < NumberOfPanels; ++i)
  {
    const auto id = static_cast<PanelId>(i);
    CAPTURE(GetPanelName(id));
    const bool isShown = id == PanelId::Legend || id == PanelId::ScaleBar || id == PanelId::Axes;
    CHECK(window.Panels.GetRect(id).IsEmpty() == !isShown);
  }
}

TEST_CASE("Hud: the help fits the window at every size")
{
  std::vector<Menu> menus;
  for (int i = 0; i < 9; ++i)
  {
    menus.push_back({ "Menu", {} });
    for (int k = 0; k < 8; ++k)
    {
      menus.back().Items.push_back(
        { "a rather long text of an action of the viewer", "key", {}, {} });
    }
  }
  const HelpPage page(menus);
  for (const PanelSize& size : { PanelSize{ 800, 600 }, { 1280, 800 }, { 1920, 1080 } })
  {
    const int text = GetTextSize(size.Width, size.Height);
    const Rect rect{ 8, 32, size.Width - 16, size.Height - 64 };
    CAPTURE(size.Width);
    CHECK(page.Fits(rect, page.FindTextSize(rect, text)));
  }
}

TEST_CASE("Hud: the scale bar has the length that it tells")
{
  HudWindow window;
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(30.0); // 0.1 m a pixel
  const ScaleBar& bar = window.Panels.GetScaleBar();
  CHECK(bar.GetMetresPerPixel() == Approx(0.1));
  CHECK(bar.GetLength() == Approx(10.0)); // at most 160 pixels
  CHECK(bar.GetLabel() == "10 m");
  window.Place();
  const Rect rect = window.Panels.GetRect(PanelId::ScaleBar).Shrunk(6);
  int pixels = 0; // middle of the bar's lowest line
  for (int x = 0; x < 800; ++x)
  {
    pixels += window.Has({ x, rect.Y, 1, 3 }, FindTheme("dark").Ink) ? 1 : 0;
  }
  CHECK(pixels == Approx(100).margin(3));
  camera->ParallelProjectionOff();
  CHECK(bar.GetLabel().find("at the centre") != std::string::npos);
}

TEST_CASE("Hud: the axes point where the camera shows east, north and up")
{
  HudWindow window;
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 10.0); // from above, north up
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  double direction[3];
  window.Panels.GetAxes().GetDirection(0, direction);
  CHECK(direction[0] == Approx(1.0));
  window.Panels.GetAxes().GetDirection(1, direction);
  CHECK(direction[1] == Approx(1.0));
  window.Panels.GetAxes().GetDirection(2, direction);
  CHECK(direction[2] == Approx(1.0));   // at the viewer
  camera->SetPosition(-10.0, 0.0, 8.0); // looking east: both east and up are up on the screen
  camera->SetViewUp(0.0, 0.0, 1.0);
  CHECK_FALSE(window.Panels.GetAxes().HasName(0));
  CHECK(window.Panels.GetAxes().HasName(1));
  CHECK(window.Panels.GetAxes().HasName(2));
}

TEST_CASE("Painter: long texts end in an ellipsis that fits")
{
  const std::string text = "a message that is far too long for its panel";
  const int width = MeasureText(text, 14);
  CHECK(width > 150);
  CHECK(Shorten(text, 14, width) == text);
  const std::string cut = Shorten(text, 14, width / 2);
  CHECK(cut.size() < text.size());
  CHECK(MeasureText(cut, 14) <= width / 2);
  CHECK(cut.substr(cut.size() - 3) == "\xE2\x80\xA6");
  CHECK(Shorten(text, 14, 0).empty());
}
