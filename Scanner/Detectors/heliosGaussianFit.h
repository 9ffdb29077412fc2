// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Least squares of a sum of Gaussians.

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
  double Centre;    ///< stays within Reach of where it starts
  double Sigma;     ///< stays above SmallestSigma
  bool IsSigmaFixed = false;
};

/// Samples, their abscissae in units of the pulse's sigma, and their background.
struct GaussianData
{
  std::vector<double> X;
  std::vector<double> Y;
  bool HasBackground = false; ///< it is fitted, too
  double Background = 0.0;
};

/// One a thread: it owns the scratch memory.
class GaussianFit
{
public:
  /// The bounds of a component, in units of the pulse's sigma.
  static constexpr double Reach = 2.5;
  static constexpr double SmallestSigma = 0.5;

  GaussianFit();
  ~GaussianFit();

  /**
   * Improves components by Levenberg and Marquardt's method (Eigen's MINPACK), in no more than so many
   * evaluations of the model. False, and nothing changes: the samples are too few, or it did not
   * converge.
   */
  bool Run(GaussianData& data, std::vector<GaussianComponent>& components, int mostEvaluations);

private:
  struct Internals;
  std::unique_ptr<Internals> Solver;
};

/// The model at x.
double EvaluateGaussians(
  const GaussianData& data, const std::vector<GaussianComponent>& components, double x);

/// The sum of squares of samples minus model.
double SumSquares(const GaussianData& data, const std::vector<GaussianComponent>& components);

} // namespace helios

#endif
