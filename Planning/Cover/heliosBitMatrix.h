// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Sets as rows of bits, 64 per word: the data structure of the scan position selection.

#ifndef heliosBitMatrix_h
#define heliosBitMatrix_h

#include "vtkHeliosPlanningModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <vector>

namespace helios
{

using Word = std::uint64_t;
using Words = std::vector<Word>;

inline int GetWordCount(int bits)
{
  return (bits + 63) / 64;
}

inline bool HasBit(const Word* set, int i)
{
  return set[i / 64] >> (i % 64) & 1u;
}

inline void SetBit(Word* set, int i)
{
  set[i / 64] |= Word(1) << (i % 64);
}

inline void ClearBit(Word* set, int i)
{
  set[i / 64] &= ~(Word(1) << (i % 64));
}

inline int CountBits(const Word* set, int length)
{
  int count = 0;
  for (int w = 0; w < length; ++w)
  {
    count += __builtin_popcountll(set[w]);
  }
  return count;
}

inline bool HasCommon(const Word* a, const Word* b, int length)
{
  for (int w = 0; w < length; ++w)
  {
    if (a[w] & b[w])
    {
      return true;
    }
  }
  return false;
}

inline bool IsSubset(const Word* a, const Word* ofB, int length)
{
  for (int w = 0; w < length; ++w)
  {
    if (a[w] & ~ofB[w])
    {
      return false;
    }
  }
  return true;
}

/// Calls visit(i) for the bits of one word of a set, in ascending order.
template <typename VisitT>
void VisitWord(Word word, int w, VisitT visit)
{
  for (; word != 0; word &= word - 1)
  {
    visit(64 * w + __builtin_ctzll(word));
  }
}

/// Calls visit(i) for every member of a set, in ascending order.
template <typename VisitT>
void VisitBits(const Word* set, int length, VisitT visit)
{
  for (int w = 0; w < length; ++w)
  {
    VisitWord(set[w], w, visit);
  }
}

/// A view of rows of bits; the bits after the last column are zero.
struct BitRows
{
  const Word* Data = nullptr;
  int Rows = 0;
  int Columns = 0;
  int Length = 0; // words per row

  const Word* Get(int row) const
  {
    return this->Data + static_cast<std::size_t>(row) * this->Length;
  }
  bool Has(int row, int column) const { return HasBit(this->Get(row), column); }
  int GetSize(int row) const { return CountBits(this->Get(row), this->Length); }
  std::int64_t GetSize() const; // bits of all rows
};

/// Rows of bits.
class VTKHELIOSPLANNING_EXPORT BitMatrix
{
public:
  BitMatrix() = default;
  BitMatrix(int rows, int columns);

  void Set(int row, int column) { SetBit(this->Get(row), column); }
  Word* Get(int row) { return this->Data.data() + static_cast<std::size_t>(row) * this->Length; }
  BitRows View() const { return { this->Data.data(), this->Rows, this->Columns, this->Length }; }

private:
  Words Data;
  int Rows = 0;
  int Columns = 0;
  int Length = 0;
};

/// Returns the columns as rows.
VTKHELIOSPLANNING_EXPORT BitMatrix Transpose(const BitRows& matrix);

/// Returns the given rows, in the order given.
VTKHELIOSPLANNING_EXPORT BitMatrix SelectRows(const BitRows& matrix, const std::vector<int>& rows);

} // namespace helios

#endif
