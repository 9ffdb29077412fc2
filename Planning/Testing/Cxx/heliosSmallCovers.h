// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Random covers small enough for enumeration.

#ifndef heliosSmallCovers_h
#define heliosSmallCovers_h

#include "heliosCoverProblem.h"

#include <algorithm>
#include <random>
#include <vector>

namespace helios
{

/// Up to 20 candidates.
class SmallCover
{
public:
  SmallCover(int candidates, int points, double density, unsigned int seed)
    : Rows(candidates, points)
  {
    std::mt19937 random(seed);
    for (int a = 0; a < candidates; ++a)
    {
      for (int v = 0; v < points; ++v)
      {
        if (random() % 1000 < 1000.0 * density)
        {
          this->Rows.Set(a, v);
        }
      }
    }
    for (int v = 0; v < points; ++v)
    {
      this->Areas.push_back(0.25 * static_cast<double>(1 + random() % 8));
    }
    this->Problem = CoverProblem(this->Rows.View());
  }

  void UseAreas() { this->Problem = CoverProblem(this->Rows.View(), this->Areas); }

  bool IsEnough(const Choice& choice) const
  {
    std::vector<char> isSeen(this->Rows.View().Columns);
    double weight = 0.0;
    for (int v = 0; v < this->Rows.View().Columns; ++v)
    {
      for (const int a : choice)
      {
        isSeen[v] = isSeen[v] || this->Rows.View().Has(a, v);
      }
      weight += isSeen[v] ? this->Problem.GetWeight(v) : 0.0;
    }
    return weight >= this->Problem.Required;
  }

  /// All choices with isGood(choice) and the minimum number of members.
  template <typename TestT>
  std::vector<Choice> TryAll(TestT isGood) const
  {
    std::vector<Choice> best;
    const int candidates = this->Rows.View().Rows;
    for (unsigned int set = 1; set < 1u << candidates; ++set)
    {
      Choice choice;
      for (int a = 0; a < candidates; ++a)
      {
        if (set >> a & 1u)
        {
          choice.push_back(a);
        }
      }
      if ((best.empty() || choice.size() <= best[0].size()) && isGood(choice))
      {
        if (!best.empty() && choice.size() < best[0].size())
        {
          best.clear();
        }
        best.push_back(choice);
      }
    }
    return best;
  }

  std::vector<Choice> GetOptima() const
  {
    return this->TryAll([this](const Choice& c) { return this->IsEnough(c); });
  }

  BitMatrix Rows;
  std::vector<double> Areas;
  CoverProblem Problem;
};

} // namespace helios

#endif
