// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rectangles of window pixels, counted from the lower left.

#ifndef heliosRect_h
#define heliosRect_h

#include <algorithm>

namespace helios::viewer
{

struct PanelSize
{
  int Width = 0;
  int Height = 0;

  bool IsEmpty() const { return this->Width <= 0 || this->Height <= 0; }
};

/// Without width or height: nothing.
struct Rect
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;

  bool IsEmpty() const { return this->Width <= 0 || this->Height <= 0; }
  int Right() const { return this->X + this->Width; }
  int Top() const { return this->Y + this->Height; }

  bool Contains(int x, int y) const
  {
    return x >= this->X && y >= this->Y && x < this->Right() && y < this->Top();
  }

  bool Intersects(const Rect& other) const
  {
    return !this->IsEmpty() && !other.IsEmpty() && this->X < other.Right() &&
      other.X < this->Right() && this->Y < other.Top() && other.Y < this->Top();
  }

  /// Returns the rectangle less a margin on all sides.
  Rect Shrunk(int margin) const
  {
    return { this->X + margin, this->Y + margin, std::max(0, this->Width - 2 * margin),
      std::max(0, this->Height - 2 * margin) };
  }

  bool operator==(const Rect& b) const
  {
    return this->X == b.X && this->Y == b.Y && this->Width == b.Width && this->Height == b.Height;
  }
};

} // namespace helios::viewer

#endif
