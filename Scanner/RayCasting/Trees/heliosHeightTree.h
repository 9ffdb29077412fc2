// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A height field as a wide tree whose nodes and leaves are computed on demand.

#ifndef heliosHeightTree_h
#define heliosHeightTree_h

#include "heliosBeamNode.h"
#include "heliosHeightField.h"

#include <cstdint>
#include <vector>

namespace helios
{

/**
 * A tree whose nodes are the nodes of the pyramid, and whose leaves are its strips of two cells: up
 * to four triangles. A node has the number of its level, from the top, and its own in the level;
 * the root is 0. Triangles are slots of the field.
 */
class HeightTree
{
public:
  /// Boxes are in the frame of a BeamTree; the field must outlive it.
  HeightTree(const HeightField& field, const double centre[3], double scale);

  const HeightField& GetField() const { return this->Field; }

  void MakeNode(vtkTypeUInt32 number, BeamNode& node) const;
  void MakeLeaf(vtkTypeUInt32 number, BeamLeafData& leaf) const;
  void Prefetch(vtkTypeUInt32 number) const;

private:
  static constexpr int LevelShift = 27; ///< place of the level in a number
  static constexpr vtkTypeUInt32 InLevel = (1u << LevelShift) - 1;

  /// Rows of a row-major table, without a division.
  struct RowFinder
  {
    vtkTypeUInt32 Columns = 1;
    int Shift = 31;
    std::uint64_t Factor = std::uint64_t(1) << 31; ///< 2^Shift / Columns, rounded up

    void Set(std::int64_t columns);
    vtkTypeUInt32 GetRow(vtkTypeUInt32 i) const
    {
      return static_cast<vtkTypeUInt32>(i * this->Factor >> this->Shift);
    }
  };

  struct Level
  {
    const HeightPyramid::Extents* Extents = nullptr; ///< null: computed
    RowFinder Rows;
    double Origin[2];     ///< place of the first node, along x and y
    double ColumnStep[2]; ///< to the next node of a row
    double RowStep[2];
    float Low[2][BeamNode::Width]; ///< sides of the children, from the place of the node
    float High[2][BeamNode::Width];
    vtkTypeUInt32 ChildColumns; ///< children of a node in a row
    vtkTypeUInt32 ChildRows;
    vtkTypeUInt32 ChildrenPerRow;           ///< children in a row of the level below
    vtkTypeUInt32 Base;                     ///< smallest number of the children
    vtkTypeUInt32 Offsets[BeamNode::Width]; ///< numbers of the children relative to the first
  };

  void SetLevel(const HeightPyramid::Level& from, Level& level) const;
  void SetBoxes(const HeightPyramid::Level& from, Level& level) const;
  void SetChildren(std::size_t level);
  const HeightField& Field;
  double Centre[3];
  double Scale;
  std::vector<Level> Levels; ///< from the top
  RowFinder LeafRows;
};

} // namespace helios

#endif
