// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The returns of a beam to a tolerance: few sub-rays where a surface is smooth, many along its edges.

#ifndef heliosBeamTracer_h
#define heliosBeamTracer_h

#include "heliosScanRecords.h"
#include "heliosSurfaceResponse.h"

#include <vector>

namespace helios
{

/// A sub-ray as it was cast: a unit vector in the world, and its share of the energy.
struct CastSubRay
{
  Vec3 Direction;
  double Weight;
};

/**
 * Gauss-Legendre rings of sub-rays look at the beam: where neighbours among them meet one surface they
 * are its returns. Else the cross-section is parted into cells (heliosBeamLattice.h), with a sub-ray at
 * every corner. A cell whose corners meet one plane returns from its own points, which are put onto the
 * plane without casting a ray; one on a bent surface returns from its corners, a quarter of its energy
 * each. A cell that holds an edge is parted into four, as often as the plan says, and at last returns
 * from its corners, too. One a thread.
 */
class BeamTracer
{
public:
  BeamTracer(const ScanModel& model, SurfaceResponse& response);

  /// Replaces returns, and their sub-rays, by those of a pulse; adds to the counts.
  void Trace(const Pulse& pulse, std::vector<SubReturn>& returns, std::vector<CastSubRay>& subRays,
    ScanCounts& counts);

private:
  /// What the corners of a cell meet.
  enum Kinds
  {
    Smooth, // nothing, or one plane
    Bent,   // one surface
    Edge
  };
  /// A cell by its place, in cells of the level at work, and its corners in turn.
  struct Cell
  {
    int X, Y;
    int Corners[4];
    Kinds Kind;
  };
  /// A corner with its hit; the power is that of a sub-ray of weight 1.
  struct Corner
  {
    double Range;
    vtkIdType CellId;
    double Power;
    double CosIncidence;
    double Weight;
    bool IsSilent; // outside the measured ranges
    bool HasPower;
  };

  void Clear();
  bool TraceProbes();
  void TraceCells();
  void StartCells();
  void AddRay(const Vec3& direction, const Vec3& origin);
  int GetCorner(int x, int y);
  void CastRays();
  void Visit(const Cell& cell, int level);
  void Split(const Cell& cell, int level);
  double GetSpread(const int corners[4]) const;
  Kinds GetKind(const int corners[4], double energy);
  Kinds Compare(int a, int b, double energy);
  Kinds CompareSurfaces(int a, int b, double energy);
  bool IsFineEnough(double spread, int level) const;
  Vec3 GetOrigin(const Vec3& local) const;
  double GetPower(int corner);
  void ReturnFromCell(const BeamCell& cell, int corner, double spread);
  void ReturnFromPlane(int corner, const Vec3& local, double weight);
  void ReturnFromCorners(const int corners[4], double weight);
  void ReturnFromWeights();
  void AddReturn(const Corner& from, const Vec3& direction, double weight);

  const ScanModel& Model;
  SurfaceResponse& Response;
  double SigmaRange;
  Pulse Beam;
  std::vector<int> Slots;        // of the lattice: the corner there, or -1
  std::vector<std::size_t> Used; // of the slots
  std::vector<vtkHeliosRay> Rays;
  std::vector<vtkHeliosHit> Hits;
  std::vector<Corner> Corners;
  std::vector<Cell> Cells;
  std::vector<Cell> Finer;
  std::vector<SubReturn>* Returns = nullptr;
  std::vector<CastSubRay>* SubRays = nullptr;
};

} // namespace helios

#endif
