// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A dialog by which a file is opened or named.

#ifndef heliosFileDialog_h
#define heliosFileDialog_h

#include "heliosFileList.h"
#include "heliosPanel.h"
#include "heliosStatus.h"

#include <functional>
#include <string>

namespace helios::viewer
{

/**
 * Folders and files by mouse and keyboard: a click selects, a second one opens, letters filter the
 * list or write a path, Tab completes, Backspace goes up, Escape closes.
 */
class FileDialog : public Panel
{
public:
  /// Receives the file; the dialog shows an error, and stays open.
  using Done = std::function<Status(const std::string& path)>;

  /// Opens the dialog in the folder of a file, for one that exists.
  void Open(const std::string& fileName, const FileKind& kind, Done done);

  /// Opens the dialog for the name of a file to write; one that exists must be confirmed.
  void SaveAs(const std::string& fileName, const FileKind& kind, Done done);

  void Close() { this->IsShown = false; }
  bool IsOpen() const { return this->IsShown; }

  const FileList& GetList() const { return this->Files; }
  const std::string& GetText() const { return this->Text; }
  const std::string& GetHint() const { return this->Hint; }

  /// Handles a key by its X name, and the character that it writes; 0: none.
  void OnKey(const std::string& key, char character);

  /// Handles a press at a time [s], in the rectangle of the dialog [pixels].
  void OnPress(const Rect& rect, int x, int y, int textSize, double time);

  /// Scrolls the list by rows.
  void OnWheel(int rows);

  PanelSize GetSize(int textSize) const override;
  void Paint(Painter& painter, const Rect& rect) const override;

  /// @{
  /// Returns the parts of the dialog [pixels].
  struct Places
  {
    Rect Title, Up, Path, Field, List, Hint, Accept, Cancel;
  };
  static Places GetPlaces(const Rect& rect, int textSize);
  Rect GetRow(const Rect& rect, int entry, int textSize) const; ///< empty: scrolled out
  ///@}

private:
  void Begin(const std::string& folder, const FileKind& kind, Done done);
  void SetText(const std::string& text);
  void Accept();
  void AcceptName();
  void AcceptEntry();
  void Finish(const std::string& path);
  void Enter(const std::string& folder);
  void Complete();
  bool IsPath() const { return this->Text.find('/') != std::string::npos || this->Text == "~"; }
  void PaintRow(Painter& painter, const Rect& row, const FileEntry& entry, bool isSelected) const;
  void PaintButton(Painter& painter, const Rect& rect, const std::string& text) const;

  FileList Files;
  Done OnDone;
  std::string Text; ///< filter, path, or name
  std::string Hint;
  std::string Confirmed; ///< file that may be replaced
  bool IsShown = false;
  bool IsSaving = false;
  mutable bool IsNew = false; ///< not yet drawn
  mutable int First = 0;      ///< first row
  mutable int Rows = 1;       ///< rows that fit
  int Pressed = -1;
  double PressedAt = 0.0;
};

} // namespace helios::viewer

#endif
