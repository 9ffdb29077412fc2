// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The shortest round trip through places, with a lower bound of any.

#ifndef heliosTour_h
#define heliosTour_h

#include <vector>

namespace helios
{

/// Symmetric distances of places.
class DistanceTable
{
public:
  explicit DistanceTable(int size);

  int GetSize() const { return this->Size; }
  double Get(int a, int b) const { return this->Values[this->Find(a, b)]; }
  void Set(int a, int b, double distance);

private:
  std::size_t Find(int a, int b) const
  {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(this->Size) +
      static_cast<std::size_t>(b);
  }

  int Size;
  std::vector<double> Values;
};

struct Tour
{
  std::vector<int> Order; ///< begins with place 0
  double Length = 0.0;
  double Bound = 0.0; ///< no round trip is shorter
};

/// The largest number of places of SolveTour() that is solved exactly.
constexpr int ExactPlaces = 15;

/**
 * Returns the shortest round trip: exact for up to ExactPlaces by dynamic programming (Held and
 * Karp 1962, J. SIAM 10, 196-210). For more, the best of trips that go to the nearest place,
 * improved by reversing parts (2-opt) and moving up to three places (Or-opt) until neither helps,
 * with the 1-tree bound of Held and Karp (1971, Math. Programming 1, 6-25).
 */
Tour SolveTour(const DistanceTable& distances);

} // namespace helios

#endif
