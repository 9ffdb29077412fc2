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
  for (const auto& tool : this->Tools)
  {
    if (tool->OnKey(key, control))
    {
      return true;
    }
  }
  for (const Action& action : this->Actions)
  {
    if (!control && std::find(action.Keys.begin(), action.Keys.end(), key) != action.Keys.end())
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
    menus.back().Items.push_back({ action.What, action.Shown, action.Do });
  }
  for (const auto& tool : this->Tools)
  {
    Menu menu{ tool->GetName(), {} };
    for (const KeyHelp& key : tool->GetKeys())
    {
      MenuItem item{ key.What, key.Shown, nullptr };
      if (!key.Press.empty())
      {
        item.Do = [this, press = key.Press] { this->Press(press, false); };
      }
      menu.Items.push_back(item);
    }
    menus.push_back(menu);
  }
  return menus;
}

} // namespace helios::viewer
