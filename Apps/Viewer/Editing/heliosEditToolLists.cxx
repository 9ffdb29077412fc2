// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Lists of platforms, instruments, parts and models to choose from.
#include "heliosEditTool.h"

#include "heliosViewer.h"

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace helios::viewer
{

namespace
{

/// Returns an entry, some steps after a given one.
template <typename T>
const std::pair<std::string, T>* FindNext(
  const std::vector<std::pair<std::string, T>>& entries, const std::string& reference, int step)
{
  if (entries.empty())
  {
    return nullptr;
  }
  const auto now = std::find_if(entries.begin(), entries.end(),
    [&reference](const auto& entry) { return entry.first == reference; });
  const auto count = static_cast<int>(entries.size());
  const int at = now == entries.end() ? -1 : static_cast<int>(now - entries.begin());
  return &entries[static_cast<std::size_t>((at + step + 2 * count) % count)];
}

/// A static platform covers all directions only with head rotation.
bool IsFit(const SurveyEdit& edit, const ScannerData& scanner)
{
  return edit.IsMoving() || scanner.HeadRotateSpeedMax > 0.0;
}

} // namespace

//------------------------------------------------------------------------------
void EditTool::ChangePlatform(int step)
{
  const auto* next = FindNext(this->Choice.Platforms, this->Edit.Platform, step);
  if (!next)
  {
    this->Owner.ShowMessage("the catalogue has no platform: give its folder with --assets");
    return;
  }
  this->SetPlatform(*next);
}

//------------------------------------------------------------------------------
void EditTool::SetPlatform(const std::pair<std::string, PlatformData>& platform)
{
  this->Remember();
  ChoosePlatform(this->Edit, platform.first, platform.second);
  if (!IsFit(this->Edit, this->Edit.ScannerModel))
  {
    this->ChangeScanner(1, true);
  }
  this->ShowGhost();
  this->ShowPanel();
  this->Owner.UpdateMenus(); // instruments that fit
}

//------------------------------------------------------------------------------
void EditTool::SetScanner(const std::pair<std::string, ScannerData>& scanner)
{
  this->Remember();
  ChooseScanner(this->Edit, scanner.first, scanner.second);
  this->ShowGhost();
  this->ShowPanel();
}

//------------------------------------------------------------------------------
/// Returns lists of platforms and instruments, or of the parts of the scene and of models to add.
std::vector<Menu> EditTool::GetMenus()
{
  if (!this->IsOn)
  {
    return {};
  }
  if (this->Doing == Mode::Parts)
  {
    Menu parts{ "Part", {} };
    for (int i = 0; i < this->Scene.GetNumberOfParts(); ++i)
    {
      const std::string name = this->Scene.GetPartName(i);
      const auto select = [this, name]
      {
        this->Part = name;
        this->ShowPanel();
      };
      parts.Items.push_back({ name, "", select, [this, name] { return this->Part == name; } });
    }
    Menu models{ "Model", {} };
    for (std::size_t i = 0; i < this->Files.size(); ++i)
    {
      const auto select = [this, i]
      {
        this->File = i;
        this->ShowPanel();
      };
      models.Items.push_back({ fs::path(this->Files[i]).filename().string(), "", select,
        [this, i] { return this->File == i; } });
    }
    return { parts, models };
  }
  Menu platforms{ "Platform", {} };
  for (const auto& entry : this->Choice.Platforms)
  {
    platforms.Items.push_back({ entry.second.Name, "", [this, &entry] { this->SetPlatform(entry); },
      [this, &entry] { return this->Edit.Platform == entry.first; } });
  }
  Menu scanners{ "Instrument", {} };
  for (const auto& entry : this->Choice.Scanners)
  {
    if (IsFit(this->Edit, entry.second))
    {
      scanners.Items.push_back({ entry.second.Name, "", [this, &entry] { this->SetScanner(entry); },
        [this, &entry] { return this->Edit.Scanner == entry.first; } });
    }
  }
  return { platforms, scanners };
}

//------------------------------------------------------------------------------
void EditTool::ChangeScanner(int step, bool isRemembered)
{
  const auto* next = FindNext(this->Choice.Scanners, this->Edit.Scanner, step);
  for (std::size_t i = 0; next && !IsFit(this->Edit, next->second); ++i)
  {
    next = i < this->Choice.Scanners.size() ? FindNext(this->Choice.Scanners, next->first, step)
                                            : nullptr;
  }
  if (!next)
  {
    this->Owner.ShowMessage(
      "the catalogue has no other instrument for it: give a folder with --assets");
    return;
  }
  isRemembered ? void() : this->Remember();
  ChooseScanner(this->Edit, next->first, next->second);
  this->ShowGhost();
  this->ShowPanel();
}

} // namespace helios::viewer
