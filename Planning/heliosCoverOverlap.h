// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scans that share enough points to be registered with each other, as a network.

#ifndef heliosCoverOverlap_h
#define heliosCoverOverlap_h

#include "heliosCoverProblem.h"

#include <memory>

namespace helios
{

/**
 * Two candidates are neighbours where the points both see are at least a share of the smaller
 * viewshed, by weight. Neighbours are found when asked for, and kept.
 */
class VTKHELIOSPLANNING_EXPORT OverlapNetwork
{
public:
  OverlapNetwork(const CoverProblem& problem, double share);

  double GetShare() const { return this->Share; }
  bool AreNeighbours(int a, int b) const;

  /// The neighbours of a candidate, as bits.
  const Words& GetNeighbours(int candidate);

  /// The parts of a choice that are connected within it.
  std::vector<Choice> GetParts(const Choice& choice) const;
  bool IsConnected(const Choice& choice) const { return this->GetParts(choice).size() <= 1; }

  /// The connected parts of all candidates that see anything.
  std::vector<Choice> GetAllParts(const StopTest& stop = {}) const;

  /**
   * Adds candidates until the choice is connected: the two parts with the shortest way between them
   * are joined first, by those on the way. False: there is no way.
   */
  bool Connect(Choice& choice, const StopTest& stop = {});

  /// Removes, in the order given, whoever neither covering nor connection needs.
  Choice RemoveNeedless(const Choice& order, const StopTest& stop = {}) const;

private:
  Choice FindWay(const std::vector<Choice>& parts, const StopTest& stop);

  const CoverProblem* Problem;
  double Share;
  std::vector<double> Sizes;
  std::vector<std::unique_ptr<Words>> Neighbours;
};

} // namespace helios

#endif
