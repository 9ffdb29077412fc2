// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverBound.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// Steps without a better bound before the step length is reduced, and their maximum number.
constexpr int Patience = 30;
constexpr int MaximumSteps = 1000;

/// Share of the last direction kept in the next: without it steps oscillate.
constexpr double Inertia = 0.95;

/// Tolerance for rounding in a bound.
constexpr double Rounding = 1e-9;

class Lagrange
{
public:
  explicit Lagrange(const CoverProblem& problem)
    : Problem(problem)
    , Prices(problem.Rows.Columns)
    , Best(problem.Rows.Columns)
    , Slope(problem.Rows.Columns)
    , Way(problem.Rows.Columns)
  {
    for (int a = 0; a < problem.Rows.Rows; ++a)
    {
      const int size = problem.Rows.GetSize(a);
      VisitBits(problem.Rows.Get(a), problem.Rows.Length,
        [&](int v)
        {
          const double price = 1.0 / size;
          this->Prices[v] = this->Prices[v] == 0.0 ? price : std::min(this->Prices[v], price);
        });
      this->Bits += size;
    }
    this->Best = this->Prices;
  }

  double Climb(int upper, std::int64_t work, const StopTest& stop)
  {
    double bound = this->Evaluate();
    double length = 1.0;
    int idle = 0;
    for (int step = 0; step < MaximumSteps && work > 0 && !(stop && stop()); ++step)
    {
      if (std::ceil(bound - Rounding) >= upper || !this->Move(length, upper))
      {
        break;
      }
      const double now = this->Evaluate();
      work -= 2 * this->Bits;
      idle = now > bound ? 0 : idle + 1;
      if (now > bound)
      {
        bound = now;
        this->Best = this->Prices;
      }
      else if (idle == Patience)
      {
        idle = 0;
        length /= 2.0;
        this->Prices = this->Best;
        this->Evaluate();
      }
    }
    return std::max(0.0, bound - Rounding);
  }

private:
  /// Computes L(u), and its subgradient.
  double Evaluate()
  {
    double bound = this->SeeEnough();
    for (int a = 0; a < this->Problem.Rows.Rows; ++a)
    {
      const Word* row = this->Problem.Rows.Get(a);
      double reduced = 1.0;
      VisitBits(row, this->Problem.Rows.Length, [&](int v) { reduced -= this->Prices[v]; });
      if (reduced < 0.0)
      {
        bound += reduced;
        VisitBits(row, this->Problem.Rows.Length, [&](int v) { this->Slope[v] -= 1.0; });
      }
    }
    this->Value = bound;
    return bound;
  }

  /// Returns the second term; its z enters the subgradient.
  double SeeEnough()
  {
    std::fill(this->Slope.begin(), this->Slope.end(), 0.0);
    this->Order.clear();
    VisitBits(this->Problem.Coverable.data(), this->Problem.Rows.Length,
      [this](int v) { this->Order.push_back(v); });
    if (this->Problem.IsFull)
    {
      double all = 0.0;
      for (const int v : this->Order)
      {
        this->Slope[v] = 1.0;
        all += this->Prices[v];
      }
      return all;
    }
    std::sort(this->Order.begin(), this->Order.end(),
      [this](int v, int w)
      {
        return this->Prices[v] * this->Problem.GetWeight(w) <
          this->Prices[w] * this->Problem.GetWeight(v);
      });
    double missing = this->Problem.Required;
    double sum = 0.0;
    for (const int v : this->Order)
    {
      const double weight = this->Problem.GetWeight(v);
      const double share = weight > missing ? missing / weight : 1.0;
      this->Slope[v] = share;
      sum += share * this->Prices[v];
      missing -= weight;
      if (missing <= 0.0)
      {
        break;
      }
    }
    return sum;
  }

  /// Makes a step along the subgradient; false: it is zero.
  bool Move(double length, int upper)
  {
    double square = 0.0;
    bool isTop = true;
    for (std::size_t v = 0; v < this->Prices.size(); ++v)
    {
      const bool isStuck = this->Prices[v] == 0.0 && this->Slope[v] < 0.0;
      const double slope = isStuck ? 0.0 : this->Slope[v];
      isTop = isTop && slope == 0.0;
      this->Way[v] = Inertia * this->Way[v] + (1.0 - Inertia) * slope;
      square += this->Way[v] * this->Way[v];
    }
    if (isTop || square == 0.0)
    {
      return false;
    }
    const double step = length * std::max(0.01 * upper, upper - this->Value) / square;
    for (std::size_t v = 0; v < this->Prices.size(); ++v)
    {
      // The optimal prices are at most 1, the cost of a scan.
      this->Prices[v] = std::clamp(this->Prices[v] + step * this->Way[v], 0.0, 1.0);
    }
    return true;
  }

  const CoverProblem& Problem;
  std::vector<double> Prices;
  std::vector<double> Best;
  std::vector<double> Slope;
  std::vector<double> Way; // direction of the steps: subgradients with decaying weights
  std::vector<int> Order;
  std::int64_t Bits = 0;
  double Value = 0.0;
};

} // namespace

double GetLagrangeBound(
  const CoverProblem& problem, int upper, std::int64_t work, const StopTest& stop)
{
  return Lagrange(problem).Climb(upper, work, stop);
}

} // namespace helios
