// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The legend of the colours: a scale with ticks, or a list of categories.

#ifndef heliosLegend_h
#define heliosLegend_h

#include "heliosColorMaps.h"
#include "heliosPanel.h"

#include <string>
#include <utility>
#include <vector>

namespace helios::viewer
{

/// Contents of a legend.
struct Legend
{
  struct Mark
  {
    double Position; ///< on the scale, 0: low, 1: high; of a category: its colour's index
    std::string Text;
  };

  std::string Title;
  bool IsCategory = false;
  std::vector<Rgb> Colors; ///< from low to high, or of the categories; empty: no legend
  std::vector<Mark> Marks;
  std::vector<std::pair<Rgb, std::string>> Others; ///< colours beside the scale
};

class LegendPanel : public Panel
{
public:
  void SetLegend(const Legend& legend) { this->Content = legend; }
  const Legend& GetLegend() const { return this->Content; }

  PanelSize GetSize(int textSize) const override;
  void Paint(Painter& painter, const Rect& rect) const override;

private:
  void PaintScale(Painter& painter, const Rect& inside) const;
  void PaintCategories(Painter& painter, const Rect& inside) const;
  void PaintOthers(Painter& painter, Rect& inside) const;

  Legend Content;
};

} // namespace helios::viewer

#endif
