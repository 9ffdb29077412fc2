// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosBeamDeflector
 * @brief   the direction of each emitted pulse
 *
 * A strategy, const once set up. The direction of a pulse is a pure function of
 * its index: any thread or machine can compute any pulse, without drift.
 *
 * To add one: subclass, implement GetDirection() (and GetScanAngle() if the
 * angle is not measured from the y axis, GetScanDirectionFlag() and
 * IsEdgeOfFlightLine() if there are lines). ComputePhase() gives phases that are
 * exact for any index. Nothing else of vtkHelios is needed.
 *
 * @sa
 * vtkHeliosRotatingMirror vtkHeliosOscillatingMirror vtkHeliosFiberArray
 * vtkHeliosConicMirror vtkHeliosPalmerMirror vtkHeliosRisleyPrisms
 * vtkHeliosSpinningChannels vtkHeliosScanner
 */

#ifndef vtkHeliosBeamDeflector_h
#define vtkHeliosBeamDeflector_h

#include "vtkHeliosScannerOpticsModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosBeamDeflector : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosBeamDeflector, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the pulse frequency [Hz]. Valid range: (0, 1e9]. Default: 100000.
   */
  void SetPulseFrequency(double frequency);
  vtkGetMacro(PulseFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get how long the optics have been moving at pulse 0 [s]: pulse i is at
   * the phases of the time i / PulseFrequency + WarmUpTime. Optics that count
   * pulses start at the nearest whole one. Valid range: [0, 1e6]. Default: 0.
   */
  void SetWarmUpTime(double time);
  vtkGetMacro(WarmUpTime, double);
  ///@}

  /**
   * Computes the direction of a pulse in the scanner frame (x right, y forward, z up), a unit
   * vector. Returns false if the deflector emits no pulse at that index (the mirror is turned
   * away); direction is then not set.
   */
  virtual bool GetDirection(vtkIdType pulse, double direction[3]) const = 0;

  /**
   * Returns the angle of a pulse as the instrument reports it [deg]: by default the angle between
   * its direction and the y axis, 0 if no pulse is emitted.
   */
  virtual double GetScanAngle(vtkIdType pulse) const;

  ///@{
  /**
   * Returns the channel of a pulse, from 0, for optics with several channels; and its delay after
   * pulse / PulseFrequency [s] if channels do not fire evenly. By default there is one, without
   * delay: 0 and 0.
   */
  virtual int GetChannel(vtkIdType pulse) const;
  virtual double GetDelay(vtkIdType pulse) const;
  ///@}

  /**
   * Returns when a pulse is fired [s], after pulse 0 without delay: pulse / PulseFrequency and its
   * delay. Channels that fire at once have equal times, to the bit.
   */
  virtual double GetElapsedTime(vtkIdType pulse) const;

  ///@{
  /**
   * Returns, for optics that scan lines, the flags of LAS 1.4: 1 while the scan angle increases,
   * else 0; and whether a pulse is the last one emitted before the scan reverses or the next facet
   * starts a line. By default there are no lines: 0 and false.
   */
  virtual int GetScanDirectionFlag(vtkIdType pulse) const;
  virtual bool IsEdgeOfFlightLine(vtkIdType pulse) const;
  ///@}

  /**
   * Computes where a pulse starts, in the scanner frame [m], for optics whose beams do not start at
   * one point. Returns false, and leaves origin unchanged, if it starts at 0, 0, 0, the default.
   */
  virtual bool GetOrigin(vtkIdType pulse, double origin[3]) const;

  /**
   * Computes the axis across the scan lines, in the scanner frame: elliptical footprints are
   * aligned with it. The plane of the beam and this axis holds the major axis of the footprint, for
   * vtkHeliosBeamSampler::MajorAxisAngle 0; so the footprint turns with the beam that a mirror or a
   * head turns, and the angle between its axes and the scan line stays. By default x, about which
   * mirrors turn.
   */
  virtual void GetCrossAxis(double axis[3]) const;

  /**
   * Returns the column of a pulse in its revolution, from 0, for optics that fire in columns. By
   * default 0.
   */
  virtual vtkIdType GetColumn(vtkIdType pulse) const;

protected:
  vtkHeliosBeamDeflector() = default;
  ~vtkHeliosBeamDeflector() override = default;

  /**
   * Returns the phase of a motion with this frequency [Hz], in [0, 1): for pulse i frac(frequency
   * (i / PulseFrequency + WarmUpTime)), exact to a few ulps after any number of revolutions. A
   * negative frequency reverses the rotation.
   */
  double ComputePhase(vtkIdType pulse, double frequency) const;

  /**
   * Returns the index of a pulse for optics that count pulses, offset by the pulses of WarmUpTime.
   */
  vtkIdType ComputeCount(vtkIdType pulse) const;

  /**
   * Sets a property, clamped to its range; returns whether it changed; NaN
   * gives low.
   */
  bool SetClamped(double& property, double value, double low, double high);

  double PulseFrequency = 100000.0;
  double WarmUpTime = 0.0;

private:
  vtkHeliosBeamDeflector(const vtkHeliosBeamDeflector&) = delete;
  void operator=(const vtkHeliosBeamDeflector&) = delete;
};

#endif
