// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosInterpolatedPlatform
 * @brief   replays a recorded trajectory
 *
 * Input: one or more recorded trajectories instead of waypoints (vtkPolyData with the point arrays
 * GpsTime and Orientation, as written by vtkHeliosTrajectoryReader), in any order: they are
 * concatenated by time and may not overlap. Two samples at one time are a jump.
 *
 * Output: the trajectory of the legs, each a part [start, end] of the recorded times; without legs
 * the whole trajectory is leg 0. A leg has a sample at its start, the recorded ones, and one at its
 * end, all with its LegIds. The trajectory from the end of a leg to a later start of the next is
 * included, with LegIds -1; a leg that teleports, or starts earlier, starts where the one before
 * ended in GpsTime, at another position.
 *
 * GpsTime counts from StartTime at the start of the first leg; with KeepFileTimes it is the
 * recorded time, and before a leg that teleports the platform waits at the end of the one before
 * (LegIds -1).
 *
 * Between samples the position is linear in time, without an array Velocity in the output; or
 * cubic: Hermite's polynomial with Velocity, from the input or else from the parabola through a
 * sample and its neighbours. The attitude rotates at a constant rate along the shorter arc.
 *
 * Errors: an input without samples or without the arrays; samples that are not finite, not unit
 * quaternions or not ordered in time; inputs that overlap; a leg that does not end after it starts,
 * or exceeds the recorded times; with KeepFileTimes a leg that starts before the one before ends,
 * or times outside [0, 1e12].
 *
 * @sa
 * vtkHeliosTrajectoryReader vtkHeliosPlatform
 */

#ifndef vtkHeliosInterpolatedPlatform_h
#define vtkHeliosInterpolatedPlatform_h

#include "vtkHeliosPlatform.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro
#include "vtkSmartPointer.h"                 // For the inputs as one

#include <vector> // For the legs

namespace helios
{
class SampledPath;
}

class VTKHELIOSSCANNERPLATFORMS_EXPORT vtkHeliosInterpolatedPlatform : public vtkHeliosPlatform
{
public:
  static vtkHeliosInterpolatedPlatform* New();
  vtkTypeMacro(vtkHeliosInterpolatedPlatform, vtkHeliosPlatform);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Adds a leg over [start, end] of the recorded times [s], NaN: from their first, or to their
   * last; remove all, get their number. The platform does not move from the end of the leg before
   * to a leg that teleports. LegIds count from FirstLegId. Default: none, all is one leg.
   */
  void AddLeg(double start, double end, bool teleportToStart);
  void RemoveAllLegs();
  int GetNumberOfLegs() const { return static_cast<int>(this->Legs.size()); }
  ///@}

  ///@{
  /**
   * Set/Get the LegIds of the first leg. Valid range: [0, 1e9]. Default: 0.
   */
  vtkSetClampMacro(FirstLegId, int, 0, 1000000000);
  vtkGetMacro(FirstLegId, int);
  ///@}

  ///@{
  /**
   * Set/Get whether GpsTime is the recorded time; otherwise it counts from
   * StartTime. Default: off.
   */
  vtkSetMacro(KeepFileTimes, bool);
  vtkGetMacro(KeepFileTimes, bool);
  vtkBooleanMacro(KeepFileTimes, bool);
  ///@}

  /// Interpolation of positions between samples.
  enum Interpolations
  {
    LINEAR = 0,
    CUBIC = 1
  };

  ///@{
  /**
   * Set/Get the interpolation of positions between samples. Default: LINEAR.
   */
  vtkSetClampMacro(Interpolation, int, LINEAR, CUBIC);
  vtkGetMacro(Interpolation, int);
  void SetInterpolationToLinear() { this->SetInterpolation(LINEAR); }
  void SetInterpolationToCubic() { this->SetInterpolation(CUBIC); }
  ///@}

protected:
  vtkHeliosInterpolatedPlatform() = default;
  ~vtkHeliosInterpolatedPlatform() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Returns false and is not used: millions of samples are written directly to the output arrays.
  bool Move(vtkPolyData*, std::vector<State>&) override { return false; }

private:
  vtkHeliosInterpolatedPlatform(const vtkHeliosInterpolatedPlatform&) = delete;
  void operator=(const vtkHeliosInterpolatedPlatform&) = delete;

  /// A part of the recorded times.
  struct Leg
  {
    double Start;
    double End;
    bool Teleports;
  };
  struct Span; // a leg, or the part between two legs

  vtkSmartPointer<vtkPolyData> JoinInputs(vtkInformationVector* inputs);
  bool FindLegs(const helios::SampledPath& path, std::vector<Leg>& legs);
  bool CheckLeg(const helios::SampledPath& path, const Leg& leg, std::size_t index);
  bool CheckFileTimes(const std::vector<Leg>& legs);
  std::vector<Span> PlanSpans(const std::vector<Leg>& legs) const;
  void Fill(
    const helios::SampledPath& path, const std::vector<Span>& spans, vtkPolyData* output) const;

  std::vector<Leg> Legs;
  int FirstLegId = 0;
  bool KeepFileTimes = false;
  int Interpolation = LINEAR;
};

#endif
