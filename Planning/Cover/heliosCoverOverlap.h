// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Connected networks of scans that share enough points for registration.

#ifndef heliosCoverOverlap_h
#define heliosCoverOverlap_h

#include "heliosCoverProblem.h"

#include <memory>

namespace helios
{

/**
 * Two candidates are neighbours if the points seen by both are at least a share of the smaller
 * viewshed, by weight. Neighbours are computed on demand and cached.
 */
class VTKHELIOSPLANNING_EXPORT OverlapNetwork
{
public:
  OverlapNetwork(const CoverProblem& problem, double share);

  bool AreNeighbours(int a, int b) const;

  /// Returns the neighbours of a candidate, as bits.
  const Words& GetNeighbours(int candidate);

  /// Returns the connected parts of a choice.
  std::vector<Choice> GetParts(const Choice& choice) const;
  bool IsConnected(const Choice& choice) const { return this->GetParts(choice).size() <= 1; }

  /// Returns the connected parts of all candidates that see any point.
  std::vector<Choice> GetAllParts(const StopTest& stop = {}) const;

  /**
   * Adds candidates until the choice is connected: joins the two parts with the shortest path
   * between them first, by the candidates on that path. False: no path exists.
   */
  bool Connect(Choice& choice, const StopTest& stop = {});

  /// Removes, in the order given, each member that neither coverage nor connectivity needs.
  Choice RemoveNeedless(const Choice& order, const StopTest& stop = {}) const;

private:
  Choice FindPath(const std::vector<Choice>& parts, const StopTest& stop);

  const CoverProblem* Problem;
  double Share;
  std::vector<double> Sizes;
  std::vector<std::unique_ptr<Words>> Neighbours;
};

} // namespace helios

#endif
