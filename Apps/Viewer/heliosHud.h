// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The words over the picture: what is going on, the legs, messages, and the help.

#ifndef heliosHud_h
#define heliosHud_h

#include <vtkNew.h>

#include <string>

class vtkRenderer;
class vtkTextActor;

namespace helios
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
  void SetHelp(const std::string& text);    ///< in the middle, over all

  void SetHelpVisible(bool visible);
  bool IsHelpVisible() const;

  /// Status, legs and messages; the help is apart.
  void SetVisible(bool visible);
  bool IsVisible() const;

  /// Fits the letters to the window's size [pixels].
  void Resize(int width, int height);

  /// What is written now: status, legs and message.
  std::string GetText() const;

private:
  vtkRenderer* Renderer;
  vtkNew<vtkTextActor> Status;
  vtkNew<vtkTextActor> Legs;
  vtkNew<vtkTextActor> Message;
  vtkNew<vtkTextActor> Help;
};

} // namespace helios

#endif
