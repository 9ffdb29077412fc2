// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Text over the picture: status, legs, messages, and the help.

#ifndef heliosHud_h
#define heliosHud_h

#include <vtkNew.h>

#include <string>

class vtkRenderer;
class vtkTextActor;

namespace helios::viewer
{

class Hud
{
public:
  explicit Hud(vtkRenderer* renderer);
  ~Hud();

  /// Several lines each; empty: none.
  void SetStatus(const std::string& text);  ///< top left
  void SetLegs(const std::string& text);    ///< top right
  void SetMessage(const std::string& text); ///< above the time bar
  void SetHelp(const std::string& text);    ///< centred, on top

  void SetHelpVisible(bool visible);
  bool IsHelpVisible() const;

  /// Status, legs and messages; the help is separate.
  void SetVisible(bool visible);
  bool IsVisible() const;

  /// Fits the font to the window size [pixels].
  void Resize(int width, int height);

  /// The current text: status, legs and message.
  std::string GetText() const;

private:
  vtkRenderer* Renderer;
  vtkNew<vtkTextActor> Status;
  vtkNew<vtkTextActor> Legs;
  vtkNew<vtkTextActor> Message;
  vtkNew<vtkTextActor> Help;
};

} // namespace helios::viewer

#endif
