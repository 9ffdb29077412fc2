// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPanoramicErrorModel
 * @brief   mechanical misalignments of a panoramic scanner
 *
 * Terms of the geometric error model of NIST for laser scanners whose beam comes along the shaft of
 * a spinning mirror, on a head that rotates about a vertical axis (Muralikrishnan et al. 2015,
 * Precision Engineering 40, 139-150), the ten parameters of panoramic scanners (Medic et al. 2017,
 * Sensors 17, 1145). The beam is emitted as the misaligned parts emit it, and reported as if they
 * were aligned.
 *
 * The frame turns with the head: z is its axis of rotation, x the shaft, along which the beam comes
 * from -x; the mirror reflects it into the y, z plane. With the range R, the azimuth H (clockwise,
 * from y to x), and the zenith angle V, negative in the back face (y < 0), true minus reported
 * values are, to first order,
 *
 *   dR = x2 sin V + x10
 *   dH = x1n / R + x1z / (R tan V) + x3 / (R sin V) + x5n + x5z / tan V
 *        + 2 x6 / sin V - x7 / tan V
 *   dV = (x1n cos V - x1z sin V + x2 cos V) / R + x4 + x5n cos V - x5z sin V
 *
 * The ray is computed without this approximation: the beam is reflected by the mirror, so that it
 * has no singularity at the zenith. Expressions of the superclass are added. Parameters of scales,
 * encoders and wobble (x8, x9, x11, x12) are left out.
 *
 * @sa
 * vtkHeliosExpressionErrorModel vtkHeliosScanner
 */

#ifndef vtkHeliosPanoramicErrorModel_h
#define vtkHeliosPanoramicErrorModel_h

#include "vtkHeliosExpressionErrorModel.h"
#include "vtkHeliosScannerDetectorsModule.h" // For export macro

class VTKHELIOSSCANNERDETECTORS_EXPORT vtkHeliosPanoramicErrorModel
  : public vtkHeliosExpressionErrorModel
{
public:
  static vtkHeliosPanoramicErrorModel* New();
  vtkTypeMacro(vtkHeliosPanoramicErrorModel, vtkHeliosExpressionErrorModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the offset of the beam from the shaft before the mirror, along y (x1n) and
   * z (x1z) [m]. Valid range: [-1, 1]. Default: 0.
   */
  vtkSetClampMacro(HorizontalBeamOffset, double, -1.0, 1.0);
  vtkGetMacro(HorizontalBeamOffset, double);
  vtkSetClampMacro(VerticalBeamOffset, double, -1.0, 1.0);
  vtkGetMacro(VerticalBeamOffset, double);
  ///@}

  ///@{
  /**
   * Set/Get the offset of the shaft (transit axis) from the axis of the head along y,
   * x2 [m]. Valid range: [-1, 1]. Default: 0.
   */
  vtkSetClampMacro(TransitOffset, double, -1.0, 1.0);
  vtkGetMacro(TransitOffset, double);
  ///@}

  ///@{
  /**
   * Set/Get the offset of the mirror along the shaft, x3 [m]: it moves the reflected
   * beam; its constant share of the range is part of RangeOffset. Valid range: [-1, 1].
   * Default: 0.
   */
  vtkSetClampMacro(MirrorOffset, double, -1.0, 1.0);
  vtkGetMacro(MirrorOffset, double);
  ///@}

  ///@{
  /**
   * Set/Get the index error of the vertical angle, added to V, x4 [deg]. Valid range:
   * [-10, 10]. Default: 0.
   */
  vtkSetClampMacro(VerticalIndexOffset, double, -10.0, 10.0);
  vtkGetMacro(VerticalIndexOffset, double);
  ///@}

  ///@{
  /**
   * Set/Get the tilt of the beam from the shaft before the mirror, towards y (x5n) and
   * z (x5z) [deg]. Valid range: [-10, 10]. Default: 0.
   */
  vtkSetClampMacro(HorizontalBeamTilt, double, -10.0, 10.0);
  vtkGetMacro(HorizontalBeamTilt, double);
  vtkSetClampMacro(VerticalBeamTilt, double, -10.0, 10.0);
  vtkGetMacro(VerticalBeamTilt, double);
  ///@}

  ///@{
  /**
   * Set/Get the angle of the mirror to the shaft less the nominal one, x6 [deg]; it turns
   * the beam towards +x by twice as much. Valid range: [-10, 10]. Default: 0.
   */
  vtkSetClampMacro(MirrorTilt, double, -10.0, 10.0);
  vtkGetMacro(MirrorTilt, double);
  ///@}

  ///@{
  /**
   * Set/Get the tilt of the shaft about y: its +x end is raised, x7 [deg]. Valid range:
   * [-10, 10]. Default: 0.
   */
  vtkSetClampMacro(TransitTilt, double, -10.0, 10.0);
  vtkGetMacro(TransitTilt, double);
  ///@}

  ///@{
  /**
   * Set/Get the offset of the range finder, the true range less the measured one, x10 [m].
   * Valid range: [-1, 1]. Default: 0.
   */
  vtkSetClampMacro(RangeOffset, double, -1.0, 1.0);
  vtkGetMacro(RangeOffset, double);
  ///@}

  ///@{
  /**
   * Returns the errors by the parameters, and by the expressions. Thread-safe.
   */
  double GetRangeError(double theta) const override;
  bool MoveRay(double origin[3], double direction[3]) const override;
  ///@}

protected:
  vtkHeliosPanoramicErrorModel() = default;
  ~vtkHeliosPanoramicErrorModel() override = default;

private:
  vtkHeliosPanoramicErrorModel(const vtkHeliosPanoramicErrorModel&) = delete;
  void operator=(const vtkHeliosPanoramicErrorModel&) = delete;

  bool IsAligned() const;

  double HorizontalBeamOffset = 0.0;
  double VerticalBeamOffset = 0.0;
  double TransitOffset = 0.0;
  double MirrorOffset = 0.0;
  double VerticalIndexOffset = 0.0;
  double HorizontalBeamTilt = 0.0;
  double VerticalBeamTilt = 0.0;
  double MirrorTilt = 0.0;
  double TransitTilt = 0.0;
  double RangeOffset = 0.0;
};

#endif
