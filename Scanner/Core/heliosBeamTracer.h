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
 * The cross-section of the beam is parted into cells (heliosBeamLattice.h), with a sub-ray at every
 * corner. A cell whose corners meet one smooth surface returns from its own points, which are put onto
 * the plane of a corner without casting a ray; any other is parted into four, as often as the plan
 * says, and at last returns from its corners, a quarter of its energy each. One a thread.
 */
class BeamTracer
{
public:
  BeamTracer(const ScanModel& model, SurfaceResponse& response);

  /// Replaces returns, and their sub-rays, by those of a pulse; adds to the counts.
  void Trace(const Pulse& pulse, std::vector<SubReturn>& returns, std::vector<CastSubRay>& subRays,
    ScanCounts& counts);

private:
  /// A place of the lattice, in cells of the level at work.
  struct Cell
  {
    int X, Y;
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

  void Start(const Pulse& pulse);
  int GetCorner(int x, int y);
  void GetCorners(const Cell& cell, int level, int corners[4]);
  void CastRays();
  void Visit(const Cell& cell, int level);
  double GetSpread(const int corners[4]) const;
  bool IsContinuous(const int corners[4]);
  bool IsFineEnough(double spread, int level) const;
  bool AreAlike(int a, int b);
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
