// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBitMatrix.h"

#include <algorithm>
#include <array>

namespace helios
{

namespace
{

/// Transposes 64 words of 64 bits in place by swapping successively smaller squares.
void TransposeBlock(std::array<Word, 64>& block)
{
  Word mask = 0x00000000FFFFFFFFu;
  for (int half = 32; half != 0; half /= 2, mask ^= mask << half)
  {
    for (int k = 0; k < 64; k = ((k | half) + 1) & ~half)
    {
      const Word swap = ((block[k] >> half) ^ block[k | half]) & mask;
      block[k | half] ^= swap;
      block[k] ^= swap << half;
    }
  }
}

} // namespace

std::int64_t BitRows::GetSize() const
{
  std::int64_t bits = 0;
  for (int r = 0; r < this->Rows; ++r)
  {
    bits += this->GetSize(r);
  }
  return bits;
}

BitMatrix::BitMatrix(int rows, int columns)
  : Data(static_cast<std::size_t>(rows) * GetWordCount(columns))
  , Rows(rows)
  , Columns(columns)
  , Length(GetWordCount(columns))
{
}

BitMatrix Transpose(const BitRows& matrix)
{
  BitMatrix result(matrix.Columns, matrix.Rows);
  for (int top = 0; top < matrix.Rows; top += 64)
  {
    const int height = std::min(64, matrix.Rows - top);
    for (int w = 0; w < matrix.Length; ++w)
    {
      std::array<Word, 64> block = {};
      for (int r = 0; r < height; ++r)
      {
        block[r] = matrix.Get(top + r)[w];
      }
      TransposeBlock(block);
      const int width = std::min(64, matrix.Columns - 64 * w);
      for (int c = 0; c < width; ++c)
      {
        result.Get(64 * w + c)[top / 64] = block[c];
      }
    }
  }
  return result;
}

BitMatrix SelectRows(const BitRows& matrix, const std::vector<int>& rows)
{
  BitMatrix result(static_cast<int>(rows.size()), matrix.Columns);
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    std::copy_n(matrix.Get(rows[r]), matrix.Length, result.Get(static_cast<int>(r)));
  }
  return result;
}

} // namespace helios
