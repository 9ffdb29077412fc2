// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines of text in a box.

#ifndef heliosTextPanel_h
#define heliosTextPanel_h

#include "heliosPanel.h"

#include <string>
#include <vector>

namespace helios::viewer
{

class TextPanel : public Panel
{
public:
  /// Makes a panel; isWarning: in the colour of messages.
  explicit TextPanel(bool isWarning = false)
    : IsWarning(isWarning)
  {
  }

  /// Lines; empty: not shown.
  void SetText(const std::string& text);
  const std::string& GetText() const { return this->Text; }

  PanelSize GetSize(int textSize) const override;

  /// Lines that do not fit are shortened or left out.
  void Paint(Painter& painter, const Rect& rect) const override;

private:
  bool IsWarning;
  std::string Text;
  std::vector<std::string> Lines;
};

/// Returns the space around the text of a panel [pixels].
int GetTextMargin(int textSize);

} // namespace helios::viewer

#endif
