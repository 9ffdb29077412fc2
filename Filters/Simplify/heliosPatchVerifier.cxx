// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPatchVerifier.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <chrono>
#include <numeric>

namespace helios
{

namespace
{

/// Triangles measured between two stop checks: as many as take about 0.05 s.
class Portion
{
public:
  vtkIdType Get() const { return this->Size; }

  template <typename WorkT>
  void Run(WorkT&& work)
  {
    const auto start = std::chrono::steady_clock::now();
    work();
    const bool isShort = std::chrono::steady_clock::now() - start < std::chrono::milliseconds(50);
    this->Size = std::clamp<vtkIdType>(isShort ? 2 * this->Size : this->Size / 2, 64, 65536);
  }

private:
  vtkIdType Size = 1024;
};

std::vector<Triangle> GetTriangles(const Patch& patch)
{
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < patch.Corners.size(); i += 3)
  {
    const vtkTypeInt32* c = &patch.Corners[i];
    triangles.push_back({ patch.Points[c[0]], patch.Points[c[1]], patch.Points[c[2]] });
  }
  return triangles;
}

bool IsSame(const Triangle& a, const Triangle& b)
{
  return std::is_permutation(a.begin(), a.end(), b.begin());
}

} // namespace

PatchVerifier::PatchVerifier(const Patch& patch, double limit, StopCheck& check)
  : Source(patch)
  , Limit(limit)
  , Stop(check)
  , Before(GetTriangles(patch))
  , Surface(this->Before, check)
  , After(this->Before)
  , Places(this->Before.size())
  , IsNew(this->Before.size())
  , There(this->Before.size())
  , Back(this->Before.size())
{
  // Before any removal, each triangle is at distance 0 from itself.
  std::iota(this->Places.begin(), this->Places.end(), 0);
  for (std::size_t i = 0; i < this->Before.size(); ++i)
  {
    this->There[i].Use(static_cast<vtkIdType>(i));
  }
}

double PatchVerifier::GetDistance() const
{
  double distance = 0.0;
  for (std::size_t i = 0; i < this->Before.size(); ++i)
  {
    distance = std::max(distance, this->There[i].Bound);
    distance = this->Places[i] >= 0 ? std::max(distance, this->Back[i].Bound) : distance;
  }
  return distance;
}

bool PatchVerifier::Verify(const DecimatedPatch& mesh)
{
  const std::vector<vtkIdType> last = this->Places;
  std::fill(this->Places.begin(), this->Places.end(), -1);
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    const auto triangle = static_cast<std::size_t>(mesh.Triangles[i]);
    const vtkTypeInt32* c = &mesh.Corners[3 * i];
    const auto& points = this->Source.Points;
    const Triangle now = { points[c[0]], points[c[1]], points[c[2]] };
    this->Places[triangle] = static_cast<vtkIdType>(i);
    this->IsNew[triangle] = last[triangle] < 0 || !IsSame(now, this->After[triangle]);
    this->After[triangle] = now;
  }
  for (std::size_t i = 0; i < last.size(); ++i)
  {
    this->IsNew[i] = this->Places[i] < 0 || this->IsNew[i];
  }
  this->Bad.clear();
  this->CheckThere(mesh);
  this->CheckBack();
  return this->Bad.empty();
}

/// Returns whether a bound is invalid: it exceeded the limit, or triangles it came from no longer
/// exist.
bool PatchVerifier::NeedsCheck(const Result& result) const
{
  return result.Worst >= 0 || result.NumberOfUsed > Result::MaximumUsed ||
    std::any_of(result.Used.begin(), result.Used.begin() + result.NumberOfUsed,
      [this](vtkIdType triangle) { return this->IsNew[static_cast<std::size_t>(triangle)] != 0; });
}

void PatchVerifier::Check(const std::vector<vtkIdType>& which, const std::vector<Triangle>& from,
  const SurfaceDistance& to, const std::vector<vtkIdType>& hints, std::vector<Result>& results)
{
  const auto measure = [&](vtkIdType begin, vtkIdType end)
  {
    for (; begin < end; ++begin)
    {
      const auto triangle = static_cast<std::size_t>(which[static_cast<std::size_t>(begin)]);
      results[triangle] =
        to.Measure(from[triangle], this->Limit, this->Limit / 8.0, hints[triangle]);
    }
  };
  const auto count = static_cast<vtkIdType>(which.size());
  Portion portion;
  for (vtkIdType begin = 0; begin < count;)
  {
    this->Stop.Poll();
    const vtkIdType end = std::min(count, begin + portion.Get());
    portion.Run([&]() { vtkSMPTools::For(begin, end, measure); });
    begin = end;
  }
}

/// Checks the distances from the patch to the decimation.
void PatchVerifier::CheckThere(const DecimatedPatch& mesh)
{
  std::vector<Triangle> surface;
  for (const vtkIdType triangle : mesh.Triangles)
  {
    surface.push_back(this->After[static_cast<std::size_t>(triangle)]);
  }
  std::vector<vtkIdType> which;
  std::vector<vtkIdType> hints(this->Before.size(), 0);
  vtkIdType hint = 0;
  for (std::size_t i = 0; i < this->Before.size(); ++i)
  {
    hint = this->Places[i] >= 0 ? this->Places[i] : hint;
    hints[i] = hint;
    if (this->NeedsCheck(this->There[i]))
    {
      which.push_back(static_cast<vtkIdType>(i));
    }
  }
  this->Check(
    which, this->Before, SurfaceDistance(std::move(surface), this->Stop), hints, this->There);
  for (const vtkIdType triangle : which)
  {
    Result& result = this->There[static_cast<std::size_t>(triangle)];
    for (int i = 0; i < std::min(result.NumberOfUsed, Result::MaximumUsed); ++i)
    {
      result.Used[i] = mesh.Triangles[static_cast<std::size_t>(result.Used[i])];
    }
    if (result.Worst >= 0)
    {
      this->Bad.push_back(triangle);
    }
  }
}

/// Checks the distances from the decimation to the patch, which does not change.
void PatchVerifier::CheckBack()
{
  std::vector<vtkIdType> which;
  std::vector<vtkIdType> hints(this->Before.size());
  std::iota(hints.begin(), hints.end(), 0);
  for (std::size_t i = 0; i < this->After.size(); ++i)
  {
    if (this->Places[i] >= 0 && (this->IsNew[i] || this->Back[i].Worst >= 0))
    {
      which.push_back(static_cast<vtkIdType>(i));
    }
  }
  this->Check(which, this->After, this->Surface, hints, this->Back);
  for (const vtkIdType triangle : which)
  {
    const Result& result = this->Back[static_cast<std::size_t>(triangle)];
    if (result.Worst >= 0)
    {
      this->Bad.push_back(result.Worst);
    }
  }
}

} // namespace helios
