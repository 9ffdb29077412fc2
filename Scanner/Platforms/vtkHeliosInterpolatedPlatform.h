// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosInterpolatedPlatform
 * @brief   a platform that flies again what was recorded
 *
 * Input: one or more recorded trajectories in place of waypoints (vtkPolyData with
 * the point arrays GpsTime and Orientation, as vtkHeliosTrajectoryReader gives
 * them), in any order: they are put one behind the other by time and may not
 * overlap. Two samples at one time are a jump.
 *
 * Output: the trajectory of the legs, each a part [start, end] of the recorded
 * times; without legs all of it is leg 0. A leg has a sample at its start, the
 * recorded ones, and one at its end; all carry its LegIds. What is flown
 * from the end of a leg to a later start of the next is there, too, with LegIds
 * -1; a leg that teleports, or starts earlier, starts where the one before ended
 * in GpsTime, at another place.
 *
 * GpsTime counts from StartTime on at the start of the first leg; with
 * KeepFileTimes it is the recorded time, and where a leg teleports the platform
 * waits at the end of the one before (LegIds -1).
 *
 * Between samples the position is linear in time, and then the output has no
 * array Velocity; or cubic: Hermite's polynomial with Velocity, which is that of
 * the input or else of the parabola through a sample and its neighbours. The
 * attitude turns at a constant rate, the shorter way.
 *
 * Errors: an input without samples, without the arrays, with samples that are
 * not finite, are no unit quaternions or go back in time; inputs that overlap;
 * a leg that does not end after it starts, or reaches beyond the recorded
 * times; with KeepFileTimes a leg that starts before the one before ends, or
 * times outside [0, 1e12].
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
   * Add a leg that flies [start, end] of the recorded times [s], NaN: from their
   * first, or to their last; remove all, get their number. A leg that teleports
   * is not flown to from the end of the leg before. Its LegIds are FirstLegId and
   * those after it. Default: none, all is one leg.
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
   * Set/Get whether GpsTime is the recorded time; else it counts from StartTime.
   * Default: off.
   */
  vtkSetMacro(KeepFileTimes, bool);
  vtkGetMacro(KeepFileTimes, bool);
  vtkBooleanMacro(KeepFileTimes, bool);
  ///@}

  /// How positions run between samples.
  enum Interpolations
  {
    LINEAR = 0,
    CUBIC = 1
  };

  ///@{
  /**
   * Set/Get how positions run between samples. Default: LINEAR.
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

  /// Not used: millions of samples go straight into the arrays of the output.
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
  struct Span; // a leg, or what is between two

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
