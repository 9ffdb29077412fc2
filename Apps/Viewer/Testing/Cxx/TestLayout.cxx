// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLayout.h"
#include "heliosTheme.h"

#include <catch2/catch.hpp>

#include <random>
#include <vector>

using namespace helios::viewer;

namespace
{

const std::vector<PanelSize> Windows = { { 800, 600 }, { 1280, 800 }, { 1920, 1080 } };

std::vector<PanelId> GetAll()
{
  std::vector<PanelId> all;
  for (std::size_t i = 0; i < NumberOfPanels; ++i)
  {
    all.push_back(static_cast<PanelId>(i));
  }
  return all;
}

/// Sizes as texts of the viewer have, in text heights; all but help and menu.
Layout MakeTypical(const PanelSize& window)
{
  const int size = GetTextSize(window.Width, window.Height);
  Layout layout;
  layout.SetWindow(window.Width, window.Height, size);
  layout.SetSize(PanelId::MenuBar, { 1, 2 * size });
  layout.SetSize(PanelId::ToolBar, { 1, 2 * size });
  layout.SetSize(PanelId::TimeBar, { 1, 2 * size });
  layout.SetSize(PanelId::Status, { 22 * size, 5 * size });
  layout.SetSize(PanelId::Legs, { 13 * size, 20 * size });
  layout.SetSize(PanelId::Legend, { 8 * size, 20 * size });
  layout.SetSize(PanelId::Axes, { 6 * size, 6 * size });
  layout.SetSize(PanelId::ScaleBar, { 12 * size, 3 * size });
  layout.SetSize(PanelId::Cursor, { 20 * size, 2 * size });
  layout.SetSize(PanelId::Message, { 30 * size, 2 * size });
  layout.SetSize(PanelId::Chart, { window.Width / 2, 46 * window.Height / 100 });
  return layout;
}

void CheckPlaces(const Layout& layout, const PanelSize& window)
{
  const Rect whole{ 0, 0, window.Width, window.Height };
  for (const PanelId a : GetAll())
  {
    const Rect& first = layout.Get(a);
    CAPTURE(GetPanelName(a), first.X, first.Y, first.Width, first.Height, window.Width);
    CHECK((first.IsEmpty() ||
      (first.X >= 0 && first.Y >= 0 && first.Right() <= whole.Width &&
        first.Top() <= whole.Height)));
    for (const PanelId b : GetAll())
    {
      CAPTURE(GetPanelName(b));
      const bool isTip = a == PanelId::Tip || b == PanelId::Tip; // over others
      CHECK((a == b || isTip || !first.Intersects(layout.Get(b))));
    }
  }
}

} // namespace

TEST_CASE("Layout: all panels of a run have room, and none covers another")
{
  for (const PanelSize& window : Windows)
  {
    Layout layout = MakeTypical(window);
    layout.Place();
    CheckPlaces(layout, window);
    for (const PanelId id :
      { PanelId::MenuBar, PanelId::TimeBar, PanelId::Status, PanelId::Legs, PanelId::Legend,
        PanelId::Axes, PanelId::ScaleBar, PanelId::Cursor, PanelId::Message, PanelId::Chart })
    {
      CAPTURE(GetPanelName(id), window.Width);
      CHECK_FALSE(layout.Get(id).IsEmpty());
    }
  }
}

TEST_CASE("Layout: sliders and chart are side by side")
{
  for (const PanelSize& window : Windows)
  {
    Layout layout = MakeTypical(window);
    const int size = GetTextSize(window.Width, window.Height);
    layout.SetSize(PanelId::Editor, { 16 * size, 29 * size });
    layout.Place();
    CheckPlaces(layout, window);
    const Rect editor = layout.Get(PanelId::Editor), chart = layout.Get(PanelId::Chart);
    CAPTURE(window.Width);
    CHECK_FALSE(editor.IsEmpty());
    CHECK_FALSE(chart.IsEmpty());
    CHECK(chart.X >= editor.Right());
  }
}

TEST_CASE("Layout: the help has all the room between the bars, an open menu hides what it covers")
{
  Layout layout = MakeTypical(Windows[1]);
  layout.SetSize(PanelId::Menu, { 300, 400 });
  layout.SetMenuPosition(10);
  layout.Place();
  CheckPlaces(layout, Windows[1]);
  CHECK(layout.Get(PanelId::Menu).Top() == layout.Get(PanelId::MenuBar).Y);
  CHECK(layout.Get(PanelId::Status).IsEmpty());
  CHECK_FALSE(layout.Get(PanelId::Legs).IsEmpty());
  layout.SetSize(PanelId::Help, { 1, 1 });
  layout.Place();
  CheckPlaces(layout, Windows[1]);
  CHECK(layout.Get(PanelId::Help).Width > 1200);
  CHECK(layout.Get(PanelId::Legend).IsEmpty());
  PanelId id = PanelId::Status;
  CHECK(layout.Find(640, 400, id));
  CHECK(id == PanelId::Help);
}

TEST_CASE("Layout: panels of any size never cover each other")
{
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i)
  {
    const auto draw = [&random](int most)
    { return static_cast<int>(random() % unsigned(most + 1)); };
    const PanelSize window{ 64 + draw(2000), 64 + draw(1200) };
    Layout layout;
    layout.SetWindow(window.Width, window.Height, 12);
    for (const PanelId id : GetAll())
    {
      if (id != PanelId::Help && draw(3) > 0)
      {
        layout.SetSize(id, { draw(window.Width), draw(window.Height) });
      }
    }
    layout.SetMenuPosition(draw(window.Width));
    layout.Place();
    CheckPlaces(layout, window);
  }
}

TEST_CASE("Layout: a dialog is alone, in the middle, and within small windows")
{
  for (const PanelSize& window : { PanelSize{ 400, 300 }, { 800, 600 }, { 1920, 1080 } })
  {
    Layout layout = MakeTypical(window);
    layout.SetSize(PanelId::Dialog, { 600, 400 });
    layout.Place();
    CheckPlaces(layout, window);
    const Rect& dialog = layout.Get(PanelId::Dialog);
    CHECK(dialog.X + dialog.Width / 2 == Approx(window.Width / 2).margin(1));
    CHECK(dialog.Width <= 600);
    CHECK(layout.Get(PanelId::Legend).IsEmpty());
    CHECK_FALSE(layout.Get(PanelId::ToolBar).IsEmpty());
  }
}

TEST_CASE("Layout: an open menu hides the buttons, a tip hangs below them")
{
  const PanelSize window{ 1280, 800 };
  Layout layout = MakeTypical(window);
  layout.SetSize(PanelId::Tip, { 200, 30 });
  layout.SetTipPosition(1200); // would leave the window
  layout.Place();
  CHECK_FALSE(layout.Get(PanelId::Legs).IsEmpty()); // below the tip
  CHECK(layout.Get(PanelId::Tip).Top() == layout.Get(PanelId::ToolBar).Y);
  CHECK(layout.Get(PanelId::Tip).Right() == 1280);
  layout.SetSize(PanelId::Menu, { 200, 300 });
  layout.Place();
  CheckPlaces(layout, window);
  CHECK(layout.Get(PanelId::Menu).Top() == layout.Get(PanelId::MenuBar).Y);
  CHECK(layout.Get(PanelId::ToolBar).IsEmpty());
  CHECK(layout.Get(PanelId::Tip).IsEmpty());
}
