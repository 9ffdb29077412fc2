// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosFootprintRaster.h"

#include "heliosBeamNode.h" // For rounding to floats
#include "heliosRayVectors.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr vtkTypeUInt64 AllBits = ~vtkTypeUInt64(0);
constexpr std::size_t Terms = 8; ///< least number, of the polynomial

/// Columns of places, in the middle of which a column is whole.
struct Columns
{
  EightFloats Left, Right;
};

/// Computes both at once, because one step of a polynomial waits for the last.
HELIOS_INLINE Columns GetColumns(
  const std::vector<float>& warp, float scale, const EightFloats& left, const EightFloats& right)
{
  const EightFloats leftSquare = left * left;
  const EightFloats rightSquare = right * right;
  Columns sum{ EightFloats() + warp.back(), EightFloats() + warp.back() };
  std::size_t k = warp.size() - 1;
  for (; k > Terms - 1; --k)
  {
    sum.Left = sum.Left * leftSquare + warp[k - 1];
    sum.Right = sum.Right * rightSquare + warp[k - 1];
  }
#pragma GCC unroll 8
  for (std::size_t term = Terms - 1; term > 0; --term)
  {
    sum.Left = sum.Left * leftSquare + warp[term - 1];
    sum.Right = sum.Right * rightSquare + warp[term - 1];
  }
  const float shift = scale - 0.5F;
  return { scale * left * sum.Left + shift, scale * right * sum.Right + shift };
}

/// Rounds up numbers of at least -1.
HELIOS_INLINE EightMasks CeilLanes(const EightFloats& x)
{
  const EightMasks whole = __builtin_convertvector(x, EightMasks);
  return whole - (x > __builtin_convertvector(whole, EightFloats));
}

HELIOS_INLINE EightMasks Clamp(const EightMasks& x, int low, int high)
{
  const EightMasks above = x < low ? EightMasks() + low : x;
  return above > high ? EightMasks() + high : above;
}

HELIOS_INLINE int GetMinimum(const EightMasks& x)
{
  EightMasks y = __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3);
  EightMasks z = x < y ? x : y;
  y = __builtin_shufflevector(z, z, 2, 3, 0, 1, 6, 7, 4, 5);
  z = z < y ? z : y;
  return std::min(z[0], z[1]);
}

HELIOS_INLINE int Count(vtkTypeUInt64 bits)
{
  return __builtin_popcountll(bits);
}

} // namespace

//------------------------------------------------------------------------------
void FootprintRaster::SetGrid(const BeamEnergy& beam, int across)
{
  const bool isSame = this->Exponent == beam.GetExponent();
  if (isSame && this->Across == across)
  {
    return;
  }
  if (!isSame)
  {
    this->SetWarp(beam.GetExponent());
  }
  this->Across = across;
  this->AllSpans.resize(static_cast<std::size_t>(across / Side));
  this->Places.resize(static_cast<std::size_t>(across));
  for (int i = 0; i < across; ++i)
  {
    this->Places[static_cast<std::size_t>(i)] = static_cast<float>(this->GetPlace(i));
  }
  this->SetTiles(beam);
}

//------------------------------------------------------------------------------
/// Sets the polynomial, which is exact at Chebyshev's nodes of x^2, by Newton's form.
void FootprintRaster::SetWarp(double exponent)
{
  this->Exponent = exponent;
  const auto count = static_cast<std::size_t>(4.0 + std::ceil(0.5 * exponent));
  const double root = std::sqrt(exponent);
  std::vector<double> nodes, differences;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double node =
      0.5 - 0.5 * std::cos(vtkMath::Pi() * (static_cast<double>(i) + 0.5) / count);
    nodes.push_back(node);
    const double x = std::sqrt(node);
    differences.push_back(std::erf(root * x) / (x * std::erf(root)));
  }
  for (std::size_t order = 1; order < count; ++order)
  {
    for (std::size_t i = count - 1; i >= order; --i)
    {
      differences[i] = (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - order]);
    }
  }
  std::vector<double> powers(count, 0.0);
  for (std::size_t i = count; i-- > 0;) // powers = powers * (t - node) + difference
  {
    for (std::size_t k = count - 1; k > 0; --k)
    {
      powers[k] = powers[k - 1] - nodes[i] * powers[k];
    }
    powers[0] = differences[i] - nodes[i] * powers[0];
  }
  this->Warp.assign(powers.begin(), powers.end());
  this->Warp.resize(std::max(this->Warp.size(), Terms), 0.0F);
}

