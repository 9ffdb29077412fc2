// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosViewerKeys.h"

#include "heliosViewerTool.h"

#include <algorithm>

namespace helios::viewer
{

//------------------------------------------------------------------------------
bool ViewerKeys::Press(const std::string& key, bool control)
{
  const std::string name = control ? "Control-" + key : key;
  const auto hasKey = [&name](const Action& action)
  { return std::find(action.Keys.begin(), action.Keys.end(), name) != action.Keys.end(); };
  const bool isOwn = control && std::any_of(this->Actions.begin(), this->Actions.end(), hasKey);
  for (const auto& tool : this->Tools)
  {
    if (!isOwn && tool->OnKey(key, control))
    {
      return true;
    }
  }
  for (const Action& action : this->Actions)
  {
    if (hasKey(action))
    {
      action.Do();
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::vector<Menu> ViewerKeys::GetMenus()
{
  std::vector<Menu> menus;
  for (const Action& action : this->Actions)
  {
    if (!action.Heading.empty())
    {
      menus.push_back({ action.Heading, {} });
    }
    menus.back().Items.push_back({ action.What, action.Shown, action.Do, action.IsOn });
  }
  for (const auto& tool : this->Tools)
  {
    Menu menu{ tool->GetName(), {} };
    for (const KeyHelp& key : tool->GetKeys())
    {
      MenuItem item{ key.What, key.Shown, nullptr, nullptr };
      if (!key.Press.empty())
      {
        item.Do = [this, press = key.Press] { this->Press(press, false); };
      }
      menu.Items.push_back(item);
    }
    menu.Items.empty() ? void() : menus.push_back(menu);
    for (const Menu& own : tool->GetMenus())
    {
      menus.push_back(own);
    }
  }
  return menus;
}

} // namespace helios::viewer
