// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSpinningChannels
 * @brief   a stack of lasers in a spinning head
 *
 * The n channels fire in turn, PulseFrequency pulses/s in all: pulse i is channel c = i mod n in
 * the cycle of n pulses that starts at (i - c) / PulseFrequency. A channel has an elevation e above
 * the horizon, its own azimuth, and a firing time in the cycle; by default c / PulseFrequency,
 * evenly. The head rotates about z with ScanFrequency, from StartAngle on; the azimuth a of a pulse
 * is the azimuth h of the head when it fires, with exact fractions of a revolution, plus the
 * azimuth of its channel. A channel starts at a distance r (OriginOffset) from the axis, in the
 * direction of the head, and at a height z (OriginHeight). Direction and origin are
 * - (-sin a cos e, cos a cos e, sin e)
 * - (-r sin h, r cos h, z)
 *
 * A column is a cycle of n pulses; columns count from 0 in each revolution, which begins at
 * StartAngle.
 *
 * Azimuths increase anticlockwise, seen from above, with y at 0; instruments that count clockwise
 * have a negative ScanFrequency and azimuths of the opposite sign.
 *
 * @sa
 * vtkHeliosBeamDeflector vtkHeliosScanner
 */

#ifndef vtkHeliosSpinningChannels_h
#define vtkHeliosSpinningChannels_h

#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosScannerOpticsModule.h" // For export macro

#include <vector> // For the channels

class VTKHELIOSSCANNEROPTICS_EXPORT vtkHeliosSpinningChannels : public vtkHeliosBeamDeflector
{
public:
  static vtkHeliosSpinningChannels* New();
  vtkTypeMacro(vtkHeliosSpinningChannels, vtkHeliosBeamDeflector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the rotation frequency of the head [Hz]; negative: clockwise. Valid
   * range: [-1e6, 1e6]. Default: 10.
   */
  vtkSetClampMacro(ScanFrequency, double, -1e6, 1e6);
  vtkGetMacro(ScanFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get the azimuth of the head at pulse 0 [deg]. Valid range: [-360, 360].
   * Default: 0.
   */
  vtkSetClampMacro(StartAngle, double, -360.0, 360.0);
  vtkGetMacro(StartAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of channels n; new channels have elevation and azimuth 0
   * and fire evenly. Valid range: [1, 100000]. Default: 1.
   */
  void SetNumberOfChannels(int channels);
  int GetNumberOfChannels() const;
  ///@}

  ///@{
  /**
   * Set/Get the elevation of a channel [deg]. Valid range: [-90, 90]. Default: 0.
   */
  void SetElevation(int channel, double elevation);
  double GetElevation(int channel) const;
  ///@}

  ///@{
  /**
   * Set/Get the azimuth of a channel in the head [deg]. Valid range: [-360, 360].
   * Default: 0.
   */
  void SetAzimuth(int channel, double azimuth);
  double GetAzimuth(int channel) const;
  ///@}

  ///@{
  /**
   * Set/Get the firing time of a channel in a cycle [s]; negative: evenly, at
   * channel / PulseFrequency. Valid range: [-1, 1e3]. Default: -1.
   */
  void SetFiringTime(int channel, double time);
  double GetFiringTime(int channel) const;
  ///@}

  ///@{
  /**
   * Set/Get the distance of the origin of a channel from the axis [m]. Valid range:
   * [-10, 10]. Default: 0.
   */
  void SetOriginOffset(int channel, double offset);
  double GetOriginOffset(int channel) const;
  ///@}

  ///@{
  /**
   * Set/Get the height of the origin of a channel [m]. Valid range: [-10, 10].
   * Default: 0.
   */
  void SetOriginHeight(int channel, double height);
  double GetOriginHeight(int channel) const;
  ///@}

  bool GetDirection(vtkIdType pulse, double direction[3]) const override;
  bool GetOrigin(vtkIdType pulse, double origin[3]) const override;
  vtkIdType GetColumn(vtkIdType pulse) const override;

  /**
   * Returns z, about which the head spins.
   */
  void GetCrossAxis(double axis[3]) const override;

  /**
   * Returns the azimuth of a pulse [deg], in [0, 360).
   */
  double GetScanAngle(vtkIdType pulse) const override;

  int GetChannel(vtkIdType pulse) const override;
  double GetDelay(vtkIdType pulse) const override;
  double GetElapsedTime(vtkIdType pulse) const override;

protected:
  vtkHeliosSpinningChannels();
  ~vtkHeliosSpinningChannels() override = default;

private:
  vtkHeliosSpinningChannels(const vtkHeliosSpinningChannels&) = delete;
  void operator=(const vtkHeliosSpinningChannels&) = delete;

  struct Channel
  {
    double Elevation = 0.0;
    double Azimuth = 0.0;
    double FiringTime = -1.0;
    double OriginOffset = 0.0;
    double OriginHeight = 0.0;
  };

  Channel* Find(int channel);
  Channel GetOne(int channel) const;
  double ComputeHeadTurn(vtkIdType pulse, const Channel& one) const;
  double ComputeTurn(vtkIdType pulse) const;

  double ScanFrequency = 10.0;
  double StartAngle = 0.0;
  std::vector<Channel> Channels;
};

#endif