//------------------------------------------------------------------------------
/// Returns the place of a column or row.
double FootprintRaster::GetPlace(double column) const
{
  const double target = (2.0 * column + 1.0) / this->Across - 1.0;
  const double root = std::sqrt(this->Exponent);
  double low = -1.0;
  double high = 1.0;
  for (int i = 0; i < 50; ++i)
  {
    const double middle = 0.5 * (low + high);
    (std::erf(root * middle) < target * std::erf(root) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

//------------------------------------------------------------------------------
/// Returns the row of tiles that a place is in, or one before it by steps of places.
int FootprintRaster::GetTileRow(float place, int after) const
{
  const float step = 0.5F * static_cast<float>(this->TileRows.size() - 2) * (1.0F + place);
  const int index =
    static_cast<int>(std::clamp(step, 0.0F, static_cast<float>(this->TileRows.size() - 2)));
  return this->TileRows[static_cast<std::size_t>(index + after)];
}

//------------------------------------------------------------------------------
void FootprintRaster::SetTiles(const BeamEnergy& beam)
{
  const int across = this->Across / Side;
  this->Sides.clear();
  this->EmptyTiles.clear();
  this->Weights.clear();
  for (int t = 0; t < across; ++t)
  {
    const float* x = &this->Places[static_cast<std::size_t>(Side * t)];
    double mean = 0.0, slope = 0.0, square = 0.0;
    for (int i = 0; i < Side; ++i)
    {
      mean += x[i] / 8.0;
      slope += x[i] * (i - 3.5) / 42.0; // the sum of (i - 3.5)^2
      square += x[i] * x[i] / 8.0;
    }
    const double variance = std::max(0.0, square - mean * mean);
    this->Sides.push_back(
      { static_cast<float>(mean), static_cast<float>(slope), static_cast<float>(variance) });
  }
  constexpr int steps = 128;
  this->TileRows.clear();
  for (int i = 0, row = 0; i <= steps + 1; ++i)
  {
    const float place = 2.0F * static_cast<float>(i) / steps - 1.0F;
    while (row + 1 < across && this->Places[static_cast<std::size_t>(Side * row + 7)] < place)
    {
      ++row;
    }
    this->TileRows.push_back(row);
  }
  double total = 0.0;
  for (int row = 0; row < across; ++row)
  {
    for (int column = 0; column < across; ++column)
    {
      vtkTypeUInt64 inside = 0;
      for (int bit = 0; bit < Side * Side; ++bit)
      {
        const double x = this->Places[static_cast<std::size_t>(Side * column + bit % Side)];
        const double y = this->Places[static_cast<std::size_t>(Side * row + bit / Side)];
        inside |= vtkTypeUInt64(x * x + y * y < 1.0) << bit;
      }
      const double x = this->Sides[static_cast<std::size_t>(column)].Mean;
      const double y = this->Sides[static_cast<std::size_t>(row)].Mean;
      const double weight = beam.GetIntensity(x, y) / std::exp(-this->Exponent * (x * x + y * y));
      this->EmptyTiles.push_back({ ~inside, HUGE_VALF, -1 });
      this->Weights.push_back(weight);
      total += weight * Count(inside);
    }
  }
  for (double& weight : this->Weights)
  {
    weight /= total;
  }
}

//------------------------------------------------------------------------------
void FootprintRaster::Draw(const FootprintFaces& faces, const BeamEnergy& beam, int across,
  const Targets& targets, std::vector<EnergyMoments>& sums)
{
  this->SetGrid(beam, across);
  this->Tiles = this->EmptyTiles;
  this->DrawFaces(faces);
  this->AddSpots(targets, sums);
}

//------------------------------------------------------------------------------
HELIOS_INLINE void FootprintRaster::SetSpans(
  const FootprintFaces::Face& face, const FootprintFaces::Line* lines, int row, Spans& spans) const
{
  const EightFloats y = Load<EightFloats>(&this->Places[static_cast<std::size_t>(Side * row)]);
  EightFloats left = EightFloats() - 1.0F;
  EightFloats right = EightFloats() + 1.0F;
  for (const FootprintFaces::Line* end = lines + face.Left; lines != end; ++lines)
  {
    const FootprintFaces::Line& line = *lines;
    const EightFloats x = line.X + line.Slope * (y - line.Y);
    left = x > left ? x : left;
  }
  for (const FootprintFaces::Line* end = lines + face.Right; lines != end; ++lines)
  {
    const FootprintFaces::Line& line = *lines;
    const EightFloats x = line.X + line.Slope * (y - line.Y);
    right = x < right ? x : right;
  }
  const EightMasks isIn = (y >= face.Low) & (y < face.High) & (left < right);
  left = left < 1.0F ? left : EightFloats() + 1.0F;
  right = right > -1.0F ? right : EightFloats() - 1.0F;
  const Columns columns =
    GetColumns(this->Warp, 0.5F * static_cast<float>(this->Across), left, right);
  const EightMasks first = CeilLanes(columns.Left);
  const EightMasks last = CeilLanes(columns.Right);
  const EightMasks firstIn = isIn ? first : EightMasks() + this->Across;
  const EightMasks lastIn = isIn ? last : EightMasks();
  Store(spans.First, firstIn);
  Store(spans.Last, lastIn);
  spans.FirstOfAny = GetMinimum(firstIn);
  spans.LastOfAny = -GetMinimum(-lastIn);
  spans.FirstOfAll = -GetMinimum(-firstIn);
  spans.LastOfAll = GetMinimum(lastIn);
}

//------------------------------------------------------------------------------
HELIOS_CLONES
void FootprintRaster::DrawFaces(const FootprintFaces& faces)
{
  const int across = this->Across / Side;
  this->FirstFragments.clear();
  std::size_t count = 0;
  for (std::size_t index = 0; index < faces.GetNumberOfFaces(); ++index)
  {
    const FootprintFaces::Face& face = faces.GetFace(index);
    const float nearest = RoundUp(face.Maximum);
    const float farthest = RoundDown(face.Minimum);
    const FootprintFaces::Line* lines = faces.GetLines(face);
    const int bottom = this->GetTileRow(face.Low, 0);
    const int top = this->GetTileRow(face.High, 1);
    this->FirstFragments.push_back(count);
    for (int row = bottom; row <= top; ++row) // first all, because one waits for nothing of another
    {
      this->SetSpans(face, lines, row, this->AllSpans[static_cast<std::size_t>(row)]);
    }
    for (int row = bottom; row <= top; ++row)
    {
      const Spans& spans = this->AllSpans[static_cast<std::size_t>(row)];
      const std::size_t most = count + static_cast<std::size_t>(across);
      if (most > this->Fragments.size())
      {
        this->Fragments.resize(2 * most);
      }
      Tile* tiles = this->Tiles.data();
      Fragment* fragments = this->Fragments.data();
      for (int column = spans.FirstOfAny / Side; Side * column < spans.LastOfAny; ++column)
      {
        const auto place = static_cast<std::size_t>(row * across + column);
        Tile& tile = tiles[place];
        const bool mayBeNearer = nearest > tile.Minimum;
        if (tile.Covered == AllBits && !mayBeNearer)
        {
          continue;
        }
        const int start = Side * column;
        vtkTypeUInt64 bits = AllBits;
        if (spans.FirstOfAll > start || spans.LastOfAll < start + Side)
        {
          const EightMasks full = EightMasks() + 255;
          const EightMasks first = Load<EightMasks>(spans.First) - start;
          const EightMasks last = Load<EightMasks>(spans.Last) - start;
          bits = GetBytes(full << Clamp(first, 0, Side)) & ~GetBytes(full << Clamp(last, 0, Side));
        }
        vtkTypeUInt64 visible = bits & ~tile.Covered;
        if (mayBeNearer && visible != bits)
        {
          visible |= this->Uncover(faces, static_cast<int>(index), place, bits & tile.Covered);
        }
        if (visible != 0)
        {
          fragments[count] = { visible, tile.Last, static_cast<vtkTypeUInt16>(place),
            static_cast<vtkTypeUInt16>(index) };
          tile = { tile.Covered | visible, std::min(tile.Minimum, farthest),
            static_cast<int>(count) };
          ++count;
        }
      }
    }
  }
  this->FirstFragments.push_back(count);
}

//------------------------------------------------------------------------------
/// Removes those of some bits of a tile where a face is nearer than the face that has them; returns
/// them.
vtkTypeUInt64 FootprintRaster::Uncover(
  const FootprintFaces& faces, int face, std::size_t tile, vtkTypeUInt64 bits)
{
  const FootprintFaces::Face& f = faces.GetFace(static_cast<std::size_t>(face));
  vtkTypeUInt64 all = 0;
  for (int k = this->Tiles[tile].Last; k >= 0;
       k = this->Fragments[static_cast<std::size_t>(k)].Before)
  {
    Fragment& fragment = this->Fragments[static_cast<std::size_t>(k)];
    const FootprintFaces::Face& other = faces.GetFace(static_cast<std::size_t>(fragment.Face));
    vtkTypeUInt64 nearer = bits & fragment.Bits;
    if (nearer == 0 || !(f.Maximum > other.Minimum))
    {
      continue;
    }
    const InverseDepth difference = { f.Inverse.X - other.Inverse.X, f.Inverse.Y - other.Inverse.Y,
      f.Inverse.One - other.Inverse.One };
    const bool isSame = difference.X == 0.0 && difference.Y == 0.0 && difference.One == 0.0;
    nearer &= isSame ? (f.Cell < other.Cell ? AllBits : 0) : this->GetNearer(difference, tile);
    fragment.Bits &= ~nearer;
    all |= nearer;
  }
  return all;
}

//------------------------------------------------------------------------------
/// Returns the cells of a tile where a difference of inverse depths is positive.
HELIOS_CLONES
vtkTypeUInt64 FootprintRaster::GetNearer(const InverseDepth& difference, std::size_t tile) const
{
  const std::size_t across = static_cast<std::size_t>(this->Across / Side);
  const float* xs = &this->Places[Side * (tile % across)];
  const EightFloats y = Load<EightFloats>(&this->Places[Side * (tile / across)]);
  const EightFloats row = static_cast<float>(difference.One) + static_cast<float>(difference.Y) * y;
  const auto slope = static_cast<float>(difference.X);
  EightMasks bits = {};
  for (int column = 0; column < Side; ++column)
  {
    const EightMasks isNearer = row + slope * xs[column] > 0.0F;
    bits |= isNearer & (1 << column);
  }
  return GetBytes(bits);
}

//------------------------------------------------------------------------------
/// Calls use(spot) for what is visible of a face in each tile.
template <typename UseT>
HELIOS_INLINE void FootprintRaster::ForEachSpot(std::size_t face, UseT use) const
{
  const std::size_t across = static_cast<std::size_t>(this->Across / Side);
  const std::size_t last = this->FirstFragments[face + 1];
  for (std::size_t i = this->FirstFragments[face]; i < last; ++i)
  {
    const Fragment& fragment = this->Fragments[i];
    const vtkTypeUInt64 bits = fragment.Bits;
    if (bits == 0)
    {
      continue;
    }
    const TileSide& h = this->Sides[fragment.Tile % across];
    const TileSide& v = this->Sides[fragment.Tile / across];
    Spot spot{ static_cast<int>(face), this->Weights[fragment.Tile] * (Side * Side), h.Mean, v.Mean,
      h.Variance, v.Variance };
    if (bits != AllBits)
    {
      // The mean indices of columns and rows in the tile, by the digits of these.
      const int count = Count(bits);
      const int columns = Count(bits & 0xaaaaaaaaaaaaaaaau) +
        2 * Count(bits & 0xccccccccccccccccu) + 4 * Count(bits & 0xf0f0f0f0f0f0f0f0u);
      const int rows = Count(bits & 0xff00ff00ff00ff00u) + 2 * Count(bits & 0xffff0000ffff0000u) +
        4 * Count(bits & 0xffffffff00000000u);
      const float each = 1.0F / static_cast<float>(count);
      spot.Energy = this->Weights[fragment.Tile] * count;
      spot.X += h.Step * (static_cast<float>(columns) * each - 3.5F);
      spot.Y += v.Step * (static_cast<float>(rows) * each - 3.5F);
    }
    use(spot);
  }
}

//------------------------------------------------------------------------------
HELIOS_CLONES
void FootprintRaster::AddSpots(const Targets& targets, std::vector<EnergyMoments>& sums)
{
  this->Spots.clear();
  for (std::size_t face = 0; face < targets.size(); ++face)
  {
    if (targets[face] < 0)
    {
      this->ForEachSpot(face, [this](const Spot& spot) { this->Spots.push_back(spot); });
      continue;
    }
    EnergyMoments sum;
    this->ForEachSpot(face, [&sum](const Spot& spot) { spot.AddTo(sum); });
    sums[static_cast<std::size_t>(targets[face])] = sum;
  }
}

} // namespace helios
