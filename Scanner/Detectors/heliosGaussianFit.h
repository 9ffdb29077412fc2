// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Least-squares fit of a sum of Gaussians.

#ifndef heliosGaussianFit_h
#define heliosGaussianFit_h

#include <memory>
#include <vector>

namespace helios
{

/// A exp(-(x - c)^2 / (2 s^2)).
struct GaussianComponent
{
  double Amplitude; ///< stays positive
  double Centre;    ///< stays within Reach of its start
  double Sigma;     ///< stays above SmallestSigma
  bool IsSigmaFixed = false;
};

/// Samples, their abscissae in units of the pulse's sigma, and their background.
struct GaussianData
{
  std::vector<double> X;
  std::vector<double> Y;
  bool HasBackground = false; ///< whether it is fitted, too
  double Background = 0.0;
};

/// One per thread: it owns the scratch memory.
class GaussianFit
{
public:
  /// The bounds of a component, in units of the pulse's sigma.
  static constexpr double Reach = 2.5;
  static constexpr double SmallestSigma = 0.5;

  GaussianFit();
  ~GaussianFit();

  /**
   * Improves components by the Levenberg-Marquardt method (Eigen's MINPACK), in at most n
   * evaluations of the model. False, without changes, if there are too few samples or it did not
   * converge.
   */
  bool Run(GaussianData& data, std::vector<GaussianComponent>& components, int maximumEvaluations);

private:
  struct Internals;
  std::unique_ptr<Internals> Solver;
};

/// Returns the model at x.
double EvaluateGaussians(
  const GaussianData& data, const std::vector<GaussianComponent>& components, double x);

/// Returns the sum of squares of samples minus model.
double SumSquares(const GaussianData& data, const std::vector<GaussianComponent>& components);

} // namespace helios

#endif
