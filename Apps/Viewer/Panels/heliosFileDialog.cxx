// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFileDialog.h"

#include "heliosPainter.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace fs = std::filesystem;

namespace helios::viewer
{

namespace
{

constexpr double DoubleClickSeconds = 0.5;

} // namespace

//------------------------------------------------------------------------------
void FileDialog::Begin(const std::string& folder, const FileKind& kind, Done done)
{
  this->Files.SetKind(kind);
  this->OnDone = std::move(done);
  this->Text.clear();
  this->Hint.clear();
  this->Confirmed.clear();
  this->IsShown = true;
  this->IsNew = true;
  this->Enter(folder.empty() ? "." : folder);
}

//------------------------------------------------------------------------------
void FileDialog::Open(const std::string& fileName, const FileKind& kind, Done done)
{
  const fs::path path(fileName);
  this->IsSaving = false;
  this->Begin(path.parent_path().string(), kind, std::move(done));
  this->Files.Select(path.filename().string());
}

//------------------------------------------------------------------------------
void FileDialog::SaveAs(const std::string& fileName, const FileKind& kind, Done done)
{
  this->IsSaving = true;
  const fs::path path(fileName);
  this->Begin(path.parent_path().string(), kind, std::move(done));
  this->Text = path.filename().string();
  this->Files.Select(-1);
}

//------------------------------------------------------------------------------
/// Lists a folder.
void FileDialog::Enter(const std::string& folder)
{
  if (!this->Files.SetFolder(folder))
  {
    this->Hint = folder + ": this folder cannot be read";
    return;
  }
  this->First = 0;
  this->Pressed = -1;
  this->Hint.clear();
  this->IsSaving ? this->Files.Select(-1) : this->Text.clear();
}

//------------------------------------------------------------------------------
void FileDialog::SetText(const std::string& text)
{
  this->Text = text;
  this->Hint.clear();
  this->Confirmed.clear();
  if (!this->IsSaving)
  {
    this->First = 0;
    this->Files.SetFilter(this->IsPath() ? "" : text);
  }
}

//------------------------------------------------------------------------------
void FileDialog::Finish(const std::string& path)
{
  const Status status = this->OnDone(path);
  this->Hint = status.Message();
  this->IsShown = !status.IsOk();
}

//------------------------------------------------------------------------------
/// Does what Return and the button do.
void FileDialog::Accept()
{
  const FileEntry* entry = this->Files.GetEntry();
  if (this->IsSaving && entry && entry->IsFolder)
  {
    this->Enter(this->Files.GetPath(entry->Name));
    return;
  }
  this->IsSaving || this->IsPath() ? this->AcceptName() : this->AcceptEntry();
}

//------------------------------------------------------------------------------
void FileDialog::AcceptName()
{
  std::error_code error;
  const std::string path = this->Files.GetPath(this->Text);
  if (this->Text.empty())
  {
    this->Hint = "write the name of the file";
  }
  else if (fs::is_directory(path, error))
  {
    this->Text.clear();
    this->Enter(path);
  }
  else if (!this->IsSaving)
  {
    fs::exists(path, error) ? this->Finish(path)
                            : void(this->Hint = path + ": no such file; check the name");
  }
  else if (fs::exists(path, error) && this->Confirmed != path)
  {
    this->Confirmed = path;
    this->Hint = this->Text + " exists: save again to replace it";
  }
  else
  {
    this->Finish(path);
  }
}

//------------------------------------------------------------------------------
void FileDialog::AcceptEntry()
{
  const FileEntry* entry = this->Files.GetEntry();
  if (!entry)
  {
    this->Hint = this->Text.empty() ? "nothing here can be opened"
                                    : "no name here contains \"" + this->Text + "\"";
    return;
  }
  const std::string path = this->Files.GetPath(entry->Name);
  entry->IsFolder && entry->Kind.empty() ? this->Enter(path) : this->Finish(path);
}

//------------------------------------------------------------------------------
/// Completes a path to what the names that begin with it have in common, or enters the folder.
void FileDialog::Complete()
{
  const std::size_t slash = this->Text.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : this->Text.substr(0, slash + 1);
  const std::string begin = this->Text.substr(folder.size());
  FileList names;
  names.SetKind([](const std::string&) { return "file"; });
  if (!names.SetFolder(this->Files.GetPath(folder)))
  {
    return;
  }
  std::string common;
  int count = 0;
  bool isFolder = false;
  for (const FileEntry& entry : names.GetEntries())
  {
    if (entry.Name.compare(0, begin.size(), begin) == 0)
    {
      const auto end =
        std::mismatch(common.begin(), common.end(), entry.Name.begin(), entry.Name.end()).first;
      common = count == 0 ? entry.Name : std::string(common.begin(), end);
      isFolder = entry.IsFolder;
      ++count;
    }
  }
  count > 0 ? this->SetText(folder + common + (count == 1 && isFolder ? "/" : "")) : void();
}

//------------------------------------------------------------------------------
void FileDialog::OnKey(const std::string& key, char character)
{
  const int page = std::max(1, this->Rows - 1);
  const std::pair<const char*, int> moves[] = { { "Up", -1 }, { "Down", 1 }, { "Prior", -page },
    { "Next", page }, { "Home", -1000000 }, { "End", 1000000 } };
  const auto* move =
    std::find_if(std::begin(moves), std::end(moves), [&](const auto& m) { return key == m.first; });
  const FileEntry* entry = this->Files.GetEntry();
  if (move != std::end(moves))
  {
    this->Files.Move(move->second);
    this->First = std::clamp(this->First, std::max(0, this->Files.GetSelected() - this->Rows + 1),
      std::max(0, this->Files.GetSelected()));
  }
  else if (key == "Escape")
  {
    this->Close();
  }
  else if (key == "Return" || key == "KP_Enter")
  {
    this->Accept();
  }
  else if (key == "Tab")
  {
    this->Complete();
  }
  else if (key == "Left" || (key == "BackSpace" && this->Text.empty()))
  {
    this->Files.MoveUp();
  }
  else if (key == "Right" && entry && entry->IsFolder)
  {
    this->Enter(this->Files.GetPath(entry->Name));
  }
  else if (key == "BackSpace")
  {
    this->SetText(this->Text.substr(0, this->Text.size() - 1));
  }
  else if (std::isprint(static_cast<unsigned char>(character)) != 0)
  {
    this->IsSaving ? this->Files.Select(-1) : void();
    this->SetText(this->Text + character);
  }
}

//------------------------------------------------------------------------------
void FileDialog::OnWheel(int rows)
{
  const auto count = static_cast<int>(this->Files.GetEntries().size());
  this->First = std::clamp(this->First + rows, 0, std::max(0, count - this->Rows));
}

//------------------------------------------------------------------------------
void FileDialog::OnPress(const Rect& rect, int x, int y, int textSize, double time)
{
  const Places places = GetPlaces(rect, textSize);
  if (places.Cancel.Contains(x, y))
  {
    this->Close();
  }
  else if (places.Accept.Contains(x, y))
  {
    this->Accept();
  }
  else if (places.Up.Contains(x, y))
  {
    this->Files.MoveUp();
  }
  else if (places.List.Contains(x, y))
  {
    const int row = (places.List.Top() - 1 - y) / GetLineHeight(textSize);
    const int entry = this->First + row;
    const bool isAgain = entry == this->Pressed && time - this->PressedAt < DoubleClickSeconds;
    this->Files.Select(entry);
    this->Pressed = entry;
    this->PressedAt = time;
    const FileEntry* selected = this->Files.GetEntry();
    if (selected && this->IsSaving && !selected->IsFolder)
    {
      this->SetText(selected->Name);
    }
    isAgain&& selected ? this->Accept() : void();
  }
}

//------------------------------------------------------------------------------
PanelSize FileDialog::GetSize(int textSize) const
{
  return this->IsShown ? PanelSize{ 50 * textSize, 32 * textSize } : PanelSize{};
}

//------------------------------------------------------------------------------
FileDialog::Places FileDialog::GetPlaces(const Rect& rect, int textSize)
{
  const int line = GetLineHeight(textSize) + textSize / 2;
  const int gap = textSize / 2;
  const Rect inside = rect.Shrunk(textSize);
  const int button = 6 * textSize;
  Places places;
  int y = inside.Top() - line;
  places.Title = { inside.X, y, inside.Width, line };
  y -= line;
  places.Up = { inside.X, y, 3 * textSize, line };
  const int right = places.Up.Right() + gap;
  places.Path = { right, y, inside.Right() - right, line };
  y -= line + gap;
  places.Field = { inside.X, y, inside.Width, line };
  places.Cancel = { inside.Right() - button, inside.Y, button, line };
  places.Accept = { places.Cancel.X - gap - button, inside.Y, button, line };
  places.Hint = { inside.X, inside.Y, places.Accept.X - gap - inside.X, line };
  const int bottom = places.Cancel.Top() + gap;
  places.List = { inside.X, bottom, inside.Width, std::max(0, y - gap - bottom) };
  return places;
}

//------------------------------------------------------------------------------
Rect FileDialog::GetRow(const Rect& rect, int entry, int textSize) const
{
  const Rect list = GetPlaces(rect, textSize).List;
  const int line = GetLineHeight(textSize);
  const Rect row{ list.X, list.Top() - (entry - this->First + 1) * line, list.Width, line };
  return entry < this->First || row.Y < list.Y ? Rect() : row;
}

//------------------------------------------------------------------------------
void FileDialog::PaintButton(Painter& painter, const Rect& rect, const std::string& text) const
{
  painter.Fill(rect, painter.GetTheme().Border);
  painter.DrawText(rect.X + rect.Width / 2, rect.Y + rect.Height / 2, text, painter.GetTheme().Ink,
    Painter::Align::Center);
}

//------------------------------------------------------------------------------
void FileDialog::PaintRow(
  Painter& painter, const Rect& row, const FileEntry& entry, bool isSelected) const
{
  const Theme& theme = painter.GetTheme();
  const int size = painter.GetTextSize();
  isSelected ? painter.Fill(row, theme.Handle, 110) : void();
  const int y = row.Y + row.Height / 2;
  const int kind = 8 * size;
  painter.DrawText(row.X + size / 2, y,
    Shorten(entry.Name + (entry.IsFolder ? "/" : ""), size, row.Width - kind - size),
    entry.IsFolder ? theme.Heading : theme.Ink);
  painter.DrawText(row.Right() - size / 2, y,
    entry.Kind.empty() && entry.IsFolder ? "folder" : entry.Kind, theme.FaintInk,
    Painter::Align::Right);
}

//------------------------------------------------------------------------------
void FileDialog::Paint(Painter& painter, const Rect& rect) const
{
  const Theme& theme = painter.GetTheme();
  const int size = painter.GetTextSize();
  const Places places = GetPlaces(rect, size);
  const auto middle = [](const Rect& place) { return place.Y + place.Height / 2; };
  painter.Fill(rect, theme.Panel);
  painter.DrawPanel(rect);
  painter.DrawText(
    places.Title.X, middle(places.Title), this->IsSaving ? "Save as" : "Open", theme.Heading);
  this->PaintButton(painter, places.Up, "Up");
  painter.DrawText(places.Path.X, middle(places.Path),
    Shorten(this->Files.GetFolder(), size, places.Path.Width), theme.Ink);
  painter.Fill(places.Field, theme.Border, 90);
  const std::string caret = this->Text + "|";
  const std::string empty = this->IsSaving ? "name" : "filter, or a path: / ~";
  painter.DrawText(places.Field.X + size / 2, middle(places.Field),
    this->Text.empty() ? empty : Shorten(caret, size, places.Field.Width - size),
    this->Text.empty() ? theme.FaintInk : theme.Ink);
  const auto count = static_cast<int>(this->Files.GetEntries().size());
  this->Rows = std::max(1, places.List.Height / GetLineHeight(size));
  if (this->IsNew) // the selected one is in sight
  {
    this->First = std::max(0, this->Files.GetSelected() - this->Rows + 1);
    this->IsNew = false;
  }
  for (int i = this->First; i < std::min(count, this->First + this->Rows); ++i)
  {
    this->PaintRow(painter, this->GetRow(rect, i, size),
      this->Files.GetEntries()[static_cast<std::size_t>(i)], i == this->Files.GetSelected());
  }
  if (count > this->Rows)
  {
    const int height = places.List.Height * this->Rows / count;
    const int top = places.List.Top() - places.List.Height * this->First / count;
    painter.Fill({ places.List.Right() - 3, top - height, 3, height }, theme.Groove);
  }
  const std::string help =
    this->IsSaving ? "Return saves, Esc closes" : "Return opens, Backspace goes up, Esc closes";
  painter.DrawText(places.Hint.X, middle(places.Hint),
    Shorten(this->Hint.empty() ? help : this->Hint, size, places.Hint.Width),
    this->Hint.empty() ? theme.FaintInk : theme.Warning);
  this->PaintButton(painter, places.Accept, this->IsSaving ? "Save" : "Open");
  this->PaintButton(painter, places.Cancel, "Cancel");
}

} // namespace helios::viewer
