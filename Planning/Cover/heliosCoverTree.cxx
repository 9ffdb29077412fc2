// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverTree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace helios
{

CoverTree::CoverTree(const BitRows& rows, const BitRows& columns)
  : Rows(rows)
  , Columns(columns)
  , Order(columns.Rows)
  , Free(columns.Length)
  , Seen(columns.Length)
{
  for (int a = 0; a < rows.Rows; ++a)
  {
    this->Largest = std::max(this->Largest, rows.GetSize(a));
  }
  std::vector<int> sizes(columns.Rows);
  for (int v = 0; v < columns.Rows; ++v)
  {
    sizes[v] = columns.GetSize(v);
  }
  std::iota(this->Order.begin(), this->Order.end(), 0);
  std::stable_sort(
    this->Order.begin(), this->Order.end(), [&sizes](int v, int w) { return sizes[v] < sizes[w]; });
}

CoverAnswer CoverTree::Visit(
  int count, const Visitor& visitor, std::int64_t& work, const StopTest& stop)
{
  this->OnCover = visitor;
  this->Stop = stop;
  this->Work = &work;
  this->Chosen.clear();
  Words missing(this->Rows.Length);
  for (int v = 0; v < this->Rows.Columns; ++v)
  {
    SetBit(missing.data(), v);
  }
  const bool isThrough = count < 1 || this->Branch(count, missing, Words(this->Columns.Length));
  if (!this->IsOn())
  {
    return CoverAnswer::Unknown;
  }
  return isThrough ? CoverAnswer::None : CoverAnswer::Found;
}

/// Visits the covers of a branch. False: ended early, by the visitor or the work.
bool CoverTree::Branch(int left, const Words& missing, Words isOut)
{
  if (left == 1)
  {
    return this->Finish(missing, isOut);
  }
  const int rarest = this->FindRarest(left, missing, isOut);
  if (rarest < 0)
  {
    return true;
  }
  const Word* seers = this->Columns.Get(rarest);
  Choice turn;
  for (int w = 0; w < this->Columns.Length; ++w)
  {
    VisitWord(seers[w] & ~isOut[w], w, [&turn](int a) { turn.push_back(a); });
  }
  for (const int a : turn)
  {
    this->Chosen.push_back(a);
    const bool isOn = this->IsOn() && this->Follow(a, left - 1, missing, isOut);
    this->Chosen.pop_back();
    if (!isOn)
    {
      return false;
    }
    SetBit(isOut.data(), a);
  }
  return true;
}

/// Visits each candidate that sees all missing points as the last member.
bool CoverTree::Finish(const Words& missing, const Words& isOut)
{
  const int length = this->Columns.Length;
  Words all(length);
  for (int w = 0; w < length; ++w)
  {
    all[w] = ~isOut[w];
  }
  for (const int v : this->Order)
  {
    if (HasBit(missing.data(), v))
    {
      Word any = 0;
      for (int w = 0; w < length; ++w)
      {
        any |= all[w] &= this->Columns.Get(v)[w];
      }
      *this->Work -= length;
      if (!any)
      {
        return true;
      }
    }
  }
  bool isOn = true;
  VisitBits(all.data(), length,
    [this, &isOn](int a)
    {
      this->Chosen.push_back(a);
      isOn = isOn && this->OnCover(this->Chosen);
      this->Chosen.pop_back();
    });
  return isOn;
}

bool CoverTree::Follow(int candidate, int left, const Words& missing, const Words& isOut)
{
  const Word* row = this->Rows.Get(candidate);
  Words rest(missing);
  int size = 0;
  for (int w = 0; w < this->Rows.Length; ++w)
  {
    rest[w] &= ~row[w];
    size += __builtin_popcountll(rest[w]);
  }
  *this->Work -= 2 * this->Rows.Length + 8;
  if (size == 0)
  {
    return this->OnCover(this->Chosen);
  }
  return size > static_cast<std::int64_t>(left) * this->Largest || this->Branch(left, rest, isOut);
}

/// Finds the missing point that the fewest remaining candidates see; -1: the missing points cannot
/// be covered with the scans left.
int CoverTree::FindRarest(int left, const Words& missing, const Words& isOut)
{
  int rarest = -1;
  int minimum = std::numeric_limits<int>::max();
  int apart = 0;
  std::fill(this->Seen.begin(), this->Seen.end(), 0);
  for (const int v : this->Order)
  {
    if (!HasBit(missing.data(), v))
    {
      continue;
    }
    const Word* seers = this->Columns.Get(v);
    bool isApart = true;
    int count = 0;
    for (int w = 0; w < this->Columns.Length; ++w)
    {
      this->Free[w] = seers[w] & ~isOut[w];
      count += __builtin_popcountll(this->Free[w]);
      isApart = isApart && !(this->Free[w] & this->Seen[w]);
    }
    *this->Work -= 2 * this->Columns.Length;
    if (isApart)
    {
      ++apart;
      for (int w = 0; w < this->Columns.Length; ++w)
      {
        this->Seen[w] |= this->Free[w];
      }
    }
    if (count < minimum)
    {
      minimum = count;
      rarest = v;
    }
    if (count == 0 || apart > left)
    {
      return -1;
    }
  }
  return rarest;
}

} // namespace helios
