// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGaussianFit.h"

#include <unsupported/Eigen/LevenbergMarquardt>

#include <cmath>

namespace helios
{
namespace
{

constexpr double Tolerance = 1e-10; // relative change of sum of squares and parameters

double Square(double x)
{
  return x * x;
}

/**
 * The residuals in the form of Eigen's solver. Unbounded parameters replace the bounded ones, all 0
 * at the start of the fit except the width: A = A0 exp(p), c = c0 + Reach tanh(p), s = smallest +
 * (1 - smallest) exp(p).
 */
struct GaussianResiduals
{
  using Scalar = double;
  enum
  {
    InputsAtCompileTime = Eigen::Dynamic,
    ValuesAtCompileTime = Eigen::Dynamic
  };
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  using QRSolver = Eigen::ColPivHouseholderQR<JacobianType>;

  const GaussianData* Data = nullptr;
  std::vector<GaussianComponent> Start;
  std::vector<GaussianComponent> Now;
  double Background = 0.0;

  int inputs() const
  {
    int count = this->Data->HasBackground ? 1 : 0;
    for (const GaussianComponent& g : this->Start)
    {
      count += g.IsSigmaFixed ? 2 : 3;
    }
    return count;
  }
  int values() const { return static_cast<int>(this->Data->X.size()); }

  void GetParameters(InputType& p) const
  {
    p.setZero(this->inputs());
    Eigen::Index k = 0;
    for (const GaussianComponent& g : this->Start)
    {
      k += 2;
      if (!g.IsSigmaFixed)
      {
        constexpr double minimum = GaussianFit::SmallestSigma;
        p[k++] = std::log((g.Sigma - minimum) / (1.0 - minimum));
      }
    }
    if (this->Data->HasBackground)
    {
      p[k] = this->Data->Background;
    }
  }

  void SetParameters(const InputType& p)
  {
    Eigen::Index k = 0;
    for (std::size_t i = 0; i < this->Start.size(); ++i)
    {
      const GaussianComponent& from = this->Start[i];
      GaussianComponent& g = this->Now[i];
      g.Amplitude = from.Amplitude * std::exp(p[k++]);
      g.Centre = from.Centre + GaussianFit::Reach * std::tanh(p[k++]);
      if (!g.IsSigmaFixed)
      {
        constexpr double minimum = GaussianFit::SmallestSigma;
        g.Sigma = minimum + (1.0 - minimum) * std::exp(p[k++]);
      }
    }
    this->Background = this->Data->HasBackground ? p[k] : this->Data->Background;
  }

  int operator()(const InputType& p, ValueType& residuals)
  {
    this->SetParameters(p);
    for (Eigen::Index i = 0; i < residuals.size(); ++i)
    {
      const auto sample = static_cast<std::size_t>(i);
      double sum = this->Background;
      for (const GaussianComponent& g : this->Now)
      {
        sum += g.Amplitude * std::exp(-0.5 * Square((this->Data->X[sample] - g.Centre) / g.Sigma));
      }
      residuals[i] = sum - this->Data->Y[sample];
    }
    return 0;
  }

  int df(const InputType& p, JacobianType& jacobian)
  {
    this->SetParameters(p);
    Eigen::Index k = 0;
    for (std::size_t j = 0; j < this->Now.size(); ++j)
    {
      const GaussianComponent& g = this->Now[j];
      const double towards = (g.Centre - this->Start[j].Centre) / GaussianFit::Reach;
      const double perCentre = GaussianFit::Reach * (1.0 - towards * towards);
      const double perSigma = g.Sigma - GaussianFit::SmallestSigma;
      for (Eigen::Index i = 0; i < jacobian.rows(); ++i)
      {
        const double u = (this->Data->X[static_cast<std::size_t>(i)] - g.Centre) / g.Sigma;
        const double value = g.Amplitude * std::exp(-0.5 * u * u);
        jacobian(i, k) = value;
        jacobian(i, k + 1) = value * u / g.Sigma * perCentre;
        if (!g.IsSigmaFixed)
        {
          jacobian(i, k + 2) = value * u * u / g.Sigma * perSigma;
        }
      }
      k += g.IsSigmaFixed ? 2 : 3;
    }
    if (this->Data->HasBackground)
    {
      jacobian.col(k).setOnes();
    }
    return 0;
  }
};

bool HasConverged(Eigen::LevenbergMarquardtSpace::Status status)
{
  using namespace Eigen::LevenbergMarquardtSpace;
  return status != ImproperInputParameters && status != TooManyFunctionEvaluation &&
    status != UserAsked && status != NotStarted && status != Running;
}

} // namespace

//------------------------------------------------------------------------------
struct GaussianFit::Internals
{
  GaussianResiduals Residuals;
  Eigen::LevenbergMarquardt<GaussianResiduals> Marquardt{ Residuals };
  Eigen::VectorXd Parameters;
};

//------------------------------------------------------------------------------
GaussianFit::GaussianFit()
  : Solver(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
GaussianFit::~GaussianFit() = default;

//------------------------------------------------------------------------------
bool GaussianFit::Run(
  GaussianData& data, std::vector<GaussianComponent>& components, int maximumEvaluations)
{
  GaussianResiduals& residuals = this->Solver->Residuals;
  residuals.Data = &data;
  residuals.Start = residuals.Now = components;
  if (residuals.values() < residuals.inputs())
  {
    return false;
  }
  auto& marquardt = this->Solver->Marquardt;
  marquardt.setFtol(Tolerance);
  marquardt.setXtol(Tolerance);
  marquardt.setMaxfev(maximumEvaluations);
  residuals.GetParameters(this->Solver->Parameters);
  const bool converged = HasConverged(marquardt.minimize(this->Solver->Parameters));
  if (!converged || !this->Solver->Parameters.allFinite())
  {
    return false;
  }
  residuals.SetParameters(this->Solver->Parameters);
  components = residuals.Now;
  data.Background = residuals.Background;
  return true;
}

//------------------------------------------------------------------------------
double EvaluateGaussians(
  const GaussianData& data, const std::vector<GaussianComponent>& components, double x)
{
  double sum = data.Background;
  for (const GaussianComponent& g : components)
  {
    sum += g.Amplitude * std::exp(-0.5 * Square((x - g.Centre) / g.Sigma));
  }
  return sum;
}

//------------------------------------------------------------------------------
double SumSquares(const GaussianData& data, const std::vector<GaussianComponent>& components)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < data.X.size(); ++i)
  {
    sum += Square(data.Y[i] - EvaluateGaussians(data, components, data.X[i]));
  }
  return sum;
}

} // namespace helios
